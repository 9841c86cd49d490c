"""What is known of a template before it is said, against the automaton and every way to say it."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st
from templates import trees

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Status
from intent_engine.language.grammar import ActionSpec, Grammar, Intent, Operators, Sentence, Slot
from intent_engine.language.loading.grammar_shapes import Shapes
from intent_engine.language.networks.exploration import explore
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.templates.template_tree import Choice, Node, Optional, Reference, Sequence, Word, references

PHRASES: dict[str, Node] = {
    "p": Choice((Word("x"), Sequence((Word("y"), Optional(Word("z")))))),
    "q": Optional(Sequence((Reference("p", "p", 0), Optional(Reference("p", "p", 0))))),
}


def grammar(*templates: Node) -> Grammar:
    slots = {"s": Slot("s", "text", max_words=1)}
    intent = Intent("i", ActionSpec("custom", "i"), tuple(Sentence("", node) for node in templates))
    return Grammar("en", (), PHRASES, slots, {"i": intent}, Operators(negation=(("not",),), stop=(("stop",),)))


def plain(node: Node) -> bool:
    """Whether names in a template stand under their own name alone, and no word class does."""
    return all(reference.name == reference.label for reference in references(node))


TREES = trees(("a", "b", "c"), names=("p", "q", "s"), leaves=6).filter(plain)


@settings(max_examples=100, deadline=None)
@given(trees(("a", "b", "c"), leaves=6))
def test_a_template_is_empty_if_it_can_be_said_so(template):
    ways = spellings(template, {}, 100_000)
    assert Shapes(grammar()).empty(template) == (() in ways)
    assert not Shapes(grammar()).free(template) or () in ways


@settings(max_examples=100, deadline=None)
@given(TREES)
def test_free_templates_hold_no_word_that_must_be_said(template):
    shapes = Shapes(grammar())
    assert not shapes.empty(template) or shapes.free(template)
    assert shapes.free(Reference("s", "s", 0))
    assert not shapes.free(Sequence((template, Word("a"))))


@settings(max_examples=80, deadline=None)
@given(st.lists(TREES, min_size=1, max_size=3))
def test_the_automaton_is_never_wider_than_was_said(templates):
    """The ways to go on are at most those of all sentences together, from each of the words that may have led there."""
    shapes = Shapes(grammar())
    words = 12  # places of a template that one word can lead to: it has at most six leaves
    bound = sum(words * (1 + max(shapes.widest(node), shapes.entries(node))) for node in templates)
    assert explore(grammar(*templates), None).widest <= bound


@settings(max_examples=100, deadline=None)
@given(TREES.filter(lambda node: "WordClass" not in repr(node)))  # which has no spellings
def test_a_slot_is_always_said_if_it_is_so_in_every_way_to_say_it(template):
    ways = spellings(template, {**PHRASES, "s": Word("?")}, 100_000)
    assert Shapes(grammar()).always(template) == ({"s"} if all("?" in way for way in ways) else set())


def test_labels_are_counted_along_one_way():
    shapes = Shapes(grammar())
    said = Reference("s", "s", 0)
    assert shapes.labels(Choice((said, Sequence((said, said))))) == {"s": 2}
    assert shapes.labels(Sequence((Optional(said), Reference("s", "t", 0)))) == {"s": 1, "t": 1}


def test_a_grammar_that_nobody_checked_rejects_what_it_cannot_walk():
    """A program may make a grammar of its own; still no text raises, and stop stops."""
    doubled: dict[str, Node] = {"p0": Optional(Word("x"))}
    for number in range(1, 41):
        doubled[f"p{number}"] = Sequence((Reference(f"p{number - 1}", "", 0),) * 2)
    wide = replace(grammar(Sequence((Word("wave"), Reference("p40", "", 0)))), phrases=doubled)
    engine = IntentEngine([wide])
    for text in ("wave", "wave x", "wave x x x"):
        found = engine.parse(text)
        assert (found.status, found.actions) == (Status.REJECTED, ())
        assert found.reason.startswith("the grammar is too ambiguous")
        assert engine.prefix(text).status is PrefixStatus.IMPOSSIBLE
    assert engine.parse("stop").actions == (Stop(),)
