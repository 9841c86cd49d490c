"""What is a command only behind another: "go to the kitchen and then to the bedroom"."""

from __future__ import annotations

from functools import cache

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from meanings import done, german, shipped

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.errors import ConfigError
from intent_engine.interpretation import Status
from intent_engine.language.checker import check_grammar
from intent_engine.language.sampler import RandomChoices, Sampler, sample
from intent_engine.language.utterance import Utterance

ENGLISH = {
    "go to the kitchen and then to the bedroom": "to kitchen, to bedroom",
    "go to the kitchen then the bedroom": "to kitchen, to bedroom",
    "go to the kitchen, then to the bedroom, and then to the dock": "to kitchen, to bedroom, to dock",
    "uh go to the kitchen please and then to the bedroom now": "to kitchen, to bedroom",
    "turn left and go to the kitchen and to the dock and turn right": "left 43, to kitchen, to dock, right 43",
    "turn left ninety degrees then right forty five": "left 90, right 45",
    "take a left and then a right": "left 43, right 43",
    "pick up the cup and the plate": "pick cup, pick plate",
    "pick up the cup and the plate from the table and the fork": "pick cup, pick plate, pick fork",
    "pick up the cup and the plate and go to the kitchen": "pick cup, pick plate, to kitchen",
    "put the cup on the table and the plate in the sink": "place cup table, place plate sink",
    "go to the kitchen no to the bedroom and then to the dock": "to bedroom, to dock",
    "go to the kitchen and then to the bedroom and stop": "to kitchen, to bedroom",
    "go to the kitchen and then to the bedroom stop": "stop",
    # In a list, where a joint comes at last.
    "go to the kitchen, the bedroom and the dock": "to kitchen, to bedroom, to dock",
    "turn left, go to the kitchen, the bedroom, and the dock": "left 43, to kitchen, to bedroom, to dock",
    "pick up the cup, the plate, the fork and the spoon": "pick cup, pick plate, pick fork, pick spoon",
    "go to the kitchen, the bedroom": "rejected",
    "go to the kitchen, the bedroom, the dock": "rejected",
    "go to the kitchen, the bedroom and turn left": "rejected",
    "go to the kitchen, the bedroom and stop": "rejected",
    "go to the kitchen, the bedroom or the dock": "rejected",
    "turn left, the bedroom and the dock": "rejected",
    # Corrected.
    "go to the kitchen and then to the bedroom, no, the dock": "to kitchen, to dock",
    "go to the kitchen and then to the bedroom, no, to the dock": "to kitchen, to dock",
    "go to the kitchen and then to the bedroom, no, turn left": "to kitchen, left 43",
    "go to the kitchen, the bedroom and the dock, I mean the living room": "to kitchen, to bedroom, to living room",
    "pick up the cup and the plate, no, the bowl": "pick cup, pick bowl",
    "put the cup on the table and the plate in the sink, no, on the shelf": "place cup table, place plate shelf",
    "put the cup on the table and the plate in the sink, no, the fork": "place cup table, place fork sink",
    "turn left ninety degrees then right forty five, no, sixty": "left 90, right 60",
    "go to the kitchen and then to the bedroom, no": "rejected",
    "go to the kitchen and then to the bedroom, no, the cup": "rejected",
    # It names as much as what it goes on from.
    "bring me the cup and the plate": "bring, bring",
    # Of both, and of no more.
    "pick up both the cup and the plate": "pick cup, pick plate",
    "pick up the cup and the plate both": "pick cup, pick plate",
    "bring me both the cup and the plate": "bring, bring",
    "take both the cup and go home": "rejected",
    "take both the cup, the plate and the fork": "rejected",
    "take the cup both": "rejected",
    "don't take both the cup and the plate": "rejected",
    "bring the cup to the office and the plate to the kitchen": "bring, bring",
    "bring the cup to the office and the plate": "rejected",
    "bring me the cup and the plate from the kitchen": "rejected",
    "drop the cup and the plate": "place cup, place plate",
    "place the cup and the plate on the table": "rejected",
    # By themselves, behind another intent, or without a joint they are nothing.
    "to the bedroom": "rejected",
    "and then to the bedroom": "rejected",
    "go forward and to the bedroom": "rejected",
    "turn left and the plate": "rejected",
    "go to the kitchen, to the bedroom": "rejected",
    "go to the kitchen, turn left, and to the bedroom": "rejected",
    # And whatever else is not clear.
    "go to the kitchen and not to the bedroom": "to kitchen",
    "don't go to the kitchen and then to the bedroom": "rejected",
    "don't go to the kitchen, to the bedroom": "rejected",
    "go to the kitchen and then to the bedroom if the door is open": "rejected",
    "go to the kitchen and then to the moon": "rejected",
    "go to the kitchen and to the bedroom or to the dock": "rejected",
    "pick up the cup and smile": "rejected",
    "pick up the cup and shake it": "rejected",
    "pick up the cup and the door is open": "rejected",
    "take the cup to the kitchen and the plate": "rejected",
    "put the cup on the table and the plate": "rejected",
    # What is a command by itself is that one.
    "pick up the cup and that is enough": "stop",
    "turn left ninety degrees and then right": "left 90, right 43",
}
GERMAN = {
    "nimm die Tasse und den Teller": "pick tasse, pick teller",
    "nimm die Tasse und die Flasche vom Tisch": "pick tasse, pick flasche",
    "stell die Tasse auf den Tisch und den Teller ins Regal": "place tasse tisch, place teller regal",
    "fahr in die Küche und dann ins Schlafzimmer": "to küche, to schlafzimmer",
    "dreh dich um 90 Grad nach links und dann um 45 Grad nach rechts": "left 90, right 45",
    "fahr in die Küche, ins Schlafzimmer und ins Wohnzimmer": "to küche, to schlafzimmer, to wohnzimmer",
    "fahr in die Küche und dann ins Schlafzimmer, nein, ins Wohnzimmer": "to küche, to wohnzimmer",
    "bring mir die Tasse und den Teller": "bring, bring",
    "bring die Tasse zum Tisch und den Teller": "rejected",
    "stell die Tasse ab und den Teller": "place tasse, place teller",
    "den Teller": "rejected",
    "dreh dich nach links und den Teller": "rejected",
    "nimm die Tasse und den Teller nicht": "rejected",
    "nimm die Tasse und die Tür ist offen": "rejected",
}


