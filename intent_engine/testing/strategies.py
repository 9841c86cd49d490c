"""Sentences of any grammar with their known meaning, for Hypothesis."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

from hypothesis import reject
from hypothesis import strategies as st
from hypothesis.strategies import DrawFn, SearchStrategy

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.grammar_states import unknown_states
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.sampler import Piece, Sample, Sampler
from intent_engine.language.sampling.drawing import RandomChoices
from intent_engine.needs import states_of
from intent_engine.testing.noise import Noise, corrected, misheard, negated, spelled, with_fillers
from intent_engine.testing.texts import texts_of

__all__ = ["Sentence", "sentences"]


class Sentence(NamedTuple):
    """What :func:`sentences` yields."""

    text: str
    """As a person might say it, or a recogniser write it."""
    expected: Interpretation
    """What it means."""


def sentences(
    engine: IntentEngine,
    intent: str | None = None,
    *,
    noise: Noise | str | Collection[Noise | str] = (),
    state: Collection[str] = (),
    language: str | None = None,
    texts: Mapping[str, Sequence[str]] | None = None,
) -> SearchStrategy[Sentence]:
    """A strategy that yields ``(text, expected interpretation)``. A failure shrinks to the shortest sentence.

    The meaning is known because the sentence is made from it; the engine is not asked. ``expected`` compares with
    :func:`~intent_engine.testing.assert_means`, for its confidence and reason are not foretold.

    Args:
        engine: whose grammar and map are used, as they are now.
        intent: only its sentences; None: those of every intent that has templates.
        noise: what is done to them, see :class:`~intent_engine.testing.Noise`; several kinds may be combined.
            With ``negation`` the expected interpretation is a rejected one, without an action.
        state: states that the robot is in; give the same to :meth:`IntentEngine.parse`.
        language: of the grammar, where the engine has several.
        texts: slot name to what is said for it, for text slots; else they are filled with common things.

    Raises:
        ConfigError: there is nothing to say, or to correct; or no such intent, state or text slot.
        TypeError: ``engine`` is none, or another argument is not of its kind.
        ValueError: an unknown kind of noise, or a negation together with a correction.
    """
    if not isinstance(engine, IntentEngine):
        raise TypeError(f"sentences takes an IntentEngine, not {engine!r}: IntentEngine.from_files(...) makes one")
    if intent is not None and not isinstance(intent, str):
        raise TypeError(f"sentences takes the name of one intent, not {intent!r:.80}; st.one_of(...) joins several")
    if not isinstance(noise, Collection):
        raise TypeError(f"noise is a name, or several in a list ({', '.join(Noise)}), not {noise!r:.80}")
    state = states_of(state)
    if unknown := unknown_states(state, engine.states, "state"):
        raise ConfigError(unknown)
    given = (noise,) if isinstance(noise, str) else tuple(noise)
    if strange := [kind for kind in given if kind not in list(Noise)]:
        raise ValueError(f"there is no noise {strange[0]!r}; there is {', '.join(Noise)}")
    kinds = frozenset(map(Noise, given))
    if {Noise.NEGATION, Noise.CORRECTION} <= kinds:
        raise ValueError("a sentence is negated or corrected; with both, nobody knows what is meant")
    grammar = engine.matcher(language).grammar
    stops: frozenset[str] = frozenset()
    if kinds & {Noise.NEGATION, Noise.CORRECTION}:
        # "stop, don't" and "stop, no, go on" stop a robot, whatever else they mean.
        stops = frozenset(name for name, item in grammar.intents.items() if item.action.type == "stop")
        if intent in stops:
            raise ConfigError(f"intent {intent!r} stops the robot; its sentences are neither negated nor corrected")
    for kind, words in ((Noise.NEGATION, grammar.operators.negation), (Noise.CORRECTION, grammar.operators.correction)):
        if kind in kinds and not words:
            hint = f"add them to the grammar: operators: {{{kind}: [...]}}"
            raise ConfigError(f"language {grammar.language!r} has no words of {kind}; {hint}")
    said = None if texts is None else texts_of(texts, grammar)
    sampler = Sampler(grammar, engine.locations, state=state, texts=said, without=stops)
    sampler.check(intent)
    if Noise.CORRECTION in kinds:
        _check_corrections(sampler, intent)
    return _sentences(sampler, intent, kinds)


CORRECTIONS_TRIED = 500
"""Sentences after which it is told that none can be corrected; Hypothesis would only say that it found nothing."""


def _check_corrections(sampler: Sampler, intent: str | None) -> None:
    choices = RandomChoices(0)
    drawn = (sampler.attempt(choices, intent) for _ in range(CORRECTIONS_TRIED))
    if not any(sample is not None and corrected(sample, sampler, choices) is not None for sample in drawn):
        raise ConfigError(
            f"no sentence of {'the grammar' if intent is None else f'intent {intent!r}'} can be corrected so that what "
            "is meant is known: none ends with a value that can be said again by itself, and behind none can another "
            "command be said: there is none, or the sentence ends with free words, which would take it in"
        )


DRAWS_PER_WORD = 3
"""Hypothesis shrinks to the fewest draws. A word draws nothing by itself, so each is given some weight: otherwise a
long sentence of few decisions would pass for shorter than a short one with a slot more."""
_NOTHING = st.booleans()


class _Drawn:
    """Decisions that Hypothesis makes, and shrinks: towards 0, which is always the shortest."""

    def __init__(self, draw: DrawFn) -> None:
        self._draw = draw

    def below(self, count: int) -> int:
        return self._draw(st.integers(0, count - 1)) if count > 1 else 0


@st.composite
def _sentences(draw: DrawFn, sampler: Sampler, intent: str | None, kinds: frozenset[Noise]) -> Sentence:
    choices = _Drawn(draw)
    sample = _some(sampler.attempt(choices, intent))
    grammar, pieces = sampler.grammar, sample.pieces
    if Noise.CORRECTION in kinds:
        pieces, sample = _some(corrected(sample, sampler, choices))
    whole = not kinds & {Noise.NEGATION, Noise.CORRECTION}
    said: Sequence[Piece] = pieces
    if Noise.SPELLING in kinds and whole and not sampler.of_pattern(sample):
        said = misheard(said, grammar, choices)
    if Noise.NEGATION in kinds:
        said = negated(said, grammar, choices)
    if Noise.FILLERS in kinds:
        said = with_fillers(said, grammar, choices)
    for _ in range(DRAWS_PER_WORD * sum(len(piece.text.split()) for piece in said)):
        draw(_NOTHING)
    spelling = Noise.SPELLING in kinds
    text = spelled(said, choices, whole=whole) if spelling else " ".join(piece.text for piece in said)
    return Sentence(text, _expected(text, sample, negation=Noise.NEGATION in kinds))


def _some(value: Any) -> Any:
    """The value, where the decisions made one."""
    if value is None:
        reject()
    return value


def _expected(text: str, sample: Sample, *, negation: bool) -> Interpretation:
    if negation:
        return Interpretation(text, Status.REJECTED)
    return Interpretation(text, Status.ACCEPTED, sample.intent, dict(sample.slots), sample.actions, 1.0)
