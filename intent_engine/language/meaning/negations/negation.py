"""Negation: whatever else is said, a negated command is not done. Only what is wanted instead may be."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from intent_engine.actions import Action, Custom, Stop
from intent_engine.language.grammar import MOTIONS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.negations.denied_parts import DeniedParts
from intent_engine.language.meaning.negations.excluding import Excluding
from intent_engine.language.meaning.negations.forbidden_verbs import as_told, verb_first
from intent_engine.language.meaning.negations.motion_verbs import MotionVerbs
from intent_engine.language.meaning.negations.where_denied import WhereDenied
from intent_engine.language.meaning.other_words import OtherWords
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Negations"]


class Negations:
    """What an utterance with a negation leaves to be done."""

    def __init__(
        self,
        phrases: Phrases,
        commands: Commands,
        compounds: Compounds,
        corrections: Corrections,
        other_words: OtherWords,
    ) -> None:
        self._phrases = phrases
        self._negation = phrases.negation
        self._commands = commands
        self._compounds = compounds
        self._corrections = corrections
        self._other_words = other_words
        wording = commands.matcher.grammar.wording
        self._before = frozenset(((), *wording.before_negations))
        self._excluding = Excluding(wording)
        self._first = WhereDenied(phrases, wording).first
        self._behind_the_verb = bool(wording.behind_verbs)
        self._articles = thing_words(commands.matcher.grammar.language).articles
        self._parts = DeniedParts(commands, corrections)
        self._verbs = MotionVerbs(commands.matcher.grammar)

    def stands_in(self, core: Utterance) -> bool:
        return self._negation.may_stand_in(core.words) and self._first(core) is not None

    def begins(self, core: Utterance) -> bool:
        """Whether an utterance begins with its negation, or with words of correction before that."""
        found = self._first(core)
        if found is None:
            return False
        lengths = (0, *self._phrases.correction.lengths_at(core.words, 0))
        return any(tuple(core.words[length : found[0]]) in self._before for length in lengths if length <= found[0])

    def forbids_motion(self, core: Utterance, state: Collection[str]) -> bool:
        """Whether nothing is said but that a motion is not to be: "don't move", "don't go to the kitchen".

        It need not be said as the grammar has it: "don't go to the kichen", "don't my left turn".
        """
        found = self._first(core)
        if found is None:
            return False
        position, length = found
        before = core.words[:position]
        more = [word for word in before if (word,) not in self._before]
        if tuple(before) in self._before or self._phrases.fillers.cover(more):
            before = []
        after = core.part(position + length, len(core))
        grammar = self._commands.matcher.grammar
        ways = as_told(after, grammar)
        if any(self._is_motion([*before, *way.words], state) for way in ways if self._first(way) is None):
            return True
        said = Utterance([*before, *after.words], [False] * (len(before) + len(after)))
        if self._first(said) is not None:
            return False
        if any(self._is_exactly_a_motion(way.words, state) for way in verb_first(said, grammar)):
            return True
        other = self._other_words.told(said, state, asks=False)  # "don't turn to the left"
        return other is not None and self._is_exactly_a_motion(other.words, state)

    def denied(self, core: Utterance, state: Collection[str]) -> tuple[Action, ...]:
        """What an utterance with a negation says not to do: "don't clean the lab". A word of correction may stand
        before it, which in Spanish is the negation as well: "no, no limpies el laboratorio".

        More may follow that is not clear, and leaves what stands before it forbidden: "don't clean the lab, then clean
        the hall" may want the hall, or neither.
        """
        parts = (core.part(begin, len(core)) for begin in (0, *self._phrases.correction.lengths_at(core.words, 0)))
        return next(filter(None, (self._forbidden(part, state) for part in parts)), ())

    def _forbidden(self, part: Utterance, state: Collection[str]) -> tuple[Action, ...]:
        """The commands that are forbidden one after another, each in words of its own, from the first word on."""
        found = self._first(part)
        if found is None:
            return ()
        position, length = found
        start = position if tuple(part.words[:position]) in self._before else 0
        for end, after in self._ends_of_forbidden(part, start, position, length):
            told = self._denied(part.part(start, end), position - start, length, state)
            action = self._action(told, state) if told is not None else None
            if action is not None:
                return (action, *self._forbidden(part.part(after, len(part)), state))
        return ()

    def _ends_of_forbidden(self, part: Utterance, start: int, position: int, length: int) -> Iterator[tuple[int, int]]:
        """Where what is forbidden may end, the longest first, and where what follows it begins: behind a joint, a
        contrast or a pause. A negation stands last only in the same breath: "nicht" of "geh ins Labor, nicht, äh, in
        die Küche" forbids no lab."""
        yield len(part), len(part)
        last = position > start and self._behind_the_verb and not part.breaks[position]
        for end in range(len(part) - 1, position + length - last, -1):
            joint = max(self._phrases.sequence.at(part.words, end), self._phrases.contrast.at(part.words, end))
            if joint or part.breaks[end]:
                yield end, end + joint

    def denied_part(self, core: Utterance, done: Sequence[Clause], state: Collection[str]) -> tuple[Action, ...]:
        """What an utterance says not to do by naming a part of it: "not the kitchen", after "go to the kitchen".

        What is named takes the place of its like in a command that was done, and makes the one that shall not be; words
        that any would do in place of name nothing. So does the verb of a command: "don't bring it".

        Args:
            core: what was said.
            done: commands that were understood before.
            state: of the robot.
        """
        for begin in (0, *self._phrases.correction.lengths_at(core.words, 0)):
            part = core.part(begin, len(core))
            found = self._first(part)
            if found is None:
                continue
            start, before = found[0] + found[1], part.words[: found[0]]
            first = tuple(before) in self._before
            if denied := self._parts.by_verb([*(() if first else before), *part.words[start:]], done):
                return denied
            if not first:
                continue
            ends = (
                at for at in range(start + 1, len(part)) if part.breaks[at] or self._phrases.contrast.at(part.words, at)
            )
            named = part.part(start, next(ends, len(part)))
            if not named.words or self._negation.find(named.words) is not None:
                continue
            parts = (self._parts.denied(clause, named, state) for clause in done)
            if (action := next((one for one in parts if one is not None), None)) is not None:
                return (action,)
        return ()

    def denied_beside(self, core: Utterance, wanted: Utterance, state: Collection[str]) -> tuple[Action, ...]:
        """What shall not be done of an utterance of which something is wanted: "don't clean the lab, clean the hall",
        "clean the hall, not the lab". Nothing of what is wanted."""
        found = self._first(core)
        if found is None:
            return ()
        position, length = found
        told = self._told_before(core, position, length, state)
        if told is None:
            other = core.part(position + length, len(core))
            said = core.part(0, self._joined(core.part(0, position)))
            told = self._corrections.instead(said, other, state) if said.words and other.words else None
            if told is None and other.words and self._commands.moves(other.words, state):
                told = other
        denied = self._action(told, state) if told is not None else None
        return (denied,) if denied is not None and denied != self._action(wanted, state) else ()

    def _told_before(self, core: Utterance, position: int, length: int, state: Collection[str]) -> Utterance | None:
        """The command that is forbidden up to a pause or a contrast, behind which another is wanted."""
        start = position if tuple(core.words[:position]) in self._before else 0
        start = position if self._phrases.correction.cover(core.words[:position]) else start
        for end in range(position + length + 1, len(core)):
            if self._phrases.contrast.at(core.words, end) or core.breaks[end]:
                told = self._denied(core.part(start, end), position - start, length, state)
                if told is not None:
                    return told
        return None

    def _joined(self, said: Utterance) -> int:
        """Where a command ends that may be joined to what is excluded: "forward *and* not back"."""
        joint = max(self._phrases.sequence.ends(said.words), self._phrases.contrast.ends(said.words))
        return len(said) - joint

    def _action(self, told: Utterance, state: Collection[str]) -> Action | None:
        clause = self._commands.exact(told.words, state)
        return clause.action if clause is not None else None

    def _is_motion(self, words: list[str], state: Collection[str]) -> bool:
        """Whether words are a motion, exactly or nearly, or begin one: "don't turn"."""
        if self._verbs.begin(words) and self._commands.matcher.prefix(words)[1] is not None:
            return True
        clause = (self._commands.exact(words, state) or self._commands.misheard(words, state)) if words else None
        return clause is not None and self._moves(clause)

    def _is_exactly_a_motion(self, words: list[str], state: Collection[str]) -> bool:
        clause = self._commands.exact(words, state)
        return clause is not None and self._moves(clause)

    @staticmethod
    def _moves(clause: Clause) -> bool:
        if clause.reading is None:
            return False
        person = isinstance(clause.action, Custom) and not clause.action.slots  # "don't follow me", "don't come here"
        return person or clause.reading.intent.action.type in MOTIONS  # also one that cannot be: "don't go there"

    @step(Kind.NEGATION)
    def wanted(self, core: Utterance, state: Collection[str]) -> tuple[Utterance | None, str]:
        """What is still wanted of an utterance with a negation: only what follows "instead" or "but".

        "don't turn left, turn right": the first part must be a whole command and a pause or a contrast must follow,
        and what follows must be whole commands, or behind a contrast what takes the place of a part of the first:
        "don't go to the kitchen but to the bedroom". Anything else with a negation does nothing.
        """
        words = core.words
        found = self._first(core)
        if found is None:
            return core, ""
        position, length = found
        if position and (said := self._not_the_other(core, position, length, state)) is not None:
            return said, ""
        if (other := self._no_not_that(core, state)) is not None:
            return other, ""
        refused = f"negated: {' '.join(words[position : position + length])!r}"
        start = position if tuple(words[:position]) in self._before else 0
        pauses = start == position or self._behind_the_verb
        first = position in (0, self._phrases.correction.at(words, 0))
        for end in range(position + length + 1, len(words)):
            contrast = self._phrases.contrast.at(words, end)
            if not contrast and not (core.breaks[end] and (pauses or first)):
                continue
            told = core.part(start, end)
            wanted = core.part(end + contrast, len(core))
            if not wanted.words or self._negation.find(wanted.words) is not None:
                continue
            denied = self._denied(told, position - start, length, state) if contrast or pauses else None
            if denied is None:
                if contrast and (begun := self._instead_of_begun(told, position - start, length, wanted, state)):
                    return begun, ""
                if first and self._is_another(core.part(position, end), length, wanted, state):
                    return wanted, ""
                if self._is_begun_alike(self._ways_to_tell(told, position - start, length), wanted, state):
                    return wanted, ""
                continue
            if self._phrases.sequence.at(wanted.words, 0):
                continue
            if self._compounds.split(wanted, state) or self._commands.accepts(wanted.words, state):
                return wanted, ""
            if contrast and (instead := self._corrections.instead(denied, wanted, state)) is not None:
                return instead, ""
        return None, refused

    def _is_another(self, denied: Utterance, begin: int, wanted: Utterance, state: Collection[str]) -> bool:
        """Whether a whole command follows what is not meant by a part of it, "not the kitchen, go to the hall", or that
        objects to what was done, "not there, go to the hall". A word that any command has room for names no part: "not
        yet, pick up the cup"."""
        clause = self._commands.exact(wanted.words, state, breaks=wanted.breaks)
        if clause is None or not clause.accepted or clause.reading is None or isinstance(clause.action, Stop):
            return False
        if not self._commands.opens_with_a_verb(clause.reading):
            return False
        if self._phrases.objections.objection.at(denied.words, 0) == len(denied):
            return True
        named = denied.part(begin, len(denied))
        led = bool(named.words) and named.words[0] in self._articles
        if (
            not named.words
            or not self._excluding.before(denied.words[:begin])
            or (clause.reading.free_words and not led)
        ):
            return False
        return self._parts.with_part(wanted, named, state) not in (None, clause.action)

    def _no_not_that(self, core: Utterance, state: Collection[str]) -> Utterance | None:
        """An utterance without what a correction says not to have been meant: "turn left, no, not left, right" is "turn
        left, no, right", and "no, not left, right" is "right". None: it is not clear, or more is denied.

        Pauses part what is denied from the rest, and it is what was said before, or a command by itself.
        """
        words, breaks = core.words, core.breaks
        for at in range(1, len(core)):
            length = self._negation.at(words, at) if breaks[at] else 0
            corrects = self._phrases.correction.ends(words[:at]) if length else 0
            begin = at - corrects
            if not corrects or (begin and not breaks[begin]) or self._negation.find(words[:begin]) is not None:
                continue
            for end in range(at + length + 1, len(core)):
                contrast = self._phrases.contrast.at(words, end)
                if contrast or breaks[end]:
                    denied, wanted = core.part(at + length, end), core.part(end + contrast, len(core))
                    return self._without_denied(core.part(0, at), begin, denied, wanted, state)
        return None

    def _without_denied(
        self, before: Utterance, begin: int, denied: Utterance, wanted: Utterance, state: Collection[str]
    ) -> Utterance | None:
        """What was said before a denial and what is wanted behind it. A correction begins at ``begin``."""
        if not wanted.words or self._negation.find(wanted.words) is not None:
            return None
        if not begin:
            whole = all(self._commands.accepts(part.words, state) for part in (denied, wanted))
            return wanted if whole else None
        if not self._corrections.is_said(before.part(0, begin), denied, state):
            return None
        return Utterance([*before.words, *wanted.words], [*before.breaks, True, *wanted.breaks[1:]])

    def _denied(self, part: Utterance, position: int, length: int, state: Collection[str]) -> Utterance | None:
        """The command that a part with a negation forbids; None: it forbids none."""
        ways = self._ways_to_tell(part, position, length)
        return next((told for told in ways if self._commands.exact(told.words, state) is not None), None)

    def _ways_to_tell(self, part: Utterance, position: int, length: int) -> Iterator[Utterance]:
        """What a part with a negation may forbid, as a command may have it."""
        before, after = part.part(0, position), part.part(position + length, len(part))
        grammar = self._commands.matcher.grammar
        ways = [
            Utterance([*before.words, *way.words], [*before.breaks, *way.breaks]) for way in as_told(after, grammar)
        ]
        yield from ways
        yield from verb_first(ways[0], grammar)
        if (other := self._other_words.told(ways[0], (), asks=False)) is not None:
            yield other

    def _instead_of_begun(
        self, part: Utterance, position: int, length: int, wanted: Utterance, state: Collection[str]
    ) -> Utterance | None:
        """What is wanted behind a contrast, where the command before it is not whole: it goes on as the one behind
        does. "Don't pour fifty but eighty milliliters of water", "räum nicht Tisch zehn, sondern Tisch elf ab"."""
        for told in self._ways_to_tell(part, position, length):
            if (instead := self._corrections.instead_of_begun(told, wanted, state)) is not None:
                return instead
        return None

    def _is_begun_alike(self, ways: Iterable[Utterance], wanted: Utterance, state: Collection[str]) -> bool:
        """Whether a whole command is told behind the beginning of one: "don't lift bin 2, lift bin 3 for an hour"."""
        verb, prefix = wanted.words[0], self._commands.matcher.prefix
        alike = (way.words for way in ways if len(way) > 1 and way.words[0] == verb not in self._commands.not_verbs)
        return any(prefix(words)[1] is not None for words in alike) and self._commands.moves(wanted.words, state)

    def _not_the_other(self, core: Utterance, position: int, length: int, state: Collection[str]) -> Utterance | None:
        """The command before a negation behind which stands only another value of one of its slots: "turn left, not
        right", "forward and not back". None: there is more, or less, or it is no other ("turn left not now")."""
        if not self._excluding.behind(core, position, length):
            return None
        other = core.part(position + length, len(core))
        goes_on = self._phrases.sequence.at(other.words, 0)
        if not other.words or goes_on or self._negation.find(other.words) is not None:
            return None
        said = core.part(0, position)
        end = self._joined(said)
        if self._phrases.says_later(said.words[end:]):
            return None
        said = said.part(0, end)
        if length > 1 and self._commands.moves(said.words, state) and self._commands.moves(other.words, state):
            return said  # "go forward instead of turning left"; "turn left not right" names no other command
        excluded = self._corrections.instead(said, other, state)
        if excluded is None and len(other) > 1 and other.words[0] in self._articles:  # "die Tomaten statt der Gurken"
            excluded = self._corrections.instead(said, other.part(1, len(other)), state)
        if excluded is None:
            return None
        one, two = (self._commands.exact(some.words, state) for some in (said, excluded))
        if one is None or two is None or one.reading is None or two.reading is None:
            return None
        wanted, denied = one.reading, two.reading
        named, others = ({slot.label for slot in reading.slots} for reading in (wanted, denied))
        return said if wanted.intent is denied.intent and named == others else None  # "move not back" names no other
