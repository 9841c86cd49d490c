"""``regex:`` and ``lark:`` patterns: the two other ways to write a sentence.

Regular expressions run in RE2, which is linear in the text whatever the pattern; Python's own could be made to run for
hours by one user's pattern and one long text. Named groups, and the rules of a Lark grammar, are slots.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from intent_engine.errors import ConfigError, Problem
from intent_engine.language.grammar import Grammar, Intent, Sentence
from intent_engine.language.template import Word

if TYPE_CHECKING:
    from intent_engine.language.matcher import Matcher, Reading

__all__ = ["Patterns"]


class Patterns:
    """The patterns of a grammar. False if there are none.

    Raises:
        ConfigError: a pattern cannot be compiled, or names a slot that does not exist.
    """

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        problems: list[Problem] = []
        self._regexes: list[tuple[Intent, Sentence, Any]] = []
        self._larks: list[tuple[Intent, Sentence, Any]] = []
        for intent in grammar.intents.values():
            for pattern in intent.regex:
                self._add_regex(intent, pattern, problems)
            if intent.lark is not None:
                self._add_lark(intent, intent.lark, problems)
        if problems:
            raise ConfigError(problems)

    def __bool__(self) -> bool:
        return bool(self._regexes or self._larks)

    def _problem(self, intent: Intent, message: str, hint: str | None = None) -> Problem:
        place = intent.place
        if place is None:
            return Problem(message, hint=hint)
        return Problem(message, place.file, place.line, place.column, place.source, hint)

    def _add_regex(self, intent: Intent, pattern: str, problems: list[Problem]) -> None:
        import re2

        options = re2.Options()
        options.log_errors = False
        try:
            compiled = re2.compile(pattern, options)
        except re2.error as error:
            detail = error.args[0].decode() if isinstance(error.args[0], bytes) else error.args[0]
            message = f"regex of intent {intent.name!r} cannot be read: {detail}"
            hint = "patterns are RE2: named groups (?P<slot>...), no look-around and no back-references"
            problems.append(self._problem(intent, message, hint))
            return
        for name in compiled.groupindex:
            if name not in self._grammar.slots:
                message = f"regex of intent {intent.name!r}: group {name!r} is no slot"
                problems.append(self._problem(intent, message, f"define it: slots: {{{name}: {{type: text}}}}"))
        self._regexes.append((intent, Sentence(pattern, Word(pattern)), compiled))

    def _add_lark(self, intent: Intent, text: str, problems: list[Problem]) -> None:
        from lark import Lark
        from lark.exceptions import LarkError

        try:
            parser = Lark(text, parser="earley", lexer="dynamic", ambiguity="resolve", propagate_positions=True)
        except (LarkError, OSError, ValueError) as error:
            message = f"lark grammar of intent {intent.name!r} cannot be read: {str(error).strip().splitlines()[0]}"
            problems.append(self._problem(intent, message, "the first rule must be called start"))
            return
        self._larks.append((intent, Sentence(text, Word(intent.name)), parser))

    def read(self, words: list[str], matcher: Matcher) -> list[Reading]:
        """The readings of patterns that match all the words."""
        text = " ".join(words)
        found = [
            self._reading(intent, sentence, values, words, matcher)
            for intent, sentence, values in (*self._by_regex(text), *self._by_lark(text))
        ]
        return sorted(found, key=lambda reading: (bool(reading.problem), -reading.intent.priority))

    def _by_regex(self, text: str) -> Iterator[tuple[Intent, Sentence, Mapping[str, str]]]:
        for intent, sentence, pattern in self._regexes:
            match = pattern.fullmatch(text)
            if match is not None:
                yield (
                    intent,
                    sentence,
                    {name: value for name, value in match.groupdict().items() if value is not None},
                )

    def _by_lark(self, text: str) -> Iterator[tuple[Intent, Sentence, Mapping[str, str]]]:
        from lark.exceptions import LarkError

        for intent, sentence, parser in self._larks:
            try:
                tree = parser.parse(text)
            except LarkError:
                continue
            values = {}
            for node in tree.iter_subtrees():
                name = str(node.data)
                if name in self._grammar.slots and not node.meta.empty:
                    values[name] = text[node.meta.start_pos : node.meta.end_pos].strip()
            yield intent, sentence, values

    def _reading(
        self,
        intent: Intent,
        sentence: Sentence,
        values: Mapping[str, str],
        words: list[str],
        matcher: Matcher,
    ) -> Reading:
        from intent_engine.language.matcher import Reading

        slots = []
        free = 0
        for name, said in values.items():
            slot = self._grammar.slots.get(name)
            if slot is None:
                continue
            if slot.type in ("text", "object"):
                free += len(said.split())
            slots.append(matcher.slot_from_words(slot, name, said.split()))
        return Reading(intent, sentence, tuple(slots), tuple(words), 0, free)
