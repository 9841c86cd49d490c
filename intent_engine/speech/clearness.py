"""How clearly a model heard the words on which the meaning of a command hangs.

A word that no list has, a number that sounds like another, and a "don't" that may have been said are told apart by
nothing in the grammar: only by how much likelier the model finds the one than the other.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from intent_engine.interpretation import Interpretation
from intent_engine.language.approximate import FreeWord
from intent_engine.language.numbers.english import ALIKE
from intent_engine.language.numbers.spelled import in_digits
from intent_engine.language.utterance import Utterance
from intent_engine.speech.recognizer import Encoded
from intent_engine.speech.scoring import Scoring
from intent_engine.speech.spoken_grammar import NARRATING, SpokenGrammar
from intent_engine.speech.writing import spellings, written

__all__ = ["RIVAL_MARGIN", "Clearness"]

CLEAR = 0.6
"""Geometric mean of the probabilities of a word's pieces, from which it was heard clearly."""
NOT_SAID = 5.5
"""nats by which a command must be likelier than the same with a "don't" or "never". In kitchen noise at 10 and 6 dB
"never" is heard as "then we'll" and "don't" as "go and": of 8 commands of synthetic voices that should not be done and
were heard as such that should, 7 were ahead by less, and of 80 that were heard word by word, half of them in noise,
none."""
SURELY_SAID = 6.5
"""nats by which a command that was heard is likelier than one with a "don't" at the piece where they part, from which
the whole need not be compared."""
RIVAL_MARGIN = 3.0
"""nats by which a number must be likelier than one that sounds like it (``ALIKE``),"""
TEEN = 1.0
"""and one in -teen by so many more, one in -ty by so many less: both models are ready to hear a -teen. Of 196 numbers
of 14 synthetic voices, clean and at 10 and 6 dB, 91, 89 and 86 % are clear with it and 0.5, 1.5 and 2.0 % taken for the
other; without, 91, 86 and 83 % and 1.5, 2.6 and 3.1 %."""
SURELY_THIS = 4.5
"""nats by which the first piece of a number that was heard is likelier than that of the one it sounds like, from which
the sentences need not be compared: of 24 that were heard word by word these differed by as much, or up to 5 more."""


class Clearness(Scoring):
    """A model that says how clearly it heard words of a grammar."""

    grammar: SpokenGrammar
    """Which sentences it may have heard."""

    def clearness(
        self, encoded: Encoded, words: Sequence[str], language: str | None = None, *, heard: bool = False
    ) -> dict[str, float]:
        """The words of an utterance on which its meaning hangs, each with the nats by which it was heard more clearly
        than it must be: words of free slots that no list has, or else numbers that sound like others; and the beginning
        of a command, in which a "don't" may have been. Where the grammar has only one of two such numbers ("sixteen
        ounce") there is nothing to tell.

        Args:
            encoded: the sound.
            words: of the utterance.
            language: of the speech.
            heard: whether the model heard just these.
        """
        found = self._known_clearly(encoded, words, language, heard=heard)
        ahead = self._ahead(encoded, words, language, heard=heard) - NOT_SAID
        if math.isfinite(ahead):
            begin = " ".join(words[: self.grammar.lead(words, language) or 1])
            found[begin] = min(ahead, found.get(begin, math.inf))
        return found

    def _known_clearly(
        self, encoded: Encoded, words: Sequence[str], language: str | None, *, heard: bool
    ) -> dict[str, float]:
        if any(isinstance(word, FreeWord) for word in words):
            scores = self.word_scores(encoded, " ".join(words), language)
            return {
                word: score - math.log(CLEAR)
                for word, (_, score) in zip(words, scores, strict=True)
                if isinstance(word, FreeWord)
            }
        if language not in (None, "en"):
            return {}
        rivals = {
            word: other
            for at, word in enumerate(words)
            if word in ALIKE
            and self.grammar.possible(other := (*words[:at], ALIKE[word], *words[at + 1 :]), (), language)
        }
        if not rivals:
            return {}
        ahead = [self._parted(encoded, other, language) for other in rivals.values()] if heard else []
        if not ahead or min(ahead) < SURELY_THIS:
            said, *others = self.score_words(encoded, [words, *rivals.values()], language)
            ahead = [said - other for other in others]
        return {
            word: apart - RIVAL_MARGIN + (TEEN if word.endswith("ty") else -TEEN)
            for word, apart in zip(rivals, ahead, strict=True)
        }

    def _parted(self, encoded: Encoded, other: Sequence[str], language: str | None) -> float:
        """nats by which what was heard freely is likelier than another sentence, at the piece where they part."""
        rows = self.decoded(encoded)
        heard = max(rows, key=len, default=())
        ahead = math.inf
        for spelled in spellings(other, language):
            pieces = self.tokenizer(language).encode(" " + written(spelled, language))
            pairs = enumerate(zip(heard, pieces, strict=False))
            parts = next((at for at, (one, piece) in pairs if one != piece), None)
            if parts is None:  # nothing was heard, or one goes on where the other ends
                return -math.inf
            row = rows[heard[:parts]]
            ahead = min(ahead, float(row[heard[parts]] - row[pieces[parts]]))
        return ahead

    # -- what shall not be done ---------------------------------------------------------------------

    def _ahead(self, encoded: Encoded, words: Sequence[str], language: str | None, *, heard: bool = False) -> float:
        """nats by which a command is likelier than that it shall not be done.

        Args:
            encoded: the sound.
            words: of the command.
            language: of the speech.
            heard: whether the model heard just these.
        """
        forbidden = self.grammar.forbidden(words, language)
        if not forbidden:
            return math.inf
        if heard:
            # What follows is hardly likelier after a "don't".
            ahead = min(self._parted(encoded, one, language) for one in forbidden)
            if ahead >= SURELY_SAID:
                return ahead
        spelled = {True: in_digits(words), False: list(words)}
        scores = self.score(encoded, [written(one, language) for one in spelled.values()], language)
        said, digits = max(zip(scores, spelled, strict=True))
        forbidden = [in_digits(one) if digits else one for one in forbidden]
        return said - max(self.score(encoded, [written(one, language) for one in forbidden], language))

    def refused(self, encoded: Encoded, free: str, meaning: Interpretation, language: str | None) -> bool:
        """Whether it was heard that something shall not be done. In noise a "don't" is heard where "go" was said, so
        what was not heard clearly may have been a command."""
        negated = meaning.reason.startswith("negated") and not NARRATING.isdisjoint(self.grammar.words(free, language))
        return meaning.refuses and not (negated and not self.story(encoded, free, language))

    def story(self, encoded: Encoded, free: str, language: str | None) -> list[str]:
        """Words with which a sentence is no command, of those that were heard clearly: in noise anything is heard."""
        words = [NARRATING.intersection(Utterance.of(word, language or "en").words) for word in free.split()]
        if not any(words):
            return []
        heard = self.word_scores(encoded, free, language)
        return [word for said, (_, score) in zip(words, heard, strict=True) if score > math.log(CLEAR) for word in said]
