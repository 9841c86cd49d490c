"""Two commands of one kind with nothing but an "uh" between them: both, or the second in the place of the first? So it
is with a verb alone before the "uh", of a command that may be longer: "move, uh, turn left"."""

from __future__ import annotations

from collections.abc import Collection

from intent_engine.actions import Stop
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance

__all__ = ["Hesitations"]


class Hesitations:
    """What may have been said anew behind a hesitation: "turn left, uh, right"."""

    def __init__(self, matcher: Matcher, phrases: Phrases, compounds: Compounds) -> None:
        self._strict = matcher.strict
        self._phrases = phrases
        self._compounds = compounds

    def or_either(self, parts: list[Clause], said: Utterance, state: Collection[str]) -> list[Clause]:
        """The commands of an utterance; or the one clause that asks, where one of them may take the place of the one
        before: they do the same kind of thing, or that is a verb alone, and a hesitation but no joint stands between
        them.

        Args:
            parts: commands that were understood.
            said: all words, with the fillers.
            state: states of the robot.
        """
        hesitation = self._phrases.hesitation
        if len(parts) < 2 or not hesitation.may_stand_in(said.words):
            return parts
        for place in range(1, len(said) - 1):
            if not (length := hesitation.at(said.words, place)):
                continue
            before, after = (
                self._phrases.without_fillers(some)
                for some in (said.part(0, place), said.part(place + length, len(said)))
            )
            if self._is_joined(before, after):
                continue
            last, first = self._commands(before, state)[-1:], self._commands(after, state)[:1]
            for one, other in zip(last, first, strict=False):
                if _of_one_kind(one, other) or self._may_be_left(one, other):
                    return [_asks(one, other)]
        return parts

    def _may_be_left(self, one: Clause, other: Clause) -> bool:
        """Whether the first is a verb that more may follow, and may have been left for the second. A stop never is."""
        alone = one.reading is not None and len(one.reading.words) == 1 and not one.reading.slots
        if one.reading is None or not alone or Stop in (type(one.action), type(other.action)):
            return False
        _, reached = self._strict.walk(one.reading.words)
        return reached is not None and bool(self._strict.next_words(reached))

    def _is_joined(self, before: Utterance, after: Utterance) -> bool:
        sequence = self._phrases.sequence
        return sequence.ends(before.words) > 0 or (len(after) > 0 and sequence.at(after.words, 0) > 0)

    def _commands(self, part: Utterance, state: Collection[str]) -> list[Clause]:
        if not part.words:
            return []
        several = self._compounds.split(part, state)
        if several is None:
            one = self._compounds.part(part, state)
            several = [one] if one is not None else []
        return several if all(clause.accepted for clause in several) else []


def _of_one_kind(one: Clause, other: Clause) -> bool:
    return one.reading is not None and other.reading is not None and one.reading.intent is other.reading.intent


def _asks(one: Clause, other: Clause) -> Clause:
    assert one.reading is not None
    assert other.reading is not None
    first, second = described(one.reading), described(other.reading)
    words = " ".join(other.reading.words)
    reason = (
        f"{words!r} may be said besides what was said before, or in its place; join them with 'and', or say it again"
    )
    return Clause(one.reading, reason=reason, alternatives=(f"{first}, then {second}", second), ambiguous=True)
