"""Numbers in the words of a template: heard as they are spoken, and as a recogniser writes them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.numbered import numbers_either_way
from intent_engine.language.numbers.spelled import in_digits, in_words
from intent_engine.language.spellings import spellings
from intent_engine.language.template import parse_template
from intent_engine.language.template_tree import template_text

RADIO = """
language: en
phrases:
  gear: "gear twenty one"
slots:
  level: [level 2, level three]
intents:
  tune:
    action: {type: custom, name: tune}
    sentences:
      - "tune to channel 5"
      - "use {gear}"
      - "make a 180 [now]"
      - "set {level}"
      - "(room 7|b 12|hall one hundred and five)"
      - "code 007"
"""


@pytest.fixture(scope="module")
def radio(tmp_path_factory: pytest.TempPathFactory) -> IntentEngine:
    path = tmp_path_factory.mktemp("radio") / "radio.yaml"
    path.write_text(RADIO)
    return IntentEngine.from_files(path)


@pytest.mark.parametrize(
    "text",
    [
        *("tune to channel 5", "tune to channel five", "use gear 21", "use gear twenty one", "use gear twenty-one"),
        *("make a 180", "make a one hundred eighty now", "make a one hundred and eighty", "make a one eighty"),
        *("set level two", "set level 2", "set level 3", "room seven", "b twelve", "b 12"),
        *("hall 105", "hall one hundred five", "hall one hundred and five", "code 007"),
    ],
)
def test_a_number_in_a_template_may_be_said_and_written(radio: IntentEngine, text: str) -> None:
    heard = radio.parse(text)
    assert heard.status is Status.ACCEPTED, heard


@pytest.mark.parametrize(
    "text", ["tune to channel six", "use gear 1", "use gear twenty", "make a eighty", "code seven"]
)
def test_another_number_is_another_number(radio: IntentEngine, text: str) -> None:
    assert not radio.parse(text).actions


@given(st.integers(1, 999_999))
def test_every_whole_number_is_in_words_and_in_digits(number: int) -> None:
    digits, words = (str(number),), tuple(in_words([str(number)]))
    for written in (digits, words):
        template = parse_template(f"tune to {' '.join(written)} now")
        ways = spellings(numbers_either_way(template), {}, 9)
        assert ("tune", "to", *digits, "now") in ways
        assert ("tune", "to", *words, "now") in ways
        assert all(in_digits(way[2:-1]) == digits for way in ways)


@pytest.mark.parametrize("text", ["go [to] the (left|right)", "(a;b c) {slot:name} {#}", "code 007", "12345678"])
def test_a_template_without_numbers_that_are_said_is_left_as_it_is(text: str) -> None:
    node = parse_template(text)
    assert template_text(numbers_either_way(node)) == template_text(node)
