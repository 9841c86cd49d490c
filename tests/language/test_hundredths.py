"""A number alone behind a unit counts its hundredths, where the slot has them: "two euros fifty"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

GRAMMAR = """
slots:
  coin: {type: number, units: {1: (euro|euros), 0.01: (cent|cents)}, max: 200}
  times: {type: number, whole: true, max: 9}
  eggs: {type: number, units: {6: [box, boxes], 30: [tray, trays]}}
intents:
  pay: {action: custom, sentences: ["pay {coin}", "pay {coin} {times} times"]}
  order: {action: custom, sentences: ["order {eggs}"]}
"""


@given(euros=st.integers(1, 100), cents=st.integers(1, 99))
def test_the_number_counts_hundredths(engine_of, euros: int, cents: int) -> None:
    assert engine_of(GRAMMAR).parse(f"pay {euros} euros {cents}").slots["coin"] == pytest.approx(euros + cents / 100)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("pay two euros fifty", {"coin": 2.5}),
        ("pay a euro twenty", {"coin": 1.2}),
        ("pay two euros fifty cents", {"coin": 2.5}),
        ("pay two euros three times", {"coin": 2.0, "times": 3}),
        # More than a euro has, a part of one, two numbers, a pause, and a unit that has no hundredth.
        ("pay two euros one fifty", None),
        ("pay two euros half", None),
        ("pay two and a half euros fifty", None),
        ("pay two euros fifty three times", None),
        ("pay two euros, fifty", None),
        ("pay fifty cents two", None),
        ("order two trays five", None),
    ],
)
def test_hundredths(engine_of, said: str, slots: dict[str, float] | None) -> None:
    found = engine_of(GRAMMAR).parse(said)
    assert (dict(found.slots) if found.actions else None) == slots
