"""A thing of the kind that was named before, told by whose or which it is alone: "abre la puerta de entrada y *la* de
salida", "ferme la porte de la cave et *celle* du grenier"."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, only
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.of_words import of_words
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["NounsBeforeOf"]

_MOST_WORDS = 3
"""Of such a noun, without its article."""


class NounsBeforeOf:
    """Puts in the noun, with its article.

    Args:
        grammar: whose language has words for it.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        self._of = of_words(grammar.language)
        self._stands_for = grammar.wording.stands_for_noun
        self._sequence = sequence

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with the noun that was named before; None: none was, or it is not clear which.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        words = core.words
        places = (at for at in range(_MOST_WORDS, len(words) - 1) if words[at] in self._stands_for)
        place = next((at for at in places if words[at + 1] in self._of and not core.breaks[at + 1]), 0)
        if not place:
            return None
        named = {tuple(name) for name in self._named(words[:place], words[place])}
        return only(as_said(core.with_other(place, place + 1, Utterance.in_one_breath(name))) for name in sorted(named))

    def _named(self, words: Sequence[str], stands_for: str) -> Iterator[Sequence[str]]:
        """What was named before with its article and an "of" behind it."""
        articles = self._stands_for[stands_for]
        for start in (at for at, word in enumerate(words) if word in articles):
            ends = range(start + 2, min(start + 2 + _MOST_WORDS, len(words)))
            end = next((at for at in ends if words[at] in self._of), 0)
            if end and self._sequence.find(words[start:end]) is None:
                yield words[start:end]
