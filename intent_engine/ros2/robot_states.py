"""The states that a node was told the robot is in, by a parameter and on a topic. No ROS in here."""

from __future__ import annotations

import json
import reprlib
from dataclasses import dataclass, replace

from intent_engine.errors import ConfigError, Problem
from intent_engine.grammar_states import unknown_states

__all__ = ["MAX_TEXT", "PARAMETER", "TOPIC", "States", "in_one_line", "state_names", "states_text"]

TOPIC = "voice_commands/state"
PARAMETER = "parameter states"

MAX_TEXT = 4096
"""Characters of a message. A robot is in a handful of states; what is longer was meant for another topic."""

_TOLD = 5
"""Unknown names of one message that are told."""

_HINT = 'write the states with commas or blanks between them, docked carrying, or as JSON, ["docked", "carrying"]'


def state_names(value: object, named_by: str) -> frozenset[str]:
    """The names in what a person or another node wrote; the same name twice is one.

    Args:
        value: words with commas or blanks between them, a JSON list in text, or a list of names; nothing, an empty
            text, an empty list and empty names name none.
        named_by: what it was given with.

    Raises:
        ConfigError: it is none of these.
    """
    if value is None:
        return frozenset()
    if isinstance(value, str):
        text = value
        if len(text) > MAX_TEXT:
            message = f"{len(text)} characters are no list of states; at most {MAX_TEXT} are read"
            raise ConfigError(Problem(f"{named_by}: {message}", hint=_HINT))
        # Only a list in brackets can hold a name with a blank in it.
        if not text.lstrip().startswith(("[", "{")):
            return frozenset(text.replace(",", " ").split())
        try:
            value = json.loads(text)
        except (ValueError, RecursionError):
            raise ConfigError(Problem(f"{named_by}: {_shown(text)} is no JSON", hint=_HINT)) from None
    if isinstance(value, (str, bytes, dict)) or not hasattr(value, "__iter__"):
        raise ConfigError(Problem(f"{named_by}: {_shown(value)} is no list of states", hint=_HINT))
    names = list(value)
    for name in names:
        if not isinstance(name, str):
            raise ConfigError(Problem(f"{named_by}: {_shown(name)} is no name of a state", hint=_HINT))
    return frozenset(names) - {""}


def states_text(states: frozenset[str]) -> str:
    """The message that tells states: a JSON list, sorted."""
    return json.dumps(sorted(states))


def in_one_line(error: ConfigError) -> str:
    """All that is wrong and what to do about it, for a place that shows one line."""
    return "; ".join(f"{each.message}: {each.hint}" if each.hint else each.message for each in error.problems)


@dataclass(frozen=True, slots=True)
class States:
    """Which states hold, and who says so. What is wrong changes nothing."""

    known: frozenset[str]
    """Those that the grammar asks for."""
    by_parameter: frozenset[str] = frozenset()
    by_topic: frozenset[str] = frozenset()

    @property
    def held(self) -> frozenset[str]:
        """Those that hold. Neither side takes away what the other says, so it does not matter who spoke last."""
        return self.by_parameter | self.by_topic

    def with_parameter(self, value: object) -> States:
        """When the parameter is set.

        Raises:
            ConfigError: it is no list of states, or no intent asks for one of them.
        """
        return replace(self, by_parameter=self._checked(value, PARAMETER))

    def with_message(self, text: str) -> States:
        """When a message came on the topic. It is the whole list: what the topic said before holds no longer.

        Raises:
            ConfigError: it is no list of states, or no intent asks for one of them.
        """
        return replace(self, by_topic=self._checked(text, TOPIC))

    def _checked(self, value: object, named_by: str) -> frozenset[str]:
        names = state_names(value, named_by)
        if problems := unknown_states(sorted(names), self.known, named_by):
            raise ConfigError(problems[:_TOLD])
        return names


def _shown(value: object) -> str:
    """The beginning of anything. Python's own ``repr`` goes as deep as a value does, and fails there."""
    return repr(value[:100]) if isinstance(value, str) else reprlib.repr(value)
