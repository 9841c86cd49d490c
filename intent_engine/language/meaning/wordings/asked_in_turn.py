"""Several orders that are asked for once, each with its verb last: "kannst du die Heizung *ausschalten* und das Fenster
*öffnen*?"."""

from __future__ import annotations

from collections.abc import Callable

from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.told import Understood, readings_of
from intent_engine.language.utterance import Utterance

__all__ = ["asked_in_turn"]


def asked_in_turn(
    asked: Utterance, phrases: Phrases, told: Callable[[Utterance], Understood | None]
) -> Utterance | None:
    """Such orders as they are told, with the words that join them; None: these are none.

    Args:
        asked: what follows what asks for it.
        phrases: of the grammar.
        told: the one order that is asked for in some words; None: it is none.
    """
    orders = Utterance.in_one_breath([])
    begin = 0
    for at in range(1, len(asked) + 1):
        joint = phrases.sequence.at(asked.words, at) if at < len(asked) else 0
        if not joint and at < len(asked) and not asked.breaks[at]:
            continue
        readings = readings_of(told(asked.part(begin, at)))
        if len(readings) == 1:
            words = [*readings[0].words, *asked.words[at : at + joint]]
            breaks = [*asked.breaks[begin : begin + 1], *[False] * (len(words) - 1)]
            orders = Utterance([*orders.words, *words], [*orders.breaks, *breaks])
            begin = at + joint
        elif at == len(asked):
            return None
    return orders
