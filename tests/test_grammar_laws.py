"""Laws that hold whatever the grammar, over grammars that are drawn at random.

A sentence is made from its meaning, the words of it are moved and changed, and the grammar is written in another way
that says the same.
"""

from __future__ import annotations

import json
import random
import threading
from collections.abc import Callable, Iterator
from copy import deepcopy
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import HealthCheck, given, reject, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.errors import ConfigError
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.sampler import Sample, Sampler
from intent_engine.testing import differences, moves

Spec = dict[str, Any]
VERBS = ("go", "take", "turn", "polish", "set", "mend")
WORDS = ("to", "two", "the", "left", "right", "lamp", "for", "box", "on", "light", "water", "up", "back", "half", "one")
SLOTS: Spec = {
    "count": {"type": "number", "min": 1, "max": 99},
    "far": {"type": "distance"},
    "walk": {"type": "distance", "units": {"30 cm": ["step", "steps"]}, "max": "90 m"},
    "bend": {"type": "angle", "unit": "deg"},
    "span": {"type": "duration"},
    "part": {"type": "percent", "min": 0.01, "max": 1.0},
    "nth": {"type": "ordinal"},
    "pace": {"type": "speed"},
    "lit": {"type": "boolean"},
    "colour": ["red", "light blue", "green"],
    "size": {"type": "choice", "values": {"small": ["small", "tiny"], "large": ["(big|huge) [old]"]}},
    "what": {"type": "text", "max_words": 2},
    "thing": {"type": "text", "max_words": 3, "allow": ["and"], "without": ["lamp"]},
    "kept": {"type": "object", "known": ["red cup", "box"]},
    "where": {"type": "location"},
}
FREE = ("what", "thing", "kept")
PLACES = {"bay 3": (1.0, 2.0, 0.0), "loading dock": (3.0, 2.0, 0.0), "attic": (0.0, 0.0, 0.0)}
NOT_SAID_TO_BE_DONE = (
    *("don't {}", "never {}", "please do not {}", "I don't want you to {}", "you must not {}", "no need to {}"),
    *("do you {}?", "did you {}?", "why do you {}?", "should I {}?", "have you ever seen a robot {}"),
    *("if you {}", "unless it rains, {}", "what happens if you {}", "when I say so, {}", "I was going to {}"),
    *("he told me to {}", '"{}" is what she said', "it would be wrong to {}", "yesterday you {}"),
)


def template(draw: random.Random, depth: int, names: list[str]) -> str:
    def inner() -> str:
        return template(draw, depth - 1, names)

    kind = draw.random()
    if depth == 0 or kind < 0.35:
        return draw.choice(names) if names and draw.random() < 0.4 else draw.choice(WORDS)
    if kind < 0.55:
        return f"{inner()} {inner()}"
    if kind < 0.72:
        return f"[{inner()}]"
    return f"({inner()}|{inner()})" if kind < 0.88 else f"({inner()};{inner()})"


def grammar(draw: random.Random) -> Spec:
    chosen = draw.sample(sorted(SLOTS), 3)
    spare = [name for name in chosen if name in FREE][1:]  # two free texts in a row can be parted in two ways
    slots = {name: SLOTS[name] for name in chosen if name not in spare}
    phrases = {"inner": template(draw, 2, []), "outer": template(draw, 2, ["{inner}"])}
    names = ["{inner}", "{outer}", *(f"{{{name}}}" for name in slots)]
    spec: Spec = {"language": "en", "slots": slots, "phrases": phrases, "intents": {}}
    if draw.random() < 0.5:
        spec["fillers"] = draw.choice([[], ["please"], ["please", "could you"]])
    for number in range(draw.randint(1, 3)):
        verb = VERBS[number] if draw.random() < 0.85 else draw.choice(VERBS)
        said = [f"{verb} {template(draw, draw.randint(1, 3), names)}" for _ in range(draw.randint(1, 2))]
        intent: Spec = {"action": {"type": "custom", "name": f"do{number}"}, "sentences": said}
        if draw.random() < 0.2:
            intent["priority"] = draw.randint(-3, 3)
        if draw.random() < 0.15:
            intent["then"] = [f"and {template(draw, 1, names)}"]
        if draw.random() < 0.15:
            intent["regex"] = f"{verb}ing (up|down)"
        spec["intents"][f"intent{number}"] = intent
    return spec


def loaded(spec: Spec, **others: Spec) -> IntentEngine:
    """The engine of a grammar, with others beside it that it may include."""
    with TemporaryDirectory() as folder:
        for name, each in {**others, "own": spec}.items():
            Path(folder, f"{name}.yaml").write_text(json.dumps(each), "utf-8")  # JSON is YAML
        return IntentEngine.from_files(Path(folder, "own.yaml"), locations=PLACES)