@pytest.mark.parametrize(("text", "meant"), ENGLISH.items())
def test_what_follows_goes_on_from_what_was_said(text: str, meant: str) -> None:
    assert done(shipped().parse(text)) == meant


@pytest.mark.parametrize(("text", "meant"), GERMAN.items())
def test_in_german_too(text: str, meant: str) -> None:
    assert done(german().parse(text)) == meant


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("go to the kitchen and then to the moon", "in 'to the moon': no place is called 'moon'"),
        ("pick up the cup and the left", "in 'the left': 'left' is nothing for slot 'another'"),
    ],
)
def test_what_is_wrong_with_it_is_told(text: str, reason: str) -> None:
    assert shipped().parse(text).reason == reason


def test_a_misheard_name_is_resolved_in_it() -> None:
    found = shipped().parse("go to the kitchen and then to the bed room")
    assert done(found) == "to kitchen, to bedroom"
    found = shipped().parse("turn left ninety degrees then a rite")
    assert done(found) == "left 90, right 43"


@pytest.mark.parametrize("text", ["pick up the cup and the plate and put them on the table", "put them on the table"])
def test_several_things_are_not_put_down_as_one(text: str) -> None:
    engine = shipped()
    last = engine.parse("pick up the cup and the plate").actions
    found = engine.parse(text, last=last)
    assert found.status is Status.REJECTED
    assert "cup, plate" in found.reason
    assert done(engine.parse("put them on the table", last=last[:1])) == "place cup table"
    assert done(engine.parse("pick up the cup and the plate and put it on the table")).endswith("place plate table")


# -- laws -----------------------------------------------------------------------------------------------------


WHERE = [(shipped, name) for name in ("navigate", "turn", "pick", "place")]
WHERE += [(german, name) for name in ("turn", "pick", "place")]


@cache
def sampler_of(engine):
    return Sampler(engine.grammar, engine.locations)


@st.composite
def lists(draw):
    """An engine, a command, a joint, what goes on from it, and what both do."""
    of, intent = draw(st.sampled_from(WHERE))
    engine = of()
    sampler = sampler_of(engine)
    first = sampler.draw(RandomChoices(draw(st.integers(0, 10**6))), intent)
    then = sampler.attempt_later(RandomChoices(draw(st.integers(0, 10**6))), first)
    assume(then is not None)
    joint = " ".join(draw(st.sampled_from(engine.grammar.operators.sequence)))
    before, after = (" ".join(piece.text for piece in sample.pieces) for sample in (first, then))
    assume(engine.parse(before).actions == first.actions)
    return engine, before, joint, after, first.actions + then.actions


laws = settings(max_examples=200, deadline=None, derandomize=True)


@laws
@given(lists())
def test_it_does_both_and_nothing_else(said):
    engine, first, joint, then, actions = said
    assume(not any(f"{joint} {then} ".startswith(f"{' '.join(none)} ") for none in engine.grammar.wording.no_joints))
    alone = engine.parse(then)
    both = engine.parse(f"{first} {joint} {then}")
    if alone.status is Status.ACCEPTED:
        actions = engine.parse(first).actions + alone.actions
    assert both.actions in ((), actions)
    asked = Status.AMBIGUOUS in (alone.status, both.status)  # what its end is meant for, too
    assert both.actions or asked or joint.split()[-1] in then.split(), both.reason


