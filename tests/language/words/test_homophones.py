"""Words that sound the same: the grammar tells which of them was said."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.names import NameIndex
from intent_engine.language.numbers.english_words import NUMBER_WORDS
from intent_engine.language.templates.spellings import own_homophones
from intent_engine.language.words.homophones import homophones

KITCHEN = """
intents:
  give:
    action: {type: custom, name: give}
    sentences: ["give me the {food}", "pair the cheese"]
slots:
  food: {type: choice, values: [pear, flour, grey tea, steak]}
"""


@pytest.fixture(scope="module")
def kitchen(engine_of) -> IntentEngine:
    return engine_of(KITCHEN)


@pytest.mark.parametrize(
    ("heard", "food"),
    [
        ("give me the pair", "pear"),
        ("give me the flower", "flour"),
        ("Give me the gray tee.", "grey tea"),
        ("give me the stake", "steak"),
        ("give me the steak", "steak"),
    ],
)
def test_what_sounds_the_same_is_the_grammars_word_and_as_sure(kitchen: IntentEngine, heard: str, food: str) -> None:
    found = kitchen.parse(heard)
    assert (found.status, found.slots, found.confidence) == (Status.ACCEPTED, {"food": food}, 1.0)


def test_what_was_read_for_another_word_is_told(kitchen: IntentEngine) -> None:
    assert kitchen.parse("give me the pair").reason == "read as 'give me the pear'"


def test_a_word_of_the_grammar_is_itself_where_it_can_be(kitchen: IntentEngine) -> None:
    assert kitchen.parse("pair the cheese").reason == ""


@pytest.mark.parametrize("heard", ["peer", "floor", "stick", "great tea"])
def test_what_only_sounds_alike_is_none(kitchen: IntentEngine, heard: str) -> None:
    assert kitchen.parse(f"give me the {heard}").status is not Status.ACCEPTED


def test_a_misheard_word_is_less_sure(engine_of) -> None:
    engine = engine_of(KITCHEN + "sound_alikes: {stick: [steak]}\n")
    assert engine.parse("give me the stick").confidence == pytest.approx(0.97)


def test_only_those_of_the_grammars_own_words_are_kept(kitchen: IntentEngine) -> None:
    found = own_homophones(kitchen.matcher(None).grammar)
    assert found["stake"] == ("steak",)
    assert "break" not in found


def test_another_language_has_none(engine_of) -> None:
    engine = engine_of("language: de\n" + KITCHEN)
    assert engine.parse("pear the cheese").status is not Status.ACCEPTED
    assert own_homophones(engine.matcher(None).grammar) == {}


@pytest.mark.parametrize("heard", ["male room", "the mail room", "mane haul", "gait two"])
def test_names_of_places_are_as_sure_by_ear(heard: str) -> None:
    places = NameIndex([("mail room", "mail room"), ("main hall", "main hall"), ("gate two", "gate 2")])
    assert places.resolve(heard).score == 1.0
    assert places.resolve(heard).name is not None


@given(st.sampled_from(sorted(homophones("en"))))
def test_either_may_be_heard_for_the_other(word: str) -> None:
    for other in homophones("en")[word]:
        assert other != word
        assert word in homophones("en")[other]


def test_numbers_and_what_turns_a_meaning_around_are_none():
    """But for "wait", which stops: a robot that stands for a "weight" does no harm."""
    operators = shipped().grammar.operators
    turning = {words[0] for words in (*operators.negation, *operators.correction, *operators.cancel) if len(words) == 1}
    assert turning.intersection(homophones("en")) == {"wait"}
    assert shipped().parse("wait").stops
    assert not NUMBER_WORDS & homophones("en").keys()


@pytest.mark.parametrize("heard", ["Break.", "break break please", "break hard", "frees", "Woe!", "no, break"])
def test_a_stop_is_one_by_its_sound_in_every_grammar(kitchen: IntentEngine, heard: str) -> None:
    assert kitchen.parse(heard).actions == (Stop(),)


@pytest.mark.parametrize("heard", ["take a break", "give me the pear break", "break the ice", "don't break"])
def test_but_only_where_nothing_else_was_said(kitchen: IntentEngine, heard: str) -> None:
    assert kitchen.parse(heard).actions == ()


def test_a_word_that_the_grammar_has_itself_is_no_stop(engine_of) -> None:
    own = """
    intents:
      rest:
        action: {type: custom, name: rest}
        sentences: ["break", "frees the arm"]
    """
    engine = engine_of(own)
    assert engine.parse("break").intent == "rest"
    assert engine.parse("frees").actions == ()
    assert engine.parse("brake").actions == (Stop(),)


OVEN = """
language: de
slots: {heat: number, tilt: angle}
intents:
  heat: {action: custom, sentences: ["heize auf {heat} Grad [Celsius]", "heize mit {heat} Prozent"]}
  tilt: {action: custom, sentences: ["kippe um {tilt}"]}
