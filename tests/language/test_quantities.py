"""Quantities: what people say and recognisers write, in SI units."""

from __future__ import annotations

import math
from decimal import Decimal
from pathlib import Path

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.numbers.units import FACTORS, RATES, units
from intent_engine.language.quantities import Relative, evaluate, templates
from intent_engine.language.template import parse_template

DEGREE = math.pi / 180
FOOT, INCH, MILE, MPH = 0.3048, 0.0254, 1609.344, 0.44704
KINDS = ("number", "ordinal", "distance", "angle", "duration", "speed", "angular_speed", "percent")
GRAMMAR = "language: en\nfillers: []\nslots:\n" + "".join(f"  {kind}: {{type: {kind}}}\n" for kind in KINDS)
GRAMMAR += "intents:\n" + "".join(
    f'  {kind}: {{action: {{type: custom, name: x}}, sentences: ["{kind.replace("_", " ")} {{{kind}}}"]'
    + (f", defaults: {{{kind}: 1.0}}}}\n" if "speed" in kind else "}\n")
    for kind in KINDS
)
"""One sentence for each kind, so that what evaluate() values can be compared with what a grammar hears."""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


def words(text: str) -> list[str]:
    return [token.word for token in tokenize(text)]


def heard(engine: IntentEngine, kind: str, said: str) -> float | None:
    """What a grammar with a slot of this kind makes of it."""
    found = engine.parse(f"{kind.replace('_', ' ')} {said}")
    assert found.status is not Status.AMBIGUOUS, found
    value = found.slots.get(kind) if found.status is Status.ACCEPTED else None
    return None if value is None else float(value)


ROWS: dict[str, list[tuple[str, float]]] = {
    "distance": [
        ("two meters", 2),
        ("two metres", 2),
        ("2m", 2),
        ("10 m.", 10),
        ("ten-meters", 10),
        ("1/2 meter", 0.5),
        ("2-1/2 feet", 2.5 * FOOT),
        ("2½ feet", 2.5 * FOOT),
        ("2,5 m", 2.5),
        ("half a metre", 0.5),
        ("half meter", 0.5),
        ("a half meter", 0.5),
        ("a meter", 1),
        ("another meter", 1),
        ("two more meters", 2),
        ("ten more feet", 10 * FOOT),
        ("a meter and a half", 1.5),
        ("two and a half meters", 2.5),
        ("two meters and a half", 2.5),
        ("one and three quarters meters", 1.75),
        ("a couple of feet", 2 * FOOT),
        ("a couple feet", 2 * FOOT),
        ("half a dozen inches", 6 * INCH),
        ("one meter twenty", 1.2),
        ("1m20", 1.2),
        ("one meter and twenty centimeters", 1.2),
        ("two feet six inches", 2.5 * FOOT),
        ("two foot six", 2.5 * FOOT),
        ("5'6\"", 5.5 * FOOT),
        ('6"', 6 * INCH),
        ("three yards", 0.9144 * 3),
        ("a quarter mile", MILE / 4),
        ("three quarters of a mile", MILE * 0.75),
        ("thirty centimetres", 0.3),
        ("a hundred millimeters", 0.1),
        ("1.5km", 1500),
        ("point five meters", 0.5),
        ("zero point zero five meters", 0.05),
        ("two thousand five hundred meters", 2500),
        ("minus two meters", -2),
    ],
    "angle": [
        ("ninety degrees", 90 * DEGREE),
        ("90°", 90 * DEGREE),
        ("90 deg", 90 * DEGREE),
        ("forty-five degrees", 45 * DEGREE),
        ("one eighty degrees", math.pi),
        ("three hundred and sixty degrees", 2 * math.pi),
        ("minus ninety degrees", -90 * DEGREE),
        ("ten degrees and a half", 10.5 * DEGREE),
        ("quarter turn", math.pi / 2),
        ("a quarter of a turn", math.pi / 2),
        ("half a turn", math.pi),
        ("half turn", math.pi),
        ("three quarter turn", 1.5 * math.pi),
        ("a full turn", 2 * math.pi),
        ("one and a half turns", 3 * math.pi),
        ("two half turns", 2 * math.pi),
        ("a right angle", math.pi / 2),
        ("about face", math.pi),
        ("u-turn", math.pi),
        ("halfway around", math.pi),
        ("full circle", 2 * math.pi),
        ("all the way around", 2 * math.pi),
        ("1.57 radians", 1.57),
    ],
    "duration": [
        ("three seconds", 3),
        ("3s", 3),
        ("3 sec", 3),
        ("half a second", 0.5),
        ("500 ms", 0.5),
        ("a minute and a half", 90),
        ("one and a half minutes", 90),
        ("two minutes thirty seconds", 150),
        ("two minutes thirty", 150),
        ("a couple of seconds", 2),
        ("ten more seconds", 10),
        ("an hour and 15 minutes", 4500),
        ("three quarters of an hour", 2700),
        ("half an hour", 1800),
    ],
    "speed": [
        ("0.3 meters per second", 0.3),
        ("0.3 m/s", 0.3),
        (".3 m/s", 0.3),
        ("half a meter per second", 0.5),
        ("one meter a second", 1),
        ("30 cm/s", 0.3),
        ("two feet per second", 2 * FOOT),
        ("2 km/h", 2 / 3.6),
        ("two kilometers an hour", 2 / 3.6),
        ("2 kph", 2 / 3.6),
        ("3 mph", 3 * MPH),
        ("three miles an hour", 3 * MPH),
    ],
    "angular_speed": [
        ("20 degrees per second", 20 * DEGREE),
        ("20°/s", 20 * DEGREE),
        ("thirty degrees a second", 30 * DEGREE),
        ("0.5 rad/s", 0.5),
        ("half a radian per second", 0.5),
        ("ten rpm", math.pi / 3),
        ("two turns per minute", math.pi / 15),
    ],
    "percent": [("fifty percent", 0.5), ("50%", 0.5), ("a hundred per cent", 1)],
    "number": [("a couple", 2), ("two and a half", 2.5), ("1,200", 1200), ("minus three", -3)],
    "ordinal": [
        ("third", 3),
        ("3rd", 3),
        ("number three", 3),
        ("number 12", 12),
        ("the third", 3),
        ("the last", -1),
        ("twenty first", 21),
    ],
}


