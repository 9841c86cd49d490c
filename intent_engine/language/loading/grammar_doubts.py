"""What is doubtful in a grammar that can be used: what nothing uses, and what never does what its author means."""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterator, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import FREE_KINDS, Grammar, Sentence, problem_at
from intent_engine.language.loading.grammar_intents import slots_by_label
from intent_engine.language.loading.grammar_parts import Draft, Places
from intent_engine.language.loading.grammar_shapes import Shapes
from intent_engine.language.loading.yaml_source import YamlPath
from intent_engine.language.normalize import words_of
from intent_engine.language.numbers.units import Units, units
from intent_engine.language.pattern.patterns import slots_of_patterns, unsaid_patterns
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    references,
)
from intent_engine.language.vocabulary import words_in
from intent_engine.language.words.phrase_set import PhraseSet

if TYPE_CHECKING:
    from intent_engine.language.meaning.phrases import Phrases

__all__ = ["grammar_doubts"]

MAX_SPELLINGS = 256
"""Ways to say a sentence that are looked at."""
LONGEST_SIGN = 2
"""Letters of a sign of a unit, which may be a word of its own: "in" of inches."""
NEAR = 80.0
"""Percent of the letters of a default's name that are those of a slot: it is mistyped, and no constant of its own."""
_OPTIONAL = re.compile(r"([^\W\d_]+)\?(?=\s+[\w({\[])")
"""A word with a "?" in the midst of a sentence."""
_STROKE = re.compile(r"([^\W\d_]+)/([^\W\d_]+)")
_TAG = re.compile(r"(?:(\([^()\[\]{}]*[^()\[\]{}\s]\))|(?<![^\W_])([^\W\d_]+))\{\s*([^\W\d]\w*)[^{}]*\}")
_SIGNS = frozenset("()[]{}|;")
_OTHER_TEMPLATES = (
    (
        re.compile(r"[^\W\d_]+(?:\[[^\[\]()]+\]|\([^\[\]()]+\))|(?:\[[^\[\]()]+\]|\([^\[\]()]+\))[^\W\d_]+"),
        "{0!r} is said in two words: a bracket ends one",
        "write words in full, (lamp|lamps) for lamp[s]; or a blank between them",
    ),
    (
        re.compile(r"[\[(][^\[\]()|;]*,[^\[\]()|;]*[\])]"),
        "a ',' parts nothing: all of {0!r} is said, one after the other",
        "alternatives are parted by |: (make|brew)",
    ),
    (
        re.compile(r"\([^\[\]()|;{}<,:]*\)"),
        "the brackets of {0!r} change nothing: it must be said",
        "what may be left out stands in []: [please]",
    ),
    (
        re.compile(r"\b\d+\.\.\d+\b"),
        "{0!r} is no range, but two numbers that are said",
        "for any number give it a slot: n: {type: number, min: 0, max: 10, whole: true}",
    ),
    (
        re.compile(r"(?<![{\w])[^\W\d_]+:[^\W\d_]+"),
        "{0!r} puts nothing in the place of a word: both are said",
        "a value that is called otherwise than it is said: slots: {name: {values: {value: words}}}",
    ),
)
"""What templates of hassil, Rhasspy and Rhino have and ours read as words, without a mistake: what stands in the text,
what it is here, and what to write."""


def grammar_doubts(grammar: Grammar, draft: Draft, places: Places) -> Iterator[Problem]:
    """Everything that is hardly meant in a grammar without a mistake."""
    yield from _unused(grammar, draft, places)
    yield from _stopping(grammar)
    yield from _denials(grammar, draft)
    yield from _neighbours(grammar, draft)
    yield from _units_said_twice(grammar, draft)
    yield from _fixed_in_vain(grammar)
    yield from _defaults_in_vain(grammar, places)
    yield from _strokes(grammar, draft)
    yield from _foreign_signs(draft)
    yield from _tags(grammar, draft)
    yield from _values_with_brackets(grammar, draft)
    yield from unsaid_patterns(grammar, places)


