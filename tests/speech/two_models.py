"""Two models that hear what they were made for: an opinion that was made up, and a recogniser that has it."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field, replace

import numpy as np

from intent_engine.speech.again import LATER
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.hypotheses.dictating import as_heard, as_written
from intent_engine.speech.hypotheses.evidence import View, letters_apart
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.second_opinion import SecondOpinion

SOUND = np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE).astype(np.float32)
FORWARD, LEFT = "go forward two meters", "turn left"
LIKELY, UNLIKELY = -1.0, -20.0


def heard(text: str, confidence: float | None, **more) -> Transcript:
    return Transcript(text, free_text=text, confidence=confidence, decode_seconds=0.25, **more)


@dataclass
class Thinks:
    """An opinion that was made up: what is thought of each sentence, and how clear words are."""

    transcript: Transcript
    scores: dict[str, float] = field(default_factory=dict)
    clear: dict[str, float] = field(default_factory=dict)
    settled: bool = False
    others: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """What else may have been said in place of a sentence."""
    shared: dict[str, dict[str, float]] = field(default_factory=dict)
    """How clear words are, with what is said in other words compared as well."""
    begins: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Sentences that mean the same and begin otherwise."""
    dictated: tuple[str, ...] = ()
    finds: dict[str, float] = field(default_factory=dict)
    """How likely texts are, as they are written."""

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return tuple(tuple(text.split()) for text in self.scores)

    @property
    def heard(self) -> list[str]:
        return self.transcript.free_text.split()

    def heard_beside(self, _words) -> list[str]:
        return self.heard

    def views(self, sentences):
        return [
            View(self.scores.get(" ".join(said), UNLIKELY), LIKELY, letters_apart(said, self.heard))
            for said in (as_heard(words, self.heard) for words in sentences)
        ]

    def written(self, begin):
        return as_written(begin, self.transcript.free_text, lambda text: text.lower().split())

    def likelihoods(self, texts):
        return [self.finds.get(text, UNLIKELY) for text in texts]

    def beside(self, words, *, far=False):
        return tuple(tuple(text.split()) for text in self.others.get(" ".join(words), ()))

    def begun(self, words):
        return tuple(tuple(text.split()) for text in self.begins.get(" ".join(words), ()))

    def clearness(self, _words, others=()):
        return self.clear | {
            word: clear for one in others for word, clear in self.shared.get(" ".join(one), {}).items()
        }


@dataclass
class Knows(Thinks):
    """One who can say of all sentences how likely they are, and thought of few."""

    thought_of: frozenset[str] = frozenset()

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return tuple(one for one in super().sentences if " ".join(one) in self.thought_of)


class Says:
    """A recogniser that hears what it was made for, and finds that likely. What it is sure of is settled."""

    def __init__(self, engine, answer: Transcript | Thinks, found: Thinks | None = None) -> None:
        if isinstance(answer, Transcript):
            answer = Thinks(answer, {answer.text: LIKELY} if engine.parse(answer.text).actions else {})
        heard = answer.transcript
        settled = heard.confidence == 1.0 or not heard.text or engine.parse(heard.text).refuses
        self.opinion = replace(answer, settled=answer.settled or settled)
        self.found = found or answer
        self.listened: list[int] = []
        self.listened_again: list[int] = []
        """The same a moment later."""
        self.buried: Thinks | None = None
        """What is found by digging."""
        self.later: Thinks | None = None
        """What is heard a moment later; None: the same."""
        self.compared = self.searched = self.dug = 0
        self.closed = False
        self.lost = 0
        """How many more times it fails, as a device that is gone."""
        self.left: threading.Event | None = None
        self.prepared = threading.Event()

    def prepare(self) -> None:
        self.prepared.set()

    def despite_cuda(self, ask):
        try:
            return ask()
        except RuntimeError:
            return ask()

    def listen(self, samples: np.ndarray, *, told=None) -> Thinks:
        assert self.prepared.is_set()
        if self.lost:
            self.lost -= 1
            raise RuntimeError("CUDA failed with error out of memory")
        if samples[:LATER].any():
            self.listened.append(samples.size)
            return self.opinion
        self.listened_again.append(samples.size - LATER)
        return self.later or self.opinion

    def glance(self, samples: np.ndarray) -> Transcript:
        return replace(self.opinion.transcript, draft=not self.opinion.settled)

    def stay(self) -> None:
        self.left = threading.Event()

    def leave(self) -> None:
        assert self.left is not None
        self.left.set()

    def compare(self, heard: Thinks) -> Thinks:
        self.compared += 1
        return heard

    def search(self, heard: Thinks) -> Thinks:
        self.searched += 1
        return heard if heard.settled else self.found

    def dig(self, heard: Thinks, searched: Thinks) -> Thinks:
        self.dug += 1
        return searched if heard.settled or self.buried is None else self.buried

    def clear(self, heard: Thinks) -> Transcript:
        assert self.left is None or not self.left.is_set(), "who is left answers nothing"
        return heard.transcript

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        return self.search(self.listen(samples)).transcript

    def close(self) -> None:
        self.closed = True


def two(engine, first: Transcript | Thinks, second: Transcript | Thinks) -> tuple[SecondOpinion, Says, Says]:
    one, other = Says(engine, first), Says(engine, second)
    return SecondOpinion(engine, one, lambda: other), one, other


UNSURE = Thinks(heard(FORWARD, 0.5), {FORWARD: -14.0})
