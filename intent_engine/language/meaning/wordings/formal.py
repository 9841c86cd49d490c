"""Commands with their verb in another form: "schalten Sie die Lampe ein" tells a stranger what "schalte die Lampe
ein" tells a friend, and so do "allumez la lampe" and "encienda la lámpara". Understood of a grammar that has no such
form."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property

from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.parts import next_begins
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import verbs_of

__all__ = ["Formal"]


class Formal:
    """Reads such commands as a grammar has them.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
        forms: the forms that it has not, each with the one that it may have: "-en sie/-e".
        tells: whether a grammar that has such a form itself says by it of which verbs.
    """

    def __init__(self, phrases: Phrases, commands: Commands, forms: Iterable[str], *, tells: bool = True) -> None:
        pairs = (pair.partition("/") for pair in forms)
        self._forms = [(form.split(), told.split()) for form, _, told in pairs]
        self._phrases = phrases
        self._commands = commands
        self._tells = tells

    @cached_property
    def _grammar_says(self) -> bool:
        """Whether the grammar has such a form itself, and so says of which verbs: "finden Sie" may only ask."""
        verbs, strict = self._commands.first_words, self._commands.matcher.strict
        for verb in verbs if self._tells else ():
            said = (Utterance.in_one_breath([verb, *form[1:]]) for form, _ in self._forms)
            if any(self._told(one, 0, verbs) and strict.walk(one.words)[1] is not None for one in said):
                return True
        return False

    def told(self, core: Utterance) -> Utterance | None:
        """What was said, without its fillers, with all verbs with which its commands begin in the form that the grammar
        has. None: none has another form."""
        verbs = self._commands.first_words
        if not self._forms or self._told_nowhere(core) or self._grammar_says:
            return None
        said, place = core, 0
        while place < len(said):
            rest = said.words[place:]
            place += max(self._phrases.goes_on(rest), self._phrases.opens(rest))
            told = self._told(said, place, verbs)
            if told is not None:
                length, verb = told
                said = said.with_other(place, place + length, Utterance.in_one_breath(verb))
            place = next_begins(said, place, self._phrases)
        return said if said.words != core.words else None

    def told_at(self, said: Utterance, place: int) -> tuple[int, Sequence[str]] | None:
        """How many words at a place are such a form, and how they are told; None: none are, or the grammar has such a
        form itself."""
        return None if self._grammar_says else self._told(said, place, self._commands.first_words)

    def forms_in(self, core: Utterance) -> set[str]:
        """The words of an utterance that are such forms by themselves."""
        return {word for word in core.words if self.is_one(word)} if self._forms else set()

    def is_one(self, word: str) -> bool:
        """Whether a word by itself is such a form."""
        return self._told(Utterance.in_one_breath([word]), 0, self._commands.first_words) is not None

    def _told_nowhere(self, core: Utterance) -> bool:
        """A quick look: whether no word could be such a form."""
        verbs = self._commands.first_words
        return not any(self._told(core, place, verbs) for place in range(len(core)))

    def _told(self, said: Utterance, place: int, verbs: Collection[str]) -> tuple[int, Sequence[str]] | None:
        """How many words from a place on are such a form, and how they are told otherwise."""
        grammar = self._commands.matcher.grammar
        for form, told in self._forms:
            words = said.words[place : place + len(form)]
            if (
                len(words) < len(form)
                or (len(form) == 1 and words[0] in verbs)
                or any(said.breaks[place + 1 : place + len(form)])
            ):
                continue
            at = next((at for at, part in enumerate(form) if part.startswith("-")), None)
            if any(part != word for other, (part, word) in enumerate(zip(form, words, strict=True)) if other != at):
                continue
            ways = [told[0]] if at is None else verbs_of(words[at], form[at], told[0], grammar)
            if (verb := next((way for way in ways if way in verbs and way != words[0]), None)) is not None:
                return len(form) + self._addressed(said, form, place), (verb, *told[1:])
        return None

    def _addressed(self, said: Utterance, form: Sequence[str], place: int) -> int:
        """Words behind a verb for whom it tells: "encienda *usted* la luz". Some forms have them already."""
        at = place + len(form)
        asked = self._commands.matcher.grammar.wording.asked
        return int(len(form) == 1 and at < len(said) and said.words[at] in asked and not said.breaks[at])
