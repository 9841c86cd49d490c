"""The tree of beginnings, with the decoders of both models on real sound."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.speech.acoustic.moonshine import ScoringMoonshine
from intent_engine.speech.acoustic.moonshine_pieces import BEGINNING
from intent_engine.speech.acoustic.moonshine_weights import moonshine_package
from intent_engine.speech.acoustic.prefix_tree import ROOM, TREES, PrefixTree, RecentTrees
from intent_engine.speech.recognizer import Encoded


@pytest.fixture(scope="module", params=["whisper", "moonshine"])
def known(request, spoken):
    """A decoder, what it hears of "go forward two meters", and what is before every text."""
    if request.param == "whisper":
        whisper = request.getfixturevalue("whisper")
        return whisper._decoder, whisper._spoken(whisper.encode(spoken))[0], whisper.prompt("en")
    if moonshine_package() is None:
        pytest.skip("Moonshine's package is for Linux on x86-64")
    moonshine = ScoringMoonshine()
    return moonshine.model.decoder, moonshine.encode(spoken).features[0], (BEGINNING,)


@pytest.fixture(scope="module")
def decoder(known):
    return known[0]


@pytest.fixture(scope="module")
def plant(known):
    """A new tree for that sound."""
    return lambda: PrefixTree(*known)


pieces = st.lists(st.integers(0, 30_000), min_size=0, max_size=5).map(tuple)


@settings(max_examples=20, deadline=None)
@given(st.lists(pieces, min_size=1, max_size=6), st.randoms(use_true_random=False))
def test_what_is_asked_beside_changes_nothing(plant, beginnings, random):
    """Together, one after the other in any order, and again; but for what rounding to bytes makes of a last digit."""
    together = plant().chances(beginnings)
    assert set(together) == set(beginnings)
    tree = plant()
    for one in random.sample(beginnings, len(beginnings)):
        for _ in range(2):
            np.testing.assert_allclose(tree.chances([one])[one], together[one], atol=0.5, rtol=0.03)
    for row in together.values():
        assert np.exp(row).sum() == pytest.approx(1.0, abs=1e-3)


@settings(max_examples=20, deadline=None)
@given(st.lists(pieces.filter(bool), min_size=1, max_size=6))
def test_a_text_is_as_likely_as_its_pieces(plant, texts):
    tree = plant()
    tree.learn(texts)
    for text in texts:
        rows = tree.chances([text[:place] for place in range(len(text))])
        wanted = [rows[text[:place]][piece] for place, piece in enumerate(text)]
        np.testing.assert_allclose(tree.likelihood(text), wanted, atol=1e-3)
        assert tree.likelihood(text).max() < 1e-3, "nothing is likelier than sure"


def test_a_tree_grows_beyond_its_room(plant):
    many = [(piece, piece + 1) for piece in range(1000, 1000 + ROOM)]
    tree = plant()
    before = tree.chances([many[0]])[many[0]]
    tree.learn([(*one, 0) for one in many])
    np.testing.assert_allclose(tree.chances([many[0]])[many[0]], before, atol=0.5)
    np.testing.assert_allclose(tree.chances([many[-1]])[many[-1]], plant().chances([many[-1]])[many[-1]], atol=0.5)


def test_a_call_that_fails_leaves_nothing_half_known(plant, monkeypatch, decoder):
    tree = plant()
    with monkeypatch.context() as patched:
        patched.setattr(decoder, "telling", None)
        with pytest.raises(AttributeError):
            tree.chances([(400, 500)])
    np.testing.assert_allclose(tree.chances([(400,)])[400,], plant().chances([(400,)])[400,], atol=0.5)


@settings(max_examples=20, deadline=None)
@given(pieces, st.lists(st.integers(0, 30_000), min_size=1, max_size=4))
def test_what_comes_after_a_beginning_is_told_piece_by_piece(plant, beginning, asked):
    tree = plant()
    row = tree.chances([beginning])[beginning]
    np.testing.assert_allclose(tree.after(beginning, asked), row[asked], atol=1e-3)


def test_it_goes_on_as_the_model_would(plant):
    tree = plant()
    found = dict(tree.onward([(), (400, 500)], length=4, end=-1, further=3))
    assert {(), (400,), (400, 500)} <= set(found)
    for start in ((), (400, 500)):
        longest = max((one for one in found if one[: len(start)] == start), key=len)
        for place in range(len(start), len(longest)):
            assert longest[place] == found[longest[:place]].argmax() or longest[: place + 1] == (400, 500)[: place + 1]
    assert max(map(len, found)) == 4, "no longer than it may"
    (first,) = (int(found[()].argmax()) for _ in range(1))
    assert set(dict(tree.onward([()], length=4, end=first, further=3))) == {()}, "not beyond the end"


def test_of_the_last_sounds_it_is_kept_what_was_asked(known):
    _, features, prompt = known
    sounds = [Encoded(features[np.newaxis], 1.0) for _ in range(TREES + 1)]
    trees, plant = RecentTrees(), lambda: PrefixTree(*known)
    first = [trees.of(sound, prompt, plant) for sound in sounds[:TREES]]
    assert [trees.of(sound, prompt, plant) for sound in sounds[:TREES]] == first
    trees.of(sounds[TREES], prompt, plant)
    assert trees.of(sounds[1], prompt, plant) is first[1]
    assert trees.of(sounds[0], prompt, plant) is not first[0], "the oldest is forgotten"
    longer = (*prompt, 5)
    other = trees.of(sounds[0], longer, lambda: PrefixTree(*known[:2], longer))
    assert other is not trees.of(sounds[0], prompt, plant)
    assert trees.of(sounds[0], longer, plant) is other
