"""What is said is done, what is not said is not: a table of sentences, and laws about all others."""

from __future__ import annotations

import string

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from meanings import ROOT, commands, does, done, shipped
from safety_table import MOTION_FORBIDDEN, NOT_EVEN_MOVING, NOTHING, TABLE, WHILE_MOVING, matches

from intent_engine.actions import Move, Navigate, Stop, Turn
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.meaning.corrections.said_twice import said_once
from intent_engine.language.numbers.english_words import NUMBER_WORDS, ZERO
from intent_engine.language.utterance import Utterance


@pytest.mark.parametrize(("text", "meant"), TABLE.items())
def test_a_sentence_of_the_table(text: str, meant: str) -> None:
    assert matches(meant, does(text)), f"{text!r}: {does(text)}, not {meant}"


@pytest.mark.parametrize("text", WHILE_MOVING)
def test_while_the_robot_moves_whatever_begins_or_ends_with_a_stop_word_stops_it(text: str) -> None:
    assert does(text, "moving") == "stop"
    assert matches(NOTHING, does(text))


@pytest.mark.parametrize("text", MOTION_FORBIDDEN)
def test_while_the_robot_moves_a_forbidden_motion_stops_it(text: str) -> None:
    assert does(text, "moving") == "stop"
    assert matches(NOTHING, does(text))


@pytest.mark.parametrize("said", ["{}", "no, {}!", "hey {}", "{} {}"])
def test_what_only_takes_back_stops_a_moving_robot_of_every_grammar(said: str) -> None:
    """Also of one that has no command for it, in the words of its language."""
    waving = IntentEngine.from_files(ROOT / "examples" / "custom_command.yaml")
    for phrase in waving.grammar.operators.cancel:
        text = said.replace("{}", " ".join(phrase))
        assert done(waving.parse(text, state=["moving"])) == "stop", text
        assert not waving.parse(text).actions, text


@pytest.mark.parametrize("text", NOT_EVEN_MOVING)
def test_but_not_what_denies_a_stop_or_only_names_one(text: str) -> None:
    assert does(text, "moving") != "stop"


# -- laws -----------------------------------------------------------------------------------------------------


quick = settings(max_examples=120, deadline=None)
NEGATIONS = [
    *("don't {}", "do not {}", "never {}", "please don't {}", "uh don't {}", "you must not {}", "you should never {}"),
    *("{} not", "not {}", "don't you {}", "I don't want you to {}", "don't ever {}", "{}, no", "{} never mind"),
    *("robot do not {} please", "do not, under any circumstances, {}", "without {}", "nobody {}", "won't {}"),
]


@quick
@given(commands(), st.sampled_from(NEGATIONS))
def test_a_negated_command_moves_nothing(command: str, negated: str) -> None:
    found = shipped().parse(negated.format(command))
    assert all(isinstance(action, Stop) for action in found.actions), done(found)


@quick
@given(commands(), st.sampled_from(["don't {}", "do not {}", "please don't {}", "Robot, don't {}!"]))
@example("my anti clockwise oh turn", "don't {}")
def test_a_moving_robot_stops_where_a_motion_is_forbidden(command: str, negated: str) -> None:
    found = shipped().parse(command)
    assume(found.actions and all(isinstance(action, (Move, Turn, Navigate)) for action in found.actions))
    assume(len(found.actions) == 1 and found.confidence == 1.0)
    assume(not command[:1].isdigit() and not {*NUMBER_WORDS, *ZERO}.intersection(command.lower().split()[:1]))
    assert does(negated.format(command), "moving") == "stop", command


ALTERNATIVES = ["{} or the {}", "{} or a {}", "{}, the {}", "{} the {}", "{} or {}"]
things = st.sampled_from(["cup", "red cup", "bottle", "box", "screwdriver", "bottle of water"])


@quick
@given(
    st.sampled_from(
        ["pick up the {}", "bring me the {}", "put the {} on the table", "put the cup on the {}", "drop the {}"]
    ),
    things,
    things,
    st.sampled_from(ALTERNATIVES),
)
def test_two_things_are_no_one_thing(command: str, one: str, other: str, form: str) -> None:
    assert not shipped().parse(command.format(form.format(one, other))).actions


