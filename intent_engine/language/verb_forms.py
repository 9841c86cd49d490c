"""Verbs as they tell of something ("opens", "activated", "pausing"), where a command says "open", and as they are
forbidden and ended ("non *girare*"), where a command says "gira"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from intent_engine.language.grammar import Grammar

__all__ = ["told_forms_of", "verbs_told"]

ENDINGS = (("s", ""), ("es", ""), ("ies", "y"), ("d", ""), ("ed", ""), ("ied", "y"), ("ing", ""), ("ing", "e"))
"""How English verbs end that tell of something, and how the verb itself ends there."""
LEAST_LETTERS = 2
IRREGULAR = {"led": "lead"}
"""Forms that sound like the verb itself, or nearly, and have no such ending."""


def told_forms_of(word: str, language: str) -> Iterator[str]:
    """The verbs of which a word may be such a form: of "stopped" these are "stopp", which is none, and "stop". None in
    other languages than English."""
    if language == "en" and word in IRREGULAR:
        yield IRREGULAR[word]
    for ending, own in ENDINGS if language == "en" else ():
        stem = word.removesuffix(ending)
        if stem == word or len(stem) < LEAST_LETTERS:
            continue
        yield stem + own
        if ending in ("ed", "ing") and not own and stem[-1] == stem[-2]:
            yield stem[:-1]


def verbs_told(words: Sequence[str], grammar: Grammar) -> Iterator[tuple[int, str]]:
    """Of how many of the words, from the first on, a verb is a form, and that verb as it is told: of "girare" it is
    "gira". Some of them are none."""
    for *form, verb in grammar.wording.forbidden:
        *before, ending = form
        if len(words) < len(form) or list(words[: len(before)]) != before:
            continue
        said = words[len(before)]
        if not ending.startswith("-"):
            if said == ending:
                yield len(form), verb
            continue
        stem = said.removesuffix(ending[1:])
        if said.endswith(ending[1:]) and len(stem) >= LEAST_LETTERS:
            yield len(form), stem + verb.removeprefix("-")