def made(draw: random.Random) -> tuple[Spec, IntentEngine, Sampler]:
    spec = grammar(draw)
    try:
        engine = loaded(spec)
    except ConfigError:  # "[go]" alone, two free texts in a row: such is refused
        reject()
    sampler = Sampler(engine.grammar, engine.locations)
    if not sampler.intents:
        reject()
    return spec, engine, sampler


class Choices:
    def __init__(self, draw: random.Random) -> None:
        self._draw = draw

    def below(self, count: int) -> int:
        return self._draw.randrange(count) if count > 1 else 0


def drawn(sampler: Sampler, draw: random.Random, count: int) -> Iterator[Sample]:
    for _ in range(count):
        if (sample := sampler.attempt(Choices(draw))) is not None:
            yield sample


def law(few: int, many: int, sentences: int) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """A law of a grammar, its engine and its sampler; ``sentences`` are drawn from each of the grammars."""

    def decorate(function: Callable[..., None]) -> Callable[..., None]:
        @pytest.mark.parametrize("grammars", [few, pytest.param(many, marks=pytest.mark.slow)])
        def test(grammars: int) -> None:
            @settings(max_examples=grammars, deadline=None, suppress_health_check=list(HealthCheck))
            @given(st.randoms(use_true_random=False))  # which shrinks
            def holds(draw: random.Random) -> None:
                spec, engine, sampler = made(draw)
                function(spec, engine, drawn(sampler, draw, sentences), draw)

            holds()

        test.__doc__ = function.__doc__
        return test

    return decorate


def meaning(found: Interpretation) -> tuple[Any, ...]:
    """What is ambiguous has the name and the slots of the first of its ways, and that is a matter of their order."""
    first = found.status is Status.AMBIGUOUS
    return found.status, None if first else found.intent, {} if first else found.slots, found.actions


def said_without_slots(spec: Spec, sample: Sample, found: Interpretation) -> bool:
    """Whether a sentence can be said in two ways, and was taken for the one with fewer slots: "one one" of
    "[{count}] one [one]"."""
    text = json.dumps(spec)
    for name in sample.slots.keys() - found.slots.keys():
        text = text.replace(f"{{{name}}}", "zebra")
    other = loaded(json.loads(text)).parse(sample.text)
    return len(found.slots) < len(sample.slots) and meaning(other) == meaning(found)


# -- sentences ----------------------------------------------------------------------------------------------------


@law(few=60, many=600, sentences=4)
def test_a_sentence_means_what_it_was_made_from_however_it_is_written(spec, engine, samples, draw):
    for sample in samples:
        found = engine.parse(sample.text)
        wanted = Interpretation(sample.text, Status.ACCEPTED, sample.intent, sample.slots, sample.actions)
        if found.status is Status.ACCEPTED and found.intent == sample.intent:
            different = differences(found, wanted)
            assert not different or said_without_slots(spec, sample, found), sample.text
        else:  # two intents say the same
            assert found.status is not Status.INCOMPLETE, sample.text
        words = sample.text
        for text in (words.upper(), words.title(), words.replace(" ", "  "), f"\t{words} ", f"{words}.", f"{words}!"):
            assert meaning(engine.parse(text)) == meaning(found), text
        for begin, end in ('""', "“”", "''"):
            assert engine.parse(f"{begin}{words}{end}").actions in ((), found.actions), text


@law(few=40, many=500, sentences=3)
def test_what_is_not_said_to_be_done_is_not_done(spec, engine, samples, draw):
    for sample in samples:
        for form in NOT_SAID_TO_BE_DONE:
            assert not moves(engine.parse(form.format(sample.text))), form.format(sample.text)


@law(few=50, many=600, sentences=4)
def test_words_left_out_added_or_in_another_order_act_only_as_a_sentence_of_the_grammar(spec, engine, samples, draw):
    matcher = engine.matcher()
    for sample in samples:
        words = sample.text.split()
        at = draw.randrange(len(words))
        others = [words[:-1], words[1:], [*words[:at], *words[at + 1 :]], draw.sample(words, len(words))]
        others += [[*words[:at], extra, *words[at:]] for extra in ("zebra", "seven", "under")]
        for said in others:
            found = engine.parse(" ".join(said))
            if moves(found) and said:
                heard = matcher.heard(found.reason.partition(" as '")[2].rstrip("'") or " ".join(said))
                patterns = any("regex" in intent for intent in spec["intents"].values())
                assert patterns or matcher.read(heard.words) or found.intent == "compound", said