TAILS = [
    *("in five minutes", "at noon", "later", "someday", "eventually", "on Mondays", "every day", "this afternoon"),
    *("in case of fire", "on my signal", "on the count of three", "if you dare", "as soon as I leave", "until I clap"),
    *("said Tom", "he said", "means something", "is a joke", "as usual", "for fun", "in your dreams", "in theory"),
    *("or so", "huh", "where", "really", "seriously", "or else", "three times a day", "like yesterday"),
]


@quick
@given(commands(), st.sampled_from(TAILS))
@example("turn counterclockwise", "in five minutes")
@example("normally advance ahead", "in five minutes")
@example("drive straight ahead", "in five minutes")
@example("turn right ninety degrees", "every day")
@example("go to the charging station", "huh")
@example("pick up the cup", "as usual")
def test_a_command_that_goes_on_with_when_or_what_of_it_is_none(command: str, tail: str) -> None:
    found = shipped().parse(f"{command} {tail}")
    assert all(isinstance(action, Stop) for action in found.actions), done(found)


@quick
@given(commands(), commands(), st.sampled_from([" and ", ", then ", " and then ", ". "]))
def test_a_negated_part_moves_nothing_of_the_whole(first: str, second: str, joint: str) -> None:
    for text in (f"{first}{joint}don't {second}", f"don't {first} and {second}"):
        found = shipped().parse(text)
        assert all(isinstance(action, Stop) for action in found.actions), (text, done(found))


@quick
@given(commands(), commands(), st.sampled_from(NEGATIONS))
def test_commands_in_one_breath_are_negated_together(first: str, second: str, negated: str) -> None:
    found = shipped().parse(negated.format(f"{first} {second}"))
    assert all(isinstance(action, Stop) for action in found.actions), done(found)


@quick
@given(st.lists(commands(), min_size=2, max_size=3).map(" ".join))
@example("go forward turn left")
@example("pick up the cup go to the kitchen")
@example("about face your anti clockwise lead me to base station")
def test_commands_in_one_breath_are_done_only_if_they_can_be_parted_in_one_way(text: str) -> None:
    """A reference that tries every way to cut the words into commands, each understood for itself."""
    found = shipped().parse(text)
    parted = found.intent == "compound" and shipped()._interpreter(None)._run_ons.split(Utterance.of(text), ())
    if not (parted and found.actions):  # "ease off u turn": a speed is said by itself
        return
    words = text.split()

    def ways(start: int) -> list[list[str]]:
        if start == len(words):
            return [[]]
        onward = []
        for end in range(start + 2, len(words) + 1):
            part = shipped().parse(" ".join(words[start:end]))
            if len(part.actions) == 1 and part.confidence == 1.0 and part.intent != "compound":
                onward.extend([done(part), *rest] for rest in ways(end))
        return onward

    assert done(found) in {", ".join(way) for way in ways(0)}


STOPPING = ["{1}, {0}", "{1} {0}", "{0} {1}", "{0}, {1}", "{0}. {1}!", "{0} no {1}", "{1} {1} {1}", "{0} {1} {0}"]
stop_words = st.sampled_from([" ".join(words) for words in shipped().grammar.operators.stop])


@quick
@given(commands(), stop_words, st.sampled_from(STOPPING))
@example("go forward", "stop", "{0} {1}")
@example("go forward one meter and eight oh eight centimeters", "stop", "{1}, {0}")
@example("lift up cup off of cup off of cup", "stop", "{1} {0}")
@example("lift up cup off of cup off of cup", "stop", "{0} {1}")
def test_a_stop_word_before_or_after_a_command_stops(command: str, stop: str, form: str) -> None:
    text = form.format(command, stop)
    assert does(text) == "stop", text


