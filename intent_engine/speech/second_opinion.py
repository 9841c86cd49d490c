"""A second model for what the first is not sure of.

Most commands are heard well by a small model in a few hundredths of a second. In noise it is often unsure, and then the
person would have to say it again; a model of another make knows the answer sooner than they could. It listens beside
the first, and is left where that heard a sentence of the grammar word by word. Where both are sure, it is done; where
they are not, both search the grammar, which takes most of the time, and only when the person is silent.

Each says which sentences of the grammar it may have been, and what it thinks of the other's; what both think of it
becomes one (:mod:`~intent_engine.speech.hypotheses.combination`). Here is who is asked, and when.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterable
from concurrent.futures import Future
from dataclasses import dataclass, replace
from threading import Event
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from intent_engine.interpretation import Interpretation
from intent_engine.speech.acoustic.moonshine import MoonshineModel, MoonshineRecognizer
from intent_engine.speech.again import heard_again
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.beside import Beside, cores
from intent_engine.speech.hypotheses.combination import Combination
from intent_engine.speech.hypotheses.opinion import Opinion, Steered
from intent_engine.speech.hypotheses.pace import too_few
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.leaving import LeftError
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.steering import CLEAR_TALK
from intent_engine.speech.thresholds import enough_to_stop

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["SecondOpinion"]

_Answer = TypeVar("_Answer")

SURE_TOGETHER = 0.9
"""Confidence of both from which they do not search the grammar for more,"""
NEARLY = 2.0
"""where one of them heard the sentence but for so many letters. Else there may be a better one beside it, which is like
neither's words: "a bit of sun earth" is nearer to "sugar" than to "soy milk"."""
SURE_OF_A_WORD = 0.95
"""Confidence of the first in a single word, from which the second is not asked: in noise tiny.en hears nearly twice as
many single words as Moonshine, which then says "Don't" for "go"."""
HOPELESS = 0.03
"""Confidence of the first, below which the second is not asked about words that the first heard clearly."""
MOSTLY_KNOWN = 0.75
"""Share of such words that the grammar has, from which they are probably a command, and the second is asked before that
is known: so are nine of ten orders of coffee in noise and commands, and four of a hundred things that people say to
each other in a grammar of 370 words, in one of 800 every second or fifth."""
LATER = 1.5
"""s by which an utterance may have gone on since it was heard with less care, all of them silent."""
SOON = 1.5
"""s that a search may take for a deeper one to follow, which takes up to five times as long: on a slow machine it would
seem to hang."""
CLOSING = 2.0
"""s that the second model is given to end what it does."""
UNSETTLED = 0.1
"""s at the end of such a sound that a noise filter may still change."""


@dataclass(frozen=True, slots=True)
class _Look:
    """What was made of a sound at first sight."""

    samples: Samples
    first: Opinion
    second: Opinion | None
    """None: not asked."""
    transcript: Transcript
    doubtful: bool
    """Whether more is to be found."""


