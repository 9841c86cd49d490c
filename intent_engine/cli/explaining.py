"""Explanations in words, for the terminal."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from intent_engine.cli.describe import interpretation_lines, slots_text

if TYPE_CHECKING:
    from intent_engine.language.explanation import Candidate, Explanation, SlotSource, Step

__all__ = ["explanation_lines"]

Line = tuple[str, str | None]


def explanation_lines(found: Explanation) -> Iterator[Line]:
    """The path from a text to its meaning, line by line, each with its style."""
    words = " ".join(("| " if word.pause else "") + word.word for word in found.words)
    yield f"words: {words or 'none'}", "bold"
    for noticed in found.noticed:
        yield f"  {noticed.kind}: {noticed.words}", "dim"
    yield "steps:", "bold"
    for step in found.steps:
        yield from _step(step, 1)
    for number, slots in enumerate(found.slots, start=1):
        if slots:
            yield ("slots:" if len(found.slots) == 1 else f"slots of command {number}:"), "bold"
            for slot in slots:
                yield f"  {_source(slot)}", None
    yield from interpretation_lines(found.interpretation)


def _step(step: Step, depth: int) -> Iterator[Line]:
    indent = "  " * depth
    yield f"{indent}{step.name}: {step.words!r}: {step.outcome}", None
    for candidate in step.candidates:
        yield f"{indent}  {_candidate(candidate)}", "dim" if candidate.refused else "green"
        yield f"{indent}    {candidate.place}: {candidate.sentence}", "dim"
    for inner in step.steps:
        yield from _step(inner, depth + 1)
    if step.untold:
        yield f"{indent}  and {step.untold} more", "dim"


def _candidate(candidate: Candidate) -> str:
    slots = slots_text({slot.name: slot.value for slot in candidate.slots})
    head = f"{candidate.score:.2f} {candidate.intent} {slots}".rstrip()
    return f"{head}; refused: {candidate.refused}" if candidate.refused else f"{head}; taken"


def _source(slot: SlotSource) -> str:
    value = slots_text({slot.name: slot.value}) if slot.value is not None else slot.name
    if slot.source == "default":
        return f"{value}: the default"
    if slot.source == "condition":
        return f"{value}: the default where {slot.words}"
    if slot.source == "sentence":
        return f"{value}: the sentence has it"
    if slot.how == "exact":
        return f"{value}: said {slot.words!r}"
    rivals = ", ".join(f"{name} {score:.2f}" for name, score in slot.rivals)
    return f"{value}: said {slot.words!r}, {slot.how}" + (f" ({rivals})" if rivals else "")
