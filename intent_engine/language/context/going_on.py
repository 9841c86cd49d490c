"""What goes on from the command that was said before, in an utterance of its own: "and Ben", after "wave to Anna".

It adds what both do together besides the first: "wave to Anna and Ben". A name alone may as well take the place of the
one before.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from intent_engine.actions import Action
from intent_engine.interpretation import Interpretation, Status

__all__ = ["goes_on_from", "is_a_list"]


_LAST = re.compile(r"(?s)(.*\S)\s+([^\W\d]+)[\s.!]*$")
"""A text and its last word."""


def goes_on_from(
    text: str,
    before: str,
    done: Sequence[Action],
    meaning: Callable[[str], Interpretation],
    parted: Collection[str] = (),
) -> Interpretation | None:
    """What a text adds that begins with a joint; its ``text`` is the whole sentence. None: it does not go on.

    Args:
        text: what is said now, and is no command by itself.
        before: the text of what was said before, with all that it went on from.
        done: what that did, at least its last action.
        meaning: understands a text.
        parted: words that end what was said before, and would end the whole sentence: "turn the fan *on*", "and the
            pump".
    """
    first = meaning(before)
    if not first.actions or not done or first.actions[-1] != done[-1]:
        return None
    ways, count = [f"{before} {text}"], len(first.actions)
    if (last := _LAST.match(before)) is not None and last[2].lower() in parted:
        ways.append(f"{last[1]} {text.rstrip(' .!')} {last[2]}")
    whole = next((one for one in map(meaning, ways) if is_a_list(one, count - 1)), None)
    if whole is None or whole.actions[:count] != first.actions or len(whole.actions) <= count:
        return None
    steps = whole.slots["steps"][count:]
    intent, slots = (steps[0]["intent"], steps[0]["slots"]) if len(steps) == 1 else (whole.intent, {"steps": steps})
    more, needs = whole.actions[count:], whole.needs[count:]
    return replace(whole, intent=intent, slots=slots, actions=more, needs=needs, goes_on=True)


def is_a_list(whole: Interpretation, begin: int = 0) -> bool:
    """Whether a sentence is commands of one intent, from one of them on."""
    if whole.status is not Status.ACCEPTED or "steps" not in whole.slots:
        return False
    steps = whole.slots["steps"][begin:]
    return len(steps) > 1 and all(step["intent"] == steps[0]["intent"] for step in steps)
