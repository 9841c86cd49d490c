"""For whom something is done, in an order that asks for it: "tu peux *m*'apporter la pelle", "puoi portar*mi* la pala",
"necesito que *me* traigas la azada", "*mi* apri la serra?"."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.formal import Formal
from intent_engine.language.meaning.wordings.joined import begins_thing
from intent_engine.language.meaning.wordings.parts import next_begins
from intent_engine.language.utterance import Utterance

__all__ = ["ForWhomAsked"]


class ForWhomAsked:
    """Reads such an order as it is told that says for nobody, its verb as it was said.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
        infinitives: the verbs behind what asks, and what they are told as.
        asking: the verbs with which a friend is asked.
    """

    def __init__(self, phrases: Phrases, commands: Commands, infinitives: Formal, asking: Formal) -> None:
        self._grammar = commands.matcher.grammar
        wording = self._grammar.wording
        self._before = wording.for_whom_before
        self._joined = wording.joined
        pairs = (form.partition("/") for form in wording.asking)
        self._same = tuple(form.removeprefix("-") for form, _, told in pairs if form == told)
        self._phrases = phrases
        self._commands = commands
        self._infinitives = infinitives
        self._asking = asking

    def behind_what_asks(self, core: Utterance) -> Utterance:
        """What follows "puedes" or "quiero que", without those for whom it is done, where a thing follows the verb."""
        return self._without(core, lambda verb: True)

    def asked(self, core: Utterance) -> Utterance | None:
        """What a friend is asked to do for somebody. None: nobody is named before a verb that asks a friend: "me trae
        la pala" tells what somebody does."""
        said = self._without(core, self._asks)
        return said if said.words != core.words else None

    def _asks(self, verb: str) -> bool:
        return self._asking.is_one(verb) or (verb in self._commands.first_words and verb.endswith(self._same or ("/",)))

    def _without(self, core: Utterance, is_verb: Callable[[str], bool]) -> Utterance:
        said = core
        for place in reversed(list(self._places(core))):
            words, rest = core.words, core.words[place + 1 :]
            if any(core.breaks[place + 1 : place + 3]):
                continue
            if words[place] in self._before and len(rest) > 1 and is_verb(rest[0]):
                if begins_thing(rest[1:], self._grammar):
                    said = said.cut(place, place + 1)
            elif rest and (verb := self._infinitive(words[place])) and begins_thing(rest, self._grammar):
                said = said.with_other(place, place + 1, Utterance.in_one_breath([verb]))
        return said

    def _infinitive(self, word: str) -> str:
        """The infinitive with which somebody is written together; empty: none is."""
        for joined in self._joined:
            bare = word.removesuffix(joined)
            verbs: Sequence[str] = (bare, f"{bare}e") if bare != word else ()  # "portarmi" is of "portare"
            for verb in verbs:
                if self._infinitives.is_one(verb):
                    return verb
        return ""

    def _places(self, core: Utterance) -> Iterator[int]:
        """Where commands may begin."""
        place = 0
        while place < len(core):
            rest = core.words[place:]
            place += max(self._phrases.goes_on(rest), self._phrases.opens(rest))
            if place < len(core):
                yield place
            place = next_begins(core, place, self._phrases)
