"""A sentence of a grammar beside the words that were heard."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.speech.hypotheses.said_and_heard import SaidAndHeard
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar


@pytest.mark.parametrize(
    ("sentence", "heard", "unheard"),
    [
        ("go for three seconds", "for three seconds", ("go",)),
        ("please go for three seconds", "for three seconds", ("go",)),
        ("go forward two meters", "forward two meters", ()),  # a command by itself
        ("stop moving", "moving", ()),
        ("go for three seconds", "so for three seconds", ()),
    ],
)
def test_a_verb_that_nobody_heard_makes_no_command_of_a_part_of_one(grammar, sentence, heard, unheard):
    assert SaidAndHeard(grammar, sentence.split(), [heard.split()] * 2).begins_unheard() == unheard


@pytest.mark.parametrize(
    ("sentence", "heard", "otherwise"),
    [
        ("scan b five", ["scan bay five"] * 2, ("bay",)),
        ("scan b five", ["scan bay five", "span bay to"], ("bay",)),
        ("scan b five", ["scan bay five", "scan b five"], ()),
        ("scan b five", ["scan g five"] * 2, ()),
        ("scan b five", ["scan be five"] * 2, ()),
        ("scan bay five b", ["scan bay five bay"] * 2, ()),  # which the sentence has
        ("i want you to scan a five", ["would you like to scan a five"] * 2, ()),  # whose "I" is no code
        ("scan b five", ["scan they five"] * 2, ()),  # no word of the grammar
        ("scan bay b five", ["scan bay bay five"] * 2, ()),  # who stammers
        ("scan the b five", ["scan a five"] * 2, ()),  # who says "the", and is heard to say "a", says nothing else
        ("scan a five", ["scan the five"] * 2, ()),
        ("scan b five", [], ()),
    ],
)
def test_a_word_that_all_heard_is_no_letter(tmp_path, sentence, heard, otherwise):
    file = tmp_path / "depot.yaml"
    file.write_text("slots: {bay: [A5, B5]}\nintents: {scan: {action: custom, sentences: ['scan [bay] {bay}']}}\n")
    grammar = SpokenGrammar(IntentEngine.from_files(file))
    assert SaidAndHeard(grammar, sentence.split(), [one.split() for one in heard]).letter_otherwise() == otherwise


@pytest.mark.parametrize(
    ("sentence", "heard", "otherwise"),
    [
        ("shut the oven", ["set the oven"] * 2, ("set",)),
        ("shut the oven", ["please set the oven", "set the of vin"], ("set",)),
        ("please shut the oven", ["set the oven"] * 2, ("set",)),
        ("shut the oven", ["set the oven", "sat the oven"], ()),
        ("shut the oven", ["set the oven", "shut the oven"], ()),
        ("shut the oven", ["sat the oven"] * 2, ()),  # with which no command begins
        ("shut the oven", ["set an oven"] * 2, ()),  # nor with this
        ("shut the oven", ["set the oven", "set an oven"], ("set",)),
        ("shut the oven", ["set"] * 2, ("set",)),
        ("the oven shut", ["the oven set"] * 2, ()),
        ("shut the oven", ["the oven"] * 2, ()),
        ("halt", ["set"] * 2, ()),  # a word alone is weighed beside all others
        ("two ovens", ["three ovens"] * 2, ()),  # numbers are weighed apart
        ("stop", ["set"] * 2, ()),  # a stop waits for nothing
        ("shut the oven", [], ()),
    ],
)
def test_a_command_that_all_heard_begin_is_no_other(tmp_path, sentence, heard, otherwise):
    file = tmp_path / "bakery.yaml"
    file.write_text(
        "slots: {n: number}\n"
        "intents:\n"
        "  heat: {action: custom, sentences: ['set the oven to {n} degrees', '{n} ovens']}\n"
        "  door: {action: custom, sentences: ['shut the oven', 'the oven shut', 'halt']}\n"
    )
    grammar = SpokenGrammar(IntentEngine.from_files(file))
    assert SaidAndHeard(grammar, sentence.split(), [one.split() for one in heard]).begun_otherwise() == otherwise


@pytest.mark.parametrize(
    ("sentence", "heard", "otherwise"),
    [
        ("lead me back to entrance", "leave me back to entrance", ()),  # "me back" would be a thing
        ("lead the cup", "leave the cup", ()),  # so may this, of which nothing tells
        ("go to the kitchen", "drive to the kitten", ("drive",)),
    ],
)
def test_what_a_free_slot_would_take_begins_no_command(grammar, sentence, heard, otherwise):
    assert SaidAndHeard(grammar, sentence.split(), [heard.split()] * 2).begun_otherwise() == otherwise


@pytest.mark.parametrize(
    ("heard", "unheard"),
    [
        (["and two grams of salt"] * 2, ()),
        (["and two grams of salt", "two grams of salt"], ()),
        (["two grams of salt"] * 2, ("add",)),
        (["so two grams of salt"] * 2, ("add",)),
    ],
)
def test_a_verb_that_was_heard_as_a_little_word_before_a_number_was_heard(tmp_path, heard, unheard):
    file = tmp_path / "kitchen.yaml"
    file.write_text(
        "slots: {amount: number}\nintents: {add: {action: custom, sentences: ['add {amount} grams of salt']}}\n"
    )
    grammar = SpokenGrammar(IntentEngine.from_files(file))
    said = SaidAndHeard(grammar, ["add", "two", "grams", "of", "salt"], [one.split() for one in heard])
    assert said.begins_unheard() == unheard


@pytest.mark.parametrize(
    ("sentence", "heard", "left_out"),
    [
        ("lets turn around", ["it turns around"] * 2, ("it",)),
        ("oh let us go to the lounge", ["all of us went to the lounge"] * 2, ("all of us went",)),
        ("lets turn around", ["it turns around", "lets turn around"], ()),
        ("lets turn around", [], ()),
    ],
)
def test_what_all_heard_told_before_any_word_of_a_command(engine, sentence, heard, left_out):
    """The verb was heard in another form, so that nothing in it is the command's own beginning."""
    assert SaidAndHeard(SpokenGrammar(engine), sentence.split(), [one.split() for one in heard]).left_out() == left_out


