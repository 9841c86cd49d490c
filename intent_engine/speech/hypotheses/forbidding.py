"""A command as it would be said if it should not be done: "don't turn left".

In noise a "don't" is easily lost. So before a command is done, it is compared with what was perhaps said: the same,
forbidden.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from intent_engine.speech.hypotheses.dictating import begin_of
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

__all__ = ["forbidden", "said_otherwise"]

BEGINNINGS = ("don't",), ("do", "not"), ("never",)
"""How a command begins that shall not be done, as it is written. "Then we'll go" is heard of "never go", too."""
NOT_WITHIN = 3
"""First words of a command, behind any of which a "nicht" may stand: "fahr nicht ...", "dreh dich nicht ..."."""
OTHERWISE = 2
"""Other ways to say a command, of which a "don't" is looked for too."""


def forbidden(grammar: SpokenGrammar, words: Sequence[str], language: str | None = None) -> list[tuple[str, ...]]:
    """The ways to say that a command shall not be done.

    After what says nothing at its beginning ("please don't"), and in place of that; but never in place of a wake word,
    since what is not for the robot is not done anyhow. In German with a "nicht" behind its first words.

    Args:
        grammar: what the words mean.
        words: of the command.
        language: of the speech.

    Returns:
        Their words; none of what is no command, of a stop, and in languages of which that is not known.
    """
    meaning = grammar.parse(" ".join(words), language)
    if not meaning.actions or meaning.stops:
        return []
    called = grammar.wake(language).after(words)
    lead = called + grammar.lead(words[called:], language)
    if language not in (None, "en"):
        behind = grammar.wording(language).behind_verbs
        places = range(lead + 1, min(lead + 1 + NOT_WITHIN, len(words)))
        return [(*words[:at], *no, *words[at:]) for no in behind for at in places]
    begin, rest = tuple(words[:lead]), tuple(words[lead:])
    begins = {begin} if called else {(): None, begin: None}
    return [(*kept, *no, *rest) for kept in begins for no in BEGINNINGS]


def said_otherwise(
    grammar: SpokenGrammar, sentences: Sequence[tuple[str, ...]], language: str | None = None
) -> list[tuple[str, ...]]:
    """The next sentences that mean what the first means, of which a "don't" may have been said as well: those that
    begin with a verb, since nobody says "don't a mocha".

    Args:
        grammar: what the sentences mean.
        sentences: that may have been said, likeliest first; at least one.
        language: of the speech.
    """
    best, *others = sentences
    meaning, addressed = grammar.parse(" ".join(best), language), grammar.wake(language).addressed
    same = (
        one
        for one in others
        if not (begin_of(one) or grammar.means_else(one, meaning, language)) and addressed(one) == addressed(best)
    )
    in_slots = grammar.in_slots(language)
    return [one for one in islice(same, OTHERWISE) if one[grammar.lead(one, language)] not in in_slots]
