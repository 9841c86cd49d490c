"""Questions in the words of a command: "right?" asks whether it is so, and nothing is done.

"Turn left?" asks for it, as "will you turn left?" does. How a recogniser sets its question marks tells little.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from intent_engine.actions import Stop
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Questions"]

_ASKED = re.compile(r"\?[\s!?.\"')\]]*$")
"""The end of a question."""


class Questions:
    """What asks, and what tells to do something, of the commands of a grammar."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        self._phrases = phrases
        self._commands = commands
        known, wording = thing_words(commands.matcher.grammar.language), commands.matcher.grammar.wording
        self._wonders, self._begging = wording.wonders, wording.begging
        before_things = (known.articles | known.joining) - wording.requests
        self._before_things = before_things if wording.parted else frozenset[str]()
        """Words with which an order in the infinitive begins, whose verb stands last,"""
        self._parted = wording.parted
        """and what begins such a verb that is all of one."""

    def asks(self, text: str, said: Utterance, parts: Sequence[Clause], *, spoken: bool) -> bool:
        """Whether a text is a question, and not one to do something.

        Args:
            text: what was said or typed.
            said: its words.
            parts: the commands that it would be.
            spoken: whether a recogniser wrote it.
        """
        return bool(_ASKED.search(text)) and (
            (not spoken and self._lists_only(parts) and not self._requests(said))
            or self._asks_at_last(said, parts)
            or any(map(self._asks_whether, parts))
        )

    def wonders_whether(self, said: Utterance) -> bool:
        """Whether words ask whether somebody can: "kannst du eigentlich links abbiegen", which a recogniser may write
        without its mark. Behind a pause such a word corrects: "kannst du, eigentlich lieber rechts abbiegen"."""
        found = self._wonders.find(said.words)
        if found is None or not self._phrases.requests(said.words[: found[0]]):
            return False
        return self._phrases.after_opening(said.words) >= sum(found) and True not in said.breaks[1 : found[0] + 1]

    def _requests(self, said: Utterance) -> bool:
        """Whether words ask for what follows in one breath: "could you climb a bit?", but not "can you, right?". Behind
        what begs a comma is only written: "darf ich dich bitten, dich umzudrehen?"."""
        begins = self._phrases.after_opening(said.words)
        paused = any(said.breaks[begins : begins + 1]) and not self._begging.at(said.words, 0)
        return self._phrases.requests(said.words) and not paused

    def _lists_only(self, parts: Collection[Clause]) -> bool:
        """Whether something is told to be done, and no word of it is a verb that tells it: "right", "two meters
        forward". Nor is a German infinitive, which stands behind all else: "die Tür öffnen?"."""
        told = [part for part in parts if part.accepted and part.reading is not None]
        return bool(told) and not any(map(self._tells, told))

    def _tells(self, part: Clause) -> bool:
        """Whether a command begins with the verb that tells it. A stop is heard all the same."""
        if part.reading is None or not self._commands.opens_with_a_verb(part.reading):
            return False
        first = part.reading.words[0]
        infinitive = first.endswith("n") and first.startswith(self._parted)  # "losfahren?"
        return not (infinitive or first in self._before_things) or isinstance(part.action, Stop)

    def _asks_whether(self, part: Clause) -> bool:
        """Whether a command is a question in the same words, which nothing but its mark tells: "gehen Sie zur Tür?". A
        stop is heard all the same."""
        if part.reading is None or isinstance(part.action, Stop):
            return False
        grammar, words = self._commands.matcher.grammar, part.reading.words
        asked = not grammar.wording.asked.isdisjoint(words[1:2]) and words[0] not in grammar.wording.requests
        return asked and all(slot.start > 1 for slot in part.reading.slots)  # "nimm sie?" is none

    def _asks_at_last(self, said: Utterance, parts: Sequence[Clause]) -> bool:
        """Whether what ends a question asks whether it is so: "pick up the cup, right?" is no turn to the right. It is
        a command without a verb, behind one with a verb and a pause: "can you turn left, right, left?" asks for it."""
        if len(parts) < 2 or parts[-2].reading is None or parts[-1].reading is None:
            return False
        before, last = parts[-2].reading, parts[-1].reading
        begin = len(said) - len(last.words)
        paused = tuple(said.words[begin:]) == last.words and said.breaks[begin] is True
        return paused and self._commands.opens_with_a_verb(before) and not self._commands.opens_with_a_verb(last)
