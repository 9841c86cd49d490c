"""Words that stand behind a verb and are of the whole command: "fahr *dann* in die Küche", "hol *mir* die Zange"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.parts import next_begins
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.thing_words import thing_words

__all__ = ["BehindTheVerb"]

_MOST_BETWEEN = 2
"""Words of the verb itself before them: "drehen *Sie sich* dann"."""
_LEAST_BEHIND = 2
"""Words behind whom something is done for: "fahr mir vor" says where."""

_LEAST_BEFORE = 3
"""Words of a command with a thing: "fold the towels"."""
_AN_ARTICLE_AND_A_NOUN = 2


class BehindTheVerb:
    """Reads such words as they would stand in a language without them.

    Args:
        phrases: of the grammar.
        matcher: of the grammar, whose language has such words.
    """

    def __init__(self, phrases: Phrases, matcher: Matcher) -> None:
        wording = matcher.grammar.wording
        self._phrases = phrases
        self._matcher = matcher
        self._adverbs = sorted(wording.adverbs, key=len, reverse=True)
        self._for_whom = wording.for_whom
        self._gives = wording.gives
        self._own = vocabulary(matcher.grammar) if wording.gives else None
        self._others = wording.others
        self._people, self._articles = wording.other_people, wording.tells_of_a
        self._leads_to_some = wording.seeks | wording.brings
        self._for = wording.lasting
        self._language = matcher.grammar.language
        self._once_more = wording.once_more
        self._leads = wording.leads | wording.says_when
        self._besides = wording.besides
        counting = {words[0] for words in matcher.grammar.counting if len(words) == 1}
        self._shortened = [
            tuple(word for word in words if word not in counting) for words in wording.once_more if counting & {*words}
        ]
        """The same without what is left out as counting something: "one (more) time"."""
        self._verb_last = bool(wording.parted)
        self._of_the_verb = wording.asked | wording.before_verbs
        known = thing_words(self._language).articles
        self._pronouns = {word for (word, *more) in matcher.grammar.operators.pronoun if not more} - known

    def ordered(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """An utterance whose adverbs stand before the verb ("dann fahr in die Küche"); None: there are none behind it.

        What comes first is said of the first command only: "räum aber *zuerst* den Tisch ab" may turn their order.

        Args:
            core: what was said, without its fillers.
            verbs: words with which a command may begin.
        """
        said = core
        for start, verb in self._verbs(core, verbs):
            said = self._moved(said, verb, first=not start)
        return said if said.words != core.words else None

    def for_nobody(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """An utterance that does not say for whom something is done; None: it never did, or the grammar tells it apart
        ("hol mir die Tasse" may bring it, and "hol die Tasse" take it)."""
        said = core
        for _, verb in reversed(list(self._verbs(core, verbs))):
            at = self._behind(core, verb, self._of_the_verb - self._for_whom)
            words, paused = core.words[at : at + 1], any(core.breaks[verb + 1 : at + 2])
            if at + _LEAST_BEHIND >= len(core) or paused or self._for_whom.isdisjoint(words):
                continue
            if self._gives and not (core.words[at - 1] in self._gives and self._begins_thing(core.words[at + 1])):
                continue
            told_apart = self._own is None or words[0] in self._own
            if not told_apart or self._matcher.prefix(core.words[verb : at + 1])[1] is None:
                said = said.cut(at, at + 1)
        return said if said.words != core.words else None

    def for_others(self, core: Utterance) -> Utterance | None:
        """An utterance without others, with whom it ends, for whom something is done: "fold the towels for the kids".
        None: it has none, or they may be where something goes, or what is looked for."""
        at = next((at for at in range(len(core) - 2, _LEAST_BEFORE - 1, -1) if core.words[at] in self._for), 0)
        words, whom = core.words[:at], core.words[at + 1 :]
        if not words or any(core.breaks[at:]) or not self._leads_to_some.isdisjoint(words):
            return None
        people = len(whom) == _AN_ARTICLE_AND_A_NOUN and whom[0] in self._articles and whom[1] in self._people
        return core.part(0, at) if people or self._others.at(whom, 0) == len(whom) else None

    def _begins_thing(self, word: str) -> bool:
        """Whether a thing begins with a word: its article, how many there are of it, or its name ("show me Saturn")."""
        known = thing_words(self._language)
        begins = word in known.articles or is_number(word, self._language)
        return begins or word not in known.joining | known.alone | known.unfinished

    def said_once(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """An utterance without what says, once, that it was so before: behind a verb or at its end, "mach das Licht
        *wieder* an", or before a verb that stands last. None: there is no such word, or there are several."""
        found = [(at, one) for at in range(len(core)) for one in self._once_more if _is_at(core, at, one)]
        if not found:
            found = [(at, one) for at in range(len(core)) for one in self._shortened if self._ends_so(core, at, one)]
        if len(found) != 1:
            return None
        ((at, one),) = found
        last = at + len(one) == len(core)
        before = self._verb_last and not last and core.words[-1].endswith("n")  # "das Licht wieder anmachen"
        behind = last or before or any(word in verbs for word in core.words[:at])
        return core.cut(at, at + len(one)) if behind and at > 0 and not core.breaks[at] else None

    def but_for_besides(self, core: Utterance) -> Utterance | None:
        """What was said but for an "as well" at its end, which sounds like no word of a sentence; None: it has none."""
        length = self._besides.ends(core.words)
        alike = self._matcher.alikes.get(core.words[-1]) if core.words else None
        return core.part(0, len(core) - length) if 0 < length < len(core) and not alike else None

    def _ends_so(self, core: Utterance, at: int, phrase: Sequence[str]) -> bool:
        """Whether a command, or what is done to what, ends with such a phrase, of which a word within was left out."""
        end = at + len(phrase)
        if not _is_at(core, at, phrase) or None not in core.breaks[at + 1 : end]:
            return False
        if end == len(core) or core.breaks[end] or self._phrases.sequence.at(core.words, end) > 0:
            return True
        return core.words[end] in self._leads  # "spin the towels one more time *at* twelve hundred"

    def _verbs(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[int, int]]:
        """Where a command may begin, and where its verb stands."""
        start = 0
        while start < len(core):
            rest = core.words[start:]
            verb = start + max(self._phrases.goes_on(rest), self._phrases.opens(rest))
            if verb < len(core) and core.words[verb] in verbs:
                yield start, verb
            start = next_begins(core, max(verb, start), self._phrases)

    def _behind(self, said: Utterance, verb: int, between: Collection[str]) -> int:
        """The place behind a verb and the words of its own."""
        at = verb + 1
        while at < len(said) and at - verb <= _MOST_BETWEEN and said.words[at] in between:
            at += 1
        return at

    def _moved(self, said: Utterance, verb: int, *, first: bool) -> Utterance:
        """The same with an adverb before the verb at a place that stood behind it, in one breath with it and what
        follows. Two adverbs are one of their own: "fahr erst dann vor" says not before."""
        at = self._behind(said, verb, self._of_the_verb | self._for_whom | self._pronouns)
        for length in self._adverb_at(said, at):
            end = at + length
            joins = first or self._phrases.says_later(said.words[at:end])
            if end == len(said) or any(said.breaks[verb + 1 : end + 1]) or not joins or self._adverb_at(said, end):
                return said
            adverb = Utterance([*said.words[at:end], said.words[verb]], [False] * (length + 1))
            return said.cut(at, end).with_other(verb, verb + 1, adverb)
        return said

    def _adverb_at(self, said: Utterance, at: int) -> list[int]:
        """Lengths of the adverbs at a place, the longest first."""
        return [len(one) for one in self._adverbs if _is_at(said, at, one)]


def _is_at(said: Utterance, at: int, phrase: Sequence[str]) -> bool:
    return tuple(said.words[at : at + len(phrase)]) == tuple(phrase)
