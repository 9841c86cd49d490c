"""YAML read with the place of every value, so that an error can point at it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import Place
from intent_engine.language.loading.json_mistakes import json_problem
from intent_engine.language.loading.lost_words import lost_words
from intent_engine.language.loading.spoilt_lines import (
    after_a_quote,
    merge_conflict,
    section_of_ini,
    spoilt_before,
    typographic_quote,
    without_colon,
    without_dash,
)
from intent_engine.language.loading.text_file import TooLargeError, text_of

__all__ = ["YamlSource", "near_file", "not_utf8", "read_yaml"]

MAX_COPIES = 100_000
"""Values that aliases may repeat; nested aliases can unfold a page to more than any memory holds."""

MAX_BRACKETS = 100
MAX_INDENT = 400
"""Brackets in brackets, and characters before the first word of a line. Nobody writes more, and the YAML library in C
overflows its stack, and ends the process, on some ten thousand."""

SHORTEST = "the shortest grammar: intents: {wave: {action: custom, sentences: [wave]}}"

_BESIDE_BRACKETS = re.compile(r"[\[{,:]\s*[^\s\[\]{}\"',:][^\[\]{}\"',:]*\s[{\[]$|[\]}]\s*\w$")
"""Words without quotes within brackets on one line, beside others: "[go {place}", "{1: degrees [celsius", "[[a] b"."""

NAMED = {("intents",), ("slots",), ("phrases",)}
"""Sections of a grammar whose keys are names that somebody gave."""

YamlPath = tuple[str | int, ...]

_Loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@dataclass
class YamlSource:
    """The data of a file, where each value stands, and what was wrong on the way."""

    file: str
    data: Any = None
    lines: list[str] = field(default_factory=list)
    marks: dict[YamlPath, tuple[int, int]] = field(default_factory=dict)
    """Path -> (line, column) of the value, from 0."""
    key_marks: dict[YamlPath, tuple[int, int]] = field(default_factory=dict)
    raw: dict[YamlPath, str] = field(default_factory=dict)
    """Path -> the scalar as written, where YAML read something else than text."""
    problems: list[Problem] = field(default_factory=list)
    broken: set[YamlPath] = field(default_factory=set)
    """Values of which a problem has been told already; nobody should look at them again."""

    absent: list[str] = field(default_factory=list)
    """Files that it names and that are not there."""

    folded: set[YamlPath] = field(default_factory=set)
    """Texts without quotes that stand on several lines, which YAML reads as one."""

    def entries(self, path: YamlPath, value: Any) -> Iterator[tuple[YamlPath, Any, Any]]:
        """(path, key or index, value) of what a mapping or list holds, without what is broken; nothing if it is so. A
        text is a list of one, unless it looks like several."""
        if path in self.broken:
            return
        if isinstance(value, str):
            if path in self.folded:
                self.broken.add(path)
                self.problem(path, "YAML reads these lines as one text", "begin each with '- ', or quote what is one")
                return
            yield path, 0, value
            return
        pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
        for key, item in pairs:
            if (*path, key) not in self.broken:
                yield (*path, key), key, item

    def place(self, path: YamlPath, offset: int = 0, key: bool = False) -> Place:
        """Where the value (or key) at a path stands; ``offset`` columns into it."""
        marks = self.key_marks if key and path in self.key_marks else self.marks
        while path and path not in marks:
            path = path[:-1]
        line, column = marks.get(path, (0, 0))
        source = self.lines[line] if line < len(self.lines) else ""
        if offset and source[column : column + 1] in ("'", '"'):
            offset += 1
        return Place(self.file, line + 1, min(column + offset, max(len(source) - 1, 0)) + 1, source)

    def problem(
        self, path: YamlPath, message: str, hint: str | None = None, offset: int = 0, key: bool = False
    ) -> None:
        place = self.place(path, offset, key)
        self.problems.append(Problem(message, self.file, place.line, place.column, place.source, hint))


def read_yaml(path: str | Path, *, shortest: str = SHORTEST) -> YamlSource:
    """Read a file; what is wrong with it as YAML is in ``problems``, and then ``data`` is None.

    Args:
        path: where it is.
        shortest: what to do about an empty one.
    """
    source = YamlSource(str(path))
    file = Path(path)
    try:
        text = text_of(file)
    except TooLargeError:
        source.problems.append(Problem("is larger than 64 MiB", str(path), hint="is this the right file?"))
        return source
    except FileNotFoundError:
        if file.is_symlink():
            message = f"is a link to {file.readlink()}, which is not there"
            source.problems.append(Problem(message, str(path), hint="mend the link, or give the path of a YAML file"))
            return source
        hint = near_file(file) or "give the path of a YAML file"
        source.problems.append(Problem("no such file", str(path), hint=hint))
        return source
    except IsADirectoryError:
        source.problems.append(Problem("is a folder, not a file", str(path), hint="give the path of a YAML file"))
        return source
    except UnicodeDecodeError as error:
        source.problems.append(not_utf8(str(path), error))
        return source
    except OSError as error:
        source.problems.append(Problem(f"cannot be read: {error.strerror}", str(path)))
        return source
    except ValueError:
        source.problems.append(Problem(f"{str(path)!r} is the path of no file", hint="give the path of a YAML file"))
        return source
    return parse_yaml(text, source, shortest)


def not_utf8(name: str, error: UnicodeDecodeError, otherwise: str = "is this the right file?") -> Problem:
    """Where the first byte stands that is no UTF-8, and what the file may be instead.

    Args:
        name: of the file.
        error: that came of reading it.
        otherwise: what to do about one that is no text at all.
    """
    data = bytes(error.object)
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return Problem("is UTF-16 text, not UTF-8", name, hint="save it as UTF-8")
    if b"\0" in data[:4096]:
        return Problem("is no text at all", name, hint=otherwise)
    start = data.rfind(b"\n", 0, error.start) + 1
    end = data.find(b"\n", error.start)
    line = data[start : end if end >= 0 else len(data)].decode("utf-8", "replace").rstrip("\r")
    before = data[start : error.start].decode("utf-8", "replace")
    message = f"is not UTF-8 text: byte {data[error.start]:#04x}"
    return Problem(message, name, data.count(b"\n", 0, error.start) + 1, len(before) + 1, line, "save it as UTF-8")


def parse_yaml(text: str, source: YamlSource, shortest: str = "") -> YamlSource:
    """Fill ``source`` from text."""
    source.lines = text.splitlines()
    if (section := section_of_ini(source.lines)) is not None:
        place, hint = (section + 1, 1, source.lines[section]), "it is written otherwise here: docs/migrating.md"
        source.problems.append(Problem("is an INI file, as of Rhasspy, and no YAML", source.file, *place, hint))
        return source
    if (deep := _too_deep(text)) is not None:
        hint = f"at most {MAX_BRACKETS} brackets in brackets; is this the right file?"
        source.problems.append(Problem("is nested too deeply", source.file, deep + 1, hint=hint))
        return source
    try:
        node = yaml.compose(text, Loader=_Loader)
        if node is None:
            source.problems.append(Problem("is empty", source.file, hint=shortest))
            return source
        source.data = _Reader(source).plain(node, (), frozenset())
        if source.data is None and not source.problems:
            source.problems.append(Problem("is empty", source.file, hint=shortest))
    except yaml.MarkedYAMLError as error:
        found = json_problem(text, source.file) if source.file.endswith(".json") else None
        source.problems.append(found or _syntax_problem(error, source))
    except yaml.reader.ReaderError:
        source.problems.append(_character_problem(text, source))
    except (yaml.YAMLError, ValueError) as error:
        source.problems.append(Problem(f"is not valid YAML: {error}", source.file))
    except RecursionError:
        source.problems.append(Problem("is nested too deeply", source.file))
    return source


def _too_deep(text: str) -> int | None:
    """The line, from 0, at which a text may be nested too deeply to be parsed; brackets in quotes count as well."""
    if (indented := re.search(rf"^[ \t\-?:]{{{MAX_INDENT},}}", text, re.MULTILINE)) is not None:
        return text.count("\n", 0, indented.start())
    if text.count("[") + text.count("{") <= MAX_BRACKETS:
        return None
    depth = 0
    for bracket in re.finditer(r"[\[\]{}]", text):
        depth = depth + 1 if bracket[0] in "[{" else max(depth - 1, 0)
        if depth > MAX_BRACKETS:
            return text.count("\n", 0, bracket.start())
    return None


def _character_problem(text: str, source: YamlSource) -> Problem:
    place = next((place for place, one in enumerate(text) if yaml.reader.Reader.NON_PRINTABLE.match(one)), 0)
    message = f"holds a character that YAML does not allow: {text[place]!a}"
    line, column = text.count("\n", 0, place), place - (text.rfind("\n", 0, place) + 1)
    shown = text.split("\n")[line].rstrip("\r").replace(text[place], "\N{REPLACEMENT CHARACTER}")
    return Problem(message, source.file, line + 1, column + 1, shown, "remove it")


def _syntax_problem(error: yaml.MarkedYAMLError, source: YamlSource) -> Problem:
    """What the YAML parser says, at a line that there is, with what people usually did wrong there."""
    mark, opened = error.problem_mark or error.context_mark, error.context_mark
    if (conflict := merge_conflict(source.lines)) is not None:
        return Problem(conflict[1], source.file, conflict[0] + 1, 1, source.lines[conflict[0]], conflict[2])
    hint: str | None = None
    if error.context == "while scanning a quoted scalar" and opened is not None:
        message = "is not valid YAML: a quote that is opened here is never closed"
        hint = "close it, or write the quote of a word as '' inside single quotes"
        shown = source.lines[opened.line]
        hint = typographic_quote(shown[opened.column + 1 :]) or hint
        return Problem(message, source.file, opened.line + 1, opened.column + 1, shown, hint)
    line, column = (mark.line, mark.column) if mark else (0, 0)
    while line > 0 and (line >= len(source.lines) or not source.lines[line].strip()):
        line -= 1
        column = len(source.lines[line]) if line < len(source.lines) else 0
    shown = source.lines[line] if line < len(source.lines) else ""
    what = str(error.problem or error.context)
    message = f"is not valid YAML: {what}"
    indent = shown[: len(shown) - len(shown.lstrip())]
    other = spoilt_before(source.lines, line)
    if other is None and re.search("mapping values are not allowed|expected (?:key|':')", what):
        other = without_colon(source.lines, line) or without_dash(source.lines, line)
    if other is not None:
        return Problem(other[1], source.file, other[0] + 1, None, source.lines[other[0]], other[2])
    if "\t" in indent:
        message, hint = "a tab indents this line; YAML allows spaces alone", "use two spaces for each level"
    elif "another document" in what:
        message, hint = "a second document begins here", "remove the ---; write a second file and include: it"
    elif "aliases unfold" in what or "stands within" in what:
        hint = "write out what is meant in the place of the alias"
    elif "undefined alias" in what:
        hint = "quote it if it is a sentence; an alias *name needs an anchor &name before it"
    elif "unknown escape" in what:
        hint = "write it in single quotes: between double ones YAML reads \\ as the beginning of a sign"
    elif (quoted := after_a_quote(source.lines, line, column) or typographic_quote(shown)) is not None:
        hint = quoted
    elif re.match(r"\s*-\t", shown):
        message, hint = "a tab stands behind this '-'", "write a space there"
    elif re.match(r"\s*-\s+[|>]", shown):
        hint = "quote a sentence that begins with | or >"
    elif column == len(indent) and re.search("expected (?:'-'|key|<block end>)", what):
        hint = "check that this line is indented like its neighbours"
    elif opened is not None and _BESIDE_BRACKETS.search(shown[: column + 1]):
        hint = "quote a sentence that holds { or ["
    elif opened is not None and what.startswith("did not find expected ',' or"):
        hint = f"the bracket that is opened at line {opened.line + 1}, column {opened.column + 1} is not closed"
    elif (
        "expected '-'" in what
        or re.search(r"-\s+[{\[]", shown)
        or ("expected key" in what and re.search(r":\s+[{\[]", shown))
    ):
        hint = "quote a sentence that begins with { or ["
    elif "mapping values are not allowed" in what:
        hint = "quote text that holds ': ', and check that this line is indented like its neighbours"
    elif re.search(r"[:-]\s+[%@`*&]", shown):
        hint = "quote text that begins with this character"
    elif "could not find expected ':'" in what or "expected <block end>" in what or "block mapping" in what:
        hint = "check that this line is indented like its neighbours, and that quotes are closed"
    return Problem(message, source.file, line + 1, column + 1, shown, hint)


class _Earlier(str):
    """A name that stands once more further down; no other key is like it, so both have their entry and are checked."""

    __slots__ = ()
    __hash__ = object.__hash__

    def __eq__(self, other: object) -> bool:
        return self is other

    def __ne__(self, other: object) -> bool:
        return self is not other


def _marked(what: str, node: Any) -> yaml.MarkedYAMLError:
    return yaml.MarkedYAMLError(problem=what, problem_mark=node.start_mark)


class _Reader:
    """Nodes of the YAML parser to plain data."""

    def __init__(self, source: YamlSource) -> None:
        self._source = source
        self._met: set[int] = set()
        self._copies = 0

    def plain(self, node: Any, path: YamlPath, above: frozenset[int]) -> Any:
        source = self._source
        source.marks[path] = (node.start_mark.line, node.start_mark.column)
        if id(node) in self._met:
            self._copies += 1
            if self._copies > MAX_COPIES:
                raise _marked(f"aliases unfold to more than {MAX_COPIES:,} values", node)
        else:
            self._met.add(id(node))
        if isinstance(node, yaml.ScalarNode):
            if not node.style and node.end_mark.line > node.start_mark.line:
                source.folded.add(path)
            elif (lost := lost_words(node, source.lines)) is not None:
                source.problem(path, *lost)
            return _scalar(node, path, source)
        if id(node) in above:
            raise _marked("an alias *name stands within what its anchor &name holds", node)
        above = above | {id(node)}
        if isinstance(node, yaml.SequenceNode):
            return [self.plain(child, (*path, index), above) for index, child in enumerate(node.value)]
        result: dict[str, Any] = {}
        merged: dict[str, Any] = {}
        read: dict[str, tuple[Any, tuple[int, int]]] = {}
        for key_node, value_node in node.value:
            if not isinstance(key_node, yaml.ScalarNode):
                source.problem(path, "a key must be plain text", "quote it if it holds brackets")
                continue
            key = key_node.value
            here = (*path, key)
            if key_node.tag == "tag:yaml.org,2002:merge":
                mark = source.marks[path]
                merged |= self._merged(value_node, here, above)
                source.marks[path] = mark
                continue
            source.key_marks[here] = (key_node.start_mark.line, key_node.start_mark.column)
            if key in result and path in NAMED:
                earlier, (first, mark) = _Earlier(key), read[key]
                source.key_marks[*path, earlier] = mark
                result[earlier] = self.plain(first, (*path, earlier), above)
            read[key] = value_node, source.key_marks[here]
            if key in result:
                source.problem(here, f"{key!r} stands twice; the first would be lost", "rename or merge them", key=True)
            _scalar(key_node, (*here, "\0key"), source)
            result[key] = self.plain(value_node, here, above)
        return {**merged, **result}

    def _merged(self, node: Any, path: YamlPath, above: frozenset[int]) -> dict[str, Any]:
        """What ``<<: *name`` takes over; it stands where the mapping stands that takes it."""
        found: dict[str, Any] = {}
        nodes = node.value if isinstance(node, yaml.SequenceNode) else [node]
        for one in reversed(nodes):
            value = self.plain(one, path[:-1] if isinstance(one, yaml.MappingNode) else path, above)
            if isinstance(value, dict):
                found |= value
            else:
                self._source.problem(path, "'<<' takes over mappings alone", "give it the alias of a mapping")
        return found


_CONSTRUCTOR = yaml.SafeLoader("")
_READ: Mapping[str, Callable[[Any], Any]] = {
    "bool": _CONSTRUCTOR.construct_yaml_bool,
    "int": _CONSTRUCTOR.construct_yaml_int,
    "float": _CONSTRUCTOR.construct_yaml_float,
    "null": _CONSTRUCTOR.construct_yaml_null,
    "timestamp": lambda node: node.value,
}
_READ_OTHERWISE = re.compile(r"[-+]?0[0-7_]+|.*:.*")
"""Numbers that YAML 1.1 takes for octal, "010" for 8, and for minutes and seconds, "1:30" for 90. Nobody who writes a
file means these; they stay the text that they are, which is no number."""


_FLOAT_OF_JSON = re.compile(r"-?[0-9]+e[-+][0-9]+")
"""Small and large numbers as programs write them, 1e-05: to YAML 1.1, unlike 1.2, they are words without a "."."""


def _scalar(node: Any, path: YamlPath, source: YamlSource) -> Any:
    tag = node.tag.rsplit(":", 1)[-1]
    if tag == "str" and not node.style and _FLOAT_OF_JSON.fullmatch(node.value):
        tag = "float"
    read = _READ.get(tag)
    if read is None:
        return node.value
    source.raw[path] = node.value
    if tag in ("int", "float") and _READ_OTHERWISE.fullmatch(node.value):
        return node.value
    try:
        return read(node)
    except (ValueError, KeyError, yaml.YAMLError):  # "!!bool maybe"
        return node.value


def near_file(file: Path) -> str | None:
    """A hint which file was probably meant by one that is not there, of those in its folder; None: there is none."""
    try:
        neighbours = [other.name for other in file.parent.iterdir() if did_you_mean(file.stem, [other.stem])]
    except OSError:
        return None
    return did_you_mean(file.name, neighbours)
