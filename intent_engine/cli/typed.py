"""Sentences that are typed: how long one may be."""

from __future__ import annotations

from intent_engine.errors import TextTooLongError

__all__ = ["MAX_TEXT", "check_length", "too_long"]

MAX_TEXT = 10_000
"""Characters. No one says a command this long; what is longer is a file given by mistake."""


def check_length(text: str) -> None:
    """Raise, if a text is longer than any command.

    Raises:
        TextTooLongError: it is.
    """
    if len(text) > MAX_TEXT:
        raise too_long(f"the text ({len(text)} characters)")


def too_long(what: str) -> TextTooLongError:
    return TextTooLongError(
        f"{what} is longer than {MAX_TEXT} characters, so it is no command, and nothing was done\n"
        "    give one sentence; to read a file of sentences, one a line: intent-engine parse - < sentences.txt"
    )