@pytest.mark.parametrize(
    ("sentence", "heard", "left_out"),
    [
        ("let us turn left", ["let me turn left", "let us turn left"], ("let me",)),
        ("lets turn left", ["lets turn left", "please let him turn left"], ("let him",)),
        ("turn left", ["turn left", "let me turn left"], ("let me",)),
        ("let us turn left", ["let us turn left", "lets turn left"], ()),
        ("let us turn left", ["let my turn left", "let us turn left"], ()),
        ("let us turn left", ["let me burn left", "let us turn left"], ()),
    ],
)
def test_who_lets_somebody_do_it_says_what_he_does_himself(engine, sentence, heard, left_out):
    """One model is enough: it is done only if none heard it."""
    assert SaidAndHeard(SpokenGrammar(engine), sentence.split(), [one.split() for one in heard]).left_out() == left_out


def test_a_stop_and_what_is_as_good_as_sure_is_what_it_is(engine):
    grammar, other = SpokenGrammar(engine), [["go", "to", "the", "mountains"]] * 2
    assert not SaidAndHeard(grammar, ["stop"], [["somebody"], ["somebody"]]).heard_otherwise(0.8)
    kitchen = SaidAndHeard(grammar, ["go", "to", "the", "kitchen"], other)
    assert kitchen.heard_otherwise(0.8) == ("mountains",)
    assert not kitchen.heard_otherwise(0.99)


