"""What was heard against what was labelled, one recording at a time; then all of a condition together."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from enum import StrEnum
from typing import Any

from intent_engine.actions import Action, Custom, Stop
from intent_engine.actions import to_json as action_to_json
from intent_engine.evaluation.hearing import Hearing
from intent_engine.evaluation.labels import Row, Step, steps_of
from intent_engine.evaluation.sameness import same
from intent_engine.language.utterance import plain
from intent_engine.speech.recognizer import Transcript

__all__ = ["Condition", "Outcome", "Score", "Verdict", "judge", "plain", "quantile", "score", "wilson"]


class Verdict(StrEnum):
    """What came of a recording."""

    RIGHT = "right"
    """A command, and just that was done."""
    WRONG = "wrong"
    """A command, and something else was done."""
    MISSED = "missed"
    """A command, and nothing was done."""
    QUIET = "quiet"
    """No command, and nothing was done."""
    FALSE_ACCEPT = "false accept"
    """No command, and something was done."""


@dataclass(frozen=True, slots=True)
class Condition:
    """What one table row is about."""

    model: str
    snr: float | None = None
    """dB; None: without added noise."""

    @property
    def noise(self) -> str:
        return "none" if self.snr is None else f"{self.snr:g} dB"


@dataclass(frozen=True, slots=True)
class Outcome:
    """One recording in one condition."""

    row: Row
    condition: Condition
    verdict: Verdict
    heard: str
    free: str
    """Heard without the help of the grammar."""
    intents: tuple[str, ...]
    """What was acted on."""
    actions: tuple[Action, ...]
    slots: int = 0
    """Labelled slot values."""
    slots_right: int = 0
    latency: float | None = None
    """s from the end of speech to the first action, where that was right."""
    decode: float = 0.0
    """s that the last decode took."""
    held: float | None = None
    """s from the end of speech to the first time that the reflex held the robot, negative before it; None: never, or
    nobody knows when speech ended: the label does not say it, and nothing was acted on."""
    held_at: float | None = None
    """s since the sound began; None: never."""
    errors: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    """What was acted on, with its slots."""
    transcripts: tuple[Transcript, ...] = ()
    """What the recogniser made of it, utterance by utterance."""

    @property
    def unasked(self) -> bool:
        """Whether something was done that was not said and is more than a stop, which harms nobody."""
        mistaken = self.verdict in (Verdict.WRONG, Verdict.FALSE_ACCEPT)
        return mistaken and not (self.actions and all(isinstance(action, Stop) for action in self.actions))


def judge(row: Row, condition: Condition, hearing: Hearing) -> Outcome:
    """Score one recording."""
    steps = [step for act in hearing.acts for step in steps_of(act.meaning)]
    actions = hearing.actions
    verdict = _verdict(row, steps, actions)
    labelled = [(step, name) for step in row.expected.steps for name in step.slots]
    latency = None
    if verdict is Verdict.RIGHT and hearing.acts:
        first = hearing.acts[0]
        ended = row.speech_end if row.speech_end is not None and len(hearing.acts) == 1 else first.speech_ended
        latency = first.time - ended
    return Outcome(
        row,
        condition,
        verdict,
        " ".join(hearing.texts),
        " ".join(hearing.free_texts),
        tuple(step.intent for step in steps),
        actions,
        len(labelled),
        _slots_right(row.expected.steps, steps, actions),
        latency,
        hearing.decodes[-1] if hearing.decodes else 0.0,
        _held(row, hearing),
        hearing.holds[0] if hearing.holds else None,
        tuple(hearing.errors),
        tuple(steps),
        tuple(hearing.transcripts),
    )


def _held(row: Row, hearing: Hearing) -> float | None:
    if not hearing.holds:
        return None
    ended = row.speech_end
    if ended is None and hearing.acts:
        ended = hearing.acts[0].speech_ended
    return None if ended is None else hearing.holds[0] - ended


def _verdict(row: Row, steps: Sequence[Step], actions: Sequence[Action]) -> Verdict:
    expected = row.expected
    acted = bool(steps or actions)
    if not expected.command:
        return Verdict.FALSE_ACCEPT if acted else Verdict.QUIET
    if not acted:
        return Verdict.MISSED
    if expected.stops and all(isinstance(action, Stop) for action in actions):
        steps, actions = _once(steps), actions[:1]  # a robot that is stopped twice is stopped
    right = (
        (not expected.steps or expected.by_text or _same_steps(expected.steps, steps, actions))
        and (expected.types is None or _of_types(expected.types, actions))
        and (expected.actions is None or _same_actions(expected.actions, actions))
    )
    return Verdict.RIGHT if right else Verdict.WRONG


def _once(steps: Sequence[Step]) -> Sequence[Step]:
    """One of several steps that are the same."""
    return steps[:1] if len({step.intent for step in steps}) == 1 else steps


def _same_steps(expected: Sequence[Step], found: Sequence[Step], actions: Sequence[Action]) -> bool:
    return len(expected) == len(found) and all(
        one.intent == other.intent and all(_came_out(name, one, other, default) for name in one.slots)
        for one, other, default in zip(expected, found, _defaults(found, actions), strict=True)
    )


def _came_out(name: str, expected: Step, found: Step, default: Mapping[str, Any]) -> bool:
    """Whether a labelled value was said, or taken where nothing was said."""
    value = expected.slots[name]
    return same(value, found.slots.get(name)) or (name not in found.slots and same(value, default.get(name)))


def _defaults(steps: Sequence[Step], actions: Sequence[Action]) -> Sequence[Mapping[str, Any]]:
    """What each of some commands hands to the user's program, said or not; nothing of other commands."""
    if len(steps) != len(actions):
        return [{}] * len(steps)
    return [action.slots if isinstance(action, Custom) else {} for action in actions]


