"""Where the commands of one utterance stand, and what joins them."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.counted import amounts, in_an_amount
from intent_engine.language.meaning.wordings.merely import said_before
from intent_engine.language.utterance import Utterance

__all__ = ["next_begins", "part_by_part"]


def part_by_part(
    said: Utterance, phrases: Phrases, language: str, told: Callable[[Utterance], Utterance | None]
) -> Utterance | None:
    """An utterance with each of its commands as it is told otherwise; None: none of them is.

    Args:
        said: the words, without those that say nothing.
        phrases: of the grammar.
        language: of the words.
        told: one command otherwise; None: as it is.
    """
    words: list[str] = []
    breaks: list[bool | None] = []
    changed = False
    for start, end, joins in _parts(said, phrases, language):
        part = said.part(start, end)
        other = None if joins else told(part)
        changed |= other is not None
        words += (other or part).words
        breaks += [said.breaks[start], *(other or part).breaks[1:]]
    return Utterance(words, breaks) if changed else None


def next_begins(said: Utterance, start: int, phrases: Phrases, may_be: Callable[[int], bool] = lambda at: True) -> int:
    """Where, behind a place, another command may begin: at a pause or what joins; the end, if none does.

    Args:
        said: the words.
        start: the place.
        phrases: of the grammar.
        may_be: whether it may be at a place.
    """
    later = filter(may_be, range(start + 1, len(said)))
    return next((at for at in later if said.breaks[at] or phrases.goes_on_at(said.words, at)), len(said))


def _parts(said: Utterance, phrases: Phrases, language: str) -> Iterator[tuple[int, int, bool]]:
    """Where each begins and ends, and whether it only joins or opens."""
    within = in_an_amount(said.words, language)
    merely = {  # "go just two meters", "to, say, two meters"
        at
        for amount in amounts(said.words, language)
        for begin, length in said_before(said.words, amount.start, phrases)
        for at in range(begin - length, begin + 1)
    }

    def begins(at: int) -> bool:
        return not (at in merely or (at in within and not any(said.breaks[at : at + 2])))

    start = 0
    while start < len(said):
        rest = said.words[start:]
        if joint := max(phrases.goes_on(rest), phrases.opens(rest), phrases.correction.at(said.words, start)):
            yield start, start + joint, True
            start += joint
            continue
        end = next_begins(said, start, phrases, begins)
        yield start, end, False
        start = end
