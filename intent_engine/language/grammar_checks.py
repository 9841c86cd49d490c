"""What a grammar means, checked: names that exist, no recursion, sentences that can be reached."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from intent_engine.errors import Problem
from intent_engine.language.grammar import ACTION_PARAMETERS, Grammar, Intent, Place, Sentence
from intent_engine.language.template import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
    references,
)
from intent_engine.language.yaml_source import did_you_mean

__all__ = ["check_meaning", "nullable"]

REQUIRED = {"navigate": ("location",), "pick": ("object",), "turn": ("direction",), "move": ("direction",)}
"""Parameters without which an action cannot be made. A move's or turn's direction may come from the sentence's own
slots, a default or the sign of its distance or angle."""


def check_meaning(grammar: Grammar) -> tuple[list[Problem], list[Problem]]:
    """Problems that make a grammar unusable, and warnings."""
    problems: list[Problem] = []
    warnings: list[Problem] = []
    problems.extend(_names(grammar))
    if problems:
        return problems, warnings
    problems.extend(_recursion(grammar))
    if problems:
        return problems, warnings
    problems.extend(_choices(grammar))
    problems.extend(_twice(grammar))
    for intent in grammar.intents.values():
        problems.extend(_intent(grammar, intent))
    warnings.extend(_unused(grammar))
    return problems, warnings


def _problem(place: Place | None, message: str, hint: str | None = None, offset: int = 0) -> Problem:
    if place is None:
        return Problem(message, hint=hint)
    quoted = place.source[place.column - 1 : place.column] in ("'", '"')
    column = place.column + offset + (1 if quoted and offset else 0)
    return Problem(message, place.file, place.line, min(column, len(place.source) or 1), place.source, hint)


def _sentences(grammar: Grammar) -> Iterator[tuple[Intent, Sentence]]:
    for intent in grammar.intents.values():
        for sentence in intent.sentences:
            yield intent, sentence


def _names(grammar: Grammar) -> Iterator[Problem]:
    known = [*grammar.slots, *grammar.phrases]

    def unknown(reference: Reference) -> str | None:
        near = did_you_mean(reference.name, known)
        return near or (f"known: {', '.join(sorted(known))}" if known else "define it under slots: or phrases:")

    for _, sentence in _sentences(grammar):
        for reference in references(sentence.template):
            if reference.name not in known:
                message = f"there is no slot or phrase {reference.name!r}"
                yield _problem(sentence.place, message, unknown(reference), reference.column)
    for name, node in grammar.phrases.items():
        for reference in references(node):
            if reference.name not in known:
                yield Problem(
                    f"phrase {name!r} names {reference.name!r}, which does not exist",
                    grammar.files[0] if grammar.files else None,
                    hint=unknown(reference),
                )
    for slot in grammar.slots.values():
        for _, node in slot.values:
            for reference in references(node):
                if reference.name not in grammar.phrases:
                    message = f"a value of slot {slot.name!r} names {reference.name!r}; only phrases can stand there"
                    yield _problem(slot.place, message, did_you_mean(reference.name, grammar.phrases))


def _recursion(grammar: Grammar) -> Iterator[Problem]:
    def visit(name: str, above: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
        if name in above:
            yield (*above[above.index(name) :], name)
            return
        if name in done:
            return
        for reference in references(grammar.phrases[name]):
            if reference.name in grammar.phrases:
                yield from visit(reference.name, (*above, name))
        done.add(name)

    done: set[str] = set()
    for name in grammar.phrases:
        for loop in visit(name, ()):
            yield Problem(
                f"phrases name each other in a circle: {' -> '.join(loop)}",
                grammar.files[0] if grammar.files else None,
                hint="a sentence would never end; write the repetition out",
            )
            return


def nullable(node: Node, phrases: Mapping[str, Node]) -> bool:
    """Whether a template can be said with no word at all."""
    match node:
        case Word() | WordClass():
            return False
        case Optional():
            return True
        case Choice(items):
            return any(nullable(item, phrases) for item in items)
        case Sequence(items) | AnyOrder(items):
            return all(nullable(item, phrases) for item in items)
        case Reference(name):
            return name in phrases and nullable(phrases[name], phrases)
    return False


def _choices(grammar: Grammar) -> Iterator[Problem]:
    for slot in grammar.slots.values():
        spelled: dict[Node, object] = {}
        for value, node in slot.values:
            for option in node.items if isinstance(node, Choice) else (node,):
                if option in spelled and spelled[option] != value:
                    message = f"slot {slot.name!r}: the same words mean {spelled[option]!r} and {value!r}"
                    yield _problem(slot.place, message, "remove one")
                spelled[option] = value
            if nullable(node, grammar.phrases):
                message = f"slot {slot.name!r}: value {value!r} can be said without a word"
                yield _problem(slot.place, message, "make one word of it necessary")


def _twice(grammar: Grammar) -> Iterator[Problem]:
    first: dict[Node, tuple[Intent, Sentence]] = {}
    for intent, sentence in _sentences(grammar):
        if sentence.template in first:
            other, earlier = first[sentence.template]
            where = f"line {earlier.place.line}" if earlier.place else "before"
            if other.name != intent.name or dict(earlier.fixed) != dict(sentence.fixed):
                message = f"the same sentence is already in intent {other.name!r} ({where}); it can never be reached"
                yield _problem(sentence.place, message, "remove one of them")
        else:
            first[sentence.template] = (intent, sentence)


def _intent(grammar: Grammar, intent: Intent) -> Iterator[Problem]:
    if not intent.sentences and not intent.regex and intent.lark is None:
        message = f"intent {intent.name!r} has nothing that a person can say"
        yield _problem(intent.place, message, "add sentences:, regex: or lark:")
    for sentence in intent.sentences:
        if nullable(sentence.template, grammar.phrases):
            yield _problem(sentence.place, "every word of this sentence may be left out", "make one necessary")
        yield from _complete(grammar, intent, sentence)
    labels = _labels(grammar, intent)
    free = bool(intent.regex or intent.lark)
    for key in intent.defaults:
        if key not in labels and key not in ACTION_PARAMETERS[intent.action.type] and not free:
            if intent.action.type == "custom":
                continue  # a constant for the handler
            known = [*labels, *ACTION_PARAMETERS[intent.action.type]]
            yield _problem(intent.place, f"default for {key!r}, which nothing takes", did_you_mean(key, known))
    for condition in intent.when:
        for key in condition.slots:
            if key not in labels and not free:
                yield _problem(
                    intent.place,
                    f"'when' asks for slot {key!r}, which no sentence has",
                    did_you_mean(key, labels),
                )
    for value in intent.action.parameters.values():
        if isinstance(value, str) and value.startswith("{") and value.strip("{}") not in labels and not free:
            message = f"the action takes {value}, which no sentence of {intent.name!r} has"
            yield _problem(intent.place, message, did_you_mean(value.strip("{}"), labels))


def _labels(grammar: Grammar, intent: Intent) -> set[str]:
    labels: set[str] = set()
    for sentence in intent.sentences:
        labels.update(sentence.fixed)
        labels.update(slot_labels(grammar, sentence.template))
    return labels


def slot_labels(grammar: Grammar, node: Node) -> Iterator[str]:
    """The labels of the slots that a template can fill, through its phrases."""
    for reference in references(node):
        if reference.name in grammar.slots:
            yield reference.label
        elif reference.name in grammar.phrases:
            yield from slot_labels(grammar, grammar.phrases[reference.name])


def _complete(grammar: Grammar, intent: Intent, sentence: Sentence) -> Iterator[Problem]:
    """Every sentence must be able to give what its action cannot do without."""
    given = {*sentence.fixed, *intent.defaults, *slot_labels(grammar, sentence.template)}
    for condition in intent.when:
        given.update(condition.defaults)
    for parameter in REQUIRED.get(intent.action.type, ()):
        source = intent.action.parameters.get(parameter, "{" + parameter + "}")
        label = source.strip("{}") if isinstance(source, str) and source.startswith("{") else None
        if label is not None and label not in given:
            if parameter == "direction" and given & {"angle", "distance"}:
                continue
            message = f"{intent.action.type} needs {parameter!r}, and this sentence cannot give it"
            hint = f"add {{{label}}} to the sentence, slots: {{{label}: ...}} beside it, or a default"
            yield _problem(sentence.place, message, hint)


def _unused(grammar: Grammar) -> Iterable[Problem]:
    used: set[str] = set()
    for _, sentence in _sentences(grammar):
        used.update(reference.name for reference in references(sentence.template))
    for node in grammar.phrases.values():
        used.update(reference.name for reference in references(node))
    for slot in grammar.slots.values():
        for _, node in slot.values:
            used.update(reference.name for reference in references(node))
    free = any(intent.regex or intent.lark for intent in grammar.intents.values())
    for name, slot in grammar.slots.items():
        if name not in used and not free:
            yield _problem(slot.place, f"slot {name!r} is used by no sentence")
    for name in grammar.phrases:
        if name not in used:
            yield Problem(f"phrase {name!r} is used by no sentence", grammar.files[0] if grammar.files else None)
