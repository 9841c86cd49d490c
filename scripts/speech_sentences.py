"""Sentences for synthetic voices: commands as people say them, samples of a grammar, and speech that is no command."""

from __future__ import annotations

import random
import re
import sys
from collections.abc import Sequence
from typing import Any

from intent_engine.actions import to_json
from intent_engine.engine import IntentEngine
from intent_engine.evaluation.labels import COMPOUND
from intent_engine.interpretation import Status
from intent_engine.language.sampler import sample

FRAMES = {
    "stop": """
        stop
        stop now
        robot stop
        please stop
        stop moving
        halt
        freeze
        wait
        stop right there
        cancel that
        stop stop stop
    """,
    "move": """
        go forward
        move backward
        go forward {distance}
        move forward {distance}
        go back {distance}
        drive forward {distance}
        move backward {distance}
        move ahead {distance}
        go straight for {duration}
        drive backward for {duration}
        back up {distance}
        go forward {distance} at {speed}
        please move forward {distance}
        could you go back {distance}
        robot drive ahead {distance}
    """,
    "turn": """
        turn left
        turn right
        turn around
        turn left {angle}
        turn right {angle}
        rotate left {angle}
        rotate {angle} to the right
        spin right {angle}
        turn {angle} left
        please turn right {angle}
        turn left for {duration}
    """,
    "navigate": """
        go to the {place}
        navigate to the {place}
        drive to the {place}
        please go to the {place}
        take me to the {place}
        head to the {place}
        could you go to the {place}
        robot go to the {place}
        go back to the {place}
        return to the {place}
    """,
    "pick": """
        pick up the {thing}
        grab the {thing}
        take the {thing} from the {target}
        pick the {thing} up
        please pick up the {thing}
    """,
    "place": """
        put the {thing} on the {target}
        place the {thing} on the {target}
        put it down
        drop the {thing}
        put down the {thing}
    """,
    "bring": "bring me the {thing}",
    "follow": "follow me",
    "come": "come here",
}
"""Commands as tutorials and people have them, by intent."""
SHARES = {
    "stop": 0.12, "move": 0.28, "turn": 0.22, "navigate": 0.2, "pick": 0.07, "place": 0.06, "bring": 0.03,
    "hand_over": 0.02, "follow": 0.02, "come": 0.02, "look": 0.02,
}  # fmt: skip
"""Of the commands: what people say to a robot that drives is mostly about driving."""
VALUES = {
    "distance": (
        "one meter", "two meters", "three meters", "half a meter", "one and a half meters", "ten meters", "five feet",
        "two feet", "twenty centimeters", "fifty centimeters", "a couple of feet", "two and a half meters",
        "four meters", "six inches", "seven meters",
    ),
    "duration": ("two seconds", "three seconds", "five seconds", "ten seconds", "half a second"),
    "speed": ("half a meter per second", "zero point two meters per second", "one meter per second"),
    "angle": (
        "ninety degrees", "forty five degrees", "thirty degrees", "one hundred eighty degrees", "sixty degrees",
        "ten degrees", "one hundred and twenty degrees", "fifteen degrees",
    ),
    "thing": (
        "cup", "red cup", "box", "bottle", "ball", "book", "blue box", "screwdriver", "apple", "green bottle", "keys",
    ),
    "target": ("table", "shelf", "chair", "desk", "floor", "counter"),
}  # fmt: skip
SAMPLED = 1 / 3
"""Share of commands that come from the sampler."""
MOST_WORDS = 10
FORBIDDEN = """
don't go to the kitchen
do not turn left
don't move forward two meters
never go to the bedroom
please don't turn right
robot don't go back one meter
do not pick up the cup
don't take the blue box from the table
you must not go to the lounge
please do not drive ahead
don't go to the dock
never pick up the knife
don't rotate ninety degrees
do not go forward
don't put down the book
please don't go to the front room
robot do not move
don't go back half a meter
do not bring me the box
don't turn around
"""
"""What shall not be done, each said by every other voice. In noise the first words are soon heard as others."""
TOLD = """
mary went to the kitchen
mary goes to the kitchen
peter puts the box on the table
the robot goes to the kitchen
the robot turned left at the door
the dog follows me
the man picked up the cup
my brother drives to the office every day
my mother put the keys on the shelf
everyone goes to the kitchen at noon
somebody dropped the bottle
nobody goes to the garage
people turn left here
the children go to the bedroom now
the bus goes forward
the car moves back a little
the cat jumped on the table
john takes the ball from the shelf
our robot follows me to the kitchen
this robot can turn around
that one goes back to the dock
to go to the kitchen takes a minute
to turn left is easy
going to the kitchen is fun
turning left was wrong
picking up the box is hard
I will go to the kitchen
I am going to the kitchen
I'll take the cup from the table
I'm turning left now
we will put the box on the shelf
we're going to the dock
you should go to the office
you are going forward two meters
he turns right at the corner
she goes back one meter
they drive to the lounge
it turns around
it stopped at the door
he told me to go to the kitchen
she said that we turn left
I want to go to the kitchen
I have to go to the bedroom
I can pick up the box
I like to go to the kitchen
let me put the cup on the table
let me turn right
do you go to the kitchen
did it turn left
does it go forward two meters
should I go to the kitchen
why did you stop
when do we go to the kitchen
how do I turn left
who put the box on the table
what happens when you turn right
where did you put the cup
if you turn left you see the door
after you go to the kitchen the light goes off
before we turn around we look
yesterday it went to the kitchen
sometimes I go forward
on monday we go to the office
there is a box on the table
the box is on the table
the cup fell from the shelf
the kitchen is to the left
two meters forward is the door
the way to the kitchen is left
the door to the office was open
all of us went to the lounge
both of them turn left
some people go back to the dock
my friend and I go to the kitchen
the red cup is on the counter
her robot brings me the coffee
his car turns right
the boys follow me
the train stops here
the bus stop is over there
"""
"""What is told or asked, in words of commands: a recogniser that is led along a grammar would make commands of it."""
PAUSED = """
turn left, ninety degrees
turn right, sixty degrees
turn left, slowly
turn right, for three seconds
go forward, two meters
go forward, five feet
go forward, for ten seconds
go back, half a meter
move forward, slowly
drive backward, one meter
go ahead, three meters
turn left, no, right
go forward, no, back
go to the kitchen, I mean the bedroom
go to the lounge, no, the dock
turn around, and then go forward one meter
turn left, and go to the kitchen
go forward one meter, then turn right
"""
"""Commands of two parts, with a pause where the comma is, in which the first part is a command of its own."""
OTHERS = """
I was going to go to the kitchen
she went to the bedroom and turned off the light
don't move
don't go forward
do not turn left
never go to the kitchen
please don't stop on my account
the bus stop is around the corner
what did the bus do when it went forward
he told me to turn left at the church
yesterday we drove two hundred meters and gave up
how far is it to the kitchen
is the living room clean
why did you stop
when will you go to the dock
I think the kitchen is on the left
my left foot hurts
that is not right
you are right about that
the right answer is forty two
it's about ninety degrees outside
the movie starts in ten minutes
we need three more chairs in the living room
there are two cups on the table
I like the red cup better
who put the box on the table
somebody left the bottle in the bedroom
what time is it
how is the weather today
play some music
call my mother
remind me to water the plants
set an alarm for seven o'clock
turn down the volume
turn on the lights in the kitchen
turn off the television
send a message to John
what is the capital of France
tell me a joke
I am going to the supermarket
let me think about it
could you repeat that question
I don't know what you mean
that was a good dinner
the children are sleeping
we moved to a new house last year
she runs a small company
he walks the dog every morning
they stopped talking when I came in
the train stops here at noon
my car won't start
the meeting was moved to Monday
pick a number between one and ten
pick me up at the airport
he took first place in the race
follow the instructions on the box
we will follow up next week
look who is talking
come to think of it that was strange
you should bring an umbrella when it rains
give it some time
the elevator goes up and down
back in my day we had no robots
forward the email to the office
we are moving forward with the project
I had to backtrack two steps in the recipe
first you turn the page and then you read it
the left one is broken
have you ever been to the entrance hall of the museum
it takes two to tango
good morning everybody
thank you very much
see you tomorrow
nice to meet you
one two three four five
mister Dashwood had then leisure to consider how much there might be in his power to do
it was the best of times it was the worst of times
the quick brown fox jumps over the lazy dog
"""
"""Speech that a robot must not act on: talk, negated commands, questions, and requests to other machines."""


