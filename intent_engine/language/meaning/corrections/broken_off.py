"""A command that was broken off behind a small word, and goes on behind a "no": "raise it by, no, by ten meters"."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.utterance import Utterance

__all__ = ["broken_off"]

_BOTH = 2


def broken_off(
    pieces: Sequence[tuple[Utterance, str]], leads: Collection[str], commands: Commands, state: Collection[str]
) -> Clause | None:
    """The one command that both pieces are, or None. Nothing was said yet that could be corrected but the small word
    with which the first ends; the second may have another in its place: "turn it to, no, by ten degrees".

    Args:
        pieces: what stands before a word of correction and behind it, as
            :meth:`~intent_engine.language.meaning.corrections.correction.Corrections.pieces` has them.
        leads: such small words.
        commands: of the grammar.
        state: of the robot.
    """
    if len(pieces) != _BOTH or pieces[1][1] or not pieces[1][0].words:
        return None
    said, meant = pieces[0][0], pieces[1][0]
    if len(said) < _BOTH or said.words[-1] not in leads or commands.accepts(meant.words, state):
        return None
    begun = said.words[:-1] if meant.words[0] in leads else said.words
    clause = commands.exact(
        [*begun, *meant.words], state, breaks=[*said.breaks[: len(begun)], False, *meant.breaks[1:]]
    )
    whole = clause is not None and clause.accepted and clause.reading is not None and not clause.reading.free_words
    return clause if whole else None
