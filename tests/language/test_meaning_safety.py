"""What is said is done, what is not said is not: a table of sentences, and laws about all others."""

from __future__ import annotations

import string
from dataclasses import replace

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from meanings import ROOT, commands, does, done, shipped

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.automaton import Automaton
from intent_engine.language.grammar import Grammar, Operators
from intent_engine.language.locations import load
from intent_engine.language.meaning import MAX_WORDS, Interpreter
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.correction import Corrections
from intent_engine.language.meaning.negation import Negations
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.run_on import RunOns
from intent_engine.language.meaning.stops import Stops
from intent_engine.language.utterance import Utterance

NOTHING = "nothing"
"""Stands for any status without an action."""

PLAIN = {
    "go forward": "forward 1",
    "go forward two meters": "forward 2",
    "back up a couple of feet": "back 0.6096",
    "turn left": "left 43",
    "turn right one eighty degrees": "right 180",
    "turn around": "left 180",
    "go to the kitchen": "to kitchen",
    "pick up the red cup": "pick red cup",
    "put the cup on the table": "place cup table",
    "follow me": "follow",
    "come back": "come",
    "come back two meters": "back 2",
    "turn slowly left": "left 21",
}
FILLED = {
    "uh go forward please": "forward 1",
    "could you please go to the kitchen": "to kitchen",
    "okay robot um turn left": "left 43",
    "so, like, turn, uh, left": "left 43",
    "hey robot, would you mind, go forward two uh meters": "forward 2",
    "uh": NOTHING,
    "please": NOTHING,
    "okay robot": NOTHING,
    "": NOTHING,
    "...": NOTHING,
    "[BLANK_AUDIO]": NOTHING,
    "(music)": NOTHING,
}
NEGATED = {
    "don't go forward": NOTHING,
    "do not go forward": NOTHING,
    "dont go forward": NOTHING,
    "please don't go forward": NOTHING,
    "don't you go forward": NOTHING,
    "you must not go forward": NOTHING,
    "you shouldn't go forward": NOTHING,
    "you cannot go forward": NOTHING,
    "I don't want you to go forward": NOTHING,
    "go forward not": NOTHING,
    "not go forward": NOTHING,
    "not forward": NOTHING,
    "go, not forward": NOTHING,
    "let's not go to the kitchen": NOTHING,
    "never go to the kitchen": NOTHING,
    "go to the kitchen never": NOTHING,
    "do not ever turn left": NOTHING,
    "no longer go forward": NOTHING,
    "go forward, no longer": NOTHING,
    "go forward without the cup": NOTHING,
    "without going forward": NOTHING,
    "go anywhere except the kitchen": NOTHING,
    "go to the kitchen, except now": NOTHING,
    "neither turn left": NOTHING,
    "neither turn left nor turn right": NOTHING,
    "nor turn left": NOTHING,
    "turn left, nor go forward": NOTHING,
    "nobody go forward": NOTHING,
    "nobody, go forward": NOTHING,
    "nothing, go forward": NOTHING,
    "nowhere, go forward": NOTHING,
    "nowhere near the kitchen": NOTHING,
    "turn left not right": NOTHING,
    "turn left and not right": NOTHING,
    "no turning left": NOTHING,
    "no left turn": NOTHING,
    "no turn left": NOTHING,
    "no go to the kitchen": NOTHING,
    "go forward but don't hit the wall": NOTHING,
    "go forward but not too far": NOTHING,
    "go not more than two meters forward": NOTHING,
    # Any words are the name of a thing, but not these.
    "pick up nothing": NOTHING,
    "look at nobody": NOTHING,
    "pick up neither cup": NOTHING,
    "pick up the cup nor the bottle": NOTHING,
    "take the cup nowhere": NOTHING,
    "pick up the cup without the lid": NOTHING,
    "pick up all except one": NOTHING,
    "pick up the cup no longer": NOTHING,
    "pick up the cup not the bottle": NOTHING,
    "pick up the cup never mind the bottle": NOTHING,
    "avoid the kitchen": NOTHING,
    "stay away from the kitchen": NOTHING,
    "go to the room that isn't the kitchen": NOTHING,
    "can't you go forward": NOTHING,
    "don't": NOTHING,
    "no": NOTHING,
    "not now": NOTHING,
    "no thanks": NOTHING,
    # What is wanted instead is done only where it is plain where the forbidden part ends.
    "don't turn left, turn right": "right 43",
    "don't turn left but turn right": "right 43",
    "don't turn left, instead turn right": "right 43",
    "don't turn left instead turn right": "right 43",
    "don't turn left just turn right": NOTHING,  # "just" is a filler
    "don't turn left rather turn right": "right 43",
    "don't turn left but rather turn right": "right 43",
    "don't turn left but instead turn right": "right 43",
    "don't turn left instead just turn right": "right 43",
    "don't turn left but do turn right": "right 43",
    "don't go to the kitchen, go to the bedroom": "to bedroom",
    "don't turn left turn right": NOTHING,
    "don't turn left and turn right": NOTHING,
    "don't turn left, and turn right": NOTHING,
    "don't turn left or turn right": NOTHING,
    "don't turn left, don't turn right": NOTHING,
    "turn right instead of left": NOTHING,
}
CORRECTED = {
    "turn left no right": "right 43",
    "turn left no turn right": "right 43",
    "turn left no no right": "right 43",
    "turn left no wait right": "right 43",
    "turn left actually right": "right 43",
    "turn left, sorry, right": "right 43",
    "turn left or rather right": "right 43",
    "turn left I mean right": "right 43",
    "turn left I meant right": "right 43",
    "turn left no I mean right": "right 43",
    "turn left oops right": "right 43",
    "turn left make that right": "right 43",
    "turn left correction right": "right 43",
    "turn left no right no left": "left 43",
    "turn left ninety no sixty degrees": "left 60",
    "turn left at point five radians per second no twenty degrees per second": "left 30",
    "turn left nine uh forty five degrees": NOTHING,
    "go forward five uh twenty meters": NOTHING,
    "turn left ninety degrees no right": "right 90",
    "go forward two meters no three meters": "forward 3",
    "go forward two meters no backward three meters": "back 3",
    "go forward two meters no turn left": "left 43",
    "go to the kitchen, I mean the bedroom": "to bedroom",
    "go to the kitchen no the bedroom": "to bedroom",
    "pick up the cup no the bottle": "pick bottle",
    "pick up the cup no put it down": "place",
    "pick up the cup make that the bottle": "pick bottle",
    "turn left and go forward no backward": "left 43, back 0.6",
    "no, turn left": "left 43",
    "actually turn left": "left 43",
    "no wait turn left": "left 43",
    "sorry, right": NOTHING,
    "no left": NOTHING,
    "grab the bottle from the table no the chair": NOTHING,
    # Taken back, with nothing in its place.
    "go forward no": NOTHING,
    "go forward, no.": NOTHING,
    "go forward no no": NOTHING,
    "go forward sorry": NOTHING,
    "go forward oops": NOTHING,
    "go forward I mean": NOTHING,
    "go forward no actually": NOTHING,
    "turn left no right no": NOTHING,
    "turn left and go forward no": NOTHING,
    "go forward wait": "stop",
    "go to the kitchen no wait": "stop",
    "go forward for two seconds, wait a minute": "stop",
    "go forward, hold on": "stop",
    "he said wait": NOTHING,
    "don't wait": NOTHING,
}
CANCELLED = {
    "go forward never mind": NOTHING,
    "go forward nevermind": NOTHING,
    "go forward, cancel": NOTHING,
    "go forward cancel that": NOTHING,
    "go forward forget it": NOTHING,
    "go forward forget about it": NOTHING,
    "go forward scratch that": NOTHING,
    "go forward do not": NOTHING,
    "go forward, no don't": NOTHING,
    "go forward do not do that": NOTHING,
    "go forward disregard that": NOTHING,
    "go forward ignore that": NOTHING,
    "go forward belay that": NOTHING,
    "go forward skip it": NOTHING,
    "go forward drop it": NOTHING,
    "go forward leave it": NOTHING,
    "turn left and go forward never mind": NOTHING,
    "pick up the cup forget it": NOTHING,
    "pick up the cup scratch that": NOTHING,
    "go to the kitchen, on second thought": NOTHING,
    "go to the kitchen just kidding": NOTHING,
    "cancel that": "stop",
    "never mind": "stop",
    "wait": "stop",
}
COMPOUND = {
    "go forward two meters then turn left": "forward 2, left 43",
    "go forward two meters and turn left and pick up the cup": "forward 2, left 43, pick cup",
    "turn left, go forward": "left 43, forward 1",
    "first turn left and then go forward": "left 43, forward 1",
    "turn left and then go to the kitchen": "left 43, to kitchen",
    "turn left after that go forward": "left 43, forward 1",
    "turn left and finally go forward": "left 43, forward 1",
    "turn left next go forward": "left 43, forward 1",
    "go to the kitchen and when you get there turn left": "to kitchen, left 43",
    "go forward then stop": "forward 1",
    "go to the kitchen and wait there": "to kitchen",
    "go to the kitchen and wait": "to kitchen",
    "go forward and": NOTHING,
    "turn left and then": NOTHING,
    "and then": NOTHING,
    "go forward and dance": NOTHING,
    "dance and go forward": NOTHING,
    "go forward then sing a song then turn left": NOTHING,
    "go forward then don't turn left": NOTHING,
    "go to the moon and turn left": NOTHING,
    "turn left and go to the moon": NOTHING,
    "turn left or turn right": NOTHING,
    "either turn left or turn right": NOTHING,
    "turn left or right": NOTHING,
    "go to the kitchen or the bedroom": NOTHING,
}
CONTINUED = {
    # To a place: no repetition of what was done last.
    "continue to the kitchen": "to kitchen",
    "carry on to the kitchen": "to kitchen",
    "keep going to the kitchen": "to kitchen",
    "go on to the kitchen": "to kitchen",
    "continue": "again",
    "carry on": "again",
    "keep going": "again",
    "continue forward": "forward 1",
    "keep going back": "back 0.6",
    "carry on to the moon": NOTHING,
    "continue to the moon": NOTHING,
    "keep going to the": NOTHING,
    "continue to": NOTHING,
    "don't continue to the kitchen": NOTHING,
    "I continued to the kitchen": NOTHING,
    "take over": NOTHING,
}
RUN_ON = {
    "go forward turn left": "forward 1, left 43",
    "turn left go forward two meters": "left 43, forward 2",
    "forward two meters turn left": "forward 2, left 43",
    "turn left ninety go forward two meters": "left 90, forward 2",
    "turn left go forward turn right": "left 43, forward 1, right 43",
    "uh turn left um go forward please": "left 43, forward 1",
    "can you go to the kitchen turn around": "to kitchen, left 180",
    "pick up the cup go to the kitchen": "pick cup, to kitchen",
    "pick up the cup go forward": "pick cup, forward 1",
    "go to the kitchen pick up the red cup": "to kitchen, pick red cup",
    "get the book from the table turn left go forward": "pick book, left 43, forward 1",
    "put it down go back two meters": "place, back 2",
    # What could be parted in two ways, or be a correction or an echo.
    "turn left ninety two meters forward": NOTHING,
    "turn left two meters ahead": NOTHING,
    "go to the kitchen two meters ahead": NOTHING,
    "move forward slowly turn left": NOTHING,
    "turn left i need two meters forward": NOTHING,
    "go forward wait for me at the kitchen": NOTHING,
    "wait for me at the kitchen turn left": NOTHING,
    "turn left turn right": NOTHING,
    "turn left turn left": NOTHING,
    "go to the kitchen go to the bedroom": NOTHING,
    "turn left go forward turn left go forward": NOTHING,
    "keep going go forward": NOTHING,
    "go forward forward": NOTHING,
    # No words are the name of a thing and a command, nor a name that nobody can be sure of.
    "pick up the go forward button": NOTHING,
    "take the box back go to the kitchen": NOTHING,
    "pick up the cup slowly go to the kitchen": NOTHING,
    "pick up the thing you know go forward": NOTHING,
    "pick up the cup it is red go to the kitchen": NOTHING,
    # Half of it is nothing.
    "turn left go to the moon": NOTHING,
    "go to the kitchn turn left": NOTHING,
    "turn left go": NOTHING,
    "dance turn left": NOTHING,
    # What changes a sentence changes these.
    "don't turn left go forward": NOTHING,
    "turn left don't go forward": NOTHING,
    "do not ever go forward turn left": NOTHING,
    "go forward turn left no": NOTHING,
    "go forward turn left never mind": NOTHING,
    "go forward turn left if you see me": NOTHING,
    "he said go forward turn left": NOTHING,
    "when I say so go forward turn left": NOTHING,
    "I went forward turned left": NOTHING,
    "you go forward turn left": NOTHING,
    "did you go forward turn left": NOTHING,
    "he told me go forward turn left": NOTHING,
    "the command is go forward turn left": NOTHING,
    "go forward turn left stop": "stop",
    "go forward stop turn left go back": "stop",
    "stop go forward turn left": "stop",
    "turn left turn left stop": "stop",
    "move forward slowly turn left stop": "stop",
}
UNFINISHED = {
    "pick up the": NOTHING,
    "pick up a": NOTHING,
    "pick up a cup of": NOTHING,
    "bring me my": NOTHING,
    "put the cup on the": NOTHING,
    "grab the bottle from the": NOTHING,
    "go to the": NOTHING,
    "turn": NOTHING,
    "go forward two": NOTHING,
    "pick up box a": "pick box a",
    "pick up that": "pick that",
}
MISHEARD = {
    "go to the kichen": "to kitchen",
    "turn lft": "left 43",
    "turn write": "right 43",
    "go forward two feed": "forward 0.6096",
    # One word, and not heard as it is.
    "lft": NOTHING,
    "bak": NOTHING,
    "please lft": NOTHING,
    # Nothing is guessed beside a word that changes what is meant.
    "don't go to the kichen": NOTHING,
    "turn lft if you can see me": NOTHING,
}
REPORTED = {
    "he said go forward": NOTHING,
    "he said, go forward": NOTHING,
    "she told me to turn left": NOTHING,
    "I said go forward": NOTHING,
    "they say turn left": NOTHING,
    "my brother said turn left": NOTHING,
    "tell him to go forward": NOTHING,
    "the command is go forward": NOTHING,
    "repeat after me go forward": NOTHING,
    "remember to turn left": NOTHING,
    "pretend to go forward": NOTHING,
    "he said stop": NOTHING,
    "mom said stop": NOTHING,
    "tell her to stop": NOTHING,
}
CONDITIONAL = {
    "if the door is open go forward": NOTHING,
    "go forward if the door is open": NOTHING,
    "if you see a cup, pick it up": NOTHING,
    "when I say go, go forward": NOTHING,
    "turn left when you see the door": NOTHING,
    "go forward until you see the wall": NOTHING,
    "go forward while turning": NOTHING,
    "unless it is dark go forward": NOTHING,
    "turn left before you go forward": NOTHING,
    "go forward after turning left": NOTHING,
    "tomorrow go to the kitchen": NOTHING,
    "go forward in five minutes": NOTHING,
    "go forward later": NOTHING,
    "when i say stop": NOTHING,
}
QUESTIONS = {
    "did you go forward": NOTHING,
    "should I go forward": NOTHING,
    "what is forward": NOTHING,
    "why did you turn left": NOTHING,
    "where is the kitchen": NOTHING,
    "how do I go to the kitchen": NOTHING,
    "who went to the kitchen": NOTHING,
    "is the kitchen on the left": NOTHING,
    "are you going to the kitchen": NOTHING,
    "what happens if you go forward": NOTHING,
    "what did the bus do when it went forward": NOTHING,
    "should I stop": NOTHING,
    "why did you stop": NOTHING,
    "shall we go to the kitchen": NOTHING,
    # Questions in form only.
    "can you go to the kitchen": "to kitchen",
    "will you turn left?": "left 43",
    "can you stop?": "stop",
}
TALK = {
    # Past tense.
    "I was going to go to the kitchen": NOTHING,
    "I went forward two meters": NOTHING,
    "you went forward": NOTHING,
    "you turned left": NOTHING,
    "the robot turned left": NOTHING,
    "yesterday you went to the kitchen": NOTHING,
    "could you have gone forward": NOTHING,
    "you were turning left": NOTHING,
    # Others than the robot.
    "he goes to the kitchen": NOTHING,
    "they moved forward": NOTHING,
    "it moves forward": NOTHING,
    "I am going to the kitchen": NOTHING,
    "we're going to the kitchen": NOTHING,
    "they're moving forward": NOTHING,
    "you go forward": NOTHING,
    # Words of commands in other senses.
    "that's right": NOTHING,
    "you are right": NOTHING,
    "what's left": NOTHING,
    "left over food": NOTHING,
    "back to work": NOTHING,
    "ahead of time": NOTHING,
    "all right": NOTHING,
    "turn off the lights": NOTHING,
    "turn up the volume": NOTHING,
    "forward the email": NOTHING,
    "take a break": NOTHING,
    "take it easy": NOTHING,
    "take care": NOTHING,
    "get lost": NOTHING,
    "get away from me": NOTHING,
    "drop please": NOTHING,
    "grab uh": NOTHING,
    "take a picture": NOTHING,
    "go to sleep": NOTHING,
    "walk the dog": NOTHING,
    "call mom": NOTHING,
}
STOP = {
    "stop": "stop",
    "Stop!": "stop",
    "STOP": "stop",
    "stop stop stop": "stop",
    "stopstop": NOTHING,
    "please stop": "stop",
    "robot stop": "stop",
    "stop robot": "stop",
    "can you please stop": "stop",
    "stop now": "stop",
    "stop it": "stop",
    "stop right there right there": "stop",
    "stop turning left": "stop",
    "stop moving forward": "stop",
    "stop turning completely around": "stop",
    "stop brake at once": "stop",
    "stop, about face": "stop",
    "no stop": "stop",
    "no no no no stop": "stop",
    "wait stop": "stop",
    "uh stop": "stop",
    "oh my god stop": "stop",
    "whoa": "stop",
    "whoa whoa": "stop",
    "whoa there": "stop",
    "halt": "stop",
    "freeze": "stop",
    "abort": "stop",
    "hold it": "stop",
    "hold on": "stop",
    "emergency stop": "stop",
    "e-stop": "stop",
    "I said stop!": "stop",
    "abort mission": "stop",
    "hold on a second": "stop",
    "[stop]": "stop",
    # In every position.
    "go forward stop": "stop",
    "go forward. Stop": "stop",
    "go forward, stop": "stop",
    "go forward no stop": "stop",
    "go forward two stop": "stop",
    "go to the stop": "stop",
    "turn left stop turn right": "stop",
    "turn left stop turn right stop turn left": "stop",
    "stop turn left": "stop",
    "stop, turn left": "stop",
    "stop and turn left": "stop",
    "stop then go forward": "stop",
    "no stop, go forward": "stop",
    "turn left then stop then turn right": "stop",
    "pick up the stop": "stop",
    "pick up the cup stay where you are": "stop",
    # Nothing said in the same breath takes it back.
    "stop no go forward": "stop",
    "stop wait turn left": "stop",
    "stop don't move": "stop",
    "stop, don't": "stop",
    "stop, never mind": "stop",
    "don't go forward stop": "stop",
    "don't stop, stop": "stop",
    # And what is no command to stop.
    "don't stop": NOTHING,
    "do not stop": NOTHING,
    "never stop": NOTHING,
    "don't ever stop": NOTHING,
    "no don't stop": NOTHING,
    "I can't stop": NOTHING,
    "it won't stop": NOTHING,
    "the bus stop": NOTHING,
    "go to the bus stop": NOTHING,
    "where is the bus stop": NOTHING,
    "pick up the stop sign": NOTHING,
    "stop the music": NOTHING,
    "stop by the kitchen": NOTHING,
    "nonstop": NOTHING,
    "stopp": NOTHING,
    "pull out all the stops": NOTHING,
    "don't stop, go forward": "forward 1",
}
LIKE_STOP = dict.fromkeys(
    [
        *(
            "shop",
            "top",
            "stock",
            "step",
            "stops",
            "stopper",
            "stomp",
            "strop",
            "stoop",
            "stub",
            "chop",
            "hop",
        ),
        *("hall", "the hall", "halts", "hold", "holt", "hault", "salt", "malt", "fault", "call my mother", "tall"),
        *("weight", "wade", "way", "a bort", "report", "frieze", "breeze", "free", "woe", "whoever", "bake", "break"),
        *("the shop", "to the top", "at the top", "the stock", "one step", "step by step", "non stop", "stop sign"),
    ],
    NOTHING,
)
TABLE = {
    **PLAIN,
    **FILLED,
    **NEGATED,
    **CORRECTED,
    **CANCELLED,
    **COMPOUND,
    **CONTINUED,
    **RUN_ON,
    **UNFINISHED,
    **LIKE_STOP,
    **MISHEARD,
    **REPORTED,
    **CONDITIONAL,
    **QUESTIONS,
    **TALK,
    **STOP,
}


