"""How sure it is that a sentence of the grammar was said: from what the model thinks of the sound, one probability.

No single number tells. A misheard command explains the sound nearly as well as the free words do, but so does a wrong
one; the wrong one has a rival that does so too, or is unlike the words that were heard.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from rapidfuzz.distance import Levenshtein

from intent_engine.language.words.likeness import sound

__all__ = ["Evidence", "View", "letters_apart"]

FAR_AHEAD = 8.0
"""nats; a margin beyond it says no more."""
LETTER = 0.6
"""nats that a letter of difference from the free words weighs beside the model's own score: the free words were heard
too, and an utterance that leaves half of them out is cheap in pieces but wrong."""
BIAS = 0.72
WEIGHTS = {"gap": -1.88, "margin": 1.7, "cost": -0.51, "apart": -0.85}
"""Logistic regression, by ``scripts/fit_confidence.py``: commands of 14 synthetic voices and coffee orders of 50 people
in quiet and in noise, and both as other speech for the other's grammar."""
BIAS_OF_SEVERAL = 2.4
WEIGHTS_OF_SEVERAL = {"gap": -2.0, "margin": 1.5, "cost": -0.75, "apart": -0.8}
"""The same for what two models think in the mean. Near what ``scripts/fit_second_opinion.py`` finds (1.83, and -2.44,
1.46, 0 and -1.1) and as good on the recordings: 340 right and 11 wrong of 473. But with those a sentence that one of
the two finds all but impossible would be sure for want of a rival, and of such the recordings have few;"""
BIAS_ALONE = 4.1
WEIGHTS_ALONE = {"gap": -0.67, "margin": 1.13, "cost": -1.37, "apart": -0.84}
"""and for a single word, beside which all single words of the grammar were looked at: 512 words by as many people, a
third of them commands, in quiet and in noise."""
UNKNOWN = -2.0
"""The same for a word that no list has. Chosen, not fitted: among the recordings such words are nearly always misheard
ones, but people have things that no list knows, and whether they were heard clearly is looked at apart."""


@dataclass(frozen=True, slots=True)
class Evidence:
    """What speaks for and against one sentence."""

    gap: float
    """nats by which the words heard freely are likelier, for each telling word of the sentence and one more; 0 if they
    are not."""
    margin: float
    """nats by which it is ahead of the next sentence that means something else."""
    cost: float
    """nats that it costs given the sound, for each of its words and one more."""
    apart: float
    """Letters by which it differs from the words heard freely, for each telling word and one more."""
    unknown: int = 0
    """Words in it that no list has."""
    models: int = 1
    """How many think so, in the mean."""
    alone: bool = False
    """Whether it is a single word."""

    @property
    def weighed(self) -> dict[str, float]:
        """What is weighed: the first nats of a gap or a margin say more than those that follow."""
        return {"gap": math.log1p(self.gap), "margin": math.log1p(self.margin), "cost": self.cost, "apart": self.apart}

    @property
    def confidence(self) -> float:
        """Probability that it was said."""
        bias, weights = BIAS, WEIGHTS
        if self.models > 1:
            bias, weights = (BIAS_ALONE, WEIGHTS_ALONE) if self.alone else (BIAS_OF_SEVERAL, WEIGHTS_OF_SEVERAL)
        value = bias + UNKNOWN * self.unknown + sum(weights[name] * amount for name, amount in self.weighed.items())
        return _probability(value) * self.share

    @property
    def share(self) -> float:
        """Of it and the next sentence that means something else, the probability that it was this one, by what several
        models heard independently of each other. Weights of one model and of single words know nothing of it."""
        return 1.0 if self.models == 1 or self.alone else _probability(self.models * self.margin)


def _probability(nats: float) -> float:
    """Of something that is likelier by so many nats than that it is not."""
    return 1.0 / (1.0 + math.exp(-nats))


@dataclass(frozen=True, slots=True)
class View:
    """What one model thinks of one sentence."""

    score: float
    """Log probability of the sentence given the sound."""
    free_score: float
    """The same of the words that were heard freely."""
    apart: float
    """Letters by which the sentence differs from those."""
    words: int = 0
    """Of the sentence, where it holds a dictated text; else 0."""

    @property
    def value(self) -> float:
        """By which sentences are compared, in nats."""
        return self.score - LETTER * self.apart


def letters_apart(words: Sequence[str], heard: Sequence[str]) -> float:
    """Letters by which a sentence differs from what was heard, half by spelling and half by sound."""
    said, freely = "".join(words), "".join(heard)
    keys, heard_keys = "".join(map(sound, words)), "".join(map(sound, heard))
    spelled = Levenshtein.distance(said, freely)
    sounded = Levenshtein.distance(keys, heard_keys) * max(len(said), 1) / max(len(keys), 1)
    return 0.55 * spelled + 0.45 * sounded
