"""YAML with places: every value is where it says, and any bytes are data or are told what is wrong with them."""

from __future__ import annotations

import json
import string

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.loading import yaml_source
from intent_engine.language.loading.yaml_source import YamlSource, parse_yaml, read_yaml


def parsed(text: str) -> YamlSource:
    return parse_yaml(text, YamlSource("a.yaml"))


PLAIN = st.text(string.ascii_letters + string.digits + " äß:#-'\"{}[],&*!|>%@\n", max_size=12)
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | PLAIN,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(PLAIN, inner, max_size=4),
    max_leaves=12,
)


@given(VALUES, st.booleans())
def test_data_is_what_yaml_reads(value, flow):
    text = yaml.safe_dump(value, default_flow_style=flow, allow_unicode=True)
    source = parsed(text)
    if not source.problems:
        assert source.data == yaml.safe_load(text)


@given(
    st.dictionaries(
        st.text(string.ascii_lowercase, min_size=1), st.text(string.ascii_lowercase, min_size=1), min_size=1
    )
)
def test_every_value_stands_where_it_says(value):
    source = parsed(yaml.safe_dump({"top": value, "list": [*value.values()]}))
    for path in source.marks:
        if path and path[0] == "top" and len(path) == 2:
            place, key = source.place(path), source.place(path, key=True)
            said = place.source[place.column - 1 :].strip("'\"")
            assert said.startswith(str(value[path[1]]))
            assert key.source[key.column - 1 :].strip("'\"").startswith(str(path[1]))
            assert key.line == place.line


@given(st.text(max_size=60) | st.text(alphabet=":-{}[]\"'\n\t #&*|>!%a1", max_size=60))
def test_any_text_is_data_or_is_told_what_is_wrong(text):
    source = parsed(text)
    if source.data is None and not source.problems:
        assert yaml.safe_load(text) is None
    for problem in source.problems:
        assert problem.message
        if problem.line is not None and text:
            assert problem.source is not None
            assert problem.line <= len(text.splitlines()) or not text.splitlines()


@given(st.binary(max_size=80))
def test_any_bytes_are_data_or_are_told_what_is_wrong(tmp_path_factory, data):
    path = tmp_path_factory.getbasetemp() / "any.yaml"
    path.write_bytes(data)
    source = read_yaml(path)
    assert isinstance(source.problems, list)


@pytest.mark.parametrize(
    ("text", "path", "raw"),
    [
        ("a: no", ("a",), "no"),
        ("a: [x, on]", ("a", 1), "on"),
        ("a: 012", ("a",), "012"),
        ("a: 1_000", ("a",), "1_000"),
        ("a: 2024-01-01", ("a",), "2024-01-01"),
        ("a: ~", ("a",), "~"),
        ("a:", ("a",), ""),
    ],
)
def test_what_was_written_is_kept_where_yaml_reads_something_else(text, path, raw):
    assert parsed(text).raw[path] == raw


@pytest.mark.parametrize(
    ("written", "value"),
    [("012", "012"), ("-07", "-07"), ("1:30", "1:30"), ("1:30.5", "1:30.5"), ("0x10", 16), ("1_000", 1000), ("0", 0),
     ("01.5", 1.5), ("08", "08")],
)  # fmt: skip
def test_no_number_is_read_as_octal_or_as_minutes(written, value):
    assert parsed(f"a: {written}").data == {"a": value}


@pytest.mark.parametrize("number", [1e-05, -2.5e-07, 1e16, 0.1, -3e22])
def test_a_number_is_read_as_json_writes_it(number):
    assert parsed(f"a: {json.dumps(number)}\nb: '{number}'").data == {"a": number, "b": str(number)}


def test_what_is_text_stays_text():
    source = parsed("a: 'no'\nb: \"12\"\nc: !!str 12\nd: 2024-01-01\n")
    assert source.data == {"a": "no", "b": "12", "c": "12", "d": "2024-01-01"}


def test_aliases_and_merges_are_read():
    source = parsed(
        "base: &base {x: 1, y: 2}\nmine:\n  <<: *base\n  y: 3\nboth: {<<: [*base, {z: 4}]}\nlist: [*base]\n"
    )
    assert source.problems == []
    assert source.data["mine"] == {"x": 1, "y": 3}
    assert source.data["both"] == {"x": 1, "y": 2, "z": 4}
    assert source.data["list"] == [{"x": 1, "y": 2}]
    assert source.place(("mine", "y")).line == 4


def test_merging_what_is_no_mapping_is_told():
    (problem,) = parsed("base: &base [1]\nmine:\n  <<: *base\n").problems
    assert problem.message == "'<<' takes over mappings alone"


