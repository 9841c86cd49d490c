"""``intent-engine sample``: random sentences of a grammar, each with its meaning."""

from __future__ import annotations

from typing import Annotated

import typer

from intent_engine.cli.describe import action_text, meaning_text
from intent_engine.cli.guard import verb
from intent_engine.cli.options import Grammars, Json, Language, Locations, States, known_states, load_engine
from intent_engine.cli.terminal import json_line, say

__all__ = ["sample"]


@verb
def sample(
    grammar: Grammars = None,
    locations: Locations = None,
    language: Language = None,
    count: Annotated[int, typer.Option("--count", "-n", min=1, help="How many sentences.")] = 20,
    intent: Annotated[str | None, typer.Option(help="Only sentences of this intent.")] = None,
    seed: Annotated[int, typer.Option(help="The same seed gives the same sentences.")] = 0,
    state: States = None,
    as_json: Json = False,
) -> int:
    """Show what can be said: random sentences with the meaning that they were made from."""
    from intent_engine.actions import to_json
    from intent_engine.language.sampler import RandomChoices, Sampler

    engine = load_engine(grammar, locations, language)
    sampler = Sampler(engine.matcher(language).grammar, engine.locations, state=known_states(engine, state))
    choices = RandomChoices(seed)
    for _ in range(count):
        drawn = sampler.draw(choices, intent)
        if as_json:
            actions = [to_json(action) for action in drawn.actions]
            json_line({"text": drawn.text, "intent": drawn.intent, "slots": dict(drawn.slots), "actions": actions})
        else:
            say(drawn.text)
            meaning = f"    {meaning_text(drawn.intent, drawn.slots)}"
            actions_text = "; ".join(action_text(action) for action in drawn.actions if action.type != "custom")
            say(f"{meaning} -> {actions_text}" if actions_text else meaning, "dim")
    return 0
