"""Two quantities one after the other."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does, shipped

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.numbers.spelled import in_words

GRAMMAR = """
language: en
slots:
  hour: {type: number, min: 1, max: 12, whole: true}
  minute: {type: number, min: 0, max: 59}
  x: number
  y: number
  n: {type: number, whole: true}
  short: {type: number, max: 100}
intents:
  count: {action: {type: custom, name: count}, sentences: ["count to {n}"]}
  alarm:
    action: {type: custom, name: alarm}
    sentences: ["wake me at {hour} [{minute}] [am|pm]"]
  call:
    action: {type: custom, name: call}
    sentences: ["call me at {hour} [sharp|pm]"]
  point:
    action: {type: custom, name: point}
    sentences: ["point at {x} {y}", "aim at {short:x} {short:y}"]
  between:
    action: {type: custom, name: between}
    sentences: ["between {x} and {y}"]
  copy:
    action: {type: custom, name: copy}
    sentences: ["copy page {short:page} [{minute:copies} times]", "scan page {minute:page} [{short:copies} times]"]
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.fixture(scope="module")
def cages(engine_of) -> IntentEngine:
    return engine_of("""
language: en
slots: {cage: {type: number, max: 20, whole: true}, pen: {type: number, max: 2000}, kg: {type: number, max: 100}}
intents:
  feed: {action: custom, sentences: ["feed cage {cage} [{kg} kilos]", "feed pen {pen} [{kg} kilos]"]}
""")


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("wake me at six thirty am", {"hour": 6, "minute": 30}),
        ("wake me at ten fifteen", {"hour": 10, "minute": 15}),
        ("wake me at 6:30 a.m.", {"hour": 6, "minute": 30}),
        ("wake me at twelve fifty five", {"hour": 12, "minute": 55}),
        ("point at three four", {"x": 3, "y": 4}),
        ("point at twenty five six", {"x": 25, "y": 6}),
    ],
)
def test_what_can_only_be_two_numbers(engine, said, slots):
    found = engine.parse(said)
    assert (found.status, dict(found.slots)) == (Status.ACCEPTED, slots)


@pytest.mark.parametrize(
    "said", ["twenty five", "two fifty", "one hundred five", "one hundred two hundred", "two thousand five hundred"]
)
def test_what_could_be_one_number_or_two_is_asked_back(engine, said):
    found = engine.parse(f"point at {said}")
    assert (found.status, found.actions) == (Status.REJECTED, ())
    assert "could be one number or two" in found.reason


@pytest.mark.parametrize(
    ("said", "y"), [("two fifty", 50), ("two one hundred", 100), ("two hundred", None), ("one hundred", None)]
)
def test_a_number_that_counts_another_is_one_with_it(engine, said, y):
    """ "Two hundred" are no two and a hundred, though it is more than a slot takes."""
    assert [action.slots["y"] for action in engine.parse(f"aim at {said}").actions] == [y] * (y is not None)


@given(st.integers(2, 9), st.integers(1, 9))
def test_tens_and_ones_are_never_two_numbers(cages, tens, ones):
    """However few the first of two slots takes: "cage twenty five kilos" says too little, or a cage that is none."""
    number = " ".join(in_words([str(10 * tens + ones)]))
    found = cages.parse(f"feed cage {number} kilos")
    assert (found.status, found.actions) == (Status.REJECTED, ())
    assert cages.parse(f"feed cage seven {number} kilos").slots == {"cage": 7, "kg": 10 * tens + ones}


@pytest.mark.parametrize("number", ["one hundred five", "two thousand ten"])
def test_nor_is_what_goes_on_from_a_hundred(cages, number):
    assert not cages.parse(f"feed pen {number} kilos").actions


@given(st.integers(1, 12), st.integers(0, 59), st.sampled_from(["{}.{:02}", "{}:{:02}", "{}{:02}", "{} {:02}"]))
def test_any_time_of_day_in_figures(engine, hour, minute, figures):
    found = engine.parse(f"wake me at {figures.format(hour, minute)} am")
    assert {"minute": 0, **found.slots} == {"hour": hour, "minute": minute}  # "1.00" is an hour alone


@given(st.integers(1, 12), st.sampled_from([" ", " sharp", " pm"]))
def test_a_full_hour_has_no_minutes(engine, hour, behind):
    """Recognisers write "3:00" for three, which a slot for the hour takes, and no other does."""
    assert dict(engine.parse(f"call me at {hour}:00{behind}").slots) == {"hour": hour}
    assert not engine.parse(f"call me at {hour}, 00{behind}").actions
    assert not engine.parse(f"call me at {hour}:30{behind}").actions
    assert not engine.parse(f"count to {hour}:00").actions


