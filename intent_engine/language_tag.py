"""Names of languages as people and systems write them."""

from __future__ import annotations

import re

__all__ = ["code_of", "language_of"]

_TAG = re.compile(r"([a-z]{2,3})(?:[-_][a-z0-9]{1,8})*", re.IGNORECASE | re.ASCII)
"""BCP 47, with the underscore of POSIX too; what is longer than three letters is no language that anybody speaks."""


def language_of(tag: str) -> str:
    """The language of a tag, by which grammars are found: ``en`` of ``en-US``; what is no tag, as it is."""
    found = _TAG.fullmatch(tag)
    return found[1].lower() if found else tag


_NAMES = {
    "de": ("german", "deutsch", "allemand", "alemán", "tedesco"),
    "en": ("english", "englisch", "anglais", "inglés", "inglese"),
    "es": ("spanish", "español", "castellano", "spanisch"),
    "fr": ("french", "français", "französisch"),
    "it": ("italian", "italiano", "italienisch"),
    "nl": ("dutch", "nederlands", "niederländisch"),
    "pl": ("polish", "polski", "polnisch"),
    "pt": ("portuguese", "português", "portugiesisch"),
}


def code_of(name: str) -> str | None:
    """The tag of a language that somebody called by its name, to be told of; None: no name is known so."""
    said = name.strip().lower()
    return next((code for code, names in _NAMES.items() if said in names), None)
