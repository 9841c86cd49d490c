"""A "no" with more behind it: "no, the lab", said to a robot that moves, or "no, Anna", said to somebody else."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.negations.forbidden_verbs import last_verb_first
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import verbs_told

__all__ = ["objects_to_what_is_done"]


def objects_to_what_is_done(
    phrases: Phrases, commands: Commands, said: Utterance, before: str, parse: Callable[[str], Interpretation]
) -> bool:
    """Whether it is said to the robot: "no" stands twice in one breath, or what follows is a command, or takes the
    place of a part of what was understood before.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
        said: the words.
        before: the text of what was last understood; empty: it is not known.
        parse: what a text means by itself.
    """
    core = phrases.without_fillers(said)
    begun, objections = phrases.objections.objected(core)
    if not begun or begun == len(core) or phrases.objections.thanks(said):
        return False
    negated = phrases.negation.at(core.words, 0)  # "nicht das" may be "not that", or begin "nicht das Labor reinigen"
    if 0 < negated <= begun and not any(core.breaks[1 : begun + 1]) and _is_forbidden(core.words[negated:], commands):
        return False
    if objections > 1:
        return True
    if objections:
        rest = parse(" ".join(core.words[begun:]))
        if rest.actions or rest.status is Status.AMBIGUOUS or rest.unknown_place:
            return True
    words = core.words if phrases.correction.at(core.words, 0) else [*phrases.correcting, *core.words[begun:]]
    ways = (words, phrases.objections.without_standing_for(words)) if before else ()
    corrected = (parse(f"{before}, {' '.join(words)}") for words in ways)
    return any(one.corrected and not one.stops for one in corrected)


def _is_forbidden(words: Sequence[str], commands: Commands) -> bool:
    """Whether a verb is as it is forbidden, "no *limpien* el salón", "nicht den Saal *reinigen*": that says what is
    not to be done, and not that anything else is to end."""
    grammar = commands.matcher.grammar
    told = (way.words[0] for way in last_verb_first(Utterance.in_one_breath(words), grammar))
    return not commands.first_words.isdisjoint((*(verb for _, verb in verbs_told(words, grammar)), *told))
