"""Wrong calls from Python are told as what they are, before a robot is without limits or a source is read."""

from __future__ import annotations

import numpy as np
import pytest

from intent_engine import Executor, IntentEngine, Interpretation, Runtime, SimulatedRobot, Status
from intent_engine.actions import Move
from intent_engine.errors import AudioError, ConfigError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.journal import Journal
from intent_engine.execution.limits import Limits
from intent_engine.language.locations import LocationMap, from_text, load
from intent_engine.speech.endpoint import Settings
from intent_engine.speech.sources.file import FileSource
from intent_engine.speech.sources.stream import StreamSource
from intent_engine.testing import sentences


@pytest.fixture
def executor():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as one:
        yield one


@pytest.mark.parametrize("limits", [{}, {"linear_velocity": 0.5}, "robots/turtlebot3.yaml", 0.5])
def test_what_are_no_limits_limits_nothing_and_is_refused(limits):
    clock = VirtualClock()
    with pytest.raises(TypeError, match=r"limits of a robot are Limits\(linear_velocity=0\.5\)"):
        Executor(SimulatedRobot(clock), limits, clock)
    robot = SimulatedRobot(clock)
    robot.limits = limits
    with pytest.raises(TypeError, match=r"limits of a robot are Limits\("):
        Executor(robot, clock=clock)


def test_limits_of_the_robot_hold_where_none_are_given():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    robot.limits = Limits(linear_velocity=0.2)
    with Executor(robot, clock=clock) as own, Executor(SimulatedRobot(clock), Limits(angle=1.0), clock) as given:
        assert own.limits is robot.limits
        assert given.limits == Limits(angle=1.0)


@pytest.mark.parametrize("value", ["0.5 m/s", True, [1.0]])
def test_a_limit_is_a_number(value):
    with pytest.raises(TypeError, match="the limit linear_velocity is a number in SI units, not"):
        Limits(linear_velocity=value)


def test_what_is_no_runtime(executor):
    engine = IntentEngine.from_files("en", locations="home")
    with pytest.raises(TypeError, match="takes an IntentEngine and then an Executor, not Executor and IntentEngine"):
        Runtime(executor, engine)
    with pytest.raises(TypeError, match=r"run takes a source of sound, not 'talk.wav': FileSource\(path\)"):
        Runtime(engine, executor, recognizer=object(), voice=object()).run("talk.wav")


@pytest.mark.parametrize("rate", ["16k", None, 16])
def test_a_rate_that_is_none(rate):
    with pytest.raises(AudioError, match="is no sample rate of sound"):
        StreamSource(rate)


def test_what_no_sentences_are_made_of():
    with pytest.raises(TypeError, match="sentences takes an IntentEngine, not 'en'"):
        sentences("en")
    engine = IntentEngine.from_files("en", locations="home")
    with pytest.raises(ValueError, match="there is no noise 'filler'; there is fillers, spelling"):
        sentences(engine, noise=["spelling", "filler"])


async def asks() -> set[str]:
    return set()


