"""Words that were said twice, as people do who begin again: "go to the, to the kitchen"."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from intent_engine.language.checking.trace_checks import LEADING
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import LEAST_WORDS, Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.slots.name_words import is_identifier
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["SaidTwice", "said_once"]

MOST = 3
"""Words that are begun again at once,"""
MOST_BEGUN = 5
"""and those that are left before a whole command."""


class SaidTwice:
    """What one grammar lets people say twice who mean it once."""

    def __init__(self, commands: Commands, phrases: Phrases) -> None:
        self._commands = commands
        self._phrases = phrases
        things = thing_words(commands.matcher.grammar.language)
        self._leading = things.articles | things.unfinished | things.joining | things.alone
        """Words after which a name or the like goes on."""
        self._saying_nothing = things.articles | things.unfinished | LEADING

    def once(self, core: Utterance) -> Utterance | None:
        """An utterance with what was said twice in it said once; None: there is nothing, or hardly anything is left."""
        once = said_once(core, lambda start, end: self._may_be(core.words, start, end))
        return once if once is not None and len(once) >= LEAST_WORDS else None

    def begun_anew(self, core: Utterance, said: Utterance) -> Utterance | None:
        """The command behind words that were begun and left. None: there are none.

        They were begun without its verb, and all of them are said again in it: "the boxes, uh, take the boxes to the
        hall". Or they begin with its verb, are the beginning of a command and none yet, and name nothing else: "go for
        go forward six feet". Or nothing but a verb was begun, and a hesitation stands before another: "turn, uh, rotate
        the first joint".

        Args:
            core: words without those that say nothing,
            said: and with them.
        """
        if (less := self._without_begun_verb(core, said)) is not None:
            return less
        verbs = self._commands.verbs
        if core.words[0] in verbs:
            return self._begun_with_the_verb(core)
        for place in range(1, min(len(core), MOST_BEGUN + 1)):
            left, rest = core.words[:place], core.part(place, len(core))
            if not verbs.isdisjoint(left) or self._phrases.operate_in(left):
                return None
            if core.breaks[place] is not False and rest.words[0] in verbs:
                again = any(rest.words[at : at + place] == left for at in range(1, len(rest)))
                return rest if again else None
        return None

    def _begun_with_the_verb(self, core: Utterance) -> Utterance | None:
        again = [place for place in range(1, len(core)) if core.words[place] == core.words[0]]
        if len(again) != 1 or again[0] > MOST_BEGUN:
            return None
        left, rest = core.words[: again[0]], core.part(again[0], len(core))
        # "Put the cup put the plate on the table" leaves out a cup, and "turn off turn on the lights" a command.
        named = set(left) - self._saying_nothing - set(rest.words)
        if named or self._phrases.operate_in(left) or any(map(self._commands.matcher.is_number, left)):
            return None
        strict = self._commands.matcher.strict
        _, begun = strict.walk(left)
        if begun is None:
            return None
        # "Turn right *uh* turn right seventy five" is one, and without the "uh" it may be two.
        more = core.breaks[again[0]] is None and len(rest) > len(left) and rest.words[: len(left)] == left
        return rest if more or not strict.accepting(begun) else None

    def _without_begun_verb(self, core: Utterance, said: Utterance) -> Utterance | None:
        """The utterance less a verb that was begun and left at a hesitation, for a command with another or the same:
        "turn, uh, rotate it". What was begun says nothing yet: of "open the lid, uh, take it" the lid would be lost."""
        hesitation, strict = self._phrases.hesitation, self._commands.matcher.strict
        if not hesitation.may_stand_in(said.words):
            return None
        for place in range(1, len(core)):
            if core.breaks[place] is False or core.words[place] not in self._commands.verbs:
                continue
            start = next((at for at in range(place - 1, max(place - MOST_BEGUN, 0), -1) if self._begins(core, at)), 0)
            left = core.words[start:place]
            _, begun = strict.walk(left)
            is_begun = begun is not None and not strict.accepting(begun) and left[0] in self._commands.verbs
            names_none = self._saying_nothing.issuperset(left[1:]) and not self._phrases.operate_in(left)
            if is_begun and names_none and self._hesitates_behind(core.words[:place], said):
                return core.cut(start, place)
        return None

    def _begins(self, core: Utterance, place: int) -> bool:
        return bool(core.breaks[place]) or self._phrases.sequence.ends(core.words[:place]) > 0

    def _hesitates_behind(self, left: Sequence[str], said: Utterance) -> bool:
        hesitation = self._phrases.hesitation
        places = (at for at in range(len(left), len(said)) if hesitation.at(said.words, at))
        return any(self._phrases.without_fillers(said.part(0, at)).words == left for at in places)

    def means(self, parts: Sequence[Clause], core: Utterance, once: Utterance) -> bool:
        """Whether these commands are what was meant by it: "left left" may be two, and so may what is several commands
        where a verb was said twice."""
        first = parts[0].reading if parts else None
        if first is None or not self._commands.opens_with_a_verb(first):
            return False
        verbs, fewer = (sum(self._commands.may_begin_in([word]) for word in one.words) for one in (core, once))
        return len(parts) == 1 or verbs == fewer

    def _may_be(self, words: Sequence[str], start: int, end: int) -> bool:
        """Whether words may be said twice by who means them once: with which the command begins, or which end with an
        article or the like, or stand before a number ("bay bay seven").

        None of them is a number, or changes what is meant. Nor are they a command ("back back"), but for its verb, or
        may be a number before another: "to to thirty". "The cup the cup" may be two.
        """
        matcher = self._commands.matcher
        twice, after = words[start:end], words[2 * end - start : 2 * end - start + 1]
        if any(matcher.is_number(word) or (is_identifier(word) and word not in self._leading) for word in twice):
            return False
        counted = any(map(matcher.is_number, after))
        if counted and twice[-1] in LEADING:
            return False
        if (start, end) == (0, 1):
            return True
        if start and twice[-1] not in self._leading and not counted:
            return False
        return not (self._phrases.operate_in(twice) or matcher.read(list(twice)))


def said_once(said: Utterance, may_be: Callable[[int, int], bool]) -> Utterance | None:
    """An utterance with what was said twice in it said once; None: there is nothing, or it was said more than twice.

    Args:
        said: the utterance.
        may_be: whether the words from a place to another may be said twice by who means them once.
    """
    words = said.words
    kept = list(range(len(words)))
    place = 0
    while place < len(words):
        length = next((count for count in range(MOST, 0, -1) if _again(words, place, count)), 0)
        if not length:
            place += 1
            continue
        if _again(words, place + length, length) or not may_be(place, place + length):
            return None
        kept = [at for at in kept if not place <= at < place + length]
        place += 2 * length
    if len(kept) == len(words):
        return None
    return Utterance([words[at] for at in kept], [said.breaks[at] for at in kept])


def _again(words: Sequence[str], place: int, count: int) -> bool:
    """Whether so many words at a place are said again right after."""
    after = words[place + count : place + 2 * count]
    return len(after) == count and list(words[place : place + count]) == list(after)
