"""Who asks for another wants one more: "another coffee" is "a coffee", but "another kitchen" is none that is known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from intent_engine.language.grammar import FREE_KINDS, Grammar, Slot
from intent_engine.language.loading.language_words import default_another
from intent_engine.language.networks.word_state import Trace
from intent_engine.language.templates.template_tree import Choice, Word

__all__ = ["Another"]


_ONCE = frozenset(("location",))
_MAYBE = _ONCE | FREE_KINDS


class Another:
    """Words of one grammar that stand for an article."""

    def __init__(self, grammar: Grammar) -> None:
        known = default_another(grammar.language)
        self.meant: Mapping[str, tuple[str, ...]] = {
            word: meant for word, meant in grammar.sound_alikes.items() if known.get(word) == meant
        }
        """Each with the articles."""
        articles = {article for meant in self.meant.values() for article in meant}
        self._slots = grammar.slots
        self._named = {slot.name for slot in grammar.slots.values() if _may_be_called(slot, articles)}
        """Slots of which it may be a value: "row another" is no row A."""

    def is_no_article(self, trace: Trace, words: Sequence[str], *, loose: bool) -> bool:
        """Whether such a word is taken for an article on a way through the automaton where it is none: in a value that
        may be called so, or before the name of a place, of which there is but one; and, where the words are read as
        they are, before free words, which may begin with it ("play another love")."""
        if self.meant.keys().isdisjoint(words):
            return False
        inside, behind = "", -1
        for position, mark in trace:
            kind = mark[0]
            if kind == "open" and mark[1][0] == "slot":
                inside = mark[1][2]
                if position == behind and self._slots[inside].type in (_ONCE if loose else _MAYBE):
                    return True
            elif kind == "close" and mark[1][0] == "slot":
                behind = position if behind > -1 else behind  # "another big dock"
                inside = ""
            elif kind == "alike" and words[position - 1] in self.meant:
                if inside in self._named:
                    return True
                behind = position
        return False


def _may_be_called(slot: Slot, articles: set[str]) -> bool:
    """Whether an article may be a value of a slot: of a list that has it, or on a map, which may have it."""
    nodes = [item for _, node in slot.values for item in (node.items if isinstance(node, Choice) else (node,))]
    return slot.type == "location" or any(Word(article) in nodes for article in articles)
