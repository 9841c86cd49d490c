"""Words that tell whose something is: "Anna's son" is somebody else than Anna."""

from __future__ import annotations

import re

__all__ = ["owners"]

_OWNED = re.compile("(?<=[a-z0-9])['’ʼ`]s[.,;:!?\"]*$")


def owners(text: str) -> frozenset[str]:
    """The words of an English text that are written so, without their apostrophe."""
    return frozenset(_OWNED.sub("s", word) for word in text.lower().split() if _OWNED.search(word))
