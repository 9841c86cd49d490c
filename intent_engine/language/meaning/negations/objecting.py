"""A "no" with more behind it: "no, the lab", said to a robot that moves, or "no, Anna", said to somebody else."""

from __future__ import annotations

from collections.abc import Callable

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance

__all__ = ["objects_to_what_is_done"]


def objects_to_what_is_done(
    phrases: Phrases, said: Utterance, before: str, parse: Callable[[str], Interpretation]
) -> bool:
    """Whether it is said to the robot: "no" stands twice in one breath, or what follows is a command, or takes the
    place of a part of what was understood before.

    Args:
        phrases: of the grammar.
        said: the words.
        before: the text of what was last understood; empty: it is not known.
        parse: what a text means by itself.
    """
    core = phrases.without_fillers(said)
    begun, objections = phrases.objected(core)
    if not begun or begun == len(core) or phrases.thanks(said):
        return False
    if objections > 1:
        return True
    if objections:
        rest = parse(" ".join(core.words[begun:]))
        if rest.actions or rest.status is Status.AMBIGUOUS or rest.unknown_place:
            return True
    words = core.words if phrases.correction.at(core.words, 0) else [*phrases.correcting, *core.words[begun:]]
    ways = (words, phrases.without_standing_for(words)) if before else ()
    corrected = (parse(f"{before}, {' '.join(words)}") for words in ways)
    return any(one.corrected and not one.stops for one in corrected)
