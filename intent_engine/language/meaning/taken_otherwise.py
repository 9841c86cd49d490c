"""Other ways to take what was said: a letter as a sound said twice, what asks for doing something as its command."""

from __future__ import annotations

from collections.abc import Callable, Collection

from intent_engine.interpretation import Cause, Status
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.told import Understood
from intent_engine.language.meaning.wordings.asked_for_doing import AskedForDoing
from intent_engine.language.utterance import Utterance

__all__ = ["TakenOtherwise"]


class TakenOtherwise:
    """What was said and meant, taken otherwise where that tells more.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
        awake: what follows the wake word; None: it was not said.
        meant: what an utterance means in a state of the robot, with the text that it was said in, and whether a wake
            word is needed.
    """

    def __init__(
        self,
        phrases: Phrases,
        commands: Commands,
        awake: Callable[[Utterance], Utterance | None],
        meant: Callable[[str, Utterance, Collection[str], bool], Understood],
    ) -> None:
        self._phrases = phrases
        self._asked = AskedForDoing(phrases, commands)
        self._awake = awake
        self._meant = meant

    def by_letters(
        self,
        text: str,
        otherwise: tuple[Utterance, Understood],
        lettered: Utterance,
        state: Collection[str],
        spoken: bool,
    ) -> tuple[Utterance, Understood]:
        """What was said and meant where a letter may be a sound said twice, as in "t turn left". It is none where it
        stands in a sentence, and be it one that is refused for a number: "from rack b bay ninety"."""
        found = self._meant(text, lettered, state, spoken)
        tells = found[0].status in (Status.ACCEPTED, Status.AMBIGUOUS) or found[0].beyond_limits
        if found[0].intent is not None and otherwise[1][0].status is Status.REJECTED:
            tells = True  # "no row is called 'b bay'"
        return (lettered, found) if tells else otherwise

    def as_asked(
        self, text: str, otherwise: tuple[Utterance, Understood], state: Collection[str], spoken: bool
    ) -> tuple[Utterance, Understood]:
        """What was said and meant where an order asks for doing something; else as it was, ``otherwise``."""
        said = otherwise[0]
        woken = self._awake(said) if self._phrases.wake else said
        if woken is None and spoken:
            return otherwise
        told = self._asked.told(woken or said)
        found = self._meant(text, told, state, False) if told is not None else None
        if told is None or found is None:
            return otherwise
        better = found[0].status in (Status.ACCEPTED, Status.AMBIGUOUS)
        if not better and (found[0].intent is None or Cause.NO_COMMAND not in otherwise[1][0].causes):
            return otherwise  # "go to room 206" is a way, and no "to room 206"
        return told, found