@pytest.mark.parametrize(
    ("sentence", "heard", "opposite"),
    [
        ("switch the fan on", ["switch the fan off"] * 2, ("off",)),
        ("switch the fan on", ["switch off the fan"] * 2, ("off",)),  # wherever it stands
        ("switch the fan on", ["switch the fan off", "switch the fan of"], ()),  # one may be wrong
        ("switch the fan on", ["switch the fan off", "switch the fan on"], ()),
        ("switch the fan on and the lamp off", ["switch the fan on and the lamp off"] * 2, ()),
        ("unlock the door", ["lock the door"], ("lock",)),  # a model that hears alone
        ("turn counter clockwise", ["turn counterclockwise"] * 2, ()),
        ("close the door", ["pause the door"] * 2, ()),
        ("stop", ["start"] * 2, ()),  # a stop waits for nothing
        ("switch the fan on", [], ()),
    ],
)
def test_a_command_is_not_the_opposite_of_what_all_heard(grammar, sentence, heard, opposite):
    assert SaidAndHeard(grammar, sentence.split(), [one.split() for one in heard]).opposite() == opposite


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("go forward almost two meters", ("almost",)),
        ("go forward twenty two meters", ("twenty",)),
        ("go forward please two meters", ()),  # means the same
        ("go forward um two meters", ()),
    ],
)
def test_what_all_heard_within_a_sentence_and_changes_it(grammar, heard, said):
    sentence = ["go", "forward", "two", "meters"]
    assert SaidAndHeard(grammar, sentence, [heard.split()] * 2).passed_over() == said


@pytest.mark.parametrize(
    ("sentence", "heard", "left_out"),
    [
        ("turn left", ["who turned left", "turn left"], ("who turned",)),
        ("please turn left", ["i turned left", "please turn left"], ("i turned",)),
        ("move forward", ["now move forward", "she moves forward"], ("she moves",)),
        ("move forward", ["i move forward", "move forward"], ()),  # in noise a word more is easily heard
        ("turn left", ["turned left", "turn left"], ()),
        ("turn left", ["who", "turn left"], ()),
        ("turn left", ["turn left, you turned", "turn left"], ()),
    ],
)
def test_a_person_and_the_form_that_fits_it_are_believed_of_one(grammar, sentence, heard, left_out):
    heard = [one.replace(",", "").split() for one in heard]
    assert SaidAndHeard(grammar, sentence.split(), heard).left_out() == left_out


@pytest.mark.parametrize(
    ("heard", "joint"),
    [
        (["turn left or move forward", "turn left and move forward"], ("and",)),
        (["turn left or move forward", "turn left move forward"], ("and",)),
        (["turn left and move forward", "turn or left and move forward"], ()),
        (["turn left and move forward"] * 2, ()),
        (["turn left an move forward"] * 2, ()),
    ],
)
def test_a_joint_is_asked_about_where_one_heard_an_or(grammar, heard, joint):
    words = ["turn", "left", "and", "move", "forward"]
    assert SaidAndHeard(grammar, words, [one.split() for one in heard]).either_heard() == joint


LAMPS = """
language: en
slots: {lamp: [lamp, fan]}
intents:
  "on": {action: custom, sentences: ["turn on the {lamp}"]}
"""


@pytest.mark.parametrize(
    ("sentence", "heard", "left_out"),
    [
        ("turn the lamp on", ["by turn the lamp on", "turn the lamp on"], ("by",)),
        ("turn the lamp on", ["e turned a land on", "turn the lamp on"], ("e",)),
        ("can you turn the lamp on", ["g turn the lamp on"] * 2, ("g",)),
        ("turn on the lamp and the fan", ["so we turn on the lamp and the fan", "on the lamp and the fan"], ("so we",)),
        ("turn on the lamp", ["by turn on the lamp", "turn on the lamp"], ()),  # as the grammar has it
        ("turn the lamp on", ["please turn the lamp on", "turn the lamp on"], ()),
        ("turn the lamp on", ["turn the lamp on"] * 2, ()),
    ],
)
def test_of_what_is_put_otherwise_one_model_that_heard_more_before_it_is_enough(engine_of, sentence, heard, left_out):
    grammar = SpokenGrammar(engine_of(LAMPS))
    assert SaidAndHeard(grammar, sentence.split(), [one.split() for one in heard]).left_out() == left_out