@laws
@given(lists())
def test_every_beginning_of_it_may_go_on(said):
    engine, first, joint, then, _ = said
    text = f"{first} {joint} {then}"
    words = Utterance.of(text, engine.grammar.language).words
    likely = engine.matcher().likely
    for count in range(1, len(words) + 1):
        begun = " ".join(words[:count])
        if Utterance.of(begun, engine.grammar.language).words == words[:count]:  # else "s swing" would be a stutter
            assert engine.prefix(begun).status is not PrefixStatus.IMPOSSIBLE, begun
    assert engine.prefix(text).status in (PrefixStatus.COMPLETE, PrefixStatus.EXTENDABLE)
    assert likely.walk(words)[1] is not None  # a recogniser is led along it


@laws
@given(lists(), st.sampled_from(["follow me", "come here"]))
def test_behind_another_intent_it_is_nothing(said, other):
    engine, _, joint, then, _ = said
    assume(engine is shipped() and engine.parse(then).status is Status.REJECTED)
    assert not engine.parse(f"{other} {joint} {then}").actions


@settings(max_examples=10, deadline=None, derandomize=True)
@given(st.integers(0, 10**6), st.sampled_from([shipped, german]))
def test_it_is_sampled(seed, of):
    engine = of()
    drawn = [one for one in sample(engine.grammar, engine.locations, 200, seed=seed) if one.intent == "compound"]
    assert drawn
    for one in drawn:
        found = engine.parse(one.text)
        assert found.actions in ((), one.actions), one.text


# -- the key of the file --------------------------------------------------------------------------------------


ROUTES = """
language: en
slots:
  stop_at: [harbour, market, station]
  thing: {type: text, max_words: 2}
intents:
  ride:
    action: custom
    sentences: ["ride to the {stop_at}"]
    then: %s
  sail:
    action: custom
    sentences: ["sail", "on to the market"]
"""


def engine_of(tmp_path, then: str) -> IntentEngine:
    path = tmp_path / "routes.yaml"
    path.write_text(ROUTES % then)
    return IntentEngine.from_files(path, locations={})


def test_a_grammar_of_ones_own_has_it(tmp_path):
    engine = engine_of(tmp_path, '["[on] to the {stop_at}", {say: "all the way", slots: {stop_at: station}}]')
    found = engine.parse("ride to the harbour and then to the station")
    assert found.slots == {
        "steps": [
            {"intent": "ride", "slots": {"stop_at": "harbour"}},
            {"intent": "ride", "slots": {"stop_at": "station"}},
        ]
    }
    assert engine.parse("ride to the harbour and all the way").slots["steps"][1]["slots"] == {"stop_at": "station"}
    assert engine.parse("sail and then to the station").status is Status.REJECTED
    # What is a command by itself is that one.
    steps = engine.parse("ride to the harbour and on to the market").slots["steps"]
    assert [step["intent"] for step in steps] == ["ride", "sail"]


@pytest.mark.parametrize(
    ("then", "message"),
    [
        ('["to the {stopat}"]', "there is no slot or phrase 'stopat'"),
        ('["to the (market"]', "'(' is never closed"),
        ('["{thing}"]', "this sentence fits whatever anybody says"),
        ('["[to]"]', "every word of this sentence may be left out"),
        ("[{say: to there, slots: {stop_at: marked}}]", "'marked' is no value of slot 'stop_at'"),
        ("{on: to}", "then"),
    ],
)
def test_its_mistakes_are_told(tmp_path, then, message):
    with pytest.raises(ConfigError) as caught:
        engine_of(tmp_path, then)
    assert message in str(caught.value)


def test_a_file_that_includes_another_adds_to_it(tmp_path):
    (tmp_path / "routes.yaml").write_text(ROUTES % '["to the {stop_at}"]')
    more = tmp_path / "more.yaml"
    more.write_text(
        'language: en\ninclude: [routes.yaml]\nintents:\n  ride: {action: custom, then: ["the {stop_at} next"]}\n'
    )
    engine = IntentEngine.from_files(more, locations={})
    found = engine.parse("ride to the harbour and to the market and the station next")
    assert [step["slots"]["stop_at"] for step in found.slots["steps"]] == ["harbour", "market", "station"]


def test_what_is_never_understood_is_told(tmp_path):
    engine = engine_of(tmp_path, '["on to the market", "to the {stop_at}"]')
    found = [one for one in check_grammar(engine.grammar, None).findings if one.topic == "shadowed"]
    assert [one.problem.message for one in found] == [
        "this sentence is never understood: 'on to the market' is one of 'sail' (line 13)"
    ]
    assert not [one for one in check_grammar(shipped().grammar, shipped().locations).findings if one.level == "warning"]


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("go to bay 3 and then 2 meters back", True),
        ("go to bay three, then two meters back", True),
        ("go to the exit point and one meter back", True),  # no number ends with a "point"
        ("go to bay 3 and 2 meters back", False),
        ("go to bay 3, 2 meters back", False),
    ],
)
def test_numbers_before_and_behind_a_joint_are_two_unless_they_may_be_one(engine_of, said, done):
    engine = engine_of("include: en", locations={"bay 3": (0.0, 3.0, 0.0), "exit point": (1.0, 1.0, 0.0)})
    assert len(engine.parse(said).actions) == (2 if done else 0)