def _of_types(types: Sequence[str], actions: Sequence[Action]) -> bool:
    """Whether each action is of the type that is labelled, or the custom action of that name."""
    return len(types) == len(actions) and all(
        wanted == action.type or (isinstance(action, Custom) and wanted == action.name)
        for wanted, action in zip(types, actions, strict=True)
    )


def _same_actions(expected: Sequence[Action], found: Sequence[Action]) -> bool:
    return len(expected) == len(found) and all(
        same(action_to_json(one), action_to_json(other)) for one, other in zip(expected, found, strict=True)
    )


def _slots_right(expected: Sequence[Step], found: Sequence[Step], actions: Sequence[Action]) -> int:
    """Labelled values that came out, step by step; none of a step whose intent is another."""
    return sum(
        _came_out(name, one, other, default)
        for one, other, default in zip(expected, found, _defaults(found, actions), strict=False)
        if one.intent == other.intent
        for name in one.slots
    )


# -- all together ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Score:
    """What a condition came to. Shares are from 0 to 1, times in s; None where there is nothing to count."""

    model: str
    noise: str
    recordings: int
    commands: int
    right: int
    wrong: int
    missed: int
    accuracy: float | None
    """Commands that were understood with all their labelled slots, of all commands."""
    accuracy_low: float | None
    """With so many recordings the accuracy on all such recordings lies between here ..."""
    accuracy_high: float | None
    """... and here, with 95 % confidence (Wilson's interval)."""
    slot_accuracy: float | None
    """Labelled slot values that came out."""
    others: int
    """Recordings that are no command."""
    false_accepts: int
    """Of these: acted on."""
    unasked: int
    """Of all recordings: something was done that was not said and is more than a stop."""
    word_error_rate: float | None
    """Wrong, missing and added words, of all words said."""
    free_word_error_rate: float | None
    """The same without the help of the grammar."""
    latency_p50: float | None
    """From the end of speech to the action, where it was the right one."""
    latency_p90: float | None
    latency_p99: float | None
    latency_max: float | None
    decode_p50: float | None
    decode_p90: float | None
    stops: int
    """Commands to stop."""
    stops_held: int
    """Of these: the reflex held the robot."""
    held_p50: float | None
    """From the end of a stop word to the hold; negative before it."""
    held_p90: float | None
    others_held: int
    """Recordings of anything else in which the reflex held the robot for a moment."""
    errors: int
    """Decodes that failed."""

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary, with times and shares of four digits."""
        values = {item.name: getattr(self, item.name) for item in fields(self)}
        return {name: round(value, 4) if isinstance(value, float) else value for name, value in values.items()}


def score(outcomes: Sequence[Outcome]) -> Score:
    """The score of one condition.

    Raises:
        ValueError: there are no outcomes.
    """
    if not outcomes:
        raise ValueError("nothing was heard")
    count = {verdict: sum(outcome.verdict is verdict for outcome in outcomes) for verdict in Verdict}
    commands = count[Verdict.RIGHT] + count[Verdict.WRONG] + count[Verdict.MISSED]
    low, high = wilson(count[Verdict.RIGHT], commands) if commands else (None, None)
    slots = sum(outcome.slots for outcome in outcomes)
    latencies = [outcome.latency for outcome in outcomes if outcome.latency is not None]
    decodes = [outcome.decode for outcome in outcomes if outcome.decode]
    condition = outcomes[0].condition
    stops = [outcome for outcome in outcomes if outcome.row.expected.stops]
    held = [outcome.held for outcome in stops if outcome.held is not None]
    stops_held = sum(outcome.held_at is not None for outcome in stops)
    return Score(
        model=condition.model,
        noise=condition.noise,
        recordings=len(outcomes),
        commands=commands,
        right=count[Verdict.RIGHT],
        wrong=count[Verdict.WRONG],
        missed=count[Verdict.MISSED],
        accuracy=count[Verdict.RIGHT] / commands if commands else None,
        accuracy_low=low,
        accuracy_high=high,
        slot_accuracy=sum(outcome.slots_right for outcome in outcomes) / slots if slots else None,
        others=count[Verdict.QUIET] + count[Verdict.FALSE_ACCEPT],
        false_accepts=count[Verdict.FALSE_ACCEPT],
        unasked=sum(outcome.unasked for outcome in outcomes),
        word_error_rate=_word_error_rate(outcomes, [outcome.heard for outcome in outcomes]),
        free_word_error_rate=_word_error_rate(outcomes, [outcome.free for outcome in outcomes]),
        latency_p50=quantile(latencies, 0.5),
        latency_p90=quantile(latencies, 0.9),
        latency_p99=quantile(latencies, 0.99),
        latency_max=quantile(latencies, 1.0),
        decode_p50=quantile(decodes, 0.5),
        decode_p90=quantile(decodes, 0.9),
        stops=len(stops),
        stops_held=stops_held,
        held_p50=quantile(held, 0.5),
        held_p90=quantile(held, 0.9),
        others_held=sum(outcome.held_at is not None for outcome in outcomes) - stops_held,
        errors=sum(len(outcome.errors) for outcome in outcomes),
    )


def quantile(values: Sequence[float], share: float) -> float | None:
    """The smallest value that at least this share of the values does not exceed; None of no values."""
    if not values:
        return None
    return sorted(values)[max(math.ceil(share * len(values)) - 1, 0)]


def wilson(right: int, whole: int, z: float = 1.96) -> tuple[float, float]:
    """Interval of a share that was counted (Wilson 1927); ``z`` = 1.96 is 95 %."""
    share = right / whole
    spread = z * math.sqrt(share * (1 - share) / whole + z * z / (4 * whole * whole))
    middle, scale = share + z * z / (2 * whole), 1 + z * z / whole
    # Rounding must not push an end beyond the share itself, where that is 0 or 1.
    return max(min((middle - spread) / scale, share), 0.0), min(max((middle + spread) / scale, share), 1.0)


def _word_error_rate(outcomes: Sequence[Outcome], heard: Sequence[str]) -> float | None:
    """Over all rows with words in their label; jiwer counts no row without."""
    import jiwer

    said, found = [], []
    for outcome, text in zip(outcomes, heard, strict=True):
        words = plain(outcome.row.text or "")
        if words:
            said.append(" ".join(words))
            found.append(" ".join(plain(text)))
    return float(jiwer.wer(said, found)) if said else None
