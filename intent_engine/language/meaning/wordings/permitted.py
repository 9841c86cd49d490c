"""What somebody tells or asks may be done, and means as an order: "you can land now", "can we start, please?"."""

from __future__ import annotations

from collections.abc import Mapping

from intent_engine.language.utterance import Utterance
from intent_engine.language.wording import Wording
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Permitted"]


class Permitted:
    """Reads it without what permits it, if a filler makes an order of it: "you can turn left" may tell anybody how a
    road goes on."""

    def __init__(self, wording: Wording) -> None:
        self._permits = _urged(wording.permits)
        self._pleads = _urged(wording.pleads)
        self._requests = wording.requests if wording.parted else frozenset[str]()
        self._asked = wording.asked

    def ordered(self, core: Utterance, said: Utterance, *, asks: bool) -> Utterance | None:
        """The order; None: it is none.

        Args:
            core: the words, without those that say nothing.
            said: all of them.
            asks: whether they are written as a question.
        """
        for permits in (self._pleads,) if asks else (self._pleads, self._permits):
            for phrase, urging in permits.items():
                length = len(phrase)
                begun = (
                    tuple(core.words[:length]) == phrase and length < len(core) and not any(core.breaks[1 : length + 1])
                )
                # "You can land *now*", "du kannst *jetzt* losfahren".
                if begun and (urging.ends(said.words) or urging.at(said.words, length)):
                    return core.part(length, len(core))
        return None

    def asks_within(self, said: Utterance, core: Utterance) -> bool:
        """Whether a friend is asked behind a thing, of a verb that stands last: "die Hefte *kannst du* binden". Of
        "die Hefte können sie binden" it may be told that they can.

        Args:
            said: all words.
            core: those that say something.
        """
        asks = {*said.words} & self._requests - {*core.words}
        return any(said.words[said.words.index(one) + 1 :][:1] != [who] for one in asks for who in self._asked)


def _urged(permits: Mapping[str, frozenset[str]]) -> dict[tuple[str, ...], PhraseSet]:
    return {
        tuple(phrase.split()): PhraseSet(tuple(one.split()) for one in urging) for phrase, urging in permits.items()
    }
