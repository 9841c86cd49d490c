"""How clearly a model heard the words on which the meaning of a command hangs.

A word that no list has, a number that sounds like another, and a "don't" that may have been said are told apart by
nothing in the grammar: only by how much likelier the model finds the one than the other.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from intent_engine.interpretation import Cause, Interpretation
from intent_engine.language.networks.approximate import FreeWord
from intent_engine.language.numbers.alike import alike
from intent_engine.language.numbers.english_words import DIGITS
from intent_engine.language.numbers.letters import is_letter_of_a_code
from intent_engine.language.numbers.spelled import in_digits, number_end
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.speech.acoustic.rows import Rows
from intent_engine.speech.acoustic.scoring import Scoring
from intent_engine.speech.acoustic.writing import spellings, written
from intent_engine.speech.hypotheses.forbidding import forbidden
from intent_engine.speech.hypotheses.left_out import end_left_out
from intent_engine.speech.hypotheses.narration import NARRATING, SUBJECTS_IN
from intent_engine.speech.hypotheses.said_and_heard import SaidAndHeard
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.recognizer import Encoded, Transcript

__all__ = ["CLEAR", "RIVAL_MARGIN", "Clearness"]

CLEAR = 0.6
"""Geometric mean of the probabilities of a word's pieces, from which it was heard clearly."""
CLEAR_SUBJECT = 0.3
"""The same for a word with which a statement begins: in its place, anything else could have come."""
NOT_SAID = 5.5
"""nats by which a command must be likelier than the same with a "don't" or "never". In kitchen noise at 10 and 6 dB
"never" is heard as "then we'll" and "don't" as "go and": of 8 commands of synthetic voices that should not be done and
were heard as such that should, 7 were ahead by less, and of 80 that were heard word by word, half of them in noise,
none."""
SURELY_SAID = 6.5
"""nats by which a command is likelier than one with a "don't" at the piece where they part, from which the whole need
not be compared: of 295 that were ahead by as much there, in quiet and in noise, each was as a whole by 5.8 and more."""
RIVAL_MARGIN = 3.0
"""nats by which a number must be likelier than one that sounds like it (``numbers/alike.py``),"""
TEEN = 1.0
"""and one in -teen by so many more, one in -ty by so many less: both models are ready to hear a -teen. Of 196 numbers
of 14 synthetic voices, clean and at 10 and 6 dB, 91, 89 and 86 % are clear with it and 0.5, 1.5 and 2.0 % taken for the
other; without, 91, 86 and 83 % and 1.5, 2.6 and 3.1 %."""
FOR_FORTY = {"for": "forty", "forty": "for"}
"""What sounds alike before a digit, "for five degrees" and "forty five degrees","""
FOR_MARGIN = 1.5
"""and the nats by which either must be likelier."""
LETTER_MARGIN = 3.0
"""nats by which a letter beside a number, "f three", must be likelier than any other: most rhyme with several."""
SURELY_THIS = 4.5
"""nats by which the first piece of a number that was heard is likelier than that of the one it sounds like, from which
the sentences need not be compared: of 24 that were heard word by word these differed by as much, or up to 5 more."""
DOUBTFUL_SCORE = -0.6
"""Mean log probability of the free words below which others are looked at, though they are a sentence already,"""
DOUBTFUL_SENTENCE = -0.8
"""and of more than a few words that are no stop. How they are written is part of it: "30" or "thirty"."""
CLEAR_WORDS = -0.5
"""The same however they might be written, from which they need not be looked at after all,"""
CLEAR_SENTENCE = -0.7
"""and of more than a few words. Of 1,062 hearings that were a sentence word by word (six domains, and single words by
people; clean, at 10 and 6 dB) 240 were in doubt by the former. By these 128 are not, of which none is wrong; of the
112 that still are, ten."""


