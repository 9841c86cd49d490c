"""The order of the rules: what an utterance means, or why it means nothing."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from intent_engine.actions import Action, Stop
from intent_engine.interpretation import Cause, Interpretation, Status
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.cancelled import Cancelled
from intent_engine.language.meaning.clause import Clause, more_telling
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.corrections.hesitation import Hesitations
from intent_engine.language.meaning.corrections.replacement import Replacements
from intent_engine.language.meaning.dictation import Dictated, Dictation
from intent_engine.language.meaning.fillers_or_words import FillersOrWords
from intent_engine.language.meaning.negations.negation import Negations
from intent_engine.language.meaning.negations.objecting import objects_to_what_is_done
from intent_engine.language.meaning.not_commands.no_command import NoCommand
from intent_engine.language.meaning.not_commands.talk import Talk
from intent_engine.language.meaning.other_words import OtherWords
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.run_on import RunOns
from intent_engine.language.meaning.steps import Kind, Watch, step, watched
from intent_engine.language.meaning.stops import Stops
from intent_engine.language.meaning.taken_otherwise import TakenOtherwise
from intent_engine.language.meaning.told import Understood, as_stop, as_told, as_told_together, which_number
from intent_engine.language.meaning.wordings.dash_or_sign import DashOrSign
from intent_engine.language.meaning.wordings.numbers_in_pieces import NumbersInPieces
from intent_engine.language.meaning.wordings.pronouns import NameSaid
from intent_engine.language.meaning.written_otherwise import WrittenOtherwise
from intent_engine.language.numbers.vague import lacks_a_number
from intent_engine.language.slots.called_so import CalledSo
from intent_engine.language.slots.text_places import TextPlaces
from intent_engine.language.utterance import Utterance, without_enumeration
from intent_engine.needs import MOVING

if TYPE_CHECKING:
    from intent_engine.language.networks.nearest import Nearest

__all__ = ["MAX_CHARACTERS", "MAX_WORDS", "Interpreter", "Understood"]

MAX_WORDS = 80
"""Words beyond which nothing is a command. A long compound order has about 30."""
MAX_CHARACTERS = 2_000
_Rule = TypeVar("_Rule")


class Interpreter:
    """Text to :class:`Interpretation` for one grammar and map. Never raises on text. Thread-safe."""

    def __init__(self, matcher: Matcher, nearest: Nearest) -> None:
        grammar = matcher.grammar
        self.matcher = matcher
        commands = Commands(matcher)
        texts = TextPlaces(matcher)
        at = texts.at if texts else None
        self.phrases = Phrases(grammar, commands.lists, at, texts.name, CalledSo(matcher))
        self._nearest = nearest
        self._dashes = DashOrSign(grammar)
        self._language = grammar.language
        self._stop_intent = grammar.stop_intent
        self._arrange(commands, None)

    def _arrange(self, commands: Commands, watch: Watch | None) -> None:
        """Make the rules, each from those before it."""

        def made(rule: _Rule) -> _Rule:
            return rule if watch is None else watched(rule, watch)

        phrases = self.phrases
        self._dictation = made(Dictation(phrases, commands))
        self._commands = made(commands)
        replacements = made(Replacements(self._commands))
        self._corrections = made(Corrections(phrases, self._commands, replacements))
        self._compounds = made(Compounds(phrases, self._commands, self._corrections))
        self._cancelled = Cancelled(phrases, self._commands, self._compounds)
        self._talk = Talk(phrases, self._commands)
        other_words = OtherWords(self._commands, phrases)
        self._otherwise = WrittenOtherwise(self._commands, phrases, other_words, self._meant)
        self._fillers = FillersOrWords(phrases, self._commands, self._meant)
        self._numbers = made(NumbersInPieces(phrases, self.matcher))
        self._taken_otherwise = TakenOtherwise(phrases, self._commands, self._awake, self._meant)
        self._hesitations = Hesitations(self.matcher, phrases, self._compounds)
        self._run_ons = made(RunOns(phrases, self._commands))
        self._negations = made(Negations(phrases, self._commands, self._compounds, self._corrections, other_words))
        self._stops = made(Stops(phrases, self._commands, self._compounds, self._run_ons))
        self._no_command = made(NoCommand(phrases, self._commands, self._compounds, self._corrections, self._nearest))

    def dictated(self, text: str) -> Dictated | None:
        """The command in which a text is dictated, whatever the robot does; None: nothing is."""
        return self._dictation.taken(text) if self._dictation else None

    def dictates(self, text: str) -> bool:
        """Whether something is dictated in a text, also behind other commands."""
        return bool(self._dictation) and self._dictated(text, (), spoken=False) is not None

    def denied_part(self, text: str, before: str, state: Collection[str] = ()) -> tuple[Action, ...]:
        """What a text says not to do that names only a part of it: "not the kitchen", after "go to the kitchen".

        Args:
            text: what was said or typed.
            before: the text of what was last understood.
            state: states of the robot.
        """
        core = self.phrases.without_fillers(self._said(text))
        if not self._negations.stands_in(core):
            return ()
        return self._negations.denied_part(core, self.understand(before, state)[1], state)

    def objection(self, text: str, before: str, state: Collection[str] = ()) -> Interpretation | None:
        """The stop of a robot that moves, at a "no" with more behind it ("no, the lab", after "go to the kitchen");
        None: it may be said to somebody else. The arguments are those of :meth:`denied_part`."""
        said = self._said(text)
        heard = (said, before, lambda one: self.understand(one, state)[0])
        if not objects_to_what_is_done(self.phrases, self._commands, *heard):
            return None
        return self._objected(text, said.words)[0]

    def named_before(self, text: str, before: str, state: Collection[str] = ()) -> list[NameSaid]:
        """What was named before for which the pronoun of a text may stand, each with the text that has it there: "close
        the lid" of "close it", after "open the lid". The arguments are those of :meth:`denied_part`."""
        return self._otherwise.named_before(text, lambda: self.understand(before, state)[1], self.understand)

    def watched(self, watch: Watch) -> Interpreter:
        """Another that understands the same, and whose every step a watcher sees."""
        other = watched(self, watch)
        other._arrange(self._commands, watch)
        return other

    # -- the order of things ----------------------------------------------------------------------------------

    def interpret(
        self, text: str, state: Collection[str] = (), *, spoken: bool = False, heard: bool = False
    ) -> Interpretation:
        """The meaning of a text.

        Args:
            text: what was said or typed.
            state: names of the states that the robot is in, for ``requires`` and ``excludes``.
            spoken: whether a wake word is needed, if the grammar has one. Stop never needs it. It was heard as well.
            heard: whether a recogniser wrote it, and may have written "turned left" for "turn left".
        """
        return self.understand(text, state, spoken=spoken, heard=heard)[0]

    def understand(
        self, text: str, state: Collection[str] = (), *, spoken: bool = False, heard: bool = False
    ) -> Understood:
        """The same, with the commands of which the meaning is made."""
        if len(text) > MAX_CHARACTERS:
            return self._rejected(text, f"longer than any command ({len(text)} characters)")
        if self._dashes.may_stand_in(text):
            return self._dashes.understood(text, lambda one: self._understood(one, state, spoken=spoken, heard=heard))
        return self._understood(text, state, spoken=spoken, heard=heard)

    def _understood(self, text: str, state: Collection[str], *, spoken: bool, heard: bool) -> Understood:
        """The same, dashes before numbers taken for no sign."""
        typed = not (spoken or heard)
        sentence = without_enumeration(text)
        if sentence is not text:
            said = self._said(sentence)
            understood = self._meant(sentence, said, state, spoken)
            if reason := self._talk.tells(said, understood, typed=typed):
                understood = self._rejected(sentence, reason)
            if understood[0].status is Status.ACCEPTED:
                return understood  # else it may be how a number was written: "2. Meters ahead"
        said = self._said(text)
        words = said.words
        if not words:
            return self._rejected(text, "nothing was said")
        if len(words) > MAX_WORDS:
            return self._rejected(text, f"longer than any command ({len(words)} words)")
        meant = self._meant(text, said, state, spoken)
        lettered = Utterance.with_letters(text, self._language)
        if lettered is not None and not meant[0].stops:
            said, meant = self._taken_otherwise.by_letters(text, (said, meant), lettered, state, spoken)
        if meant[0].status is Status.REJECTED:
            said, meant = self._taken_otherwise.as_asked(text, (said, meant), state, spoken)
        talk = self._talk
        if reason := talk.asks_or_quotes(text, said, meant, spoken=spoken) or talk.tells(said, meant, typed=typed):
            return self._rejected(text, reason)
        if meant[0].status is Status.ACCEPTED and (other := self.phrases.or_commands.in_full(said)) is not None:
            return self._fillers.or_either(text, meant, other, state)
        return meant

    def _said(self, text: str) -> Utterance:
        return self.matcher.as_written(Utterance.of(text, self._language))

    def _meant(self, text: str, said: Utterance, state: Collection[str], spoken: bool = False) -> Understood:
        words, phrases = said.words, self.phrases
        if phrases.stop.may_stand_in(words) and self._stops.heard(said, state):
            return self._stopped(text)
        if phrases.stop_by_sound.may_stand_in(words) and self._stops.by_sound(said):
            return self._stopped(text)
        if self._dictation and (dictated := self._dictated(text, state, spoken=spoken)) is not None:
            stops = self._stops.beside(said, phrases.without_fillers(said), state)
            return self._stopped(text) if stops else dictated
        if said.unclear:
            return self._unclear(text, said, state)
        if phrases.wake:
            woken = self._awake(said)
            if woken is None and spoken:
                understood = self._meant(text, said, state, spoken=False)
                if understood[0].actions and all(isinstance(action, Stop) for action in understood[0].actions):
                    return understood  # "stop turning left" is a stop, too, and never needs it
                return self._rejected(text, f"did not begin with {' '.join(self.matcher.grammar.wake[0])!r}")
            said = woken or said
        in_pieces = self._numbers.in_pieces(said)
        clause = self._commands.exact(said.words, state, "", said.breaks) if not in_pieces else None
        if clause is not None and clause.accepted:
            free = clause.reading is not None and clause.reading.free_words > 0
            if not free or not phrases.fillers.may_stand_in(said.words):
                return as_told(text, clause)  # else fillers may stand in the free words: "the cup please"
        core = phrases.without_fillers(said)
        if clause is not None and clause.accepted and core is said:
            return as_told(text, clause)
        if core.words and phrases.or_commands.only_agrees(said):
            return self._agreed(text, core)
        if (listed := self._fillers.listed(text, said, state)) is not None:
            return listed
        if phrases.fillers.may_stand_in(said.words) and not self._numbers.restarted(core, said):
            again = self._fillers.besides(said, core, state)
            if again is not None and (again.accepted or clause is None or again.no_name):
                clause = again  # "take your time please" takes no "time please"
            if clause is not None and clause.accepted:
                return as_told(text, clause)
        if core is not said and phrases.stop.may_stand_in(core.words) and self._stops.heard(core, state):
            return self._stopped(text)  # "halten Sie bitte an": some stand within a stop
        if not core.words:
            return self._rejected(text, "no command in it")
        if clause is not None and clause.ambiguous:
            return self._otherwise.or_asked(text, core, state, clause)
        if self._numbers.restarted(core, said):
            if self._stops.beside(said, core, state):
                return self._stopped(text)
            return self._rejected(text, "the number was said in two pieces; say it again")
        understood = self._operated(text, said, core, state, clause)
        may_agree = understood[0].actions and not (understood[0].stops or understood[0].corrected)
        if may_agree and phrases.or_commands.agrees_at_last(said):
            understood = self._agreed(text, core)
        if MOVING in state and not understood[0].actions and (stop := self._stop_at_first(core, state)):
            return self._stopped(text, f"{stop!r} stops, and what follows was not understood", Cause.REST_UNKNOWN)
        return understood

    def _stop_at_first(self, core: Utterance, state: Collection[str]) -> str:
        """The words before a pause that would stop a robot that moves, if no more had been said: "wait, the cat is
        there". What follows is not understood, and takes nothing back. Empty: there are none; a "no" may begin an
        answer to somebody else ("no, I did not see it")."""
        pauses = (place for place in range(1, len(core)) if core.breaks[place])
        for begun in (core.part(0, place) for place in pauses):
            found, _ = self._meant(" ".join(begun.words), begun, state)
            if found.stops and not found.objects:
                return found.text
        return ""

    def _dictated(self, text: str, state: Collection[str], *, spoken: bool) -> Understood | None:
        """A command in which something is dictated, alone or behind others: "turn left, and write down that ...". What
        is before it must be commands by itself: "don't turn left, and say hello" is understood as any other text."""
        if (alone := self._dictation.taken(text, state, spoken)) is not None:
            return as_told(text, alone.clause)
        for before, dictated in self._dictation.behind(text, state):
            found, parts = self._meant(before, self._said(before), state, spoken)
            if found.status is Status.ACCEPTED and parts and not found.stops:
                return as_told_together(text, [*parts, dictated.clause], self._stop_intent)
        return None

    def _operated(
        self, text: str, said: Utterance, core: Utterance, state: Collection[str], clause: Clause | None
    ) -> Understood:
        """What is no single exact sentence: cancellation, negation, correction, compound, misheard names."""
        words = core.words
        if 0 < (ends := self.phrases.in_its_place.ends(words)) < len(words):
            found, told = self._operated(text, said, core.part(0, len(words) - ends), state, clause)
            if len(found.actions) == 1 or found.denied:
                return found, told  # "turn left, turn right instead" may be both, or one
        takes_back = self._corrections.may_stand_in(words) or self.phrases.cancel.may_stand_in(words)
        if takes_back and self._stops.in_protest(core, state):
            return self._stopped(text)
        if MOVING in state and self._stops.in_objection(said, core):
            return self._objected(text, words)
        if MOVING in state and self._stops.in_denial(core):
            return self._stopped(text)
        if MOVING in state and self.phrases.objections.only_hold(words):
            return self._stopped(text)
        if self.phrases.cancel.may_stand_in(words) and 0 < self.phrases.cancel.ends(words) < len(words):
            return self._rejected(text, "cancelled in the same breath", Cause.CANCELLED)
        if self._stops.in_a_sentence(core):
            return self._stopped(text)
        if self.phrases.stop.may_stand_in(words) and self._stops.of_doing(core):
            return self._stopped(text)
        if after := self._cancelled.after(core, state):
            found, told = self._meant(text, core.part(after, len(core)), state, spoken=False)
            if found.status is Status.ACCEPTED:
                return replace(found, reason=found.reason or f"after {' '.join(words[:after])!r}"), told
        if MOVING in state and self._stops.is_sentence(words[: self.phrases.cancel.at(words, 0)]):
            return self._stopped(text)  # whatever follows: "never mind turn right"
        if taken_back := self._corrections.taken_back(words):
            if self._stops.beside(said, core, state):  # "just wait, stop, just wait"
                return self._stopped(text)
            if self.phrases.objections.only_hold(words):
                return self._held_at_rest(text, words)
            return self._rejected(text, f"taken back: {' '.join(words[-taken_back:])!r}")
        negated = self._negations.stands_in(core)
        if negated:
            wanted, reason = self._negations.wanted(core, state)
            if wanted is None:
                ways = (core, self.phrases.without_idle_fillers(said), said)  # "oh" may be a zero
                if MOVING in state and any(self._negations.forbids_motion(way, state) for way in ways):
                    return self._stopped(text)
                denied = self._negations.denied(core, state)
                begins = self._negations.begins(core)
                if MOVING in state and self._stops.behind_what_is_denied(core, denied, begins=begins):
                    return self._stopped(text)
                if self.phrases.stop.may_stand_in(words) and self._stops.between(said, state):
                    return self._stopped(text)  # "don't move a muscle, stop": some stops say no
                return replace(self._rejected(text, reason, Cause.NEGATED)[0], denied=denied), ()
            found, told = self._affirmed(text, said, wanted, state, None, negated=True)
            return replace(found, denied=self._negations.denied_beside(core, wanted, state)), told
        return self._affirmed(text, said, core, state, clause, negated=False)

    def _affirmed(
        self,
        text: str,
        said: Utterance,
        core: Utterance,
        state: Collection[str],
        clause: Clause | None,
        *,
        negated: bool,
    ) -> Understood:
        """What is wanted, where nothing is negated, or besides what was."""
        words = core.words
        parts = self._compounds.split(core, state)
        if parts is None and not negated:  # "turn left and do that again": some fillers end a sentence
            for fuller in (self.phrases.without_idle_fillers(said), self.phrases.without_opening(said)):
                if parts is None and len(fuller) > len(core):
                    parts = self._compounds.split(fuller, state, exactly=True)
        if parts is not None:
            return as_told_together(text, self._hesitations.or_either(parts, said, state), self._stop_intent)
        single = self._compounds.part(core, state, loosely=not negated)
        if single is not None and (single.accepted or single.ambiguous):
            return as_told(text, single) if single.accepted else self._otherwise.or_asked(text, core, state, single)
        if not negated and self.phrases.stop.may_stand_in(words) and self._stops.between(said, state):
            return self._stopped(text)
        if not negated and (commands := self._run_ons.split(core, state)) is not None:
            fuller = self.phrases.without_idle_fillers(said)  # of "about face" one word is a filler
            other = self._run_ons.split(fuller, state) if len(fuller) > len(core) else None
            if other is not None and [one.action for one in other] != [one.action for one in commands]:
                return self._rejected(text, "it could mean two things")
            return as_told_together(text, self._hesitations.or_either(commands, said, state), self._stop_intent)
        written = self._otherwise.understood(text, core, state)
        if written is not None:
            return written
        if not negated and self._stops_beside_what_is_understood(core, state):
            return self._stopped(text)
        if self.phrases.objections.only_hold(words) and self.matcher.prefix(words)[1] is None:
            return self._held_at_rest(text, words)
        if vague := lacks_a_number(core, self._language, lambda one: self._meant(text, one, state)[0].status):
            return self._rejected(text, vague)
        return self._no_command.told(text, core, state, more_telling(clause, single))

    def _unclear(self, text: str, said: Utterance, state: Collection[str]) -> Understood:
        """A number that could be another: nothing is done with it, but a stop is heard beside it."""
        if self._stops.beside(said, self.phrases.without_fillers(said), state):
            return self._stopped(text)
        return self._rejected(text, which_number(said.unclear, self._language))

    def _stops_beside_what_is_understood(self, core: Utterance, state: Collection[str]) -> bool:
        """Whether an utterance begins or ends with a stop, and the rest is understood in any way: "stop lift up the
        cup the cup"."""
        rest = self._stops.left_out(core)
        return rest is not None and self._meant(" ".join(rest.words), rest, state)[0].status is Status.ACCEPTED

    @step(Kind.WAKE)
    def _awake(self, said: Utterance) -> Utterance | None:
        return self.phrases.awake(said)

    # -- results ------------------------------------------------------------------------------------------------

    def _stopped(self, text: str, reason: str = "", *causes: Cause) -> Understood:
        found, parts = as_stop(text, self._stop_intent)
        return (replace(found, reason=reason, causes=frozenset(causes)) if reason else found), parts

    def _objected(self, text: str, words: Sequence[str]) -> Understood:
        return self._stopped(text, f"{' '.join(words)!r} said to a robot that moves", Cause.OBJECTED)

    def _agreed(self, text: str, core: Utterance) -> Understood:
        reason = f"{core.words[-1]!r} may be a command, or only agree; say it in a whole sentence"
        return self._rejected(text, reason)

    def _held_at_rest(self, text: str, words: Sequence[str]) -> Understood:
        return self._rejected(text, f"cancelled: {' '.join(words)!r} where nothing moves", Cause.CANCELLED)

    @step(Kind.REFUSAL)
    def _rejected(self, text: str, reason: str, *causes: Cause) -> Understood:
        return Interpretation(text, Status.REJECTED, reason=reason, causes=frozenset(causes)), ()
