"""What a thing in a free slot is never called, listed or not: one of two, or when it is wanted."""

from __future__ import annotations

import pytest

from intent_engine.interpretation import Status

GRAMMAR = """
language: {language}
slots:
  thing: {{type: text, max_words: 6}}
  item: {{type: object, max_words: 6}}
  paint: {{type: object, allow: [or, oder, twice]}}
  song: {{type: text, max_words: 6}}
  note: {{type: text, dictation: true}}
intents:
  pick: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["take {{thing}}"]}}
  bring: {{action: custom, sentences: ["bring {{item}}"]}}
  paint: {{action: custom, sentences: ["paint {{paint}}"]}}
  play: {{action: custom, sentences: ["play {{song}}"]}}
  write: {{action: custom, sentences: ["write {{note}}"]}}
"""


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "the cup or the glass"),
        ("en", "cup or glass"),
        ("en", "either the cup or the glass"),
        ("en", "a cup or two"),
        ("de", "den Becher oder das Glas"),
        ("de", "entweder den Becher oder das Glas"),
        ("fr", "la tasse ou le verre"),
        ("fr", "soit la tasse soit le verre"),
        ("es", "la taza o el vaso"),
        ("es", "un plato u otro"),
        ("it", "la tazza o il bicchiere"),
        ("it", "la tazza oppure il bicchiere"),
    ],
)
@pytest.mark.parametrize("verb", ["take", "bring"])
def test_of_two_things_none_is_taken(engine_of, language, said, verb):
    found = engine_of(GRAMMAR.format(language=language)).parse(f"{verb} {said}")
    assert found.status is Status.REJECTED
    assert "leaves open which is meant" in found.reason


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "the cup tomorrow"),
        ("en", "the cup twice"),
        ("en", "the cup in five minutes"),
        ("en", "the cup for two hours"),
        ("en", "the cup at three"),
        ("en", "the red cup within ten seconds"),
        ("de", "den Becher morgen"),
        ("de", "den Becher zweimal"),
        ("de", "den Becher in fünf Minuten"),
        ("fr", "la tasse demain"),
        ("fr", "la tasse dans cinq minutes"),
        ("fr", "la tasse à trois heures"),
        ("fr", "la tasse deux fois"),
        ("es", "la taza mañana"),
        ("es", "la taza en cinco minutos"),
        ("es", "la taza a las tres"),
        ("es", "la taza dos veces"),
        ("it", "la tazza domani"),
        ("it", "la tazza tra cinque minuti"),
        ("it", "la tazza alle tre"),
        ("it", "la tazza due volte"),
    ],
)
@pytest.mark.parametrize("verb", ["take", "bring"])
def test_a_thing_at_another_time_is_not_taken_now(engine_of, language, said, verb):
    assert engine_of(GRAMMAR.format(language=language)).parse(f"{verb} {said}").status is Status.REJECTED


@pytest.mark.parametrize(
    ("language", "said", "value"),
    [
        ("en", "take the box for cables", "box for cables"),
        ("en", "take the cup in the kitchen", "cup in the kitchen"),
        ("en", "take the five minute timer", "five minute timer"),
        ("en", "take the book about him", "book about him"),
        ("en", "take used cups", "used cups"),
        ("en", "paint red or blue", "red or blue"),
        ("en", "paint twice", "twice"),
        ("en", "play jazz or rock", "jazz or rock"),
        ("en", "play it twice", "it twice"),
        ("en", "write the cup or the glass", "the cup or the glass"),
        ("en", "write call anna in five minutes", "call anna in five minutes"),
        ("es", "take la caja o", "caja o"),  # a letter
        ("it", "bring la scatola o", "scatola o"),
    ],
)
def test_names_and_titles_and_dictation_are_as_they_were(engine_of, language, said, value):
    found = engine_of(GRAMMAR.format(language=language)).parse(said)
    assert (found.status, list(found.slots.values())) == (Status.ACCEPTED, [value]), found.reason


@pytest.mark.parametrize("verb", ["take", "bring"])
@pytest.mark.parametrize(
    ("language", "said"),
    [("en", "the cup, wash it"), ("en", "the cup is red"), ("en", "the cup the plate"), ("de", "den Becher und ihn")],
)
def test_what_is_said_besides_is_no_part_of_its_name(engine_of, verb, language, said):
    assert engine_of(GRAMMAR.format(language=language)).parse(f"{verb} {said}").status is Status.REJECTED


def test_with_an_article_it_is_asked_about_in_any_slot(engine_of):
    assert not engine_of(GRAMMAR.format(language="en")).parse("play the first or the last").actions
