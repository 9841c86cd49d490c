"""What is corrected, and what is said with it, be it for the first time: "pan left, no, right twenty degrees"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.opposed_words import OpposedWords
from intent_engine.language.meaning.corrections.replacement import Replacements
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["SaidWithMore"]


class SaidWithMore:
    """Reads a correction of two values, of which the first takes the place of one that was said."""

    def __init__(self, commands: Commands, replacements: Replacements, opposites: OpposedWords) -> None:
        self._commands = commands
        self._replacements = replacements
        self._opposites = opposites

    def replaced(self, said: Utterance, meant: Utterance, state: Collection[str]) -> Utterance | None:
        """``said`` with the first words of ``meant`` in the place of a value, and the others in that of another, or
        behind all. None: it is no command, any words would do there, or more than one could be meant."""
        before = self._understood(said, state)
        if before is None or len(meant) < 2:
            return None
        found: dict[tuple[tuple[str, str], ...], Utterance] = {}
        for first, way in self._ways(said, meant, state):
            one, both = self._understood(first, state), self._understood(way, state)
            if one is None or both is None or not before.intent is one.intent is both.intent:
                continue
            old, new, all_ = before.values(), one.values(), both.values()
            changed = {label for label in new if old.get(label) != new[label]}
            if changed and set(new) == set(old) <= set(all_) and all(all_[label] == new[label] for label in changed):
                found.setdefault(tuple(sorted((label, str(value)) for label, value in all_.items())), way)
        return next(iter(found.values())) if len(found) == 1 else None

    def _ways(self, said: Utterance, meant: Utterance, state: Collection[str]) -> Iterator[tuple[Utterance, Utterance]]:
        """The command with the first words alone in their place, and with the others as well."""
        is_number = self._commands.matcher.is_number
        alone = next((at for at, word in enumerate(meant.words) if not is_number(word)), len(meant))
        for cut in range(alone + 1, len(meant)):  # "ten boxes on the cart, no, twelve on the shelf" may be both
            value = meant.part(0, cut)
            first = self._replacements.replaced(said, value, state, "") or self._opposites.replaced(said, value, state)
            if first is None or len(first) == cut:  # a whole command, which nothing takes the place of
                continue
            more = meant.part(cut, len(meant))
            again = self._replacements.replaced(first, more, state, "")
            if again is not None and _in_order(again.words, value.words, more.words):
                yield first, again
            yield first, first.with_other(len(first), len(first), more)

    def _understood(self, said: Utterance, state: Collection[str]) -> Reading | None:
        """How a command is read that is one as it is, without free words."""
        clause = self._commands.exact(said.words, state)
        reading = clause.reading if clause is not None and clause.accepted else None
        if reading is None or any(slot.slot.type in FREE_KINDS for slot in reading.slots):
            return None
        return reading


def _in_order(words: Sequence[str], first: Sequence[str], second: Sequence[str]) -> bool:
    """Whether some words stand among others, and some more behind them."""
    behind = f" {' '.join(words)} ".partition(f" {' '.join(first)} ")[2]
    return f" {' '.join(second)} " in f" {behind}"