@pytest.mark.parametrize(("kind", "said", "value"), [(kind, *row) for kind, rows in ROWS.items() for row in rows])
def test_what_is_said_and_what_a_grammar_hears(engine: IntentEngine, kind: str, said: str, value: float) -> None:
    assert heard(engine, kind, said) == pytest.approx(value)
    assert evaluate(words(said), kind) == pytest.approx(value)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("distance", "two"),  # a number alone has no unit, unless the slot has
        ("distance", "meters"),
        ("distance", "two degrees"),
        ("distance", "two meters three meters"),
        ("distance", "one meter two hundred"),
        ("distance", "two meters per second"),
        ("distance", "a few meters"),
        ("distance", "four of the inches"),
        ("angle", "two turn"),  # "I want to turn"
        ("distance", "two half meters"),  # two and a half
        ("angle", "30 half degrees"),
        ("distance", "two oh half meters"),
        ("distance", "+-5 mm"),
        ("distance", "+/- 5 mm"),
        ("distance", "four meters and a half in"),  # "... in a meter per second"
        ("distance", "1.5 meters and a half"),  # a recogniser's "one meter and a half"
        ("distance", "1.5 and a half meters"),
        ("distance", "half a meter and a half"),
        ("distance", "2.5 meters fifty"),  # 2.55 m, or two meters fifty
        ("distance", "five and a half feet three"),
        ("duration", "half a minute thirty"),
        ("duration", "1.5h30"),
        ("distance", "75 -300 mm"),
        ("distance", "1/0 meters"),
        ("distance", "infinity meters"),
        ("distance", "nan meters"),
        ("distance", "9" * 400 + " meters"),
        ("angle", "ninety"),
        ("angle", "ninety meters"),
        ("duration", "three"),
        ("duration", "second"),
        ("speed", "two meters"),
        ("speed", "500 percent"),
        ("speed", "zero percent"),
        ("percent", "fifty"),
    ],
)
def test_what_is_no_such_quantity(engine: IntentEngine, kind: str, said: str) -> None:
    assert evaluate(words(said), kind) is None
    assert heard(engine, kind, said) is None


def test_a_bare_number_takes_the_unit_that_the_slot_gives() -> None:
    assert evaluate(["ninety"], "angle", unit="deg") == pytest.approx(math.pi / 2)
    assert evaluate(["ninety", "radians"], "angle", unit="deg") == 90
    assert evaluate(["two"], "speed", unit="m/s") == 2
    assert evaluate(["two"], "speed", unit="km/h") == pytest.approx(2 / 3.6)
    assert evaluate(["two"], "distance", unit="parsec") is None
    assert evaluate(["half"], "distance", unit="m") == 0.5


