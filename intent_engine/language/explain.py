"""Why a text was understood as it was: every step of the :class:`Interpreter`, told by the code that takes it.

A :class:`Witness` watches the steps that the rules of meaning mark (:mod:`intent_engine.language.meaning.steps`): what
they are given and what they answer becomes the explanation. Nothing is decided here, so an explanation cannot differ
from a parse; and a parse that nobody wants explained has no watcher, so it costs nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from typing import Any

from intent_engine.actions import Action
from intent_engine.interpretation import Interpretation
from intent_engine.language.explanation import Candidate, Explanation, Noticed, Step, Word
from intent_engine.language.meaning import MAX_CHARACTERS, Clause, Interpreter
from intent_engine.language.meaning.command import forbidden
from intent_engine.language.meaning.dictation import Dictated
from intent_engine.language.meaning.steps import Kind
from intent_engine.language.meaning.wordings.pronouns import NameSaid
from intent_engine.language.normalize import tokenize
from intent_engine.language.reading import Reading
from intent_engine.language.slots.sources import candidate, sources
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Witness"]

MAX_STEPS = 12
"""Steps told inside another; a correction can be tried in many ways, and nobody reads them all."""
NO_SPLIT = "no way to split it into whole commands"


class _Open:
    """A step that is being taken."""

    def __init__(self) -> None:
        self.candidates: list[Candidate] = []
        self.steps: list[Step] = []

    def close(self, told: tuple[str, str], kind: Kind) -> Step:
        inner = self.steps[:MAX_STEPS]
        name = Kind.CORRECTION if kind is Kind.REPLACEMENT else kind  # what is replaced is the correction
        return Step(name.value, *told, tuple(self.candidates), tuple(inner), len(self.steps) - len(inner))

    def add(self, step: Step) -> None:
        """Put a step in, unless it says nothing new: the same is asked with and without fillers."""
        before = self.steps[-1] if self.steps else None
        again = step.name == Kind.REFUSAL and before is not None and before.outcome == step.outcome
        if step not in self.steps and not again:
            self.steps.append(step)


class Witness:
    """An interpreter that remembers how it came to its last interpretation. Not thread-safe; made for one text."""

    def __init__(self, interpreter: Interpreter) -> None:
        self.matcher = interpreter.matcher
        self._interpreter = interpreter.watched(self._watch)
        self._open: list[_Open] = [_Open()]
        self._clauses: tuple[Clause, ...] = ()
        self._found: Interpretation | None = None

    def interpret(
        self, text: str, state: Collection[str] = (), *, spoken: bool = False, heard: bool = False
    ) -> Interpretation:
        """The meaning of a text; see :meth:`Interpreter.interpret`."""
        self._found, self._clauses = self._interpreter.understand(text, state, spoken=spoken, heard=heard)
        return self._found

    def denied_part(self, text: str, before: str, state: Collection[str] = ()) -> tuple[Action, ...]:
        """See :meth:`Interpreter.denied_part`."""
        return self._interpreter.denied_part(text, before, state)

    def objection(self, text: str, before: str, state: Collection[str] = ()) -> Interpretation | None:
        """See :meth:`Interpreter.objection`."""
        return self._interpreter.objection(text, before, state)

    def named_before(self, text: str, before: str, state: Collection[str] = ()) -> list[NameSaid]:
        """See :meth:`Interpreter.named_before`."""
        return self._interpreter.named_before(text, before, state)

    def explanation(self, found: Interpretation) -> Explanation:
        """How the last text came to be ``found``: what this interpreter gave, with "it" and "again" put in."""
        before = self._found
        if before is not None and before != found:
            outcome = found.reason if found.status is not before.status else "what it points back to is put in"
            self._open[0].steps.append(Step("pointing back", found.text, outcome))
        tokens = tokenize(found.text[:MAX_CHARACTERS], self.matcher.grammar.language)
        words = tuple(Word(token.word, found.text[token.start : token.end], token.breaks) for token in tokens)
        return Explanation(
            self.matcher.grammar.language,
            words,
            tuple(self._noticed(Utterance([token.word for token in tokens], [token.breaks for token in tokens]))),
            tuple(self._open[0].steps),
            tuple(sources(clause, self.matcher.locations) for clause in self._clauses),
            found,
        )

    def _noticed(self, said: Utterance) -> list[Noticed]:
        words = said.words
        found = []
        for kind, phrases in self._phrase_sets().items():
            position = 0
            while position < len(words):
                length = phrases.at(words, position)
                if length and kind == "filler" and not self._interpreter.phrases.says_nothing(said, position, length):
                    length = 0
                if length:
                    found.append(Noticed(kind, " ".join(words[position : position + length]), position))
                position += max(length, 1)
        return sorted(found, key=lambda one: one.start)

    def _phrase_sets(self) -> Mapping[str, PhraseSet]:
        phrases = self._interpreter.phrases
        return {
            "filler": phrases.fillers,
            "wake word": phrases.wake,
            "stop": phrases.stop,
            "negation": phrases.negation,
            "correction": phrases.correction,
            "cancellation": phrases.cancel,
            "joint": phrases.sequence,
            "contrast": phrases.contrast,
        }

    # -- watching ---------------------------------------------------------------------------------------------

    def _watch(self, kind: Kind, method: Callable[..., Any]) -> Callable[..., Any]:
        return self._judging(method) if kind is Kind.CHOICE else self._telling(kind, method, OUTCOMES[kind])

    def _telling(
        self, kind: Kind, method: Callable[..., Any], outcome: Callable[[Any], str | None]
    ) -> Callable[..., Any]:
        def telling(*given: Any, **options: Any) -> Any:
            step = _Open()
            self._open.append(step)
            try:
                answer = method(*given, **options)
            finally:
                self._open.pop()
            told = outcome(answer)
            if told is not None and (step.steps or told != NO_SPLIT):
                self._open[-1].add(step.close((_subject(kind, given), told), kind))
            return answer

        return telling

    def _judging(self, method: Callable[..., Clause]) -> Callable[[list[Reading], Collection[str]], Clause]:
        def judging(readings: list[Reading], state: Collection[str]) -> Clause:
            clause = method(readings, state)
            self._open[-1].candidates.extend(
                candidate(reading, _why_refused(reading, clause, state)) for reading in readings
            )
            return clause

        return judging


def _why_refused(reading: Reading, clause: Clause, state: Collection[str]) -> str:
    if reading is clause.reading:
        return "" if clause.accepted else clause.reason
    why = reading.problem or forbidden(reading, state)
    if why or clause.reading is None:
        return why or "another was nearer"
    best = clause.reading
    if reading.intent.priority != best.intent.priority:
        return f"intent {best.intent.name!r} has a higher priority"
    if reading.free_words != best.free_words:
        return "more of its words fall into free text"
    if reading.alikes != best.alikes:
        return "more of its words had to be replaced by others that sound alike"
    if reading.score != best.score:
        return "another is nearer to what was said"
    return "as good as the one above it" if clause.ambiguous else "it means the same"


# -- what a step is told as -----------------------------------------------------------------------------------


def _words_of(part: Utterance | list[str]) -> str:
    return " ".join(part.words if isinstance(part, Utterance) else part)


def _subject(kind: Kind, given: tuple[Any, ...]) -> str:
    """What a step was tried on."""
    match kind:
        case Kind.REFUSAL | Kind.DICTATION:
            return str(given[0])
        case Kind.OTHERWISE:
            return _words_of(given[1])
        case Kind.REPLACEMENT:
            return f"{_words_of(given[0])} / {_words_of(given[1])}"
    return _words_of(given[0])


def _clause(none: str) -> Callable[[Clause | None], str]:
    def outcome(answer: Clause | None) -> str:
        if answer is None:
            return none
        if answer.accepted:
            intent = answer.reading.intent.name if answer.reading is not None else ""
            return f"understood as {intent}" + (f" ({answer.reason})" if answer.reason else "")
        return answer.reason

    return outcome


def _stop(answer: bool) -> str:
    return "a command to stop" if answer else "no command to stop"


def _wake(answer: Utterance | None) -> str:
    return "not said" if answer is None else f"said; then {_words_of(answer)!r}"


def _dictation(answer: Dictated | None) -> str | None:
    return None if answer is None else f"dictated: {answer.text!r}"


def _numbers(answer: bool) -> str | None:
    return "one number was begun twice" if answer else None


def _replacement(answer: Utterance | None) -> str:
    return "it is not clear what is corrected" if answer is None else f"what is meant: {_words_of(answer)!r}"


def _negation(answer: tuple[Utterance | None, str]) -> str:
    wanted, reason = answer
    return reason if wanted is None else f"only this is wanted: {_words_of(wanted)!r}"


def _compound(answer: list[Clause] | None) -> str:
    if answer is None:
        return NO_SPLIT
    if len(answer) == 1 and answer[0].ambiguous:
        return answer[0].reason
    return f"{len(answer)} commands" if len(answer) > 1 else "one command"


def _run_on(answer: list[Clause] | None) -> str | None:
    return None if answer is None else f"{len(answer)} commands, with nothing between them"


def _refusal(answer: tuple[Interpretation, Any]) -> str:
    return answer[0].reason


def _otherwise(answer: tuple[Interpretation, Any]) -> str:
    return f"{answer[0].status.value}: {answer[0].reason}"


OUTCOMES: Mapping[Kind, Callable[[Any], str | None]] = {
    Kind.STOP: _stop,
    Kind.WAKE: _wake,
    Kind.DICTATION: _dictation,
    Kind.NUMBERS: _numbers,
    Kind.SENTENCE: _clause("no sentence has these words"),
    Kind.COMMAND: _clause("no command"),
    Kind.MISHEARD: _clause("no sentence comes near"),
    Kind.CORRECTION: _clause("nothing that can be corrected"),
    Kind.REPLACEMENT: _replacement,
    Kind.NEGATION: _negation,
    Kind.COMPOUND: _compound,
    Kind.RUN_ON: _run_on,
    Kind.REFUSAL: _refusal,
    Kind.OTHERWISE: _otherwise,
}
"""How the answer of each kind of step is told; None: not at all. A choice is told by its candidates."""
