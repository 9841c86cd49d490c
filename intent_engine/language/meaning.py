"""What an utterance means: stop first, then exact sentences, then the operators of speech, then misheard names.

The order is the safety of it. Nothing fuzzy is tried on words that hold a negation, a correction or a word that
changes a sentence's sense; a compound is taken whole or not at all; two meanings are nobody's order.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from intent_engine.actions import Action, Stop
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.action_builder import CannotActError, build_action
from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.matcher import Matcher, Reading, SlotReading
from intent_engine.language.numbers.english import NUMBER_WORDS
from intent_engine.language.patterns import Patterns
from intent_engine.language.quantities import Relative, evaluate, is_number_word, is_numeral
from intent_engine.language.spellings import own_words
from intent_engine.language.utterance import Openers, PhraseSet, Utterance

if TYPE_CHECKING:
    from intent_engine.language.nearest import Nearest

__all__ = ["MAX_WORDS", "Interpreter"]

MAX_WORDS = 80
"""Words beyond which nothing is a command. A long compound order has about 30."""
MAX_CHARACTERS = 2_000
MAX_PARTS = 8
"""Commands in one utterance."""
_WITH_UNITS = tuple(kind for kind in QUANTITY_KINDS if kind not in ("number", "ordinal"))
MOVING = "moving"
"""The robot state in which any utterance that begins with a stop word stops it."""


@dataclass(frozen=True, slots=True)
class Clause:
    """One command, understood, or why not."""

    reading: Reading | None = None
    action: Action | None = None
    reason: str = ""
    """Why it is not accepted; or what was changed to accept it."""
    alternatives: tuple[str, ...] = ()
    ambiguous: bool = False

    @property
    def accepted(self) -> bool:
        return self.action is not None


class Interpreter:
    """Text to :class:`Interpretation` for one grammar and map. Never raises on text. Thread-safe."""

    def __init__(self, matcher: Matcher, nearest: Nearest) -> None:
        grammar = matcher.grammar
        self.matcher = matcher
        self._grammar = grammar
        self._nearest = nearest
        self._patterns = Patterns(grammar)
        operators = grammar.operators
        self._fillers = PhraseSet(grammar.fillers)
        own = own_words(grammar)
        self._idle = PhraseSet(words for words in grammar.fillers if not own.issuperset(words))
        """Fillers that no sentence needs: without "for me", "wait for me" would be gone as well."""
        self._phrases = PhraseSet((*operators.correction, *operators.cancel, *operators.negation))
        """Operators, of which no filler takes a part."""
        self._wake = PhraseSet(grammar.wake)
        self._stop = PhraseSet(operators.stop)
        self._negation = PhraseSet(operators.negation)
        self._correction = PhraseSet(operators.correction)
        self._cancel = PhraseSet(operators.cancel)
        self._sequence = PhraseSet(operators.sequence)
        self._contrast = PhraseSet(operators.contrast)
        opening = (words for words in grammar.fillers if any((word,) in operators.sequence for word in words))
        self._openers = Openers(PhraseSet(opening), self._sequence)
        self._closed = operators.closed
        self._stop_intent = next(
            (intent.name for intent in grammar.intents.values() if intent.action.type == "stop"), "stop"
        )

    # -- the order of things ----------------------------------------------------------------------------------

    def interpret(self, text: str, state: Collection[str] = (), *, spoken: bool = False) -> Interpretation:
        """The meaning of a text.

        Args:
            text: what was said or typed.
            state: names of the states that the robot is in, for ``requires`` and ``excludes``.
            spoken: whether a wake word is needed, if the grammar has one. Stop never needs it.
        """
        if len(text) > MAX_CHARACTERS:
            return self._rejected(text, f"longer than any command ({len(text)} characters)")
        said = Utterance.of(text)
        if not said.words:
            return self._rejected(text, "nothing was said")
        if len(said) > MAX_WORDS:
            return self._rejected(text, f"longer than any command ({len(said)} words)")
        if self._stop.may_stand_in(said.words) and self._stops(said, state):
            return Interpretation(text, Status.ACCEPTED, self._stop_intent, {}, (Stop(),), 1.0)
        if self._wake:
            woken = self._awake(said)
            if woken is None and spoken:
                return self._rejected(text, f"did not begin with {' '.join(self._grammar.wake[0])!r}")
            said = woken or said
        clause = self._exact(said.words, state)
        if clause is not None and clause.accepted:
            free = clause.reading is not None and clause.reading.free_words > 0
            if not free or not self._fillers.may_stand_in(said.words):
                return self._accepted(text, clause)  # else fillers may stand in the free words: "the cup please"
        core = said.without(self._fillers, self._phrases, self._openers)
        if clause is not None and clause.accepted and core is said:
            return self._accepted(text, clause)
        if core is not said and not self._number_restarted(core):
            again = self._exact(core.words, state)
            if again is None:  # "uh, again": some fillers are sentences as well, or parts of one
                again = self._exact(said.without(self._idle, self._phrases, self._openers).words, state)
            if again is not None and (again.accepted or clause is None):
                clause = again
            if clause is not None and clause.accepted:
                return self._accepted(text, clause)
        if not core.words:
            return self._rejected(text, "no command in it")
        if clause is not None and clause.ambiguous:
            return self._not_accepted(text, clause)
        if self._number_restarted(core):
            return self._rejected(text, "the number was said in two pieces; say it again")
        return self._operated(text, said, core, state, clause)

    def _number_restarted(self, core: Utterance) -> bool:
        """ "nine, uh, forty five degrees": two numbers, not 945. Which one was meant nobody can know."""
        return any(
            self._is_number(core.words[place - 1]) and self._is_number(core.words[place]) for place in core.joined
        )

    def _is_number(self, word: str) -> bool:
        language = self._grammar.language
        return is_numeral(word) or (word in NUMBER_WORDS if language == "en" else is_number_word(word, language))

    def _operated(
        self, text: str, said: Utterance, core: Utterance, state: Collection[str], clause: Clause | None
    ) -> Interpretation:
        """What is no single exact sentence: cancellation, negation, correction, compound, misheard names."""
        words = core.words
        if self._cancel.may_stand_in(words) and 0 < self._cancel.ends(words) < len(words):
            return self._rejected(text, "cancelled in the same breath")
        if self._halts(core):
            return Interpretation(text, Status.ACCEPTED, self._stop_intent, {}, (Stop(),), 1.0)
        taken_back = self._correction.ends(words) if self._correction.may_stand_in(words) else 0
        if 0 < taken_back < len(words) and not self._sequenced(words, len(words) - taken_back):
            return self._rejected(text, f"taken back: {' '.join(words[-taken_back:])!r}")
        negated = self._negation.may_stand_in(words) and self._negated_at(words) is not None
        if negated:
            wanted, reason = self._after_negation(core, state)
            if wanted is None:
                return self._rejected(text, reason)
            core = wanted
        parts = self._compound(core, state)
        if parts is not None:
            return self._joined(text, parts)
        single = self._clause(core, state, loosely=not negated)
        if single is not None and (single.accepted or single.ambiguous):
            return self._accepted(text, single) if single.accepted else self._not_accepted(text, single)
        if not negated and self._stop.may_stand_in(words) and self._stops_between(said, state):
            return Interpretation(text, Status.ACCEPTED, self._stop_intent, {}, (Stop(),), 1.0)
        return self._not_understood(text, core, clause or single)

    # -- stop ---------------------------------------------------------------------------------------------------

    def _stops(self, said: Utterance, state: Collection[str]) -> bool:
        """Whether any clause of the utterance is a command to stop.

        A clause is one that begins the utterance (after fillers, a wake word or "no"), follows a pause, or ends a
        sentence that was begun ("go forward stop"). "the bus stop", "don't stop" and "stop the music" are none; but
        while the robot moves, an utterance that *begins* with a stop word stops it whatever comes after.
        """
        words = said.words
        start = self._skip(words, 0)
        if self._only_stops(words, start):
            return True
        if MOVING in state and self._stop.at(words, start) and not self._is_sentence(words, state):
            return True
        if self._corrected_after(words, start):
            return True
        for position in range(start + 1, len(words)):
            if not self._stop.at(words, position):
                continue
            if said.breaks[position] or self._clause_begins(words, start, position):
                if self._negated_before(words, position):
                    continue
                if self._corrected_after(words, position):
                    return True
                ends = self._only_stops(words, position)
                if ends and not self._sequenced(words, position) and not self._is_sentence(words, state):
                    return True
        return False

    def _is_sentence(self, words: list[str], state: Collection[str]) -> bool:
        """Whether the words are a sentence that could be meant: "go to the bus stop", where there is such a place."""
        clause = self._exact(words, state)
        return clause is not None and (clause.accepted or clause.ambiguous)

    def _skip(self, words: list[str], position: int) -> int:
        """Past fillers, wake words and words of correction ("no stop", "hey robot stop")."""
        while position < len(words):
            length = max(
                self._fillers.at(words, position),
                self._wake.at(words, position),
                self._correction.at(words, position),
            )
            if not length or self._stop.at(words, position) >= length:
                break
            position += length
        return position

    def _only_stops(self, words: list[str], position: int) -> bool:
        """Whether nothing but stop phrases and fillers follows, with at least one of the former first."""
        found = False
        while position < len(words):
            length = self._stop.at(words, position)
            if length:
                found = True
            elif found:
                length = self._fillers.at(words, position) or self._wake.at(words, position)
            if not length and found:
                length = _echo(words, position)
            if not length:
                return False
            position += length
        return found

    def _clause_begins(self, words: list[str], start: int, position: int) -> bool:
        """Whether what stands before could be a command by itself, so that a new clause can begin here."""
        before = (
            Utterance(words[start:position], [False] * (position - start))
            .without(self._fillers, self._phrases, self._openers)
            .words
        )
        if not before:
            return True
        correction = self._correction.ends(before)
        if correction:
            before = before[: len(before) - correction]
        if self._stop.may_stand_in(before) and self._only_stops(before, 0):
            return True
        count, reached = self.matcher.prefix(before)
        return reached is not None and count > 0

    def _halts(self, core: Utterance) -> bool:
        """ "go forward for two seconds, wait a minute": a command, and then a sentence of the stop intent.

        The words of those sentences are more than stop words, and begin like corrections: nothing is corrected.
        """
        words = core.words
        for position in range(1, len(words)):
            readings = self.matcher.read(words[position:])
            if not any(reading.intent.action.type == "stop" and not reading.problem for reading in readings):
                continue
            apart = core.breaks[position] or self._clause_begins(words, 0, position)
            if apart and not self._negated_before(words, position) and not self._sequenced(words, position):
                return True
        return False

    def _corrected_after(self, words: list[str], position: int) -> bool:
        """Whether a stop phrase stands here and a correction or cancellation ("do not") after it.

        "stop, no, go forward", "stop don't move": nothing said in the same breath takes a stop back. A negation alone
        does: "halt nicht an".
        """
        length = self._stop.at(words, position)
        after = position + length
        return length > 0 and any(phrases.at(words, after) for phrases in (self._correction, self._cancel))

    def _stops_between(self, said: Utterance, state: Collection[str]) -> bool:
        """ "stop turn left", "turn left stop turn right": written without their pauses, commands around a stop."""
        words = said.words
        begins = [self._skip(words, 0), 0]
        position = begins[0]
        while position <= len(words):
            length = self._stop.at(words, position)
            if not length and position < len(words):
                position += 1
                continue
            if not any(self._only_commands(said.part(begin, position), state) for begin in begins):
                return False
            begins = [position + shorter for shorter in self._stop.lengths_at(words, position)] + [position]
            position += max(length, 1)
        return True

    def _only_commands(self, part: Utterance, state: Collection[str]) -> bool:
        """Whether a part between stop words is commands, or only fillers, and so no talk about something else."""
        part = part.part(self._sequence.at(part.words, 0), len(part))
        for joint in (self._correction, self._sequence):
            part = part.part(0, len(part) - joint.ends(part.words))
        core = part.without(self._fillers, self._phrases, self._openers)
        known = not core.words or self._accepts(part, state) or self._accepts(core, state)
        return known or self._compound(core, state) is not None

    def _negated_before(self, words: list[str], position: int) -> bool:
        return any(self._negation.at(words, back) == position - back for back in range(max(0, position - 3), position))

    def _sequenced(self, words: list[str], position: int) -> bool:
        """Whether "and then" stands before: a stop at the end of a list of commands is where it ends anyway."""
        return any(self._sequence.at(words, back) == position - back for back in range(max(0, position - 4), position))

    def _awake(self, said: Utterance) -> Utterance | None:
        position = 0
        while position < len(said):
            length = self._wake.at(said.words, position)
            if length:
                return said.part(position + length, len(said))
            length = self._fillers.at(said.words, position)
            if not length:
                return None
            position += length
        return None

    # -- one command --------------------------------------------------------------------------------------------

    def _exact(self, words: list[str], state: Collection[str]) -> Clause | None:
        """The command that these words are, exactly; None if no sentence has them."""
        readings = self.matcher.read(words)
        if self._patterns:
            readings = [*readings, *self._patterns.read(words, self.matcher)]
        return self._choose(readings, state) if readings else None

    def _clause(self, part: Utterance, state: Collection[str], *, loosely: bool) -> Clause | None:
        """The command that a part of an utterance is: exact, corrected, or with misheard names."""
        words = part.words
        clause = self._exact(words, state)
        if clause is not None and (clause.accepted or clause.ambiguous):
            return clause
        if self._correction.may_stand_in(words):
            corrected = self._corrected(part, state)
            if corrected is not None:
                return corrected
        if loosely and not self._holds_operator(words):
            loose = self._misheard(words, state)
            if loose is not None:
                return loose
        return clause

    def _holds_operator(self, words: list[str]) -> bool:
        return not self._closed.isdisjoint(words)

    def _misheard(self, words: list[str], state: Collection[str]) -> Clause | None:
        readings = self.matcher.read(words, loose=True)
        if not readings:
            return None
        # Something must have been heard as it is: "lft" alone is nothing.
        good = [reading for reading in readings if not reading.problem and reading.heard_exactly]
        if good:
            best = max(good, key=lambda reading: (reading.intent.priority, -reading.free_words, reading.score))
            level = [
                reading
                for reading in good
                if reading.intent.priority == best.intent.priority
                and reading.free_words == best.free_words
                and reading.score > best.score - 0.08
            ]
            return self._choose([best, *(reading for reading in level if reading is not best)], state)
        wrong = [reading for reading in readings if reading.problem]
        return self._choose([min(wrong, key=_problem_rank)], state) if wrong else None

    def _choose(self, readings: list[Reading], state: Collection[str]) -> Clause:
        """The one meaning of readings that are best first, or why there is none."""
        best = readings[0]
        if best.problem:
            return self._problem_clause(best)
        allowed = [reading for reading in readings if not reading.problem and not self._forbidden(reading, state)]
        if not allowed:
            return Clause(best, reason=self._forbidden(best, state))
        best = allowed[0]
        try:
            action = build_action(best.intent, best.values(), self.matcher.locations)
        except CannotActError as error:
            return Clause(best, reason=str(error))
        if len(allowed) > 1:
            rivals = self._rivals(best, action, allowed[1:])
            if rivals:
                return Clause(
                    best,
                    reason="it could mean two things",
                    alternatives=(describe(best, action), *rivals),
                    ambiguous=True,
                )
        return Clause(best, action, _changes(best))

    def _rivals(self, best: Reading, action: Action, others: list[Reading]) -> tuple[str, ...]:
        """Other meanings as good as the best: same words understood, same priority, another action."""
        found: list[str] = []
        for other in others:
            if (other.intent.priority, other.free_words, other.alikes) != (
                best.intent.priority,
                best.free_words,
                best.alikes,
            ):
                continue
            try:
                meant = build_action(other.intent, other.values(), self.matcher.locations)
            except CannotActError:
                continue
            if meant != action:
                found.append(describe(other, meant))
        return tuple(dict.fromkeys(found))

    def _forbidden(self, reading: Reading, state: Collection[str]) -> str:
        intent = reading.intent
        missing = intent.requires - set(state) if intent.requires else None
        if missing:
            return f"{intent.name} needs the robot to be {' and '.join(sorted(missing))}"
        present = intent.excludes & set(state) if intent.excludes else None
        if present:
            return f"{intent.name} cannot be done while the robot is {' and '.join(sorted(present))}"
        return ""

    def _problem_clause(self, reading: Reading) -> Clause:
        slot = next(slot for slot in reading.slots if slot.problem)
        names = tuple(name for name, _ in slot.rivals[:3])
        if slot.status == "ambiguous":
            return Clause(reading, reason=slot.problem, alternatives=names, ambiguous=True)
        return Clause(reading, reason=slot.problem, alternatives=names)

    # -- operators ----------------------------------------------------------------------------------------------

    def _negated_at(self, words: list[str]) -> tuple[int, int] | None:
        """(position, length) of the first negation that is no part of a correction: "no espera" corrects, where "no"
        negates; "no no" may be either, and so negates."""
        position = 0
        while position < len(words):
            length = self._negation.at(words, position)
            corrects = self._correction.at(words, position)
            if corrects > length and not all(
                self._negation.at([word], 0) for word in words[position : position + corrects]
            ):
                position += corrects
            elif length:
                return position, length
            else:
                position += 1
        return None

    def _after_negation(self, core: Utterance, state: Collection[str]) -> tuple[Utterance | None, str]:
        """What is still wanted of an utterance with a negation: only what follows "instead" or "but".

        "don't turn left, turn right": the first part must be a whole command and a pause or a contrast must follow,
        and what follows must be whole commands. Anything else with a negation does nothing.
        """
        words = core.words
        found = self._negated_at(words)
        if found is None:
            return core, ""
        position, length = found
        refused = f"negated: {' '.join(words[position : position + length])!r}"
        if words[:position] not in ([], ["do"], ["please", "do"], ["please"]):
            return None, refused
        for end in range(position + length + 1, len(words)):
            contrast = self._contrast.at(words, end)
            if not contrast and not core.breaks[end]:
                continue
            forbidden = self._exact(words[position + length : end], state)
            if forbidden is None:
                continue
            wanted = core.part(end + contrast, len(core))
            if not wanted.words or self._negation.may_stand_in(wanted.words):
                continue
            if self._sequence.at(wanted.words, 0):
                continue
            if self._compound(wanted, state) or self._accepts(wanted, state):
                return wanted, ""
        return None, refused

    def _accepts(self, part: Utterance, state: Collection[str]) -> bool:
        clause = self._exact(part.words, state)
        return clause is not None and clause.accepted

    def _corrected(self, part: Utterance, state: Collection[str]) -> Clause | None:
        """ "turn left no right", "go to the kitchen I mean the lab": the last word counts."""
        pieces = list(self._split_corrections(part))
        if len(pieces) < 2:
            return self._corrected_before(part, state)
        current = pieces[0].words
        for piece in pieces[1:]:
            if not piece.words:
                continue
            replaced = self._replace(current, piece.words, state)
            if replaced is None:
                return None
            current = replaced
        clause = self._exact(current, state)
        if clause is None or not clause.accepted:
            return clause
        return Clause(clause.reading, clause.action, f"corrected to {' '.join(current)!r}")

    def _corrected_before(self, part: Utterance, state: Collection[str]) -> Clause | None:
        """ "no, turn left", "actually go back": a whole command after a word of correction replaces an earlier one.

        Not "sorry, right": one word is as likely talk. Nor "no turn left" in one breath, which may forbid.
        """
        start = 0
        while length := self._correction.at(part.words, start):
            start += length
        forbids = set(part.words[:start]) == {"no"} and not self._pause_after(part, start)
        if not start or len(part) < start + 2 or forbids:
            return None
        clause = self._exact(part.words[start:], state)
        if clause is None or not clause.accepted:
            return clause
        return replace(clause, reason=f"after {' '.join(part.words[:start])!r}")

    def _split_corrections(self, part: Utterance) -> Iterator[Utterance]:
        start = position = 0
        while position < len(part):
            length = self._correction.at(part.words, position)
            if length:
                bare = position == 0 and not self._pause_after(part, position + length)
                if bare and part.words[0] == "no" and length == 1:
                    return  # "no go to the kitchen": who knows
                if position > start or start > 0:
                    yield part.part(start, position)
                start = position = position + length
            else:
                position += 1
        yield part.part(start, len(part))

    def _pause_after(self, part: Utterance, position: int) -> bool:
        return position < len(part) and part.breaks[position]

    def _replace(self, said: list[str], meant: list[str], state: Collection[str]) -> list[str] | None:
        """``said`` with the part that ``meant`` corrects replaced, or None if that is not clear.

        ``meant`` takes the place of one slot of ``said`` (or of the end of it), so that the intent stays and as many
        words as possible are kept; two ways that keep as many and differ are not clear. Else it is a whole command.
        """
        whole = self._whole(meant, state)
        if not said:
            return meant if whole else None
        kept: dict[tuple[bool, int], dict[tuple[Any, ...], list[str]]] = {}
        first = next((reading for reading in self.matcher.read(said) if not reading.problem), None)
        for words, count, at, label in self._replacements(said, meant, first, whole) if first is not None else ():
            assert first is not None
            old = first.values()
            for reading in self.matcher.read(words)[:1]:
                if reading.problem or reading.intent is not first.intent:
                    continue
                touched = [slot for slot in reading.slots if slot.start < at + len(meant) and slot.end > at]
                if label is not None and label not in (slot.label for slot in touched):
                    continue
                if any(self._grafted(slot, at, meant, whole) for slot in touched):
                    continue
                new = reading.values()
                if set(new) != set(old) or sum(old[label] != value for label, value in new.items()) > 1:
                    continue
                meaning = tuple(sorted((label, str(value)) for label, value in new.items()))
                # A place takes the place of a place, though free words would take it as well.
                known = not any(slot.slot.type in ("text", "object") for slot in touched)
                kept.setdefault((known, count), {}).setdefault(meaning, words)
        if kept:
            best = kept[max(kept)]
            return next(iter(best.values())) if len(best) == 1 else None
        if whole:
            # One sentence, whole or begun: of two commands joined by "and", only the last is corrected.
            _, reached = self.matcher.strict.walk(said)
            return meant if reached is not None else None
        return None

    def _replacements(
        self, said: list[str], meant: list[str], reading: Reading, whole: bool
    ) -> Iterator[tuple[list[str], int, int, str | None]]:
        """Each way to put ``meant`` into ``said``: the words, how many of the old are kept, where the new ones begin,
        and the slot that they are for."""
        within: set[int] = set()
        for slot in reading.slots:
            if slot.slot.type in ("text", "object"):
                # Any words would do there, so all of them are replaced, and never by what is a command itself.
                within.update(range(slot.start + (not whole), slot.end))
                ends = [] if whole else [slot.end]
            else:
                ends = list(range(slot.end, slot.start, -1))
            for end in ends:
                yield said[: slot.start] + meant + said[end:], len(said) - (end - slot.start), slot.start, slot.label
        for start in range(len(said) - 1, 0, -1):
            if start not in within:
                yield said[:start] + meant, start, start, None

    def _grafted(self, slot: SlotReading, at: int, meant: list[str], whole: bool) -> bool:
        """Whether a slot would hold what was said and what was meant as one: "point" + "20 degrees per second".

        A number alone may take the unit that was said before ("two meters, no, three"), a value with its unit takes
        the place of all. Free words take nothing over, and never hold what is a command by itself.
        """
        mixed = slot.start < at or slot.end > at + len(meant)
        if slot.slot.type in ("text", "object"):
            return mixed or whole
        if not mixed:
            return False
        if slot.slot.type in QUANTITY_KINDS:
            kinds = _WITH_UNITS if slot.slot.type in _WITH_UNITS else (slot.slot.type,)
            return any(evaluate(meant, kind, self._grammar.language) is not None for kind in kinds)
        return self.matcher.slot_from_words(slot.slot, slot.label, meant).status == "exact"

    def _whole(self, words: list[str], state: Collection[str]) -> bool:
        clause = self._exact(words, state)
        return clause is not None and clause.accepted

    # -- compounds ----------------------------------------------------------------------------------------------

    def _compound(self, core: Utterance, state: Collection[str]) -> list[Clause] | None:
        """The commands that an utterance joins, if every part of some split is a whole command; else None."""
        words = core.words
        if not self._sequence.may_stand_in(words) and not any(core.breaks[1:]):
            return None
        tried: dict[int, list[Clause] | None] = {}

        def rest(start: int, depth: int) -> list[Clause] | None:
            if start in tried:
                return tried[start]
            tried[start] = None
            found: list[Clause] | None = None
            for end, after in self._boundaries(core, start):
                clause = self._clause(core.part(start, end), state, loosely=True)
                if clause is None or not clause.accepted:
                    continue
                if end == len(words):
                    found = [clause]
                elif self._only_stops(words, after):
                    found = [clause]  # "... and stop": every command ends with the robot at rest
                elif depth < MAX_PARTS:
                    onward = rest(after, depth + 1)
                    found = [clause, *onward] if onward is not None else None
                    if after > end and onward and len(onward) == 1 and isinstance(onward[0].action, Stop):
                        found = [clause]  # "... and wait there"
                if found is not None:
                    break
            tried[start] = found
            return found

        start = self._sequence.at(words, 0)
        parts = rest(start, 1)
        if parts is None or (len(parts) == 1 and not self._sequence.may_stand_in(words)):
            return parts if parts else None
        return parts

    def _boundaries(self, core: Utterance, start: int) -> Iterator[tuple[int, int]]:
        """(end of this part, start of the next), the longest part first."""
        words = core.words
        yield len(words), len(words)
        for end in range(len(words) - 1, start, -1):
            for length in self._sequence.lengths_at(words, end):
                after = end + length
                # "turn 15 and 20 degrees": one number or two, nobody can know.
                if after < len(words) and not (self._is_number(words[end - 1]) and self._is_number(words[after])):
                    yield end, after
            if core.breaks[end]:
                yield end, end

    def _joined(self, text: str, parts: list[Clause]) -> Interpretation:
        if len(parts) == 1:
            return self._accepted(text, parts[0])
        if any(isinstance(part.action, Stop) for part in parts):
            return Interpretation(text, Status.ACCEPTED, self._stop_intent, {}, (Stop(),), 1.0)
        steps = []
        actions: list[Action] = []
        score = 1.0
        for part in parts:
            assert part.reading is not None
            assert part.action is not None
            steps.append({"intent": part.reading.intent.name, "slots": slot_values(part.reading)})
            actions.append(part.action)
            score *= part.reading.score
        reasons = "; ".join(part.reason for part in parts if part.reason)
        return Interpretation(text, Status.ACCEPTED, "compound", {"steps": steps}, tuple(actions), score, (), reasons)

    # -- results ------------------------------------------------------------------------------------------------

    def _accepted(self, text: str, clause: Clause) -> Interpretation:
        reading, action = clause.reading, clause.action
        assert reading is not None
        assert action is not None
        return Interpretation(
            text,
            Status.ACCEPTED,
            reading.intent.name,
            slot_values(reading),
            (action,),
            reading.score,
            (),
            clause.reason,
        )

    def _not_accepted(self, text: str, clause: Clause) -> Interpretation:
        status = Status.AMBIGUOUS if clause.ambiguous else Status.REJECTED
        intent = clause.reading.intent.name if clause.reading else None
        slots = slot_values(clause.reading) if clause.reading else {}
        return Interpretation(text, status, intent, slots, (), 0.0, clause.alternatives, clause.reason)

    def _rejected(self, text: str, reason: str) -> Interpretation:
        return Interpretation(text, Status.REJECTED, reason=reason)

    def _not_understood(self, text: str, core: Utterance, clause: Clause | None) -> Interpretation:
        words = core.words
        if not self._holds_operator(words) and not (clause is not None and clause.ambiguous):
            # Before what a name is not: "go to the" is unfinished, not a place called "the".
            _, reached = self.matcher.prefix(words)
            unfinished = clause is not None and clause.reading is not None and clause.reading.unfinished
            if reached is not None and (unfinished or not self.matcher.spoken.accepting(reached)):
                following = sorted(self.matcher.spoken.next_words(reached))[:8]
                return Interpretation(
                    text,
                    Status.INCOMPLETE,
                    reason="the sentence is not finished",
                    alternatives=tuple(following),
                )
        if clause is not None:
            return self._not_accepted(text, clause)
        near = self._nearest.sentences(words)
        return Interpretation(text, Status.REJECTED, reason="not a command of this grammar", alternatives=near)


def _echo(words: list[str], position: int) -> int:
    """Length of the words here that only say again what stands before: "stop right there right there"."""
    for length in range(min(position, len(words) - position), 0, -1):
        if words[position : position + length] == words[position - length : position]:
            return length
    return 0


def _problem_rank(reading: Reading) -> tuple[int, int, float]:
    """Which failure tells most: an ambiguous name, then a limit, then the fewest words not understood."""
    order = {"ambiguous": 0, "limit": 1}
    slot = next(slot for slot in reading.slots if slot.problem)
    nearest = slot.rivals[0][1] if slot.rivals else 0.0
    return order.get(slot.status, 2), slot.end - slot.start, -nearest


def _changes(reading: Reading) -> str:
    """What was changed to accept a reading that is not exact."""
    changes = [
        f"heard {' '.join(reading.words[slot.start : slot.end])!r} as {slot.value!r}"
        for slot in reading.slots
        if slot.status == "fuzzy"
    ]
    if reading.alikes:
        changes.append(f"read as {' '.join(reading.words)!r}")
    return "; ".join(changes)


def slot_values(reading: Reading) -> dict[str, Any]:
    """Slots for a person or a program: SI numbers, names, text; a relative speed as its factor of the usual one."""
    values: Mapping[str, Any] = reading.values()
    return {
        label: value.factor if isinstance(value, Relative) else value
        for label, value in values.items()
        if value is not None
    }


def describe(reading: Reading, action: Action) -> str:
    """A short name of a meaning, for "did you mean"."""
    values = ", ".join(f"{label}: {value}" for label, value in slot_values(reading).items())
    return f"{reading.intent.name} ({values})" if values else reading.intent.name