"""
LAB = """
language: en
slots: {heat: number, row: [A, B, C], column: {type: number, max: 12}}
intents:
  heat: {action: custom, sentences: ["heat to {heat} degrees [celsius] [in {row} {column}]"]}
  draw: {action: custom, sentences: ["draw {heat} microliters from {row} {column}"]}
"""


@pytest.mark.parametrize(
    ("grammar", "said", "slots"),
    [
        (OVEN, "heize auf 90°", {"heat": 90}),
        (OVEN, "heize auf 90 °C", {"heat": 90}),
        (OVEN, "heize mit 50%", {"heat": 50}),
        (OVEN, "kippe um 90°", {"tilt": pytest.approx(math.pi / 2)}),
        (LAB, "heat to 90°C", {"heat": 90}),
        (LAB, "heat to 90 °C in C4", {"heat": 90, "row": "C", "column": 4}),
        (LAB, "heat to 90 degrees in C four", {"heat": 90, "row": "C", "column": 4}),
        (LAB, "draw fifty microlitres from C three", {"heat": 50, "row": "C", "column": 3}),
    ],
)
def test_a_sign_is_its_word_in_any_language(engine_of, grammar, said, slots):
    """Recognisers write "90 °C" and "50%", whatever unit the author of a grammar counts with a plain number."""
    (action,) = engine_of(grammar).parse(said).actions
    assert action.slots == slots


WELLS = """
language: en
slots:
  row: [A, B, C, T]
  column: {type: number, min: 1, max: 12, whole: true}
intents:
  fill: {action: custom, sentences: ["fill well {row} {column}", "show row {row}"]}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("fill well be too", {"row": "B", "column": 2}),
        ("fill well-see one", {"row": "C", "column": 1}),
        ("fill well sea four", {"row": "C", "column": 4}),
        ("fill well tea 12", {"row": "T", "column": 12}),
        ("show row bee", {"row": "B"}),
        ("fill well a one", {"row": "A", "column": 1}),
    ],
)
def test_a_letter_is_what_is_written_for_it(engine_of, said: str, slots: dict[str, object]) -> None:
    found = engine_of(WELLS).parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.slots == slots


@pytest.mark.parametrize("said", ["show row you", "show row are", "show row why", "fill well dee one"])
def test_letters_that_a_grammar_does_not_have_are_none(engine_of, said: str) -> None:
    assert not engine_of(WELLS).parse(said).actions


BRITISH = """
slots:
  where: [harbour, theatre, filter]
  text: {type: text, max_words: 2}
intents:
  tidy: {action: custom, sentences: ["sterilize the {where}", "visualise [the] labels", "label {text}"]}
  motor: {action: custom, sentences: ["start the motor", "open the prize"]}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("sterilise the harbor", {"where": "harbour"}),
        ("Sterilize the theater!", {"where": "theatre"}),
        ("sterilise the filter", {"where": "filter"}),
        ("visualize labels", {}),
        ("label flavor", {"text": "flavor"}),
        ("sterilised the harbor", None),
        ("sterile the harbour", None),
        ("don't sterilise the harbor", None),
        ("open the prise", None),
    ],
)
def test_how_it_is_spelled_elsewhere(engine_of, said, slots) -> None:
    found = engine_of(BRITISH).parse(said)
    assert (found.slots if found.actions else None) == slots


SHELVES = """
language: en
slots: {shelf: [A, B, F, G], box: {type: number, max: 9}, hotel: [golf, "hotel echo"]}
intents:
  store: {action: custom, sentences: ["store a box on shelf {shelf} [box {box}]"]}
  hurry: {action: custom, sentences: ["(a|the) nurse to shelf {shelf}", "drive to {hotel}"]}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("store a box on shelf bravo", {"shelf": "B"}),
        ("store a box on shelf foxtrot box two", {"shelf": "F", "box": 2}),
        ("the nurse to shelf bravo", {"shelf": "B"}),
        ("drive to golf", {"hotel": "golf"}),
        ("drive to hotel echo", {"hotel": "hotel echo"}),
    ],
)
def test_a_letter_of_a_list_is_said_as_pilots_do(engine_of, said, slots):
    assert dict(engine_of(SHELVES).parse(said).slots) == slots


@pytest.mark.parametrize(
    "said",
    [
        "store a box on shelf charlie",
        "store a box on shelf golf",  # the word of another list
        "store alpha box on shelf b",  # the article is no letter
        "alpha nurse to shelf b",
        "drive to bravo",
    ],
)
def test_and_no_other_word_is_one(engine_of, said):
    assert not engine_of(SHELVES).parse(said).actions


def test_the_first_letter_is_one_where_no_sentence_has_it_as_an_article(engine_of):
    plain = SHELVES.replace("(a|the)", "the").replace("store a box", "store the box")
    assert engine_of(plain).parse("store the box on shelf alpha").slots == {"shelf": "A"}
    assert not engine_of(plain).parse("store alpha box on shelf b").actions
