"""What a sentence was understood to mean."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from intent_engine.actions import Action, Stop, from_json, to_json
from intent_engine.needs import Needs

__all__ = ["Cause", "Interpretation", "Question", "Status"]

_KINDS: Mapping[str, tuple[str, tuple[type, ...]]] = {
    "text": ("a text", (str,)),
    "status": ("a text", (str,)),
    "intent": ("a text or null", (str, type(None))),
    "slots": ("an object", (Mapping,)),
    "actions": ("a list", (list, tuple)),
    "confidence": ("a number", (int, float)),
    "alternatives": ("a list of texts", (list, tuple)),
    "reason": ("a text", (str,)),
}
"""The keys of an interpretation in JSON, each with what it holds."""


class Status(StrEnum):
    """How sure the engine is. Only ``ACCEPTED`` moves a robot."""

    ACCEPTED = "accepted"
    """Understood, and every part of it is complete."""
    INCOMPLETE = "incomplete"
    """The beginning of a sentence of the grammar; more words are needed."""
    AMBIGUOUS = "ambiguous"
    """Two or more meanings are as likely; ``alternatives`` names them."""
    REJECTED = "rejected"
    """Not a command of this grammar, or one that was negated or cancelled; ``reason`` says why."""


class Cause(StrEnum):
    """What kind of ``reason`` an interpretation has, where a program has to know it: the words are for people."""

    NEGATED = "negated"
    """It says that something shall not be done."""
    CANCELLED = "cancelled"
    """It takes back what it said itself, or would hold a robot that is at rest."""
    CORRECTED = "corrected"
    """Its later words took back some of the earlier ones: "turn left, no, right"."""
    OBJECTED = "objected"
    """A robot that moves stops at it, since nothing was said but "no", "not that" or the like."""
    REST_UNKNOWN = "rest unknown"
    """A robot that moves stops at its first words, and the rest was not understood: "wait, the cat is there"."""
    BEYOND_LIMITS = "beyond limits"
    """A number is none that its slot takes."""
    UNKNOWN_PLACE = "unknown place"
    """The place that it names is not on the map."""
    NO_COMMAND = "no command"
    """It, or a part of it, is like no command."""
    NONE_MEANT = "none meant"
    """It answers that nothing is meant of what was asked about."""


@dataclass(frozen=True, slots=True)
class Question:
    """What an interpretation that is not accepted asks back, for the answer that may follow."""

    choices: tuple[str, ...] = ()
    """For each of its alternatives the whole sentence that is meant by it; empty where it stands for none. None at all
    of a sentence that is not finished."""
    beginning: str = ""
    """The sentence that is not finished, whose rest is the answer; empty: there is none."""
    before: tuple[Action, ...] = ()
    """What was done before it was asked, which "again" and "it" still point to,"""
    needs: tuple[Needs, ...] = ()
    """and what each of that asks of the states of the robot; empty if that is not known."""
    said_before: str = ""
    """The text of it, which "not the kitchen" still points to; empty if that is not known."""


@dataclass(frozen=True, slots=True)
class Interpretation:
    """The meaning of one utterance. The same text always gives the same interpretation."""

    text: str
    """What was said, as it came in."""
    status: Status
    intent: str | None = None
    """Name of the intent; ``compound`` when several commands were said at once; None when rejected."""
    slots: Mapping[str, Any] = field(default_factory=dict, hash=False)
    """Slot name to value: strings, SI floats, booleans. For a compound:
    ``{"steps": [{"intent", "slots"}, ...]}`` in the order said."""
    actions: tuple[Action, ...] = ()
    """What to do, in order. Empty unless accepted."""
    confidence: float = 0.0
    """0 to 1: 1 is an exact sentence of the grammar; fuzzy slots and sound-alikes lower it."""
    alternatives: tuple[str, ...] = ()
    """Ambiguous: the meanings in question. Rejected: the nearest sentences or names."""
    reason: str = ""
    """Why it is not accepted, or what was changed to accept it; empty for an exact sentence."""
    causes: frozenset[Cause] = field(default=frozenset(), compare=False, repr=False)
    """What kinds of reason ``reason`` tells of; none after JSON."""
    denied: tuple[Action, ...] = field(default=(), compare=False, repr=False)
    """What shall not be done, where a command was negated: "don't clean the lab"; also of one that is accepted, where
    another is wanted instead: "don't clean the lab, clean the hall". None after JSON. For :meth:`Executor.deny`, before
    the actions are submitted: a robot that does it has to stop."""
    needs: tuple[Needs, ...] = field(default=(), compare=False, repr=False)
    """What each of the actions asks of the states of the robot; none for a stop, and after JSON."""
    question: Question | None = field(default=None, compare=False, repr=False)
    """What an answer is understood by, if it is given as ``last`` with the next utterance; None: nothing is asked, and
    after JSON."""

    goes_on: bool = field(default=False, compare=False, repr=False)
    """Whether it only goes on with what was given as ``last``: "and Ben", after "wave to Anna". Its ``text`` is the
    whole sentence; its actions are those that were added, and wait their turn: :meth:`Executor.submit` takes them with
    the policy ``follow``. False after JSON."""

    def guards(self, state: Callable[[], Collection[str]]) -> tuple[Callable[[], str] | None, ...]:
        """What asks again, for each of the actions, whether the robot is in the states that its intent asks for: for
        :meth:`Executor.submit`. What waits its turn may have been understood long before it begins.

        Args:
            state: gives the states in which the robot is, when it is called; "moving" does not matter among them.
        """
        if not callable(state):
            raise TypeError(f"guards takes a function that tells the states, not {state!r:.80}: lambda: {state!r:.80}")
        guards = [needs.guard(state) for needs in self.needs]
        return (*guards, *[None] * (len(self.actions) - len(guards)))

    @property
    def stops(self) -> bool:
        """Whether a stop is among its actions."""
        return any(isinstance(action, Stop) for action in self.actions)

    @property
    def stops_at_first(self) -> bool:
        """Whether it stops a robot that moves for its first words alone, and the rest was not understood: "wait, the
        cat is there"."""
        return Cause.REST_UNKNOWN in self.causes

    @property
    def objects(self) -> bool:
        """Whether it stops a robot that moves since nothing was said but "no", "not that" or the like."""
        return Cause.OBJECTED in self.causes

    @property
    def refuses(self) -> bool:
        """Whether it says that something shall not be done: it was negated, or taken back."""
        return not self.causes.isdisjoint((Cause.NEGATED, Cause.CANCELLED))

    @property
    def beyond_limits(self) -> bool:
        """Whether it would be a command, if one of its numbers were another: its slot takes no such number."""
        return self.status is Status.REJECTED and Cause.BEYOND_LIMITS in self.causes

    @property
    def unknown_place(self) -> bool:
        """Whether it would be a command, if the place that it names were on the map."""
        return self.status is Status.REJECTED and Cause.UNKNOWN_PLACE in self.causes

    @property
    def corrected(self) -> bool:
        """Whether its later words took back some of the earlier ones: "turn left, no, right"."""
        return Cause.CORRECTED in self.causes

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary with exactly these eight keys."""
        return {
            "text": self.text,
            "status": self.status.value,
            "intent": self.intent,
            "slots": dict(self.slots),
            "actions": [to_json(action) for action in self.actions],
            "confidence": round(self.confidence, 4),
            "alternatives": list(self.alternatives),
            "reason": self.reason,
        }

    @staticmethod
    def from_json(data: Mapping[str, Any]) -> Interpretation:
        """The interpretation that :meth:`to_json` wrote.

        Raises:
            TypeError: it is no JSON object.
            ValueError: a key is missing, or what it holds is of the wrong kind.
        """
        if not isinstance(data, Mapping):
            raise TypeError(f"Interpretation.from_json takes what to_json gave, a dictionary, not {data!r:.80}")
        if missing := [key for key in _KINDS if key not in data]:
            raise ValueError(f"an interpretation in JSON has {', '.join(_KINDS)}; {', '.join(missing)} is missing")
        for key, (kind, types) in _KINDS.items():
            value = data[key]
            right = isinstance(value, types) and not isinstance(value, bool)
            if not right or (key == "alternatives" and not all(isinstance(one, str) for one in value)):
                raise ValueError(f"{key} of an interpretation in JSON is {kind}, not {value!r:.80}")
        return Interpretation(
            text=data["text"],
            status=Status(data["status"]),
            intent=data["intent"],
            slots=dict(data["slots"]),
            actions=tuple(from_json(action) for action in data["actions"]),
            confidence=float(data["confidence"]),
            alternatives=tuple(data["alternatives"]),
            reason=data["reason"],
        )
