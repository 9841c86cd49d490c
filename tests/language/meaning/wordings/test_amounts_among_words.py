"""Where amounts stand among words."""

import pytest

from intent_engine.language.meaning.wordings.counted import amounts


@pytest.mark.parametrize(
    ("language", "said", "found"),
    [
        ("en", "nudge it half a degree left", ["half a degree"]),
        ("en", "track it for two and a half hours", ["two and a half hours"]),
        ("en", "an hour and a half please", ["an hour and a half"]),
        ("en", "move it a couple of degrees down", ["a couple of degrees"]),
        ("en", "by a hundred and twenty degrees", ["a hundred and twenty degrees"]),
        ("en", "two point five meters", ["two point five meters"]),
        ("en", "gate seven to bay nine", ["seven", "nine"]),
        ("en", "lift three a meter", ["three", "a meter"]),
        ("en", "a box and an hour", ["an hour"]),
        ("de", "heb Bühne drei einen halben Meter", ["drei", "einen halben meter"]),
        ("es", "riega hora y media los olivos", ["hora y media"]),
        ("en", "two meters a second", ["two meters a second"]),
        ("en", "four meters and half a meter per second", ["four meters", "half a meter per second"]),
        ("xx", "nothing is known of this", []),
    ],
)
def test_where_they_stand(language: str, said: str, found: list[str]) -> None:
    words = said.lower().split()
    assert [" ".join(words[at] for at in one) for one in amounts(words, language)] == found
