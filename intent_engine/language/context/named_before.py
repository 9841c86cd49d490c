"""A pronoun for what a command before named from a list or the map, or in words of its own: "close it", after "open the
lid".

The name is put in before the text is understood, so that it means what the same text with the name means: a command,
something that shall not be done ("don't close it"), or talk. Free words are put in when their action is known
(:mod:`~intent_engine.language.context.references`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from intent_engine.actions import Action
from intent_engine.interpretation import Interpretation, Question, Status
from intent_engine.language.meaning.wordings.pronouns import NameSaid

__all__ = ["named_before"]


def named_before(
    text: str,
    found: Interpretation,
    names: Sequence[NameSaid],
    meaning: Callable[[str], Interpretation],
) -> Interpretation | None:
    """What a text with a pronoun means, where only one of the things named before fits; its ``text`` has the name. Of
    several it is asked which, or all are denied of which it says that they shall not be done. None: nothing fits, or
    what may not be meant does.

    Args:
        text: what was said.
        found: what that means by itself, which does nothing.
        names: what was named before, with the texts that have it in the place of the pronoun.
        meaning: understands a text.
    """
    fits: dict[tuple[Action, ...], Interpretation] = {}
    denied: dict[Action, None] = {}
    clear = True
    for name in names:
        means = (meaning(" ".join(way)) for way in name.ways if way)
        way = next((one for one in means if (one.actions or one.denied) and name.fits(one.text)), None)
        if way is None or (way.actions and found.refuses):
            continue
        clear = clear and name.is_meant
        if way.actions:
            fits.setdefault(way.actions, way)
        denied.update(dict.fromkeys(way.denied))
    if denied and not fits:
        return replace(found, denied=tuple(denied))
    if not fits or not clear:
        return None
    if len(fits) > 1:
        return _which(text, found, [one.text for one in fits.values()])
    (meant,) = fits.values()
    if meant.status is not Status.ACCEPTED:
        return None
    reason = "; ".join(filter(None, (f"heard {text!r} as {meant.text!r}", meant.reason)))
    return replace(meant, reason=reason)


def _which(text: str, found: Interpretation, meanings: Sequence[str]) -> Interpretation:
    """The question which of several things is meant."""
    reason = f"{text!r} may be {' or '.join(map(repr, meanings))}; say which"
    alternatives = tuple(meanings)
    return replace(
        found, status=Status.AMBIGUOUS, reason=reason, alternatives=alternatives, question=Question(alternatives)
    )