@given(st.integers(1, 12), st.integers(1, 9), st.sampled_from(("oh", "o", "zero")), st.booleans())
def test_any_minute_below_ten_is_said_with_its_zero(engine, hour, minute, zero, figures):
    said = [str(hour), str(minute)] if figures else in_words([str(hour), str(minute)])
    assert dict(engine.parse(f"wake me at {said[0]} {zero} {said[1]}").slots) == {"hour": hour, "minute": minute}


@pytest.mark.parametrize(
    "said",
    ["wake me at six, oh, five", "wake me at thirteen oh five", "point at six oh five", "wake me at six oh twelve"],
)
def test_a_zero_that_parts_nothing_parts_no_number(engine, said):
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    "said",
    [
        "wake me at 6.75",
        "wake me at 1365",
        "point at 630",
        "count to 6.30",
        "wake me at 25.30",
        "copy page 1123 times",
        "scan page 1123 times",
    ],
)
def test_figures_that_are_no_two_numbers_are_one(engine, said):
    assert engine.parse(said).actions == ()


@pytest.mark.parametrize("said", ["count to 1e1", "count to 1e2", "point at 1e1 2", "point at 2 1e1"])
def test_an_exponent_is_no_number_that_anybody_says(engine, said):
    assert not engine.parse(said).actions


@pytest.mark.parametrize("said", ["6.5", "six and a half", "six point five", "six point three"])
def test_a_slot_that_counts_takes_whole_numbers(engine, said):
    found = engine.parse(f"wake me at {said}")
    assert (found.status, found.actions) == (Status.REJECTED, ())
    assert "is no whole number" in found.reason
    assert engine.parse("wake me at 6.0").slots == {"hour": 6.0}


@given(st.integers(1, 12), st.integers(10, 59))
def test_any_time_of_day(engine, hour, minute):
    words = " ".join(in_words([str(hour), str(minute)]))
    assert dict(engine.parse(f"wake me at {words}").slots) == {"hour": hour, "minute": minute}


@given(st.integers(0, 9999), st.integers(0, 9999))
def test_two_numbers_are_never_other_two(engine, x, y):
    words = " ".join(in_words([str(x), str(y)]))
    found = engine.parse(f"point at {words}")
    assert found.status is not Status.ACCEPTED or dict(found.slots) == {"x": x, "y": y}


@pytest.mark.parametrize("said", ["100 and 2 and a half", "two hundred and one and a half"])
def test_an_and_that_could_be_in_either_number_is_asked_back(engine, said):
    found = engine.parse(f"between {said}")
    assert (found.status, found.actions) == (Status.REJECTED, ())
    assert "where the first number ends" in found.reason


@pytest.mark.parametrize(
    ("said", "x", "y"),
    [
        ("0.5 and one and a half", 0.5, 1.5),
        ("one hundred and fifty and two hundred", 150, 200),
        ("two and a half and three", 2.5, 3),
        ("twenty and five and a half", 20, 5.5),
        ("a hundred and fifty", 100, 50),
    ],
)
def test_an_and_of_one_number_parts_no_two(engine, said, x, y):
    assert engine.parse(f"between {said}").slots == {"x": x, "y": y}


@given(
    st.one_of(st.integers(0, 9999), st.integers(1, 9).map(lambda n: 100 * n)),
    st.booleans(),
    st.integers(0, 99),
    st.booleans(),
)
def test_two_joined_numbers_are_never_other_two(engine, x, half, y, other_half):
    first, second = (
        " ".join(in_words([str(number)])) + " and a half" * plus for number, plus in ((x, half), (y, other_half))
    )
    found = engine.parse(f"between {first} and {second}")
    assert found.status is not Status.ACCEPTED or found.slots == {"x": x + half / 2, "y": y + other_half / 2}


MOVE = """
language: en
slots: {way: distance, time: duration, part: percent, size: {type: number, units: {12: dozen}}}
intents:
  go: {action: custom, sentences: ["go [on] {way} [for {time}]", "wait {time}", "dim to {part}", "buy {size}"]}
"""


@given(
    st.integers(1, 9),
    st.sampled_from(["meters", "minutes", "feet"]),
    st.sampled_from([", ", "... "]),
    st.integers(2, 90),
    st.booleans(),
)
def test_a_number_after_a_pause_is_no_part_of_the_one_before(engine_of, one, unit, pause, other, figures):
    """ "Two meters, three" are 2.03 m as likely as three meters after all."""
    engine = engine_of(MOVE)
    verb = "wait" if unit == "minutes" else "go"
    numbers = [str(one), str(other)]
    first, second = numbers if figures else (" ".join(in_words([each])) for each in numbers)
    assert engine.parse(f"{verb} {first} {unit}{pause}{second}").actions == ()


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("go two meters three", 2.03),
        ("go two meters, thirty centimeters", 2.3),
        ("go two, meters", 2.0),
        ("go a meter, and a half", 1.5),
        ("go five feet, six inches", 1.6764),
        ("go two thousand, five hundred meters", 2500.0),
        ("buy one thousand, five hundred", 1500.0),
        ("wait two minutes, thirty seconds", 150.0),
    ],
)
def test_what_has_its_unit_or_is_a_half_is(engine_of, said, value):
    assert next(iter(engine_of(MOVE).parse(said).slots.values())) == pytest.approx(value)


