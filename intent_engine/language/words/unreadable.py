"""Text of which a character was lost before it came here: nobody knows whether "go forward 1� meters" was 1½."""

from __future__ import annotations

import re
from dataclasses import replace

from intent_engine.actions import Stop
from intent_engine.interpretation import Interpretation, Status

__all__ = ["as_read"]

_LOST = re.compile("[\ufffd\ud800-\udfff]")
"""What decoders write in the place of bytes that are no text in their encoding."""


def as_read(said: str, found: Interpretation) -> Interpretation:
    """What a text means, or why nothing is done of it: it has a character that could not be read. Only a stop that was
    read is done in any case, and nothing beside it."""
    if said.isascii() or (lost := _LOST.search(said)) is None or not found.actions:
        return found
    reason = f"a character could not be read, behind {said[: lost.start()]!r}: give the text as UTF-8"
    if found.stops:
        return replace(found, actions=(Stop(),), needs=(), goes_on=False, reason=reason, causes=frozenset())
    return Interpretation(said, Status.REJECTED, found.intent, reason=reason, denied=found.denied)
