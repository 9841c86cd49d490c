"""All recordings in all conditions, for one model after the other."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from intent_engine.evaluation.hearing import Listener
from intent_engine.evaluation.labels import Row
from intent_engine.evaluation.scoring import Condition, Outcome, Score, judge, score
from intent_engine.evaluation.sound import Noise, SamplesSource, load, mix, silent

__all__ = ["Trial", "scores"]


@dataclass(frozen=True)
class Trial:
    """What is done with each recording.

    Args:
        noise: to mix in; None: none.
        snrs: dB, one condition each, beside the one without added noise.
        clean: whether to hear the recordings without added noise too.
        doubt: is told of each row that is a command by its label and silence to the ear.
    """

    noise: Noise | None = None
    snrs: Sequence[float] = ()
    clean: bool = True
    doubt: Callable[[Row], object] = lambda row: None

    def conditions(self, model: str) -> list[Condition]:
        """The conditions of a model, the quietest first."""
        loud = sorted(set(self.snrs), reverse=True) if self.noise is not None else []
        return [*([Condition(model)] if self.clean else []), *(Condition(model, snr) for snr in loud)]

    def hear(self, rows: Iterable[Row], listener: Listener, model: str) -> Iterator[list[Outcome]]:
        """The outcomes of one recording after the other, one for each condition.

        Raises:
            AudioError: a recording cannot be read.
        """
        conditions = self.conditions(model)
        for row in rows:
            speech = load(row)
            if row.expected.command and silent(speech):
                self.doubt(row)
            outcomes = []
            for condition in conditions:
                sound = speech
                if condition.snr is not None and self.noise is not None:
                    sound = mix(speech, self.noise.piece(row.id, speech.size), condition.snr)
                outcomes.append(judge(row, condition, listener.hear(SamplesSource(sound))))
            yield outcomes


def scores(outcomes: Iterable[Outcome]) -> list[Score]:
    """One score for each condition, in the order in which they came first."""
    sorted_out: dict[Condition, list[Outcome]] = {}
    for outcome in outcomes:
        sorted_out.setdefault(outcome.condition, []).append(outcome)
    return [score(found) for found in sorted_out.values()]
