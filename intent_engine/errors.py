"""What can go wrong, as few types as a caller can tell apart.

Every message is written for the person who caused it: what is wrong, where, why, and what to do about it.
Only these types leave the package on bad input; the command line prints them without a traceback and exits
with ``exit_code``.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass

__all__ = [
    "AudioError",
    "ConfigError",
    "DeviceError",
    "IntentEngineError",
    "Problem",
    "RobotError",
    "TextTooLongError",
    "WeightsError",
]


LONGEST_SHOWN = 200
"""Characters of a line that are shown; a file that a program wrote may have all of it on one."""


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing wrong in a file that a person wrote."""

    message: str
    """What is wrong, in one sentence."""
    file: str | None = None
    """The file, as the person named it."""
    line: int | None = None
    """Line, counted from 1."""
    column: int | None = None
    """Column, counted from 1."""
    source: str | None = None
    """The line itself, to show with a caret under the column."""
    hint: str | None = None
    """What to do, or what was probably meant."""

    def __str__(self) -> str:
        where = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        text = f"{where}: {self.message}" if where else self.message
        if self.source is not None:
            shown, before = _cut(self.source, self.column or 1)
            text += f"\n    {shown}"
            if self.column is not None:
                text += f"\n    {''.join(map(_blank, before))}^"
        if self.hint:
            text += f"\n    {self.hint}"
        return text


def _cut(source: str, column: int) -> tuple[str, str]:
    """What is shown of a line, all of it unless it is too long to be seen at once, and what of that stands before a
    column."""
    begin = max(0, min(column - 1 - LONGEST_SHOWN // 2, len(source) - LONGEST_SHOWN))
    head, tail = "..." * (begin > 0), "..." * (len(source) > begin + LONGEST_SHOWN)
    before = head + source[begin : column - 1] + " " * (column - 1 - len(source))
    return head + source[begin : begin + LONGEST_SHOWN] + tail, before


def _blank(sign: str) -> str:
    """As much room as a sign takes on a terminal."""
    if sign == "\t":
        return sign
    return "" if unicodedata.combining(sign) else " " * (1 + (unicodedata.east_asian_width(sign) in "WF"))


class IntentEngineError(Exception):
    """Base of every error that this package raises on purpose."""

    exit_code = 1


class ConfigError(IntentEngineError):
    """A grammar, map or robot file is missing or wrong. Holds *all* problems found, not only the first."""

    exit_code = 2

    def __init__(
        self, problems: Problem | str | list[Problem] | tuple[Problem, ...], files: Iterable[str] = ()
    ) -> None:
        if isinstance(problems, str):
            problems = Problem(problems)
        if isinstance(problems, Problem):
            problems = [problems]
        self.problems: tuple[Problem, ...] = tuple(dict.fromkeys(problems))
        self.files: tuple[str, ...] = tuple(files)
        """Files that were read or looked for, in any of which it may be mended; empty where nobody kept account."""
        super().__init__("\n".join(str(problem) for problem in self.problems))


class AudioError(IntentEngineError):
    """An audio file or stream cannot be used: missing, empty, truncated, not audio, too long."""

    exit_code = 3


class DeviceError(IntentEngineError):
    """No microphone, no PortAudio, or no permission."""

    exit_code = 4


class WeightsError(IntentEngineError):
    """Model weights are missing or do not match their digest, or the model fails at everything that it hears."""

    exit_code = 5


class RobotError(IntentEngineError):
    """A robot could not do what it was told, or cannot be reached."""

    exit_code = 6


class TextTooLongError(IntentEngineError):
    """A text is longer than any command; nothing was parsed."""

    exit_code = 7
