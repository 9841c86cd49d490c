"""How what was understood is told: as one command, several in a row, or a stop."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import TypeAlias

from intent_engine.actions import Action, Stop
from intent_engine.interpretation import Cause, Interpretation, Question, Status
from intent_engine.language.context.answers import with_name
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause, slot_values
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = [
    "Understood",
    "as_stop",
    "as_told",
    "as_told_together",
    "asked_back",
    "free_words_of",
    "names_any",
    "only",
    "readings_of",
    "told_before",
    "which_number",
]

Understood: TypeAlias = tuple[Interpretation, tuple[Clause, ...]]
"""What a text means, and the commands of which that is made; none where nothing but a stop or a refusal came of it."""


def as_told(text: str, clause: Clause) -> Understood:
    """One command as it is told: accepted, ambiguous, or rejected."""
    reading = clause.reading
    intent = reading.intent.name if reading is not None else None
    slots = slot_values(reading) if reading is not None else {}
    if clause.action is not None and reading is not None:
        actions, needs = (clause.action,), (reading.intent.needs,)
        found = Interpretation(
            text, Status.ACCEPTED, intent, slots, actions, reading.score, (), clause.reason, clause.causes, needs=needs
        )
    else:
        status = Status.AMBIGUOUS if clause.ambiguous else Status.REJECTED
        asked = asked_back(text, clause)
        names, reason, causes = clause.alternatives, clause.reason, clause.causes
        found = Interpretation(text, status, intent, slots, (), 0.0, names, reason, causes, question=asked)
    return found, (clause,)


def asked_back(text: str, clause: Clause) -> Question | None:
    """What is asked where a command names what is not clear, or is not known but like something; None: nothing."""
    reading, slot = clause.reading, clause.wrong_slot
    if reading is None or slot is None or not clause.alternatives:
        return None
    if clause.alternatives != tuple(name for name, _ in slot.rivals[: len(clause.alternatives)]):
        return None
    said = reading.words[slot.start : slot.end]
    choices = tuple(with_name(text, said, name) for name in clause.alternatives)
    return Question(choices) if any(choices) else None


def as_stop(text: str, intent: str) -> Understood:
    """A stop as it is told, whatever was said besides; ``intent`` is the one of the grammar that stops."""
    return Interpretation(text, Status.ACCEPTED, intent, {}, (Stop(),), 1.0), ()


def told_before(
    core: Utterance, place: int, sequence: PhraseSet, as_said: Callable[[Utterance], Understood | None]
) -> Understood | None:
    """What the commands before a place mean, up to a pause or a joint that is as near to it as can be; None: nothing.

    Args:
        core: what was said.
        place: of a word that points back.
        sequence: the words between commands.
        as_said: what an utterance means; None: it is no command.
    """
    ends = (end for end in range(place - 1, 0, -1) if core.breaks[end] or sequence.at(core.words, end))
    return next(filter(None, (as_said(core.part(0, end)) for end in ends)), None)


def as_told_together(text: str, parts: Sequence[Clause], stop_intent: str) -> Understood:
    """Accepted commands in a row as they are told: one alone as itself, several of which one stops as that stop."""
    if len(parts) == 1:
        return as_told(text, parts[0])
    if any(isinstance(part.action, Stop) for part in parts):
        return as_stop(text, stop_intent)[0], tuple(parts)
    steps = []
    score = 1.0
    for part in parts:
        assert part.reading is not None
        steps.append({"intent": part.reading.intent.name, "slots": slot_values(part.reading)})
        score *= part.reading.score
    actions = tuple(part.action for part in parts if part.action is not None)
    needs = tuple(part.reading.intent.needs for part in parts if part.reading is not None)
    reasons = "; ".join(part.reason for part in parts if part.reason)
    causes = frozenset[Cause]().union(*(part.causes for part in parts))
    found = Interpretation(
        text, Status.ACCEPTED, "compound", {"steps": steps}, actions, score, (), reasons, causes, needs=needs
    )
    return found, tuple(parts)


def free_words_of(understood: Understood) -> frozenset[str]:
    """The words of an interpretation that are free."""
    return frozenset(
        word
        for reading in readings_of(understood)
        for slot in reading.slots
        if slot.slot.type in FREE_KINDS
        for word in reading.words[slot.start : slot.end]
    )


def readings_of(understood: Understood | None) -> list[Reading]:
    """What the words of an interpretation were read as, command by command."""
    return [part.reading for part in understood[1] if part.reading is not None] if understood is not None else []


def names_any(reading: Reading | None, words: Collection[str]) -> bool:
    """Whether free words begin with one of some words: "sich Anna" is nobody."""
    if reading is None:
        return False
    return any(slot.slot.type in FREE_KINDS and reading.words[slot.start] in words for slot in reading.slots)


def which_number(written: str, language: str) -> str:
    """Why a number with a point or a comma is none: "1,500" may be fifteen hundred, or one and a half."""
    digits = written.replace(",", ".")
    thousands, decimals = digits.replace(".", ""), digits.rstrip("0").rstrip(".")
    decimals = f"0{decimals}" if decimals.startswith(".") else decimals
    if language != "en":
        decimals = decimals.replace(".", ",")
    return f"{written!r} could be {thousands} or {decimals}; write one of these, or say it in words"


def only(found: Iterable[Understood | None]) -> Understood | None:
    """What is understood in any of several ways; None: nothing is, or it is not the same in all."""
    meanings: dict[tuple[Action, ...], Understood] = {}
    for one in found:
        if one is not None:
            meanings.setdefault(one[0].actions, one)
    return next(iter(meanings.values())) if len(meanings) == 1 else None