def _stopping(grammar: Grammar) -> Iterator[Problem]:
    """Sentences of which some words stop the robot, whatever they are to do here: a stop goes before all else."""
    stop = PhraseSet(grammar.operators.stop)
    lists = {
        slot.name: Choice(tuple(node for _, node in slot.values))
        for slot in grammar.slots.values()
        if slot.values and slot.name not in grammar.phrases
    }
    said = {**grammar.phrases, **lists}
    others = (intent for intent in grammar.intents.values() if intent.action.type != "stop")
    known: dict[str, frozenset[str]] = {}
    suspects = [
        (intent.name, sentence)
        for intent in others
        for sentence in intent.sentences
        if stop.may_stand_in(_all_words(sentence.template, said, known))
    ]
    # Most sentences have other words than those of a stop, and to make the phrases of a grammar takes long.
    beside = (*grammar.operators.stop, *grammar.fillers, *grammar.around, *grammar.wake, *grammar.operators.opening)
    stopping = {word for words in (*beside, *grammar.operators.correction) for word in words}
    phrases: Phrases | None = None
    for name, sentence in suspects:
        within = _within(sentence.template, said, stopping)
        for words in spellings(within, said, MAX_SPELLINGS) if within is not None else ():
            phrases = phrases or _phrases(grammar)
            if phrases.only_stops(list(words), phrases.after_opening(list(words))):
                yield _stopped(name, sentence, " ".join(words))
                break


def _within(node: Node, said: Mapping[str, Node], words: Collection[str]) -> Node | None:
    """What of a template can be said with some words alone; None: nothing."""
    match node:
        case Word(text):
            return node if text in words else None
        case Optional(item):
            inner = _within(item, said, words)
            return Optional(inner) if inner is not None else Sequence(())
        case Choice(items):
            ways = tuple(way for item in items if (way := _within(item, said, words)) is not None)
            return Choice(ways) if ways else None
        case Sequence(items) | AnyOrder(items):
            ways = tuple(way for item in items if (way := _within(item, said, words)) is not None)
            return type(node)(ways) if len(ways) == len(items) else None
        case Reference(name) if name in said:
            return _within(said[name], said, words)
    return None


def _phrases(grammar: Grammar) -> Phrases:
    from intent_engine.language.meaning.phrases import Phrases  # which knows the words of grammars that are loaded

    return Phrases(grammar)


def _stopped(name: str, sentence: Sentence, words: str) -> Problem:
    message = f"{words!r} stops the robot in every grammar, and is never one of {name!r}"
    hint = "say it in other words; or let the intent have action: stop"
    return problem_at(sentence.place, message, hint)


def _all_words(node: Node, said: Mapping[str, Node], known: dict[str, frozenset[str]]) -> frozenset[str]:
    """The words of a template, with those of the phrases and lists that it names, which are ``known`` once met."""
    found = set(words_in(node))
    for name in {reference.name for reference in references(node)}:
        if name in said:
            if name not in known:
                known[name] = _all_words(said[name], said, known)
            found |= known[name]
    return frozenset(found)


def _fixed_in_vain(grammar: Grammar) -> Iterator[Problem]:
    """Values that a sentence has without saying them, though it always says another in their place."""
    shapes = Shapes(grammar)
    sentences = (sentence for intent in grammar.intents.values() for sentence in intent.all_sentences)
    for sentence in (one for one in sentences if one.fixed):
        for label in sorted(shapes.always(sentence.template) & sentence.fixed.keys()):
            message = (
                f"slot {label!r} is always said in this sentence, and never has the value {sentence.fixed[label]!r}"
            )
            hint = f"leave it out of slots:, or let it be said or not: [{{{label}}}]"
            yield problem_at(sentence.place, message, hint)


