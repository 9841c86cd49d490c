"""Names of languages as people and systems write them."""

from __future__ import annotations

import re

__all__ = ["language_of"]

_TAG = re.compile(r"([a-z]{2,3})(?:[-_][a-z0-9]{1,8})*", re.IGNORECASE | re.ASCII)
"""BCP 47, with the underscore of POSIX too; what is longer than three letters is no language that anybody speaks."""


def language_of(tag: str) -> str:
    """The language of a tag, by which grammars are found: ``en`` of ``en-US``; what is no tag, as it is."""
    found = _TAG.fullmatch(tag)
    return found[1].lower() if found else tag
