"""What a grammar means, checked: names that exist, no recursion, sentences that can be reached and can act."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import Grammar, Intent, Place, Sentence, Slot, problem_at
from intent_engine.language.language_files import languages_of
from intent_engine.language.loading.grammar_doubts import grammar_doubts
from intent_engine.language.loading.grammar_parts import Draft, Places, Written
from intent_engine.language.loading.grammar_shapes import Shapes
from intent_engine.language.loading.grammar_values import action_problems, example_problems, value_problems
from intent_engine.language.normalize import words_of
from intent_engine.language.numbers.english_words import SUFFIXES
from intent_engine.language.pattern.patterns import pattern_problems
from intent_engine.language.quantities import evaluate
from intent_engine.language.slots.own_units import MAX_NAMES
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.templates.template_tree import Choice, Node, Sequence, references
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["check_meaning"]

MAX_NESTING = 50
"""Phrases in phrases. It bounds every walk through them."""
MAX_WAYS = 10_000
"""Ways to go on after the same words in a sentence. Shipped ones have 213 at most; the automaton gives up at 20,000."""


def check_meaning(grammar: Grammar, places: Places, draft: Draft) -> tuple[list[Problem], list[Problem]]:
    """Problems that make a grammar unusable, and warnings.

    Args:
        grammar: as read; what could not be read is missing in it.
        places: where things stand in the files.
        draft: what could not be read, so that nothing is said to be missing because of it.
    """
    warnings: list[Problem] = []
    problems = [*_language(grammar, places, draft), *_operators(grammar, places), *_alike(grammar, draft)]
    unknown = list(_names(grammar, draft))
    problems += unknown
    circles = list(_recursion(grammar, places))
    problems += circles
    problems += _twice(grammar, warnings)
    if not circles:  # what follows walks through phrases
        shapes = Shapes(grammar)
        problems += _silent(draft, shapes)
        problems += _dictations(grammar, draft)
        if not unknown:  # else a value may name its own slot
            problems += _too_wide(grammar, places, shapes)
            problems += _own_units(grammar, draft)
        sound = not unknown and not draft.blind
        for intent in grammar.intents.values():
            whole = sound and intent.name not in draft.partial
            problems += _sentences(intent, places, shapes, whole=whole, broken=draft.broken)
            given = [{*sentence.fixed, *shapes.labels(sentence.template)} for sentence in intent.all_sentences]
            labels = set[str]().union(*given)
            if whole and not labels & draft.broken:
                problems += value_problems(grammar, intent, labels, places)
                problems += action_problems(grammar, intent, given, places)
                problems += example_problems(grammar, intent, labels)
    problems += pattern_problems(grammar, places, draft.broken if not draft.blind else None)
    if not problems and not draft.blind:
        warnings += grammar_doubts(grammar, draft, places)
    return problems, warnings


# -- the whole ------------------------------------------------------------------------------------------------


def _language(grammar: Grammar, places: Places, draft: Draft) -> Iterator[Problem]:
    operators = grammar.operators
    if not operators.negation or not operators.stop:
        known = languages_of("operators")
        hint = did_you_mean(grammar.language, known)
        yield places.problem(
            ("language",),
            f"how to say 'not' and 'stop' in language {grammar.language!r} is not known",
            hint or f"known are {', '.join(known)}; else give operators: {{negation: [...], stop: [...]}}",
        )
    if not grammar.intents and not draft.blind and not draft.mute:
        message = "there are no intents: nothing can be said"
        yield places.problem((), message, "intents: {wave: {action: custom, sentences: [wave]}}")


def _operators(grammar: Grammar, places: Places) -> Iterator[Problem]:
    """Fillers are dropped before an utterance is read, so none may hold a word that turns its meaning."""
    turning = {
        "says no": PhraseSet(grammar.operators.negation),
        "stops the robot": PhraseSet(grammar.operators.stop),
    }
    for place, text in places.texts("fillers"):
        for what, phrases in turning.items():
            if phrases.find(words_of(text)) is not None:
                message = f"the filler {text!r} {what}; without it a sentence would mean something else"
                yield problem_at(place, message, "remove it from the fillers")
    for intent in grammar.intents.values():
        for state in sorted(intent.requires & intent.excludes):
            message = f"intent {intent.name!r} requires and excludes {state!r}; it could never be done"
            yield places.problem(("intents", intent.name, "excludes"), message, "remove one of them", key=True)


def _names(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Names in braces that nothing has."""
    if draft.blind:
        return
    known = {str(name) for name in (*grammar.slots, *grammar.phrases, *draft.broken)}  # once, if it stands twice
    for written in draft.written:
        for reference in references(written.node):
            name = reference.name
            if written.kind == "slot" and name in grammar.slots:
                message = f"a value of slot {written.name!r} names the slot {name!r}; only phrases can stand there"
                hint = "write the slot beside this one in the sentence"
                yield written.problem(message, hint, reference.column)
            elif name not in known:
                near = did_you_mean(name, sorted(known))
                if reference.label in grammar.slots:  # {far:distance}, the other way round
                    near = f"the slot comes first: {{{reference.label}:{name}}}"
                hint = near or (f"known: {_listed(sorted(known))}" if known else "define it under slots: or phrases:")
                yield written.problem(f"there is no slot or phrase {name!r}", hint, reference.column)
            elif reference.label != name and name in grammar.phrases:
                message = f"{name!r} is a phrase; only slots have a second name"
                yield written.problem(message, f"write {{{name}}}", reference.column)


