"""Verbs as they tell of something ("opens", "activated", "pausing"), where a command says "open", and as they are
forbidden and ended ("non *girare*"), where a command says "gira"."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Mapping, Sequence

from intent_engine.language.grammar import Grammar

__all__ = ["IRREGULAR", "NEARLY_THE_VERB", "infinitives", "told_forms_of", "verbs_of", "verbs_told", "without_stress"]

ENDINGS = (("s", ""), ("es", ""), ("ies", "y"), ("d", ""), ("ed", ""), ("ied", "y"), ("ing", ""), ("ing", "e"))
"""How English verbs end that tell of something, and how the verb itself ends there."""
LEAST_LETTERS = 2
_ACUTE = "\N{COMBINING ACUTE ACCENT}"
_VOWELS = frozenset("aeiouáéíóúàèìòù")
NEARLY_THE_VERB: Mapping[str, str] = {
    "led": "lead", "sent": "send", "bent": "bend", "built": "build", "lent": "lend", "spent": "spend",
}  # fmt: skip
"""English forms without such an ending that sound like the verb itself, or nearly,"""
IRREGULAR: Mapping[str, tuple[str, ...]] = {
    "begin": ("began", "begun"), "blow": ("blew", "blown"), "break": ("broke", "broken"), "bring": ("brought",),
    "buy": ("bought",), "catch": ("caught",), "choose": ("chose", "chosen"), "come": ("came",), "dig": ("dug",),
    "dive": ("dove",), "do": ("did", "done"), "draw": ("drew", "drawn"), "drive": ("drove", "driven"),
    "fall": ("fell", "fallen"), "feed": ("fed",), "find": ("found",), "fly": ("flew", "flown"),
    "freeze": ("froze", "frozen"), "get": ("got", "gotten"), "give": ("gave", "given"), "go": ("went", "gone"),
    "grind": ("ground",), "hang": ("hung",), "hold": ("held",), "keep": ("kept",), "light": ("lit",),
    "make": ("made",), "pay": ("paid",), "ride": ("rode", "ridden"), "ring": ("rang", "rung"),
    "rise": ("rose", "risen"), "run": ("ran",), "say": ("said",), "seek": ("sought",), "sell": ("sold",),
    "shake": ("shook", "shaken"), "shoot": ("shot",), "show": ("shown",), "sing": ("sang", "sung"),
    "sink": ("sank", "sunk"), "sit": ("sat",), "sleep": ("slept",), "slide": ("slid",), "speak": ("spoke", "spoken"),
    "spin": ("spun",), "stand": ("stood",), "stick": ("stuck",), "sweep": ("swept",), "swim": ("swam", "swum"),
    "swing": ("swung",), "take": ("took", "taken"), "teach": ("taught",), "tell": ("told",),
    "throw": ("threw", "thrown"), "wake": ("woke", "woken"), "wear": ("wore", "worn"), "win": ("won",),
    "wind": ("wound",), "write": ("wrote", "written"),
}  # fmt: skip
"""and verbs with those that sound otherwise. "Left" is a side more often than a form of "leave", and "set", "put" and
"cut" are their own."""
_VERB_OF = {**{form: verb for verb, forms in IRREGULAR.items() for form in forms}, **NEARLY_THE_VERB}


def told_forms_of(word: str, language: str) -> Iterator[str]:
    """The verbs of which a word may be such a form: of "stopped" these are "stopp", which is none, and "stop". None in
    other languages than English."""
    if language == "en" and word in _VERB_OF:
        yield _VERB_OF[word]
    for ending, own in ENDINGS if language == "en" else ():
        stem = word.removesuffix(ending)
        if stem == word or len(stem) < LEAST_LETTERS:
            continue
        yield stem + own
        if ending in ("ed", "ing") and not own and stem[-1] == stem[-2]:
            yield stem[:-1]


def infinitives(verb: str, grammar: Grammar) -> Iterator[str]:
    """The infinitives of which a verb behind "ich möchte dass du" may be a form: "aufhebst", "aufheben"."""
    for ending, infinitive in grammar.wording.wished:
        stem = verb.removesuffix(ending.removeprefix("-"))
        if stem != verb and (len(stem) >= LEAST_LETTERS or not ending.startswith("-")):
            yield stem + infinitive.removeprefix("-")


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
        for told in verbs_of(said, ending, verb, grammar):
            yield len(form), told


def verbs_of(said: str, ending: str, verb: str, grammar: Grammar) -> Iterator[str]:
    """What a verb with an ending may be where it is told: of "regar", "-ar" and "-a" that is "rega", which is none, and
    "riega", as the language has other vowels there."""
    stem = said.removesuffix(ending[1:])
    if not said.endswith(ending[1:]) or len(stem) < LEAST_LETTERS:
        return
    told = verb.removeprefix("-")
    yield stem + told
    vowel = next((at for at in range(len(stem) - 1, -1, -1) if stem[at] in _VOWELS), -1)
    for other in grammar.wording.vowels.get(stem[vowel], ()) if vowel >= 0 else ():
        yield stem[:vowel] + other + stem[vowel + 1 :] + told


def without_stress(verb: str) -> str:
    """A verb without the accent that it has where something is written together with it: "apága", of "apágame"."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFD", verb).replace(_ACUTE, ""))
