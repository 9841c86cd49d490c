"""A thing that is said first and taken up with the verb: "la palette, descends-*la*", "la pala portá*mela*", "die Tür,
öffne *sie*"; or by a later verb: "ouvre la porte et ferme-*la*", or "ferme-*la*" after "ouvre la porte"."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from intent_engine.language.context.answers import with_name
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.formal import Formal
from intent_engine.language.meaning.wordings.pronoun_asked import PronounAsked
from intent_engine.language.meaning.wordings.pronouns import NameSaid
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.of_words import of_words
from intent_engine.language.words.thing_words import thing_words
from intent_engine.language.words.verb_forms import without_stress

__all__ = ["TakenUp"]

_MOST = 5
"""Words of such a thing, with its article."""


class TakenUp:
    """Reads such an order with the thing behind its verb.

    Args:
        grammar: whose language has articles with a pronoun for each.
        phrases: of the grammar.
        formal: its verbs as they are told to a stranger,
        infinitives: behind what asks,
        asking: and as a friend is asked.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases, formal: Formal, infinitives: Formal, asking: Formal) -> None:
        wording = grammar.wording
        self._pronouns = wording.taken_up
        self._before = wording.joined | wording.joined_first
        self._is_joined = bool(wording.joined)
        # Of other pronouns it is known what they stand for: "schließ sie".
        pronouns = {one for others in self._pronouns.values() for one in others}
        self._alone = pronouns if wording.joined else pronouns & thing_words(grammar.language).articles
        self._contracted = {one: to for one, (_, to) in thing_words(grammar.language).contracted.items()}
        self._sequence = phrases.sequence
        self._leads, self._of = wording.leads, of_words(grammar.language)
        self._language = grammar.language
        self._formal = formal
        self._asked = PronounAsked(grammar, infinitives, asking)

    def things(self, core: Utterance, said: Utterance, verbs: Collection[str]) -> Iterator[list[Utterance]]:
        """Orders with the thing in the place of the pronoun, by :meth:`ways` and :meth:`again`; those of one thing are
        together.

        Args:
            core: what was said, without its fillers.
            said: all of it, also what asks for it.
            verbs: words with which a command may begin.
        """
        for told in (core, *self._asked.ways(core, said)):
            yield from ([way] for way in self.ways(told, verbs))
            yield from self.again(told, verbs)

    def ways(self, core: Utterance, verbs: Collection[str]) -> Iterator[Utterance]:
        """An order with what it is about behind its verb, with each article that the pronoun stands for as well.

        Args:
            core: what was said, without its fillers.
            verbs: words with which a command may begin.
        """
        words = core.words
        pronouns = self._pronouns.get(words[0], frozenset()) if words else frozenset()
        if not pronouns or any(core.breaks[1:2]):
            return
        for at in range(2, min(len(words), _MOST + 1)):
            if any(core.breaks[2:at]) or self._sequence.at(words, at):
                return  # "la serre, la grange, ouvre-la", "la pelle et le râteau, apporte-la"
            verb, pronoun, end = self._verb(core, at, verbs)
            if pronoun in pronouns and not any(core.breaks[at + 1 : end + 1]):
                for article in (one for one, others in self._pronouns.items() if pronoun in others):
                    if article == words[0] or not self._is_joined:
                        told = [verb, article, *words[1:at], *words[end:]]
                        breaks = [core.breaks[0], *[False] * at, *core.breaks[end:]]
                        yield Utterance(told, breaks)

    def again(self, core: Utterance, verbs: Collection[str]) -> Iterator[list[Utterance]]:
        """Several orders with the thing of an earlier one in the place of the pronoun that is with the verb of a later
        one: "abre la puerta y ciérra*la*" is "abre la puerta y cierra la puerta". The ways of each thing are together:
        the first that is a command counts.

        Args:
            core: what was said, without its fillers.
            verbs: words with which a command may begin.
        """
        words = core.words
        if not self._pronouns or not self._tells(words[0], verbs):
            return
        for at in range(2, len(words)):
            joint = self._sequence.ends(words[:at])
            if not (joint or core.breaks[at]):
                continue
            verb, pronoun, end = self._verb(core, at, verbs)
            if pronoun in self._alone and self._ends(core, end) and not any(core.breaks[at + 1 : end]):
                for things in self._things(words[: at - joint], pronoun):
                    yield [core.with_other(at, end, Utterance.in_one_breath([verb, *thing])) for thing in things]
                return

    def before(
        self,
        text: str,
        core: Utterance,
        said: Utterance,
        before: Callable[[], Sequence[Clause]],
        verbs: Collection[str],
    ) -> list[NameSaid]:
        """What the commands of an earlier utterance named for which the pronoun with the verb of a text may stand:
        "ferme-la", after "ouvre la porte"; its ways are texts.

        An article at the end may be one whose name was not said any more ("ferme la"), if it is not written with the
        verb.

        Args:
            text: what was said.
            core: its words, without those that say nothing.
            said: all of its words.
            before: gives the earlier commands.
            verbs: words with which a command may begin.
        """
        found = self._before_it(text, core, before, verbs)
        for told in () if found else self._asked.ways(core, said):
            verb, *rest = told.words
            found += self._before_it(f"{verb}{' ' if self._is_joined else '-'}{' '.join(rest)}", told, before, verbs)
        return found

    def _before_it(
        self, text: str, core: Utterance, before: Callable[[], Sequence[Clause]], verbs: Collection[str]
    ) -> list[NameSaid]:
        verb, pronoun, end = self._verb(core, 0, verbs) if self._pronouns and core.words else ("", "", 0)
        if pronoun not in self._alone or any(core.breaks[1:end]):
            return []
        written = f"{verb}-{pronoun}" in text.lower()
        if not (self._is_joined or written) and (end == len(core) or not self._ends(core, end)):
            return []
        readings = (clause.reading.words for clause in before() if clause.reading is not None)
        names = (things for words in readings for things in self._things(words, pronoun))
        said = core.words[:end]
        return [
            NameSaid([with_name(text, said, " ".join((verb, *thing))).split() for thing in things], is_meant=True)
            for things in names
        ]

    def _ends(self, core: Utterance, end: int) -> bool:
        """Whether a word that may be an article is none, since no name follows: "ferme la", "pose la sur le quai"."""
        if self._is_joined or end == len(core) or core.breaks[end] or core.words[end] in self._leads:
            return True
        return self._sequence.at(core.words, end) > 0

    def _things(self, words: Sequence[str], pronoun: str) -> Iterator[list[list[str]]]:
        """What may be things for which a pronoun stands, each with its article; of each the longest first, and none
        with more behind it than whose it is, or its number: "la pompe du bassin 2", but not "la pompe à midi"."""
        for start, word in enumerate(words):
            article = self._contracted.get(word, word)
            if start and pronoun in self._pronouns.get(article, ()):
                last = min(start + _MOST, len(words))
                last = next((at for at in range(start + 2, last) if self._says_how(words, at)), last)
                yield [[article, *words[start + 1 : stop]] for stop in range(last, start + 1, -1)]

    def _says_how(self, words: Sequence[str], at: int) -> bool:
        """Whether no name goes on with a word: one with which is told where, how or how much ("la caisse *de* deux
        mètres"), or a number that counts what follows it ("la caisse *deux* mètres")."""
        word, after = words[at], words[at + 1 : at + 2]
        counts = bool(after) and is_number(after[0], self._language)
        if word in self._leads:
            return word not in self._of or counts
        return is_number(word, self._language) and not counts and bool(after) and after[0] not in self._leads

    def _verb(self, core: Utterance, at: int, verbs: Collection[str]) -> tuple[str, str, int]:
        """The verb at a place, the pronoun with it, and where it ends; no pronoun: it is none."""
        word = core.words[at]
        if not self._is_joined:
            after = core.words[at + 1] if at + 1 < len(core) else ""
            return word, after if self._tells(word, verbs) else "", at + 2
        for pronoun in {one for others in self._pronouns.values() for one in others}:
            bare = word.removesuffix(pronoun)
            ways = [bare, *(bare.removesuffix(before) for before in self._before)] if bare != word else []
            for way in (form for one in ways for form in (one, without_stress(one))):
                if self._tells(way, verbs):
                    return way, pronoun, at + 1
        return word, "", at + 1

    def _tells(self, word: str, verbs: Collection[str]) -> bool:
        return bool(word) and (word in verbs or self._formal.is_one(word))