def _defaults_in_vain(grammar: Grammar, places: Places) -> Iterator[Problem]:
    """Defaults of actions of the program's own that are called nearly as a slot, or that the action does not take."""
    for intent in grammar.intents.values():
        if intent.action.type != "custom" or intent.regex or intent.lark:
            continue
        labels = set(slots_by_label((sentence.template for sentence in intent.all_sentences), grammar))
        fixed = {label for sentence in intent.all_sentences for label in sentence.fixed}
        taken = {str(value).strip("{}") for value in intent.action.parameters.values()}
        base: YamlPath = ("intents", intent.name)
        given = [((*base, "defaults", key), key) for key in intent.defaults]
        for index, condition in enumerate(intent.when):
            given += [((*base, "when", index, "defaults", key), key) for key in condition.defaults]
        for path, key in given:
            if key in labels | fixed | taken:
                continue
            near = did_you_mean(key, labels, alike=NEAR)
            if near is not None or taken:
                what = "which the action does not take" if taken else "which no sentence has"
                hint = near or f"it takes {', '.join(sorted(taken))}"
                yield places.problem(path, f"a default for {key!r}, {what}", hint, key=True)


def _strokes(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Words with a stroke between them: of units that is "per", and of all else nothing that anybody says."""
    known = units(grammar.language)
    names = known.names if known is not None else {}
    for written in draft.written:
        for match in _STROKE.finditer(written.text):
            if any((word.lower(),) in names for word in match.groups()):
                continue
            heard = " ".join(words_of(match.group()))
            message = f"{match.group()!r} would have to be said as {heard!r}"
            yield written.problem(message, f"for either of them write ({match[1]}|{match[2]})", match.start())


def _foreign_signs(draft: Draft) -> Iterator[Problem]:
    """Signs that are read otherwise than their author means who knows them from regular expressions or other templates:
    "the? lab" is said with its "the", "go|drive to {place}" is "go", or "drive to {place}", and "lamp[s]" two words."""
    for written in draft.written:
        if (match := _OPTIONAL.search(written.text)) is not None:
            message = f"the '?' of {match.group()!r} says nothing: the word must be said"
            yield written.problem(message, f"for a word that may be left out write [{match[1]}]", match.start())
        for sign, message, hint in _OTHER_TEMPLATES:
            if (match := sign.search(written.text)) is not None:
                yield written.problem(message.format(match.group().strip()), hint, match.start())
        if written.kind == "sentence" and isinstance(written.node, Choice):
            ways = [bool(list(references(way))) for way in written.node.items]
            bar = _bare_bar(written.text)
            if bar is not None and len(set(ways)) > 1:
                message = (
                    "this '|' stands in no brackets, and so parts all of the sentence: one part has a slot, one none"
                )
                before, after = written.text[:bar].split()[-1:], written.text[bar + 1 :].split()[:1]
                hint = (
                    f"for either of two words write ({''.join(before)}|{''.join(after)}); for two sentences, two lines"
                )
                yield written.problem(message, hint, bar)


def _tags(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Words with a slot straight behind them, as Rhasspy says what their value is: "(red|green){colour}" is "red" and
    then a colour."""
    for written in draft.written:
        for match in _TAG.finditer(written.text):
            slot = grammar.slots.get(match[3])
            values = {word for _, node in slot.values for word in words_in(node)} if slot is not None else set()
            before = match[1] or match[2]
            if slot is not None and not values.isdisjoint(words_of(before)):
                message = f"{match.group()!r} is two things that are said: {before!r}, then {slot.name!r}"
                hint = f"write {{{slot.name}}} alone, and what is said for its values in the slot; or a blank between"
                yield written.problem(message, hint, match.start())


def _values_with_brackets(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Values of a list that are templates, and so are called with all their brackets."""
    for written in draft.written:
        slot = grammar.slots.get(written.name) if written.kind == "slot" else None
        if slot is None or not any(value == written.text for value, _ in slot.values) or not _SIGNS & {*written.text}:
            continue
        message = f"the value of slot {slot.name!r} is called {written.text!r}, as it is written"
        name = " ".join(words_of(re.sub(r"\[[^\]]*\]|\|[^)\]]*", " ", written.text))) or "name"
        yield written.problem(message, f'give it a name: values: {{{name}: "{written.text}"}}')


def _bare_bar(text: str) -> int | None:
    """Where the first "|" of a template stands that is in no brackets; None: there is none."""
    depth = 0
    for column, character in enumerate(text):
        depth += (character in "([{") - (character in ")]}")
        if character == "|" and not depth:
            return column
    return None


def _unused(grammar: Grammar, draft: Draft, places: Places) -> Iterator[Problem]:
    used = {reference.name for written in draft.written for reference in references(written.node)}
    used |= slots_of_patterns(grammar)
    sentences = (sentence for intent in grammar.intents.values() for sentence in intent.all_sentences)
    used.update(label for sentence in sentences for label in sentence.fixed)
    for section, names in (("slots", grammar.slots), ("phrases", grammar.phrases)):
        for name in names:
            if name not in used:
                what = section.removesuffix("s")
                yield places.problem((section, name), f"{what} {name!r} is used by no sentence", key=True)


def _denials(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Sentences that say "not" and yet do something: each is done, whatever the negation says."""
    negation = {words[0] for words in grammar.operators.negation if len(words) == 1}
    for written in draft.written:
        if written.kind == "sentence" and grammar.intents[written.name].action.type != "stop":
            for word in words_in(written.node):
                if word in negation:
                    message = f"this sentence says {word!r}, and yet the robot will act on it"
                    hint = "the engine knows what it means; keep it only where the action is to hold the robot back"
                    yield written.problem(message, hint)
                    break


def _neighbours(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Free text beside free text: each takes as many words as it likes, and nobody knows where one ends."""

    def free(node: Node) -> Reference | None:
        node = node.item if isinstance(node, Optional) else node
        if isinstance(node, Reference) and node.name in grammar.slots:
            return node if grammar.slots[node.name].type in FREE_KINDS else None
        return None

    for written in draft.written:
        for one, other in ((free(left), free(right)) for left, right in _neighbouring(written.node)):
            if one is None or other is None:
                continue
            message = f"nobody can tell where {one.label!r} ends and {other.label!r} begins: both are free text"
            yield written.problem(message, "put a word between them, or make a choice of one", other.column)


def _units_said_twice(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Units behind amounts that are said with their unit: "wait {time} seconds" is "wait five seconds seconds"."""
    known = units(grammar.language)
    for written in draft.written if known is not None else ():
        for left, right in _neighbouring(written.node):
            slot = grammar.slots.get(left.name) if isinstance(left, Reference) else None
            if slot is None or slot.unit is not None or not isinstance(left, Reference) or known is None:
                continue
            unit = _unit_at(known, slot.type, _beginning(right))
            if len(" ".join(unit)) > LONGEST_SIGN:
                message = f"{' '.join(unit)!r} would have to be said twice: {left.label!r} is said with its unit"
                usual = known.names.get(unit, " ".join(unit))
                hint = f"leave it out; or let {slot.name!r} have unit: {usual}, for numbers without one"
                yield written.problem(message, hint, left.column)


def _unit_at(known: Units, kind: str, words: tuple[str, ...]) -> tuple[str, ...]:
    """The words of a unit with which others begin, as many as there are; none where they begin with no unit."""
    names = known.by_kind.get(kind, {})
    way = known.by_kind.get({"speed": "distance", "angular_speed": "angle"}.get(kind, ""), {})
    if words[:1] in way and words[2:3] in known.by_kind["duration"] and words[1] in known.words.get("per", ()):
        return words[:3]
    return next((words[:end] for end in range(len(words), 0, -1) if words[:end] in names), ())


def _beginning(node: Node) -> tuple[str, ...]:
    """The words with which a template begins, of alternatives with the first."""
    match node:
        case Word(text):
            return (text,)
        case Choice(items) if items:
            return _beginning(items[0])
        case Sequence(items):
            words = itertools.takewhile(lambda item: isinstance(item, Word), items)
            return tuple(word.text for word in words if isinstance(word, Word))
    return ()


def _neighbouring(node: Node) -> Iterator[tuple[Node, Node]]:
    """Parts of a template that stand one behind the other."""
    items = node.items if isinstance(node, (Choice, Sequence, AnyOrder)) else ()
    if isinstance(node, Sequence):
        yield from pairwise(items)
    for item in (*items, *((node.item,) if isinstance(node, Optional) else ())):
        yield from _neighbouring(item)
