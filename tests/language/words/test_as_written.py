"""The words that an author writes with a capital or an apostrophe."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.words.as_written import as_written, texts_in

OFFICE = """
language: en
phrases:
  find: "(Where is|find the MRI near)"
slots:
  person: [Doctor Miller, "the chef’s sister", "Élodie (Brown|Green)", mister smith]
  Day: {type: choice, values: {Mon: [Monday, "next week"]}}
intents:
  Find: {action: {type: custom, name: find}, sentences: ["{find} {person} [on {Day}]", "Ask McKay"]}
"""


def test_values_have_them_anywhere_and_sentences_inside(engine_of):
    words = engine_of(OFFICE).grammar.as_written
    large = "Where MRI Doctor Miller Élodie Brown Green Mon Monday McKay chef's"
    assert sorted(words.values()) == sorted(large.split())
    assert (words["mri"], words["mckay"], words["élodie"]) == ("MRI", "McKay", "Élodie")
    assert words["chefs"] == "chef's"


@pytest.mark.parametrize("data", [None, 3, [None, {"Anna": 2}], {1: ["Anna"]}])
def test_whatever_was_read_of_a_file(data):
    assert set(texts_in(data)) <= {"Anna"}


def plain_word(text: str) -> str:
    return text.lower().replace("'", "")


@given(st.lists(st.text(max_size=20)), st.booleans())
def test_each_is_the_same_word_small(texts, sentences):
    for small, large in as_written(texts, sentences=sentences).items():
        assert plain_word(large) == small != large


def test_a_word_that_lost_a_vowel_is_no_part_of_the_next():
    assert as_written(["L'Atelier", "salle d’Eau", "D’Angelo's"]) == {
        "atelier": "Atelier", "eau": "Eau", "dangelos": "D'Angelo's",
    }  # fmt: skip
