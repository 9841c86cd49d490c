"""The same words as a grammar has them: written together or apart, said twice, one thing where it has more of it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from contextvars import ContextVar
from dataclasses import replace
from functools import partial

from intent_engine.actions import Action
from intent_engine.interpretation import Status
from intent_engine.language.context.going_on import is_a_list
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import LEAST_WORDS, Commands
from intent_engine.language.meaning.corrections.said_twice import SaidTwice
from intent_engine.language.meaning.negations.forbidden_verbs import verb_first
from intent_engine.language.meaning.other_words import OtherWords
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.told import Understood, as_told, names_any, only, readings_of
from intent_engine.language.meaning.wordings.asked_in_turn import asked_in_turn
from intent_engine.language.meaning.wordings.behind_the_verb import BehindTheVerb
from intent_engine.language.meaning.wordings.by_number import ByNumber
from intent_engine.language.meaning.wordings.for_whom_asked import ForWhomAsked
from intent_engine.language.meaning.wordings.formal import Formal
from intent_engine.language.meaning.wordings.given_to import GivenTo
from intent_engine.language.meaning.wordings.how_often import HowOften
from intent_engine.language.meaning.wordings.infinitive_alone import infinitive_alone
from intent_engine.language.meaning.wordings.itself import Itself
from intent_engine.language.meaning.wordings.joined import Joined
from intent_engine.language.meaning.wordings.named_again import NamedAgain
from intent_engine.language.meaning.wordings.numbers_otherwise import NUMBERS, NumbersRule
from intent_engine.language.meaning.wordings.one_of_it import OneOfIt
from intent_engine.language.meaning.wordings.particles import Particles
from intent_engine.language.meaning.wordings.permitted import Permitted
from intent_engine.language.meaning.wordings.placed_first import PlacedFirst
from intent_engine.language.meaning.wordings.pronoun_behind import PronounBehind
from intent_engine.language.meaning.wordings.pronouns import NameSaid
from intent_engine.language.meaning.wordings.reasons import Reasons
from intent_engine.language.meaning.wordings.said_first import SaidFirst
from intent_engine.language.meaning.wordings.said_lightly import SaidLightly
from intent_engine.language.meaning.wordings.shared_nouns import SharedNouns
from intent_engine.language.meaning.wordings.taken_up import TakenUp
from intent_engine.language.meaning.wordings.told_which import ToldWhich
from intent_engine.language.meaning.wordings.verb_again import VerbAgain
from intent_engine.language.meaning.wordings.verb_last import VerbLast
from intent_engine.language.meaning.wordings.verb_second import VerbSecond
from intent_engine.language.meaning.wordings.ways_on import WaysOn
from intent_engine.language.meaning.wordings.wished_forms import WishedForms
from intent_engine.language.reading import Reading
from intent_engine.language.templates.plurals import Plurals
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.owners import owners
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["WrittenOtherwise"]

_FORM_AND_VERB = 2
_DEEPEST = 12  # ways to write what was said, one upon the other
_UNDER_WAY: ContextVar[tuple[tuple[str, ...], ...]] = ContextVar("_UNDER_WAY", default=())
"""What is being understood as something else, so that none is tried again within: "kilos" as "kilo", as "kilos"."""


class WrittenOtherwise:
    """What is no command as it was said, and one as it may be written.

    Args:
        commands: of the grammar.
        phrases: of the grammar.
        other_words: of its commands.
        meant: what an utterance means in a state of the robot, with the text that it was said in.
    """

    def __init__(
        self,
        commands: Commands,
        phrases: Phrases,
        other_words: OtherWords,
        meant: Callable[[str, Utterance, Collection[str]], Understood],
    ) -> None:
        self._commands = commands
        self._matcher = commands.matcher
        self._meant = meant
        self._phrases = phrases
        self._behind = BehindTheVerb(phrases, self._matcher)
        wording = self._matcher.grammar.wording
        self._formal = Formal(phrases, commands, wording.formal)
        self._asking = Formal(phrases, commands, wording.asking)
        self._itself = Itself(self._matcher)
        self._verb_again = VerbAgain(self._matcher.grammar, phrases)
        self._verb_last = VerbLast(self._matcher)
        self._verb_second = VerbSecond(self._matcher.grammar, self._asking, self._formal)
        self._told_as = Formal(phrases, commands, wording.told_as, tells=False)
        forms = ("/".join(form) for form in wording.forbidden if len(form) == _FORM_AND_VERB)
        self._infinitives = Formal(phrases, commands, () if wording.parted else forms, tells=False)
        self._for_whom = ForWhomAsked(phrases, commands, self._infinitives, self._asking)
        self._pronoun = PronounBehind(phrases, commands)
        self._wishing, self._kindly = wording.wishing, wording.kindly
        self._wished = WishedForms(self._matcher.grammar)
        self._ways_on = WaysOn(self._matcher.grammar)
        self._joined = Joined(phrases, commands, self._formal)
        self._said_twice = SaidTwice(commands, phrases)
        self._permitted = Permitted(wording)
        self._reasons = Reasons(self._matcher, phrases)
        often = HowOften(self._matcher.grammar, phrases)
        rules: tuple[NumbersRule, ...] = (*OneOfIt(commands).rules, often.rule, *ByNumber(self._matcher.grammar).rules)
        self._numbers = (*NUMBERS, *rules, *GivenTo(commands).rules, *ToldWhich(commands).rules)
        self._pointing = NamedAgain(self._matcher.grammar, phrases)
        self._particles = Particles(commands, phrases)
        self._shared_nouns = SharedNouns(self._matcher, phrases)
        self._said_lightly = SaidLightly(self._matcher.grammar, phrases)
        self._taken_up = TakenUp(self._matcher.grammar, phrases, self._formal, self._infinitives, self._asking)
        self._said_first = SaidFirst(self._matcher.grammar, phrases)
        self._placed_first = PlacedFirst(self._matcher.grammar, phrases)
        self._other_words = other_words
        self._plurals = Plurals(self._matcher.grammar, lambda: commands.first_words)

    def understood(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """The meaning of what was said as the grammar has it; None: it is no command so either.

        Args:
            text: what was said or typed.
            core: its words, without those that say nothing.
            state: of the robot.
        """
        language = self._matcher.grammar.language
        written = self._understood_as(text, core, self._matcher.spacing.otherwise(core), state)
        for other in self._with_other_verbs(text, core):
            written = written or self._understood_as(text, core, other, state)
        for behind_the_verb in (self._behind.ordered, self._behind.said_once, self._behind.for_nobody):
            if written is None:
                other = behind_the_verb(core, self._commands.first_words)
                written = self._understood_as(text, core, other, state)
        written = written or self._without_softening(text, core, state) or self._taken_up_first(text, core, state)
        written = written or self._understood_as(text, core, self._particles.placed(core, state), state)
        if written is None:
            written = self._in_the_infinitive(text, core, state) or self._asked_for(text, core, state)
            written = written or self._verb_behind(text, core, state, self._phrases.correction)
        if written is None:
            written = self._begun_twice(text, core, state) or self._manner_moved(text, core, state)
            written = written or self._placed_later(text, core, state)
        for other in self._matcher.unit_symbols.in_full(core):
            written = written or self._understood_as(text, core, other, state)
        for otherwise, is_meant in self._numbers:
            if written is None:
                written = self._understood_as(text, core, otherwise(core, language), state)
                if not is_meant(core, readings_of(written), language):
                    written = None
        rules = (self._of_listed_things, self._done_to_itself, self._with_its_verb_again, self._without_ways_on)
        for rule in (*rules, self._counted_otherwise, self._for_each, self._named_again):
            written = written or rule(text, core, state)
        told = written or self._understood_as(text, core, self._other_words.told(core, state, asks="?" in text), state)
        return told or self._verb_behind(text, core, state, self._phrases.sequence)

    def or_asked(self, text: str, core: Utterance, state: Collection[str], asks: Clause) -> Understood:
        """What is asked back, unless that is only what the verb of a command is, and another form of one of the verbs
        that are asked about was said: "fermez la vanne" of a grammar that has "{ouvre|ferme} la vanne"."""
        first = next(iter(asks.reading.slots), None) if asks.reading is not None else None
        if first is None or first.start or first.status == "exact":
            return as_told(text, asks)
        found = self.understood(text, core, state)
        values = [reading.values().get(first.label) for reading in readings_of(found)]
        is_one = found is not None and len(values) == 1 and values[0] in asks.alternatives
        return found if found is not None and is_one else as_told(text, asks)

    def _with_other_verbs(self, text: str, core: Utterance) -> Iterator[Utterance | None]:
        """An utterance with its verbs in other forms in which the same may be told."""
        yield from self._reasons.without(core, self._commands.verbs, text)
        yield self._behind.but_for_besides(core)
        yield self._permitted.ordered(core, self._said(text), asks="?" in text)
        if "?" not in text:  # "schalten Sie die Lampe ein?" asks
            yield self._formal.told(core)
        yield self._told_as.told(core)
        yield self._joined.apart(core)
        kindly = self._kindly.find(self._said(text).words) is not None
        asked = self._for_whom.asked(core)
        if asked is not None and (kindly or self._joined.for_whom(core)):
            yield self._asking.told(asked) or asked
        elif kindly:
            yield self._asking.told(core)
        if kindly:
            yield from self._verb_second.ways(core)
        if kindly or self._matcher.grammar.wording.joined:
            yield from self._pronoun.asked(core)

    def _said(self, text: str) -> Utterance:
        return self._matcher.as_written(Utterance.of(text, self._matcher.grammar.language))

    def _in_the_infinitive(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Den Ball aufheben" is told; a question asks whether."""
        clause = infinitive_alone(core, self._commands, state) if "?" not in text else None
        return as_told(text, clause) if clause is not None else None

    def _verb_behind(self, text: str, core: Utterance, state: Collection[str], joint: PhraseSet) -> Understood | None:
        """ "Die Pumpe und die Heizung ausschalten", "den Kopf auf 20, nein, auf 30 Grad stellen"."""
        joined = "?" not in text and joint.find(core.words[:-1], 1) is not None
        ways = self._verb_last.of_several(core, self._commands.verbs) if joined else ()
        found = ((way, self._understood_as(text, core, way.said, state)) for way in ways)
        return only(one for way, one in found if one is not None and all(map(way.is_meant, readings_of(one))))

    def _asked_for(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Kannst du mir das Licht anmachen?" and "ich möchte, dass du das Licht anmachst" of a grammar that has "mach
        das Licht an". What asks are fillers of several words; a question without a verb that requests asks whether."""
        grammar, verbs = self._matcher.grammar, self._commands.verbs
        said = self._said(text)
        if not grammar.wording.parted and 0 < (wish := self._wishing.at(core.words, 0)) < len(core):
            if "?" in text:
                return None
            rest = core.part(wish, len(core))
            wished = self._for_whom.behind_what_asks(rest)
            told = self._understood_as(text, core, self._infinitives.told(wished) or wished, state)
            return told or only(self._understood_as(text, core, way, state) for way in self._pronoun.asked_for(rest))
        requests = self._phrases.requests(said.words) or self._begs(said)
        requests = requests or ("?" not in text and self._permitted.asks_within(said, core))
        asks = any(length > 1 for length in self._phrases.fillers.lengths_at(said.words, 0))
        if not (asks or requests) or ("?" in text and not requests):
            return None
        if not grammar.wording.parted:
            asked = self._for_whom.behind_what_asks(core)
            told = self._understood_as(text, core, self._infinitives.told(asked), state)
            ways = self._pronoun.asked_for(core, said.words[:1])
            return told or only(self._understood_as(text, core, way, state) for way in ways)
        begins = (0, 1) if core.words[0] in grammar.wording.for_whom else (0,)
        for part in (part for begin in begins for part in self._verb_last.in_order(core.part(begin, len(core)))):
            told = self._told(text, said, part, state)
            if told is not None:
                return told
        if not self._phrases.sequence.may_stand_in(core.words):
            return None
        several = asked_in_turn(core, self._phrases, lambda one: self._told(text, said, one, state))
        listed = (one for way in self._wished.ways(said, core) for one in self._verb_last.of_several(way, verbs))
        orders = (several, *(one.said for one in listed))
        return next(filter(None, (self._understood_as(text, core, one, state) for one in orders)), None)

    def _begs(self, said: Utterance) -> bool:
        """Whether a word anywhere makes an order of it that is a filler by itself: "die Pumpe *bitte* ausschalten"."""
        grammar = self._matcher.grammar
        return any((word,) in grammar.fillers for word in said.words if word in grammar.wording.requests)

    def _told(self, text: str, said: Utterance, asked: Utterance, state: Collection[str]) -> Understood | None:
        """The order that is asked for, with its verb first; None: it is none, or could be two."""
        grammar = self._matcher.grammar
        if len(asked) < (1 if self._begs(said) else LEAST_WORDS):  # "hupen bitte"
            return None
        ways = self._wished.ways(said, asked)
        found: dict[tuple[Action | None, ...], Clause] = {}
        for told in (one for way in ways for one in (way, *verb_first(way, grammar))):
            clause = self._commands.exact(told.words, state, breaks=told.breaks)
            if clause is not None and clause.accepted and not names_any(clause.reading, grammar.wording.before_verbs):
                found.setdefault((clause.action,), clause)
        if found:
            return as_told(text, next(iter(found.values()))) if len(found) == 1 else None
        ordered = (one for way in ways for one in verb_first(way, grammar) if one.words[0] in self._commands.verbs)
        return only(self._placed_later(text, order, state) for order in ordered)

    def _begun_twice(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Go go to the kitchen", "go to the to the kitchen": what was said twice, as people do who begin again."""
        if (anew := self._said_twice.begun_anew(core, self._said(text))) is not None:
            return self._understood_as(text, core, anew, state)
        once = self._said_twice.once(core)
        found = self._understood_as(text, core, once, state) if once is not None else None
        if found is None or once is None or not self._said_twice.means(found[1], core, once):
            return None
        return found

    def _manner_moved(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "For ten minutes water the beds" of a grammar that has "water the beds for ten minutes", and "turn the crank
        slowly" of one that has "slowly turn the crank"."""
        rule, verbs = self._said_first, self._commands.verbs
        ways = (*rule.verb_first(core, verbs), *rule.manner_first(core))
        found = self._one_of(text, core, [(way, partial(rule.means, moved=moved)) for way, moved in ways], state)
        if found is not None:
            return found
        behind = list(rule.behind_the_verb(core, verbs))  # "im Flur dimme das Licht auf zehn Prozent"
        found = self._one_of(text, core, [(way, partial(rule.means, moved=moved)) for way, moved in behind], state)
        return found or only(self._placed_later(text, way, state) for way, _ in behind)

    def _placed_later(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Mach im Flur das Licht an" of a grammar that has "mach das Licht im Flur an"."""
        rule = self._placed_first
        ways = rule.ways(core, self._commands.verbs)
        means = [(way, partial(rule.means, start=start, end=end)) for way, start, end in ways]
        return self._one_of(text, core, means, state)

    def _one_of(
        self,
        text: str,
        core: Utterance,
        ways: Sequence[tuple[Utterance, Callable[[Reading], bool]]],
        state: Collection[str],
    ) -> Understood | None:
        """The one command among ways to say it, each with whether a reading of it is what was meant."""
        found: dict[Action | None, Understood] = {}
        for other, is_meant in ways:
            clause = self._commands.exact(other.words, state, breaks=other.breaks)
            reading = clause.reading if clause is not None and clause.accepted else None
            if clause is not None and reading and len(reading.words) == len(other) and is_meant(reading):
                changed = f"heard {' '.join(core.words)!r} as {' '.join(other.words)!r}"
                found.setdefault(clause.action, as_told(text, replace(clause, reason=changed)))
        return next(iter(found.values())) if len(found) == 1 else None

    def _without_softening(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Ouvre voir la porte" of a grammar that has "ouvre la porte"."""
        rule, verbs = self._said_lightly, self._commands.verbs | self._formal.forms_in(core)
        found = self._understood_as(text, core, rule.without(core, verbs), state)
        return found if found is not None and rule.means(core, verbs, readings_of(found)) else None

    def _taken_up_first(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "La palette, descends-la" of a grammar that has "descends la palette"."""
        things = self._taken_up.things(core, self._said(text), self._commands.verbs)
        means = ((self._understood_as(text, core, way, state) for way in ways) for ways in things)
        return only(next(filter(None, ways), None) for ways in means)

    def _done_to_itself(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Dreh nach links" of a grammar that has "dreh dich nach links", and no free words for "dich"."""
        ways = (self._understood_as(text, core, way, state) for way in self._itself.ways(core, self._commands.verbs))
        found = next(filter(None, ways), None)
        return None if any(reading.free_words for reading in readings_of(found)) else found

    def _of_listed_things(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "The lamp is off, turn it on" and "fold the towels for the kids", of things that a grammar knows."""
        verbs = self._commands.verbs
        first = self._taken_up.ways(self._reasons.named_first(core, verbs), verbs)
        ways = (self._behind.for_others(core), self._reasons.of_what_is_meant(core, verbs), *first)
        found = next(filter(None, (self._understood_as(text, core, way, state) for way in ways)), None)
        return None if any(reading.free_words for reading in readings_of(found)) else found

    def _with_its_verb_again(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Mach die Jalousie auf und das Licht aus" of a grammar with a command for each."""
        for way, means in self._verb_again.ways(core, self._commands.verbs):
            found = self._understood_as(text, core, way, state)
            if means(readings_of(found)):
                return found
        return None

    def _without_ways_on(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Bring the tray over to the lab" of a grammar that has "to the lab", "turn the lamp back on" of one that has
        "turn the lamp on"."""
        ways = (self._understood_as(text, core, other, state) for other in self._ways_on.without(core))
        found = next(filter(None, ways), None)
        return found if found is not None and self._ways_on.means(core, readings_of(found)) else None

    def _named_again(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Fly to tank 2 and photograph it": with the one name that was said before and fits; or with the noun of
        "close the first valve and open the second"."""
        if self._reasons.tells_of_a_name(core, self._commands.verbs):
            return None
        return self._pointing.put_in(core, partial(self._understood_as, text, core, state=state))

    def named_before(
        self, text: str, before: Callable[[], Sequence[Clause]], understood: Callable[[str], Understood]
    ) -> list[NameSaid]:
        """What the commands of an earlier utterance named for which the pronoun of a text may stand. "Drop it" may only
        take back what was said."""
        core = self._phrases.without_fillers(self._said(text))
        if self._phrases.cancel.cover(core.words):
            return []
        has_a_verb = self._commands.may_have_a_verb(core.words)
        named = self._pointing.before(text, core, before, understood) if has_a_verb else []
        return [*named, *self._taken_up.before(text, core, self._said(text), before, self._commands.verbs)]

    def _counted_otherwise(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "One tip", "two point five bars" and "beers" of a grammar that has "tips", "bar" and "beer"."""
        begun = self._matcher.prefix(core.words)[1] is not None  # "sow three row": it may have broken off
        for known in (False, True)[: 1 if begun else 2]:
            other = self._plurals.otherwise(core, known=known, owners=owners(text))
            found = self._understood_as(text, core, other, state)
            if found is not None and other is not None:
                return None if self._plurals.changes_free_words(core, other, readings_of(found)) else found
        return None

    def _for_each(self, text: str, core: Utterance, state: Collection[str]) -> Understood | None:
        """ "Switch on the lamps in the kitchen and the hall" of a grammar that has "the lamp": one command for each."""
        if not self._phrases.sequence.may_stand_in(core.words):
            return None
        for way, noun in self._shared_nouns.ways(core, self._commands.verbs):  # "the left and right armrest"
            if self._shared_nouns.means(readings_of(found := self._understood_as(text, core, way, state)), noun):
                return found
        other = self._plurals.one_of_each(core)
        found = self._understood_as(text, core, other, state)
        if found is None or other is None or not is_a_list(found[0]):
            return None
        return None if self._plurals.changes_free_words(core, other, readings_of(found)) else found

    def _understood_as(
        self, text: str, core: Utterance, other: Utterance | None, state: Collection[str]
    ) -> Understood | None:
        """What was said as it is written otherwise, if it is a command so."""
        under_way = _UNDER_WAY.get()
        if other is None or tuple(other.words) in under_way or len(under_way) > _DEEPEST:
            return None
        before = _UNDER_WAY.set((*under_way, tuple(core.words)))
        try:
            found, parts = self._meant(text, other, state)
        finally:
            _UNDER_WAY.reset(before)
        if found.status is not Status.ACCEPTED:
            return None
        changed = f"heard {' '.join(core.words)!r} as {' '.join(other.words)!r}"
        return replace(found, reason="; ".join(filter(None, (changed, found.reason)))), parts
