"""Whole utterances: what may stand before, between and after sentences."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.language.automaton import Automaton

GRAMMAR = """
language: en
fillers: [please, so]
operators: {stop: [halt], sequence: [and then]}
intents:
  wave: {action: custom, sentences: [wave], then: [once more]}
  bow: {action: custom, sentences: [bow]}
"""


@pytest.fixture(scope="module")
def engine(tmp_path_factory) -> IntentEngine:
    file = tmp_path_factory.mktemp("utterances") / "grammar.yaml"
    file.write_text(GRAMMAR, "utf-8")
    return IntentEngine.from_files(file)


def whole(automaton: Automaton, text: str) -> bool:
    words = text.split()
    known, reached = automaton.walk(words)
    return known == len(words) and reached is not None and bool(reached.accepts)


@pytest.mark.parametrize(
    ("text", "spoken", "likely"),
    [
        ("wave", True, True),
        ("please wave please", True, True),
        ("so please wave and then bow", True, True),
        ("wave and then once more", True, True),
        ("wave and then once more and then bow", True, True),
        ("halt", True, True),
        ("please halt", True, True),
        ("do not wave", True, True),
        ("never wave", True, True),
        ("you should not wave", True, False),  # too unusual to look for
        ("wave and then halt", True, False),  # a stop that was said in a sentence is heard as it is
        ("once more", False, False),
        ("bow and then once more", False, False),
        ("wave bow", False, False),
        ("wave and then", False, False),
        ("please", False, False),
    ],
)
def test_what_is_an_utterance(engine, text, spoken, likely):
    matcher = engine.matcher()
    assert (whole(matcher.spoken, text), whole(matcher.likely, text)) == (spoken, likely)


@pytest.mark.parametrize(
    ("text", "likely"),
    [
        ("fahr tasse in die küche", False),
        ("fahr bitte in die küche", True),
        ("fahr nicht in die küche", True),
        ("bitte fahr in die küche", True),
    ],
)
def test_in_german_some_words_stand_behind_the_verb(root, text, likely):
    engine = IntentEngine.from_files(root / "grammars/de.yaml", locations=root / "locations/zuhause.yaml")
    assert whole(engine.matcher().likely, text) is likely