MOVE = Move(0.5, 1.0, 2.0)


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda one: one.cancel(one.submit(MOVE)), "cancel takes a goal, one of the list that submit returned, not"),
        (lambda one: one.cancel(None), "cancel takes a goal, as submit returns for each action, not None"),
        (lambda one: one.wait([MOVE]), "wait takes a goal, as submit returns"),
        (lambda one: one.submit(MOVE, amends=[MOVE]), "amends takes a goal"),
        (lambda one: one.submit(MOVE, "queue"), r"spoken_at is a time .* by its name: policy='queue'"),
        (lambda one: one.submit(MOVE, guards=lambda: ""), "guards are a list with one for each action"),
        (lambda one: one.submit(MOVE, policy="quee"), "policy is one of 'replace', 'queue', 'follow', 'refuse', not"),
        (lambda one: one.submit(MOVE, keep="way"), "keep is one of 'distance', 'duration', not 'way'"),
        (lambda one: one.submit(MOVE, text=5), "text is a text, not 5"),
        (
            lambda one: one.submit(MOVE, np.array([1, 2])),
            r"spoken_at is a time on .* in s, not array",
        ),
        (lambda one: one.submit(MOVE)[0].add_done_callback("print"), "add_done_callback takes a function .* 'print'"),
        (lambda one: one.clock.advance("1 s"), "a clock is moved by a number of s, not by '1 s'"),
        (lambda one: one.clock.advance_to(None), "a clock is moved by a number of s, not by None"),
        (lambda one: one.subscribe(None), "a listener is a function that takes an event, not None"),
        (lambda one: one.register("wave", lambda: None), "called as handler.action., or handler.action, context."),
    ],
)
def test_what_an_executor_cannot_take_is_told(executor, call, says):
    with pytest.raises((TypeError, ValueError), match=says):
        call(executor)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"hold_limit": None}, "hold_limit is a number of s, not None"),
        ({"hold_limit": float("nan")}, "hold_limit must be a number, not nan"),
        ({"expire_after": "5 s"}, "expire_after is a number of s, not '5 s'"),
        ({"queue_limit": True}, "queue_limit is a number of goals"),
        ({"journal": "log.jsonl"}, r"journal is Journal\(path\)"),
        ({"on_event": []}, "on_event is a function that takes an event"),
        ({"handlers": {"wave": "print"}}, "handlers takes a name and a function, not 'wave' and 'print'"),
        ({"handlers": [("wave", print)]}, "handlers are a dictionary by action"),
        ({"policies": "queue"}, "policies are a dictionary by action"),
        ({"policies": {"navigate": "quee"}}, "the policy of 'navigate' is one of 'replace'"),
        ({"rates": 20}, r"rates are Rates\(rate=20\.0\)"),
        ({"clock": VirtualClock}, r"a clock is MonotonicClock\(\) or VirtualClock\(\), not <class"),
        ({"loop": 20}, "loop is a Guardian"),
    ],
)
def test_what_no_executor_is_made_of_is_told(given, says):
    with pytest.raises((TypeError, ValueError), match=says):
        Executor(SimulatedRobot(), **given)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"recognizer": "tiny.en"}, r"recognizer is recognizer_for\(engine, 'base'\)"),
        ({"recognizer": lambda samples: "stop"}, "recognizer is recognizer_for"),
        ({"voice": True}, r"voice is SileroVoice\(\)"),
        ({"reflex": True}, r"reflex is reflex_for\(engine\)"),
        ({"noise_filter": "rnnoise"}, "noise_filter is 'auto', None or a noise filter, not 'rnnoise'"),
        ({"settings": {"wait_complete": 0.2}}, r"settings are Settings\("),
        ({"on_event": "print"}, "on_event is a function that takes an event, not 'print'"),
        ({"state": ["docked"]}, r"state is a function .* not \['docked'\]: lambda: \['docked'\]"),
        ({"state": asks}, "state is called, and not awaited, but is async"),
        ({"patience": "10 s"}, "patience is a number of s, not '10 s'"),
    ],
)
def test_what_no_runtime_is_made_of_is_told_before_anything_is_heard(executor, given, says):
    engine = IntentEngine.from_files("en", locations="home")
    with pytest.raises(TypeError, match=says):
        Runtime(engine, executor, **{"recognizer": object(), "voice": object(), **given})


def test_a_wake_word_is_a_list_of_one():
    engine = IntentEngine.from_files("en", locations="home", wake="robot")
    assert engine.grammar.wake[-1:] == (("robot",),)
    assert not engine.parse("t turn left", spoken=True).actions
    assert engine.parse("robot turn left", spoken=True).actions
    for wrong in ([5], {"robot": 1}, 5):
        with pytest.raises(TypeError, match=r"wake words are texts in a list, as \['robot'\]"):
            IntentEngine.from_files("en", wake=wrong)
    with pytest.raises(ConfigError, match=r"the wake word '!' has no letters"):
        IntentEngine.from_files("en", wake=["!"])


@pytest.mark.parametrize("state", [None, 5, {"moving": False}])
def test_states_are_names(state):
    engine = IntentEngine.from_files("en", locations="home")
    with pytest.raises(TypeError, match=r"states are names in a list or a set, as \['moving'\], not"):
        engine.parse("freeze, he said", state=state)


