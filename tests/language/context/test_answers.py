"""What answers "bay 3 or bay 13?", and what does nothing."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.actions import Custom, Navigate, Stop, Turn
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.answers import with_name
from intent_engine.language.loading.language_words import default_wording

NONE_MEANT = "nothing that was asked about is meant"


def places(*names: str) -> dict[str, tuple[float, float, float]]:
    return {name: (float(at), 0.0, 0.0) for at, name in enumerate(names)}


def engine(*names: str, grammar: str | list[str] = "en", wake: tuple[str, ...] = ()) -> IntentEngine:
    return IntentEngine.from_files(grammar, locations=places(*names), wake=wake)


BAYS = engine("bay 3", "bay 13", "kitchen")
DOORS = engine("left door", "right door")
LAB = engine("lab")


def told(engine: IntentEngine, *texts: str, **how: object) -> Interpretation:
    """What the last of some texts means, each after the one before."""
    last: Interpretation | tuple[()] = ()
    for text in texts:
        last = engine.parse(text, last=last, **how)
    assert isinstance(last, Interpretation)
    return last


def went(found: Interpretation) -> list[str]:
    return [action.location for action in found.actions if isinstance(action, Navigate)]


@pytest.mark.parametrize(
    ("answer", "place"),
    [
        ("bay 3", "bay 3"),
        ("Bay three, please.", "bay 3"),
        ("to bay 13", "bay 13"),
        ("three", "bay 3"),
        ("13", "bay 13"),
        ("the first", "bay 3"),
        ("the second one", "bay 13"),
        ("um, the last one", "bay 13"),
        ("number two", "bay 13"),
        ("yes, thirteen", "bay 13"),
    ],
)
def test_an_answer_that_tells_one_alternative_is_the_whole_sentence(answer, place):
    found = told(BAYS, "go to bay", answer)
    assert went(found) == [place]
    assert (found.text, found.intent, found.slots) == (f"go to {place}", "navigate", {"place": place})
    assert BAYS.parse(found.text).actions == found.actions


@pytest.mark.parametrize(
    "answer",
    ["yes", "bay", "thirty", "one", "the third", "three and thirteen", "no bay 3", "if bay 3", "right"],
)
def test_what_tells_no_one_alternative_does_nothing_of_them(answer):
    found = told(BAYS, "go to bay", answer)
    assert not went(found)
    assert went(told(BAYS, "go to bay", answer, "bay 3")) == ([] if answer == "right" else ["bay 3"])


@pytest.mark.parametrize("answer", ["no", "neither", "no, neither of them", "nope", "none of those, please"])
def test_who_means_none_of_them_is_asked_no_more(answer):
    found = told(BAYS, "go to bay", answer)
    assert (found.status, found.reason, found.actions) == (Status.REJECTED, NONE_MEANT, ())
    assert not told(BAYS, "go to bay", answer, "bay 3").actions


@pytest.mark.parametrize("nothing", ["what a nice day", "kitchen", "okay", "", "bay 3 or bay 13"])
def test_what_is_no_answer_ends_the_question(nothing):
    assert not told(BAYS, "go to bay", nothing).actions
    assert not told(BAYS, "go to bay", nothing, "the second one").actions


def test_another_command_is_done_and_ends_the_question():
    assert went(told(BAYS, "go to bay", "go to the kitchen")) == ["kitchen"]
    assert isinstance(told(BAYS, "go to bay", "turn left").actions[0], Turn)
    assert not told(BAYS, "go to bay", "turn left", "bay 3").actions


@pytest.mark.parametrize("state", [(), ("moving",)])
@pytest.mark.parametrize("stop", ["stop", "no, stop", "halt please"])
def test_a_stop_stops_and_ends_the_question(stop, state):
    assert told(BAYS, "go to bay", stop, state=state).actions == (Stop(),)
    assert not told(BAYS, "go to bay", stop, "bay 3", state=state).actions


def test_an_answer_with_a_stop_stops_a_robot_that_moves():
    assert told(BAYS, "go to bay", "stop, bay 3", state="moving").actions == (Stop(),)
    assert not told(BAYS, "go to bay", "stop, bay 3").actions


@pytest.mark.parametrize(
    ("answer", "place"), [("the left one", "left door"), ("the right door", "right door"), ("the second", "right door")]
)
def test_a_word_of_a_name_tells_which(answer, place):
    assert went(told(DOORS, "go to the door", answer)) == [place]


@pytest.mark.parametrize("side", ["left", "right"])
def test_what_may_be_a_command_or_an_answer_is_asked_again(side):
    found = told(DOORS, "go to the door", side)
    assert (found.status, found.actions) == (Status.AMBIGUOUS, ())
    assert not told(DOORS, "go to the door", side, side).actions
    assert went(told(DOORS, "go to the door", side, f"the {side} door")) == [f"{side} door"]
    assert isinstance(told(DOORS, "go to the door", side, f"turn {side}").actions[0], Turn)


@pytest.mark.parametrize("yes", ["yes", "yeah", "yes please", "exactly", "the lab", "yes, the lab"])
def test_yes_is_an_answer_where_one_thing_was_asked(yes):
    asked = LAB.parse("go to the lap", last=())
    assert asked.alternatives == ("lab",)
    assert went(LAB.parse(yes, last=asked)) == ["lab"]


@pytest.mark.parametrize("said", ["no", "okay", "right", "yes and no", "yes but slowly"])
def test_what_is_no_yes_does_nothing(said):
    assert not told(LAB, "go to the lap", said).actions


@pytest.mark.parametrize("name", ["bay 1", "bay 33"])
def test_a_number_is_not_a_part_of_another(name):
    found = told(engine("bay 1", "bay 2", "bay 33"), "go to bay", name.removeprefix("bay "))
    assert went(found) == [name]
    assert not told(engine("bay 1", "bay 2", "bay 33"), "go to bay", "three").actions


def test_an_unfinished_sentence_is_answered_by_its_rest():
    assert went(told(BAYS, "go to", "the kitchen")) == ["kitchen"]
    assert went(told(BAYS, "go to", "bay", "three")) == ["bay 3"]
    assert isinstance(told(BAYS, "turn", "left").actions[0], Turn)
    assert not told(BAYS, "go to", "yes", "kitchen").actions
    assert told(BAYS, "go to", "no").reason == NONE_MEANT
    assert "no place is called 'moon'" in told(BAYS, "go to", "the moon").reason
    assert not told(LAB, "go to", "what a nice day", "yes").actions


def test_a_number_in_two_pieces_is_no_answer():
    assert not told(BAYS, "go forward twenty", "five meters").actions


def test_a_whole_command_is_no_thing_to_pick_up():
    assert went(told(BAYS, "pick up", "go to the kitchen")) == ["kitchen"]


def test_what_is_chosen_means_what_it_means_in_its_sentence():
    found = told(BAYS, "go to bay and then turn left", "the second one")
    assert went(found) == ["bay 13"]
    assert len(found.actions) == 2
    assert not told(BAYS, "don't go to bay", "bay 3").actions
    assert not told(BAYS, "go to bay and go to bay", "bay 3").actions, "nobody knows where it belongs"


def test_again_and_it_point_to_what_was_done_before_the_question():
    turned = BAYS.parse("turn left")
    asked = BAYS.parse("go to bay", last=turned)
    assert BAYS.parse("again", last=asked).actions == turned.actions
    assert isinstance(told(BAYS, "turn left", "go to bay", "thirty", "again").actions[0], Turn)


BRING = """
language: en
intents:
  fetch: {action: {type: custom}, sentences: ["fetch it from {place}"]}
  take: {action: {type: pick, object: "{thing}"}, sentences: ["pick up the {thing}"]}
  wash: {action: {type: custom}, requires: [docked], sentences: ["wash {place}"]}
