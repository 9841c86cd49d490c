"""Words that mean the opposite of each other."""

from __future__ import annotations

import pytest

from intent_engine.language.loading.language_words import default_opposites
from intent_engine.language.normalize import tokenize
from intent_engine.language.words.opposites import opposed


@pytest.mark.parametrize(
    ("word", "other", "language"),
    [("on", "off", None), ("off", "on", "en"), ("auf", "zu", "de"), ("éteins", "allume", "fr"), ("giù", "su", "it")],
)
def test_the_opposite_of_a_word_in_its_language(word, other, language):
    assert other in opposed(word, language)


@pytest.mark.parametrize(
    ("language", "pairs"),
    [
        ("en", "first last, opened closed, hot cold, north south, before after, lock unlock, enable disable"),
        ("de", "erste letzte, geöffnet geschlossen, heiß kalt, norden süden, sperre entsperre, aktiviere deaktiviere"),
        ("fr", "premier dernier, ouvert fermé, chaud froid, nord sud, avant après, verrouille déverrouille"),
        ("es", "primero último, abierto cerrado, caliente frío, norte sur, antes después, bloquea desbloquea"),
        ("it", "primo ultimo, aperto chiuso, caldo freddo, nord sud, prima dopo, blocca sblocca, attiva disattiva"),
    ],
)
def test_every_language_has_the_common_ones(language, pairs):
    for one, other in map(str.split, pairs.split(",")):
        assert other in opposed(one, language)


def test_none_is_known_of_other_words_and_languages():
    assert not opposed("kitchen")
    assert not opposed("on", "nl")


@pytest.mark.parametrize("language", ["en", "de", "fr", "es", "it"])
def test_every_word_is_as_texts_are_compared_and_opposes_what_opposes_it(language):
    pairs = default_opposites(language)
    assert pairs
    for word in (word for pair in pairs for word in pair):
        others = opposed(word, language)
        assert [token.word for token in tokenize(word)] == [word]
        assert others
        assert word not in others
        assert all(word in opposed(other, language) for other in others)