@pytest.mark.parametrize("places", ["home", {"kitchen": (5.0, 2.0)}])
def test_an_engine_of_grammars_takes_a_map_that_is_read(places):
    grammars = IntentEngine.from_files("en").grammars
    with pytest.raises(TypeError, match="IntentEngine takes a map that is read, not"):
        IntentEngine(grammars, places)
    read = LocationMap.from_mapping({"kitchen": (5.0, 2.0)})
    assert IntentEngine(grammars, read).parse("go to the kitchen").actions


@pytest.mark.parametrize("language", [5, ["en"], b"en"])
def test_a_language_is_a_tag(language):
    engine = IntentEngine.from_files("en", locations="home")
    for ask in (engine.parse, engine.prefix, engine.explain, engine.dictated, engine.comes_later, engine.takes_back):
        with pytest.raises(TypeError, match="a language is given by its tag, as 'en', not as"):
            ask("stop", language=language)


def test_guards_ask_for_the_states():
    engine = IntentEngine.from_files("en", locations="home")
    with pytest.raises(TypeError, match=r"guards takes a function that tells the states, not \['docked'\]: lambda"):
        engine.parse("turn left").guards(["docked"])


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"wait_complete": "1"}, "wait_complete is a number of s, not '1'"),
        ({"wait_other": -1.0}, "wait_other must not be below zero"),
        ({"max_speech": float("nan")}, "max_speech must be a number, not nan"),
        ({"onset": 50}, "onset is a probability, at most 1, not 50"),
        ({"onset_frames": None}, "onset_frames is a number of frames"),
        ({"onset_frames": 0}, "onset_frames is a whole number from 1 to 30, not 0"),
        ({"onset_frames": 2.5}, "onset_frames is a whole number from 1 to 30, not 2.5"),
        ({"onset_frames": float("inf")}, "onset_frames is a whole number from 1 to 30, not inf"),
        ({"pre_roll": float("inf")}, "pre_roll is at most 10 s, not inf"),
    ],
)
def test_what_no_endpoint_is_set_to(given, says):
    with pytest.raises((TypeError, ValueError), match=says):
        Settings(**given)


NOTHING = Interpretation("hello", Status.REJECTED).to_json()


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: VirtualClock("noon"), "a clock is moved by a number of s, not by 'noon'"),
        (lambda: VirtualClock(float("nan")), "a clock cannot be moved to nan"),
        (lambda: IntentEngine(None), "IntentEngine takes grammars that are read"),
        (lambda: Interpretation.from_json(None), "Interpretation.from_json takes what to_json gave, a dictionary"),
        (lambda: Interpretation.from_json({"text": "stop"}), "status, intent, .*, reason is missing"),
        (
            lambda: Interpretation.from_json(NOTHING | {"slots": 3}),
            "slots of an interpretation in JSON is an object, not 3",
        ),
        (lambda: Interpretation.from_json(NOTHING | {"actions": 3}), "actions of .* is a list, not 3"),
        (lambda: Interpretation.from_json(NOTHING | {"text": 3}), "text of .* is a text, not 3"),
        (
            lambda: Interpretation.from_json(NOTHING | {"alternatives": [3]}),
            r"alternatives of .* is a list of texts, not \[3\]",
        ),
        (lambda: Interpretation.from_json(NOTHING | {"confidence": "1"}), "confidence of .* is a number, not '1'"),
        (lambda: Interpretation.from_json(NOTHING | {"status": "done"}), "'done' is not a valid Status"),
        (lambda: IntentEngine.from_files("en").answer("go to bay", "yes"), "answer takes the interpretation that asks"),
        (lambda: Journal(None), "a journal is given by its path, not as None"),
        (lambda: FileSource(5), "a recording is given by its path, not as 5"),
        (lambda: load(b"home.yaml"), "a map is given by its path, not as b'home.yaml'"),
        (lambda: load([None]), "a map is given by its path, not as None"),
        (lambda: from_text(None), "a map is a text, not None"),
        (lambda: LocationMap.from_mapping([("kitchen", 5.0, 2.0)]), "places are a dictionary, as .'kitchen'"),
    ],
)
def test_what_nothing_is_made_of_is_told(call, says):
    with pytest.raises((TypeError, ValueError), match=says):
        call()
