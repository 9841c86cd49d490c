"""Correction: "turn left no right", "go to the kitchen I mean the lab". The last word counts, where it is clear what it
replaces."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Iterator
from dataclasses import replace

from intent_engine.interpretation import Cause
from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.broken_off import broken_off
from intent_engine.language.meaning.corrections.opposed_words import OpposedWords
from intent_engine.language.meaning.corrections.replacement import Replacements
from intent_engine.language.meaning.corrections.said_with_more import SaidWithMore
from intent_engine.language.meaning.corrections.stand_ins import StandIns
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.slots.adjacent_numbers import leaves_one_of_two
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Corrections"]


_MOST_BEFORE_A_NOUN = 3


class Corrections:
    """What is meant by one command that was corrected while it was said."""

    def __init__(self, phrases: Phrases, commands: Commands, replacements: Replacements) -> None:
        self._phrases = phrases
        self._correction = phrases.correction
        self._commands = commands
        self._replacements = replacements
        self._opposites = OpposedWords(commands)
        self._stand_ins = StandIns(commands, replacements)
        self._with_more = SaidWithMore(commands, replacements, self._opposites)
        self._matcher = commands.matcher
        self._definite = thing_words(commands.matcher.grammar.language).definite
        wording = commands.matcher.grammar.wording
        self._forbidding, self._none_of, self._leads = wording.may_forbid, wording.none_of, wording.leads

    def taken_back(self, words: list[str]) -> int:
        """Length of the correction with which the words end, with nothing in its place: "go forward, no"."""
        length = self._correction.ends(words) if self._correction.may_stand_in(words) else 0
        if 0 < length < len(words) and not self._phrases.joined_before(words, len(words) - length):
            return length
        return 0

    def leans(self, part: Utterance, state: Collection[str], *, first: bool) -> bool:
        """Whether some of several commands is none by itself, since it is taken back, or takes back another: "park",
        "no, go home", of which both would be done. What begins with a verb that corrects elsewhere is one: "wait ten
        seconds". A number by itself that is taken back may be one of the command before: "two meters", "three, no,
        back"."""
        words = part.words
        if not self._correction.may_stand_in(words):
            return False
        length = 0 if first else self._correction.at(words, 0)
        begins = length > 0 and not self._begins_a_sentence(part, length)
        if not (begins or self._correction.ends(words) > 0 or (not first and self._takes_back_a_number(words))):
            return False
        return not self._commands.accepts(words, state)

    def _takes_back_a_number(self, words: list[str]) -> bool:
        end = next((place for place, word in enumerate(words) if not self._matcher.is_number(word)), 0)
        return end > 0 and self._correction.at(words, end) > 0

    def may_stand_in(self, words: list[str]) -> bool:
        return self._correction.may_stand_in(words)

    def pieces(self, part: Utterance) -> list[tuple[Utterance, str]]:
        """What stands between the words of correction, each with the "no" that it follows in one breath, if it does."""
        return list(self._split(part))

    def in_place(self, said: Utterance, meant: Utterance, state: Collection[str]) -> Utterance | None:
        """A command with the part that ``meant`` corrects replaced; None: that is not clear."""
        return self._replacements.replaced(said, meant, state, "")

    @step(Kind.CORRECTION)
    def corrected(self, part: Utterance, state: Collection[str], before: str = "") -> Clause | None:
        """The command that is meant at last; None if nothing is corrected or it is not clear what.

        Where no sentence has its "the", names are understood without, as in a command that is not corrected.

        ``before`` names an intent whose command the part goes on from: "to the bedroom, no, to the office".
        """
        found = self._corrected(part, state, before)
        if found is not None or self._definite.isdisjoint(part.words) or not self._correction.may_stand_in(part.words):
            return found
        pieces = list(self._split(part))
        if pieces and pieces[-1][0].words[-1:] and pieces[-1][0].words[-1] in self._definite:
            return None  # "to the kitchen, no, the", "no, the other way the": what was to follow was not said
        less = _without(part, self._definite)
        bare = self._corrected(less, state, before)
        if bare is None or not bare.accepted or bare.reading is None:
            return None
        words = bare.reading.words
        whole = tuple(less.words[-len(words) :]) == words  # a command of its own takes the place of all
        return bare if whole or not bare.reading.free_words else None

    def _corrected(self, part: Utterance, state: Collection[str], before: str) -> Clause | None:
        pieces = list(self._split(part))
        if len(pieces) < 2:
            return self._corrected_before(part, state) if not before else None
        if not before and (whole := broken_off(pieces, self._leads, self._commands, state)) is not None:
            return self.told(whole, list(whole.reading.words if whole.reading is not None else ()))
        current = pieces[0][0]
        if (parted := self._parted(pieces[0][0], pieces[-1][0], state, before)) is not None:
            return parted
        for piece, denies in pieces[1:]:
            if not piece.words:
                continue
            replaced = self._replacements.replaced(current, piece, state, before)
            if opens := self._phrases.opens(piece.words):  # "no, well, the ball": not a thing called "well"
                less = piece.part(opens, len(piece))
                once_more = self._replacements.replaced(current, less, state, before)
                ways = [(self._matcher.read(way.words, after=before), way) for way in (replaced, once_more) if way]
                replaced = min(ways, key=lambda way: way[0][0].free_words if way[0] else 0, default=(None, None))[1]
            stands = self._stand_ins.stands_last(current, piece)
            if not before and (stands or (replaced is None and self._stand_ins.stands_first(piece))):
                replaced = self._stand_ins.replaced(current, piece, state)
            else:
                full = None
                if not before and self._stand_ins.lacks_noun(piece):
                    full = self._stand_ins.replaced(current, piece, state)
                replaced = full or replaced or self._opposites.replaced(current, piece, state)
                if replaced is None and not before:
                    replaced = self._number_alone(current, piece, state) or self._with_more.replaced(
                        current, piece, state
                    )
            if replaced is None:
                return None
            said, meant = current.words, replaced.words
            language = self._matcher.grammar.language
            if leaves_one_of_two(said, meant, piece.words, lambda one: self._commands.readings(one, before), language):
                return None
            wanted_without = self._is_what_is_had(said, meant, piece.words) or (
                not opens
                and (self._is_a_free_thing(meant, piece.words, before) or self._is_a_unit(meant, piece.words, before))
            )
            if denies and meant == piece.words and self._is_said_again(said, meant, state):
                reason = f"'{denies}' before what was said already may forbid it; say it once"
                return Clause(reason=reason, alternatives=(" ".join(meant),), ambiguous=True)
            if meant == piece.words and self._loses_a_number(said, meant, state):
                reason = f"a number was said before {' '.join(meant)!r}; say the whole command again"
                return Clause(reason=reason, alternatives=(" ".join(meant),), ambiguous=True)
            if denies in self._none_of and wanted_without:
                either = (" ".join(meant), " ".join(said))
                reason = f"'{denies} {' '.join(piece.words)}' may correct, or say that there shall be none"
                return Clause(reason=reason, alternatives=either, ambiguous=True)
            current = replaced
        words, breaks = current.words, current.breaks
        clause = self._commands.exact(words, state, breaks=breaks)
        if before and not (clause is not None and clause.accepted):
            clause = self._commands.exact(words, state, before, breaks)
        if clause is None or not clause.accepted:
            return clause
        return self.told(clause, words)

    def _number_alone(self, said: Utterance, piece: Utterance, state: Collection[str]) -> Utterance | None:
        """A command with a number corrected that is said without its noun, be it with what stands before that, and with
        what goes on behind it: "put ten boxes, no, twelve on the shelf", "poda la hilera 14, no, la 15"; or without its
        unit, with what leads it: "for two hours, no, for three". None: it is none, or free words would be among it."""
        is_number = self._matcher.is_number
        start = next((at for at, word in enumerate(piece.words) if is_number(word)), len(piece))
        end = next((at for at in range(start, len(piece)) if not is_number(piece.words[at])), len(piece))
        if start == len(piece) or start > _MOST_BEFORE_A_NOUN or end - start == len(piece):
            return None
        more = Utterance.in_one_breath(piece.words[end:])
        whole = said.with_other(len(said), len(said), more)
        base = said if self._commands.accepts(said.words, state) else whole
        number = self._replacements.replaced(base, piece.part(start, end), state, "")
        if number is None or len(number) <= end - start or not self._commands.accepts(base.words, state):
            return None
        both = enumerate(zip(base.words, number.words, strict=False))
        noun = next((at for at, (old, new) in both if old != new), 0) - 1
        led = (base.words[max(end - start, 0) : max(end, 0)] for end in (noun, noun + 1))  # or "by ten", "by twenty"
        if noun >= len(said) - 1 or (start and piece.words[:start] not in led):
            return None  # "ten boxes to the cellar, no, the 15"
        told = number if base is whole else number.with_other(len(number), len(number), more)
        clause = self._commands.exact(told.words, state)
        reading = clause.reading if clause is not None and clause.accepted else None
        if reading is None or any(slot.slot.type in FREE_KINDS for slot in reading.slots):
            return None
        return told

    def told(self, clause: Clause, words: list[str]) -> Clause:
        """A command that was corrected to some words, with a reason that says so."""
        articles = thing_words(self._matcher.grammar.language).articles
        said = [
            word for word, after in itertools.zip_longest(words, words[1:]) if word != after or word not in articles
        ]
        return replace(clause, reason=f"corrected to {' '.join(said)!r}", causes=frozenset((Cause.CORRECTED,)))

    def _parted(self, said: Utterance, meant: Utterance, state: Collection[str], before: str) -> Clause | None:
        """Why ``said`` is no command, if that is for a pause in a name and ``meant`` only corrects a part of it:
        "release the cup, faster, no, slower". No thing is called so."""
        if True not in said.breaks[1:] or self._commands.accepts(meant.words, state):
            return None
        ways: tuple[list[bool | None], ...] = ([], said.breaks)
        plain, paused = (self._commands.exact(said.words, state, before, breaks) for breaks in ways)
        refused = plain is not None and plain.accepted and paused is not None and not paused.accepted
        return paused if refused else None

    def unclear(self, part: Utterance, state: Collection[str], are_several: Callable[[Utterance], bool]) -> list[str]:
        """What was said in the place of a part of a command, or of several, where it is not clear of which; empty: that
        is not so."""
        parts = [piece for piece, _ in self._split(part) if piece.words]
        pieces = [piece.words for piece in parts]
        if len(pieces) != 2:
            return []
        if not self._commands.accepts(pieces[0], state) and not are_several(parts[0]):
            nearly = self._commands.misheard(pieces[0], state)  # "bring two beers to table five, no, six"
            if nearly is None or not nearly.accepted:
                return []
        if any(self._commands.whole_from(part.words, len(pieces[0]))):
            return []  # "clear table three, wait two minutes and ...": what is wrong is in what follows
        return pieces[1]

    def is_said(self, said: Utterance, again: Utterance, state: Collection[str]) -> bool:
        """Whether words are a part of a command as it was said: "left" of "turn left"."""
        one = self._commands.exact(said.words, state)
        replaced = self._replacements.replaced(said, again, state, "")
        other = self._commands.exact(replaced.words, state) if replaced is not None else None
        if one is None or other is None or not one.accepted:
            return False
        return one.action == other.action

    def instead(self, denied: Utterance, meant: Utterance, state: Collection[str]) -> Utterance | None:
        """A command that is denied, with what is meant in the place of a part of it: "go to the kitchen", "to the
        bedroom". None: that is not clear, or the same, or any words would do there ("pick up the cup", "smile")."""
        replaced = self._replacements.replaced(denied, meant, state, "")
        replaced = replaced or self._opposites.replaced(denied, meant, state)
        if replaced is None and self._stand_ins.stands_last(denied, meant):  # "grab the blue cup, not the red one"
            replaced = self._stand_ins.replaced(denied, meant, state)
        if replaced is None:
            return None
        before, after = (self._commands.exact(some.words, state) for some in (denied, replaced))
        if before is None or after is None or after.reading is None or after.reading.free_words:
            return None
        return replaced if before.accepted and after.accepted and before.action != after.action else None

    def instead_of_begun(self, denied: Utterance, meant: Utterance, state: Collection[str]) -> Utterance | None:
        """The same of a command that is denied and was broken off, and whose end stands behind what is meant: "pour
        fifty", "eighty milliliters of water". None: it begins none, or it is not clear."""
        if self._commands.matcher.prefix(denied.words)[1] is None:
            return None
        replaced = self._replacements.replaced(denied, meant, state, "")
        after = self._commands.exact(replaced.words, state) if replaced is not None else None
        if after is None or after.reading is None or after.reading.free_words or not after.accepted:
            return None
        return replaced

    def _corrected_before(self, part: Utterance, state: Collection[str]) -> Clause | None:
        """ "no, turn left", "actually go back": a whole command after a word of correction replaces an earlier one.

        Not "sorry, right": one word is as likely talk. Nor, in one breath, "no turn left", which may forbid, and "wait
        a little more" where one may be told to wait.
        """
        start = self.begins_anew(part, state)
        if not start:
            return None
        clause = self._commands.exact(part.words[start:], state)
        if clause is None or not clause.accepted:
            return clause
        return replace(clause, reason=f"after {' '.join(part.words[:start])!r}")

    def begins_anew(self, part: Utterance, state: Collection[str]) -> int:
        """The word with which begins what is wanted, behind words of correction that stand first; 0: there are none, or
        they may forbid it, or be all of a command."""
        start = self._before_its_verb(part, self._correction.after(part.words, 0), state)
        forbids = self._forbidding.issuperset(part.words[:start]) and not self._pause_after(part, start)
        if not start or len(part) < start + 2 or forbids:
            return 0
        if not self._pause_after(part, start) and self._commands.moves(part.words[:start], state):
            return 0
        return start

    def _before_its_verb(self, part: Utterance, start: int, state: Collection[str]) -> int:
        """Where a command begins behind a word of correction and a pause, if it begins with words that may correct as
        well: of "no, make it blue" all but the last. Else ``start``, behind all words of correction."""
        for end in range(1, start):
            corrects = self._correction.cover(part.words[:end]) and self._pause_after(part, end)
            if corrects and self._commands.accepts(part.words[end:], state):
                return end
        return start

    def _is_said_again(self, said: list[str], meant: list[str], state: Collection[str]) -> bool:
        """Whether ``meant`` is the very command that was said, from its verb on: "go forward no go forward" corrects
        nothing, and "no go forward" may forbid."""
        one, other = self._commands.exact(said, state), self._commands.exact(meant, state)
        if one is None or other is None or one.reading is None or other.reading is None:
            return False
        same = one.action == other.action and one.reading.intent is other.reading.intent
        return other.accepted and same and self._commands.opens_with_a_verb(other.reading)

    def _loses_a_number(self, said: list[str], meant: list[str], state: Collection[str]) -> bool:
        """Whether a number was said that is in no command, or in one of the same intent, and ``meant`` is one without
        its verb: "turn ninety, no, left". Turned as far as ever, it would not be what was said."""
        number = self._matcher.is_number
        if not any(map(number, said)) or any(map(number, meant)):
            return False
        before, after = (self._commands.exact(words, state) for words in (said, meant))
        if after is None or after.reading is None or self._commands.opens_with_a_verb(after.reading):
            return False
        if before is None or not before.accepted or before.reading is None:
            return True
        return before.reading.intent is after.reading.intent

    def _is_a_free_thing(self, words: list[str], meant: list[str], before: str) -> bool:
        """Whether ``meant`` has become free words, or begins with them: "cook pasta, no cheese" is as likely without.
        Nothing tells that it excludes what was said, as one value of a list does another, and a place or a number."""
        if words == meant or self._corrects(meant):
            return False
        reading = next(iter(self._commands.readings(words, before)), None)
        free = [slot.start for slot in reading.slots if slot.slot.type in FREE_KINDS] if reading is not None else []
        return any(words[at : at + len(meant)] == meant for at in free)

    def _is_a_unit(self, words: list[str], meant: list[str], before: str) -> bool:
        """Whether ``meant`` has become a unit: "five minutes, no seconds" may be five minutes sharp."""
        reading = next(iter(self._commands.readings(words, before)), None)
        slots = [slot for slot in reading.slots if slot.slot.type in QUANTITY_KINDS] if reading is not None else []
        within = (at for slot in slots for at in range(slot.start + 1, slot.end))
        return any(words[at : at + len(meant)] == meant for at in within)

    def _is_what_is_had(self, said: list[str], words: list[str], meant: list[str]) -> bool:
        """Whether ``meant`` has become what something is to be *with*: "with milk, no sugar" is as likely without any.

        What begins with an article, a number or the "with" itself can only correct: "no, with sugar", "no the sugar".
        """
        if self._corrects(meant):
            return False
        known = thing_words(self._matcher.grammar.language)
        both = enumerate(zip(said, words, strict=False))  # less may be left than was said: "move up", no, "move"
        at = next((at for at, (old, new) in both if old != new), min(len(said), len(words)))
        while at and words[at - 1] in known.articles:
            at -= 1
        return at > 0 and words[at - 1] in known.having

    def _corrects(self, meant: list[str]) -> bool:
        """Whether words behind a "no" can only correct: such as begin with an article, a number or "with"."""
        known = thing_words(self._matcher.grammar.language)
        return meant[0] in known.articles | known.having or self._matcher.is_number(meant[0])

    def _split(self, part: Utterance) -> Iterator[tuple[Utterance, str]]:
        """What stands between the words of correction, each with the "no" that it follows in one breath, if it does."""
        start = position = 0
        denies = ""
        while position < len(part):
            length = self._correction.at(part.words, position)
            if length and position == 0 and self._begins_a_sentence(part, length):
                position = length
            elif length:
                if position == 0 and self._may_forbid(part):
                    return  # "no go to the kitchen": who knows
                if position > start or start > 0:
                    yield part.part(start, position), denies
                denies = part.words[position] if length == 1 and part.words[position] in self._forbidding else ""
                start = position = position + length
                if self._pause_after(part, start):
                    denies = ""
            else:
                position += 1
        yield part.part(start, len(part)), denies

    def _may_forbid(self, part: Utterance) -> bool:
        """Whether a part begins with one "no" or several, and goes on in one breath."""
        end = self._correction.after(part.words, 0)
        return end > 0 and self._forbidding.issuperset(part.words[:end]) and not self._pause_after(part, end)

    def _begins_a_sentence(self, part: Utterance, length: int) -> bool:
        """Whether the words of correction with which a part begins are those of a sentence that goes on in one breath:
        "wait for twenty, no, thirty seconds", "make it warmer, no, cooler"."""
        words = part.words[: length + 1]
        if len(words) == length or self._pause_after(part, length):
            return False
        count, reached = self._matcher.strict.walk(words)
        return reached is not None and count == len(words)

    def _pause_after(self, part: Utterance, position: int) -> bool:
        return position < len(part) and bool(part.breaks[position])


def _without(part: Utterance, words: Collection[str]) -> Utterance:
    """An utterance without some words; a pause before one of them stands before the next."""
    kept: list[str] = []
    breaks: list[bool | None] = []
    paused = False
    for word, pause in zip(part.words, part.breaks, strict=True):
        paused = paused or bool(pause)
        if word not in words:
            kept.append(word)
            breaks.append(paused or pause)
            paused = False
    return Utterance(kept, breaks)
