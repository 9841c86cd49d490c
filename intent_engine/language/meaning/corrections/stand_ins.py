"""Words that stand for the noun of what they correct: "lift your right hand, no, the left *one*" is about a hand. So is
an article with nothing but what tells which: "die rote Tasse, nein, die blaue"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.replacement import Replacements
from intent_engine.language.reading import SlotReading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["StandIns"]


class StandIns:
    """Puts what a command was corrected to in its place, with the noun that such a word stands for."""

    def __init__(self, commands: Commands, replacements: Replacements) -> None:
        self._commands = commands
        self._replacements = replacements
        grammar = commands.matcher.grammar
        known = thing_words(grammar.language)
        self._words = grammar.wording.standing_for
        self._articles = known.articles
        self._qualities = known.qualities
        self._binding = known.joining | known.binding | known.within

    def stands_last(self, said: Utterance, meant: Utterance) -> bool:
        """Whether a correction ends with such a word behind what tells which: "the left *one*". "Drawer one" is a
        number, and "blue one" may be a name."""
        words, number = meant.words, self._commands.matcher.is_number
        if words[-1] not in self._words or words[0] not in self._articles:
            return False
        which = [word for word in words[:-1] if word not in self._articles]
        return set(said.words).isdisjoint(which) and not any(map(number, which))

    def stands_first(self, meant: Utterance) -> bool:
        """Whether one begins with such a word, which may be none as well: "*celle* de gauche", "la *de* la"."""
        begun = [word for word in meant.words[:2] if word in self._words]
        led = meant.words[0] in self._words or meant.words[0] in self._articles
        return led and bool(begun) and not any(map(self._commands.matcher.is_number, begun))

    def lacks_noun(self, meant: Utterance) -> bool:
        """Whether one is an article and what tells which of several, and no more: "the blue"."""
        first, *others = meant.words
        return first in self._articles and bool(others) and self._qualities.issuperset(others)

    def replaced(self, said: Utterance, meant: Utterance, state: Collection[str]) -> Utterance | None:
        """``said`` with what ``meant`` is about in its place; None: it is not clear."""
        found: dict[object, Utterance] = {}
        for full in self._in_full(said.words, meant):
            words = self._replacements.replaced(said, full, state, "")
            clause = self._commands.exact(words.words, state, breaks=words.breaks) if words is not None else None
            if words is None or clause is None or not clause.accepted or clause.reading is None:
                continue
            if meant.words[-1] in self._words or self.lacks_noun(meant) or not clause.reading.free_words:
                found.setdefault(clause.action, words)
        return next(iter(found.values())) if len(found) == 1 else None

    def _in_full(self, said: list[str], meant: Utterance) -> Iterator[Utterance]:
        """All ways to say a correction with a noun that was said; or without any, where it stands before."""
        if self.lacks_noun(meant):
            for _, words in self._named(said):
                if words[-1] not in self._qualities and not self._qualities.isdisjoint(words):
                    yield meant.with_other(len(meant), len(meant), Utterance([words[-1]], [False]))
            return
        if meant.words[-1] not in self._words:
            kept = [place for place, word in enumerate(meant.words) if word not in self._words]
            while len(kept) > 1 and meant.words[kept[1]] in self._articles:
                kept = kept[1:]  # "la de la izquierda"
            yield Utterance([meant.words[place] for place in kept], [meant.breaks[place] for place in kept])
            return
        if self._articles.issuperset(meant.words[:-1]):
            return  # "no, the one": which was to follow
        for slot, words in self._named(said, listed=True):
            for noun in {words[-1], *said[slot.end : slot.end + 1]}:
                yield meant.with_other(len(meant) - 1, len(meant), Utterance([noun], [False]))

    def _named(self, said: list[str], *, listed: bool = False) -> Iterator[tuple[SlotReading, list[str]]]:
        """What free words hold in a command, or lists as well, and the words of it."""
        reading = self._commands.likeliest(said)
        for slot in reading.slots if reading is not None else ():
            words, free = list(said[slot.start : slot.end]), slot.slot.type in FREE_KINDS
            if words and (not self._binding.isdisjoint(words) if free else not listed):
                continue  # "the cup of tea": of which of both?
            if words:
                yield slot, words