def _listed(names: list[str], most: int = 12) -> str:
    return ", ".join(names) if len(names) <= most else ", ".join(names[:most]) + ", ..."


def _recursion(grammar: Grammar, places: Places) -> Iterator[Problem]:
    """Phrases that hold themselves, each circle once, and phrases that are nested beyond all use."""
    inner = {
        name: [reference.name for reference in references(node) if reference.name in grammar.phrases]
        for name, node in grammar.phrases.items()
    }
    depth: dict[str, int] = {}
    for root in grammar.phrases:
        trail = {root: iter(inner[root])} if root not in depth else {}
        while trail:
            name = next(reversed(trail))
            other = next(trail[name], None)
            if other is None:
                depth[name] = 1 + max((depth.get(one, 0) for one in inner[name]), default=0)
                del trail[name]
            elif other in trail:
                names = [*trail]
                loop = [*names[names.index(other) :], other]
                message = f"phrases name each other in a circle: {' -> '.join(loop)}"
                hint = "a sentence would never end; write the repetition out"
                if other == name:
                    hint += f", or give the phrase another name than the slot {{{name}}} in it"
                yield places.problem(("phrases", other), message, hint, key=True)
            elif other not in depth:
                trail[other] = iter(inner[other])
    for name, nested in depth.items():
        if nested == MAX_NESTING + 1:
            message = f"phrase {name!r} holds phrases in phrases, more than {MAX_NESTING} deep"
            yield places.problem(("phrases", name), message, "write some of them out", key=True)


# -- words ----------------------------------------------------------------------------------------------------


