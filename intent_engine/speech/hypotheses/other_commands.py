"""What else a model may have heard in the place of a sentence of the grammar: commands beside it."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from intent_engine.speech.acoustic.rows import Rows
from intent_engine.speech.hypotheses.clearness import Clearness
from intent_engine.speech.hypotheses.dictating import begin_of
from intent_engine.speech.hypotheses.guide import Guide
from intent_engine.speech.hypotheses.left_out import goes_on
from intent_engine.speech.hypotheses.opinion import Opinion
from intent_engine.speech.hypotheses.other_wordings import OtherWordings
from intent_engine.speech.hypotheses.pace import too_many
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.recognizer import Encoded

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["OtherCommands"]

MOST_RIVALS = 6
"""Commands that are scored because they differ in one word from the likeliest."""
NEAR = 4.0
"""nats by which the first piece of a word may be less likely than that of the word in whose place it may stand,"""
CLOSE = 1.5
"""and where a sentence was heard word by word; by so many nats the other must be less likely as a whole."""


class OtherCommands(Clearness):
    """A model that says what else of a grammar it may have heard."""

    def know(self, engine: IntentEngine) -> None:
        """The grammar of an engine; it may be reloaded at any time."""
        self.grammar = SpokenGrammar(engine)
        self.otherwise = OtherWordings(self.grammar)
        self._guides: dict[str | None, Guide] = {}
        self._besides: tuple[Encoded | None, dict[tuple[tuple[str, ...], bool], tuple[tuple[str, ...], ...]]] = (
            None,
            {},
        )
        """What may have been said in place of some sentences, given the sound that was asked about last."""

    def possible(self, heard: Opinion) -> Callable[[Sequence[str]], bool]:
        """Whether a sentence may have been said that was heard so."""
        free, language = heard.transcript.free_text, heard.transcript.language
        words = heard.heard
        story = self.story(heard.encoded, free, language)

        def possible(sentence: Sequence[str]) -> bool:
            if goes_on(sentence, [words]) or too_many(sentence, heard.samples):
                return False
            return self.grammar.possible(sentence, story, language, heard=words)

        return possible

    def beside(self, heard: Opinion, words: tuple[str, ...], *, far: bool = False) -> tuple[tuple[str, ...], ...]:
        """Other commands that may have been said in place of one, and differ in one word, or if ``far`` in a few; the
        likeliest first."""
        if begin_of(words):
            return ()
        encoded, language = heard.encoded, heard.transcript.language
        if self._besides[0] is not encoded:
            self._besides = encoded, {}
        found = self._besides[1]
        if (words, far) not in found:
            rivals = self._rivals(encoded, words, language, NEAR, self.possible(heard), widely=True, far=far)
            found[words, far] = tuple(rivals)
        return found[words, far]

    def begun(self, heard: Opinion, words: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
        """Sentences that mean what one means, and may have begun otherwise ("make me a ..."), the likeliest first."""
        language = heard.transcript.language
        meaning = self.grammar.parse(" ".join(words), language)
        lead = self.grammar.lead(words, language)
        possible = self.possible(heard)

        def wanted(sentence: tuple[str, ...]) -> bool:
            begins_otherwise = sentence[:lead] == words[:lead] and sentence[lead:][:1] != words[lead:][:1]
            # "Can you" is no beginning of a command by itself.
            if not begins_otherwise or self.grammar.lead(sentence, language) != lead:
                return False
            return possible(sentence) and not self.grammar.means_else(sentence, meaning, language)

        return tuple(self._others(heard.encoded, words, language, NEAR, wanted, widely=True, far=True))

    def _rivals(
        self,
        encoded: Encoded,
        words: Sequence[str],
        language: str | None,
        near: float,
        possible: Callable[[Sequence[str]], bool],
        *,
        widely: bool = False,
        far: bool = False,
    ) -> dict[tuple[str, ...], str]:
        """Other commands that differ in one word from one that may have been said, each with that word; the likeliest
        first.

        Args:
            encoded: the sound.
            words: of the sentence.
            language: of the speech.
            near: nats by which the first piece of another word may be less likely.
            possible: whether a sentence may have been said.
            widely, far: as for :meth:`~intent_engine.speech.hypotheses.rivals.Rivals.beside`.
        """
        meaning = self.grammar.parse(" ".join(words), language)
        if len(words) == 1 or meaning.stops:
            return {}

        def wanted(sentence: tuple[str, ...]) -> bool:
            return possible(sentence) and self.grammar.means_else(sentence, meaning, language)

        return self._others(encoded, words, language, near, wanted, widely=widely, far=far)

    def _others(
        self,
        encoded: Encoded,
        words: Sequence[str],
        language: str | None,
        near: float,
        wanted: Callable[[tuple[str, ...]], bool],
        *,
        widely: bool,
        far: bool,
    ) -> dict[tuple[str, ...], str]:
        """Of the sentences beside one those that are wanted, as :meth:`_rivals` gives them."""
        own = self.otherwise.own(tuple(words), language)
        rows = self._along(encoded, own, language, widely=widely)
        beside = self.guide(language).rivals.beside(own, rows, near, widely=widely, far=far)
        if own != tuple(words):
            put = ((self.otherwise.beside(one, own, tuple(words), language), word) for one, word in beside.items())
            beside = dict(put)
        return {one: beside[one] for one in itertools.islice(filter(wanted, beside), MOST_RIVALS)}

    def close_to(self, encoded: Encoded, words: Sequence[str], language: str | None) -> dict[tuple[str, ...], str]:
        """Other commands that may have been said where one was heard word by word, each with the word in question."""
        rivals = self._rivals(
            encoded, words, language, CLOSE, lambda sentence: self.grammar.possible(sentence, (), language)
        )
        if not rivals:
            return {}
        said, *others = self.score_words(encoded, [words, *rivals], language)
        return {one: word for (one, word), score in zip(rivals.items(), others, strict=True) if said - score < CLOSE}

    def _along(self, encoded: Encoded, words: Sequence[str], language: str | None, *, widely: bool) -> Rows:
        """What the model makes of each place of a sentence: as it heard it freely, or asked anew."""
        rivals = self.guide(language).rivals
        rows = self.decoded(encoded)
        if any(row is None for row in rivals.before(words, rows, widely=widely).values()):
            rows = dict(self.next_pieces(encoded, [rivals.pieces(words)], 1, language))
        while widely and (wanted := rivals.digits(words, rows)):
            rows = {**rows, **dict(self.next_pieces(encoded, wanted, 1, language))}
        return rows

    def guide(self, language: str | None) -> Guide:
        """How the model is led along the grammar of a language; what it learns of it is kept until it is reloaded."""
        guide = self._guides.get(language)
        if guide is None or guide.near is not self.grammar.search(language):
            guide = self._guides[language] = Guide.of(self, self.grammar, language)
        return guide
