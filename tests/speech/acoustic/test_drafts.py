"""What was written so far is a draft, and changes nothing but how long the rest takes."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from speech_stage import Says, Voiced

from intent_engine.runtime.heard import HeardKind
from intent_engine.speech import utterance_decoder
from intent_engine.speech.acoustic.drafts import LEAST, NOTHING_DRAFTED, UNSETTLED, Draft, Drafts
from intent_engine.speech.acoustic.prefix_tree import PrefixTree
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.decoding import DecodeThread
from intent_engine.speech.leaving import LeftError
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.steered import SteeredMoonshine

PIECES = st.lists(st.integers(0, 30_000), max_size=12).map(tuple)
LONG = 60.0
"""s: nobody waits so long but where something is broken."""


@pytest.fixture(scope="module")
def moonshine(engine):
    made = SteeredMoonshine(engine)
    yield made
    made.close()


@settings(max_examples=15)
@given(draft=PIECES)
def test_whatever_the_draft_the_words_are_those_without_it(whisper, moonshine, spoken, draft):
    for model in (whisper, moonshine):
        model.draft = NOTHING_DRAFTED
        text, score, looped = model.greedy(model.encode(spoken), "en")
        model.draft = Draft(lambda: draft)
        drafted = model.greedy(model.encode(spoken), "en")
        model.draft = NOTHING_DRAFTED
        assert (drafted[0], drafted[2]) == (text, looped)
        assert drafted[1] == pytest.approx(score, abs=0.05)


@pytest.mark.parametrize(
    ("draft", "written", "after"),
    [
        ("abcdef", "", "abcdef"),
        ("abcdef", "abc", "def"),
        ("abcdef", "abcdef", ""),
        ("abcdef", "abx", ""),  # one that is not in the draft
        ("abcdef", "abxd", "ef"),  # another in its place
        ("abcdef", "abxycd", "ef"),  # two more
        ("abcdef", "ad", "ef"),  # two less
        ("abxbxf", "abyb", "xf"),  # the nearest of two that are the same
        ("abcdefghij", "j", ""),  # too far away
        ("", "abc", ""),
    ],
)
def test_where_a_text_has_left_its_draft_it_may_come_back_to_it(draft, written, after):
    assert Draft(lambda: tuple(map(ord, draft))).after(tuple(map(ord, written))) == tuple(map(ord, after))


def test_what_another_model_heard_is_a_draft_too(moonshine, spoken, monkeypatch):
    """In another's pieces, and with a word in it that was not said."""
    calls = []
    step = PrefixTree._step
    monkeypatch.setattr(PrefixTree, "_step", lambda tree, new: calls.append(len(new)) or step(tree, new))
    alone = moonshine.listen(spoken)
    one_by_one = len(calls)
    moonshine.lose()
    calls.clear()
    helped = moonshine.listen(spoken, told=lambda: alone.transcript.free_text.replace("two", "to"))
    assert helped.heard == alone.heard == ["go", "forward", "two", "meters"]
    assert len(calls) < one_by_one - 1


def test_words_that_were_heard_before_are_not_written_one_by_one(whisper, go_forward, monkeypatch):
    """A call of the model for each piece of the first sound, and one for all of those that the second begins with."""
    sound = go_forward[int(1.2 * SAMPLE_RATE) :]
    calls = []
    step = type(whisper)._written

    def counted(self, decoder, encoded, language):
        tree = self._tree(encoded, language)
        before = tree._step
        monkeypatch.setattr(tree, "_step", lambda new: calls.append(len(new)) or before(new))
        return step(self, decoder, encoded, language)

    monkeypatch.setattr(type(whisper), "_written", counted)
    whisper.lose()
    whisper.lose()
    whisper.follow(sound[: int(2.2 * SAMPLE_RATE)])
    alone = len(calls)
    calls.clear()
    heard = whisper.listen(sound[: int(2.4 * SAMPLE_RATE)])
    assert heard.heard == ["go", "forward", "two", "meters"]
    assert alone >= 5
    assert len(calls) <= 3
    assert calls[0] >= alone - 1


@given(
    seconds=st.floats(0.2, 4.0),
    later=st.floats(-1.0, 2.0),
    pieces=PIECES,
    other=st.booleans(),
    lost=st.booleans(),
)
def test_only_of_the_same_sound_going_on(seconds, later, pieces, other, lost):
    rng = np.random.default_rng(1)
    sound = rng.normal(0.0, 0.1, 8 * SAMPLE_RATE).astype(np.float32)
    size, whole = int(seconds * SAMPLE_RATE), int(max(seconds + later, 0.0) * SAMPLE_RATE)
    drafts = Drafts()
    drafts.keep(sound[:size], pieces)
    if lost:
        drafts.keep(sound[: size + 1], (1, 2, 3))
        drafts.lose()
    found = drafts.of((sound[::-1] if other else sound)[:whole])
    goes_on = (
        size != whole >= size - UNSETTLED
        and size > UNSETTLED
        and whole >= min(size - UNSETTLED, int(0.3 * SAMPLE_RATE))
    )
    assert found == (pieces if goes_on and not other and len(pieces) >= LEAST else ())


