"""``regex:`` and ``lark:`` patterns: their slots, and that they swallow nothing that changes what is meant."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from meanings import done

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.normalize import tokenize
from intent_engine.language.pattern import patterns

GRAMMAR = r"""
language: en
fillers: [please, uh]
slots:
  distance: {type: distance, max: 5 m}
  direction: {type: choice, values: {forward: [forward, ahead], backward: [backward]}}
  thing: {type: text, max_words: 3}
  pair: {type: text, max_words: 5, allow: [and]}
  place: {type: location}
intents:
  stop: {action: stop, sentences: [stop]}
  walk:
    action: move
    regex: "(?:walk|stroll) (?P<direction>\\w+)(?: (?P<distance>.+))?"
  visit:
    action: {type: navigate, location: "{place}"}
    regex: "(?:visit|see) (?P<place>.+)"
  fetch:
    action: {type: pick, object: "{thing}"}
    lark: |
      start: "fetch" ("the" | "a")? thing ("now")?
      thing: COLOUR? NOUN
      COLOUR: "red" | "blue"
      NOUN: "cup" | "bottle"
      %ignore " "
  join:
    action: {type: custom, name: join}
    regex: "join (?P<pair>.+)"
  loose:
    action: {type: custom, name: loose}
    regex: "(?:.* )?dance(?: .*)?"
  quiet:
    action: {type: custom, name: quiet}
    regex: "do not disturb(?: .*)?"
"""


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> IntentEngine:
    path = tmp_path_factory.mktemp("patterns") / "patterns.yaml"
    path.write_text(textwrap.dedent(GRAMMAR), "utf-8")
    return IntentEngine.from_files(
        path, locations={"kitchen": (1.0, 2.0), "tea kitchen": (3.0, 4.0), "hall": (0.0, 0.0)}
    )


@pytest.fixture(scope="module")
def does(engine: IntentEngine) -> Callable[[str], str]:
    return lambda text: done(engine.parse(text))


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("walk forward", "forward 1"),
        ("walk ahead two meters", "forward 2"),
        ("stroll backward 50 cm", "back 0.5"),
        ("please walk uh forward", "forward 1"),
        ("walk forward two and a half meters", "forward 2.5"),  # an "and" that joins no commands
        ("walk ahead a meter and a half", "forward 1.5"),
        ("walk forward two and a half meters and visit the hall", "forward 2.5, to hall"),
        ("walk forward and dance", "forward 1, loose"),
        ("walk forward six meters", "rejected"),  # the slot's limit
        ("walk forward two", "incomplete"),  # no unit
        ("walk sideways", "rejected"),
        ("walk farward", "forward 1"),  # a choice may be misheard
        ("walk", "incomplete"),
        ("visit kitchen", "to kitchen"),
        ("see the tea kitchen", "to tea kitchen"),
        ("visit atlantis", "rejected"),
        ("fetch the red cup", "pick red cup"),
        ("fetch bottle now", "pick bottle"),
        ("fetch the green cup", "rejected"),
        ("join the red and the blue wire", "join"),
        ("dance", "loose"),
        ("uh dance wildly please", "loose"),
        ("fetch the red cup and walk forward", "pick red cup, forward 1"),
        ("walk forward then visit the hall", "forward 1, to hall"),
        ("walk forward no backward", "back 1"),
        ("do not disturb", "quiet"),
        ("do not disturb the cat", "quiet"),
    ],
)
def test_a_pattern(does: Callable[[str], str], text: str, meant: str) -> None:
    assert does(text) == meant


@pytest.mark.parametrize(
    "text",
    [
        "don't walk forward",
        "do not dance",
        "never dance",
        "dance never",
        "if it rains dance",
        "dance forget it",
        "dance never mind",
        "i dance",
        "don't visit the kitchen",
        "visit the kitchen or not",
        "do not fetch the red cup",
        "fetch the red cup not",
        "join neither wire",
        "do not disturb and dance",
        "he said dance and dance",
    ],
)
def test_a_hole_swallows_no_word_that_changes_what_is_meant(does: Callable[[str], str], text: str) -> None:
    assert does(text) == "rejected"


@pytest.mark.parametrize(
    "text", ["dance stop", "dance and stay where you are", "walk forward stop", "fetch the cup stop"]
)
def test_a_stop_after_a_pattern_stops(does: Callable[[str], str], text: str) -> None:
    assert does(text) in ("stop", "loose")  # "and stop": every command ends at rest


def test_a_pattern_and_a_sentence_are_rivals(tmp_path: Path) -> None:
    path = tmp_path / "rivals.yaml"
    path.write_text(
        "language: en\nintents:\n"
        "  a: {action: {type: custom, name: a}, sentences: [wave]}\n"
        "  b: {action: {type: custom, name: b}, regex: wav(?:e|ing)}\n"
    )
    engine = IntentEngine.from_files(path)
    assert engine.parse("wave").status is Status.AMBIGUOUS
    assert done(engine.parse("waving")) == "b"


words = st.sampled_from(
    ["walk", "forward", "fetch", "the", "red", "cup", "dance", "do", "not", "visit", "and", "2", "if"]
)


@settings(max_examples=150, deadline=None)
@given(said=st.lists(words, max_size=12))
def test_no_words_raise(engine: IntentEngine, said: list[str]) -> None:
    found: Interpretation = engine.parse(" ".join(said))
    moving = {"not", "if"} & set(said) - {"disturb"}
    if moving:
        assert not found.actions


@settings(max_examples=100, deadline=None)
@given(text=st.text(max_size=60))
def test_no_text_raises(engine: IntentEngine, text: str) -> None:
    engine.parse(text)


def test_a_long_utterance_is_not_given_to_an_ambiguous_grammar(
    engine: IntentEngine, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader = engine._interpreter(None)._commands._patterns
    seen: list[int] = []
    [(intent, sentence, parser)] = reader._larks

    class Counting:
        def parse(self, text: str) -> object:
            seen.append(len(text.split()))
            return parser.parse(text)

    monkeypatch.setattr(reader, "_larks", [(intent, sentence, Counting())])
    for length in (1, patterns.MAX_LARK_WORDS, patterns.MAX_LARK_WORDS + 1, 79):
        reader.read([token.word for token in tokenize("cup " * length)], engine.matcher())
    reader.read(["c" * (patterns.MAX_LARK_LETTERS + 1)], engine.matcher())
    assert seen == [1, patterns.MAX_LARK_WORDS]


def test_a_regular_expression_is_linear(engine: IntentEngine, engine_of) -> None:
    """The classic that takes Python's own engine ages: RE2 answers at once."""
    hard = engine_of('language: en\nintents:\n  a: {action: {type: custom, name: a}, regex: "go (?:a+ ?)+b"}\n')
    assert not hard.parse("go " + "a" * 1500).actions