GERMAN_SPEED = """
language: de
slots: {tempo: speed}
intents: {roll: {action: custom, defaults: {tempo: 0.4 m/s}, sentences: ["roll [mit {tempo}]"]}}
"""


@pytest.mark.parametrize(("said", "factor"), units("en").speeds.items())
def test_a_speed_in_terms_of_the_usual_one(engine: IntentEngine, said: str, factor: float) -> None:
    assert evaluate(said.split(), "speed") == Relative(factor)
    assert evaluate(said.split(), "angular_speed") == Relative(factor)
    assert heard(engine, "speed", said) == factor


@pytest.mark.parametrize(("said", "factor"), [*units("de").speeds.items(), ("50 prozent geschwindigkeit", 0.5)])
def test_a_german_speed_in_terms_of_the_usual_one(tmp_path: Path, said: str, factor: float) -> None:
    assert evaluate(said.split(), "speed", "de") == Relative(factor)
    file = tmp_path / "tempo.yaml"
    file.write_text(GERMAN_SPEED, "utf-8")
    (action,) = IntentEngine.from_files(file).parse(f"roll mit {said}").actions
    assert action.slots == {"tempo": pytest.approx(0.4 * factor)}


def test_a_percentage_of_the_usual_speed(engine: IntentEngine) -> None:
    for said, factor in (("fifty percent", 0.5), ("50%", 0.5), ("80 percent speed", 0.8), ("120%", 1.2)):
        assert evaluate(words(said), "speed") == Relative(factor)
        assert heard(engine, "speed", said) == factor


# -- laws -----------------------------------------------------------------------------------------------------

TABLE = units("en")
assert TABLE is not None
UNITS = [
    (kind, " ".join(spelled), factor)
    for kind, spellings in TABLE.by_kind.items()
    for spelled, factor in spellings.items()
    if kind in ("distance", "angle", "duration", "percent")
]
numbers = st.one_of(st.integers(0, 400), st.decimals("0.01", "99", places=2)).map(str)


@settings(max_examples=150, deadline=None)
@given(numbers, st.sampled_from(UNITS), st.sampled_from(["{} {}", "{}{}", "{}-{}", "minus {} {}"]))
@example("3", ("distance", "in", INCH), "{} {}")
def test_a_number_times_its_unit(engine: IntentEngine, number: str, unit: tuple[str, str, float], form: str) -> None:
    kind, name, factor = unit
    said = form.format(number, name)
    meant = float(number) * factor * (-1 if "minus" in form else 1)
    assert evaluate(words(said), kind) == pytest.approx(meant)
    if kind not in ("duration", "percent") or meant >= 0:  # no slot takes less than none of them, unless it says so
        assert heard(engine, kind, said) == pytest.approx(meant)


COUNTS = [
    "2",
    "two",
    "a",
    "half a",
    "two and a half",
    "a couple of",
    "1/2",
    "three quarters of a",
    "one hundred and five",
    "2.5",
]
TAILS = ["", " and a half", " twenty", " 20", " six inches", " and 5 cm", " thirty seconds", " and ten minutes", " 3"]


@settings(max_examples=300, deadline=None)
@given(st.integers(0, 100_000), st.integers(0, 3), st.sampled_from([("cm", 2), ("mm", 3), ("m", 0), ("km", -3)]))
def test_a_length_is_the_decimal_that_was_said(digits: int, places: int, unit: tuple[str, int]) -> None:
    name, smaller = unit
    said = str(Decimal(digits).scaleb(-places))
    assume("E" not in said)
    value = Decimal(digits).scaleb(-places - smaller)
    assert evaluate(words(f"{said} {name}"), "distance") == float(value)


@given(st.integers(0, 1000))
def test_a_percentage_is_the_decimal_that_was_said(hundredths: int) -> None:
    assert evaluate(words(f"{hundredths} percent"), "percent") == hundredths / 100


@given(st.sampled_from(COUNTS), st.sampled_from(UNITS), st.sampled_from(TAILS), st.sampled_from(KINDS))
def test_a_grammar_hears_every_quantity_that_has_a_value(
    engine: IntentEngine, count: str, unit: tuple[str, str, float], tail: str, kind: str
) -> None:
    """The templates for looking ahead must not be narrower than the values; and the values have the last word."""
    said = f"{count} {unit[1]}{tail}"
    value = evaluate(words(said), kind)
    assert heard(engine, kind, said) == (value.factor if isinstance(value, Relative) else value)


