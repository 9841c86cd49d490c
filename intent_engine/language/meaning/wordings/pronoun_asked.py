"""What was named, in an order that asks for it: "puedes apagar*lo*", "tu peux *l'*éteindre ?", "*lo* spegni, per
favore?" and "¿me *lo* apagas?" are told as "apágalo", "éteins-le" and "spegnilo" are."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.formal import Formal
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import without_stress

__all__ = ["PronounAsked"]

_WHO = ("tu", "vous")
"""Who is asked, where a language says so."""
_MOST_WORDS = 20
"""Words of an order that is looked at."""
_NOTHING = Utterance([], [])
"""What is said before what is wished, that would ask for it."""


class PronounAsked:
    """Reads such an order with its verb as it is told, and the pronoun behind it.

    Args:
        grammar: whose language has pronouns that are said or written with their verb.
        infinitives: the verbs behind what asks, and what they are told as.
        asking: the verbs with which a friend is asked.
    """

    def __init__(self, grammar: Grammar, infinitives: Formal, asking: Formal) -> None:
        wording = grammar.wording
        taken_up = wording.taken_up if wording.for_whom_before else {}
        self._pronouns = {pronoun: [pronoun] for found in taken_up.values() for pronoun in found}
        short = {article: sorted(found) for article, found in taken_up.items() if len(article) == 1}
        self._pronouns |= {} if wording.joined else short  # "l'éteindre" is with "le" or "la"
        self._ends = tuple(self._pronouns)
        self._whom = wording.for_whom_before | wording.joined_first
        self._joined = wording.joined
        self._before = wording.joined | wording.joined_first
        self._requests, self._kindly, self._wishing = wording.requests, wording.kindly, wording.wishing
        pairs = (form.partition("/") for form in wording.asking)
        self._same = tuple(form.removeprefix("-") for form, _, told in pairs if form == told)
        self._infinitives, self._asking = infinitives, asking

    def ways(self, core: Utterance, said: Utterance) -> Iterator[Utterance]:
        """What was said so, told.

        Args:
            core: what was said, without its fillers.
            said: all of it, also what asks for it.
        """
        kindly = self._kindly.find(said.words) is not None
        if len(core) > _MOST_WORDS:
            return
        wish = self._wishing.at(core.words, 0) if self._pronouns else 0  # "quiero que *lo* apagues"
        if 0 < wish < len(core):
            core, said = core.part(wish, len(core)), _NOTHING
        for at, word in enumerate(core.words if self._pronouns else ()):
            may_be_both = self._joined and word.endswith(self._ends) and self._is_asked(word, core, said)
            for verb, pronoun in self._together(word) if may_be_both else ():
                if told := self._told(verb):
                    yield core.with_other(at, at + 1, self._as_told(told, pronoun))
            if word not in self._pronouns or at + 1 == len(core) or any(core.breaks[at + 1 : at + 2]):
                continue
            verb, whom = core.words[at + 1], at > 0 and core.words[at - 1] in self._whom
            start = at - whom
            who = core.words[start - 1 : start] if start and core.words[start - 1] in _WHO else []
            told = self._told(verb) if self._is_asked(verb, core, said) else ""
            if not told and (kindly or (whom and bool(self._joined))):
                told = self._asked(verb, who)
            for pronoun in self._pronouns[word] if told else ():
                yield core.with_other(start - len(who), at + 2, self._as_told(told, pronoun))

    def _together(self, word: str) -> Iterator[tuple[str, str]]:
        """Infinitives that a word may be with a pronoun: "apagármelo" is of "apagar", "spegnerlo" of "spegnere"."""
        for pronoun in self._pronouns:
            bare = word.removesuffix(pronoun)
            for stem in (bare, *(bare.removesuffix(other) for other in self._before)) if bare != word else ():
                yield from ((verb, pronoun) for verb in dict.fromkeys((stem, without_stress(stem), f"{stem}e")))

    def _is_asked(self, verb: str, core: Utterance, said: Utterance) -> bool:
        """Whether a word that asks stands before a verb, with nothing between them that says more than a pronoun."""
        if said is _NOTHING:
            return True
        at = said.words.index(verb) if verb in said.words else 0
        while at > 0:
            at -= 1
            if said.words[at] in self._requests:
                return said.words[at] not in core.words
            if said.words[at] in core.words and said.words[at] not in self._whom.union(self._pronouns):
                return False
        return False

    def _told(self, infinitive: str) -> str:
        told = self._infinitives.told_at(Utterance.in_one_breath([infinitive]), 0)
        return told[1][0] if told is not None else ""

    def _asked(self, verb: str, who: Sequence[str]) -> str:
        """A verb as it is told with which a friend is asked: "tu éteins", "apagas"."""
        told = self._asking.told_at(Utterance.in_one_breath([*who, verb]), 0)
        return told[1][0] if told is not None else verb if verb.endswith(self._same or ("/",)) and not who else ""

    def _as_told(self, told: str, pronoun: str) -> Utterance:
        return Utterance.in_one_breath([f"{told}{pronoun}"] if self._joined else [told, pronoun])
