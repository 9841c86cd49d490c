"""What a sentence is refused for is what the person who said it can put right."""

from __future__ import annotations

import pytest
from meanings import german, shipped

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status


@pytest.mark.parametrize("place", ["garage", "room 206", "gate b", "lab 4", "lab 4 b", "pantry", "attic stairs"])
@pytest.mark.parametrize("how", ["go to {}", "go to the {}", "drive to {}", "please navigate to the {}"])
def test_a_place_that_is_not_on_the_map_is_told_as_a_place(how, place):
    found = shipped().parse(how.format(place))
    assert found.status is Status.REJECTED
    assert found.reason == f"no place is called '{place}'"
    assert len(found.alternatives) == 3


@pytest.mark.parametrize("place", ["library", "gate b", "pantry", "the moon"])
@pytest.mark.parametrize("how", ["take me to {}", "bring me to {} please", "uh lead me to {}"])
def test_who_is_taken_to_a_place_is_told_of_the_place(how, place):
    """Not that a person is nothing to take, nor that "bring me the cup" goes on otherwise."""
    found = shipped().parse(how.format(place))
    assert found.status is Status.REJECTED
    assert found.reason == f"no place is called '{place.removeprefix('the ')}'"


@pytest.mark.parametrize("text", ["bring mich zur Bibliothek", "bring mich bitte zur Bibliothek"])
def test_so_is_a_german(text):
    assert german().parse(text).reason == "no place is called 'bibliothek'"


@pytest.mark.parametrize("text", ["take me to the", "bring me to", "go to the", "bring me the"])
def test_an_article_is_no_place(text):
    assert shipped().parse(text).status is Status.INCOMPLETE


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("turn floop ninety degrees", "no side is called 'floop'"),
        ("move floop two meters", "no direction is called 'floop'"),
        ("go forward two thousand meters", "more than the largest"),
    ],
)
def test_a_value_that_no_list_has_is_told_as_one_of_that_list(text, reason):
    found = shipped().parse(text)
    assert found.status is Status.REJECTED
    assert reason in found.reason


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("pan left thirty meters", "'thirty meters' is nothing that follows 'left' in this grammar"),
        ("pan dark red quickly", "'quickly' is nothing that follows 'dark red' in this grammar"),
        ("pan redd slowly", "no side is called 'redd slowly'"),
    ],
)
def test_words_behind_a_value_are_told_and_not_the_value(engine_of, text, reason):
    engine = engine_of(
        "language: en\nslots: {side: [left, right, red, dark red]}\n"
        "intents: {pan: {action: custom, sentences: ['pan {side} [twice]']}}\n"
    )
    assert engine.parse(text).reason == reason


@pytest.mark.parametrize("text", ["to the kitchen", "seven steps back", "go to the kitchen and then to the bedroom"])
def test_an_amount_tells_nothing_where_something_else_is_not_understood(text):
    """ "To the kitchen" is no turn by two degrees."""
    assert "smallest" not in shipped().parse(text).reason


def test_a_limit_is_told_of_what_the_sentence_calls_it():
    assert shipped().parse("turn left two").reason == "angle of 2° is less than the smallest, 5°"


@pytest.mark.parametrize(
    ("text", "amount"),
    [
        ("go forward a few feet", "a few"),
        ("go several meters", "several"),
        ("turn left some degrees and then go forward", "some"),
        ("uh go a few more feet please", "a few"),
        ("take a few steps back", "a few"),
        ("go many meters back and a few feet ahead", "many"),
    ],
)
def test_an_amount_without_a_number_is_asked_for(text, amount):
    found = shipped().parse(text)
    assert (found.status, found.reason) == (Status.REJECTED, f"{amount!r} may be any number; say how many")


@pytest.mark.parametrize(
    "text", ["few", "a few feet", "I went a few meters forward", "don't go a few feet", "go some place", "many thanks"]
)
def test_but_not_where_no_command_would_come_of_it(text):
    found = shipped().parse(text)
    assert not found.actions
    assert "any number" not in found.reason


def test_an_amount_without_a_number_in_german():
    engine = german()
    assert engine.parse("fahr ein paar Meter vor").reason == "'ein paar' may be any number; say how many"


