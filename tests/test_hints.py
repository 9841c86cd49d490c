"""What a person probably meant."""

import pytest

from intent_engine.hints import did_you_mean


@pytest.mark.parametrize(
    ("word", "hint"),
    [("distnce", "did you mean 'distance'?"), ("fwd", "did you mean 'forward'?"), ("zebra", None), ("", None)],
)
def test_did_you_mean(word, hint):
    assert did_you_mean(word, ["distance", "forward", "angle"]) == hint


def test_capitals_are_no_other_letters():
    assert did_you_mean("LOCATIONS", ["frame", "locations"]) == "did you mean 'locations'?"
    assert did_you_mean("Move", ["mode", "move"]) == "did you mean 'move'?"
