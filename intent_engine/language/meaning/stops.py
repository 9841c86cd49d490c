"""Stop: heard wherever it is a command, before anything else is considered and never with anything fuzzy."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.actions import Action, Stop
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.negations.doing import verbs
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.run_on import RunOns
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import verbs_told
from intent_engine.needs import MOVING

__all__ = ["Stops"]

PROTEST = 6
"""Words of the longest sentence of the stop intent that is looked for among corrections: "hold on just a second"."""


class Stops:
    """Whether an utterance stops the robot."""

    def __init__(self, phrases: Phrases, commands: Commands, compounds: Compounds, run_ons: RunOns) -> None:
        self._phrases = phrases
        self._stop = phrases.stop
        self._commands = commands
        self._compounds = compounds
        self._run_ons = run_ons

    def may_stand_in(self, words: list[str]) -> bool:
        return self._stop.may_stand_in(words)

    @step(Kind.STOP)
    def heard(self, said: Utterance, state: Collection[str]) -> bool:
        """Whether any clause of the utterance is a command to stop.

        A clause is one that begins the utterance (after fillers, a wake word or "no"), follows a pause, or ends a
        sentence that was begun ("go forward stop"). "the bus stop", "don't stop" and "stop the music" are none; but
        while the robot moves, an utterance that *begins* with a stop word stops it whatever comes after, and so does
        one that ends with it and denies nothing: "you will hit the wall stop", or joins it to what is denied: "don't go
        to the bar and stop". To stand for a bus stop costs a word.
        """
        words = said.words
        phrases = self._phrases
        start = phrases.after_opening(words)
        if phrases.only_stops(words, start):
            return True
        if MOVING in state and self._stop.at(words, start) and not self._is_command(words, state):
            return True
        if self._corrected_after(words, start):
            return True
        denies = phrases.negation.find(words) is not None
        for position in range(start + 1, len(words)):
            if not self._stop.at(words, position):
                continue
            if MOVING in state and denies and self._joined_to_what_is_denied(words, position):
                return True
            warned = MOVING in state and not denies
            if said.breaks[position] or warned or self._clause_begins(words, start, position):
                if phrases.negated_before(words, position):
                    continue
                if self._corrected_after(words, position):
                    return True
                if not phrases.only_stops(words, position) or phrases.joined_before(words, position):
                    continue
                # "go to the bus, stop": where there is a bus as well as a bus stop, the pause tells which.
                parted = said.breaks[position] and self._commands.accepts(words[start:position], state)
                if parted or not self._is_command(words, state):
                    return True
        return False

    def _joined_to_what_is_denied(self, words: list[str], position: int) -> bool:
        """Whether only stops follow from here on, behind a joint: what they are joined to may be denied alone."""
        phrases = self._phrases
        joined = phrases.joined_before(words, position) and phrases.only_stops(words, position)
        return joined and not phrases.negated_before(words, position)

    @step(Kind.STOP)
    def behind_what_is_denied(self, core: Utterance, denied: Collection[Action], *, begins: bool) -> bool:
        """Whether a clause of an utterance that denies something begins with a stop, or is only to hold, whatever comes
        after: "don't turn left and stop there and wait", "don't go to the bar, and wait". That all of it is denied may
        be meant as well; of a robot that moves, a stop that was not meant costs a word.

        It ``begins`` with its negation, or a command is ``denied``: "she does not work and stop signs are red" is talk.
        No stop is denied itself: "halte nicht an und warte" goes on.
        """
        words, phrases = core.words, self._phrases
        if not (begins or denied) or any(isinstance(action, Stop) for action in denied):
            return False
        for position in range(1, len(words)):
            stops = self._stop.at(words, position)
            if stops and phrases.negated_before(words, position):
                return False  # "don't stop and wait"
            joined = phrases.joined_before(words, position) or phrases.contrast.ends(words[:position])
            if not (joined or core.breaks[position]) or phrases.negated_before(words, position):
                continue
            if stops or phrases.objections.only_hold(words[position:]):
                return phrases.negation.find(words[:position]) is not None
        return False

    def beside(self, said: Utterance, core: Utterance, state: Collection[str]) -> bool:
        """Whether a stop stands beside what is not done: a number in two pieces, or what was taken back."""
        return self.in_a_sentence(core) or (self._stop.may_stand_in(said.words) and self.between(said, state))

    def left_out(self, core: Utterance) -> Utterance | None:
        """An utterance without the stops with which it begins or ends; None: nothing is left, or nothing left out."""
        start, end = self._stop.after(core.words, 0), len(core)
        while length := self._stop.ends(core.words[start:end]):
            end -= length
        rest = core.part(start, end)
        return rest if 0 < len(rest) < len(core) else None

    @step(Kind.STOP)
    def by_sound(self, said: Utterance) -> bool:
        """Whether an utterance is nothing but stops, some of them written by their sound: "break"."""
        return self._phrases.only_stops_by_sound(said.words)

    @step(Kind.STOP)
    def in_protest(self, core: Utterance, state: Collection[str]) -> bool:
        """ "No, wait!", "wait wait": nothing but words that take something back, and some of them are a sentence of the
        stop intent. While the robot moves, twice no is enough: "no no no!"."""
        words, correction = core.words, self._phrases.correction
        position = protests = 0
        stops = False
        while position < len(words):
            ends = range(min(position + PROTEST, len(words)), position, -1)
            stop = next((end for end in ends if self.is_sentence(words[position:end])), None)
            taken_back = correction.at(words, position)
            if stop is None and not taken_back:
                return False
            stops = stops or stop is not None or any(map(self.is_sentence, _ends(words, position, taken_back)))
            protests += max(taken_back, 1)
            position = max(stop or 0, position + taken_back)
        return stops or (MOVING in state and protests > 1)

    @step(Kind.STOP)
    def in_objection(self, said: Utterance, core: Utterance) -> bool:
        """ "No!", "not that": nothing but that something is not meant. Of a robot that moves that is what it does."""
        return self._phrases.objections.only_objects(said, core)

    @step(Kind.STOP)
    def in_denial(self, core: Utterance) -> bool:
        """ "Don't!", "no, cut it out": nothing but that something is not to be done, whatever it is. Of a robot that
        moves that is what it does."""
        words = core.words
        kinds = (self._phrases.cancel, self._phrases.correction)
        reached: dict[int, bool] = {0: False}
        """Words used up by such phrases -> whether one of them takes back; "no do not do that" is read in two ways."""
        for position in range(len(words)):
            if position not in reached:
                continue
            for cancels, phrases in zip((True, False), kinds, strict=True):
                for length in phrases.lengths_at(words, position):
                    end = position + length
                    reached[end] = reached.get(end, False) or reached[position] or cancels
        return reached.get(len(words), False)

    @step(Kind.STOP)
    def between(self, said: Utterance, state: Collection[str]) -> bool:
        """ "stop turn left", "turn left stop turn right": written without their pauses, commands around a stop."""
        words = said.words
        if self._stop.find(words) is None:
            return False
        begins = [self._phrases.after_opening(words), 0]
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

    def in_a_sentence(self, core: Utterance) -> bool:
        """ "go forward for two seconds, wait a minute": a command, and then a sentence of the stop intent.

        The words of those sentences are more than stop words, and begin like corrections: nothing is corrected.
        """
        words = core.words
        phrases = self._phrases
        for position in range(1, len(words)):
            if not self.is_sentence(words[position:]):
                continue
            apart = core.breaks[position] or self._clause_begins(words, 0, position)
            if apart and not phrases.negated_before(words, position) and not phrases.joined_before(words, position):
                return True
        return False

    @step(Kind.STOP)
    def of_doing(self, core: Utterance) -> bool:
        """Whether a robot is told to stop what is a command of its own: "stop stirring", "stop chopping the onions";
        also after a pause or behind a command: "sit down and stop dancing".

        What is to be ended need not be said in full, only as a command begins. Commands may follow: "stop
        stirring, open the oven".
        """
        words, phrases = core.words, self._phrases
        start = phrases.after_opening(words)
        if self._doing_ended(words, start) or self._commands_follow(core):
            return True
        for position in range(start + 1, len(words)):
            if not self._stop.at(words, position) or phrases.negated_before(words, position):
                continue
            ended = self._doing_ended(words, position)
            if ended and self._only_commands(core.part(position, len(core)), ()):
                continue  # "open the oven and stop filming", where a sentence says that
            if ended and (core.breaks[position] or self._besides(words, start, position, ended)):
                return True
        return False

    def _commands_follow(self, core: Utterance) -> bool:
        """Whether what is ended stands first, and nothing but commands behind it."""
        for place in range(1, len(core) - 1):
            joint = self._phrases.sequence.at(core.words, place)
            if not (core.breaks[place] or joint) or place + joint >= len(core):
                continue
            first, rest = core.words[:place], core.part(place + joint, len(core))
            ended = self._doing_ended(first, self._phrases.after_opening(first))
            if ended and not self._commands.moves(first, ()) and self._only_commands(rest, ()):
                return True
        return False

    def _besides(self, words: list[str], start: int, position: int, ended: frozenset[str]) -> bool:
        """Whether what is ended at a place is ended besides a command before it, and at once: "sit down and stop
        dancing". Of "dance for a minute and stop dancing" and "turn left and stop rolling" it is how that ends; with
        what is denied it may be denied itself, and "and then" ends it later."""
        phrases = self._phrases
        joint = phrases.sequence.ends(words[start:position])
        before = words[start : position - joint]
        if not joint or phrases.says_later(words[position - joint : position]):
            return False
        acting = self._compounds.ends.acting.difference(before)
        if phrases.negation.find(before) is not None or ended.isdisjoint(acting):
            return False
        return bool(before) and self._clause_begins(words, start, position - joint)

    def _doing_ended(self, words: list[str], start: int) -> frozenset[str]:
        """The verbs with which a command of the grammar begins that stop words at a place are to end; empty: none."""
        matcher = self._commands.matcher
        while lengths := self._stop.lengths_at(words, start):
            for length in lengths:
                doing, *rest = after = words[start + length :] or [""]
                told = [[verb, *rest] for verb in verbs(doing, matcher.grammar.language)]
                told += [[verb, *after[said:]] for said, verb in verbs_told(after, matcher.grammar)]
                begun = (one for one in told if one[0] in self._commands.doing_begins)
                if ended := frozenset(one[0] for one in begun if matcher.prefix(one)[1] is not None):
                    return ended
            start += lengths[0]
        return frozenset()

    def is_sentence(self, words: list[str]) -> bool:
        """Whether words are a sentence of the stop intent."""
        readings = self._commands.matcher.read(words)
        return any(reading.intent.action.type == "stop" and not reading.problem for reading in readings)

    def _is_command(self, words: list[str], state: Collection[str]) -> bool:
        """Whether the words are a sentence that could be meant: "go to the bus stop", where there is such a place. What
        is said around it is not looked at ("please go to the bus stop now"); what is said within it would be: "go to
        the bus please stop"."""
        fillers = self._phrases.fillers
        end = len(words)
        while end and (behind := fillers.ends(words[:end])):
            end -= behind
        start = min(self._phrases.after_opening(words), end)
        for some in (words, words[start:end]):
            clause = self._commands.exact(some, state) if some else None
            if clause is not None and (clause.accepted or clause.ambiguous):
                return True
        return False

    def _clause_begins(self, words: list[str], start: int, position: int) -> bool:
        """Whether what stands before could be a command by itself, so that a new clause can begin here."""
        phrases = self._phrases
        before = phrases.without_fillers(Utterance(words[start:position], [False] * (position - start))).words
        if not before:
            return True
        correction = phrases.correction.ends(before)
        if correction:
            before = before[: len(before) - correction]
        if self._stop.may_stand_in(before) and phrases.only_stops(before, 0):
            return True
        count, reached = self._commands.matcher.prefix(before)
        return reached is not None and count > 0

    def _corrected_after(self, words: list[str], position: int) -> bool:
        """Whether a stop phrase stands here and a correction or cancellation ("do not") after it.

        "stop, no, go forward", "stop don't move": nothing said in the same breath takes a stop back. A negation alone
        does: "halt nicht an".
        """
        length = self._stop.at(words, position)
        after = position + length
        return length > 0 and any(
            phrases.at(words, after) for phrases in (self._phrases.correction, self._phrases.cancel)
        )

    def _only_commands(self, part: Utterance, state: Collection[str]) -> bool:
        """Whether a part between stop words is commands, or only fillers, and so no talk about something else.

        A joint with which it begins may be a word of the command: "stop, next page".
        """
        phrases = self._phrases
        if begun := phrases.sequence.at(part.words, 0):
            whole = self._compounds.part(part, state)
            if whole is not None and whole.accepted:
                return True
        part = part.part(begun, len(part))
        for joint in (phrases.correction, phrases.sequence):
            part = part.part(0, len(part) - joint.ends(part.words))
        core = phrases.without_fillers(part)
        clauses = (self._compounds.part(each, state) for each in (part, core))
        known = not core.words or any(clause is not None and clause.accepted for clause in clauses)
        return known or self._compounds.split(core, state) is not None or self._run_ons.may_be(core)


def _ends(words: list[str], begin: int, length: int) -> Iterator[list[str]]:
    """The ends of so many words from there: of "no wait" also "wait"."""
    return (words[at : begin + length] for at in range(begin, begin + length))
