"""Orders whose verb stands last in the infinitive, "Ventil drei schließen": German tells so to nobody by name."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import partial

from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.command import LEAST_WORDS
from intent_engine.language.meaning.negations.forbidden_verbs import last_verb_first
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.thing_words import thing_words

__all__ = ["VerbLast"]

_PLURALS = ("n", "s", "er", "el")
"""How German names of several things end, besides "-e", in which names of one feminine thing end as well."""


class VerbLast:
    """Reads such orders as a grammar has them, the verb first.

    Args:
        matcher: of the grammar whose they are.
    """

    def __init__(self, matcher: Matcher) -> None:
        self._grammar = grammar = matcher.grammar
        self._prefix = matcher.prefix
        self._known = thing_words(grammar.language)
        self._words = vocabulary(grammar)
        articles = sorted(self._known.definite_of_things & self._words)
        self._articles = [Utterance.in_one_breath([word]) for word in articles]

    def ways(self, part: Utterance, verbs: Collection[str]) -> Iterator[Rewording]:
        """One order with its verb first, and with an article where it has none.

        Args:
            part: the words of the order.
            verbs: with which commands begin.
        """
        if len(part) < LEAST_WORDS or not part.words[-1].endswith("n"):
            return  # "weiterfahren" says nothing of what, or where to
        named = [] if part.words[0] in self._known.articles else self._articles
        for said in (part, *(part.with_other(0, 0, article) for article in named)):  # "Tür öffnen"
            for order in last_verb_first(said, self._grammar):
                itself = order.words[1] in self._grammar.wording.before_verbs and order.words[1] not in said.words[:1]
                if order.words[0] in verbs and (not itself or self._prefix(order.words[:2])[1] is not None):
                    yield Rewording(order, partial(self._tells_by_itself, part))

    def in_order(self, asked: Utterance) -> Iterator[Utterance]:
        """What somebody is asked to do, and the same with its verb behind what follows it, apart: "dass du eine Tasche
        fräst, acht Millimeter tief". A number there may take the place of another: "zwei Meter vorfahren, drei"."""
        yield asked
        apart = [at for at in range(LEAST_WORDS, len(asked)) if asked.breaks[at]]
        if len(apart) != 1:
            return
        before, verb, more = asked.part(0, apart[0] - 1), asked.words[apart[0] - 1], asked.part(apart[0], len(asked))
        if not (is_number(more.words[0], self._grammar.language) and self._ends_an_amount(before.words)):
            yield Utterance([*before.words, *more.words, verb], [*before.breaks, *more.breaks, False])

    def _ends_an_amount(self, words: Sequence[str]) -> bool:
        """Whether words end with a number or a unit, behind which another number would go on."""
        language = self._grammar.language
        ways = (evaluate(["2", words[-1]], kind, language) for kind in QUANTITY_KINDS)
        return is_number(words[-1], language) or any(way is not None for way in ways)

    def of_several(self, core: Utterance, verbs: Collection[str]) -> Iterator[Rewording]:
        """One order of several things, or in which something is corrected before its verb, with that first and its
        pauses: "die Pumpe und die Heizung ausschalten", "den Kopf auf 20, nein, auf 30 Grad stellen".

        Args:
            core: what was said, without its fillers.
            verbs: with which commands begin.
        """
        if len(core) <= LEAST_WORDS or core.breaks[-1]:
            return
        *before, last = core.words
        for order in last_verb_first(core, self._grammar):
            front = 1 + (order.words[1 : len(core)] != before)
            behind = order.words[front + len(before) :]
            told = order.words[front : front + len(before)] == before
            if order.words[0] in verbs and told and self._prefix(order.words[: front + 1])[1] is not None:
                breaks = [core.breaks[0], *[False] * front, *core.breaks[1:-1], *[False] * len(behind)]
                means = partial(self._tells_each, front, len(behind), last)
                yield Rewording(Utterance(order.words, breaks), means)

    def _tells_each(self, front: int, behind: int, last: str, order: Reading) -> bool:
        """Whether an order, as it was corrected, or of one of the things, would be one by itself with its verb last."""
        words = order.words[front : len(order.words) - behind]
        return bool(words) and self._tells_by_itself(Utterance.in_one_breath([*words, last]), order)

    def _tells_by_itself(self, part: Utterance, order: Reading) -> bool:
        """Whether it is an order though no word asks for it, and does not tell what somebody does: "die Türen
        schließen", "sie drehen".

        A sentence that tells of somebody begins with him and has its verb second, so that a thing in the accusative or
        a way before the verb can only be told to do; and a verb that is parted would be, were it told of somebody.
        """
        known, wording = self._known, self._grammar.wording
        first, *between, last = part.words
        if first in known.articles and not between:
            return False  # "die Vorfahren"
        if first in known.pronouns or first in wording.before_verbs:
            return False
        several = first in known.of_several
        free = [order.words[slot.start] for slot in order.slots if slot.slot.type in FREE_KINDS]
        if not wording.before_verbs.isdisjoint(free) or (free and (several or first not in known.done_to)):
            return False  # "greif sich" is nobody's, and "Leute nehmen" may be about people
        parted = order.words[-1] in wording.parted and last.startswith(order.words[-1])
        if parted or not several:
            return first not in known.articles or first in known.done_to
        beside = any(word in known.joining or is_number(word, self._grammar.language) for word in between[1:])
        return beside or not self._is_of_several(between[-1])

    def _is_of_several(self, noun: str) -> bool:
        return noun.endswith(_PLURALS) or (noun.endswith("e") and noun[:-1] in self._words)