slots: {place: {type: location}, thing: {type: text}}
"""


def test_what_is_chosen_must_be_possible_now(engine_of):
    asks = engine_of(BRING, locations=places("bay 3", "bay 13"))
    asked = asks.parse("wash bay", state="docked")
    assert asked.alternatives == ("bay 3", "bay 13")
    assert asks.parse("three", last=asked, state="docked").actions == (Custom("wash", {"place": "bay 3"}),)
    refused = asks.parse("three", last=asked)
    assert (refused.status, refused.actions) == (Status.REJECTED, ())
    assert "docked" in refused.reason


def test_with_a_wake_word_an_answer_needs_it_too_if_it_is_spoken():
    robot = engine("bay 3", "bay 13", wake=("robot",))
    asked = robot.parse("robot, go to bay", spoken=True)
    assert not robot.parse("three", last=asked, spoken=True).actions
    assert went(robot.parse("robot, three", last=asked, spoken=True)) == ["bay 3"]
    assert went(robot.parse("three", last=asked)) == ["bay 3"], "typed it needs none"
    begun = robot.parse("robot, go to", spoken=True)
    assert went(robot.parse("robot, bay three", last=begun, spoken=True)) == ["bay 3"]


def test_nothing_is_asked_by_json_or_by_actions():
    asked = BAYS.parse("go to bay")
    assert not BAYS.parse("bay 3", last=Interpretation.from_json(asked.to_json())).actions
    assert not BAYS.parse("bay 3", last=asked.actions).actions
    assert not BAYS.parse("bay 3").actions
    assert BAYS.answer(asked, "what a nice day") is None
    assert BAYS.answer(BAYS.parse("turn left"), "yes") is None


def test_an_answer_is_explained():
    asked = BAYS.parse("go to bay")
    assert BAYS.explain("three", last=asked).interpretation == BAYS.parse("three", last=asked)


WORDS = (
    "yes no not neither the a first second third last one two three thirteen thirty bay left right door kitchen go to "
    "turn stop don't and or please okay again it if , uh both other"
)


@given(
    st.sampled_from(["go to bay", "go to the door", "go to bay and turn left"]),
    st.lists(st.sampled_from(WORDS.split()), max_size=5),
)
def test_nothing_is_done_that_was_neither_said_nor_asked_about(asks, words):
    text, home = " ".join(words), DOORS if "door" in asks else BAYS
    asked = home.parse(asks, last=())
    assert asked.question is not None
    said = [home.parse(text, last=()).actions]
    meant = [home.parse(one).actions for one in asked.question.choices if one]
    found = home.parse(text, last=asked)
    assert found.actions in [(), *said, *meant]
    if said[0] == (Stop(),):
        assert found.actions == (Stop(),)
    if found.actions and found.actions in meant and found.actions not in said:
        assert not {"not", "don't", "no", "neither", "or", "if"} & set(words)


GOING = {
    "en": ("go to {place}", "go to bay", "yes", "no", "neither", "the second one", "the last"),
    "de": ("geh zu {place}", "geh zu bay", "ja", "nein", "keins von beiden", "das zweite", "der letzte"),
    "fr": ("va vers {place}", "va vers bay", "oui", "non", "aucun des deux", "le deuxième", "la dernière"),
    "es": ("ve a {place}", "ve a bay", "sí", "no", "ninguno de los dos", "el segundo", "la última"),
    "it": ("vai a {place}", "vai a bay", "sì", "no", "nessuno dei due", "il secondo", "l'ultima"),
}


@pytest.mark.parametrize("language", GOING)
def test_every_language_answers(language, engine_of):
    sentence, asks, yes, no, neither, second, last = GOING[language]
    grammar = (
        f"language: {language}\nintents:\n  go: {{action: {{type: navigate, location: '{{place}}'}}, "
        f"sentences: ['{sentence}']}}\nslots: {{place: {{type: location}}}}\n"
    )
    two = engine_of(grammar, locations=places("bay 3", "bay 13"))
    assert two.parse(asks).status is Status.AMBIGUOUS
    for answer in (second, last, "bay 13", "13"):
        assert went(told(two, asks, answer)) == ["bay 13"], answer
    assert not told(two, asks, yes).actions
    assert [told(two, asks, one).reason for one in (no, neither)] == [NONE_MEANT] * 2
    one = engine_of(grammar, locations=places("lab"))
    assert went(told(one, asks.replace("bay", "lap"), yes)) == ["lab"]


@pytest.mark.parametrize("language", GOING)
def test_no_word_says_yes_and_no(language):
    wording = default_wording(language, lambda texts: tuple(tuple(text.split()) for text in texts))
    assert wording.affirming
    assert wording.declining
    assert set(wording.affirming).isdisjoint(wording.declining)


def test_of_several_languages_each_may_answer():
    both = engine("bay 3", "bay 13", grammar=["en", "de"])
    assert went(told(both, "go to bay", "das zweite")) == ["bay 13"]
    assert told(both, "go to bay", "nein").reason == NONE_MEANT


@pytest.mark.parametrize(
    ("text", "said", "name", "whole"),
    [
        ("Go to bay!", ["bay"], "bay 3", "Go to bay 3!"),
        ("go to bay, then turn left", ["bay"], "bay 3", "go to bay 3, then turn left"),
        ("go to the big bay", ["big", "bay"], "bay 3", "go to the bay 3"),
        ("from bay to bay", ["bay"], "bay 3", ""),
        ("go to the dock", ["bay"], "bay 3", ""),
    ],
)
def test_a_name_takes_the_place_of_the_words_said_for_it(text, said, name, whole):
    assert with_name(text, said, name) == whole


def test_not_the_kitchen_is_still_of_what_is_done_when_something_is_asked():
    """Whoever types, or has a node, gives what asks back as the last."""
    asked = told(BAYS, "go to the kitchen", "go to bay")
    assert went(replace(asked, actions=BAYS.parse("not the kitchen", last=asked).denied)) == ["kitchen"]


@pytest.mark.parametrize(
    ("answer", "left"),
    [
        ("not bay 3", ("bay 13",)),
        ("no, not three", ("bay 13",)),
        ("not the second one", ("bay 3",)),
        ("not the lab", ("bay 3", "bay 13")),
    ],
)
def test_what_is_not_meant_is_no_alternative_any_more(answer, left):
    asked = told(BAYS, "go to bay")
    found = BAYS.parse(answer, last=asked)
    assert not found.actions
    assert found.alternatives == left or (len(left) == 2 and found.question is None)


def test_none_is_left():
    found = told(BAYS, "go to bay", "not bay 3", "not bay 13")
    assert (found.reason, found.question) == (NONE_MEANT, None)


def test_of_talk_that_was_heard_nothing_is_asked():
    """To any word some sentence is the nearest: after "cup" and a "yes" to somebody else the robot backed up."""
    assert told(LAB, "cup").question.choices == ("back up",)
    for how in ({"heard": True}, {"spoken": True}):
        assert told(LAB, "cup", **how).question is None
        assert not told(LAB, "cup", "yes", **how).actions
    assert went(told(LAB, "go to the lap", "yes", heard=True)) == ["lab"]
