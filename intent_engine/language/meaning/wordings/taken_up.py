"""A thing that is said first and taken up with the verb: "la palette, descends-*la*", "la pala portá*mela*", "die Tür,
öffne *sie*"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.formal import Formal
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import without_stress

__all__ = ["TakenUp"]

_MOST = 5
"""Words of such a thing, with its article."""


class TakenUp:
    """Reads such an order with the thing behind its verb.

    Args:
        grammar: whose language has articles with a pronoun for each.
        phrases: of the grammar.
        formal: its verbs as they are told to a stranger.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases, formal: Formal) -> None:
        wording = grammar.wording
        self._pronouns = wording.taken_up
        self._before = wording.joined | wording.joined_first
        self._is_joined = bool(wording.joined)
        self._sequence = phrases.sequence
        self._formal = formal

    def ways(self, core: Utterance, verbs: Collection[str]) -> Iterator[Utterance]:
        """An order with what it is about behind its verb, with each article that the pronoun stands for as well.

        Args:
            core: what was said, without its fillers.
            verbs: words with which a command may begin.
        """
        words = core.words
        pronouns = self._pronouns.get(words[0], frozenset()) if words else frozenset()
        if not pronouns or any(core.breaks[1:2]):
            return
        for at in range(2, min(len(words), _MOST + 1)):
            if any(core.breaks[2:at]) or self._sequence.at(words, at):
                return  # "la serre, la grange, ouvre-la", "la pelle et le râteau, apporte-la"
            verb, pronoun, end = self._verb(core, at, verbs)
            if pronoun in pronouns and not any(core.breaks[at + 1 : end + 1]):
                for article in (one for one, others in self._pronouns.items() if pronoun in others):
                    if article == words[0] or not self._is_joined:
                        told = [verb, article, *words[1:at], *words[end:]]
                        breaks = [core.breaks[0], *[False] * at, *core.breaks[end:]]
                        yield Utterance(told, breaks)

    def _verb(self, core: Utterance, at: int, verbs: Collection[str]) -> tuple[str, str, int]:
        """The verb at a place, the pronoun with it, and where it ends; no pronoun: it is none."""
        word = core.words[at]
        if not self._is_joined:
            after = core.words[at + 1] if at + 1 < len(core) else ""
            return word, after if self._tells(word, verbs) else "", at + 2
        for pronoun in {one for others in self._pronouns.values() for one in others}:
            bare = word.removesuffix(pronoun)
            ways = [bare, *(bare.removesuffix(before) for before in self._before)] if bare != word else []
            for way in (form for one in ways for form in (one, without_stress(one))):
                if self._tells(way, verbs):
                    return way, pronoun, at + 1
        return word, "", at + 1

    def _tells(self, word: str, verbs: Collection[str]) -> bool:
        return bool(word) and (word in verbs or self._formal.is_one(word))
