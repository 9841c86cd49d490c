"""Property tests of a grammar of one's own. Run: ``pytest examples/my_grammar``."""

from pathlib import Path

from hypothesis import given

from intent_engine import IntentEngine
from intent_engine.testing import assert_means, moves, sentences

engine = IntentEngine.from_files(Path(__file__).parent / "lamp.yaml")


@given(sentences(engine, noise=["fillers", "spelling"]))
def test_every_sentence_means_what_it_says(case):
    assert_means(engine.parse(case.text), case.expected)


@given(sentences(engine, noise="negation"))
def test_what_is_negated_does_nothing(case):
    assert not moves(engine.parse(case.text))
