"""YAML read with the place of every value, so that an error can point at it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from intent_engine.errors import Problem
from intent_engine.language.grammar import Place

__all__ = ["YamlSource", "did_you_mean", "read_yaml"]

MAX_BYTES = 64 * 1024 * 1024
"""A file beyond this is not one that a person wrote for us."""

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


def read_yaml(path: str | Path) -> YamlSource:
    """Read a file; what is wrong with it as YAML is in ``problems``, and then ``data`` is None."""
    source = YamlSource(str(path))
    file = Path(path)
    try:
        if file.stat().st_size > MAX_BYTES:
            source.problems.append(Problem("is larger than 64 MiB", str(path), hint="is this the right file?"))
            return source
        text = file.read_text("utf-8")
    except FileNotFoundError:
        near = did_you_mean(file.name, (other.name for other in _neighbours(file)))
        source.problems.append(Problem("no such file", str(path), hint=near or "give the path of a YAML file"))
        return source
    except IsADirectoryError:
        source.problems.append(Problem("is a folder, not a file", str(path), hint="give the path of a YAML file"))
        return source
    except UnicodeDecodeError as error:
        source.problems.append(Problem(f"is not UTF-8 text (byte {error.start})", str(path), hint="save it as UTF-8"))
        return source
    except OSError as error:
        source.problems.append(Problem(f"cannot be read: {error.strerror}", str(path)))
        return source
    return parse_yaml(text, source)


def parse_yaml(text: str, source: YamlSource) -> YamlSource:
    """Fill ``source`` from text."""
    source.lines = text.splitlines()
    try:
        node = yaml.compose(text, Loader=_Loader)
        if node is None:
            source.problems.append(Problem("is empty", source.file, hint="see docs/grammar.md for the shortest file"))
            return source
        source.data = _plain(node, (), source, set())
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = mark.line if mark else 0
        shown = source.lines[line] if line < len(source.lines) else ""
        message = f"is not valid YAML: {error.problem or error.context}"
        hint = "quote sentences that hold ':' '#' '{' or '[' at their start" if "{" in shown or "[" in shown else None
        source.problems.append(Problem(message, source.file, line + 1, (mark.column if mark else 0) + 1, shown, hint))
    except (yaml.YAMLError, ValueError) as error:
        source.problems.append(Problem(f"is not valid YAML: {error}", source.file))
    except RecursionError:
        source.problems.append(Problem("is nested too deeply", source.file))
    return source


def _plain(node: Any, path: YamlPath, source: YamlSource, above: set[int]) -> Any:
    source.marks[path] = (node.start_mark.line, node.start_mark.column)
    if isinstance(node, yaml.ScalarNode):
        return _scalar(node, path, source)
    if id(node) in above:
        raise ValueError(f"line {node.start_mark.line + 1}: an alias that holds itself")
    above = above | {id(node)}
    if isinstance(node, yaml.SequenceNode):
        return [_plain(child, (*path, index), source, above) for index, child in enumerate(node.value)]
    result: dict[str, Any] = {}
    for key_node, value_node in node.value:
        if not isinstance(key_node, yaml.ScalarNode):
            source.problem(path, "a key must be plain text", "quote it if it holds brackets")
            continue
        key = key_node.value
        here = (*path, key)
        source.key_marks[here] = (key_node.start_mark.line, key_node.start_mark.column)
        if key in result:
            source.problem(here, f"{key!r} stands twice; the first would be lost", "rename or merge them", key=True)
        _scalar(key_node, (*here, "\0key"), source)
        result[key] = _plain(value_node, here, source, above)
    return result


_CONSTRUCTORS = yaml.SafeLoader("")


def _scalar(node: Any, path: YamlPath, source: YamlSource) -> Any:
    tag = node.tag.rsplit(":", 1)[-1]
    if tag == "str":
        return node.value
    if tag in ("bool", "int", "float", "null", "timestamp"):
        source.raw[path] = node.value
        if tag == "timestamp":
            return node.value
        try:
            return _CONSTRUCTORS.construct_object(node)
        except (ValueError, yaml.YAMLError):
            return node.value
    return node.value


def _neighbours(file: Path) -> Iterable[Path]:
    try:
        return list(file.parent.iterdir())
    except OSError:
        return []


def did_you_mean(word: str, known: Iterable[str]) -> str | None:
    """A hint naming the known word that is nearest, or None if none is near."""
    from rapidfuzz import fuzz, process

    found = process.extractOne(word, list(known), scorer=fuzz.ratio, score_cutoff=60)
    return f"did you mean {found[0]!r}?" if found else None
