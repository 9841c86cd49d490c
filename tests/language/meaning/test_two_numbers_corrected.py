"""Two numbers that belong together, as of a time: one that is said again is done where it is clear which, and that the
other stays."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.numbers.spelled import in_words

GRAMMAR = """
language: {language}
slots:
  hour: {{type: number, min: 0, max: 23, whole: true}}
  minute: {{type: number, min: 0, max: 59, whole: true}}
  row: {{type: number, min: 1, max: 40, whole: true}}
  seat: {{type: number, min: 1, max: 40, whole: true}}
intents:
  wake:
    action: custom
    defaults: {{minute: 0}}
    sentences: ["wake me at {{hour}} [{{minute}}] [o'clock]", "weck mich um {{hour}} [uhr] [{{minute}}]"]
  seat: {{action: custom, sentences: ["reserve row {{row}} seat {{seat}}"]}}
  play: {{action: custom, sentences: ["play song {{row}} [{{seat}} times]"]}}
  shake: {{action: custom, sentences: ["shake rack {{row}} [turns] [{{seat}} turns]"]}}
"""
HOURS, MINUTES = st.integers(1, 23), st.integers(1, 59)


@pytest.fixture(scope="module")
def engines(engine_of):
    return {language: engine_of(GRAMMAR.format(language=language)) for language in ("en", "de")}


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "wake me at seven thirty, no, eight"),
        ("en", "wake me at seven thirty, no, eight o'clock"),
        ("en", "wake me at seven thirty, no, at eight"),
        ("en", "reserve row 3 seat 5, no, 7"),
        ("en", "play song seven two times, no, three"),
        ("en", "shake rack seven two turns, no, three turns"),
        ("de", "weck mich um sieben Uhr dreißig, nein, acht"),
        ("de", "weck mich um sieben Uhr dreißig, nein, um acht Uhr"),
    ],
)
def test_what_may_be_either_or_leave_the_other_out_is_asked_about(engines, language, said):
    found = engines[language].parse(said)
    assert found.actions == ()
    assert "it is not clear what" in found.reason


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "wake me at seven thirty, no, forty", "wake me at seven forty"),
        ("en", "wake me at seven thirty, no, wake me at eight", "wake me at eight"),
        ("en", "wake me at seven, no, eight thirty", "wake me at eight thirty"),
        ("en", "play song seven two times, no, three times", "play song seven three times"),
        ("en", "play song 7 2 times, I mean 21 times", "play song 7 21 times"),
        ("en", "reserve row 3 seat 5, no, row 4", "reserve row 4 seat 5"),
        ("en", "reserve row 3 seat 5, no, seat 7", "reserve row 3 seat 7"),
        ("de", "weck mich um sieben Uhr dreißig, nein, acht Uhr vierzig", "weck mich um acht Uhr vierzig"),
        ("de", "weck mich um sieben Uhr, nein, acht Uhr", "weck mich um acht Uhr"),
    ],
)
def test_where_it_is_clear_it_is_done(engines, language, said, meant):
    assert engines[language].parse(said).actions == engines[language].parse(meant).actions != ()


@given(HOURS, MINUTES, HOURS, MINUTES)
def test_a_whole_time_said_again_counts(engines, hour, minute, later, other):
    texts = [" ".join(in_words([str(one), str(two)])) for one, two in ((hour, minute), (later, other))]
    found = engines["en"].parse(f"wake me at {texts[0]}, no, {texts[1]}")
    assert found.slots in ({}, {"hour": later, "minute": other})


@given(HOURS, MINUTES, MINUTES)
def test_a_minute_alone_is_one_only_where_it_is_no_hour(engines, hour, minute, other):
    was, said = (" ".join(in_words(list(map(str, some)))) for some in ((hour, minute), (other,)))
    found = engines["en"].parse(f"wake me at {was}, no, {said}")
    assert not found.actions or (other > 23 and found.slots == {"hour": hour, "minute": other}) or other == minute