def matches(meant: str, found: str) -> bool:
    return found in (Status.REJECTED, Status.INCOMPLETE, Status.AMBIGUOUS) if meant == NOTHING else found == meant


@pytest.mark.parametrize(("text", "meant"), TABLE.items())
def test_a_sentence_of_the_table(text: str, meant: str) -> None:
    assert matches(meant, does(text)), f"{text!r}: {does(text)}, not {meant}"


WHILE_MOVING = [
    *("stop the music", "stop by the kitchen", "whoa what was that", "freeze, he said"),
    *("uh robot stop the music", "no stop the music"),
]


@pytest.mark.parametrize("text", WHILE_MOVING)
def test_while_the_robot_moves_whatever_begins_with_a_stop_word_stops_it(text: str) -> None:
    assert does(text, "moving") == "stop"
    assert matches(NOTHING, does(text))


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
def test_commands_in_one_breath_are_done_only_if_they_can_be_parted_in_one_way(text: str) -> None:
    """A reference that tries every way to cut the words into commands, each understood for itself."""
    found = shipped().parse(text)
    if found.intent != "compound" or not shipped()._interpreter(None)._run_ons.split(Utterance.of(text), ()):
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
    found = shipped().parse(text, state=("moving",))
    assert not any(isinstance(action, Stop) for action in found.actions) or any(
        reading.intent.action.type == "stop" for reading in shipped().matcher().read(said)
    )


