"""Free words that begin with a way or a place are no thing: "get off the table"."""

from __future__ import annotations

import pytest

GRAMMAR = """
language: {language}
slots:
  item: {{type: object, max_words: 4}}
  title: {{type: text, max_words: 4}}
intents:
  get: {{action: custom, sentences: ["{get} {{item}}"]}}
  play: {{action: custom, sentences: ["{play} {{title}}"]}}
"""


@pytest.mark.parametrize(
    ("language", "get", "said"),
    [
        ("en", "get", "off the table"), ("en", "get", "back to me"), ("en", "get", "out of here"),
        ("en", "get", "on with it"), ("en", "get", "in my way"), ("de", "hol", "auf den Tisch"),
        ("fr", "prends", "sur la table"), ("es", "coge", "sobre la mesa"),
    ],
)  # fmt: skip
def test_it_is_no_thing(engine_of, language: str, get: str, said: str) -> None:
    engine = engine_of(GRAMMAR.format(language=language, get=get, play="play"))
    assert not engine.parse(f"{get} {said}").actions
    assert engine.parse(f"play {said}").slots["title"] == said.casefold(), "a title may be"


@pytest.mark.parametrize("said", ["off switch", "down jacket", "glass of water"])
def test_a_thing_may_be_called_so(engine_of, said: str) -> None:
    engine = engine_of(GRAMMAR.format(language="en", get="get", play="play"))
    assert engine.parse(f"get the {said}").slots == {"item": said}
