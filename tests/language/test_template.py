"""The sentence-template language: trees print and parse back, and any other text is told what is wrong with it."""

from __future__ import annotations

import dataclasses

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from templates import trees

from intent_engine.language.template import TemplateError, parse_template, parsed_by_lark
from intent_engine.language.templates.template_reader import read_template
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
    references,
    template_text,
)

A, B, C = Word("a"), Word("b"), Word("c")

TREES = [
    ("a", A),
    ("  a  ", A),
    ("A", A),
    ("a b", Sequence((A, B))),
    ("(a)", A),
    ("((a))", A),
    ("a|b", Choice((A, B))),
    ("(a|b) c", Sequence((Choice((A, B)), C))),
    ("a (b|c)", Sequence((A, Choice((B, C))))),
    ("[a] b", Sequence((Optional(A), B))),
    ("[a|b]", Optional(Choice((A, B)))),
    ("[a b] c", Sequence((Optional(Sequence((A, B))), C))),
    ("(a;b)", AnyOrder((A, B))),
    ("[a; b; c]", Optional(AnyOrder((A, B, C)))),
    ("(a b; [c])", AnyOrder((Sequence((A, B)), Optional(C)))),
    ("don't go", Sequence((Sequence((Word("do"), Word("not"))), Word("go")))),
    ("let's", Word("lets")),
    ("90°", Sequence((Word("90"), Word("degrees")))),
    ("2.5 m", Sequence((Word("2.5"), Word("m")))),
    ("{#} {#word}", Sequence((WordClass("#"), WordClass("#word")))),
    ("café, please!", Sequence((Word("café"), Word("please")))),
]


@pytest.mark.parametrize(("text", "tree"), TREES, ids=[text for text, _ in TREES])
def test_text_is_a_tree(text, tree):
    assert parse_template(text) == tree


def test_names_keep_their_place():
    node = parse_template("go {place} [at {speed:how_fast}]")
    assert list(references(node)) == [Reference("place", "place", 4), Reference("speed", "how_fast", 16)]


def unplaced(node: Node) -> Node:
    """A tree without the columns of its names."""
    if isinstance(node, Reference):
        return dataclasses.replace(node, column=0)
    if isinstance(node, Optional):
        return Optional(unplaced(node.item))
    if isinstance(node, (Sequence, Choice, AnyOrder)):
        return type(node)(tuple(unplaced(item) for item in node.items))
    return node


@given(trees(names=("place", "größe")))
def test_a_tree_prints_and_parses_back(tree):
    assert unplaced(parse_template(template_text(tree))) == tree


@given(st.text(alphabet=st.sampled_from("ab1 ()[]{}|;:#'-_.°<>$@*\\\n\t\"é½"), max_size=40) | st.text(max_size=40))
@example("(" * 5000)
@example("a|" * 5000 + "a")
@example("[a]" * 3000)
@example("{" + "a" * 10_000 + "}")
@example("a" * 100_000)
@example("½")
@example("İ")
def test_any_text_is_a_tree_or_is_told_what_is_wrong(text):
    try:
        node: Node | TemplateError = parse_template(text)
    except TemplateError as error:
        node = error
    if isinstance(node, TemplateError):
        assert node.message
        assert 0 <= node.column <= len(text)
    else:
        assert template_text(node)


SIGNS = "ab1 ()[]{}|;:#'-_.°\n\té½!"
PIECES = [
    "a",
    "don't",
    "90°",
    "!",
    " ",
    "(",
    ")",
    "[",
    "]",
    "|",
    ";",
    "{a}",
    "{ a : b }",
    "{#}",
    "{#word}",
    "{a:}",
    "{",
]


@given(
    st.text(alphabet=st.sampled_from(SIGNS), max_size=30)
    | st.lists(st.sampled_from(PIECES), max_size=12).map("".join)
    | trees(names=("place", "größe"), leaves=12).map(template_text)
)
@example("(a;b|c)")
@example("(a|b;c)")
@example("[a;b;c;d;e;f]")
@example("[a;b;c;d;e;f;g]")
@example("{ #word }{a}b")
@example("((a b)|[c])")
def test_the_quick_reader_knows_the_language_that_lark_knows(text):
    """The same tree, and neither more nor fewer texts."""
    try:
        tree: Node | None = parsed_by_lark(text)
    except TemplateError:
        tree = None
    assert read_template(text) == tree


WRONG = [
    ("", 0, "an empty sentence"),
    ("go (left", 3, "'(' is never closed"),
    ("go left)", 7, "')' closes nothing"),
    ("go (left]", 8, "']' does not close the '('"),
    ("go (left|)", 9, "')' cannot stand here"),
    ("go {}", 4, "'}' cannot stand here"),
    ("go {a b}", 6, "'b' cannot stand here"),
    ("go {1st}", 4, "'1st' cannot stand here"),
    ("go {a:}", 6, "'}' cannot stand here"),
    ("go; left", 2, "';' cannot stand here"),
    ("go !", 3, "'!' is no word"),
    ("go $place", 3, "'$' is no part of a word"),
    ("go #", 3, "'#' is no part of a word"),
    ("(a;b;c;d;e;f;g)", 1, "more than 6 parts"),
    ("a " * 10_001, 0, "a sentence of 20,002 characters"),
    ("[" * 41 + "a" + "]" * 41, 40, "nested deeper than 40"),
]


@pytest.mark.parametrize(("text", "column", "message"), WRONG, ids=[text[:12] or "empty" for text, _, _ in WRONG])
def test_what_is_wrong_is_told_where_it_stands(text, column, message):
    with pytest.raises(TemplateError) as caught:
        parse_template(text)
    assert message in caught.value.message
    assert caught.value.column == column
    assert caught.value.hint
