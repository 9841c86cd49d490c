"""The spoken forms of quantities as sentence templates, for matching and looking ahead."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from intent_engine.language.numbers import english_words, foreign, said
from intent_engine.language.numbers.units import Units, units

__all__ = ["templates"]

ENGLISH: Mapping[str, str] = {
    "digit": "(one|two|three|four|five|six|seven|eight|nine)",
    "teen": "(" + "|".join(english_words.TEENS) + ")",
    "tens": "(twenty|thirty|forty|fourty|fifty|sixty|seventy|eighty|ninety)",
    "zero": "(zero|oh|o)",
    "below_hundred": "({digit}|{teen}|{tens} [{digit}])",
    "group": "([({below_hundred}|a|{#})] hundred [[and] ({below_hundred}|{#})]|{below_hundred}"
    "|{digit} ({tens} [{digit}]|{teen}|{zero} {digit})|{#} [and ({below_hundred}|{#})])",
    "thousands": "({group} [thousand [[and] {group}]]|a thousand [[and] {group}])",
    "cardinal": "({thousands}|({group}|a) (million|billion) [[and] {thousands}]|{#} k)",
    "decimals": "({digit}|{zero}|{#}|{teen}|{tens}) " + "[({digit}|{zero}) " * 8 + "]" * 8,
    "scale": "(thousand|million|billion|dozen)",
    "part": "(thirds|third|quarter|quarters|fourth|fourths|fifth|fifths|sixth|sixths|seventh|sevenths|eighth|eighths"
    "|ninth|ninths|tenth|tenths|twelfth|twelfths|sixteenth|sixteenths|twentieth|twentieths|hundredth|hundredths|thousandth|thousandths|half|halves)",
    "fraction": "([a|one] half|[a|one] quarter|(a|an|{digit}|{teen}|{#}) {part})",
    "counted": "[minus|negative|plus] ({cardinal} [and ({fraction}|{#}) [{scale}]|{fraction}|(point {decimals} "
    "[{scale}])]|[{zero}|nought|naught] point {decimals} [{scale}]|{fraction}|{zero}|[a] couple [of]"
    "|([a|{below_hundred}|{#}] dozen [and a half]|half a dozen|[a] half dozen)|a pair [of])",
    # "Half a" only before a word.
    "number": "{counted}|[minus|negative|plus] {cardinal} (over|out of) {cardinal}|{fraction} [of] (a|an)",
    "ordinal_unit": "(" + "|".join(english_words.ORDINAL_UNITS) + ")",
    "ordinal_tens": "(" + "|".join(english_words.ORDINAL_TENS) + ")",
    "round": "[a|{group}] (hundred|thousand) [and]",
    "ordinal": "number {cardinal}|[the] ({#word}|last|[{tens}|{round} [{tens}]] {ordinal_unit}|[{round}] {ordinal_tens}"
    "|[a|{group}] (hundredth|thousandth)) [one]",
}
"""Spoken forms, as sentence templates: a little more than :func:`.english.number` accepts, for looking ahead."""


def _foreign_numbers(language: str, table: Units, joint: str) -> Mapping[str, str]:
    """The numbers that people say, word by word besides: what a recogniser looks for. Any others are read too."""
    spelled = [" ".join(words) for words in said.usual(language)]
    if not spelled:
        return {}
    found = {"spelled": "(" + "|".join(spelled) + ")"}
    ways = ["{spelled}"]
    if parts := sorted(table.words.get("half", frozenset()) | table.words.get("quarter", frozenset())):
        found["part"] = "[{one}] (" + "|".join(parts) + ")"
        found["fraction"] = "({part}|" + foreign.TEMPLATES["fraction"] + ")"
        ways += [f"{{spelled}} {joint} {{part}}", "{part}"]
    if point := foreign.point_word(language):
        ways.append(f"{{spelled}} {point} {{spelled}} [{{spelled}}]")
    found["number"] = "(" + "|".join((*ways, foreign.TEMPLATES["number"])) + ")"
    return found


@cache
def templates(language: str) -> Mapping[str, str]:
    """The spoken forms of quantities as named sentence templates, for matching and looking ahead.

    They accept what :func:`evaluate` gives a value to, and a little more; :func:`evaluate` has the last word. For a
    language that we do not know, a number is a numeral.
    """
    table = units(language)
    if table is None:
        return {"number": "{#}", "ordinal": "{#}", "count": "{#}"}
    base = dict(ENGLISH) if language == "en" else dict(foreign.TEMPLATES)
    one = "(" + "|".join(sorted(table.words["one"])) + ")"
    of = "(" + "|".join(sorted(table.words["of"])) + ")"
    joint = "(" + "|".join(sorted(table.words["and"])) + ")"
    part = "({fraction}|{#})" if language == "en" else "{fraction}"
    per = "(" + "|".join(sorted(table.words["per"])) + ")"
    base["one"] = f"{one} [whole|full|single]" if language == "en" else one
    if language != "en":
        base |= _foreign_numbers(language, table, joint)
        called = [f"[{'|'.join(sorted(table.words[key]))}]" for key in ("the", "number") if table.words.get(key)]
        base["ordinal"] = " ".join((*called, foreign.TEMPLATES["ordinal"]))
    # "Half of the meter", but not "half the meter", for which "half a meter" was heard.
    more = "|".join(sorted(table.words.get("more", ())))
    another = "".join(f"|{word}" for word in sorted(table.words.get("another", ())))
    article = f"[{of} [{one}|the]|{one}]" if language == "en" else f"[{of}] [{one}]"
    base["count"] = (
        f"({{counted}} [{article}|{more}]|[minus|negative] {{one}}|another|full|whole)"
        if language == "en"
        else f"({{number}} ({article}{more and '|'}{more})|{{one}}{another})"
    )
    after = "|".join(sorted(table.words.get("more_after", ())))
    after = f" [{after}]" if after else ""
    base["and_part"] = f"{joint} {{fraction}}"
    for kind in ("distance", "duration", "angle", "percent"):
        base[f"{kind}_unit"] = table.spoken(kind)
        unit = f"({{{kind}_unit}}|m)" if kind == "duration" else f"{{{kind}_unit}}"  # a minute only beside another unit
        base[kind] = (
            f"{{count}} {{{kind}_unit}} [{joint} {part}|[{joint}] {{count}} {unit} "
            f"[[{joint}] {{count}} {unit}]|[{joint}] {{below_hundred}}|{{#}}]{after}"
        )
        if kind == "duration":
            base[kind] += f"|{{count}} m [{joint}] {{count}} {{duration_unit}}"
        if "and_part" in table.words:
            base[kind] += f"|{{{kind}_unit}} {joint} {part}"
    if language == "en":
        # "A turn" is none.
        base["angle_unit"] = base["angle_unit"].replace("|turn|", "|")
        single = "one [whole|full|single]|(a|an) (whole|full|single)|full|whole"
        base["turns"] = f"({{counted}} [{article}|{more}]|{single}) turn"
        base["angle"] += f"|{{turns}} [{joint} {part}]|(a|an) turn {joint} {part}"
        base["angle"] += (
            "|[minus|negative] [{counted}] pi [(over|by) {below_hundred}|(over|by) {#}] (radians|radian|rad)"
        )
    base["angle"] += "".join(f"|{' '.join(words)}" for words in table.whole_angles)
    for kind, top in (("speed", "distance"), ("angular_speed", "angle")):
        single = f"|{{count}} {table.spoken(kind)}" if table.by_kind.get(kind) else ""
        unit = f"{{{top}_unit}}" if top == "distance" else table.spoken(top)  # with "a turn per second"
        base[kind] = f"{{count}} {unit} [{joint} {part}] {per} {{duration_unit}}{single}"
        if "and_part" in table.words:
            base[kind] += f"|{unit} {joint} {part} {per} {{duration_unit}}"
        base[kind] += "".join(f"|{said}" for said in table.speeds)
        if behind := "|".join(sorted(table.words.get("speed", ()))):
            base[kind] += f"|{{percent}} [{behind}]"
    return base
