"""For whom something is done, written with the verb: "apágame la bomba" is "apaga la bomba"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.formal import Formal
from intent_engine.language.quantities import evaluate
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words
from intent_engine.language.words.verb_forms import without_stress

__all__ = ["Joined", "begins_thing"]

_AMOUNTS = ("distance", "angle", "duration", "speed")
_MOST_OF_AN_AMOUNT = 4


class Joined:
    """Reads such verbs as a grammar has them that says for nobody.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
        formal: its verbs as they are told to a stranger, "apágueme".
    """

    def __init__(self, phrases: Phrases, commands: Commands, formal: Formal) -> None:
        grammar = commands.matcher.grammar
        self._joined, self._short = grammar.wording.joined, grammar.wording.joined_short
        self._asked = [[word] for word in grammar.wording.asked]
        self._grammar = grammar
        self._phrases = phrases
        self._commands = commands
        self._formal = formal

    def apart(self, core: Utterance) -> Utterance | None:
        """An utterance without what is joined to the verbs with which its commands begin, before a thing with its
        article or number: "súbeme" tells to lift a person. None: there is none."""
        said, place = core, 0
        while self._joined and place < len(said) - 1:
            rest = said.words[place:]
            place += max(self._phrases.goes_on(rest), self._phrases.opens(rest))
            verb = self._verb(said.words[place]) if place < len(said) - 1 and not said.breaks[place + 1] else None
            behind = place + 1 + (said.words[place + 1 : place + 2] in self._asked)  # "tráigame usted la pala"
            if verb is not None and behind < len(said) and begins_thing(said.words[behind:], self._grammar):
                said = said.with_other(place, place + 1, Utterance.in_one_breath([verb]))
            later = range(place + 1, len(said))
            place = next((at for at in later if said.breaks[at] or self._phrases.goes_on(said.words[at:])), len(said))
        return said if said.words != core.words else None

    def for_whom(self, core: Utterance) -> bool:
        """Whether an utterance begins with such a word, and so asks for what a friend does: "me riegas la huerta"."""
        return not self._joined.isdisjoint(core.words[:1])

    def _verb(self, word: str) -> str | None:
        """The verb to which something is joined, as the grammar has it or a stranger is told it; None: none is."""
        for joined in self._joined:
            bare = word.removesuffix(joined)
            short = self._short.get(bare.removesuffix(joined[0]), ()) if bare.endswith(joined[0]) else ()
            for verb in (bare, without_stress(bare), *sorted(short)) if bare != word else ():
                if verb in self._commands.first_words or self._formal.is_one(verb):
                    return verb
        return None


def begins_thing(words: Sequence[str], grammar: Grammar) -> bool:
    """Whether words begin with a thing: its article or what points to it, or how many there are of it, and not how far
    or how long."""
    language = grammar.language
    if words[0] in thing_words(language).articles or words[0] in grammar.wording.points:
        return True
    if not is_number(words[0], language):
        return False
    ways = [list(words[:length]) for length in range(2, _MOST_OF_AN_AMOUNT + 1)]
    return all(evaluate(way, kind, language) is None for way in ways for kind in _AMOUNTS)
