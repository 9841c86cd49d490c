"""An order in the infinitive that nothing asks for: "den Ball *aufheben*"."""

from __future__ import annotations

from collections.abc import Collection

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["infinitive_alone"]

_LEAST_OF_A_VERB = 4
"""Letters behind what would be parted from it."""


def infinitive_alone(core: Utterance, commands: Commands, state: Collection[str]) -> Clause | None:
    """ "Den Ball aufheben": "kannst du den Ball aufheben" without what asks for it; None: it is none. The verb is one
    that would be parted, were it told of somebody."""
    grammar = commands.matcher.grammar
    first, last = core.words[0], core.words[-1]
    begun = any(
        last.startswith(begin) and len(last) >= len(begin) + _LEAST_OF_A_VERB for begin in grammar.wording.parted
    )
    if not begun or not last.endswith("n") or first not in thing_words(grammar.language).done_to:
        return None
    for asking in (words for words in grammar.fillers if len(words) == 2 and words[0] in grammar.wording.requests):
        breaks = [False] * len(asking) + [*core.breaks]
        clause = commands.exact([*asking, *core.words], state, breaks=breaks)
        if clause is not None and clause.accepted:
            return clause
    return None