@pytest.mark.parametrize("text", ["jump", "banana", "please jump", "hocus pocus", "calm down", "very slowly jump"])
def test_what_is_no_value_and_nothing_else_is_no_command(text):
    assert shipped().parse(text).reason == "not a command of this grammar"


FARM = """
language: en
slots:
  crop: {type: object, max_words: 2}
  row: {type: ordinal, max: 30}
  litres: {type: number, min: 1, max: 500}
  tilt: {type: angle, max: 90 deg}
  height: {type: distance, max: 2 m}
intents:
  harvest: {action: custom, sentences: ["harvest [the] {crop}", "harvest [the] {row} row"]}
  water: {action: custom, sentences: ["water [the] {crop}", "water {litres} liters"]}
  tilt: {action: custom, sentences: ["tilt by {tilt}", "raise the boom to {height}"]}
"""


@pytest.fixture(scope="module")
def farm(engine_of) -> IntentEngine:
    return engine_of(FARM)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("harvest the fortieth row", "row of 40 is more than the largest, 30"),
        ("water six hundred liters", "litres of 600 is more than the largest, 500"),
        ("tilt by a hundred degrees", "tilt of 100° is more than the largest, 90°"),
        ("raise the boom to 250 centimeters", "height of 2.5 m is more than the largest, 2 m"),
    ],
)
def test_a_number_beyond_its_limits_is_no_name_of_a_thing(farm, text, reason):
    found = farm.parse(text)
    assert (found.status, found.reason) == (Status.REJECTED, reason)


def test_a_thing_whose_name_has_a_number_is_a_thing(farm):
    assert farm.parse("harvest the thirtieth row").slots == {"row": 30.0}
    assert farm.parse("water six roses").slots == {"crop": "six roses"}


@pytest.mark.parametrize("whole", ["{}, and then turn left", "turn left and then {}", "turn left, {} and turn right"])
@pytest.mark.parametrize(
    ("part", "reason"),
    [
        ("go to the garage", "in 'go to the garage': no place is called 'garage'"),
        ("fly over the moon", "'fly over the moon' is not a command of this grammar"),
        ("go forward two thousand meters", "in 'go forward two thousand meters': distance of 2000 m is more"),
    ],
)
def test_what_spoils_a_compound_is_told(whole, part, reason):
    found = shipped().parse(whole.format(part))
    assert found.status is Status.REJECTED
    assert not found.actions
    assert found.reason.startswith(reason)


@pytest.mark.parametrize("text", ["the bus and the car", "we met and talked", "yes, and it was late"])
def test_what_joins_no_commands_is_told_as_a_whole(text):
    assert shipped().parse(text).reason == "not a command of this grammar"


TOWER = """
slots:
  place: [kitchen, dock]
  thing: {type: text, max_words: 2}
  pace: {type: choice, values: {slow: [slowly]}}
intents:
  go: {action: custom, sentences: ["(go|drive) to [the] {place}"]}
  take: {action: custom, sentences: ["pick up [the] {thing}"]}
  lift: {action: custom, sentences: ["lift the hook [{pace}]"]}
"""


@pytest.mark.parametrize(
    ("said", "how"),
    [
        ("slowly drive to the kitchen", "slowly"),
        ("please drive slowly to the kitchen", "slowly"),
        ("quickly go to the dock", "quickly"),
        ("carefully pick up the cup", "carefully"),
        ("immediately and quickly go to the dock", ""),
        ("slowly drive to the cellar", ""),
        ("slowly", ""),
        ("slowly, he went to the dock", ""),
    ],
)
def test_how_it_is_done_is_told_where_a_command_has_no_word_for_it(engine_of, said: str, how: str) -> None:
    """Nor is it done as it always is."""
    found = engine_of(TOWER).parse(said)
    assert not found.actions
    assert found.reason.startswith(f"{how!r} says how it is done") == bool(how)


def test_a_way_of_the_shipped_grammar_has_no_pace() -> None:
    found = shipped().parse("slowly drive to the kitchen")
    assert found.status is Status.REJECTED
    assert "'slowly' says how it is done" in found.reason


def test_how_it_is_done_is_done_where_a_command_has_it(engine_of) -> None:
    assert engine_of(TOWER).parse("slowly lift the hook").slots == {"pace": "slow"}
