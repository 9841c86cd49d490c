"""Quantities to words: every way to say one has its value."""

from __future__ import annotations

import math

import pytest

from intent_engine.language import quantities
from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.normalize import tokenize
from intent_engine.language.quantities import Relative
from intent_engine.language.sampling.spoken_quantities import spoken_forms


@pytest.mark.parametrize("language", ["en", "de", "es", "fr", "it"])
@pytest.mark.parametrize("kind", QUANTITY_KINDS)
def test_every_spelling_of_a_quantity_has_its_value(kind, language):
    unit = {"distance": "m", "angle": "deg"}.get(kind)
    forms = spoken_forms(kind, language, unit, None, None)
    assert forms
    wrong = []
    for form in forms:
        for text, value in form[:: 1 if len(form) < 300 else 7]:
            found = quantities.evaluate([token.word for token in tokenize(text)], kind, language, unit)
            if isinstance(value, Relative) or isinstance(found, Relative) or found is None:
                same = found == value
            else:
                same = math.isclose(found, value, rel_tol=1e-9)
            if not same:
                wrong.append((text, value, found))
    assert not wrong


def test_limits_hold_for_spellings():
    for form in spoken_forms("distance", "en", None, 0.5, 3.0):
        assert all(0.5 <= value <= 3.0 for _, value in form)
    assert spoken_forms("distance", "tlh", None, None, None) == ()