@quick
@given(stop_words, st.data())
def test_what_is_only_like_a_stop_word_is_none(stop: str, data: st.DataObject) -> None:
    """Text is taken as it is: a letter more, less or other, and nothing stops, nor moves."""
    place = data.draw(st.integers(0, len(stop) - 1))
    letter = data.draw(st.sampled_from(string.ascii_lowercase))
    other = data.draw(st.sampled_from(["", letter, letter + stop[place], stop[place] + letter]))
    text = stop[:place] + other + stop[place + 1 :]
    stops = shipped().grammar.operators.stop
    said = Utterance.of(text).words
    assume(all(" ".join(words) not in " ".join(said) for words in stops))
    assume("".join(said) not in {"".join(words) for words in stops})  # "standstill" is written together, no other
    found = shipped().parse(text, state=("moving",))
    assert not any(isinstance(action, Stop) for action in found.actions) or any(
        reading.intent.action.type == "stop" for reading in shipped().matcher().read(said)
    )


words = st.text(st.characters(categories=["L", "N", "P", "S", "M"]), min_size=1, max_size=12)


@quick
@given(st.lists(words, max_size=8).map(" ".join), stop_words)
def test_a_stop_word_before_anything_stops_a_moving_robot(rest: str, stop: str) -> None:
    assert does(f"{stop} {rest}", "moving") == "stop"


@quick
@given(st.lists(words, max_size=8).map(" ".join), stop_words)
def test_a_stop_word_after_anything_stops_a_moving_robot(rest: str, stop: str) -> None:
    """But a denial ("don't stop"), the end of a list of commands ("and then stop") and the name of a place."""
    said = Utterance.of(rest).words
    operators = shipped().grammar.operators
    assume(not any(word in denial for denial in (*operators.negation, *operators.sequence) for word in said))
    assume(len(Utterance.of(f"{rest} {stop}").words) > len(said))
    assert does(f"{rest} {stop}", "moving") == "stop"


@settings(max_examples=300, deadline=None)
@given(st.text(max_size=200))
@example("\x00\x07\x1b[31m")
@example("\ud800")
@example("İ" * 50)
@example("½" * 50)
@example("1/0 meters")
@example("go forward 1/0 meters")
@example("go forward " + "9" * 400 + " meters")
@example("go forward 1e400 meters")
@example("go forward ٣ meters")
@example("\u202ego forward\u202c")
def test_no_text_raises(text: str) -> None:
    for state in ((), ("moving",)):
        found = shipped().parse(text, state=state)
        assert bool(found.actions) == (found.status is Status.ACCEPTED)
        assert found == shipped().parse(text, state=state)


@settings(max_examples=200, deadline=None)
@given(st.text(st.characters(exclude_characters=string.ascii_letters, max_codepoint=0x2FFF), max_size=60))
def test_text_without_a_letter_of_the_language_does_nothing(text: str) -> None:
    assume(not any(character.isascii() and character.isalpha() for character in Utterance.of(text).words))
    if not any(word.isascii() and word.isalpha() for word in Utterance.of(text).words):
        assert not shipped().parse(text).actions


VOCABULARY = sorted(
    {word for text in TABLE for word in Utterance.of(text).words} | {"meters", "two", "degrees", "and", "uh", "the"}
)


@settings(max_examples=300, deadline=None)
@given(st.lists(st.sampled_from(VOCABULARY), min_size=1, max_size=9))
@example(["slightly", "slightly", "write"])
@example(["go", "go", "back"])
def test_words_at_random_do_what_their_parts_say_or_nothing(said: list[str]) -> None:
    """An accepted utterance is made of commands: without stop words, negations and corrections, every part is one."""
    text = " ".join(said)
    found = shipped().parse(text)
    if not found.actions:
        return
    operators = shipped().grammar.operators
    plain = {words for words in (*operators.negation, *operators.correction, *operators.stop) if len(words) == 1}
    if found.intent == "compound":
        assert len(found.slots["steps"]) == len(found.actions) > 1
    elif not plain & {(word,) for word in said} and found.confidence == 1.0:
        phrases, said_so = shipped()._interpreter(None).phrases, Utterance.of(text)
        # "Turn right now" is "turn right", now; and "go go back" is "go back", begun twice.
        ways = [phrases.without_fillers(said_so), phrases.without_whole_fillers(said_so)]
        ways += [once for way in ways if (once := said_once(way, lambda start, end: True)) is not None]
        readings = [reading for way in ways for reading in shipped().matcher().read(way.words, loose=True)]
        ends = operators.sequence and any(" ".join(words) in text for words in operators.sequence)
        assert readings or ends or isinstance(found.actions[0], Stop)
