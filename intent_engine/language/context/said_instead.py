"""What is typed in the place of a part of what was said before: "no, the heater", after "turn on the lamp".

What was done of it stays done, and is denied, so that it ends where it is still being done. A robot that moves is
stopped by such a text instead, and what a drive or a turn has covered cannot be taken from what is meant.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any

from intent_engine.actions import Action, Custom, Navigate
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import Grammar
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["may_forbid", "said_instead"]


def said_instead(
    text: str,
    before: str,
    done: Sequence[Action],
    meaning: Callable[[str], Interpretation],
    listed: Collection[str],
) -> Interpretation | None:
    """What a text means that begins with a word of correction; its ``text`` is the whole sentence. None: it corrects
    nothing of what was done, or that is no single thing that can be done anew. Where that went on from something else
    ("and the fan"), only what was added is corrected.

    Args:
        text: what is said now, and is no command by itself.
        before: the text of what was said before.
        done: what that did.
        meaning: understands a text.
        listed: slots that do not hold any words: behind "say it is early" a "no, it was late" may be said to anybody.
    """
    if len(done) != 1 or not isinstance(done[0], Custom | Navigate):
        return None
    first = meaning(before)
    if first.actions[-1:] != tuple(done):
        return None
    whole = meaning(f"{before}, {text}")
    corrects = whole.status is Status.ACCEPTED and whole.corrected and not whole.stops
    if not corrects or whole.actions[:-1] != first.actions[:-1] or whole.actions[-1] == done[0]:
        return None
    (intent, slots), (_, old) = _last(whole), _last(first)
    if not all(slot in listed or slots[slot] == old.get(slot) for slot in slots):
        return None
    denied = tuple(dict.fromkeys((*done, *whole.denied)))
    return replace(whole, intent=intent, slots=slots, actions=whole.actions[-1:], needs=whole.needs[-1:], denied=denied)


def may_forbid(text: str, grammar: Grammar, meaning: Callable[[str], Interpretation]) -> bool:
    """Whether a text may forbid a whole command, since its "no" stands in one breath with it: "no turn left"."""
    said = Utterance.of(text, grammar.language)
    length = PhraseSet(grammar.operators.correction).after(said.words, 0)
    if not 0 < length < len(said) or said.breaks[length] or grammar.wording.may_forbid.isdisjoint(said.words[:length]):
        return False
    return bool(meaning(" ".join(said.words[length:])).actions)


def _last(found: Interpretation) -> tuple[str | None, Mapping[str, Any]]:
    """The intent and the slots of the last thing that an interpretation does."""
    if "steps" not in found.slots:
        return found.intent, found.slots
    step = found.slots["steps"][-1]
    return step["intent"], step["slots"]
