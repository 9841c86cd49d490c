"""``--watch``: a grammar that is edited while the engine runs."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.options import tell_doubts
from intent_engine.cli.terminal import note

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.errors import ConfigError

__all__ = ["Watch", "watched"]

Watch = Annotated[bool, typer.Option("--watch", help="Take up changes of the grammar and map while running.")]


@contextlib.contextmanager
def watched(engine: IntentEngine, given: list[str] | None, wanted: bool = True) -> Iterator[None]:
    """Reload the engine when its files change, as long as the block lasts, and say so on standard error.

    Args:
        engine: that was loaded.
        given: its grammars as the option named them; None: the shipped one.
        wanted: whether the option was given.

    Raises:
        ConfigError: the ``watchfiles`` package is not installed.
    """
    if not wanted:
        yield
        return
    from intent_engine.watching import Watcher

    def told(error: ConfigError | None) -> None:
        if error is None:
            sentences = sum(len(one.all_sentences) for grammar in engine.grammars for one in grammar.intents.values())
            note(f"reloaded: {sentences} sentences, {len(engine.locations or ())} places")
            tell_doubts(engine, given)
        else:
            note(f"not reloaded, the old grammar stays in use:\n{error}")

    with Watcher(engine, told):
        yield
