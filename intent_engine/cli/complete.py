"""``intent-engine complete``: how a sentence may go on."""

from __future__ import annotations

from typing import Annotated

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import Grammars, Json, Language, Locations, load_engine
from intent_engine.cli.terminal import json_line, note, say
from intent_engine.cli.typed import check_length, readable

__all__ = ["complete"]


@verb
def complete(
    text: Annotated[str, typer.Argument(help="The beginning of a sentence; its last word may be unfinished.")],
    grammar: Grammars = None,
    locations: Locations = None,
    language: Language = None,
    as_json: Json = False,
) -> int:
    """List the words with which a sentence may go on, one a line."""
    from intent_engine.prefix import PrefixStatus

    text = readable(text)
    check_length(text)
    engine = load_engine(grammar, locations, language)
    found = engine.prefix(text, language=language)
    words = found.next_words
    if found.status is PrefixStatus.IMPOSSIBLE and not text.endswith(" "):
        before, _, begun = text.rpartition(" ")
        words = tuple(
            word for word in engine.prefix(before, language=language).next_words if word.startswith(begun.lower())
        )
    if as_json:
        json_line({"text": text, "status": found.status.value, "next_words": list(words)})
    else:
        for word in words:
            say(word)
        if not words:
            note("nothing may follow" if found.status is PrefixStatus.COMPLETE else "no sentence begins so")
    return 0 if words or found.status is PrefixStatus.COMPLETE else EXIT_NOT_ACCEPTED
