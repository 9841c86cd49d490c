"""Words that stand behind a verb and are of the whole command: "fahr *dann* in die Küche", "hol *mir* die Zange"."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance

__all__ = ["BehindTheVerb"]

_MOST_BETWEEN = 2
"""Words of the verb itself before them: "drehen *Sie sich* dann"."""
_LEAST_BEHIND = 2
"""Words behind whom something is done for: "fahr mir vor" says where."""
_NOTHING = Utterance([], [])


class BehindTheVerb:
    """Reads such words as they would stand in a language without them.

    Args:
        phrases: of the grammar.
        grammar: whose language has such words.
    """

    def __init__(self, phrases: Phrases, grammar: Grammar) -> None:
        wording = grammar.wording
        self._phrases = phrases
        self._adverbs = sorted(wording.adverbs, key=len, reverse=True)
        self._for_whom = wording.for_whom
        self._once_more = wording.once_more
        self._of_the_verb = wording.asked | wording.before_verbs

    def otherwise(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """An utterance whose adverbs of time stand before the verb ("dann fahr in die Küche") and that does not say for
        whom something is done; None: there are no such words.

        What comes first is said of the first command only: "räum aber *zuerst* den Tisch ab" may turn their order.

        Args:
            core: what was said, without its fillers.
            verbs: words with which a command may begin.
        """
        said, start = core, 0
        while start < len(said):
            rest = said.words[start:]
            begin = start + max(self._phrases.goes_on(rest), self._phrases.opens(rest))
            if begin < len(said) and said.words[begin] in verbs:
                said = self._moved(said, begin, first=not start)
            start = self._next(said, max(begin, start) + 1)
        return said if said.words != core.words else None

    def said_once(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """An utterance without what says, behind a verb and once, that it was so before: "mach das Licht *wieder* an".
        None: there is no such word, or there are several."""
        found = [(at, one) for at in range(len(core)) for one in self._once_more if _is_at(core, at, one)]
        if len(found) != 1:
            return None
        ((at, one),) = found
        behind = any(word in verbs for word in core.words[:at]) and not core.breaks[at]
        return core.with_other(at, at + len(one), _NOTHING) if behind else None

    def _next(self, said: Utterance, start: int) -> int:
        """Where the next command may begin, from a place on."""
        places = range(start, len(said))
        return next((at for at in places if said.breaks[at] or self._phrases.goes_on(said.words[at:])), len(said))

    def _moved(self, said: Utterance, verb: int, *, first: bool) -> Utterance:
        """The same where such words stand behind the verb at a place, in one breath with it and what follows. Two
        adverbs are one of their own: "fahr erst dann vor" says not before."""
        at = verb + 1
        while at < len(said) and at - verb <= _MOST_BETWEEN and said.words[at] in self._of_the_verb:
            at += 1
        for length in self._adverb_at(said, at):
            end = at + length
            if end < len(said) and not any(said.breaks[verb + 1 : end + 1]):
                joins = first or self._phrases.says_later(said.words[at:end])
                if not joins or self._adverb_at(said, end):
                    return said
                adverb = Utterance([*said.words[at:end], said.words[verb]], [False] * (length + 1))
                said = said.with_other(at, end, _NOTHING).with_other(verb, verb + 1, adverb)
                at += length
                break
        for_whom = at + _LEAST_BEHIND < len(said) and said.words[at] in self._for_whom
        if for_whom and not any(said.breaks[verb + 1 : at + 2]):
            said = said.with_other(at, at + 1, _NOTHING)
        return said

    def _adverb_at(self, said: Utterance, at: int) -> list[int]:
        """Lengths of the adverbs at a place, the longest first."""
        return [len(one) for one in self._adverbs if _is_at(said, at, one)]


def _is_at(said: Utterance, at: int, phrase: Sequence[str]) -> bool:
    return tuple(said.words[at : at + len(phrase)]) == tuple(phrase)