def test_tags_of_other_programs_do_nothing():
    assert parsed("a: !!python/object/apply:os.system ['echo hi']").data == {"a": ["echo hi"]}
    assert parsed("a: !!int many").data == {"a": "many"}


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("- !hop up", "YAML takes !hop for a tag, and leaves it out", 'quote it: "!hop up"'),
        ("- &hop up", "YAML takes &hop for the name of an anchor, and leaves it out", 'quote it: "&hop up"'),
        ("- go to bay #5\n- go", "YAML takes #5 for a comment, and leaves it out", 'quote it: "go to bay #5"'),
        ("- go to #{place}", "YAML takes #{place} for a comment, and leaves it out", 'quote it: "go to #{place}"'),
        ("a: [\u201cgo, back\u201d, on]", "\u201c is no quote for YAML", "write straight quotes"),
        ("- \u201e[please] go\u201c", "\u201e is no quote for YAML", "write straight quotes"),
    ],
)
def test_words_that_yaml_would_leave_out_are_told(text, message, hint):
    (problem,) = parsed(text).problems
    assert (problem.message, problem.line) == (message, 1)
    assert problem.hint.startswith(hint)


@pytest.mark.parametrize(
    "text",
    [
        "- &hop up\n- *hop",
        "- '!hop up'",
        "- !!str 5",
        "- go # 5",
        "- go #the first",
        "- 'go to bay #5'",
        "a: 5 #4",
        "- \u201cgo back\u201d",
        "- \u2019tis",
    ],
)
def test_nothing_is_lost_of_what_yaml_reads_as_it_is_meant(text):
    assert not parsed(text).problems


def test_aliases_may_repeat_but_not_without_end(monkeypatch):
    monkeypatch.setattr(yaml_source, "MAX_COPIES", 100)
    rows = "a: &a [1, 2, 3]\n" + "b: [" + ", ".join(["*a"] * 20) + "]\n"
    assert len(parsed(rows).data["b"]) == 20
    (problem,) = parsed(rows.replace("*a]", "*a, *a, *a, *a, *a, *a, *a, *a]")).problems
    assert "unfold to more than" in problem.message


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("a: 1\nb: " + "[" * 100_000, 2),
        ("a: " + "{x: " * 50_000, 1),
        ("a: " + "[" * 101 + "]" * 101, 1),
        ("\n".join(" " * depth + "a:" for depth in range(2_000)), 401),
        ("- " * 100_000 + "a", 1),
        ("? " * 100_000 + "a", None),
    ],
    ids=["lists", "mappings", "just too deep", "indents", "dashes", "questions"],
)
def test_what_is_nested_too_deeply_is_told_and_never_parsed(text, line):
    """The YAML library in C overflows the stack of the whole process on such texts."""
    (problem,) = parsed(text).problems
    if line is not None:
        assert (problem.message, problem.line) == ("is nested too deeply", line)


def test_what_is_nested_but_a_little_is_read():
    assert parsed("a: " + "[" * 90 + "]" * 90).problems == []
    assert parsed("a: [" + ", ".join(["'[b]'", "{c: '{d}'}"] * 500) + "]").problems == []
    assert parsed("\n".join(" " * depth + "a:" for depth in range(90))).problems == []


def test_a_path_that_is_not_there_is_the_nearest_above():
    source = parsed("a:\n  b: 1\n")
    assert source.place(("a", "b", "c")).line == 2
    assert source.place(("x",)).line == 1


def test_entries_leave_out_what_is_broken():
    source = parsed("a: {x: 1, y: 2}\nb: [5, 6]\nc: text\n")
    source.broken.update({("a", "x"), ("b", 1)})
    assert list(source.entries(("a",), source.data["a"])) == [(("a", "y"), "y", 2)]
    assert list(source.entries(("b",), source.data["b"])) == [(("b", 0), 0, 5)]
    assert list(source.entries(("c",), source.data["c"])) == [(("c",), 0, "text")]
    source.broken.add(("c",))
    assert list(source.entries(("c",), source.data["c"])) == []


def test_a_byte_order_mark_and_windows_lines_are_no_mistake(tmp_path):
    path = tmp_path / "a.yaml"
    path.write_bytes("a: 1\r\nb: [1, x]\r\n".encode("utf-8-sig"))
    source = read_yaml(path)
    assert source.data == {"a": 1, "b": [1, "x"]}
    assert source.place(("b", 1)).source == "b: [1, x]"


def test_a_file_that_cannot_be_had(tmp_path):
    (tmp_path / "grammar.yaml").write_text("a: 1")
    (problem,) = read_yaml(tmp_path / "gramar.yaml").problems
    assert (problem.message, problem.hint) == ("no such file", "did you mean 'grammar.yaml'?")
    (problem,) = read_yaml(tmp_path).problems
    assert problem.message == "is a folder, not a file"


def test_a_link_to_nothing(tmp_path):
    (tmp_path / "grammar.yaml").symlink_to("moved.yaml")
    (problem,) = read_yaml(tmp_path / "grammar.yaml").problems
    assert problem.message == "is a link to moved.yaml, which is not there"
    assert problem.hint == "mend the link, or give the path of a YAML file"


def test_an_ending_alone_makes_no_file_the_one_that_was_meant(tmp_path):
    (tmp_path / "wave.yaml").write_text("a: 1\n", "utf-8")
    (problem,) = read_yaml(tmp_path / "nowhere.yaml").problems
    assert problem.hint == "give the path of a YAML file"
    (problem,) = read_yaml(tmp_path / "wav.yaml").problems
    assert problem.hint == "did you mean 'wave.yaml'?"
