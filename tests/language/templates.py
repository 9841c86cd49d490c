"""Random templates, for laws about all of them."""

from __future__ import annotations

from hypothesis import strategies as st

from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
)

WORDS = ("go", "left", "two", "2.5", "straße", "1/2", "um")


def trees(words: tuple[str, ...] = WORDS, names: tuple[str, ...] = (), leaves: int = 8) -> st.SearchStrategy[Node]:
    """Trees as the parser makes them: no group of one part, no class but those that there are."""
    leaf: st.SearchStrategy[Node] = st.sampled_from(words).map(Word)
    if names:
        named = st.builds(Reference, st.sampled_from(names), st.just(""), st.just(0))
        leaf = st.one_of(
            leaf,
            named.map(lambda one: Reference(one.name, one.name, 0)),
            named.map(lambda one: Reference(one.name, one.name + "_2", 0)),
            st.sampled_from(("#", "#word")).map(WordClass),
        )

    def grown(inner: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
        parts = st.lists(inner, min_size=2, max_size=3).map(tuple)
        return st.one_of(parts.map(Sequence), parts.map(Choice), parts.map(AnyOrder), inner.map(Optional))

    return st.recursive(leaf, grown, max_leaves=leaves)