def plain(engine: IntentEngine, count: int, chance: random.Random) -> list[dict[str, Any]]:
    """Filled frames, as the engine understands them, no sentence twice.

    Raises:
        ValueError: the engine understands one as another intent, or not at all.
    """
    found: dict[str, dict[str, Any]] = {}
    places = [" ".join(words) for words, _ in engine.locations.names()] if engine.locations is not None else []
    for intent, frames in FRAMES.items():
        listed = [line.strip() for line in frames.strip().splitlines()]
        texts: dict[str, None] = {}
        for turn in range(20 * len(listed)):
            frame = listed[turn % len(listed)]
            text = re.sub(r"{(\w+)}", lambda hole: chance.choice({**VALUES, "place": places}[hole[1]]), frame)
            texts[text] = None
        for text in list(texts)[: round(count * SHARES[intent])]:
            meaning = engine.parse(text)
            if meaning.status is not Status.ACCEPTED or meaning.intent != intent:
                raise ValueError(f"{text!r} is {meaning.intent or meaning.reason}, not {intent}")
            found[text] = label(text, intent, meaning.actions, "plain")
    return list(found.values())


def sampled(engine: IntentEngine, count: int, seed: int) -> list[dict[str, Any]]:
    """Samples of the grammar, no sentence twice."""
    found: dict[str, dict[str, Any]] = {}
    for intent in engine.grammar.intents:
        wanted = round(count * SHARES.get(intent, 0.02))
        drawn = sample(engine.grammar, engine.locations, 20 * wanted + 20, intent=intent, seed=seed)
        # Digits and signs are read aloud differently by every voice.
        texts = {
            one.text: one
            for one in drawn
            if len(one.text.split()) <= MOST_WORDS
            and not re.search(r"[^a-z '-]", one.text)
            and engine.parse(one.text, last=()).status is Status.ACCEPTED  # "again" is nothing by itself
        }
        for text, one in list(texts.items())[:wanted]:
            found[text] = label(text, one.intent, one.actions, "sampled")
    return list(found.values())


def paused(engine: IntentEngine) -> list[dict[str, Any]]:
    """Commands with a pause, which mean what they mean without.

    Raises:
        ValueError: the engine does not understand one.
    """
    found = []
    for text in PAUSED.strip().splitlines():
        meaning = engine.parse(text)
        if meaning.status is not Status.ACCEPTED:
            raise ValueError(f"{text!r}: {meaning.reason}")
        found.append({"text": text, "actions": [to_json(action) for action in meaning.actions], "kind": "paused"})
    return found


def label(text: str, intent: str, actions: Sequence[Any], kind: str) -> dict[str, Any]:
    """A line of labels. Of several commands the actions tell enough, without the intents of their steps."""
    one = {} if intent == COMPOUND else {"intent": intent}
    return {"text": text, **one, "actions": [to_json(action) for action in actions], "kind": kind}


def others(engine: IntentEngine, texts: str = OTHERS) -> list[dict[str, Any]]:
    """Speech that is no command; what the grammar takes for one as text is told, and stays in."""
    found = []
    for text in texts.strip().splitlines():
        if engine.parse(text).actions:
            print(f"the grammar takes this for a command: {text}", file=sys.stderr)
        found.append({"text": text, "intent": None, "kind": "other"})
    return found
