"""The engine from the outside: what it takes and what it does not."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.language.slot_values import NamesOf


@pytest.fixture(scope="module")
def engine(root) -> IntentEngine:
    return IntentEngine.from_files(root / "grammars" / "en.yaml", locations=root / "locations" / "home.yaml")


@pytest.mark.parametrize("method", ["parse", "explain", "prefix", "dictated"])
@pytest.mark.parametrize(
    ("given", "kind"), [(None, "NoneType"), (5, "int"), (b"stop", "bytes"), (["stop"], "list")], ids=repr
)
def test_what_is_no_text_is_refused_by_its_type(engine, method, given, kind):
    with pytest.raises(TypeError, match=f"^{method} takes a str, not {kind}$"):
        getattr(engine, method)(given)


def test_places_are_listed_when_one_is_asked_for_and_not_while_the_files_load(root, monkeypatch):
    listed = []
    names = NamesOf.__iter__
    monkeypatch.setattr(NamesOf, "__iter__", lambda self: listed.append(self) or names(self))
    engine = IntentEngine.from_files(root / "grammars" / "en.yaml", locations=root / "locations" / "home.yaml")
    assert engine.parse("stop").stops
    assert not listed, "a map may have ten thousand places"
    assert engine.parse("go to the kitchen").actions
    assert listed
