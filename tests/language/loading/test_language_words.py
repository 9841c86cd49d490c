"""The words that every grammar of a language has."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import astuple
from pathlib import Path
from typing import Any

import pytest
import yaml

import intent_engine.language as language_room
from intent_engine.language.loading.language_words import (
    default_another,
    default_around,
    default_booleans,
    default_counted,
    default_counting,
    default_denying,
    default_fillers,
    default_heard,
    default_operators,
    default_opposites,
    default_wording,
)
from intent_engine.language.loading.word_lists import in_full

FILES = sorted((Path(language_room.__file__).parent / "operators").glob("*.yaml"))


def as_they_are(texts: Iterable[str]) -> tuple[tuple[str, ...], ...]:
    return tuple((text,) for text in texts)


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_every_word_of_a_file_is_of_use(file: Path) -> None:
    """A key with a slip in it would be a list that nobody reads."""
    language = file.stem
    used = {word for words in default_operators(language).values() for word in words}
    used.update(default_fillers(language), default_around(language), default_counting(language))
    used.update(default_counted(language), default_another(language), default_denying(language))
    used.update(map("/".join, default_opposites(language)))
    used.update(word for words in (default_booleans(language) or {}).values() for word in words)
    used.update(default_heard(language).meant, default_heard(language).maybe_numbers)
    for held in astuple(default_wording(language, as_they_are)):
        used.update(word if isinstance(word, str) else " ".join(word) for word in held)
    written: dict[str, list[Any]] = yaml.safe_load(file.read_text("utf-8"))
    unused = {key: set(in_full(words)) - used for key, words in written.items()}
    assert not {key: words for key, words in unused.items() if words}
    assert not {word for word in used if not set("()[]|").isdisjoint(word)}


def test_a_language_that_has_no_file() -> None:
    assert default_operators("nl") == {}
    assert default_opposites("nl") == ()
    assert default_booleans("nl") is None
    assert default_another("nl") == {} == default_heard("nl").meant
    assert default_fillers("nl") == default_denying("nl") == default_around("nl") == ()
    assert not any(astuple(default_wording("nl", as_they_are)))
