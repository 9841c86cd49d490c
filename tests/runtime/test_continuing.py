"""What is said right after a command belongs to it, or does not."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from continuing_stage import ENGINE, Frames, Said, SaidInParts, Script, Voiced, framed
from hypothesis import given
from hypothesis import strategies as st
from speech_stage import ROOT

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.cli.reporter import Reporter
from intent_engine.execution.goal import GoalState
from intent_engine.runtime import Heard, HeardKind
from intent_engine.runtime.continuing import ONE_SENTENCE
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.endpoint import Settings
from intent_engine.speech.recognizer import Transcript

SOON = Settings().wait_continued
APART = Settings(wait_continued=0.0)
ORDERS = IntentEngine.from_files(ROOT / "examples" / "coffee" / "coffee.yaml")


def test_an_angle_that_comes_later_is_turned_as_a_whole():
    said = Said(Script("turn left", "ninety degrees", "Turn left. 90 degrees."))
    assert said.pose.yaw == pytest.approx(math.pi / 2)
    assert [event.goes_on for event in said.done] == [False, True]
    assert said.goals == [GoalState.CANCELED, GoalState.SUCCEEDED]


@given(pause=st.floats(0.3, SOON - 0.1), meters=st.integers(1, 5))
def test_a_distance_that_comes_later_is_driven_as_a_whole(pause, meters):
    said = Said(Script("go forward", f"{meters} meters", f"go forward {meters} meters"), pause)
    assert said.pose.x == pytest.approx(meters)


@pytest.mark.parametrize("begun", ["drive backwards", "please drive back", "go backward"])
def test_it_may_begin_in_other_words_that_mean_the_same(begun):
    """As the recogniser writes them where it hears both together."""
    said = Said(Script("drive back", "two meters", f"{begun} two meters"))
    assert said.pose.x == pytest.approx(-2.0)
    assert said.done[-1].goes_on
    assert said.done[-1].interpretation.text == "drive back two meters", "as whoever carries it out knows its beginning"


@pytest.mark.parametrize(
    ("first", "second", "driven"),
    [
        ("learn left", "and go forward two meters", 0.0),
        ("learn left", "and then go forward two meters", 0.0),
        ("learn left", "go forward two meters", 2.0),
        ("turn left", "and go forward two meters", 2.0),
        ("", "and go forward two meters", 2.0),
    ],
)
def test_what_goes_on_from_nothing_that_was_understood_is_not_done(first, second, driven):
    """Who turns first goes elsewhere."""
    said = Said(Script(first, second, f"{first}, {second}"))
    assert math.hypot(said.pose.x, said.pose.y) == pytest.approx(driven)


def test_but_a_stop_is():
    said = Said(Script("learn left", "and stop", "learn left, and stop"))
    assert [event.interpretation.stops for event in said.done] == [True]


def test_and_so_is_what_follows_later():
    said = Said(Script("learn left", "and go forward two meters", ""), pause=SOON + 0.3)
    assert said.pose.x == pytest.approx(2.0)


def test_where_a_thing_is_to_lie_may_be_said_to_its_end_while_the_hand_is_on_its_way():
    said = Said(Script("put the cup on the tool", "box", "put the cup on the tool box"), pause=0.3)
    assert [event.goals[0].action.location for event in said.done] == ["tool", "tool box"]
    assert said.goals[0] is GoalState.CANCELED


VOLUME = """
language: en
intents:
  down:
    action: {type: custom, name: order_drink}
    sentences: ["(too loud;turn it down)", "[that's] too loud", "turn [it] down"]
  up:
    action: {type: custom, name: order_drink, up: true}
    sentences: [turn it up]