HESITATIONS = st.sampled_from(["uh", "maybe", "about", "like", "well", "i would say", "another"])
SMALL = st.sampled_from(["two", "5", "six", "seven"])
COUNTS = SMALL | st.sampled_from(["a", "half a", "a couple of", "two and a half"])
RESTS = st.sampled_from(["", " forward", " please", " turn left", " and turn left"])


@given(COUNTS, st.sampled_from(["feet", "meter"]), HESITATIONS, SMALL, RESTS)
def test_a_number_without_a_unit_is_said_anew_behind_a_hesitation(one, unit, hesitation, other, rest):
    """ "Five feet, maybe six" are not five feet six."""
    assert does(f"go {one} {unit} {hesitation} {other}{rest}") in ("rejected", "incomplete")


@pytest.mark.parametrize(
    "said", ["go five feet{}six", "go a meter{}six and turn left", "turn left and go two feet{}six"]
)
@pytest.mark.parametrize("between", [" uh ", " maybe ", " I would say "])
def test_it_is_told_which_number_it_is(said, between):
    reason = shipped().parse(said.format(between)).reason
    assert "'six' may be a number of its own" in reason


TIMES = """
language: en
slots: {way: distance, times: number}
intents: {walk: {action: custom, sentences: ["walk {way} {times} times"]}}
"""


@given(st.sampled_from(["uh", "um", "please", ","]), SMALL, st.integers(2, 20))
def test_two_numbers_of_one_sentence_may_be_parted(engine_of, between, way, times):
    """The second is no part of the quantity before it, where the sentence has a place for it."""
    found = engine_of(TIMES).parse(f"walk {way} meters {between} {times} times")
    assert found.slots["times"] == times


@given(SMALL, st.sampled_from(["feet", "meters"]), SMALL, st.sampled_from([", ", " uh ", " maybe "]))
def test_what_was_corrected_is_parted_too(one, unit, other, apart):
    """ "No, two meters, two and a half" takes no unit from what was said before."""
    for number in (other, f"{other} and a half"):
        assert does(f"go forward ten cm no {one} {unit}{apart}{number}") in ("rejected", "incomplete", "ambiguous")


@given(HESITATIONS)
def test_with_a_unit_of_its_own_it_goes_on(hesitation):
    assert does(f"go forward two meters {hesitation} fifty centimeters") == "forward 2.5"
    assert does(f"turn left ninety degrees {hesitation} ten degrees") in ("rejected", "incomplete")


def test_said_in_one_breath_they_are_one():
    assert does("go forward uh five feet six") == does("go forward five feet six inches")


AMOUNTS = """
language: en
slots:
  a: {type: duration, min: 0 s}
  d: {type: distance, min: 0 m}
  w: {type: number, unit: kilo, units: {1: [kilo, kilos], 0.001: [gram, grams]}}
intents:
  pulse: {action: custom, sentences: ["pulse {a} {a:b}", "blink {a} and {a:b}"]}
  gap: {action: custom, sentences: ["gap {d} {d:b}", "drive {d} {a:b}"]}
  weigh: {action: custom, sentences: ["weigh {w} {w:b}"]}
  wait: {action: custom, sentences: ["wait {a}"]}
"""


@pytest.mark.parametrize(
    ("said", "values"),
    [
        ("pulse ten seconds five minutes", [10, 300]),
        ("pulse two minutes thirty seconds", [120, 30]),
        ("pulse two minutes ten seconds five seconds", [130, 5]),
        ("pulse five minutes ten minutes", [300, 600]),
        ("blink one minute and ten seconds and five seconds", [70, 5]),
        ("gap two meters ten centimeters", [2, 0.1]),
        ("gap two meters ten centimeters five centimeters", [2.1, 0.05]),
        ("drive two meters ten seconds", [2, 10]),
        ("weigh two kilos three hundred grams ten grams", [2.3, 0.01]),
        ("wait two minutes thirty seconds", [150]),
        # It may be parted in two places, or is no one amount.
        ("pulse one hour ten minutes five seconds", None),
        ("pulse one hour ten minutes and five seconds", None),
        ("wait ten seconds five minutes", None),
        ("wait five minutes ten minutes", None),
        ("wait ten seconds, five seconds", None),
    ],
)
def test_two_amounts_are_never_one_nor_others(engine_of, said: str, values: list[float] | None) -> None:
    actions = engine_of(AMOUNTS).parse(said).actions
    found = [list(action.slots.values()) for action in actions]
    assert found == ([] if values is None else [pytest.approx(values)])
