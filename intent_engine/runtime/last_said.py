"""What was last understood, for words of the next utterance that point back to it: "again", "it"."""

from __future__ import annotations

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.references import Before

__all__ = ["LastSaid"]


class LastSaid:
    """Keeps what was last carried out; whatever stops the robot leaves nothing to point back to. For one thread."""

    def __init__(self) -> None:
        self.meaning: Before = ()
        """For ``IntentEngine.parse(text, last=...)``; empty: there was nothing, or it is forgotten."""

    def take(self, meaning: Interpretation) -> None:
        """An utterance is carried out. One that is not accepted, or does nothing, changes nothing."""
        if meaning.stops:
            self.forget()
        elif meaning.status is Status.ACCEPTED and meaning.actions:
            self.meaning = meaning

    def forget(self) -> None:
        """The robot was stopped, or a new session begins."""
        self.meaning = ()
