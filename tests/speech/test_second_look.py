"""Two models in a robot: what is in doubt is heard again when it is over."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from two_models import FORWARD, LEFT, LIKELY, UNSURE, Thinks, heard, two

from intent_engine.runtime.heard import HeardKind
from intent_engine.runtime.runtime import SECOND_LOOK
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript


def test_a_doubtful_command_is_searched_for_when_it_is_over_and_done(engine, listen, go_forward):
    both, one, other = two(engine, UNSURE, UNSURE)
    one.found = other.found = Thinks(heard(FORWARD, 0.5), {FORWARD: LIKELY})
    found = listen(go_forward, both)
    assert (len(one.listened), len(other.listened), one.searched, other.searched) == (1, 1, 1, 1)
    assert found.robot.pose().x == pytest.approx(2.0)
    (transcript,) = (event.transcript for event in found.of(HeardKind.TRANSCRIPT))
    assert transcript.confidence > 0.7
    drafts = [event.transcript.draft for event in found.of(HeardKind.PARTIAL)]
    assert drafts == [True, True], "at a glance and in silence; what it became is no partial: the command was over"


def test_a_command_that_was_heard_well_is_done_at_once(engine, listen, go_forward):
    both, *_ = two(engine, heard(FORWARD, 1.0), heard(LEFT, 1.0))
    found = listen(go_forward, both)
    assert found.robot.pose().x == pytest.approx(2.0)


def test_a_draft_is_not_done_however_sure_it_is(engine, listen, go_forward):
    mumbled = Thinks(replace(heard(FORWARD, 0.9), free_text="goat for words two me does"), {FORWARD: LIKELY})
    both, one, other = two(engine, mumbled, mumbled)
    one.found = other.found = Thinks(heard("don't go forward", None))
    found = listen(go_forward, both)
    assert found.goals == []


def test_two_that_differ_move_nothing(engine, listen, go_forward):
    both, *_ = two(engine, heard(FORWARD, 0.6), heard(LEFT, 0.6))
    found = listen(go_forward, both)
    assert found.goals == []
    (meaning,) = (event.interpretation for event in found.of(HeardKind.INTERPRETATION))
    assert meaning.actions == ()


class Stubborn:
    """A recogniser whose final word is a draft."""

    def __init__(self) -> None:
        self.asked: list[int] = []

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.asked.append(samples.size)
        return heard("nice weather", None, draft=True)

    def close(self) -> None:
        pass


def test_a_second_look_is_taken_in_the_silence_and_not_in_a_short_pause(listen, go_forward):
    """So that its answer is there when the wait is over. One whose final word is a draft is not asked for ever."""
    stubborn = Stubborn()
    found = listen(go_forward, stubborn)
    first, second = stubborn.asked
    assert 0 < second - first < (SECOND_LOOK + 0.1) * SAMPLE_RATE
    assert found.goals == []
