"""``regex:`` and ``lark:`` patterns: the two other ways to write a sentence.

Regular expressions run in RE2, which is linear in the text whatever the pattern; Python's own could be made to run for
hours by one user's pattern and one long text. Named groups, and the rules of a Lark grammar, are slots.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeAlias

from intent_engine.errors import ConfigError, Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import FREE_KINDS, Grammar, Intent, Sentence
from intent_engine.language.loading.grammar_parts import Places
from intent_engine.language.numbers import english
from intent_engine.language.numbers.spelled import in_digits, in_words
from intent_engine.language.pattern.every_letter import with_every_letter
from intent_engine.language.pattern.pattern_tree import Part, UnsayableError
from intent_engine.language.pattern.regex_set import RegexSet
from intent_engine.language.templates.template_tree import Word
from intent_engine.language.words.phrase_set import PhraseSet

if TYPE_CHECKING:
    from intent_engine.language.loading.yaml_source import YamlPath
    from intent_engine.language.matcher import Matcher
    from intent_engine.language.reading import Reading

__all__ = ["Patterns", "pattern_problems", "said_by_patterns", "slots_of_patterns", "unsaid_patterns"]


MAX_LARK_WORDS, MAX_LARK_LETTERS = 40, 240
"""Words that a Lark grammar is tried on, and letters: an ambiguous one costs the cube of the length."""
PROBES = ("", "qwx", "qwx vbn", "qwx vbn zrt", "vbn zrt plk qwx djf")
"""What nobody says. A pattern that fits one of these fits everything, and a robot would act on any noise."""
_BEGIN_NUMBERS = frozenset(("a", "an", "zero"))
"""Words with which numbers begin that are no cardinals by themselves: "a hundred", "a dozen"."""

_Span: TypeAlias = tuple[int, int]
"""Where what a slot holds begins in a text, and where it ends."""


@dataclass(frozen=True)
class _Compiled:
    """A pattern of an intent, or why there is none."""

    pattern: Any = None
    problem: tuple[str, str | None] = ("", None)
    """Message and hint."""
    line: int = 0
    """Line of the pattern in which the problem is, from 0."""


@lru_cache(maxsize=512)
def _regex(text: str) -> _Compiled:
    import re2

    options = re2.Options()
    options.log_errors = False
    try:
        re2.compile(text, options)  # told of as it was written
        compiled = re2.compile(with_every_letter(text), options)
    except re2.error as error:
        detail = error.args[0].decode() if isinstance(error.args[0], bytes) else error.args[0]
        hint = "patterns are RE2: named groups (?P<slot>...), no look-around and no back-references"
        return _Compiled(problem=(f"the regex cannot be read: {detail}", hint))
    if any(compiled.fullmatch(probe) is not None for probe in PROBES):
        hint = "let it begin with a word that says what to do"
        return _Compiled(problem=("the regex fits whatever anybody says", hint))
    groups = re.findall(r"\(\?P<(\w+)>", re.sub(r"\\.", "", text))
    if twice := [name for name in groups if groups.count(name) > 1]:
        hint = f"put one around both: (?P<{twice[0]}>...|...); or give the other a slot of its own"
        return _Compiled(problem=(f"the regex has two groups {twice[0]!r}, and only one would be kept", hint))
    plain = re.sub(r"\\[pP]\{[^}]*\}|\\.|\(\?[^)>:]*[>:)]", "", text)
    if re.search("[A-Z]", plain) and "(?i" not in text:
        return _Compiled(problem=("the regex has capitals, and what is said comes in lower case", "write it small"))
    return _Compiled(compiled)


@lru_cache(maxsize=64)
def _lark(text: str) -> _Compiled:
    from lark.exceptions import LarkError

    from intent_engine.language.pattern.linear_lark import LinearLark

    try:
        parser = LinearLark(text, parser="earley", lexer="dynamic", ambiguity="resolve", propagate_positions=True)
    except (LarkError, OSError, ValueError, RecursionError) as error:
        detail = str(error).strip().splitlines()[0].removesuffix(": ")
        found = re.search(r"line (\d+)", detail) or re.search(r"line (\d+)", str(error))
        hint = "see lark's grammar reference; names of rules are small, names of terminals CAPITAL"
        detail = re.sub(r",? at line \d+,? col(umn)? \d+.*| at line \d+.*", "", detail)
        if "zero-width" in detail:
            detail, hint = "a pattern in it may be empty", "let each match a character at least: + instead of *"
        elif "'start'" in detail:
            detail, hint = "it has no rule called start", "the first rule must be called start"
        return _Compiled(
            problem=(f"the lark grammar cannot be read: {detail}", hint), line=int(found[1]) if found else 0
        )
    for probe in PROBES:
        try:
            parser.parse(probe)
        except LarkError:
            continue
        return _Compiled(problem=("the lark grammar fits whatever anybody says", "let it begin with a word of its own"))
    return _Compiled(parser)


def _decimals(words: Sequence[str]) -> list[str]:
    """Words with "2 point 5" as "2.5"."""
    found: list[str] = []
    for word in words:
        if word.isdigit() and found[-1:] == ["point"] and len(found) > 1 and found[-2].isdigit():
            found[-2:] = [f"{found[-2]}.{word}"]
        else:
            found.append(word)
    return found


def _in_figures(words: Sequence[str]) -> list[str]:
    """Words with those English numbers in figures that are no whole cardinal: "2.5" for "two and a half", "100" for "a
    hundred", "0" for "zero"."""
    found: list[str] = []
    at = 0
    while at < len(words):
        value, end = next(english.numbers_at(words, at), (0.0, at))
        if end > at and (words[at] in _BEGIN_NUMBERS or not value.is_integer()):
            found.append(f"{value:.12g}")
            at = end
        else:
            found.append(words[at])
            at += 1
    return found