"""


@pytest.mark.parametrize(
    ("first", "second", "orders"),
    [
        ("too loud", "turn it down", 1),
        ("turn it down", "too loud", 1),
        ("that's too loud", "turn it down", 2),
        ("too loud", "turn down", 2),
        ("too loud", "too loud", 2),
        ("turn it down", "turn it down", 2),
        ("too loud", "turn it up", 2),
    ],
)
def test_what_is_one_sentence_of_the_grammar_is_done_once(engine_of, first, second, orders):
    """An order cannot be put right, but it need not be given twice."""
    said = Said(Script(first, second, f"{first}, {second}"), engine=engine_of(VOLUME))
    assert len(said.orders) == orders
    assert [event.goes_on for event in said.done] == [False, orders == 1]


def test_also_where_its_beginning_was_taken_for_another_that_means_the_same(engine_of):
    """ "It's too loud" by itself is no sentence, and "that's too loud" is."""
    engine = engine_of(VOLUME.replace("(too loud;turn it down)", "it's too loud turn it down"))

    class Steered(Script):
        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            heard = super().transcribe(samples, final=final)
            return replace(heard, text=heard.text.replace("it's", "that's"))

    said = Said(Steered("it's too loud", "turn it down", "it's too loud, turn it down"), engine=engine)
    assert len(said.orders) == 1


def test_unless_it_is_said_later(engine_of):
    said = Said(Script("too loud", "turn it down", ""), pause=ONE_SENTENCE + 0.1, engine=engine_of(VOLUME))
    assert len(said.orders) == 2


@pytest.mark.parametrize("begun", ["turn right", "don't turn left", "learn left"])
def test_but_in_no_others(begun):
    """The robot acts on what it heard first."""
    said = Said(Script("turn left", "ninety degrees", f"{begun} ninety degrees"))
    assert said.goals == [GoalState.SUCCEEDED]
    assert 0.0 < said.pose.yaw < 1.0


def test_what_was_not_heard_as_a_command_by_itself_may_belong_to_the_one_before():
    """ "One meter" is like "go one meter", and would drive forward after "go back"."""
    script = Script("go back", "go one meter", "go back one meter", confidence=0.8)
    said = Said(script)
    assert said.pose.x == pytest.approx(-1.0)
    far = "go forward ten meters"
    two = Said(Script(far, "turn left", f"{far} turn left", confidence=0.8))
    assert two.goals == [GoalState.CANCELED, GoalState.SUCCEEDED], "what is a command by itself takes its place"
    then = Said(Script("turn left", "and then go one meter", "turn left and then go one meter", confidence=0.8))
    assert then.goals == [GoalState.SUCCEEDED, GoalState.SUCCEEDED], "or waits its turn"
    alone = Said(Script(far, "turn left", "what a nice day", confidence=0.8))
    assert alone.goals == [GoalState.CANCELED, GoalState.SUCCEEDED]


def test_an_um_between_two_parts_of_a_command_is_nothing():
    said = SaidInParts("turn left", "um", "turn left um", "ninety degrees", "turn left um ninety degrees")
    assert said.pose.yaw == pytest.approx(math.pi / 2)


def test_talk_between_them_ends_it():
    talk = "what a very nice day"
    said = SaidInParts("turn left", talk, f"turn left {talk}", "ninety degrees", begins=(0.5, 1.5, 3.4))
    assert said.goals == [GoalState.SUCCEEDED]


def test_no_wait_stops_and_what_was_meant_may_follow():
    said = SaidInParts("go to the kitchen", "no, wait", "the bedroom", "go to the kitchen no, wait, the bedroom")
    assert said.goals == [GoalState.CANCELED, GoalState.SUCCEEDED]
    assert (said.pose.x, said.pose.y) == pytest.approx((2.0, 8.0), abs=0.1)


def test_a_stop_with_a_no_before_it_is_final():
    said = SaidInParts("go to the kitchen", "no, stop", "the bedroom", "go to the kitchen no, stop, the bedroom")
    assert said.goals == [GoalState.CANCELED]


class Jumpy:
    """A reflex that takes the first sound of the second utterance for a stop."""

    def __init__(self) -> None:
        self.begun = 0

    def begin(self, _frames: object) -> None:
        self.begun += 1

    def heard(self, _samples: np.ndarray) -> bool:
        return self.begun == 2

    def close(self) -> None: ...


def test_a_robot_that_was_held_for_nothing_goes_on_with_all_that_was_said():
    said = Said(Script("turn left", "six degrees", "turn left six degrees"), reflex=Jumpy())
    assert [event.kind for event in said.events if event.kind is HeardKind.HOLD]
    assert said.pose.yaw == pytest.approx(math.radians(6), abs=0.3)
    assert said.done[-1].goes_on
    stopped = Said(Script("go forward ten meters", "stop", "go forward ten meters slowly"), reflex=Jumpy())
    assert stopped.goals == [GoalState.CANCELED]
    assert stopped.pose.x < 1.5
    hardly = Said(Script("go forward ten meters", "top", "go forward ten meters slowly", score=-2.0), reflex=Jumpy())
    assert hardly.pose.x < 1.5, "a stop that was felt, of which hardly anything was heard, is one"


def test_a_number_that_sounds_like_another_must_be_heard_with_the_command():
    said = Said(Script("turn left", "ninety degrees", "turn left I did a breeze"))
    assert [event.interpretation.text for event in said.done] == ["turn left"]


LONG_AFTER = SOON + 1.0
FAR = "go forward five meters"


@given(
    st.sampled_from(sorted(" ".join(words) for words in ENGINE.grammar.operators.later)), st.sampled_from(["", ", "])
)
def test_what_is_said_to_come_later_waits_however_long_ago_the_command_was_said(words, pause):
    said = Said(Script(FAR, f"{words}{pause} turn left", "-"), LONG_AFTER)
    assert said.goals == [GoalState.SUCCEEDED, GoalState.SUCCEEDED]
    assert said.pose.x == pytest.approx(5.0), "it was driven to its end first"
    assert said.done[-1].in_turn


@pytest.mark.parametrize(
    "second", ["turn left", "and turn left", "okay then turn left", "now turn left", "also turn left"]
)
def test_other_commands_take_its_place_then(second):
    said = Said(Script(FAR, second, "-"), LONG_AFTER)
    assert said.goals == [GoalState.CANCELED, GoalState.SUCCEEDED]


def test_where_nothing_is_being_done_it_begins_at_once():
    said = Said(Script("go forward half a meter", "when you are done, turn left", "-"), LONG_AFTER)
    assert said.goals == [GoalState.SUCCEEDED, GoalState.SUCCEEDED]
    assert not said.done[-1].in_turn


def test_a_stop_never_waits():
    said = Said(Script(FAR, "then stop", "-"), LONG_AFTER)
    assert said.goals == [GoalState.CANCELED]


def test_what_comes_after_it_waits_its_turn():
    said = Said(Script("turn left", "and then go forward one meter", "-"))
    assert said.goals == [GoalState.SUCCEEDED, GoalState.SUCCEEDED]
    assert math.hypot(said.pose.x, said.pose.y) == pytest.approx(1.0)
    more = Said(Script("go forward one meter", "and left", "go forward one meter and turn left"))
    assert more.goals == [GoalState.SUCCEEDED, GoalState.SUCCEEDED], "the first is not begun again"
    assert more.pose.x == pytest.approx(1.0)
    assert more.pose.yaw > 0.5


def test_what_is_said_in_one_breath_is_done_in_a_row():
    said = Said(Script("turn left", "go forward one meter", "-"), pause=0.3)
    assert said.goals == [GoalState.SUCCEEDED, GoalState.SUCCEEDED]
    assert (math.hypot(said.pose.x, said.pose.y), said.pose.yaw) == pytest.approx((1.0, 0.75))


def test_a_command_by_itself_is_one_and_is_not_heard_again():
    script = Script("turn left", "go forward one meter", "turn left go forward one meter")
    said = Said(script)
    assert "together" not in script.asked
    assert said.goals == [GoalState.CANCELED, GoalState.SUCCEEDED]


def test_a_stop_is_a_stop():
    said = Said(Script("go forward ten meters", "no stop", "go forward ten meters no stop"))
    assert said.pose.x < 1.0
    assert said.goals == [GoalState.CANCELED]


@given(
    stop=st.sampled_from(["stop", "Stop.", "robot stop", "stop stop", "no, stop"]),
    rest=st.sampled_from(["moving", "going", "turning", "rotating", "spinning", "pivoting"]).flatmap(
        lambda verb: st.sampled_from([f"{verb} {way}" for way in ("", "forward", "back", "left", "clockwise")])
    ),
    pause=st.floats(0.3, 1.2),
)
def test_a_stop_that_is_done_before_its_sentence_is_over_stays_one(stop, rest, pause):
    """ "Going forward" and "turning left" alone are commands of the grammar."""
    said = Said(Script(stop, rest, "-"), pause)
    whole = ENGINE.parse(f"stop {rest}")
    if whole.stops:
        assert all(event.interpretation.stops for event in said.done)
        assert (said.pose.x, said.pose.yaw) == (0.0, 0.0)


@pytest.mark.parametrize(
    ("rest", "pause"), [("go back one meter", 0.6), ("back one meter", 0.6), ("going back one meter", SOON + 0.3)]
)
def test_what_is_no_part_of_a_stop_is_done_after_it(rest, pause):
    said = Said(Script("stop", rest, "-"), pause)
    assert said.pose.x == pytest.approx(-1.0)


@pytest.mark.parametrize(
    "script",
    [
        Script("turn left", "what a nice day", "turn left what a nice day"),
        Script("turn left", "ninety degrees", "turn right ninety degrees"),
        Script("turn left", "ninety degrees", "don't turn left ninety degrees"),
        Script("turn left", "", "turn left ninety degrees"),
        Script("turn left", "um", "turn left"),
    ],
    ids=["talk", "the first is another then", "forbidden then", "nothing", "nothing new"],
)
def test_what_is_no_command_together_changes_nothing(script):
    said = Said(script)
    assert len(said.done) == 1
    assert said.goals == [GoalState.SUCCEEDED]
    assert said.pose.yaw == pytest.approx(0.75)


@pytest.mark.parametrize(
    ("script", "key", "told"),
    [
        (Script("turn left", "ninety degrees", "turn left ninety degrees"), "goes_on", "goes on     turn side=left"),
        (Script("turn left", "and then go forward one meter", "-"), "in_turn", "next        move direction=forward"),
    ],
)
def test_it_is_told_that_a_command_goes_on_or_waits_its_turn(capsys, script, key, told):
    said = Said(script)
    for as_json in (True, False):
        reporter = Reporter(said.robot, as_json=as_json)
        for event in said.events:
            reporter.heard(event)
    lines = capsys.readouterr().out.splitlines()
    events = [json.loads(line) for line in lines if line.startswith("{")]
    assert [event.get(key) for event in events if event["event"] == "interpretation"] == [None, True]
    text = "\n".join(lines)
    assert "understood  turn side=left\n" in text
    assert told in text


def test_later_words_belong_to_nothing():
    script = Script("turn left", "ninety degrees", "turn left ninety degrees")
    said = Said(script, SOON + 0.3)
    assert "together" not in script.asked
    assert said.pose.yaw == pytest.approx(0.75)


def test_nothing_goes_on_over_a_gap_in_the_sound():
    """A "don't" may be what is missing."""
    script = Script("turn left", "ninety degrees", "turn left ninety degrees")

    class Unreset(Voiced):
        def reset(self) -> None: ...

    said = Said(script, lost=0.1, voice=Unreset((0.5, 0.9), (1.5, 2.4)))
    assert "together" not in script.asked
    assert said.pose.yaw == pytest.approx(0.75)


def test_what_cannot_be_taken_back_is_not_gone_on_with():
    script = Script("get me a latte", "with soy milk", "get me a latte with soy milk")
    said = Said(script, engine=ORDERS)
    assert said.orders == [{"coffeeDrink": "latte"}]
    refused = next(event for event in reversed(said.events) if event.interpretation is not None)
    assert "'get me a latte', which is being done and cannot be changed" in refused.interpretation.reason


def test_it_can_be_switched_off():
    script = Script("turn left", "ninety degrees", "turn left ninety degrees")
    said = Said(script, settings=APART)
    assert "together" not in script.asked
    assert said.pose.yaw == pytest.approx(0.75)


@pytest.mark.parametrize("joined", [True, False])
def test_it_can_be_switched_off_while_it_listens(joined):
    """By who learns that nobody could put right what was begun."""
    script = Script("turn left", "ninety degrees", "turn left ninety degrees")
    said = Said(script, joined=joined)
    assert ("together" in script.asked) is joined
    assert said.pose.yaw == pytest.approx(math.pi / 2 if joined else 0.75)


def test_a_motion_is_begun_the_sooner_for_it():
    script = ("turn left", "what", "what")
    soon, apart, late = (
        Said(Script(*script), **how).done[0].time for how in ({}, {"settings": APART}, {"joined": False})
    )
    assert apart - soon >= 0.1
    assert late == apart


def test_it_goes_on_while_it_is_decoded_in_a_thread_beside():
    """In real time: nothing of the sound waits for the recogniser."""
    from intent_engine.execution.clock import MonotonicClock

    script = Script("turn left", "ninety degrees", "turn left ninety degrees")
    events: list[Heard] = []
    robot = SimulatedRobot(MonotonicClock())
    with Executor(robot) as executor:
        voice = Voiced((0.5, 0.9), (1.5, 2.4))
        runtime = Runtime(ENGINE, executor, script, voice=voice, noise_filter=None, on_event=events.append)
        runtime.run(Frames(framed(np.zeros(5 * SAMPLE_RATE, np.float32))))
    done = [event for event in events if event.kind is HeardKind.SUBMITTED]
    assert [event.goes_on for event in done] == [False, True]


@pytest.mark.parametrize("second", ["stop", "no, wait", "no"])
def test_it_stands_before_anybody_is_told_what_was_said(second):
    """Who is told may take its time."""
    standing = []

    class Watched(Said):
        def _heard(self, event: Heard, runtime: Runtime, joined: bool) -> None:
            super()._heard(event, runtime, joined)
            if event.kind in (HeardKind.TRANSCRIPT, HeardKind.SUBMITTED):
                standing.append((event.kind, runtime.executor.snapshot().velocity == (0.0, 0.0)))

    Watched(Script("go forward ten meters", second, f"go forward ten meters {second}"))
    told = [stands for kind, stands in standing if kind is HeardKind.TRANSCRIPT]
    assert told == [True, True], "before it moved, and at the stop"


@pytest.mark.parametrize(
    ("second", "pause", "done"),
    [
        ("go forward", 0.8, False),
        ("go forward", 0.3, True),
        ("and then go forward", 0.8, True),
        ("ninety degrees", 0.8, True),
        ("no right", 0.8, True),
    ],
)
def test_another_command_needs_the_wake_word_again(second, pause, done):
    """What is said to somebody else, right after a command, is none for the robot; what goes on from that is."""
    engine = IntentEngine.from_files(ROOT / "grammars" / "en.yaml", wake=["robot"])
    script = Script("robot turn left", second, f"robot, turn left, {second}")
    said = Said(script, pause, engine)
    assert len(said.done) == 1 + done
    if not done:
        assert said.pose.x == 0.0
        assert said.goals == [GoalState.SUCCEEDED]
