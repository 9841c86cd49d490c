"""Orders that ask for doing something: "would you mind locking drawer 3" is "lock drawer 3"."""

from __future__ import annotations

from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.negations.doing import verbs
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.verb_forms import told_forms_of

__all__ = ["AskedForDoing"]

_DOING = "ing"


class AskedForDoing:
    """Those of one grammar. Thread-safe."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        grammar = commands.matcher.grammar
        polite = bool(grammar.fillers)  # without any a command is what its sentences say
        self._asks_for_doing = PhraseSet(grammar.wording.asks_for_doing if polite else ())
        self._asks_to_do = PhraseSet(grammar.wording.asks_to_do if polite else ())
        operators = grammar.operators
        self._before = PhraseSet((*grammar.fillers, *grammar.wake, *operators.opener, *operators.sequence))
        self._phrases = phrases
        self._commands = commands
        self._language = grammar.language

    def told(self, said: Utterance) -> Utterance | None:
        """The same as it is told, without what asks; None: nothing is asked for so.

        What asks stands first, and a verb behind it with which a command begins. So does each verb behind an "and":
        "would you mind locking drawer 3 *and opening* drawer 4".
        """
        for asking in (self._asks_for_doing, self._asks_to_do):
            found = asking.find(said.words)
            if found is None or not self._before.cover(said.words[: found[0]]):
                continue
            start = self._phrases.fillers.after(said.words, sum(found))
            start += self._phrases.opens(said.words[start:])  # "it would be great if you could *just* lock the door"
            verb = self._doing if asking is self._asks_for_doing else self._to_do
            if verb(said, start) is None:
                continue
            told = said.part(start, len(said))
            places = [at for at in range(len(told)) if not at or self._phrases.sequence.ends(told.words[:at])]
            plain = {at: one for at in places if (one := verb(told, at)) is not None}
            return Utterance([plain.get(at, word) for at, word in enumerate(told.words)], [*told.breaks])
        return None

    def _to_do(self, said: Utterance, place: int) -> str | None:
        """The verb at a place, if a command or a stop begins with it: "go *to* the lab" asks for nothing else."""
        word = said.words[place] if place < len(said) else ""
        return word if self._begins(word) and word not in self._commands.not_verbs else None

    def _doing(self, said: Utterance, place: int) -> str | None:
        """The verb of which a word is the form that ends in "-ing", if a command or a stop begins with it."""
        word = said.words[place] if place < len(said) else ""
        if not word.endswith(_DOING):
            return None
        found = {*filter(self._begins, (*told_forms_of(word, self._language), *verbs(word, self._language)))}
        return found.pop() if len(found) == 1 else None  # of "planing" nobody knows whether "plan" or "plane"

    def _begins(self, verb: str) -> bool:
        return verb in self._commands.first_words or self._phrases.stop.at([verb], 0) == 1
