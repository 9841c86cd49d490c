"""What is doubtful about ``regex:`` and ``lark:``: sentences of a pattern that mean something else, or nothing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from intent_engine.errors import Problem
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import Grammar, Intent, Sentence, problem_at
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning import Interpreter
from intent_engine.language.networks.nearest import Nearest
from intent_engine.language.pattern.pattern_sampler import PatternSampler
from intent_engine.language.pattern.pattern_signs import unsaid_sign
from intent_engine.language.pattern.values_missed import values_missed
from intent_engine.language.sampler import Sampler
from intent_engine.language.sampling.drawing import RandomChoices

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["pattern_findings"]

DRAWN = 60
"""Sentences of a pattern that are looked at, at most."""
TALK = {"before": "yesterday somebody said {}", "behind": "{} like a bird in spring"}
"""What makes talk of a command; a pattern with ``.*`` in that place does not see it."""


def pattern_findings(grammar: Grammar, locations: LocationMap | None) -> Iterator[tuple[str, str, Problem]]:
    """What a look at random sentences of each pattern finds: level, topic and problem, as of a ``Finding``."""
    patterned = [intent for intent in grammar.intents.values() if intent.regex or intent.lark is not None]
    if not patterned:
        return
    sampler = PatternSampler(grammar, locations, Sampler(grammar, locations).spoken)
    matcher = Matcher(grammar, locations)
    interpreter = Interpreter(matcher, Nearest(matcher))
    for intent in patterned:
        for problem in values_missed(intent, grammar, locations):
            yield "warning", "pattern", problem
        read = []
        unsaid = sum(unsaid_sign(text) is not None for text in intent.regex)
        """Regexes that are told of by themselves."""
        for sentence in sampler.sentences(intent.name):
            if unsaid and sentence.text in intent.regex and unsaid_sign(sentence.text) is not None:
                continue
            texts = _texts(sampler, sentence)
            if not texts and (never := sampler.never_heard(sentence)) is not None:
                unsaid += 1
                message = f"nobody can say a pattern of {intent.name!r}: {never[0]!r} is heard as {never[1]!r}"
                hint = "write a blank where it is heard, or one that may be there: ' ?'"
                yield "warning", "pattern", problem_at(intent.place, message, hint)
            read.append({text: interpreter.interpret(text, intent.requires) for text in texts})
        found = [found for found in read if found]
        if len(found) < len(intent.regex) - unsaid + (intent.lark is not None):
            message = f"how a pattern of {intent.name!r} is said cannot be told"
            hint = "it is understood as it is; speech is not helped by it, and no sentences are sampled"
            yield "note", "pattern", problem_at(intent.place, message, hint)
        for meanings in found:
            yield from _findings(intent, meanings, grammar.operators.closed)
            yield from _ignored(intent, meanings, interpreter)


def _texts(sampler: PatternSampler, sentence: Sentence) -> list[str]:
    """Different sentences of one pattern."""
    drawn = (sampler.fitting(sentence, RandomChoices(seed)) for seed in range(DRAWN))
    return list(dict.fromkeys(" ".join(piece.text for piece in pieces) for pieces in drawn if pieces))


def _findings(
    intent: Intent, meanings: Mapping[str, Interpretation], closed: frozenset[str]
) -> Iterator[tuple[str, str, Problem]]:
    others = {
        text: meaning
        for text, meaning in meanings.items()
        if meaning.intent != intent.name or meaning.status is not Status.ACCEPTED
    }
    first: dict[Status, str] = {}
    for text, meaning in others.items():
        first.setdefault(meaning.status, text)
    if Status.AMBIGUOUS in first:
        text = first[Status.AMBIGUOUS]
        message = f"{text!r} could be a pattern of {intent.name!r} or another sentence: the robot would ask"
        hint = "let one of them need another word, or give one intent a priority"
        yield "warning", "ambiguous", problem_at(intent.place, message, hint)
    if Status.REJECTED in first:
        text = first[Status.REJECTED]
        message = f"{text!r} fits a pattern of {intent.name!r} and is refused: {others[text].reason}"
        changing = sorted(closed.intersection(text.split()))
        allowed = f"if that is meant, give its slot allow: [{', '.join(changing)}]" if changing else None
        yield "warning", "pattern", problem_at(intent.place, message, allowed)
    if Status.ACCEPTED in first:
        text = first[Status.ACCEPTED]
        message = f"{text!r} fits a pattern of {intent.name!r}, and is understood as {others[text].intent!r}"
        if len(others) == len(meanings):
            message = f"a pattern of {intent.name!r} is never understood: {message}"
            yield "warning", "shadowed", problem_at(intent.place, message, "reword one, or give a priority")
        else:
            yield "note", "overlap", problem_at(intent.place, message)


def _ignored(
    intent: Intent, meanings: Mapping[str, Interpretation], interpreter: Interpreter
) -> Iterator[tuple[str, str, Problem]]:
    """Whether a pattern takes words that change nothing of what is done, as ``re.search`` does: it acts on talk."""
    done = [(text, meaning) for text, meaning in meanings.items() if meaning.actions and meaning.intent == intent.name]
    for where, talk in TALK.items():
        for text, meaning in done:
            said = talk.format(text)
            if interpreter.interpret(said, intent.requires).actions == meaning.actions:
                message = f"a pattern of {intent.name!r} takes any words {where} it: {said!r} is done as {text!r} is"
                hint = "a pattern is compared with all that is said: leave .* out, and write what may stand there"
                yield "warning", "pattern", problem_at(intent.place, message, hint)
                break
