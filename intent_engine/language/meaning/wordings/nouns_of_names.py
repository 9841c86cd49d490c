"""One of several names of a list that share their noun, said without it behind one that was named: "open the left bin
and close the right *one*", "abre la pista azul y cierra *la negra*"."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, only, readings_of, told_before
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import words_in
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["NounsOfNames"]


class NounsOfNames:
    """Puts in the noun of the name in the command before.

    Args:
        grammar: whose lists have such names.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        known = thing_words(grammar.language)
        self._articles = known.articles
        self._noun_last = bool(known.qualities)
        # Where there is such a word, what tells which stands for no thing without it: "the right" may be a side.
        self._standing_for = grammar.wording.standing_for if self._noun_last else frozenset[str]()
        self._sequence = sequence
        self._which: dict[str, dict[str, set[str]]] = {}
        """By list and by the noun that two or more of its names share: the words that tell which of them is meant."""
        for slot in grammar.slots.values():
            nouns: dict[str, set[str]] = {}
            for _, node in slot.values if slot.type == "choice" else ():
                name = self._noun_first([word for word in words_in(node) if word not in self._articles])
                if len(name) > 1:
                    nouns.setdefault(name[0], set()).add(" ".join(name[1:]))
            self._which[slot.name] = {noun: which for noun, which in nouns.items() if len(which) > 1}
        every = (nouns.items() for nouns in self._which.values())
        self._told = {(noun, which) for nouns in every for noun, some in nouns for which in some}
        self._known = sorted({which for _, which in self._told})

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with that noun; None: there is none, or it is not clear which.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        place = next(self._places(core), None)
        before = told_before(core, place[0], self._sequence, as_said) if place is not None else None
        if place is None or before is None:
            return None
        start, end, which = place
        nouns = set(self._nouns(before, which))
        told = ([*which.split(), noun] if self._noun_last else [noun, *which.split()] for noun in sorted(nouns))
        return only(as_said(core.with_other(start, end, Utterance.in_one_breath(words))) for words in told)

    def _noun_first(self, name: list[str]) -> list[str]:
        """The words of a name, its noun before the others."""
        return [*name[-1:], *name[:-1]] if self._noun_last else name

    def _places(self, core: Utterance) -> Iterator[tuple[int, int, str]]:
        """Where, behind an article, only that is said which tells one of several names: its begin and end, and what
        it is."""
        words, breaks = core.words, core.breaks
        for at in (at for at in range(2, len(words)) if self._known and words[at - 1] in self._articles):
            for which in (some for some in self._known if words[at : at + len(some.split())] == some.split()):
                end = at + len(which.split())
                after = words[end] if end < len(words) else ""
                stands = after in self._standing_for
                whole = (after, which) in self._told or (not stands and bool(self._standing_for))
                if not whole and not any(breaks[at : end + stands]):
                    yield at, end + stands, which

    def _nouns(self, before: Understood, which: str) -> Iterator[str]:
        """The nouns that names have in commands, of a list of which another name has the same and is told so."""
        for reading in readings_of(before):
            for slot in reading.slots:
                name = [word for word in reading.words[slot.start : slot.end] if word not in self._articles]
                noun, *other = self._noun_first(name) or [""]
                if " ".join(other) != which in self._which.get(slot.slot.name, {}).get(noun, ()):
                    yield noun
