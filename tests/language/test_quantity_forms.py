"""Forms of quantities that no test lists: each is made by a rule that knows its value, and read back."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.numbers.units import FACTORS
from intent_engine.language.quantities import Relative, evaluate
from intent_engine.language.slots.quantity_finder import find

KINDS = ("number", "ordinal", "distance", "angle", "duration", "speed", "angular_speed", "percent")
GRAMMAR = "language: en\nslots:\n" + "".join(f"  {kind}: {{type: {kind}}}\n" for kind in KINDS) + "intents:\n"
GRAMMAR += "".join(
    f'  {kind}: {{action: {{type: custom, name: x}}, sentences: ["{kind.replace("_", " ")} {{{kind}}} [at the door]"]'
    + (f", defaults: {{{kind}: 1.0}}}}\n" if "speed" in kind else "}\n")
    for kind in KINDS
)
"""A sentence for each kind, which may go on after it."""
FOOT, DEGREE = 0.3048, math.pi / 180


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


def words(text: str) -> list[str]:
    return [token.word for token in tokenize(text)]


def values(engine: IntentEngine, kind: str, said: str) -> list[float | None]:
    """What a slot has for it, and two sentences."""
    own = evaluate(words(said), kind)
    found: list[float | None] = [own.factor if isinstance(own, Relative) else own]
    for tail in ("", " at the door"):
        parsed = engine.parse(f"{kind.replace('_', ' ')} {said}{tail}")
        value = parsed.slots.get(kind) if parsed.status is Status.ACCEPTED else None
        found.append(None if value is None else float(value))
    return found


def reads(engine: IntentEngine, kind: str, said: str, value: float | None) -> None:
    close = None if value is None else pytest.approx(value)
    assert values(engine, kind, said) == [close] * 3, said


def spelled(number: int) -> str:
    return " ".join(in_words([str(number)]))


either = st.integers(2, 99).flatmap(lambda number: st.sampled_from([(str(number), number), (spelled(number), number)]))
parts = st.sampled_from(
    [("a half", 1 / 2), ("one half", 1 / 2), ("1/2", 1 / 2), ("a quarter", 1 / 4), ("three quarters", 3 / 4),
     ("an eighth", 1 / 8), ("two thirds", 2 / 3), ("3/4", 3 / 4), ("a twentieth", 1 / 20)]
)  # fmt: skip
lengths = st.sampled_from([("meter", "meters", "m"), ("foot", "feet", "ft"), ("mile", "miles", "mi")])


@settings(max_examples=60, deadline=None)
@given(either, parts)
def test_a_number_and_a_part(engine: IntentEngine, number: tuple[str, int], part: tuple[str, float]) -> None:
    reads(engine, "number", f"{number[0]} and {part[0]}", number[1] + part[1])


@settings(max_examples=60, deadline=None)
@given(either, st.sampled_from([("million", 1e6), ("billion", 1e9)]), parts)
def test_a_half_behind_a_million_is_half_a_million(engine, number, scale, part) -> None:
    """ "A million and a half". But of "a thousand and a half" nobody can know."""
    if part[0].endswith(("half", "quarter", "quarters")):
        reads(engine, "number", f"{number[0]} {scale[0]} and {part[0]}", (number[1] + part[1]) * scale[1])
        assert evaluate(words(f"{number[0]} thousand and {part[0]}"), "number") is None


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 99), st.integers(0, 9), st.sampled_from([("", 1), (" thousand", 1e3), (" million", 1e6)]))
def test_a_decimal_is_scaled(engine: IntentEngine, whole: int, tenth: int, scale: tuple[str, float]) -> None:
    reads(engine, "number", f"{spelled(whole)} point {spelled(tenth)}{scale[0]}", (whole + tenth / 10) * scale[1])


@settings(max_examples=40, deadline=None)
@given(either)
def test_dozens(engine: IntentEngine, number: tuple[str, int]) -> None:
    reads(engine, "number", f"{number[0]} dozen", number[1] * 12)
    reads(engine, "number", f"{number[0]} and a half dozen", number[1] * 12 + 6)


@settings(max_examples=80, deadline=None)
@given(
    either,
    lengths,
    st.sampled_from(["{} more {}", "{} {} more", "{} full {}", "another {} {}", "exactly {} {}", "minus {} {}"]),
)
def test_as_much_more(engine: IntentEngine, number: tuple[str, int], unit: tuple[str, str, str], form: str) -> None:
    value = number[1] * FACTORS["distance"][unit[2]] * (-1 if "minus" in form else 1)
    said = form.format(number[0], unit[1])
    first = None if form.startswith(("another", "exactly")) else pytest.approx(value)  # words of no quantity
    assert values(engine, "distance", said) == [first, pytest.approx(value), pytest.approx(value)]


@settings(max_examples=60, deadline=None)
@given(either, parts, lengths, st.sampled_from(["per second", "a minute", "per hour"]))
def test_a_rate_of_a_unit_and_a_part(engine, number, part, unit, per) -> None:
    seconds = {"per second": 1, "a minute": 60, "per hour": 3600}[per]
    value = (number[1] + part[1]) * FACTORS["distance"][unit[2]] / seconds
    reads(engine, "speed", f"{number[0]} {unit[1]} and {part[0]} {per}", value)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 30), st.integers(1, 59), st.integers(0, 59), st.sampled_from(["", " "]))
def test_a_time_written_with_m_for_its_minutes(engine, hours, minutes, seconds, space) -> None:
    """ "1h30m", "1m 30s". An "m" alone is a meter."""
    pieces = [f"{hours}{space}h"] if hours else []
    pieces += [f"{minutes}{space}m"] + ([f"{seconds}{space}s"] if seconds else [])
    value = hours * 3600 + minutes * 60 + seconds
    reads(engine, "duration", space.join(pieces), value if hours or seconds else None)


@settings(max_examples=60, deadline=None)
@given(st.integers(1, 99), st.sampled_from("-−‐–"), st.sampled_from([("distance", "m", 1.0), ("angle", "°", DEGREE)]))
def test_no_sign_is_lost(engine: IntentEngine, number: int, minus: str, unit: tuple[str, str, float]) -> None:
    kind, name, factor = unit
    reads(engine, kind, f"{minus}{number} {name}", -number * factor)
    reads(engine, kind, f"− {number} {name}", -number * factor)
    for sign in ("<", ">", "≤", ">=", "±", "< "):
        reads(engine, kind, f"{sign}{number} {name}", None)


@given(st.integers(1, 99), st.integers(2, 98))
def test_a_range_has_no_sign(low: int, high: int) -> None:
    for dash in "-−‐–":
        for text in (f"{low}{dash}{high} m", f"{low} {dash}{high} m"):
            assert all(found.value > 0 for found in find(text)), text


@settings(max_examples=40, deadline=None)
@given(st.integers(1, 20), st.sampled_from(["m²", "m2", "m³", "m3", "cm²", "square meters", "meters squared"]))
def test_an_area_is_no_length(engine: IntentEngine, number: int, unit: str) -> None:
    reads(engine, "distance", f"{number} {unit}", None)


@settings(max_examples=40, deadline=None)
@given(either, either, st.sampled_from(["", "and "]))
def test_two_lengths_of_two_customs_are_none(engine, top, rest, joint) -> None:
    for units in (("meters", "feet"), ("feet", "centimeters"), ("miles", "meters")):
        reads(engine, "distance", f"{top[0]} {units[0]} {joint}{rest[0]} {units[1]}", None)


@pytest.mark.parametrize(
    ("kind", "said", "value"),
    [
        ("angle", "a turn and a half", 3 * math.pi),
        ("angle", "90º", 90 * DEGREE),
        ("angular_speed", "one turn per second", 2 * math.pi),
        ("angular_speed", "a turn a second", 2 * math.pi),
        ("angular_speed", "a quarter turn a second", math.pi / 2),
        ("angular_speed", "1 rps", 2 * math.pi),
        ("angular_speed", "five r p m", math.pi / 6),
        ("speed", "0.5 m / s", 0.5),
        ("speed", "3 kts", 3 * 1852 / 3600),
        ("speed", "five m p h", 5 * 0.44704),
        ("speed", "twice as fast", 2),
        ("distance", "minus a meter", -1),
        ("distance", "5 µm", 5e-6),
        ("distance", "5' 10''", 70 * 0.0254),
        ("distance", "5’10’’", 70 * 0.0254),
        ("distance", "three sixteenths of an inch", 3 / 16 * 0.0254),
        ("duration", "one hour and thirty five", 5700),
        ("number", "half a dozen", 6),
        ("number", "a half dozen", 6),
        ("number", "a dozen and a half", 18),
        ("number", "a pair", 2),
        ("number", "nought point five", 0.5),
        ("number", "one billion and a half million", 1_000_500_000),
        ("ordinal", "the third one", 3),
        ("ordinal", "the last one", -1),
        ("ordinal", "hundred and first", 101),
        ("ordinal", "a hundred and tenth", 110),
        ("ordinal", "one thousand first", 1001),
        ("ordinal", "1,000th", 1000),
        ("distance", "two feet and a half more", 2.5 * FOOT),
    ],
)
def test_what_else_is_said(engine: IntentEngine, kind: str, said: str, value: float) -> None:
    reads(engine, kind, said, value)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("number", "one one hundredth"),  # 0.01, and no 1.01
        ("number", "two thousand and a half"),
        ("number", ",5"),
        ("ordinal", "one one"),
        ("ordinal", "three one"),
        ("duration", "3 d"),  # scanned in 3D
        ("angle", "a turn"),
    ],
)
def test_what_is_no_clear_quantity(engine: IntentEngine, kind: str, said: str) -> None:
    reads(engine, kind, said, None)