class SecondOpinion:
    """Two recognisers of one engine, of which the second has a say where the first is unsure.

    Args:
        engine: whose grammar steers both.
        first: hears everything.
        second: makes the one that is asked in doubt. It is called at once, in a thread beside, since a model
            takes a second to load; what it raises is raised by every doubtful decode.
    """

    def __init__(self, engine: IntentEngine, first: Steered, second: Callable[[], Steered]) -> None:
        self._grammar = SpokenGrammar(engine)
        self._first = first
        self._both = Combination(self._grammar, self._each)
        self._beside = Beside("second model")
        self._prepared = self._beside.submit(first.prepare)
        self._second = self._beside.submit(_ready, second)
        self._draft: _Look | None = None
        """What was last heard with less care."""
        self._talk_seen = False
        """Whether what was glanced at last was clear talk."""
        self._left = Event()
        """Set when nobody waits for the second any more."""
        self._told = ""
        """The words that the first has heard so far of what is being said, for the second."""

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        began = time.perf_counter()
        self._first.stay()
        self._left = Event()
        try:
            transcript = self._first.despite_cuda(lambda: self._transcribe(samples, final=final))
        except LeftError:
            self._left.set()
            self._beside.submit(lambda: None).exception()  # the second model has to leave it too before the next
            raise
        return replace(transcript, decode_seconds=time.perf_counter() - began)

    def glance(self, samples: Samples) -> Transcript:
        """As :meth:`~intent_engine.speech.recognizer.Glancing.glance`: the first model alone."""
        self._prepared.result()
        glanced = self._first.glance(samples)
        self._told = glanced.free_text
        self._talk_seen = glanced.draft and self._talk(glanced)
        return glanced

    def follow(self, samples: Samples) -> Transcript:
        """As :meth:`~intent_engine.speech.recognizer.Following.follow`: the first model alone."""
        self._prepared.result()
        heard = self._first.follow(samples)
        self._told = heard.free_text
        return heard

    def lose(self) -> None:
        """As :meth:`~intent_engine.speech.recognizer.Following.lose`."""
        self._first.lose()

    def leave(self) -> None:
        """As :meth:`~intent_engine.speech.leaving.Leavable.leave`."""
        self._first.leave()
        self._left.set()

    def _transcribe(self, samples: Samples, *, final: bool) -> Transcript:
        known = self._draft if final and self._draft is not None and _same(samples, self._draft.samples) else None
        look = known or self._look(samples)
        self._draft = None if final else look
        transcript = look.transcript
        if look.doubtful and final:
            transcript = self._searched(look)
        if final:
            self._told = ""
        return replace(transcript, draft=look.doubtful and not final)

    def second_weights(self) -> Future[MoonshineModel | None]:
        """The weights of the second model as soon as they are loaded, for others who listen; None: it is no
        Moonshine."""

        def weights() -> MoonshineModel | None:
            second = self._second.result()
            return second.model if isinstance(second, MoonshineRecognizer) else None

        return self._beside.submit(weights)

    def _look(self, samples: Samples) -> _Look:
        """What both models make of a sound at first sight. Both listen at once, where each has a core, unless it was
        clear talk at a glance; the second is left where the first was sure of every word, or heard what is clearly no
        command."""
        self._prepared.result()
        asked = self._ask(samples) if cores() > 1 and not self._talk_seen else None
        self._talk_seen = False
        heard = self._first.listen(samples)
        self._told = heard.transcript.free_text
        if heard.settled and not (heard.transcript.unclear or heard.dictated):
            self._left.set()
            return _Look(samples, heard, None, heard.transcript, False)
        if self._talk(heard.transcript):
            self._left.set()
            asked = None
        elif asked is None:
            asked = self._ask(samples)
        first = self._first.compare(heard)
        confidence = first.transcript.sureness
        said = first.transcript.text.split()
        word = confidence >= SURE_OF_A_WORD and len(said) == 1 and not too_few(said, samples)
        hopeless = heard.transcript.score > CLEAR_TALK and confidence < HOPELESS
        if word or self._stops(first.transcript) or hopeless:
            self._left.set()
            clear = self._first.clear(first)
            return _Look(samples, first, None, clear, False)
        second = (asked or self._ask(samples)).result()
        both, apart = self._both.weighed(first, second)
        sure = both.sureness >= SURE_TOGETHER and apart <= NEARLY and not (both.unclear or both.left_out)
        known = (first.settled and second.settled) or self._meaning(both).refuses
        return _Look(samples, first, second, both, not (sure or known))

    def _talk(self, heard: Transcript) -> bool:
        """Whether the first heard clearly what is probably no command."""
        words = self._grammar.words(heard.free_text, heard.language)
        return heard.score > CLEAR_TALK and self._grammar.share_known(words, heard.language) < MOSTLY_KNOWN

    def _ask(self, samples: Samples) -> Future[Opinion]:
        """The second model's first sight of a sound, in a thread beside."""
        self._left = Event()  # it may have been left before
        return self._aside(lambda second: second.compare(second.listen(samples, told=lambda: self._told)))

    def _aside(self, ask: Callable[[Steered], _Answer]) -> Future[_Answer]:
        """What the second model answers, in a thread beside, as long as this decode is waited for."""
        left = self._left

        def answer() -> _Answer:
            second = self._second.result()
            second.left = left
            return second.despite_cuda(lambda: ask(second))

        return self._beside.submit(answer)

    def _searched(self, look: _Look) -> Transcript:
        """What both make of a sound when they have searched the grammar, side by side: once more and deeper, if it
        would be asked back else; and what they make of it when they hear it again, if it is not sure then."""
        began = time.perf_counter()
        both = self._sought(look, began)
        late = time.perf_counter() - began > SOON
        return heard_again(both, look.samples, self._grammar, self._heard, late=late)

    def _sought(self, look: _Look, began: float) -> Transcript:
        """What both find in the grammar."""
        assert look.second is not None
        before = look.second
        first, other, both = self._side_by_side(look.first, before)
        known = self._grammar.acted_on(both.sureness, both.language) or self._meaning(both).refuses
        if known or time.perf_counter() - began > SOON:
            return both
        dug = self._aside(lambda second: second.dig(before, other))
        both, _ = self._both.weighed(self._first.dig(look.first, first), dug.result(), far=True)
        return both

    def _side_by_side(self, first: Opinion, second: Opinion) -> tuple[Opinion, Opinion, Transcript]:
        """What each finds in the grammar, and what both make of that."""
        searched = self._aside(lambda model: model.search(second))
        found, other = self._first.search(first), searched.result()
        both, _ = self._both.weighed(found, other, far=True)
        return found, other, both

    def _heard(self, samples: Samples, searching: bool) -> Transcript:
        """What both make of a sound at first sight, or when they have searched the grammar, without digging."""
        look = self._look(samples)
        if look.second is None or not (look.doubtful and searching):
            return look.transcript
        *_, both = self._side_by_side(look.first, look.second)
        return both

    def _stops(self, heard: Transcript) -> bool:
        return heard.sureness >= enough_to_stop(heard) and self._meaning(heard).stops

    def close(self) -> None:
        self._first.close()
        closed = self._beside.submit(lambda: self._second.result().close())
        self._beside.close()
        with contextlib.suppress(Exception):  # one that was never made has nothing to let go of; one that hangs cannot
            closed.result(timeout=CLOSING)

    def _each(self, ask: Callable[[Opinion], Any], opinions: Iterable[Opinion], /) -> list[Any]:
        """The same asked of two models, side by side."""
        first, second = opinions
        other = self._aside(lambda _: ask(second))
        return [ask(first), other.result()]

    def _meaning(self, heard: Transcript) -> Interpretation:
        return self._grammar.parse(heard.text, heard.language)


def _ready(make: Callable[[], Steered]) -> Steered:
    """A model that is made, and ready for the first words."""
    made = make()
    made.prepare()
    return made


def _same(samples: Samples, known: Samples) -> bool:
    """Whether an utterance is one that was heard before, when it seemed to be over."""
    same = known.size - int(UNSETTLED * SAMPLE_RATE)
    if not 0 < same <= samples.size <= known.size + int(LATER * SAMPLE_RATE):
        return False
    return np.allclose(samples[:same], known[:same], atol=1e-4)
