"""Lists that were corrected while they were said: "unlock drawer 3 and 4, no, 5" is drawer 3 and drawer 5, and "unlock
drawer 3 and 4, no, 4 and 5" is drawer 4 and drawer 5.

One thing takes the place of the last, as of two commands the last is corrected; a list takes the place of a list as
long, or of one thing. Where it is not clear of what, nothing is done.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from dataclasses import replace

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.corrections.correction_places import beginnings
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["CorrectedLists"]

Each = Callable[[Utterance], list[Clause]]
"""The commands of words in which nothing is corrected; empty: they are none, or no list."""


class CorrectedLists:
    """The commands that are meant at last."""

    def __init__(self, phrases: Phrases, commands: Commands, corrections: Corrections) -> None:
        self._hold = phrases.objections.hold
        self._commands = commands
        self._corrections = corrections
        self._articles = thing_words(commands.matcher.grammar.language).articles

    def each(self, part: Utterance, state: Collection[str], listed: Each) -> list[Clause]:
        """Those of a part in which a list is corrected, or takes the place of something; or the one clause that says
        what is not clear. Empty: there is nothing of the kind."""
        if not self._corrections.may_stand_in(part.words):
            return []
        if start := self._corrections.begins_anew(part, state):
            told = f"after {' '.join(part.words[:start])!r}"
            first, *others = listed(part.part(start, len(part))) or [Clause()]
            return [replace(first, reason=first.reason or told), *others] if first.reading is not None else []
        pieces = self._corrections.pieces(part)
        if len(pieces) != 2 or pieces[1][1] or not pieces[0][0].words or not pieces[1][0].words:
            return []
        (said, _), (meant, _) = pieces
        if self._commands.accepts(meant.words, state) or listed(meant):
            return []
        before = listed(said)
        if before and not before[0].accepted:
            return []
        if not before and (alone := self._commands.exact(said.words, state, breaks=said.breaks)) is not None:
            before = [alone] if alone.accepted else []
        takes_back = part.words[len(said) : len(part) - len(meant)]
        if len(before) == 1 and self._hold.at(takes_back, 0) == len(takes_back):
            return []  # "drawer 3, wait, 4 and 5": three of them, or two
        return self._corrected(before, meant, state, listed) if before else []

    def _corrected(self, said: list[Clause], meant: Utterance, state: Collection[str], listed: Each) -> list[Clause]:
        last = said[-1].reading
        if last is None:
            return []
        if len(last.slots) == 1:
            found = {tuple(clause.action for clause in one): one for one in self._as_list(last, meant, listed)}
            if found:
                first, *others = next(iter(found.values()))
                if len(found) > 1 or len(said) not in (1, len(others) + 1):
                    return [_unclear(meant)]
                return [self._corrections.told(first, list(first.reading.words if first.reading else ())), *others]
        if len(said) == 1:
            return []
        replaced = self._corrections.in_place(Utterance.in_one_breath(last.words), meant, state)
        clause = self._commands.exact(replaced.words, state, breaks=replaced.breaks) if replaced is not None else None
        if replaced is None or clause is None or not self._is_of_the_last(said, clause):
            return []
        return [*said[:-1], self._corrections.told(clause, list(replaced.words))]

    def _as_list(self, last: Reading, meant: Utterance, listed: Each) -> Iterator[list[Clause]]:
        """The commands if ``meant`` is a list of what the one slot of a command names."""
        (slot,) = last.slots
        said = Utterance.in_one_breath(last.words)
        for at in beginnings(said.words, meant.words, slot.start, self._articles):
            clauses = listed(said.with_other(at, slot.end, meant))
            if clauses and all(clause.accepted and _names_only(clause, slot.label) for clause in clauses):
                yield clauses

    def _is_of_the_last(self, said: list[Clause], clause: Clause) -> bool:
        """Whether a corrected command may stand for the last of several: it is of the same sentence, none of the
        others, and what all of them share is as it was."""
        last, new = said[-1].reading, clause.reading
        if not clause.accepted or last is None or new is None or new.sentence is not last.sentence:
            return False
        if clause.action in [one.action for one in said[:-1]]:
            return False
        old, now, first = last.values(), new.values(), said[0].reading.values() if said[0].reading else {}
        changed = {label for label in now if now[label] != old.get(label)}
        return bool(changed) and all(first.get(label) != old.get(label) for label in changed)


def _names_only(clause: Clause, label: str) -> bool:
    return clause.reading is not None and [slot.label for slot in clause.reading.slots] == [label]


def _unclear(meant: Utterance) -> Clause:
    reason = f"it is not clear what {' '.join(meant.words)!r} takes the place of; say the whole command again"
    return Clause(reason=reason)