def test_a_terminal_of_a_lark_grammar_is_linear(engine_of) -> None:
    hard = engine_of(
        "language: en\nintents:\n  a: {action: {type: custom, name: a}, lark: 'start: \"go \" /(a+)+b/'}\n"
    )
    assert not hard.parse("go " + "a" * 60).actions
    assert hard.parse("go " + "a" * 60 + "b").actions


def test_a_terminal_that_looks_behind_is_read(engine_of) -> None:
    behind = engine_of(
        "language: en\nintents:\n  a: {action: {type: custom, name: a}, lark: 'start: \"go\" /(?<=go) now/'}\n"
    )
    assert behind.parse("go now").actions


@pytest.mark.parametrize(
    "pattern",
    [
        r"regex: 'say(?P<it>.*)'",
        r"regex: 'say(?P<it>(?: \w+)*)'",
        'lark: |\n      start: "say" it?\n      it: (" " | /\\w+/)*\n',
        'lark: |\n      start: "say" it " now" | "say" it\n      it: (" " | /\\w+/)*\n',
    ],
)
def test_a_slot_that_fits_nothing_was_not_said(engine_of, pattern: str) -> None:
    said = engine_of(
        f"language: en\nslots: {{it: text}}\nintents:\n  a:\n    action: {{type: custom, name: a}}\n    {pattern}\n"
    )
    assert said.parse("say").slots == {}
    assert said.parse("say").actions
    assert said.parse("say cheese").slots == {"it": "cheese"}


@pytest.mark.parametrize(
    ("regex", "fits"),
    [
        (r"geh zur (?P<ort>\w+)", True),
        (r"geh zur (?P<ort>[\w-]+)", True),
        (r"geh zur (?P<ort>[^\W]+)", False),  # of a class that is in another RE2 knows the English letters alone
        (r"geh zur\W(?P<ort>[[:alpha:]\w]+)", True),
        (r"geh zur \Q\w\E(?P<ort>.+)", False),
        (r"geh zu\w (?P<ort>k\w{4})", True),
        (r"geh\Wzur k(?P<ort>\W)che", False),
    ],
)
def test_letters_are_those_of_every_language(engine_of, regex: str, fits: bool) -> None:
    deutsch = engine_of(
        "language: de\nslots: {ort: [küche]}\nintents:\n  a:\n    action: {type: custom, name: a}\n"
        f"    regex: '{regex}'\n"
    )
    assert bool(deutsch.parse("Geh zur Küche!").actions) == fits


@pytest.mark.parametrize(
    ("text", "heard"),
    [
        ("visit the kichen", "the kichen"),
        ("café kichen", "kichen"),
        ("walk farward", "farward"),
        ("dig kichen", "kichen"),
    ],
)
def test_what_was_heard_otherwise_is_told_with_its_own_words(tmp_path, text, heard):
    (tmp_path / "g.yaml").write_text(
        GRAMMAR
        + """
  cafe: {action: {type: custom, name: cafe}, regex: "café (?P<place>.+)"}
  dig:
    action: {type: custom, name: dig}
    lark: |
      start: "dig " place
      place: /[a-z ]+/
""",
        "utf-8",
    )
    engine = IntentEngine.from_files(tmp_path / "g.yaml", locations={"kitchen": (1.0, 2.0), "hall": (0.0, 0.0)})
    found = engine.parse(text)
    assert found.reason.startswith(f"heard {heard!r} as")
    (slot,) = found.slots.values()
    assert slot in ("kitchen", "forward")


NUMBERS = """
language: en
slots: {level: {type: percent, max: 100 %}, cue: {type: number, max: 200}}
intents:
  dim: {action: custom, regex: "dim to (?P<level>\\\\d+(?:\\\\.\\\\d+)? percent)"}
  run:
    action: custom
    lark: |
      start: "run cue " cue
      cue: /\\d+(\\.\\d+)?/
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("dim to zero percent", {"level": 0.0}),
        ("dim to a hundred percent", {"level": 1.0}),
        ("dim to twelve and a half percent", {"level": 0.125}),
        ("run cue two and a half", {"cue": 2.5}),
        ("run cue a hundred and five", {"cue": 105.0}),
    ],
)
def test_figures_of_a_pattern_are_said_in_words_of_every_kind(engine_of, said, slots):
    assert engine_of(NUMBERS).parse(said).slots == slots


@pytest.mark.parametrize(
    "said", ["dim to a hundred and one percent", "dim to a percent", "run cue five ten", "run cue a"]
)
def test_what_is_no_number_or_too_much_fits_no_figures(engine_of, said):
    assert not engine_of(NUMBERS).parse(said).actions
