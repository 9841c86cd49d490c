"""The engine from the outside: what it takes and what it does not."""

from __future__ import annotations

import copy
import pickle

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.execution.robots.robot import Pose
from intent_engine.language.slots.slot_values import NamesOf
from intent_engine.resources import find


@pytest.mark.parametrize("method", ["parse", "explain", "prefix", "dictated"])
@pytest.mark.parametrize(
    ("given", "kind"), [(None, "NoneType"), (5, "int"), (b"stop", "bytes"), (["stop"], "list")], ids=repr
)
def test_what_is_no_text_is_refused_by_its_type(engine, method, given, kind):
    with pytest.raises(TypeError, match=f"^{method} takes a str, not {kind}$"):
        getattr(engine, method)(given)


def test_places_are_listed_when_one_is_asked_for_and_not_while_the_files_load(root, monkeypatch):
    listed = []
    names = NamesOf.__iter__
    monkeypatch.setattr(NamesOf, "__iter__", lambda self: listed.append(self) or names(self))
    engine = IntentEngine.from_files(root / "grammars" / "en.yaml", locations=root / "locations" / "home.yaml")
    assert engine.parse("stop").stops
    assert not listed, "a map may have ten thousand places"
    assert engine.parse("go to the kitchen").actions
    assert listed


def test_names_of_shipped_files_are_found_as_the_command_line_finds_them(root, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    engine = IntentEngine.from_files("en", locations="home")
    assert engine.parse("go to the kitchen").actions
    assert all(path.is_file() for path in engine.files)
    assert IntentEngine.from_files(["en", "de"], locations=["home", "zuhause"]).languages == ("en", "de")
    (tmp_path / "grammars").mkdir()
    own = tmp_path / "grammars" / "en.yaml"
    own.write_text("language: en\nintents: {beep: {action: custom, sentences: [beep]}}\n", "utf-8")
    assert IntentEngine.from_files("en").parse("beep").actions, "a user's own copy wins"
    assert engine.parse("go to the kitchen").actions
    engine.reload()
    assert engine.parse("go to the kitchen").actions, "it reads again what it has read"


def test_all_names_that_are_missing_are_told_at_once_as_the_command_line_tells_them(root, tmp_path):
    broken = tmp_path / "broken.yaml"
    broken.write_text("language: en\nintents: 5\n", "utf-8")
    with pytest.raises(ConfigError) as told:
        IntentEngine.from_files(["nowhere", broken], locations="nohome")
    messages = [problem.message for problem in told.value.problems]
    assert messages[:2] == ["no file nowhere.yaml in grammars/", "no file nohome.yaml in locations/"]
    assert len(messages) > 2, "what is wrong in the others is told, too"
    with pytest.raises(ConfigError) as found:
        find("grammars", "nowhere")
    assert told.value.problems[0] == found.value.problems[0]
    with pytest.raises(ConfigError, match=r"^no file nowhere\.yaml in grammars/") as alone:
        IntentEngine.from_files("nowhere")
    assert len(alone.value.problems) == 1


def test_a_state_that_is_given_as_text_is_that_state(engine):
    moving = engine.parse("don't move forward", state=["moving"])
    assert moving.stops
    assert engine.parse("don't move forward", state="moving") == moving  # and not the states m, o, v, ...


def test_what_was_done_last_may_be_one_action(engine):
    (turned,) = engine.parse("turn left ninety degrees").actions
    assert engine.parse("again", last=turned).actions == (turned,)
    assert engine.parse("again", last=[turned]).actions == (turned,)


@pytest.mark.parametrize("text", ["again", "stop", "what a day"])
@pytest.mark.parametrize(
    ("last", "instead"),
    [("turn left", "engine.parse"), (["turn left"], "engine.parse"), ({"type": "stop"}, "from_json"), (5, "not int")],
    ids=repr,
)
def test_what_is_no_action_cannot_be_done_again(engine, text, last, instead):
    with pytest.raises(TypeError, match=f"^last takes actions .*{instead}"):
        engine.parse(text, last=last)
    with pytest.raises(TypeError, match=r"^last takes actions .*: give its \.actions"):
        engine.parse(text, last=[engine.parse("turn left")])


@pytest.mark.parametrize("given", [None, 5, b"en", {"language": "en"}, [5], [None]], ids=repr)
def test_files_are_named_by_text_or_path(given):
    with pytest.raises(TypeError, match=r"^grammars are given by path or name, not as "):
        IntentEngine.from_files(given)
    if given is not None and not isinstance(given, dict):
        with pytest.raises(TypeError, match=r"^locations are "):
            IntentEngine.from_files("en", locations=given)


@pytest.mark.parametrize("given", ["en", (), ["en"]], ids=repr)
def test_an_engine_is_made_of_grammars_that_are_read(given):
    with pytest.raises(TypeError, match="from_files"):
        IntentEngine(given)


@pytest.mark.parametrize("copied", [pickle.dumps, copy.copy, copy.deepcopy], ids=lambda copied: copied.__name__)
def test_an_engine_that_is_copied_says_what_to_do_instead(engine, copied):
    with pytest.raises(TypeError, match="in each process"):
        copied(engine)


def test_what_an_engine_says_can_be_pickled(engine):
    found = engine.parse("go to the kitchen and turn left")
    assert pickle.loads(pickle.dumps(found)) == found


def test_an_engine_that_was_made_from_grammars_says_that_there_is_nothing_to_read_again(engine):
    other = IntentEngine(engine.grammars, engine.locations)
    with pytest.raises(ConfigError, match="made from grammars"):
        other.reload()
    assert other.parse("go to the kitchen").actions


def test_a_pose_of_a_robot_is_a_place():
    engine = IntentEngine.from_files("en", locations={"lab": Pose(1.0, 2.0, 0.5, "hall")})
    (action,) = engine.parse("go to the lab").actions
    assert (action.x, action.y, action.yaw, action.frame) == (1.0, 2.0, 0.5, "hall")