words = st.text(st.characters(categories=["L", "N", "P", "S", "M"]), min_size=1, max_size=12)


@quick
@given(st.lists(words, max_size=8).map(" ".join), stop_words)
def test_a_stop_word_before_anything_stops_a_moving_robot(rest: str, stop: str) -> None:
    assert does(f"{stop} {rest}", "moving") == "stop"


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
        core = Utterance.of(text).without(shipped()._interpreter(None).phrases.fillers).words
        readings = shipped().matcher().read(core)
        ends = operators.sequence and any(" ".join(words) in text for words in operators.sequence)
        assert readings or ends or isinstance(found.actions[0], Stop)


# -- cost -----------------------------------------------------------------------------------------------------


@pytest.fixture
def steps(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Counts the words that automata read."""
    count = [0]

    def counted(name: str) -> None:
        original = getattr(Automaton, name)

        def call(self: Automaton, words: list[str]) -> object:
            count[0] += len(words) + 1
            return original(self, words)

        monkeypatch.setattr(Automaton, name, call)

    counted("read")
    counted("walk")
    return count


HARD = [
    *("turn left and", "turn left, and", "turn left,", "no turn left", "turn left no right", "don't turn left,"),
    *(
        "stop turn left",
        "stop",
        "no",
        "and",
        "uh",
        "then and",
        "one hundred",
        "go two two two",
        "never mind",
        "not but",
    ),
    *("go forward turn left", "turn left go", "pick up the cup go forward", "turn left slowly go forward"),
    *("pick up the cup no the bottle and", "go to the kitchn and", "go to the kitchn,", "go forward stop turn left"),
]


@pytest.mark.parametrize("unit", HARD)
def test_the_work_for_the_longest_utterance_is_bounded(unit: str, steps: list[int]) -> None:
    for length in (10, 20, 40, MAX_WORDS):
        steps[0] = 0
        shipped().parse(" ".join((unit.split() * MAX_WORDS)[:length]))
        assert steps[0] <= 6 * length * length + 40 * length


@pytest.mark.parametrize("unit", [*HARD, "\x00", "½", "ß", "go forward ", "1,", "-", "("])
def test_what_is_longer_than_any_command_is_not_even_read(
    unit: str, steps: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(text: str) -> None:
        raise AssertionError("a text of a megabyte was taken apart")

    monkeypatch.setattr(Utterance, "of", never)
    found = shipped().parse((unit * (1_000_000 // len(unit) + 1))[:1_000_000])
    assert found.status is Status.REJECTED
    assert "longer than any command" in found.reason
    assert steps[0] == 0


def test_many_words_in_few_characters_are_not_parsed(steps: list[int]) -> None:
    found = shipped().parse("a " * (MAX_WORDS + 1))
    assert found.status is Status.REJECTED
    assert steps[0] == 0


# -- every rule is needed -------------------------------------------------------------------------------------


def engine_with(grammar: Grammar) -> IntentEngine:
    return IntentEngine([grammar], load(ROOT / "locations" / "home.yaml"))


def failures(engine: IntentEngine, rows: dict[str, str]) -> list[str]:
    return [text for text, meant in rows.items() if not matches(meant, done(engine.parse(text)))]


@pytest.mark.parametrize("words", shipped().grammar.operators.negation, ids=" ".join)
def test_the_table_fails_without_a_word_of_negation(words: tuple[str, ...]) -> None:
    grammar = shipped().grammar
    operators = grammar.operators
    broken = replace(
        operators,
        negation=tuple(other for other in operators.negation if other != words),
        closed=operators.closed - set(words) if len(words) == 1 else operators.closed,
    )
    assert failures(engine_with(replace(grammar, operators=broken)), {**NEGATED, **STOP}), f"nothing needs {words}"


@pytest.mark.parametrize("name", ["negation", "correction", "cancel", "sequence", "contrast", "stop"])
def test_the_table_fails_without_a_list_of_operators(name: str) -> None:
    grammar = shipped().grammar
    broken = replace(grammar.operators, **{name: ()})
    assert failures(engine_with(replace(grammar, operators=broken)), TABLE)


def test_an_english_grammar_has_its_operators_whatever_its_author_writes() -> None:
    assert shipped().grammar.operators != Operators()


ALL_WAYS = RunOns._ways
RULES = {
    # Rule -> what it says when it is broken.
    (Negations, "wanted"): lambda self, core, state: (core, ""),
    (Phrases, "negated_before"): lambda self, words, position: False,
    (Stops, "in_a_sentence"): lambda self, core: False,
    (Stops, "_corrected_after"): lambda self, words, position: False,
    (Stops, "between"): lambda self, said, state: False,
    (Stops, "_only_commands"): lambda self, part, state: True,
    (Phrases, "joined_before"): lambda self, words, position: False,
    (Stops, "_clause_begins"): lambda self, words, start, position: True,
    (Phrases, "after_opening"): lambda self, words: 0,
    (Phrases, "only_stops"): lambda self, words, position: bool(words[position:]),
    (Interpreter, "_number_restarted"): lambda self, core: False,
    (Corrections, "_pause_after"): lambda self, part, position: True,
    (Corrections, "corrected"): lambda self, part, state: None,
    (Corrections, "_corrected_before"): lambda self, part, state: None,
    (Corrections, "_grafted"): lambda self, slot, at, meant, whole: False,
    (Corrections, "taken_back"): lambda self, words: 0,
    (Compounds, "split"): lambda self, core, state: None,
    (RunOns, "split"): lambda self, core, state: None,
    (RunOns, "_is_certain"): lambda self, clause, start: clause.accepted,
    (RunOns, "_is_thing"): lambda self, slot, reading: True,
    (RunOns, "_said_twice"): lambda self, parts: False,
    (RunOns, "_ways"): lambda self, core: ALL_WAYS(self, core)[-1:],
    (Commands, "holds_command"): lambda self, reading, words=(): False,
    (Phrases, "operate_in"): lambda self, words: False,
    (Stops, "heard"): lambda self, said, state: False,
}


@pytest.mark.parametrize(("rule", "name"), RULES, ids=[f"{rule.__name__}.{name}" for rule, name in RULES])
def test_the_table_fails_without_a_rule(rule: type, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert hasattr(rule, name)
    assert not failures(shipped(), TABLE)
    monkeypatch.setattr(rule, name, RULES[rule, name])
    moving = [text for text in WHILE_MOVING if does(text, "moving") != "stop"]
    assert moving or failures(shipped(), TABLE), f"no sentence of the table needs {rule.__name__}.{name}"


FILLER_WORDS = {words[0] for words in shipped().grammar.fillers if len(words) == 1}


@pytest.mark.parametrize("word", sorted(shipped().grammar.operators.closed - FILLER_WORDS))
def test_a_closed_word_is_part_of_no_thing(word: str) -> None:
    text = f"pick up the cup {word} bottle"
    grammar = shipped().grammar
    broken = replace(grammar.operators, closed=grammar.operators.closed - {word})
    bare = replace(broken, negation=(), correction=(), cancel=(), sequence=(), contrast=(), stop=())
    assert "cup" not in does(text) or "bottle" not in does(text)
    assert done(engine_with(replace(grammar, operators=bare)).parse(text)) == f"pick cup {word} bottle"
