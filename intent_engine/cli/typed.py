"""Sentences that are typed: how long one may be."""

from __future__ import annotations

import os

from intent_engine.errors import TextTooLongError

__all__ = ["MAX_TEXT", "check_length", "readable", "too_long"]

MAX_TEXT = 10_000
"""Characters. No one says a command this long; what is longer is a file given by mistake."""


def readable(text: str) -> str:
    """A text of the command line that is UTF-8 where the system's locale is another, as ``LC_ALL=C``; else as it is."""
    if text.isascii() or not any("\udc80" <= sign <= "\udcff" for sign in text):
        return text
    try:
        return os.fsencode(text).decode("utf-8")
    except UnicodeError:
        return text


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
