"""A model steered by the grammar: hear freely, then ask which sentence of the grammar the sound fits best.

A free decode gives words, nearly right. If they are a sentence of the grammar nothing more is asked. Else sentences of
the grammar are found in two ways: those that sound most like the words heard are looked up in the automaton and scored
against the sound, in one pass each; and where none of them is sure, the model is led along the automaton
(:mod:`~intent_engine.speech.hypotheses.guided`). What speaks for and against the best is weighed in
:mod:`~intent_engine.speech.hypotheses.evidence`.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from intent_engine.interpretation import Interpretation, Status
from intent_engine.speech.acoustic.loops import stutters
from intent_engine.speech.acoustic.writing import written
from intent_engine.speech.audio import SAMPLE_RATE, Samples, in_silence
from intent_engine.speech.hypotheses.clearness import CLEAR
from intent_engine.speech.hypotheses.dictating import DICTATED, as_heard, begin_of, hardly_begun
from intent_engine.speech.hypotheses.forbidding import said_otherwise
from intent_engine.speech.hypotheses.guided import DEEP, USUAL, Effort
from intent_engine.speech.hypotheses.narration import NARRATING
from intent_engine.speech.hypotheses.opinion import Opinion, Reading, read_alone
from intent_engine.speech.hypotheses.other_commands import OtherCommands
from intent_engine.speech.hypotheses.pace import too_few, too_many
from intent_engine.speech.hypotheses.ranking import ranked
from intent_engine.speech.hypotheses.weighing import beside_heard, doubted
from intent_engine.speech.recognizer import Encoded, Transcript

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["Steering"]

SHORT_SECONDS = 1.2
"""A sound shorter than this is a word or two, which the models know from recordings that begin in silence,"""
QUIET_SECONDS = 0.3
"""so they are given some, at most this before it and after it. Of 191 single words of people cut as the endpoint cuts
them tiny.en wrote 79 % as they were, and 87 % with 0.3 s before them; Moonshine 69 % and, with 0.3 s on both sides,
80 %. Longer commands gained nothing by it and were taken for others more often."""
SINGLES = 12
"""Single words of the grammar that are scored against the sound besides those like the words heard,"""
FEW_WORDS = 2
"""where no more words were heard than these."""
DRAFTS = 3
"""Utterances from which the model is led along the automaton."""
SURE = 0.9
"""Confidence from which no other sentence is looked for,"""
CLOSE_GAP = 0.3
"""unless the free words are likelier by this gap: then there may be one that was not found yet."""
CLEAR_TALK = -0.4
"""Mean log probability of the free words from which they were heard clearly,"""
FARFETCHED = 0.02
"""and confidence of the nearest sentence below which such words are other talk, so that nothing more is looked for: of
347 commands whose words were no sentence, half of them in noise, none was lost that would have been done, and of 60
orders of coffee given to a robot 49 are left at this."""
EITHER_LANGUAGE = 3.0
"""nats by which a language may be less likely than another, and be the one that was spoken: of 53 English commands by
synthetic voices all were English by 5.4 nats and more, of 60 German ones 8 seemed to be English, 7 of them by less."""
LANGUAGE_WEIGHT = 0.3
"""of a nat of that beside one of the mean of what is heard in it."""
RETRY_SCORE = -1.0
"""Mean log probability of the free words below which a longer encoder input is tried, if nothing sure was found."""


class Steering(OtherCommands):
    """What a model that can be asked what it thinks of words becomes with a grammar: a recogniser for one engine."""

    def steer(self, engine: IntentEngine) -> None:
        """By the grammar of an engine; it may be reloaded at any time."""
        self.know(engine)
        self.opinion: Opinion | None = None
        """What it made of the sound that it heard last."""

    def prepare(self) -> None:
        """Make ready what the first words would wait for, if their language is known: a third of a second."""
        if self.language is not None:
            self.guide(self.language)
            self.grammar.look_ahead(self.language)

    def glance(self, samples: Samples) -> Transcript:
        """As :meth:`~intent_engine.speech.recognizer.Glancing.glance`."""
        began = time.perf_counter()
        self.stay()
        try:
            heard = self.listen(samples)
        except RuntimeError:  # CUDA's, for which a decode goes over to the processor
            return Transcript("", draft=True)
        return replace(heard.transcript, draft=not heard.clear, decode_seconds=time.perf_counter() - began)

    def _heard(self, samples: Samples, *, final: bool) -> Transcript:
        self.stay()
        self.opinion = self._doubted(self.search(self.compare(self.listen(samples))), far=True)
        return self.clear(self.opinion)

    def listen(self, samples: Samples, *, longer: bool = False, told: Callable[[], str] | None = None) -> Opinion:
        """The words heard freely. Settled where nothing is to be found out about them: they are a sentence of the
        grammar, or say that something shall not be done, or there are none.

        Args:
            samples: ``(n,)``
            longer: whether with more silence after the speech than usual.
            told: gives the words that somebody else hears in the sound, as far as they are known. They change nothing
                but how long it takes.
        """
        self.check()
        sound = in_silence(samples, SHORT_SECONDS, QUIET_SECONDS)
        seconds = sound.size / SAMPLE_RATE
        encoded = self.encode(sound, self.longer(seconds)) if longer else self.encode(sound)
        self.draft = self.drafted(samples, told, self.language)
        language = self.language or self._spoken_language(encoded)
        free, mean, _ = self.greedy(encoded, language)
        self.drafts.keep(samples, self.pieces_written(encoded))
        heard = Transcript(free, mean, free, language=language)
        meaning = self.grammar.parse(free, language)
        if not meaning.stops and stutters(free):
            if not longer and self.longer(seconds) > seconds:
                return self.listen(samples, longer=True, told=told)
            heard = replace(heard, score=min(mean, RETRY_SCORE))
        words = self.grammar.words(free, language)
        addressed = self.grammar.wake(language).addressed(words)  # "no, but" may have been a wake word
        refused = addressed and self.refused(encoded, free, meaning, language)
        if not free or (refused and not self._may_be_dictated(words, language)):
            return Opinion(self, samples, encoded, heard, settled=True)
        exact = meaning.status is Status.ACCEPTED and meaning.confidence == 1.0
        exact = exact and self.clearly_heard(encoded, mean, language, few=len(words) <= FEW_WORDS or meaning.stops)
        in_time = not (too_many(words, samples) or too_few(words, samples))
        dictated = self.grammar.dictated(free, language) if exact and in_time and not meaning.stops else ()
        if dictated:
            sure = replace(heard, gap=0.0, confidence=1.0)
            sentences = ((*dictated, DICTATED),)
            return Opinion(self, samples, encoded, sure, sentences, settled=True, dictated=dictated)
        # Whatever is odd about a stop, it is done at once.
        if exact and (meaning.stops or (in_time and self._plain(encoded, free, words, meaning, language))):
            close = self.close_to(encoded, words, language)
            unclear = dict.fromkeys((*close.values(), *_below(self.clearness(encoded, words, language, heard=True))))
            sure = replace(heard, gap=0.0, unclear=tuple(unclear), confidence=1.0)
            return Opinion(self, samples, encoded, sure, (tuple(words), *close), settled=True)
        return Opinion(self, samples, encoded, heard)

    def _spoken_language(self, encoded: Encoded) -> str:
        """The language of the speech; where it may be one as well as another, that in which it is a command, or says
        that something shall not be done, or else is heard more clearly."""
        likely = self.detect(encoded, self.grammar.languages)
        near = [one for one, chance in likely.items() if max(likely.values()) - chance < EITHER_LANGUAGE]
        if len(near) == 1:
            return near[0]

        def fits(language: str) -> tuple[bool, float]:
            text, mean, _ = self.greedy(encoded, language)
            meaning = self.grammar.parse(text, language)
            understood = bool(meaning.actions) or meaning.refuses
            return understood, mean + LANGUAGE_WEIGHT * likely[language]

        return max(near, key=fits)

    def _plain(
        self, encoded: Encoded, free: str, words: Sequence[str], meaning: Interpretation, language: str | None
    ) -> bool:
        """Whether a sentence is what people say, and words that say nothing were heard clearly: "fahr bitte in ..."."""
        said = set(self.grammar.empty_inside(words, language))
        clearly = not said or said <= self.heard_clearly(encoded, free, language)
        return clearly and self.grammar.plain(words, meaning, language)

    def _may_be_dictated(self, words: Sequence[str], language: str | None) -> bool:
        """Whether what shall not be done may stand in a dictated text: "right down, do not forget the keys"."""
        told = next((place for place, word in enumerate(words) if word in NARRATING), len(words))
        return any(len(begin_of(one)) <= told for one in self.grammar.openings(words, language))

    def compare(self, heard: Opinion) -> Opinion:
        """What was heard, taken for one of the sentences of the grammar that are like the words. Settled where it
        surely is one of them, or clearly none."""
        if heard.settled:
            return heard
        compared = self._compared(heard, None)
        talk = compared.transcript.sureness < FARFETCHED and heard.transcript.score > CLEAR_TALK
        compared = self._doubted(compared)
        confidence, gap = compared.transcript.sureness, compared.transcript.gap
        sure = confidence >= SURE and gap is not None and gap < CLOSE_GAP
        return replace(compared, settled=sure or talk)

    def search(self, heard: Opinion) -> Opinion:
        """What was heard, taken for one of those sentences, or of those that the model finds likeliest; if nothing sure
        is found, with a longer input once more. This takes most of the time. Settled."""
        if heard.settled:
            return heard
        found = replace(self._compared(heard, USUAL), settled=True)
        if heard.transcript.score > RETRY_SCORE or found.transcript.sureness >= SURE:
            return found
        again = self.listen(heard.samples, longer=True)
        if again.settled:
            return again  # what was heard at last to be refused is not done, however sure it seemed before
        again = replace(self._compared(again, USUAL), settled=True)
        return again if again.transcript.sureness > found.transcript.sureness else found

    def dig(self, heard: Opinion, searched: Opinion) -> Opinion:
        """What was heard, after a search that takes several times as long, for what would else be asked back.

        Args:
            heard: before it was searched; where that was settled already, nothing more is found.
            searched: what :meth:`search` made of it.
        """
        if heard.settled or not searched.transcript.free_text:
            return searched
        return replace(self._compared(searched, DEEP), settled=True)

    def _doubted(self, heard: Opinion, *, far: bool = False) -> Opinion:
        """What was heard, compared with other commands beside the likeliest, as :func:`doubted` has them."""
        if not heard.sentences or heard.transcript.confidence == 1.0:
            return heard
        return read_alone(heard, doubted(self.grammar, [heard], far=far))

    def _compared(self, heard: Opinion, effort: Effort | None) -> Opinion:
        """What was heard, taken for the likeliest sentence of the grammar."""
        readings = self.readings(heard, effort)
        free, language = heard.transcript.free_text, heard.transcript.language
        unread = replace(heard, transcript=Transcript(free, heard.transcript.score, free, language=language))
        return read_alone(unread, readings)

    def clear(self, heard: Opinion) -> Transcript:
        """What was heard, with the words that were not heard clearly, if it may be acted on."""
        transcript = heard.transcript
        # Heard word by word, and looked at already; but not who else may have begun a text.
        known = heard.settled and transcript.confidence == 1.0 and not heard.dictated
        if known or not heard.sentences or not self.grammar.acted_on(transcript.sureness, transcript.language):
            return transcript
        best = heard.sentences[0]
        otherwise = said_otherwise(self.grammar, heard.sentences, transcript.language)
        unclear = (*self._hardly_heard_before(heard), *_below(heard.clearness(best, otherwise)))
        unclear += hardly_begun(best, [heard])
        said = beside_heard(self.grammar, best, [heard])
        unclear += said.begins_unheard()
        left_out = self.left_out(heard.encoded, best, heard.heard_beside(best), transcript) or said.opposite()
        return replace(transcript, unclear=unclear, left_out=left_out)

    def _hardly_heard_before(self, heard: Opinion) -> list[str]:
        """The words before a dictated text that were heard, but not clearly."""
        free, language = heard.transcript.free_text, heard.transcript.language
        scores = self.word_scores(heard.encoded, free, language) if heard.dictated else []
        begin = scores[: len(heard.dictated) + self.grammar.lead(heard.heard, language)]
        return [
            word
            for said, score in begin
            for word in self.grammar.words(said, language)
            if word in heard.dictated and score < math.log(CLEAR)
        ]

    # -- the sentences of the grammar --------------------------------------------------------------

    def readings(self, heard: Opinion, effort: Effort | None = USUAL) -> list[Reading]:
        """Sentences of the grammar that the sound may be, likeliest first.

        Args:
            heard: what was heard freely.
            effort: with which the model is led along the grammar; None: those are enough that are like the words heard.
        """
        self.check()
        encoded, free, language = heard.encoded, heard.transcript.free_text, heard.transcript.language
        words = heard.heard
        possible = self.possible(heard)
        dictated = [one for one in self.grammar.openings(words, language) if possible(as_heard(one, words))]
        texts = {sentence: (view,) for sentence, view in zip(dictated, heard.views(dictated), strict=True)}

        def compared() -> list[Reading]:
            views = {sentence: (view,) for sentence, view in heard.viewed(found).items()}
            return ranked(self.grammar, {**texts, **views}, language)

        like = [*self.grammar.near(words, language), *self._short(encoded, words, language)]
        if self.grammar.fits_pattern(words, language):
            like.append(tuple(words))
        like += self.otherwise.heard(words, language)
        like += [sentence for sentence in heard.sentences if not begin_of(sentence)]
        if dictated:  # else each text that somebody may have dictated would be another command
            like = [sentence for sentence in like if not self.grammar.dictated(" ".join(sentence), language)]
        like = [sentence for sentence in dict.fromkeys(like) if possible(sentence)]
        found = dict(zip(like, self.score_words(encoded, like, language), strict=True))
        readings = compared()
        if effort is None:
            return readings
        drafts = [written(reading.words, language) for reading in readings[:DRAFTS]]
        guided = self.guide(language).guided.likeliest(
            lambda beginnings, length: self.next_pieces(encoded, beginnings, length, language),
            words,
            free,
            self.score(encoded, [free], language)[0],
            drafts,
            effort,
        )
        for sentence, score in guided:
            if sentence in found or possible(sentence):
                found[sentence] = max(score, found.get(sentence, score))
        return compared()

    def _beginning(self, encoded: Encoded, language: str | None) -> npt.NDArray[np.float32]:
        """How likely every piece is to be the first: as it was heard freely, or asked anew."""
        rows = self.decoded(encoded) or dict(self.next_pieces(encoded, [()], 1, language))
        return rows[()]

    def _short(self, encoded: Encoded, heard: Sequence[str], language: str | None) -> list[tuple[str, ...]]:
        """Single words of the grammar that the sound may be, where hardly more was heard, however unlike they are
        written: a short word is soon taken for another, and nothing in a single word tells that it was."""
        if len(heard) > FEW_WORDS or not (singles := self.guide(language).singles):
            return []
        row = self._beginning(encoded, language)
        likely = sorted(singles, key=lambda word: (-row[singles[word]], word))
        return [(word,) for word in likely[:SINGLES]]


def _below(clearness: Mapping[str, float]) -> tuple[str, ...]:
    """Words that were not heard as clearly as they must be."""
    return tuple(word for word, clear in clearness.items() if clear < 0)