def _at(intent: Intent, index: int, places: Places) -> YamlPath:
    """Where a regex stands: in a list, or alone."""
    alone = ("intents", intent.name, "regex")
    return (*alone, index) if places.of((*alone, 0)) != places.of(alone) else alone


def pattern_problems(grammar: Grammar, places: Places, broken: Collection[str] | None) -> Iterator[Problem]:
    """What is wrong with the patterns of a grammar.

    Args:
        places: where they stand.
        broken: names of slots that exist though they are not in the grammar; None: any name may exist.
    """
    for intent in grammar.intents.values():
        for index, text in enumerate(intent.regex):
            at = _at(intent, index, places)
            compiled = _regex(text)
            if compiled.pattern is None:
                yield places.problem(at, *compiled.problem)
            elif broken is not None:
                for name in compiled.pattern.groupindex:
                    if name not in grammar.slots and name not in broken:
                        hint = did_you_mean(name, grammar.slots) or f"define it: slots: {{{name}: {{type: text}}}}"
                        yield places.problem(at, f"the regex fills {name!r}, and there is no such slot", hint)
        if intent.lark is not None:
            compiled = _lark(intent.lark)
            if compiled.pattern is None:
                yield places.problem(("intents", intent.name, "lark"), *compiled.problem, line=compiled.line)


def _as_in_a_program(text: str, sign: str) -> str | None:
    """What to do about a regex that was copied from a program with what is around it there; None: it was not."""
    if sign == "\b":
        return "write it in single quotes: between double ones YAML reads \\b as the sign backspace"
    if re.fullmatch(r"""[rR](["']).*\1""", text):
        return "YAML has no r before a quote: write it in single quotes"
    return "write it without the / at both ends" if re.fullmatch(r"/.*/[a-z]*", text) else None


def slots_of_patterns(grammar: Grammar) -> set[str]:
    """What the patterns of a grammar that was checked can fill."""
    found: set[str] = set()
    for intent in grammar.intents.values():
        for text in intent.regex:
            found.update(_regex(text).pattern.groupindex)
        if intent.lark is not None:
            found.update(str(rule.origin.name) for rule in _lark(intent.lark).pattern.rules)
    return found


