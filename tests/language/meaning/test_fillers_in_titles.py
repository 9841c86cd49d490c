"""A title, a message or a search has the words that were said: what is a filler elsewhere may be a part of it."""

from __future__ import annotations

from typing import Any

import pytest
from meanings import done

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine

GRAMMAR = """
slots:
  title: {type: text, max_words: 8}
  artist: {type: text, max_words: 3}
  message: {type: text, max_words: 12}
  person: [anna, bob]
  count: {type: number, whole: true}
  thing: object
intents:
  play: {action: custom, sentences: ["play {title} [by {artist}]", "play {count} songs"]}
  queue: {action: custom, sentences: ["add {title} to the queue"]}
  tell: {action: custom, sentences: ["tell {person} {message}", "say {message} to {person}"]}
  louder: {action: custom, sentences: ["louder", "turn it up"]}
  turn: {action: custom, sentences: ["turn right"]}
  fetch: {action: {type: pick, object: "{thing}"}, sentences: ["fetch {thing}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        # Whose or which it is belongs to a title; an article does not.
        ("play my way", {"title": "my way"}),
        ("play this love", {"title": "this love"}),
        ("play another day", {"title": "another day"}),
        ("play the wall", {"title": "wall"}),
        ("Tell Bob my car is here.", {"person": "bob", "message": "my car is here"}),
        # A filler belongs to it where it begins one in the same breath, and in the midst of one.
        ("Play OK Computer.", {"title": "ok computer"}),
        ("play so far away please", {"title": "so far away"}),
        ("please play can you feel the love tonight for me", {"title": "can you feel the love tonight"}),
        ("add ok computer to the queue", {"title": "ok computer"}),
        ("play now here by so solid", {"title": "now here", "artist": "so solid"}),
        ("tell anna so far so good", {"person": "anna", "message": "so far so good"}),
        ("tell anna it's about ten minutes", {"person": "anna", "message": "its about ten minutes"}),
        ("tell anna two more people come", {"person": "anna", "message": "two more people come"}),
        # It is none of it at its end, between pauses, or as a sound.
        ("play my way please", {"title": "my way"}),
        ("add my way please to the queue", {"title": "my way"}),
        ("play my way please by frank sinatra", {"title": "my way", "artist": "frank sinatra"}),
        ("play, please, my way", {"title": "my way"}),
        ("play um my way", {"title": "my way"}),
        # Before a number of the sentence it is said of that.
        ("play about ten songs", {"count": 10}),
        # A greeting may be all that is said.
        ("please play hello", {"title": "hello"}),
        ("Play Hello, please.", {"title": "hello"}),
        ("play hello hello", {"title": "hello hello"}),
        ("say hello to anna", {"person": "anna", "message": "hello"}),
    ],
)
def test_what_was_said_is_the_title(engine: IntentEngine, said: str, slots: dict[str, Any]) -> None:
    found = engine.parse(said)
    assert (done(found).startswith("rejected"), dict(found.slots)) == (False, slots)


@pytest.mark.parametrize(
    ("said", "titles"),
    [
        ("play hello and turn it up", ["hello", None]),
        ("play hello, louder", ["hello", None]),
        ("louder and play ok computer", [None, "ok computer"]),
        ("louder, play ok computer", [None, "ok computer"]),
        ("play ok computer please and turn it up", ["ok computer", None]),
    ],
)
def test_a_title_among_several_commands(engine: IntentEngine, said: str, titles: list[str | None]) -> None:
    assert [action.slots.get("title") for action in engine.parse(said).actions] == titles


@pytest.mark.parametrize("said", ["play please", "play, please", "Play now.", "play right now", "tell anna for me"])
def test_a_filler_alone_is_no_title(engine: IntentEngine, said: str) -> None:
    assert done(engine.parse(said)) == "incomplete"


@pytest.mark.parametrize("said", ["okay", "thank you", "hi"])
def test_but_may_be_an_answer(engine: IntentEngine, said: str) -> None:
    assert engine.parse(f"tell anna {said}").slots == {"person": "anna", "message": said}


def test_a_filler_is_meant_where_the_sentence_goes_on(engine: IntentEngine) -> None:
    assert engine.parse("say please to anna").slots == {"person": "anna", "message": "please"}


@pytest.mark.parametrize("said", ["fetch the cup please", "fetch please my cup", "fetch, please, another cup"])
def test_a_thing_is_called_as_before(engine: IntentEngine, said: str) -> None:
    assert done(engine.parse(said)) == "pick cup"


@pytest.mark.parametrize(
    "said",
    ["play ok stop", "play my way please stop", "play ok computer, stop", "stop play ok computer", "play so stop"],
)
def test_a_stop_is_one_beside_any_title(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == (Stop(),)


@pytest.mark.parametrize(
    "said",
    [
        "don't play ok computer",
        "play so don't play",
        "play ok never mind",
        "please don't play my way please",
        "play could you be loved",  # "could" is closed, and without it the title is another
        "tell anna could you come",
    ],
)
def test_what_was_not_wanted_does_nothing(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == ()


def test_german_has_its_fillers_behind_the_verb(engine_of) -> None:
    engine = engine_of(
        "language: de\nslots: {titel: {type: text, max_words: 6}}\n"
        "intents: {spiel: {action: custom, sentences: ['spiel {titel}']}}\n"
    )
    assert engine.parse("spiel bitte mal mein Lied").slots == {"titel": "mein lied"}
    assert engine.parse("spiel tausend mal berührt").slots == {"titel": "tausend mal berührt"}