class Follows(Says):
    """A recogniser that listens along, and takes its time for it."""

    def __init__(self, *texts: str, seconds: float = 0.05, along: str = "go forward") -> None:
        super().__init__(*texts)
        self.seconds = seconds
        self.along = along
        self.followed: list[float] = []
        """s of each sound."""
        self.lost = 0

    def follow(self, samples: np.ndarray) -> Transcript:
        self.followed.append(samples.size / SAMPLE_RATE)
        return Transcript(self.along, free_text=self.along, decode_seconds=self.seconds, draft=True)

    def lose(self) -> None:
        self.lost += 1


@pytest.fixture
def two_cores(monkeypatch):
    monkeypatch.setattr(utterance_decoder, "cores", lambda: 2)


SPEECH = np.zeros(6 * SAMPLE_RATE, np.float32)
WORDS = "go forward two meters"


def test_it_is_listened_along_while_somebody_speaks(listen, two_cores):
    recognizer = Follows(WORDS)
    found = listen(SPEECH, recognizer, voice=Voiced((1.0, 3.0)), noise_filter=None)
    along = [event for event in found.of(HeardKind.PARTIAL) if event.speech_ended is None]
    assert len(recognizer.followed) == len(along) == 5
    assert {event.transcript.text for event in along} == {"go forward"}
    assert all(event.interpretation is None for event in along)
    assert all(1.0 < event.time < 3.1 for event in along)
    assert found.texts == [WORDS]
    assert found.moved == pytest.approx(2.0)


def test_but_less_often_where_it_takes_long(listen, two_cores):
    """A third of a core at most."""
    recognizer = Follows(WORDS, seconds=0.3)
    listen(SPEECH, recognizer, voice=Voiced((1.0, 3.0)), noise_filter=None)
    assert len(recognizer.followed) == 2


@pytest.mark.parametrize(
    ("along", "times"),
    [
        ("It was a dark and", 2),
        ("Emma Woodhouse, handsome", 2),
        ("go", 5),
        ("go to the kit", 5),  # the last word may be half a word
        ("Please go to the", 5),
        ("wait", 5),
        ("", 5),
    ],
)
def test_nor_where_what_is_said_begins_no_command(listen, two_cores, along, times):
    recognizer = Follows(WORDS, along=along)
    found = listen(SPEECH, recognizer, voice=Voiced((1.0, 3.0)), noise_filter=None)
    assert len(recognizer.followed) == times
    assert found.texts == [WORDS], "what was said in the end is understood as ever"
    assert found.moved == pytest.approx(2.0)


def test_and_not_on_one_core_nor_without_looking_ahead(listen, monkeypatch):
    monkeypatch.setattr(utterance_decoder, "cores", lambda: 1)
    one_core = Follows(WORDS)
    listen(SPEECH, one_core, voice=Voiced((1.0, 3.0)), noise_filter=None)
    monkeypatch.setattr(utterance_decoder, "cores", lambda: 2)
    never = Follows(WORDS)
    listen(SPEECH, never, voice=Voiced((1.0, 3.0)), noise_filter=None, speculate=False)
    assert one_core.followed == never.followed == []


def test_what_would_not_have_been_heard_in_time_is_lost_and_told_as_later(listen, two_cores):
    """On a virtual clock, on which it takes no time."""
    quick, slow = Follows(WORDS), Follows(WORDS, seconds=0.9)
    done = []
    for recognizer in (quick, slow):
        found = listen(SPEECH, recognizer, voice=Voiced((1.0, 2.0)), noise_filter=None)
        done.append(found.of(HeardKind.TRANSCRIPT)[0].transcript.decode_seconds)
    assert (quick.lost, slow.lost) == (0, 1)
    assert done[1] - done[0] == pytest.approx(utterance_decoder.GIVES_WAY)


class Held:
    """A recogniser that listens along until it is left."""

    def __init__(self) -> None:
        self.began, self.let_go = threading.Event(), threading.Event()
        self.at_once = 0

    def follow(self, samples: np.ndarray) -> Transcript:
        self.at_once += 1
        self.began.set()
        assert self.let_go.wait(LONG)
        self.at_once -= 1
        raise LeftError

    def lose(self) -> None: ...

    def leave(self) -> None:
        self.let_go.set()

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        assert self.at_once == 0, "two decodes would share one model"
        return Transcript("turn left", free_text="turn left", gap=0.0)

    def close(self) -> None: ...


def test_it_gives_way_to_a_decode_and_is_never_beside_it():
    recognizer = Held()
    decodes = DecodeThread(recognizer, patience=LONG)
    along = decodes.listen_along(SPEECH)
    assert along is not None
    assert recognizer.began.wait(LONG)
    assert decodes.free
    assert decodes.listen_along(SPEECH) is None, "one at a time"
    assert decodes.begin(SPEECH, final=True).result(LONG).text == "turn left"
    assert isinstance(along.exception(LONG), LeftError)
