"""Which of several sentences is the likeliest, by what models think of each, and how sure that is."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from statistics import fmean

from intent_engine.language.networks.approximate import FreeWord
from intent_engine.speech.hypotheses.evidence import FAR_AHEAD, Evidence, View
from intent_engine.speech.hypotheses.opinion import Reading
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.hypotheses.wake_words import UNADDRESSED
from intent_engine.speech.hypotheses.word_count import WORD, word_count

__all__ = ["ranked"]

UNKNOWN_WORD = 4.0
"""nats by which a word that no list has is less likely than those that are."""


def ranked(
    grammar: SpokenGrammar, views: Mapping[tuple[str, ...], Sequence[View]], language: str | None = None
) -> list[Reading]:
    """Sentences, likeliest first, each with what speaks for it.

    Several models are taken together as one that thinks what they do in the mean.

    Args:
        grammar: whose sentences.
        views: by the words of each sentence, what each model thinks of it; of as many models for every sentence.
        language: of the speech.
    """
    rows = []
    for words, seen in views.items():
        unknown = sum(isinstance(word, FreeWord) for word in words)
        if unknown and grammar.takes_as_heard(words, language):
            unknown = 0
        meaning = grammar.parse(" ".join(words), language)
        count = max(view.words for view in seen) or word_count(words)
        rank = fmean([view.value for view in seen]) - UNKNOWN_WORD * unknown + WORD * count
        addressed = meaning.stops or grammar.wake(language).addressed(words)  # a stop needs no wake word
        heard = any(view.apart == 0 for view in seen)
        rank -= grammar.unusual(meaning, language, heard=heard) + UNADDRESSED * (not addressed)
        rows.append((rank, words, seen, unknown, meaning.actions if addressed else ()))
    rows.sort(key=lambda row: (-row[0], row[1]))
    readings = []
    for place, (rank, words, seen, unknown, actions) in enumerate(rows):
        other = next((row[0] for row in rows[place + 1 :] if row[-1] != actions), -math.inf)
        telling = 1 + grammar.telling(words, language)
        gaps = [max(0.0, view.free_score - view.score) / telling for view in seen]
        evidence = Evidence(
            # As the gap is weighed.
            gap=math.expm1(fmean([math.log1p(gap) for gap in gaps])),
            margin=min(FAR_AHEAD, rank - other),
            cost=-fmean([view.score / (1 + (view.words or len(words))) for view in seen]),
            apart=fmean([view.apart for view in seen]) / telling,
            unknown=unknown,
            models=len(seen),
            alone=len(words) == 1,
        )
        readings.append(Reading(words, evidence, actions, rows[0][0] - rank))
    return readings
