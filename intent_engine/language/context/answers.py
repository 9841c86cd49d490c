"""What an answer to a question of the engine means: "bay 3 or bay 13?", and "the second one".

An :class:`Interpretation` that is not accepted may ask something back (its :class:`Question`). What is said next is
an answer only if it tells exactly one of the alternatives: by words of its name that no other has, by its place among
them, or by a "yes" where there is but one. An unfinished sentence is answered by its rest. What is chosen is understood
as the whole sentence that it stands for, as if that had been said; nothing is done that was neither said nor asked
about. How long a question lasts is not known here.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from intent_engine.interpretation import Cause, Interpretation, Question, Status
from intent_engine.language.grammar import Grammar
from intent_engine.language.numbers.spelled import in_digits
from intent_engine.language.quantities import evaluate
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Answers", "answered", "either", "with_name"]

_COMMAND = 2
"""Words from which a command is one of its own, and not the rest of an unfinished sentence."""


class Answers:
    """Reads answers in the words of one grammar's language.

    Args:
        grammar: of the language.
    """

    def __init__(self, grammar: Grammar) -> None:
        wording = grammar.wording
        self._language = grammar.language
        self._wake = PhraseSet(grammar.wake)
        self._yes = wording.affirming
        self._no = wording.declining
        said = grammar.fillers  # "first" is one as well, where a sentence begins
        self._fillers = PhraseSet(one for one in said if evaluate(list(one), "ordinal", grammar.language) is None)
        self._correction = PhraseSet(grammar.operators.correction)
        self._negation = PhraseSet(grammar.operators.negation)
        self._standing_for = wording.standing_for
        self._articles = thing_words(grammar.language).articles

    def words(self, text: str, *, called: bool = False) -> list[str]:
        """The words of an answer, without a wake word before them and what says nothing among them.

        Args:
            text: what was said.
            called: whether the wake word is needed, where the grammar has one; without it there are no words.
        """
        said, kept = Utterance.of(text, self._language).words, list[str]()
        woken = at = 0
        while at < len(said):
            if not kept and not woken and (woken := self._wake.at(said, at)):
                at += woken
                continue
            whole = max(self._yes.at(said, at), self._no.at(said, at))  # "yeah" is a filler as well
            length = 0 if whole else self._fillers.at(said, at)
            kept += said[at : at + (whole or 1)] if not length else []
            at += length or whole or 1
        return [] if called and self._wake and not woken else kept

    def agrees(self, words: Sequence[str]) -> bool:
        """Whether an answer says yes, and nothing else."""
        return bool(words) and self._yes.cover(words)

    def declines(self, words: Sequence[str]) -> bool:
        """Whether an answer says that nothing of it is meant, and nothing else."""
        return bool(words) and self._no.cover(words)

    def corrected(self, words: Sequence[str]) -> Sequence[str]:
        """What is left of an answer behind its last correction: "thirteen", of "three, no, thirteen"."""
        found = self._correction.find(words, 1)
        while found is not None and sum(found) < len(words):
            words = words[sum(found) :]
            found = self._correction.find(words, 1)
        return words

    def excluded(self, words: Sequence[str], names: Sequence[str], sentences: Sequence[str]) -> set[int]:
        """The places of the alternatives of which an answer says that they are not meant: "not bay three"."""
        start = self._no.at(words, 0)
        length = self._negation.at(words, start)
        rest = words[start + length :]
        return (self.meant(rest, names, sentences) or set()) if length and rest else set()

    def meant(self, words: Sequence[str], names: Sequence[str], sentences: Sequence[str]) -> set[int] | None:
        """The places of the alternatives that an answer may mean; empty: it is about them, and means none that there
        is. None: it has nothing to do with them.

        Args:
            words: of the answer.
            names: of the alternatives.
            sentences: that they stand for.
        """
        if (yes := self._yes.at(words, 0)) and yes < len(words):
            words = words[yes:]  # "yes, the lab"
        known = [self._plain(name) for name in names]
        bare = self._bare(words)
        found = self._named(self._plain_words(words), known)
        if not found or words[0] in self._articles:
            stands = not self._standing_for.isdisjoint(words)  # "the left one" is no name; "bay one" is no "bay"
            found |= self._named(self._plain_words(bare), known, whole=not stands)
        found |= self._counted(words, len(names))
        if not found and self.agrees(words):  # "right" may be the right one of two
            return set(range(len(names)))
        if found:
            return found
        whole = [self._plain(sentence) for sentence in sentences]
        found = self._named(self._plain_words(words), whole, without=self._articles)  # "to the kitchen"
        about = {word for name in known for word in name}
        plain = self._plain_words(bare)
        short = len(plain) <= 1 + max(map(len, known), default=0)
        if found or (short and (not about.isdisjoint(plain) or all(map(str.isdecimal, plain)) or self._nth(words))):
            return found
        return None

    def _bare(self, words: Sequence[str]) -> list[str]:
        """Words without the articles before them, and without what only stands for a thing."""
        rest = [word for word in words if word not in self._standing_for] or list(words)
        start = next((at for at, word in enumerate(rest[:-1]) if word not in self._articles), len(rest) - 1)
        return rest[start:]

    def _nth(self, words: Sequence[str]) -> int:
        """The place that words count, from 1; -1: the last; 0: they count none. A number alone is part of a name."""
        rest = [word for word in words if word not in self._standing_for]
        if not rest or evaluate(self._bare(rest), "number", self._language) is not None:
            return 0
        found = evaluate(rest, "ordinal", self._language)
        return int(found) if isinstance(found, float) and found.is_integer() else 0

    def _counted(self, words: Sequence[str], count: int) -> set[int]:
        nth = self._nth(words)
        place = nth - 1 if nth > 0 else count + nth
        return {place} if nth and 0 <= place < count else set()

    @staticmethod
    def _named(
        said: tuple[str, ...], names: Sequence[tuple[str, ...]], without: Collection[str] = (), *, whole: bool = True
    ) -> set[int]:
        """Which names these words are, if they may be a ``whole`` one; else those that have them side by side."""
        said = tuple(word for word in said if word not in without)
        known = [tuple(word for word in name if word not in without) for name in names]
        if not said:
            return set()
        same = {at for at, name in enumerate(known) if name == said} if whole else set[int]()
        return same or {
            at
            for at, name in enumerate(known)
            if any(name[start : start + len(said)] == said for start in range(len(name)))
        }

    def _plain(self, text: str) -> tuple[str, ...]:
        return self._plain_words(Utterance.of(text, self._language).words)

    def _plain_words(self, words: Sequence[str]) -> tuple[str, ...]:
        """Words as they are compared: a number is one word, so that "three" is no part of "thirty three"."""
        return in_digits(list(words), self._language)


def answered(
    asked: Interpretation,
    text: str,
    found: Interpretation,
    answers: Sequence[Answers],
    parse: Callable[[str], Interpretation],
    *,
    called: bool = False,
) -> Interpretation | None:
    """What a text means as the answer to a question; None: it is none, and means what it means by itself.

    Args:
        asked: what asked something back.
        text: what was said next.
        found: what that means by itself. A stop is one, whatever was asked, and ends the question.
        answers: readers of the languages in which it may have been said.
        parse: what a whole sentence means.
        called: whether an answer needs the wake word, where a grammar has one.

    Returns:
        Accepted, if it tells one alternative; its text is the whole sentence that is meant. Else it may ask again.
    """
    if asked.question is None or found.stops:
        return None
    for reader in answers:
        words = reader.words(text, called=called)
        if not words:
            continue
        if reader.declines(words):
            if found.status is Status.ACCEPTED:
                return None
            return _none_meant(text, found)
        excluded = reader.excluded(words, asked.alternatives, asked.question.choices)
        if excluded and found.status is not Status.ACCEPTED:
            return _without(excluded, asked, asked.question, text, found)
        if asked.question.beginning:
            if reader.agrees(words):
                continue  # that it goes on is no rest of it
            whole = _completed(asked, asked.question.beginning, text, words, found, parse)
        else:
            whole = _chosen(asked, asked.question, text, words, found, reader, parse)
        if whole is not None:
            return whole
    return None


def _chosen(
    asked: Interpretation,
    question: Question,
    text: str,
    words: Sequence[str],
    found: Interpretation,
    reader: Answers,
    parse: Callable[[str], Interpretation],
) -> Interpretation | None:
    """The alternative that an answer tells, or the question once more."""
    meant = reader.meant(reader.corrected(words), asked.alternatives, question.choices)
    if meant is None:
        return None
    choice = question.choices[meant.pop()] if len(meant) == 1 else ""
    if not choice:
        if found.status in (Status.ACCEPTED, Status.AMBIGUOUS):
            return None
        return _asked_again(asked, text, f"{text!r} does not tell which is meant; say its name")
    whole = parse(choice)
    if found.status is Status.ACCEPTED and (found.actions != whole.actions or not whole.actions):
        return either(asked, found, whole) if whole.actions else None
    return _as_answer(text, whole)


def _without(
    excluded: Collection[int], asked: Interpretation, question: Question, text: str, found: Interpretation
) -> Interpretation:
    """The question once more, without what is not meant."""
    left = [at for at in range(len(asked.alternatives)) if at not in excluded]
    if not left or not question.choices:
        return _none_meant(text, found)
    names = tuple(asked.alternatives[at] for at in left)
    reason = f"{text!r} tells what is not meant; say which is: {' or '.join(names)}"
    rest = replace(question, choices=tuple(question.choices[at] for at in left))
    return replace(_asked_again(asked, text, reason), alternatives=names, question=rest, denied=found.denied)


def _none_meant(text: str, found: Interpretation) -> Interpretation:
    """A "no", or a "neither": nothing is done, and what it forbids besides is told."""
    causes, reason = frozenset((Cause.NONE_MEANT,)), "nothing that was asked about is meant"
    return Interpretation(text, Status.REJECTED, reason=reason, causes=causes, denied=found.denied)


def _asked_again(asked: Interpretation, text: str, reason: str) -> Interpretation:
    """The question once more, with the reason why it is."""
    return replace(asked, text=text, reason=reason, causes=frozenset())


def _completed(
    asked: Interpretation,
    beginning: str,
    text: str,
    words: Sequence[str],
    found: Interpretation,
    parse: Callable[[str], Interpretation],
) -> Interpretation | None:
    """An unfinished sentence with its rest, if both are one."""
    whole = parse(f"{beginning.rstrip(' .,!?…')}, {' '.join(words)}")
    if found.status is Status.ACCEPTED:
        if len(words) >= _COMMAND or not whole.actions:
            return None  # another command, and no thing of that name to pick up
        return either(asked, found, whole) if found.actions != whole.actions else _as_answer(text, whole)
    if whole.actions:
        return _as_answer(text, whole)
    if found.status is Status.AMBIGUOUS or found.intent is not None:
        return None
    if whole.unknown_place:  # talk is no name, and nothing that it is like is meant
        return replace(whole, question=None)
    return whole if whole.status in (Status.AMBIGUOUS, Status.INCOMPLETE) else None


def _as_answer(text: str, whole: Interpretation) -> Interpretation:
    """What is meant, with the words that answered. It may ask on itself, or not be possible now."""
    if whole.status is not Status.ACCEPTED:
        return whole
    return replace(whole, reason="; ".join(filter(None, (f"answered by {text!r}", whole.reason))))


def either(asked: Interpretation, command: Interpretation, answer: Interpretation) -> Interpretation:
    """What may be a command of its own, or an answer that does something else: nobody knows, so it is asked again."""
    reason = f"{command.text!r} may be a command, or the answer that means {answer.text!r}; say it in a whole sentence"
    if asked.question is not None and asked.question.beginning:
        both = (command.text, answer.text)
        return Interpretation(command.text, Status.AMBIGUOUS, alternatives=both, reason=reason)
    return replace(_asked_again(asked, command.text, reason), status=Status.AMBIGUOUS)


def with_name(text: str, said: Sequence[str], name: str) -> str:
    """A text with a name in the place of the words that were said for it, which stand in it once; else empty."""
    pieces = text.split()
    places = [
        (start, end)
        for start in range(len(pieces))
        for end in range(start + 1, min(len(pieces), start + len(said) + 1) + 1)
        if Utterance.of(" ".join(pieces[start:end])).words == list(said)
        and Utterance.of(pieces[start]).words
        and Utterance.of(pieces[end - 1]).words  # "ferme-la !"
    ]
    if len(places) != 1:
        return ""
    start, end = places[0]
    last = pieces[end - 1]
    mark = last[len(last.rstrip(",.;:!?")) :]
    return " ".join([*pieces[:start], name + mark, *pieces[end:]])
