"""What has the words of a command and is none: a question, a saying, a condition, what is said to somebody else."""

from __future__ import annotations

import re
from collections.abc import Sequence

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.not_commands.asked_within import asked_within
from intent_engine.language.meaning.not_commands.conditions import Conditions
from intent_engine.language.meaning.not_commands.more_than_now import MoreThanNow
from intent_engine.language.meaning.not_commands.questions import Questions
from intent_engine.language.meaning.not_commands.sayings import Sayings
from intent_engine.language.meaning.not_commands.spoken_to import spoken_to
from intent_engine.language.meaning.not_commands.told_as_done import told_as_done
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.told import Understood
from intent_engine.language.normalize import tokenize
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.contractions import OTHER_WORDS, shortened_in
from intent_engine.language.words.owners import owners

__all__ = ["Talk"]

_APOSTROPHES = frozenset("'’ʼ`")
_APOSTROPHE = re.compile("(?<=[a-z])['’ʼ`](?=[a-z])", re.IGNORECASE)


class Talk:
    """Why what was understood is not to be done, by how it was said."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        grammar = commands.matcher.grammar
        self._alikes = commands.matcher.alikes
        self._values = commands.matcher.values
        self._language = grammar.language
        self._questions = Questions(phrases, commands)
        self._sayings = Sayings(phrases, grammar)
        self._conditions = Conditions(phrases, grammar)
        self._more_than_now = MoreThanNow(grammar)
        self._besides = grammar.wording.besides
        self._how = grammar.wording.tells_how
        self._at_times = grammar.wording.at_times
        self._fillers = phrases.fillers
        self._commands = commands
        self._thanking, self._once_more = grammar.wording.thanking, grammar.wording.once_more
        self._ways = frozenset(way for said in grammar.wording.sides for way in said.split("/"))

    def asks_or_quotes(self, text: str, said: Utterance, meant: Understood, *, spoken: bool) -> str:
        """Why it is a question, may be a saying, is said to somebody else, or leaves a value open; empty: it is none of
        these.

        Args:
            text: what was said or typed.
            said: its words.
            meant: what they were understood as.
            spoken: whether a wake word is needed, if the grammar has one.
        """
        found, parts = meant
        if self._questions.asks(text, said, parts, spoken=spoken):
            return "a question, and not one to do something"
        if not found.actions:
            return ""
        if self._thanks_once_more(said):
            return "somebody is thanked once more; say what is to be done again"
        if not found.stops and self._questions.wonders_whether(said):
            return "a question whether it can be done"
        if not found.stops and (asked := asked_within(text, parts, self._language)):
            return f"{asked!r} is asked; say it without the question mark"
        if saying := self._sayings.within(said, parts):
            return f"{saying!r} is a saying, and may be no thing to take; name the thing"
        if not _APOSTROPHES.isdisjoint(text) and not found.stops and (told := self._of_somebody(text, parts)):
            return f"{told!r} tells of somebody; say the command alone"
        if not _APOSTROPHES.isdisjoint(text) and not found.stops and (owned := self._of_an_owner(text, parts)):
            return f"{owned!r} may tell whose something is; say the name alone"
        if (added := self._more_than_now.within(said.words, parts)) and not found.stops:
            return f"{added!r} adds to what it is now; say how much it shall be"
        if not found.stops and (often := self._at_times_only(said.words, parts)):
            return f"{often!r} says how often, which is not known; say the command alone"
        if self._is_done_besides(said, parts):
            return f"{said.words[-1]!r} may be a number, or say that this is done as well; say it in other words"
        if name := spoken_to(text, parts, self._values, self._language):
            return f"{name!r} after a pause may be who is spoken to; say the command without it"
        return ""

    def _thanks_once_more(self, said: Utterance) -> bool:
        """Whether nothing is said but thanks and, in one breath, that it is once more: "thanks again". Behind a pause
        they are for what is to be done again: "again, thanks"."""
        found = self._thanking.find(said.words)
        if found is None:
            return False
        start, end = found[0], sum(found)
        begin = start - (self._once_more.ends(said.words[:start]) if said.breaks[start : start + 1] != [True] else 0)
        stop = end + (self._once_more.at(said.words, end) if said.breaks[end : end + 1] != [True] else 0)
        rest = [*said.words[:begin], *said.words[stop:]]
        return (begin, stop) != (start, end) and (not rest or self._fillers.cover(rest))

    def _of_somebody(self, text: str, parts: Sequence[Clause]) -> str:
        """A shortened word that is another without its apostrophe and was left out as such: "we'll" of "we'll lock the
        door". Empty: there is none."""
        if self._language != "en" or not _APOSTROPHE.search(text):
            return ""
        kept = {word for part in parts if part.reading is not None for word in part.reading.words}
        kept |= {word for word, (_, verb) in shortened_in(text).items() if verb in self._how}  # "we're late, go"
        for token in tokenize(text):
            written = text[token.start : token.end]
            if token.word in OTHER_WORDS - kept and _APOSTROPHE.search(written):
                return written
        return ""

    def _of_an_owner(self, text: str, parts: Sequence[Clause]) -> str:
        """A word that is only like a name, or a number, tells whose something is, and stands before free words, which
        may be what that is: "tell Ben's *mother*" is nothing for Ben. Empty: there is none."""
        known = owners(text) if self._language == "en" else frozenset()
        for reading in (part.reading for part in parts if known and part.reading is not None):
            words = reading.words
            free = {slot.start for slot in reading.slots if slot.slot.type in FREE_KINDS}
            for slot in reading.slots:
                last = words[slot.end - 1]
                if slot.status == "fuzzy" and slot.end in free and last in known:
                    return last
                if slot.end in free and words[slot.end] == "s" and f"{last}s" in known:
                    return f"{last}'s"
        return ""

    def _at_times_only(self, words: Sequence[str], parts: Sequence[Clause]) -> str:
        """What says how often where an utterance begins or ends, and was left out, or taken for a joint: "*now and
        then* turn left". Empty: there is nothing."""
        found = self._at_times.find(words)
        if found is None or not (self._fillers.cover(words[: found[0]]) or self._at_times.ends(words)):
            return ""
        often = " ".join(words[found[0] : sum(found)])
        kept = (" ".join(part.reading.words) for part in parts if part.reading is not None)
        return often if not any(f" {often} " in f" {one} " for one in kept) else ""

    def _is_done_besides(self, said: Utterance, parts: Sequence[Clause]) -> bool:
        """Whether what ends a command was read as another word, without which it is one as well: "turn left too" may be
        no turn by two degrees."""
        if not self._besides.may_stand_in(said.words[-1:]):
            return False
        last = parts[-1].reading if parts else None
        if (
            last is None
            or not last.alikes
            or self._besides.at(said.words, len(said) - 1) != 1
            or last.words[-1] == said.words[-1]
        ):
            return False
        return len(last.words) > 1 and any(not one.problem for one in self._commands.readings([*last.words[:-1]]))

    def tells(self, said: Utterance, meant: Understood, *, typed: bool) -> str:
        """Why its words are a condition, or tell of what somebody did; empty: they do not. A stop is one anyhow.

        Args:
            said: the words.
            meant: what they were understood as.
            typed: whether somebody typed them. A recogniser may write "turned left" for "turn left".
        """
        found, parts = meant
        if not (found.reason or self._conditions.may_stand_in(said.words)):  # what reads a word as another says so
            return ""
        if not found.actions or found.stops:
            return ""
        words = [word for word in said.words if word not in self._ways]  # "forwards" is no form of a verb
        told = told_as_done(words, parts, self._alikes, self._language) if typed else None
        if told is not None:
            return f"{told[0]!r} tells what somebody does or did; a command says {told[1]!r}"
        if condition := self._conditions.within(said, parts):
            return f"{condition!r} and what follows may be a condition; say the command alone"
        return ""