VOCABULARY = sorted(
    {word for rows in ROWS.values() for said, _ in rows for word in words(said)} | {"the", "of", "in", "-1", "1/0"}
)


@settings(max_examples=300, deadline=None)
@given(st.lists(st.sampled_from(VOCABULARY), max_size=8))
def test_no_words_raise_and_every_value_is_finite(said: list[str]) -> None:
    for kind in KINDS:
        value = evaluate(said, kind)
        assert value is None or isinstance(value, Relative) or math.isfinite(value)


def test_every_unit_of_every_language_has_a_size() -> None:
    for language in ("de", "en", "es", "fr", "it"):
        table = units(language)
        assert table is not None
        for kind, spellings in table.by_kind.items():
            assert set(spellings.values()) <= {*FACTORS.get(kind, {}).values(), *RATES.get(kind, {}).values()}
        for template in templates(language).values():
            parse_template(template)


@given(st.integers(1, 9), st.integers(10, 99), st.sampled_from(["", "minus "]), st.booleans())
@example(5, 10, "", True)
@example(7, 20, "", True)
@example(8, 10, "", True)
def test_an_angle_in_two_pieces_is_a_common_one_or_none(hundreds: int, tens: int, sign: str, unit: bool) -> None:
    """ "One eighty" is an angle, "five ten degrees" five, no, ten."""
    degrees = 100 * hundreds + tens
    said = f"{sign}{in_words([str(hundreds)])[0]} {' '.join(in_words([str(tens)]))}".split()
    value = evaluate([*said, "degrees"] if unit else said, "angle", unit="deg")
    from_to = hundreds > 3 and 10 <= tens < 20  # "five ten meters" may be five to ten
    if (degrees <= 360 or degrees % 90 == 0) and not from_to:
        assert value == pytest.approx(math.copysign(degrees, -1 if sign else 1) * DEGREE)
    else:
        assert value is None
    assert evaluate([*said, "meters"], "distance") == (None if from_to else -degrees if sign else degrees)
    whole = [*sign.split(), *in_words([str(degrees)]), "degrees"]
    assert evaluate(whole, "angle") == pytest.approx(math.copysign(degrees, -1 if sign else 1) * DEGREE)


@pytest.mark.parametrize("said", ["eight ten", "five ten", "nine fifteen", "minus five ten"])
def test_a_time_from_one_number_to_another_is_none(said: str) -> None:
    """Nobody waits 810 minutes who says "eight ten minutes"."""
    assert evaluate([*said.split(), "minutes"], "duration") is None
    assert evaluate([*said.split(), "percent"], "percent") is None
    assert evaluate([*said.split(), "meters"], "distance") is None
    assert evaluate([*said.split(), "meters", "per", "second"], "speed") is None
    assert evaluate([*said.split(), "degrees", "per", "second"], "angular_speed") is None


@pytest.mark.parametrize("said", ["two hours five ten minutes", "a minute and eight ten seconds"])
def test_nor_is_one_behind_a_larger_unit(said: str) -> None:
    assert evaluate(said.split(), "duration") is None


@pytest.mark.parametrize(("said", "number"), [("one ten", 110), ("two fifteen", 215), ("five fifty", 550)])
def test_a_hundred_is_left_out_where_it_is_one_number(said: str, number: float) -> None:
    assert evaluate([*said.split(), "seconds"], "duration") == number


@pytest.mark.parametrize("said", ["minus -20", "negative -20", "minus minus twenty", "plus -20"])
def test_of_two_signs_nobody_knows_which_holds(said: str) -> None:
    assert evaluate(said.split(), "number") is None
    assert evaluate([*said.split(), "degrees"], "angle") is None


@pytest.mark.parametrize(
    ("said", "part"),
    [
        ("40/50", None),
        ("4/6", None),
        ("8/10", None),
        ("120/80", None),
        ("2/3", 2 / 3),
        ("10/16", 0.625),
        ("50/100", 0.5),
    ],
)
def test_a_stroke_stands_between_two_numbers_unless_they_are_a_part_as_people_write_it(
    said: str, part: float | None
) -> None:
    """ "Every 4/6 hours" is no 40 minutes."""
    assert evaluate([said], "number") == part
    assert evaluate([said, "hours"], "duration") == (None if part is None else pytest.approx(part * 3600))
