"""Why something is to be done, told beside it: "turn the lamp on, it's dark", "I'm cold, so shut the window", "the lamp
is off, turn it on"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import cached_property

from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.persons_named import Persons
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import listed_words
from intent_engine.language.words.contractions import OTHER_WORDS, apart, shortened_in
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Reasons"]

_MOST = 7
"""Words of such a reason, behind those that it begins with,"""
_MOST_OF_A_THING = 3
"""and of the thing that it is told of."""


class Reasons:
    """Reads a command without the reason for it.

    A reason is told in one clause, behind a pause or a filler ("so"), or before one, of something that is in some way
    now. It has nothing of another command or of a condition ("it is dark *when* you leave"), and does not repeat what
    somebody said. "It" may be what the command names: "go to the kitchen, it's the *bathroom*" names another.
    """

    def __init__(self, matcher: Matcher, phrases: Phrases) -> None:
        grammar, wording = matcher.grammar, matcher.grammar.wording
        self._matcher = matcher
        self._of_whom = wording.tells_of_whom
        self._tells_of_it = wording.tells_of_it
        self._tells_of = wording.tells_of
        self._of_a_thing = wording.tells_of_a
        self._fully, self._who = wording.tells_fully, wording.tells_who
        self._how = wording.tells_how | wording.tells_fully
        self._alone = wording.tells_alone
        self._waits = wording.tells_can
        self._perceives_none = wording.perceives_none
        self._somewhat = wording.somewhat
        self._tale = wording.tells_a_tale
        self._why = wording.why
        self._why_apart = wording.why_apart
        self._thinks = wording.thinks
        self._why_of = wording.why_of
        self._why_to = wording.why_to
        self._begun = {words[:2] for words in (*wording.tells_of_it, *wording.tells_of)}
        known = thing_words(grammar.language)
        self._articles = known.articles
        pronouns = (words for words in grammar.operators.pronoun if self._articles.isdisjoint(words))
        self._persons = Persons(grammar)
        persons = ((word,) for word in self._persons.words)
        self._pronouns = PhraseSet(() if wording.taken_up else (*pronouns, *persons))
        self._taken_up = wording.taken_up
        self._several = wording.several
        self._for_a_thing = {words[0] for words in grammar.operators.pronoun if len(words) == 1} - self._articles
        self._phrases = phrases
        self._closed = frozenset(grammar.operators.closed) - self._how  # "weil es dunkel *ist*"
        particles = frozenset[str]().union(wording.parted, *wording.particles.values())
        self._leads_on = wording.leads - particles  # "the party is *over*", "die Tür ist *auf*"
        self._language = grammar.language

    def without(self, core: Utterance, verbs: Collection[str], text: str = "") -> Iterator[Utterance]:
        """What may be the command without its reason, which stands behind it or before it.

        Args:
            core: the words, without those that say nothing.
            verbs: with which commands begin.
            text: as it was written: "we're" is no "were".
        """
        if not self._tells_of:
            return
        parted = [at for at in range(1, len(core)) if core.breaks[at] is not False or self._says_why(core, at)]
        for at in parted[:1]:
            told, command = core.words[:at], core.part(at, len(core))
            if core.breaks[at] is None and command.words[0] in self._names and not self._says_why(core, at):
                continue  # "we have it just right": a small word is no pause, and no verb is behind it
            if self._is_reason(self._in_full(told, text), command.words, verbs):
                yield command
        for at in parted[-1:]:
            told, command = core.words[at:], core.part(0, at)
            if self._is_reason(self._in_full(told, text), command.words, verbs):
                yield command

    def of_what_is_meant(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """A command behind a reason with what that is told of in the place of its pronoun: "turn the lamp on" of "the
        lamp is off, turn it on"; None: there is none. Where another thing is named before the pronoun, that may be
        meant as well; and so it may be where the reason is told behind ("turn it down, the fan is loud")."""
        at = next((at for at in range(1, len(core)) if core.breaks[at]), 0)
        if not at or self._pronouns.find(core.words, at) is None or core.words[at] not in verbs:
            return None
        told, command = core.words[:at], core.part(at, len(core))
        begin = self._thinks.at(told, 0)
        how = self._behind_a_thing(told, begin, verbs)
        start, length = self._pronouns.find(command.words) or (0, 0)
        if command.words[start] in self._persons.words and not self._persons.places(command):
            return None  # "the nurse is tired, take her bag"
        if not how or not self._tells_no_more(told[how:], verbs) or self._turns(told):
            return None
        again = self._pronouns.find(command.words, start + length) is not None
        if again or self._joins_or_names(command.words[:start]):
            return None
        thing, several = told[begin : how - 1], not self._several.isdisjoint(command.words[start : start + length])
        if several == told[how - 1].endswith("s") or self._names_another(self._not_opposed(told[how:]), command.words):
            return None
        if any(word in command.words and any(opposed(word, self._language)) for word in told[how:]):
            return None  # "the door is open, open it"
        return command.with_other(start, start + length, Utterance.in_one_breath(thing))

    def named_first(self, core: Utterance, verbs: Collection[str]) -> Utterance:
        """An utterance in which only the thing stands before the command that a reason is told of: "die Orchideen,
        gieß sie" of "die Orchideen sind trocken, gieß sie"; none, if there is no such reason."""
        at = next((at for at in range(1, len(core)) if core.breaks[at]), 0)
        told, command = core.words[:at], core.part(at, len(core))
        begin = self._thinks.at(told, 0)
        how = self._behind_a_thing(told, begin, verbs) if at else 0
        rest = told[how:]
        if not how or told[begin] not in self._taken_up or self._turns(told) or not self._waits.isdisjoint(told):
            return core.part(0, 0)
        if (rest and not self._tells_no_more(rest, verbs)) or self._names_another(rest, command.words):
            return core.part(0, 0)
        thing = told[begin : how - 1]
        return Utterance([*thing, *command.words], [*[False] * len(thing), *command.breaks])

    def tells_of_a_name(self, core: Utterance, verbs: Collection[str]) -> bool:
        """Whether it begins with a reason that names something, for which a later pronoun may stand as well: "the
        towels are damp, wash the whites and dry them"."""
        at = next((at for at in range(1, len(core)) if core.breaks[at]), 0)
        how = self._behind_a_thing(core.words[:at], self._thinks.at(core.words[:at], 0), verbs) if at > 1 else 0
        return how > 0 and not self._names.isdisjoint(core.words[:how])

    def _not_opposed(self, rest: Sequence[str]) -> list[str]:
        """What something is, but for states of which there are two: "off"."""
        return [word for word in rest if not any(opposed(word, self._language))]

    def _joins_or_names(self, words: Sequence[str]) -> bool:
        return self._phrases.sequence.find(words) is not None or not self._names.isdisjoint(words)

    def _in_full(self, told: Sequence[str], text: str) -> list[str]:
        """The words, those that are short for two as these: "its" as "it is"."""
        written = shortened_in(text) if not OTHER_WORDS.isdisjoint(told) else {}
        pairs = [
            written.get(word) or next((pair for pair in apart(word) if pair in self._begun), (word,)) for word in told
        ]
        return [word for pair in pairs for word in pair]

    def _says_why(self, core: Utterance, at: int) -> bool:
        return self._why.at(core.words, at) > 0 or self._why_of.at(core.words, at) > 0

    def _is_reason(self, told: Sequence[str], command: Sequence[str], verbs: Collection[str]) -> bool:
        """Whether what is told beside a command says why, and no more."""
        begin = self._why_apart.at(told, 0)
        if senses := self._perceives_none.at(told, begin):
            rest = told[begin + senses :]
            return not rest or (not self._means_otherwise(rest, command) and self._tells_no_more(rest, verbs))
        if self._means_otherwise(told, command):
            return False
        cause = self._why_of.at(told, 0) or self._why_to.at(told, 0)
        if cause:
            return self._tells_no_more(told[cause:], verbs)
        begin += self._thinks.at(told, begin)
        if not self._waits.isdisjoint(told):
            return False  # "die Gäste können warten"
        if alone := self._alone.at(told, begin):
            return len(told) == begin + alone or self._tells_no_more(told[begin + alone :], verbs)
        if of_it := self._tells_of_it.at(told, begin):
            rest = told[begin + of_it :]
            return self._tells_no_more(rest, verbs) and not self._names_another(rest, command)
        if of_others := self._tells_of.at(told, begin):
            return self._tells_no_more(told[begin + of_others :], verbs)
        if not self._of_whom.isdisjoint(told[begin : begin + 1]) and not self._how.isdisjoint(
            told[begin + 1 : begin + 2]
        ):
            rest = told[begin + 2 :]
            return self._tells_no_more(rest, verbs) and rest[0] not in self._articles
        how = self._behind_a_thing(told, begin, verbs)
        if not how or not self._for_a_thing.isdisjoint(command):
            return False
        if told[how - 1] in self._fully:
            return how == len(told) or self._tells_no_more(told[how:], verbs)
        if not self._tells_no_more(told[how:], verbs):
            return False
        # "Windows are open" tells of these, but "site is room two" may tell of what was named.
        return told[begin] in self._of_a_thing or not self._names_another(told[how:], command)

    def _turns(self, told: Sequence[str]) -> bool:
        """Whether words deny, take back, join or repeat something."""
        phrases = self._phrases
        others = (phrases.negation, phrases.sequence, phrases.correction, phrases.cancel, phrases.stop)
        return any(one.find(told) for one in others) or not self._tale.isdisjoint(told)

    def _means_otherwise(self, told: Sequence[str], command: Sequence[str]) -> bool:
        """Whether what is told turns something, or names the opposite of what is to be done: "left, it's right"."""
        return self._turns(told) or any(other in command for word in told for other in opposed(word, self._language))

    def _names_another(self, rest: Sequence[str], command: Sequence[str]) -> bool:
        """Whether what something is may be a thing, a place or a number in the place of one of a command."""
        rest = rest[self._somewhat.at(rest, 0) :]
        others = (word for word in rest if word not in command)
        return (bool(rest) and rest[0] in self._articles) or any(
            word in self._names or self._matcher.is_number(word) for word in others
        )

    @cached_property
    def _names(self) -> frozenset[str]:
        """The words of every value that is listed, and of every place."""
        places = (words for words, _ in self._matcher.locations.names()) if self._matcher.locations else ()
        return listed_words(self._matcher.grammar).union(*places)

    def _behind_a_thing(self, told: Sequence[str], begin: int, verbs: Collection[str]) -> int:
        """Where what is told of a thing goes on behind its verb; 0: no thing is told of."""
        if begin and not self._fully.isdisjoint(told[begin : begin + 1]):
            return begin + 1  # "que esperan"
        first, second = told[begin : begin + 1], told[begin + 1 : begin + 2]
        if not (self._who.isdisjoint(first) or self._fully.isdisjoint(second)):
            return begin + 2
        thing = begin + (told[begin : begin + 1] != [] and told[begin] in self._of_a_thing)
        for at in range(thing + 1, min(thing + _MOST_OF_A_THING + 1, len(told))):
            if told[at] in self._fully or (told[at] in self._how and at < len(told) - 1):
                return at + 1 if self._tells_no_more(told[thing:at], verbs) else 0
        return 0

    def _tells_no_more(self, words: Sequence[str], verbs: Collection[str]) -> bool:
        """Whether there are words, and they have nothing of a command or of a condition."""
        if not 0 < len(words) <= _MOST or not self._closed.isdisjoint(words) or words[-1] in self._leads_on:
            return False  # "he has to, go back": what is left out is as likely a command
        return not any(self._commands(words[at:]) for at, word in enumerate(words) if word in verbs)

    def _commands(self, words: Sequence[str]) -> bool:
        """Whether words are a command, or several of them begin one: "it's so *switch the fan*". One that may begin one
        is as likely another: "the battery is *full*"."""
        said = [*words]
        return bool(self._matcher.read(said)) or (len(said) > 1 and self._matcher.prefix(said)[1] is not None)