def unsaid_patterns(grammar: Grammar, places: Places) -> Iterator[Problem]:
    """Patterns of a grammar that was checked that nobody can say, because of what no text has any more that was said:
    signs, capitals, a blank beside another."""
    from intent_engine.language.pattern.pattern_signs import unfit_end, unsaid_blank, unsaid_in_lark, unsaid_sign

    for intent in grammar.intents.values():
        at_lark = ("intents", intent.name, "lark")
        if intent.lark is not None and (text := unsaid_in_lark(_lark(intent.lark).pattern, grammar.slots)) is not None:
            message = (
                f"the lark grammar asks for {text!r}, and what is said is small letters and numbers, without signs"
            )
            yield places.problem(at_lark, message, "'Hop, now!' is heard as 'hop now'")
        for index, text in enumerate(intent.regex):
            if (sign := unsaid_sign(text)) is not None:
                message = f"the regex asks for {sign!r}, and what is said is words and numbers, without signs"
                hint = _as_in_a_program(text, sign) or (
                    "'hop, now!' is heard as 'hop now', 'what's up' as 'whats up', '50%' as '50 percent'"
                )
                yield places.problem(_at(intent, index, places), message, hint)
            elif (letter := unfit_end(text)) is not None:
                message = f"\\b beside {letter!r} fits nothing: RE2 knows the ends of English words alone"
                yield places.problem(_at(intent, index, places), message, "leave it out: all of the words are compared")
            elif unsaid_blank(text):
                message = "the regex asks for a blank beside another, or at an end, and what is said has none there"
                hint = "write |- or quotes: what stands behind | ends with the end of its line"
                yield places.problem(_at(intent, index, places), message, hint if "\n" in text else "remove it")


def said_by_patterns(grammar: Grammar) -> Iterator[Part]:
    """What the patterns of a grammar that was checked may be said as, of those of which it can be told."""
    return (part for _, _, part in parts_of_patterns(grammar))


def parts_of_patterns(grammar: Grammar) -> Iterator[tuple[Intent, Sentence, Part]]:
    """The same, each with its intent and the sentence that stands for it."""
    from intent_engine.language.pattern.pattern_lark import lark_tree
    from intent_engine.language.pattern.pattern_regex import regex_tree

    for intent in grammar.intents.values():
        for text in intent.regex:
            with contextlib.suppress(UnsayableError):
                yield intent, _sentence(text, intent), regex_tree(text)
        if intent.lark is not None:
            with contextlib.suppress(UnsayableError):
                part = lark_tree(_lark(intent.lark).pattern, grammar.slots)
                yield intent, _sentence(intent.lark, intent), part


def _sentence(pattern: str, intent: Intent) -> Sentence:
    """Stands for a pattern where others have a template."""
    return Sentence(pattern, Word(intent.name))


def _holds(text: str, span: _Span) -> bool:
    """Whether a slot holds a word: a group that fits nothing, or a blank alone, was not said."""
    begin, end = span
    return begin >= 0 and bool(text[begin:end].strip())


