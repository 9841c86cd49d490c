"""A verb without the word for who does it to himself: "dreh um neunzig Grad nach links" is "dreh *dich* um neunzig Grad
nach links"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.matcher import Matcher
from intent_engine.language.utterance import Utterance

__all__ = ["Itself"]


class Itself:
    """Reads such an order with that word.

    Args:
        matcher: of the grammar, whose language has such words behind its verbs.
    """

    def __init__(self, matcher: Matcher) -> None:
        wording = matcher.grammar.wording
        self._words = sorted(wording.before_verbs) if wording.parted else []
        self._matcher = matcher

    def ways(self, core: Utterance, verbs: Collection[str]) -> Iterator[Utterance]:
        """With each word that a command has behind its verb. What is done to something says to what: "dreh den Kopf"
        has no such way.

        Args:
            core: what was said, without its fillers.
            verbs: with which commands begin.
        """
        verb, *behind = core.words
        if not behind or verb not in verbs or core.breaks[1] or behind[0] in self._words:
            return
        for word in self._words:
            if self._matcher.prefix([verb, word])[1] is not None:
                yield core.with_other(1, 1, Utterance.in_one_breath([word]))
