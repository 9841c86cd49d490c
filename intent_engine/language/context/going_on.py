"""What goes on from the command that was said before, in an utterance of its own: "and Ben", after "wave to Anna".

It adds what both do together besides the first: "wave to Anna and Ben". A name alone may as well take the place of the
one before.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from intent_engine.actions import Action
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["as_joined", "goes_on_from", "is_a_list"]


_LAST = re.compile(r"(?s)(.*\S)\s+([^\W\d]+)[\s.!]*$")
"""A text and its last word."""


def goes_on_from(
    text: str,
    before: str,
    done: Sequence[Action],
    meaning: Callable[[str], Interpretation],
    parted: Collection[str] = (),
) -> Interpretation | None:
    """What a text adds that begins with a joint; its ``text`` is the whole sentence. None: it does not go on.

    Args:
        text: what is said now, and is no command by itself.
        before: the text of what was said before, with all that it went on from.
        done: what that did, at least its last action.
        meaning: understands a text.
        parted: words that end what was said before, and would end the whole sentence: "turn the fan *on*", "and the
            pump".
    """
    first = meaning(before)
    if not first.actions or not done or first.actions[-1] != done[-1]:
        return None
    ways, count = [f"{before} {text}"], len(first.actions)
    if (last := _LAST.match(before)) is not None and last[2].lower() in parted:
        ways.append(f"{last[1]} {text.rstrip(' .!')} {last[2]}")
    whole = next((one for one in map(meaning, ways) if is_a_list(one, count - 1)), None)
    if whole is None or whole.actions[:count] != first.actions or len(whole.actions) <= count:
        return None
    steps = whole.slots["steps"][count:]
    intent, slots = (steps[0]["intent"], steps[0]["slots"]) if len(steps) == 1 else (whole.intent, {"steps": steps})
    more, needs = whole.actions[count:], whole.needs[count:]
    return replace(whole, intent=intent, slots=slots, actions=more, needs=needs, goes_on=True)


def as_joined(
    text: str, joints: Sequence[tuple[str, ...]], ends: PhraseSet, language: str, opens: PhraseSet | None = None
) -> str:
    """A text as it is said behind what was said before: with one of the joints before it, which it begins with, or
    which is meant by how it ends or begins: "the fan *too*" is "and the fan", "*now* the fan" "and, now the fan".
    Empty: it has neither.

    Args:
        text: what is said.
        joints: words that join, of which the first is put in.
        ends: what ends a text that is joined, and says no more.
        language: of the text.
        opens: what begins a text that is joined.
    """
    said = Utterance.of(text, language).words
    begins = PhraseSet(joints).at(said, 0) > 0
    words = text.rstrip(" .!").split()
    for count in range(1, len(words)):
        if tuple(word.casefold() for word in words[-count:]) in ends:
            rest = " ".join(words[:-count]).rstrip(" ,")
            return rest if begins else f"{' '.join(joints[0])} {rest}" if joints else ""
    if not begins and joints and opens is not None and opens.at(said, 0):
        return f"{' '.join(joints[0])}, {text}"
    return text if begins else ""


def is_a_list(whole: Interpretation, begin: int = 0) -> bool:
    """Whether a sentence is commands of one intent, from one of them on."""
    if whole.status is not Status.ACCEPTED or "steps" not in whole.slots:
        return False
    steps = whole.slots["steps"][begin:]
    return len(steps) > 1 and all(step["intent"] == steps[0]["intent"] for step in steps)