class Clearness(Scoring):
    """A model that says how clearly it heard words of a grammar."""

    grammar: SpokenGrammar
    """Which sentences it may have heard."""

    def as_written(self, language: str | None = None) -> Mapping[str, str]:
        return self.grammar.as_written(language)

    def calls(self, language: str | None = None) -> PhraseSet:
        return self.grammar.wake(language).phrases

    def clearly_heard(self, encoded: Encoded, mean: float, language: str | None, *, few: bool) -> bool:
        """Whether a sentence that was heard word by word needs no other to be looked at."""
        doubtful, clear = (DOUBTFUL_SCORE, CLEAR_WORDS) if few else (DOUBTFUL_SENTENCE, CLEAR_SENTENCE)
        return mean > doubtful or self.however_written(encoded, language) > clear

    def heard_clearly(self, encoded: Encoded, free: str, language: str | None) -> frozenset[str]:
        """The words of a text that was heard freely, that were heard clearly."""
        scores = self.word_scores(encoded, free, language)
        clear = (word for word, score in scores if score > math.log(CLEAR))
        return frozenset(one for word in clear for one in self.grammar.words(word, language))

    def left_out(
        self, encoded: Encoded, words: Sequence[str], heard: Sequence[str], transcript: Transcript
    ) -> tuple[str, ...]:
        """The first and the last words that a sentence leaves out, or those that leave open what is meant, if they were
        heard clearly: in noise one model alone hears anything there. But after a sentence that could have gone on,
        whatever was heard there may be how: of "rückwärts" there was an "Ökmetz".

        Args:
            encoded: the sound.
            words: of the sentence.
            heard: the words that were heard freely.
            transcript: of them.
        """
        language = transcript.language
        said = SaidAndHeard(self.grammar, words, [heard], language, [transcript.free_text])
        left_out = said.left_out() or said.left_open()
        if not left_out:
            return ()
        clearly = self.heard_clearly(encoded, transcript.free_text, language)
        end = "" if self.grammar.settled(words, language) else " ".join(end_left_out(words, [heard]))
        return tuple(part for part in left_out if part == end or clearly.issuperset(part.split()))

    def clearness(
        self,
        encoded: Encoded,
        words: Sequence[str],
        language: str | None = None,
        *,
        heard: bool = False,
        others: Sequence[Sequence[str]] = (),
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
            others: of the same meaning, of which a "don't" may have been said as well: "go on to the kitchen" sounds
                like "don't go to the kitchen".
        """
        dictated = self.grammar.dictated(" ".join(words), language)
        found = {} if dictated else self._known_clearly(encoded, words, language, heard=heard)
        ahead = self._ahead(encoded, words, language, heard=heard, others=others) - NOT_SAID
        if math.isfinite(ahead):
            begin = " ".join(words[: self.grammar.lead(words, language) or 1])
            found[begin] = min(ahead, found.get(begin, math.inf))
        return found

    def _known_clearly(
        self, encoded: Encoded, words: Sequence[str], language: str | None, *, heard: bool
    ) -> dict[str, float]:
        if any(isinstance(word, FreeWord) for word in words):
            return {
                word: score - math.log(CLEAR)
                for word, score in zip(words, self._by_word(encoded, words, language), strict=True)
                if isinstance(word, FreeWord)
            }
        letters = self.grammar.letters(language)
        rivals = [
            (word, margin, other)
            for at, word in enumerate(words)
            for instead, margin in _sounding_like(words, at, language, letters)
            if self.grammar.possible(other := (*words[:at], instead, *words[at + 1 :]), (), language)
        ]
        if not rivals:
            return {}
        ahead = [self._heard_apart(encoded, other, language) for *_, other in rivals] if heard else []
        if not ahead or min(ahead) < SURELY_THIS:
            said, *others = self.score_words(encoded, [words, *(other for *_, other in rivals)], language)
            ahead = [said - other for other in others]
        found: dict[str, float] = {}
        for (word, margin, other), apart in zip(rivals, ahead, strict=True):
            clear = apart - margin + self._usual(words, other, language)
            found[word] = min(clear, found.get(word, math.inf))
        return found

    def _by_word(self, encoded: Encoded, words: Sequence[str], language: str | None) -> list[float]:
        """Mean log probability of the pieces of each word, in the likeliest writing: "call Anna" was not said small,
        and the number of "in ten minutes" is mostly written in figures, which count for all its words."""
        names = self.names(language)
        ways = {tuple((word, 1) for word in words): None}
        if language in (None, "en"):
            ways[_in_figures(words)] = None
        scored = []
        for way in ways:
            said = [word for word, _ in way]
            for text in dict.fromkeys((" ".join(said), " ".join(map(names.large, said)))):
                scores = zip(self.word_scores(encoded, text, language), way, strict=True)
                scored.append([score for (_, score), (_, count) in scores for _ in range(count)])
        return max(scored, key=sum)

    def _usual(self, words: Sequence[str], other: Sequence[str], language: str | None) -> float:
        """nats by which the numbers of a sentence are more usual than those of another."""
        said, instead = (self.grammar.parse(" ".join(one), language) for one in (words, other))
        return self.grammar.unusual(instead, language) - self.grammar.unusual(said, language)

    def _heard_apart(self, encoded: Encoded, other: Sequence[str], language: str | None) -> float:
        """nats by which what was heard freely is likelier than another sentence, at the piece where they part."""
        rows = self.decoded(encoded)
        heard = max(rows, key=len, default=())
        spelled = (self._pieces_of(one, language) for one in spellings(other, language, self.names(language)))
        return min(_apart(heard, pieces, rows) for pieces in spelled)

    def _pieces_of(self, words: Sequence[str], language: str | None) -> tuple[int, ...]:
        return tuple(self.tokenizer(language).encode(" " + written(words, language)))

    # -- what shall not be done ---------------------------------------------------------------------

    def _ahead(
        self,
        encoded: Encoded,
        words: Sequence[str],
        language: str | None,
        *,
        heard: bool,
        others: Sequence[Sequence[str]] = (),
    ) -> float:
        """nats by which a command is likelier than that it shall not be done.

        Args:
            encoded: the sound.
            words: of the command.
            language: of the speech.
            heard: whether the model heard just these.
            others: of the same meaning.
        """
        ways = (words, *others)
        negated = list(dict.fromkeys(one for way in ways for one in forbidden(self.grammar, way, language)))
        if not negated:
            return math.inf
        # What follows is hardly likelier after a "don't".
        if heard and (ahead := min(self._heard_apart(encoded, one, language) for one in negated)) >= SURELY_SAID:
            return ahead
        spelled = {True: in_digits(words, language), False: list(words)}
        scores = self.score(encoded, [written(one, language) for one in spelled.values()], language)
        said, digits = max(zip(scores, spelled, strict=True))
        negated = [in_digits(one, language) if digits else one for one in negated]
        if not heard and (ahead := self._begins_apart(encoded, spelled[digits], negated, language)) >= SURELY_SAID:
            return ahead
        return said - max(self.score(encoded, [written(one, language) for one in negated], language))

    def _begins_apart(
        self, encoded: Encoded, words: Sequence[str], others: Sequence[Sequence[str]], language: str | None
    ) -> float:
        """nats by which a sentence is likelier than each of some others at the piece where they part."""
        said = self._pieces_of(words, language)
        pieces = [self._pieces_of(other, language) for other in others]
        begun = {said[: _shared(said, other)] for other in pieces}
        rows = dict(self.next_pieces(encoded, sorted(begun), 1, language))
        return min(_apart(said, other, rows) for other in pieces)

    def refused(self, encoded: Encoded, free: str, meaning: Interpretation, language: str | None) -> bool:
        """Whether it was heard that something shall not be done. In noise a "don't" is heard where "go" was said, so
        what was not heard clearly may have been a command."""
        negated = Cause.NEGATED in meaning.causes and not NARRATING.isdisjoint(self.grammar.words(free, language))
        return meaning.refuses and not (negated and NARRATING.isdisjoint(self.story(encoded, free, language)))

    def story(self, encoded: Encoded, free: str, language: str | None) -> list[str]:
        """Words with which a sentence is no command, of those that were heard clearly: in noise anything is heard."""
        spoken = [Utterance.of(word, language or "en").words for word in free.split()]
        words = [word for one in spoken for word in one]
        begin, telling = self.grammar.lead(words, language), self.grammar.narrating(language)
        subjects = SUBJECTS_IN.get(language or "en", {})
        least: list[tuple[int, str, float]] = []
        count = 0
        for place, one in enumerate(spoken):
            least += [(place, word, CLEAR) for word in one if word in telling]
            least += [(place, word, CLEAR_SUBJECT) for word in one[:1] if count == begin and word in subjects]
            count += len(one)
        if not least:
            return []
        heard = self.word_scores(encoded, free, language)
        return [word for place, word, clear in least if heard[place][1] > math.log(clear)]


def _sounding_like(
    words: Sequence[str], at: int, language: str | None, letters: Iterable[str]
) -> Iterator[tuple[str, float]]:
    """What a word of a number or the letter of a code may have been, each with the nats by which it must be likelier;
    of the letters some."""
    word, after = words[at], "".join(words[at + 1 : at + 2])
    english = language in (None, "en")
    ends = (-TEEN if word.endswith("ty") else TEEN) if english else 0.0
    yield from ((other, RIVAL_MARGIN + ends) for other in alike(word, language))
    if english and word in FOR_FORTY and after in DIGITS:
        yield FOR_FORTY[word], FOR_MARGIN
    if is_letter_of_a_code(words, at, language):
        yield from ((other, LETTER_MARGIN) for other in sorted(letters) if other != word)


def _in_figures(words: Sequence[str]) -> tuple[tuple[str, int], ...]:
    """English words with whole numbers in figures, each with the number of words that it stands for."""
    found: list[tuple[str, int]] = []
    at = 0
    while at < len(words):
        end = max(number_end(words, at), at + 1)
        figures = in_digits(words[at:end])
        found.append((figures[0] if len(figures) == 1 else words[at], end - at if len(figures) == 1 else 1))
        at += found[-1][1]
    return tuple(found)


def _shared(one: Sequence[int], other: Sequence[int]) -> int:
    """How many pieces two texts have in common before they part."""
    return next((at for at, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))


def _apart(said: tuple[int, ...], other: Sequence[int], rows: Rows) -> float:
    """nats by which a text is likelier than another at the piece where they part, by how likely every piece is after
    what they share; far less where one of them has no such piece."""
    parts = _shared(said, other)
    if parts in (len(said), len(other)):
        return -math.inf
    row = rows[said[:parts]]
    return float(row[said[parts]] - row[other[parts]])
