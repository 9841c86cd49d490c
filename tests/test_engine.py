"""The engine from the outside: what it takes and what it does not."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine


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