def _alike(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Values of one choice that are said with the same words."""
    for slot in grammar.slots.values():
        spelled: dict[Node, object] = {}
        for value, node in slot.values:
            for option in node.items if isinstance(node, Choice) else (node,):
                if option in spelled and spelled[option] != value:
                    message = f"slot {slot.name!r}: the same words mean {spelled[option]!r} and {value!r}"
                    yield _written_problem(draft, slot, option, message, "remove one")
                spelled[option] = value


def _own_units(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """Units of a slot that are some already, or are said in too many ways to know them all."""
    for slot in grammar.slots.values():
        sizes: dict[tuple[str, ...], float] = {}
        for size, node in slot.units:
            for option in node.items if isinstance(node, Choice) else (node,):
                names = spellings(option, grammar.phrases, MAX_NAMES + 1)
                known = {words: _known_size(words, slot, sizes, grammar.language) for words in names}
                taken = {words: other for words, other in known.items() if other not in (0.0, size)}
                if len(names) > MAX_NAMES:
                    message = f"slot {slot.name!r}: there are more than {MAX_NAMES} ways to say one unit"
                    yield _written_problem(draft, slot, option, message, "leave some out")
                for words, other in [*taken.items()][:1]:
                    message = f"slot {slot.name!r}: {' '.join(words)!r} is a unit already, of {slot.written(other)}"
                    yield _written_problem(draft, slot, option, message, "call one of them something else")
                sizes.update(dict.fromkeys(names, size))
        if slot.type in ("number", "ordinal") and slot.unit and not slot.units:
            message = f"slot {slot.name!r}: {slot.unit!r} is no unit of {slot.type}s, which are counted as they are"
            hint = f"write it behind the slot in the sentences: {{{slot.name}}} {slot.unit}"
            hint += f"; or give its size: units: {{1: [{slot.unit}]}}" if slot.type == "number" else ""
            yield problem_at(slot.place, message, hint)
        if slot.type == "number" and slot.units and slot.unit and sizes.get(words_of(slot.unit)) != 1:
            message = f"slot {slot.name!r}: a number alone is no number of {slot.unit!r}"
            ones = " or ".join(" ".join(words) for words, size in sizes.items() if size == 1)
            yield problem_at(slot.place, message, f"write unit: {ones}" if ones else "leave unit out: it counts ones")


def _known_size(words: tuple[str, ...], slot: Slot, sizes: Mapping[tuple[str, ...], float], language: str) -> float:
    """The size of a unit that has a name already: one of the slot's own, or one that everybody knows; 0: none has.

    A sign that scales a number is none: who has a "k" in units says "5 k" of these.
    """
    if slot.type == "number" and len(words) == 1 and words[0] in SUFFIXES:
        return sizes.get(words, 0.0)
    known = sizes.get(words) or evaluate(("1", *words), slot.type, language)
    return known if isinstance(known, float) else 0.0


def _written_problem(draft: Draft, slot: Slot, node: Node, message: str, hint: str) -> Problem:
    """A problem at the last place where a slot's value is written so."""
    found: Written | None = None
    for written in draft.written:
        options = written.node.items if isinstance(written.node, Choice) else ()
        if written.kind == "slot" and written.name == slot.name and node in (written.node, *options):
            found = written
    return found.problem(message, hint) if found is not None else problem_at(slot.place, message, hint)


def _silent(draft: Draft, shapes: Shapes) -> Iterator[Problem]:
    """Values of a choice that would be heard in silence."""
    for written in draft.written:
        if written.kind == "slot" and shapes.empty(written.node):
            message = f"a value of slot {written.name!r} can be said without a word"
            yield written.problem(message, "make one word of it necessary")


def _dictations(grammar: Grammar, draft: Draft) -> Iterator[Problem]:
    """What is dictated goes on to the end of what is said."""
    for written in draft.written:
        for reference in references(written.node):
            slot = grammar.slots.get(reference.name)
            if slot is None or not slot.dictation:
                continue
            node = written.node
            parts = node.items if isinstance(node, Sequence) else (node,)
            if written.kind != "sentence" or parts[-1] is not reference:
                message = f"what is dictated goes on to the end, so {{{reference.label}}} must end a sentence"
                yield written.problem(message, "write it last, and outside of brackets and phrases", reference.column)


# -- sentences ------------------------------------------------------------------------------------------------


def _twice(grammar: Grammar, warnings: list[Problem]) -> Iterator[Problem]:
    """The same sentence again: in another intent it is an error, in the same one only useless."""
    first: dict[Node, tuple[Intent, Sentence]] = {}
    for intent in grammar.intents.values():
        for sentence in intent.sentences:
            other, earlier = first.setdefault(sentence.template, (intent, sentence))
            if earlier is sentence:
                continue
            where = _where(earlier.place, sentence.place)
            if other.name == intent.name and dict(earlier.fixed) == dict(sentence.fixed):
                message = f"the same sentence stands already at {where}"
                warnings.append(problem_at(sentence.place, message, "remove one of them"))
            elif _standing(other) == _standing(intent):
                message = f"the same sentence is already in intent {other.name!r} ({where}); it can never be reached"
                yield problem_at(sentence.place, message, "remove one of them")


def _standing(intent: Intent) -> tuple[object, ...]:
    """When an intent is understood beside others that have the same words."""
    return intent.requires, intent.excludes, intent.priority


def _too_wide(grammar: Grammar, places: Places, shapes: Shapes) -> Iterator[Problem]:
    """Sentences that can go on in more ways than can be kept in mind: phrases of optionals of phrases of optionals."""
    begin = 0
    for intent in grammar.intents.values():
        for sentence in intent.all_sentences:
            begin += 1 + shapes.entries(sentence.template)
            if shapes.widest(sentence.template) > MAX_WAYS:
                message = f"there are more than {MAX_WAYS:,} ways to go on after the same words of this sentence"
                hint = (
                    "name fewer phrases that may be empty one after another; long lists of names belong into a map file"
                )
                yield problem_at(sentence.place, message, hint)
    if begin > 2 * MAX_WAYS:
        message = f"there are more than {2 * MAX_WAYS:,} ways to begin a sentence"
        yield places.problem(("intents",), message, "make a slot of what many sentences have in common", key=True)


def _where(place: Place | None, seen_from: Place | None) -> str:
    if place is None:
        return "before"
    here = seen_from is not None and seen_from.file == place.file
    return f"line {place.line}" if here else f"{place.file}:{place.line}"


def _sentences(intent: Intent, places: Places, shapes: Shapes, *, whole: bool, broken: set[str]) -> Iterator[Problem]:
    if whole and not intent.sentences and not intent.regex and intent.lark is None:
        message = f"intent {intent.name!r} has nothing that a person can say"
        yield places.problem(("intents", intent.name), message, "add sentences:, regex: or lark:", key=True)
    for sentence in intent.all_sentences:
        if any(reference.name in broken for reference in references(sentence.template)):
            continue
        if shapes.empty(sentence.template):
            yield problem_at(sentence.place, "every word of this sentence may be left out", "make one necessary")
        elif shapes.free(sentence.template):
            message = "this sentence fits whatever anybody says: it may be nothing but free text"
            yield problem_at(sentence.place, message, "begin it with a word that says what to do")
        for label, count in shapes.labels(sentence.template).items():
            if count > 1:
                message = f"slot {label!r} can be said {count} times in one sentence; only one value would be kept"
                either = f"({{{label}}} ...|... {{{label}}})"
                hint = f"give one of them another name: {{{label}:other}}; or, if only one is ever said, write {either}"
                yield problem_at(sentence.place, message, hint)