@law(few=50, many=600, sentences=4)
def test_of_two_commands_both_are_done_in_order_or_none(spec, engine, samples, draw):
    said = [(sample.text, engine.parse(sample.text).actions) for sample in samples if sample.intent != "compound"]
    for (one, first), (other, second) in pairwise(said):
        for joint in ("and", "then", "and then"):
            text = f"{one} {joint} {other}"
            as_one = engine.matcher().read(engine.matcher().heard(text).words)
            opens = (*one.split(), *joint.split()) in engine.grammar.fillers  # "go on and", though one may go on
            done = second if opens else first + second
            assert as_one or engine.parse(text).actions in ((), done), text
        for no in ("no,", "I mean", "no wait", "sorry,"):
            assert len(engine.parse(f"{one} {no} {other}").actions) < 2, f"{one} {no} {other}"


@law(few=50, many=600, sentences=4)
def test_what_a_sentence_begins_with_goes_on_with_its_next_word(spec, engine, samples, draw):
    for sample in samples:
        words = sample.text.split()
        for count in range(1, len(words)):
            begun = engine.prefix(" ".join(words[:count]))
            assert begun.status in (PrefixStatus.INCOMPLETE, PrefixStatus.EXTENDABLE), words[:count]
            plain = [word for word in begun.next_words if word[0] != "<"]
            if plain:
                longer = " ".join([*words[:count], draw.choice(plain)])
                assert engine.prefix(longer).status is not PrefixStatus.IMPOSSIBLE, longer


# -- the same grammar written in another way ------------------------------------------------------------------------


def asked(samples: Iterator[Sample], draw: random.Random) -> list[str]:
    """Sentences, what is almost one, and several."""
    texts: list[str] = []
    for sample in samples:
        words = sample.text.split()
        texts += [sample.text, " ".join(words[:-1]), f"{sample.text} {draw.choice(WORDS)}"]
        texts.append(" ".join(draw.sample(words, len(words))))
        texts += [f"{sample.text} {joint} {texts[0]}" for joint in ("and then", "no", "")]
    return texts


def renamed(spec: Spec, kind: str) -> Spec:
    """The grammar with other names for its phrases or slots."""
    text = json.dumps(spec)
    for name in spec[kind]:
        text = text.replace(f"{{{name}}}", f"{{other_{name}}}").replace(f'"{name}": ', f'"other_{name}": ')
    return json.loads(text)


def reordered(spec: Spec) -> Spec:
    other = deepcopy(spec)
    for key in ("intents", "slots", "phrases"):
        other[key] = dict(reversed(other[key].items()))
    for intent in other["intents"].values():
        intent["sentences"].reverse()
    return other


def without_phrases(spec: Spec) -> Spec:
    """Each phrase written out where it is named; two sentences that are one then are refused."""
    phrases = spec["phrases"]
    text = json.dumps({key: part for key, part in spec.items() if key != "phrases"})
    for name in ("outer", "inner"):
        text = text.replace(f"{{{name}}}", f"({phrases[name]})")
    return json.loads(text)


@law(few=25, many=300, sentences=3)
def test_how_a_grammar_is_written_changes_no_meaning(spec, engine, samples, draw):
    texts = asked(samples, draw)
    expected = [meaning(engine.parse(text)) for text in texts]
    more = {"intents": {"more": {"action": "custom", "sentences": ["transmogrify the apple"]}}}
    others = {
        "in another order": loaded(reordered(spec)),
        "included": loaded({"language": "en", "include": "inner.yaml"}, inner=spec),
        "with an intent more": loaded({"language": "en", "include": "inner.yaml", **more}, inner=spec),
        "phrases renamed": loaded(renamed(spec, "phrases")),
    }
    try:
        others["phrases written out"] = loaded(without_phrases(spec))
    except ConfigError:  # "go {inner}" and "go to": one sentence of two intents
        reject()
    for how, other in others.items():
        assert [meaning(other.parse(text)) for text in texts] == expected, how
    other = loaded(renamed(spec, "slots"))
    back = [json.loads(json.dumps(other.parse(text).to_json()).replace("other_", "")) for text in texts]
    assert [meaning(Interpretation.from_json(found)) for found in back] == expected


@law(few=25, many=300, sentences=3)
def test_the_same_text_means_the_same_whenever_and_wherever_it_is_asked(spec, engine, samples, draw):
    texts = asked(samples, draw)
    expected = {text: engine.parse(text) for text in texts}
    fresh = loaded(spec)
    found: list[list[tuple[str, Interpretation]]] = [[] for _ in range(4)]

    def ask(number: int) -> None:
        order = random.Random(number).sample(texts, len(texts))
        found[number] = [(text, fresh.parse(text)) for text in order]

    threads = [threading.Thread(target=ask, args=(number,)) for number in range(len(found))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for answers in found:
        assert len(answers) == len(texts)
        assert all(expected[text] == answer for text, answer in answers)
    for text, answer in expected.items():
        assert engine.explain(text).interpretation == answer == engine.parse(text)
        assert Interpretation.from_json(json.loads(json.dumps(answer.to_json()))) == answer
