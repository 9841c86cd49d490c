"""A greeting with which a free name begins is a part of it: whoever greets does it before a command or behind it."""

from __future__ import annotations

from typing import Any

import pytest

GRAMMAR = """
slots:
  title: {type: text, max_words: 4}
  artist: {type: text, max_words: 3}
  level: {type: number, max: 10}
intents:
  play: {action: custom, sentences: ["play {title} [by {artist}]"]}
  volume: {action: custom, sentences: ["volume {level}", "louder"]}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("play hey jude", {"title": "hey jude"}),
        ("play uh hey jude please", {"title": "hey jude"}),
        ("please play hey jude by hey marseilles", {"title": "hey jude", "artist": "hey marseilles"}),
        ("hello play hello by adele", {"title": "hello", "artist": "adele"}),
        ("play thank you by dido", {"title": "thank you", "artist": "dido"}),
        ("play yesterday, no, hey jude", {"title": "hey jude"}),
        ("play yesterday thanks", {"title": "yesterday"}),
        ("play yesterday please thank you", {"title": "yesterday"}),
        ("hey play yesterday", {"title": "yesterday"}),
        ("play, hey, yesterday", {"title": "yesterday"}),
        ("could you hey play yesterday", {"title": "yesterday"}),
    ],
)
def test_greetings(engine_of, said: str, slots: dict[str, Any]) -> None:
    assert dict(engine_of(GRAMMAR).parse(said).slots) == slots


@pytest.mark.parametrize(
    ("said", "last"),
    [
        ("louder and play hey jude", {"title": "hey jude"}),
        ("louder thanks and then play yesterday", {"title": "yesterday"}),
        ("louder and hey play yesterday", {"title": "yesterday"}),
    ],
)
def test_among_several(engine_of, said: str, last: dict[str, Any]) -> None:
    assert engine_of(GRAMMAR).parse(said).slots["steps"][-1]["slots"] == last


def test_a_greeting_where_no_name_is(engine_of) -> None:
    assert dict(engine_of(GRAMMAR).parse("volume hey five").slots) == {"level": 5}


@pytest.mark.parametrize(
    ("said", "title"),
    [
        ("play can you feel it", "can you feel it"),
        ("play would you mind", None),
        ("play could you please stay", None),  # which is "could you please", and a title, or no more than a part of one
        ("play thank you for all the music", None),  # which is longer than a title, and no "for all the music"
    ],
)
def test_what_asks_may_be_a_part_of_the_name_too(engine_of, said: str, title: str | None) -> None:
    assert engine_of(GRAMMAR).parse(said).slots.get("title") == title


@pytest.mark.parametrize(
    "said",
    [
        "can you play yesterday",
        "could you please play yesterday",
        "play yesterday could you",
        "play yesterday, would you please",
        "play, could you, yesterday",
        "louder, no, could you play yesterday",
        "hey can you play yesterday",
    ],
)
def test_before_or_behind_a_command_it_asks_for_it(engine_of, said: str) -> None:
    assert dict(engine_of(GRAMMAR).parse(said).slots) == {"title": "yesterday"}


@pytest.mark.parametrize(
    ("language", "sentence", "said", "title"),
    [
        ("fr", "cherche le livre {title}", "cherche le livre Bonjour tristesse", "bonjour tristesse"),
        ("fr", "cherche le livre {title}", "salut, cherche le livre Germinal, merci beaucoup", "germinal"),
        ("de", "spiel {title}", "spiel ok computer", "ok computer"),
        ("de", "spiel {title}", "hallo, spiel bitte Yesterday, vielen dank", "yesterday"),
        ("es", "pon la canción {title}", "pon la canción Hola soledad", "hola soledad"),
        ("es", "pon la canción {title}", "hola, pon la canción Volare, muchas gracias", "volare"),
        ("it", "metti la canzone {title}", "metti la canzone Ciao amore", "ciao amore"),
        ("it", "metti la canzone {title}", "ciao, metti la canzone Volare, grazie mille", "volare"),
    ],
)
def test_greetings_of_other_languages(engine_of, language: str, sentence: str, said: str, title: str) -> None:
    grammar = (
        f"language: {language}\nslots:\n  title: {{type: text, max_words: 4}}\n"
        f"intents:\n  play: {{action: custom, sentences: ['{sentence}']}}\n"
    )
    assert dict(engine_of(grammar).parse(said).slots) == {"title": title}