class Patterns:
    """The patterns of a grammar that was checked. False if there are none."""

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        self._regexes: list[tuple[Intent, Sentence, Any]] = []
        self._larks: list[tuple[Intent, Sentence, Any]] = []
        for intent in grammar.intents.values():
            for text in intent.regex:
                self._regexes.append((intent, _sentence(text, intent), self._checked(_regex(text), intent)))
            if intent.lark is not None:
                lark = self._checked(_lark(intent.lark), intent)
                self._larks.append((intent, _sentence(intent.lark, intent), lark))
        self._regex_set = RegexSet([pattern for _, _, pattern in self._regexes])
        operators = grammar.operators
        self._operators = PhraseSet(
            (
                *operators.negation,
                *operators.correction,
                *operators.cancel,
                *operators.stop,
                *((word,) for word in operators.closed),
            )
        )

    @staticmethod
    def _checked(compiled: _Compiled, intent: Intent) -> Any:
        if compiled.pattern is None:
            raise ConfigError(Problem(f"intent {intent.name!r}: {compiled.problem[0]}", hint=compiled.problem[1]))
        return compiled.pattern

    def __bool__(self) -> bool:
        return bool(self._regexes or self._larks)

    def read(self, words: list[str], matcher: Matcher) -> list[Reading]:
        """The readings of patterns that match all the words.

        A pattern with holes (``.*forward.*``) fits "do not go forward" as well. So a word that changes what is meant
        must be spelled out in the pattern, or allowed by a slot of it. Numbers may be said in words where it has
        digits, and the other way round.
        """
        for said in self._numbers_otherwise(words):
            text = " ".join(said)
            changing = self._changing(said)
            readings = [
                self._reading(intent, sentence, values, said, matcher)
                for intent, sentence, values in (*self._by_regex(text), *self._by_lark(text))
            ]
            found = [reading for reading in readings if changing <= self._meant(reading)]
            if found:
                return sorted(found, key=lambda reading: (bool(reading.problem), -reading.intent.priority))
        return []

    def held(self, intent: str, text: str) -> Iterator[dict[str, str]]:
        """What the slots of an intent's patterns hold that fit a normalised text as it is."""
        for owner, _, values in (*self._by_regex(text), *self._by_lark(text)):
            if owner.name == intent:
                yield {name: text[begin:end].strip() for name, (begin, end) in values.items()}

    def _numbers_otherwise(self, words: list[str]) -> Iterator[list[str]]:
        """Words as they are; in English also with their numbers in digits, and in words."""
        yield words
        if self._grammar.language == "en":
            digits = _decimals(in_digits(words))
            for other in (digits, in_words(words), _decimals(in_digits(_in_figures(words)))):
                if other != words and (other is digits or other != digits):
                    yield other

    def _changing(self, words: list[str]) -> set[int]:
        """The places of the words of every operator that is said."""
        if not self._operators.may_stand_in(words):
            return set()
        found = ((at, self._operators.at(words, at)) for at in range(len(words)))
        return {place for at, length in found for place in range(at, at + length)}

    def _meant(self, reading: Reading) -> set[int]:
        """The places of words that a pattern spells out, that a slot of it allows, or that stand in what is exactly a
        quantity or a name: "two and a half meters"."""
        written = set(re.findall(r"[^\W\d_]+", reading.sentence.text))
        written.update(*(slot.allow for name, slot in self._grammar.slots.items() if name in written))
        within = {
            place
            for slot in reading.slots
            if slot.slot.type not in FREE_KINDS and slot.status == "exact"
            for place in range(slot.start, slot.end)
        }
        return within | {place for place, word in enumerate(reading.words) if word in written}

    def _by_regex(self, text: str) -> Iterator[tuple[Intent, Sentence, Mapping[str, _Span]]]:
        for place in self._regex_set.fitting(text):
            intent, sentence, pattern = self._regexes[place]
            match = pattern.fullmatch(text)
            if match is not None:
                spans = {name: match.span(number) for name, number in pattern.groupindex.items()}
                yield intent, sentence, {name: span for name, span in spans.items() if _holds(text, span)}

    def _by_lark(self, text: str) -> Iterator[tuple[Intent, Sentence, Mapping[str, _Span]]]:
        from lark.exceptions import LarkError

        short = text.count(" ") < MAX_LARK_WORDS and len(text) <= MAX_LARK_LETTERS
        for intent, sentence, parser in self._larks if short else ():
            try:
                tree = parser.parse(text)
            except LarkError:
                continue
            values = {}
            for node in tree.iter_subtrees():
                name = str(node.data)
                if name in self._grammar.slots and not node.meta.empty:
                    span = node.meta.start_pos, node.meta.end_pos
                    if _holds(text, span):
                        values[name] = span
            yield intent, sentence, values

    def _reading(
        self,
        intent: Intent,
        sentence: Sentence,
        values: Mapping[str, _Span],
        words: list[str],
        matcher: Matcher,
    ) -> Reading:
        from intent_engine.language.reading import Reading

        slots = []
        free = 0
        text = " ".join(words)
        for name, (begin, end) in sorted(values.items(), key=lambda held: held[1]):  # as they were said
            slot = self._grammar.slots.get(name)
            if slot is None:
                continue
            said = text[begin:end].split()
            place = text.count(" ", 0, begin + len(text[begin:end]) - len(text[begin:end].lstrip()))
            if slot.type in FREE_KINDS:
                free += len(said)
            slots.append(matcher.values.from_words(slot, name, said, place))
        return Reading(intent, sentence, tuple(slots), tuple(words), 0, 0, free)
