"""For whom something is done, where a sentence itself says so behind its verb, and who asks for it says so before that
or with the infinitive: "peux-tu *nous* emmener au jardin" of "emmène-*nous* au jardin", "¿*nos* llevas al jardín?" of
"lléva*nos* al jardín"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import verbs_of, verbs_told, without_stress

__all__ = ["PronounBehind"]

_Form = tuple[list[str], str]


class PronounBehind:
    """Reads the first command of an utterance as such a sentence has it.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
    """

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        self._grammar = commands.matcher.grammar
        wording = self._grammar.wording
        self._before, self._behind, self._joined = wording.for_whom_before, wording.for_whom, wording.joined
        self._phrases = phrases
        self._commands = commands
        self._asking, self._formal = _forms(wording.asking), _forms(wording.formal)
        self._who = {form[0] for form, _ in self._asking if len(form) > 1}  # "*tu* nous emmènes"

    def asked_for(self, core: Utterance, asks: Sequence[str] = ()) -> Iterator[Utterance]:
        """What follows what asks for it, or wishes it: "nous emmener", "llevarnos", "ci portassi". The pronoun may be
        the first word, which ``asks``: "¿*nos* puedes llevar?"."""
        if not self._before.isdisjoint(asks):
            core = core.with_other(0, 0, Utterance.in_one_breath([*asks]))
        place = self._phrases.opens(core.words)
        for verb, pronoun, end in (*self._apart(core, place), *self._together(core, place)):
            for _, told in verbs_told([verb], self._grammar):
                yield from self._behind_it(core, place, end, told, pronoun)

    def asked(self, core: Utterance) -> Iterator[Utterance]:
        """What a friend is asked to do, or a stranger is told: "nos llevas", "tu nous emmènes", "llévenos"."""
        place = self._phrases.opens(core.words)
        who = [word for word in core.words[place : place + 1] if word in self._who]
        forms = [([form[-1]], told) for form, told in self._asking if form[:-1] == who and self._who.issuperset(who)]
        if bool(who) == bool(self._who):
            for verb, pronoun, end in self._apart(core, place + len(who)):
                for told in self._told(verb, forms):
                    yield from self._behind_it(core, place, end, told, pronoun)
        for verb, pronoun, end in self._together(core, place):
            for told in self._told(verb, self._formal):
                yield from self._behind_it(core, place, end, told, pronoun)

    def _apart(self, core: Utterance, place: int) -> Iterator[tuple[str, str, int]]:
        """A verb with the pronoun before it, and where it ends."""
        words, end = core.words, place + 2
        if end < len(core) and words[place] in self._before and not any(core.breaks[place + 1 : end + 1]):
            yield words[place + 1], words[place], end

    def _together(self, core: Utterance, place: int) -> Iterator[tuple[str, str, int]]:
        """A verb that the pronoun is written with, and where it ends: "portarci" is of "portare"."""
        for pronoun in self._joined if place + 1 < len(core) and not core.breaks[place + 1] else ():
            bare = core.words[place].removesuffix(pronoun)
            if bare != core.words[place]:
                yield from ((verb, pronoun, place + 1) for verb in (bare, without_stress(bare), f"{bare}e"))

    def _told(self, verb: str, forms: Sequence[_Form]) -> Iterator[str]:
        for (form, *more), told in forms:
            if not more and form.startswith("-"):
                yield from verbs_of(verb, form, told, self._grammar)
            elif not more and form == verb:
                yield told

    def _behind_it(self, core: Utterance, place: int, end: int, told: str, pronoun: str) -> Iterator[Utterance]:
        """The same with the verb as it is told, and the pronoun behind it, where a command begins so."""
        if (joined := self._with_pronoun.get(without_stress(f"{told}{pronoun}"))) is not None:
            yield core.with_other(place, end, Utterance.in_one_breath([joined]))
        elif told in self._commands.first_words:
            alike = sorted(other for other in self._behind if other[0] == pronoun[0])  # "me", "moi"
            yield from (core.with_other(place, end, Utterance.in_one_breath([told, other])) for other in alike)

    @cached_property
    def _with_pronoun(self) -> dict[str, str]:
        """Verbs of the grammar that are written with a pronoun, each by its letters without an accent."""
        verbs = self._commands.first_words if self._joined else ()
        return {without_stress(verb): verb for verb in verbs if verb.endswith(tuple(self._joined))}


def _forms(pairs: Sequence[str]) -> list[_Form]:
    return [(form.split(), told) for form, _, told in (pair.partition("/") for pair in pairs)]
