"""When it is said, in virtual time: probabilities in, signals out."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.audio import FRAME_SECONDS
from intent_engine.speech.endpoint import Endpointer, Outlook, Settings, Signal

SPEECH, SILENCE = 0.9, 0.05
WAITS = {
    Outlook.COMPLETE: 0.064,
    Outlook.SETTLED: 0.128,
    Outlook.AMENDABLE: 0.2,
    Outlook.EXTENDABLE: 0.35,
    Outlook.DOUBTFUL: 0.45,
    Outlook.INCOMPLETE: 0.7,
    Outlook.CALLED: 0.7,
    Outlook.OTHER: 0.5,
    Outlook.UNKNOWN: 0.5,
}


def frames(seconds: float) -> int:
    return round(seconds / FRAME_SECONDS)


def play(endpoint: Endpointer, *parts: tuple[float, float]) -> list[Signal]:
    """Signals other than none, for (probability, seconds)."""
    signals = [endpoint.frame(probability) for probability, seconds in parts for _ in range(frames(seconds))]
    return [signal for signal in signals if signal is not Signal.NONE]


def test_silence_is_nothing():
    assert play(Endpointer(), (SILENCE, 3600.0)) == []


def test_an_utterance():
    endpoint = Endpointer()
    assert play(endpoint, (SILENCE, 1.0), (SPEECH, 1.0)) == [Signal.STARTED]
    assert endpoint.speaking
    assert play(endpoint, (SILENCE, 1.0)) == [Signal.PAUSED, Signal.ENDED]
    assert not endpoint.speaking


def silence_until_the_end(outlook: Outlook, asked: float | None = None) -> float:
    """s of silence that end an utterance with this outlook."""
    endpoint = Endpointer()
    play(endpoint, (SPEECH, 1.0))
    assert endpoint.frame(SILENCE) is Signal.PAUSED
    endpoint.judge(outlook, asked)
    silent = 1
    while endpoint.frame(SILENCE) is not Signal.ENDED:
        silent += 1
        assert silent < 200
    return (silent + 1) * FRAME_SECONDS


def as_frames(seconds: float) -> object:
    return pytest.approx(seconds, abs=FRAME_SECONDS / 2 + 1e-9)


@pytest.mark.parametrize("outlook", WAITS)
def test_how_long_it_waits_is_what_the_grammar_thinks(outlook):
    assert silence_until_the_end(outlook) == as_frames(WAITS[outlook])


@given(st.sampled_from(list(Outlook)), st.floats(0.1, 5.0))
def test_an_intent_says_how_long_it_waits_only_where_it_could_go_on(outlook, asked):
    changed = {Outlook.AMENDABLE: asked, Outlook.EXTENDABLE: asked, Outlook.DOUBTFUL: asked + 0.1}
    assert silence_until_the_end(outlook, asked) == as_frames(changed.get(outlook, WAITS[outlook]))


def test_what_one_intent_asked_for_is_not_for_the_next():
    endpoint = Endpointer()
    play(endpoint, (SPEECH, 1.0), (SILENCE, FRAME_SECONDS))
    endpoint.judge(Outlook.EXTENDABLE, 3.0)
    assert play(endpoint, (SILENCE, 1.0), (SPEECH, 0.5)) == [Signal.RESUMED]
    assert play(endpoint, (SILENCE, 0.1)) == [Signal.PAUSED]
    endpoint.judge(Outlook.EXTENDABLE)
    assert play(endpoint, (SILENCE, 0.3)) == [Signal.ENDED]


def test_every_wait_can_be_set():
    assert set(WAITS) == set(Outlook)
    waits = {f"wait_{outlook}": float(number) for number, outlook in enumerate(Outlook, start=1)}
    settings = Settings(**waits)
    assert sorted(settings.wait(outlook) for outlook in Outlook) == sorted(waits.values())


def test_who_goes_on_is_not_cut_off():
    endpoint = Endpointer()
    play(endpoint, (SPEECH, 1.0), (SILENCE, 0.1))
    endpoint.judge(Outlook.INCOMPLETE)
    assert play(endpoint, (SILENCE, 0.4), (SPEECH, 0.5)) == [Signal.RESUMED]
    assert play(endpoint, (SILENCE, 0.3)) == [Signal.PAUSED], "what the grammar thought is out of date: unknown again"
    assert play(endpoint, (SILENCE, 0.3)) == [Signal.ENDED]


def test_a_knock_is_no_speech():
    assert play(Endpointer(), (SPEECH, FRAME_SECONDS), (SILENCE, 1.0)) == []


def test_what_is_hardly_longer_than_a_knock_is_told_apart():
    ends = [Signal.STARTED, Signal.PAUSED, Signal.SHORT]
    for frames_, end in ((2, Signal.SHORT), (3, Signal.SHORT), (4, Signal.ENDED)):
        assert play(Endpointer(), (SPEECH, frames_ * FRAME_SECONDS), (SILENCE, 1.0)) == [*ends[:2], end]


def test_who_says_more_after_a_knock_has_said_more():
    signals = play(Endpointer(), (SPEECH, 2 * FRAME_SECONDS), (SILENCE, 0.1), (SPEECH, 0.1), (SILENCE, 1.0))
    assert signals == [Signal.STARTED, Signal.PAUSED, Signal.RESUMED, Signal.PAUSED, Signal.ENDED]


def test_between_the_thresholds_speech_goes_on_but_does_not_begin():
    endpoint = Endpointer()
    assert play(endpoint, (0.4, 5.0)) == []
    assert play(endpoint, (SPEECH, 0.5), (0.4, 2.0)) == [Signal.STARTED, Signal.FADING]
    assert endpoint.speaking
    assert endpoint.silence == 0
    assert play(endpoint, (SILENCE, 0.1), (0.4, 0.1)) == [Signal.PAUSED], "nor does it begin again"


def test_an_endless_talker_is_ended():
    endpoint = Endpointer()
    assert play(endpoint, (SPEECH, 19.5)) == [Signal.STARTED]
    assert play(endpoint, (SPEECH, 1.0)) == [Signal.CUT, Signal.STARTED], "and heard on"


def test_reset_forgets():
    endpoint = Endpointer()
    play(endpoint, (SPEECH, 1.0))
    endpoint.reset()
    assert play(endpoint, (SILENCE, 2.0)) == []


@given(st.lists(st.floats(0, 1), max_size=400), st.lists(st.sampled_from(list(Outlook)), min_size=1, max_size=5))
def test_signals_come_in_an_order_that_makes_sense(probabilities, outlooks):
    """started, then paused and resumed by turns, then ended; and never two utterances at once."""
    endpoint = Endpointer(replace(Settings(), max_speech=4.0))
    allowed = {
        None: {Signal.STARTED},
        Signal.STARTED: {Signal.FADING, Signal.PAUSED, Signal.ENDED},
        Signal.FADING: {Signal.RESUMED, Signal.PAUSED, Signal.ENDED},
        Signal.PAUSED: {Signal.RESUMED, Signal.SHORT, Signal.ENDED},
        Signal.RESUMED: {Signal.FADING, Signal.PAUSED, Signal.ENDED},
    }
    last: Signal | None = None
    for count, probability in enumerate(probabilities):
        signal = endpoint.frame(probability)
        if signal is Signal.NONE:
            continue
        assert signal in allowed[last]
        if signal is Signal.PAUSED:
            endpoint.judge(outlooks[count % len(outlooks)])
        last = None if signal in (Signal.ENDED, Signal.SHORT) else signal
        assert endpoint.speaking is (last is not None)


@given(st.lists(st.floats(0, 1), max_size=200))
def test_two_seconds_of_silence_end_everything(probabilities):
    endpoint = Endpointer()
    for probability in probabilities:
        endpoint.frame(probability)
    for _ in range(frames(2.0)):
        endpoint.frame(0.0)
    assert not endpoint.speaking


# -- a voice that fades ------------------------------------------------------------------------------------------------


def test_a_voice_that_fades_is_told_once_before_it_is_silent():
    endpoint = Endpointer()
    assert play(endpoint, (SPEECH, 0.5), (0.5, 0.1)) == [Signal.STARTED, Signal.FADING]
    assert endpoint.silence == 0
    assert not endpoint.faded_long
    assert play(endpoint, (SILENCE, 0.1)) == [Signal.PAUSED]
    assert endpoint.faded_long


def test_a_voice_that_comes_back_has_spoken_on():
    endpoint = Endpointer()
    play(endpoint, (SPEECH, 0.5), (0.5, 0.1))
    endpoint.judge(Outlook.COMPLETE)
    assert play(endpoint, (SPEECH, 0.2)) == [Signal.RESUMED]
    assert not endpoint.faded_long
    assert play(endpoint, (SILENCE, 0.3)) == [Signal.PAUSED], "what the grammar thought is out of date"


@given(st.lists(st.floats(0, 1), max_size=400), st.sampled_from(list(Outlook)))
def test_nothing_begins_pauses_or_ends_otherwise_because_a_voice_fades(probabilities, outlook):
    def signals(fading: float) -> list[Signal]:
        endpoint = Endpointer(Settings(fading=fading, max_speech=4.0))
        found = []
        for probability in probabilities:
            found.append(endpoint.frame(probability))
            if endpoint.silence:
                endpoint.judge(outlook)
        return [Signal.NONE if one in (Signal.FADING, Signal.RESUMED) else one for one in found]

    assert signals(0.6) == signals(0.0)


@pytest.mark.parametrize(
    ("low", "outlook", "over"),
    [
        (0.45, Outlook.COMPLETE, True),
        (0.5, Outlook.COMPLETE, False),
        (0.45, Outlook.SETTLED, False),
        (0.45, Outlook.AMENDABLE, False),
        (0.45, Outlook.UNKNOWN, False),
    ],
)
def test_a_low_voice_ends_what_nothing_can_change(low, outlook, over):
    endpoint = Endpointer()
    play(endpoint, (SPEECH, 1.0))
    assert endpoint.frame(0.55) is Signal.FADING
    endpoint.judge(outlook)
    signals = play(endpoint, (low, 0.32))
    assert signals == ([Signal.ENDED] if over else [])


@given(st.floats(0.0, 0.49), st.integers(2, 6))
def test_what_was_judged_since_the_last_frame_may_be_over_at_once(probability, frames_):
    endpoint = Endpointer()
    play(endpoint, (SPEECH, 1.0))
    for _ in range(frames_):
        assert endpoint.frame(probability) is not Signal.ENDED
    assert endpoint.due() is Signal.NONE, "nobody knows yet what was said"
    endpoint.judge(Outlook.COMPLETE)
    assert endpoint.due() is Signal.ENDED
    assert not endpoint.speaking
    assert endpoint.due() is Signal.NONE
