"""Commands that do the opposite of one that was probably said.

Nothing is worse than to drive the other way, so that the opposite is compared however unlike it seems: other words that
may stand in a place are looked for by their beginning alone, by which "backward" was far behind "forward", and as whole
sentences they were nearly as likely.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from intent_engine.actions import Action
from intent_engine.interpretation import Interpretation
from intent_engine.language.networks.approximate import UtteranceSearch
from intent_engine.language.numbers.spelled import number_words
from intent_engine.language.words.opposites import opposed
from intent_engine.speech.hypotheses.detours import leads
from intent_engine.speech.hypotheses.evidence import letters_apart
from intent_engine.speech.hypotheses.word_pieces import MANY_WORDS
from intent_engine.ways import opposite_ways, ways

__all__ = ["opposing"]

MOST_OPPOSED = 6
"""Commands that are compared, those first that are likest to what was heard: of one to move or turn the shipped English
grammar has up to 34."""


def opposing(
    search: UtteranceSearch,
    parse: Callable[[str], Interpretation],
    words: Sequence[str],
    heard: Sequence[Sequence[str]],
    language: str | None = None,
) -> list[tuple[str, ...]]:
    """Sentences that differ in one word from one, and drive or turn the other way, or have the word that means the
    opposite ("off" for "on"); the likest to what was heard first.

    Args:
        search: of the grammar, which knows the words after each of its states.
        parse: what a sentence means.
        words: of the sentence; one that does nothing has no opposite.
        heard: the words that each model heard freely.
        language: of the speech.
    """
    meaning = parse(" ".join(words))
    if not meaning.actions or meaning.stops:
        return []
    moves = any(ways(meaning.actions))
    found = []
    for place, other in _others(search, words, number_words(language)):
        said = (*words[:place], other, *words[place + 1 :])
        listed = other in opposed(words[place], language)
        if (listed or moves) and _opposite(meaning.actions, parse(" ".join(said)).actions, listed=listed):
            found.append((min(letters_apart(said, one) for one in heard), said))
    return [said for _, said in sorted(found)][:MOST_OPPOSED]


def _others(search: UtteranceSearch, words: Sequence[str], numbers: Collection[str]) -> Iterator[tuple[int, str]]:
    """The places of a sentence, each with other words with which it is one as well. Not those of its quantities, which
    tell how far and not which way: to ask of all words that may stand anywhere what they mean took up to a second."""
    graph = search.graph
    state = graph.start()
    for place, word in enumerate(words):
        likely: Collection[str] = search.words_after(state)[1]
        quantity = any(near in numbers for near in words[max(0, place - 1) : place + 1])
        if len(likely) <= MANY_WORDS and not quantity:
            rest = tuple(words[place + 1 :])
            yield from (
                (place, other) for other in sorted(likely) if other != word and leads(graph, state, (other, *rest))
            )
        state = graph.step(state, word)
        if state is None:
            return


def _opposite(actions: Sequence[Action], others: Sequence[Action], *, listed: bool) -> bool:
    """Whether others do the opposite; or just something else, with a word that means the opposite."""
    return opposite_ways(actions, others) or (listed and bool(others) and tuple(actions) != tuple(others))
