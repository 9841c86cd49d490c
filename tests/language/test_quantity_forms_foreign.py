"""The same in German, French, Spanish and Italian: forms that a rule makes, with their value, are read back."""

from __future__ import annotations

import math
from typing import NamedTuple

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers import foreign, said
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import evaluate

LANGUAGES = ("de", "fr", "es", "it")
KINDS = ("number", "ordinal", "distance", "angle", "duration", "speed", "percent")
SENTENCES = {"de": ("setze", "zur tür"), "fr": ("mets", "vers la porte"), "es": ("pon", "hacia la puerta"),
             "it": ("metti", "verso la porta")}  # fmt: skip


class Words(NamedTuple):
    """What a language calls a few things."""

    meters: str
    per_second: str
    half: str
    """Behind a number: "and a half"."""
    million: str
    point: str
    minus: str
    more: str
    """A number of something, as much more."""
    called: str
    third: str
    some: str


SAID = {
    "de": Words("meter", "in der sekunde", "und ein halb", "millionen", "komma", "minus", "noch {} {}", "der {}",
                "dritte", "ein paar"),
    "fr": Words("mètres", "à la seconde", "et demi", "millions", "virgule", "moins", "{} {} de plus", "le {}",
                "troisième", "quelques"),
    "es": Words("metros", "por segundo", "y medio", "millones", "coma", "menos", "{} {} más", "el {}", "tercero",
                "unos"),
    "it": Words("metri", "al secondo", "e mezzo", "milioni", "virgola", "meno", "altri {} {}", "il {}", "terzo",
                "alcuni"),
}  # fmt: skip


@pytest.fixture(scope="module")
def engines(tmp_path_factory) -> dict[str, IntentEngine]:
    folder = tmp_path_factory.mktemp("forms")
    found = {}
    for language, (verb, tail) in SENTENCES.items():
        path = folder / f"{language}.yaml"
        lines = [f"language: {language}", "slots:", *(f"  {kind}: {{type: {kind}}}" for kind in KINDS), "intents:"]
        for kind in KINDS:
            lines += [f"  {kind}:", "    action: {type: custom, name: x}"]
            lines += [f'    sentences: ["{verb} {kind} {{{kind}}} [{tail}]"]']
        path.write_text("\n".join(lines), "utf-8")
        found[language] = IntentEngine.from_files(path)
    return found


def words(text: str, language: str) -> list[str]:
    return [token.word for token in tokenize(text, language)]


def reads(engines: dict[str, IntentEngine], language: str, kind: str, form: str, value: float | None) -> None:
    verb, tail = SENTENCES[language]
    close = None if value is None else pytest.approx(value)
    for rest in ("", f" {tail}"):
        found = engines[language].parse(f"{verb} {kind} {form}{rest}")
        heard = found.slots.get(kind) if found.status is Status.ACCEPTED else None
        assert heard == close, (language, form, rest)


def spelled(number: int, language: str) -> str:
    text = " ".join(said.spell(number, language))
    return text if foreign.number(text.split(), language) == number else str(number)  # text2num lacks a few


languages = st.sampled_from(LANGUAGES)


@settings(max_examples=80, deadline=None)
@given(languages, st.integers(2, 99), st.booleans())
def test_a_half_behind_a_number_and_behind_millions(engines, language, number, digits) -> None:
    form = str(number) if digits else spelled(number, language)
    own = SAID[language]
    if language != "de":
        reads(engines, language, "number", f"{form} {own.half}", number + 0.5)
        reads(engines, language, "distance", f"{form} {own.meters} {own.half}", number + 0.5)
        reads(engines, language, "number", f"{form} {own.million} {own.half}", (number + 0.5) * 1e6)
    reads(engines, language, "number", f"{form} {own.million}", number * 1e6)


@settings(max_examples=150, deadline=None)
@given(languages, st.integers(0, 99), st.integers(0, 2), st.integers(1, 99), st.booleans(), st.booleans())
def test_decimals_in_words(engines, language, whole, zeros, rest, one_number, scaled) -> None:
    """ "Zwei Komma null fünf", "trois virgule soixante-quinze": digits, or one number."""
    own = SAID[language]
    after = [spelled(rest, language)] if one_number else [spelled(int(digit), language) for digit in str(rest)]
    after = [*[spelled(0, language)] * zeros, *after]
    value = float(f"{whole}.{'0' * zeros}{rest}")
    form = " ".join([spelled(whole, language), own.point, *after])
    assume(not any(character.isdigit() for character in form) and len(form.split()) < 8)
    reads(engines, language, "number", f"{form} {own.million}" if scaled else form, value * (1e6 if scaled else 1))


@settings(max_examples=100, deadline=None)
@given(languages, st.data())
def test_parts_of_one(engines, language, data) -> None:
    table = units(language)
    assert table is not None
    (name, single), bottom = data.draw(st.sampled_from(sorted(table.parts.items())))
    top = 1 if single else data.draw(st.integers(2, min(9, int(bottom) - 1)))
    one = {"de": "ein", "fr": "un", "es": "un", "it": "un"}[language]
    count = one if single else data.draw(st.sampled_from([spelled(top, language), str(top)]))
    reads(engines, language, "number", f"{count} {name}", top / bottom)
    if language != "de":
        spoken = one if single else spelled(top, language)
        joint = min(table.words["and"])
        reads(engines, language, "number", f"{spelled(3, language)} {joint} {spoken} {name}", 3 + top / bottom)


@settings(max_examples=60, deadline=None)
@given(st.integers(1, 9), st.integers(2, 10))
def test_german_parts_of_one_word(engines, top, bottom) -> None:
    name = next((word for (word, _), number in units("de").parts.items() if number == bottom), None)
    if name is not None and top < bottom:
        count = "ein" if top == 1 else spelled(top, "de")
        assert evaluate([count + name], "number", "de") == pytest.approx(top / bottom)
        reads(engines, "de", "distance", f"{count}{name} meter", top / bottom)


@settings(max_examples=60, deadline=None)
@given(languages, st.integers(2, 99))
def test_as_much_more_and_below_zero_and_a_rate(engines, language, number) -> None:
    own, form = SAID[language], spelled(number, language)
    reads(engines, language, "distance", own.more.format(form, own.meters), number)
    reads(engines, language, "distance", f"{own.minus} {form} {own.meters}", -number)
    reads(engines, language, "speed", f"{form} {own.meters} {own.per_second}", number)
    reads(engines, language, "distance", f"{own.some} {own.meters}", None)


@settings(max_examples=80, deadline=None)
@given(languages, st.integers(1_000, 10**9))
def test_thousands_set_apart(engines, language, number) -> None:
    """Those of a plain space if there are two: "1 500" may be two numbers."""
    own = SAID[language]
    for space in (" ", "\u00a0", "\u202f"):
        written = f"{number:,}".replace(",", space)
        clear = number >= 1_000_000 or space != " "
        reads(engines, language, "number", written, number if clear else None)
        reads(engines, language, "distance", f"{written} {own.meters}", number if clear else None)


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_third_and_number_three(engines, language) -> None:
    own = SAID[language]
    table = units(language)
    assert table is not None
    reads(engines, language, "ordinal", own.third, 3)
    reads(engines, language, "ordinal", own.called.format(own.third), 3)
    for name in table.words["number"]:
        reads(engines, language, "ordinal", f"{name} {spelled(3, language)}", 3)
    reads(engines, language, "ordinal", f"{own.minus} 3", None)


@pytest.mark.parametrize(
    ("language", "kind", "form", "value"),
    [
        ("de", "number", "zweiundeinhalb", 2.5),
        ("de", "number", "einhalb", 0.5),
        ("de", "number", "zweieinviertel", 2.25),
        ("de", "number", "anderthalb Millionen", 1_500_000),
        ("de", "number", "eineinhalbtausend", 1500),
        ("de", "number", "1,5 Mio.", 1_500_000),
        ("de", "number", "fuenfunddreissig", 35),
        ("de", "number", "ein halbes Dutzend", 6),
        ("de", "distance", "einen und einen halben Meter", 1.5),
        ("de", "duration", "eine Dreiviertelstunde", 2700),
        ("de", "duration", "eine drei viertel Stunde", 2700),
        ("de", "duration", "eine Viertelstunde", 900),
        ("de", "duration", "1,5 Std.", 5400),
        ("de", "angle", "eine ganze Drehung", 2 * math.pi),
        ("de", "angle", "zwei halbe Drehungen", 2 * math.pi),
        ("de", "angle", "drei Vierteldrehungen", 1.5 * math.pi),
        ("de", "speed", "fünf Kilometer die Stunde", 5 / 3.6),
        ("de", "duration", "eine gute halbe Stunde", 1800),
        ("de", "duration", "ein Stündchen", 3600),
        ("fr", "number", "une demi-douzaine", 6),
        ("fr", "number", "une vingtaine", 20),
        ("fr", "number", "deux centaines", 200),
        ("fr", "duration", "une bonne demi-heure", 1800),
        ("fr", "duration", "cinq petites minutes", 300),
        ("fr", "number", "zero virgule cinq", 0.5),
        ("fr", "distance", "deux metres et demi", 2.5),
        ("fr", "duration", "une heure et trois quarts", 6300),
        ("fr", "angle", "un tour complet", 2 * math.pi),
        ("fr", "angle", "un angle droit", math.pi / 2),
        ("fr", "angle", "deux demi-tours", 2 * math.pi),
        ("fr", "ordinal", "2e", 2),
        ("fr", "ordinal", "1re", 1),
        ("es", "number", "media docena", 6),
        ("es", "number", "una veintena", 20),
        ("es", "duration", "veinte minutitos", 1200),
        ("es", "duration", "media horita", 1800),
        ("es", "distance", "otro metro", 1),
        ("es", "distance", "un metro y cincuenta", 1.5),
        ("es", "distance", "un metro y setenta y cinco", 1.75),
        ("es", "duration", "una hora y treinta y cinco", 5700),
        ("es", "distance", "cincuenta centimetros", 0.5),
        ("es", "angle", "una vuelta completa", 2 * math.pi),
        ("es", "angle", "tres medias vueltas", 3 * math.pi),
        ("es", "angle", "90º", math.pi / 2),
        ("es", "ordinal", "1º", 1),
        ("es", "ordinal", "3ª", 3),
        ("es", "speed", "metro y medio por segundo", 1.5),
        ("es", "distance", "cuatro metros y medio más", 4.5),
        ("es", "percent", "cien por cien", 1),
        ("it", "number", "mezza dozzina", 6),
        ("it", "number", "una decina", 10),
        ("it", "number", "due centinaia", 200),
        ("it", "duration", "un paio d'ore", 7200),
        ("it", "duration", "un'oretta e mezza", 5400),
        ("it", "distance", "un metro e cinquanta", 1.5),
        ("it", "distance", "due metri in più", 2),
        ("it", "angle", "un angolo retto", math.pi / 2),
        ("it", "angle", "due mezzi giri", 2 * math.pi),
        ("it", "ordinal", "l'ultimo", -1),
        ("it", "ordinal", "3°", 3),
        ("it", "percent", "cinquanta percento", 0.5),
    ],
)
def test_what_else_is_said(engines, language: str, kind: str, form: str, value: float) -> None:
    reads(engines, language, kind, form, value)
    assert evaluate(words(form, language), kind, language) == pytest.approx(value)


@pytest.mark.parametrize(
    ("language", "kind", "form"),
    [
        ("de", "number", ",5"),
        ("fr", "number", "mille et demi"),
        ("es", "number", "cientos"),
        ("es", "duration", "unos minutos"),
        ("fr", "number", "vingt-cinquième"),  # an ordinal, and no 20/5
        ("it", "number", "terzo"),
        ("es", "distance", "un metro y tres"),
        ("de", "distance", "zweieinhalb Meter fünfzig"),
        ("fr", "duration", "1,5 h 30"),
        # A rest of "null Komma fünf".
        *(("de", "distance", "null fünf Meter"), ("fr", "distance", "zéro cinq mètres")),
        *(("es", "distance", "cero cinco metros"), ("it", "distance", "zero cinque metri")),
    ],
)
def test_what_is_no_clear_quantity(engines, language: str, kind: str, form: str) -> None:
    reads(engines, language, kind, form, None)
    assert evaluate(words(form, language), kind, language) is None


@pytest.mark.parametrize(
    ("language", "form"),
    [
        ("de", "fünf, und zwanzig meter"),
        ("fr", "quarante, cinq mètres"),
        ("fr", "quatre, vingt mètres"),
        ("fr", "quatre-vingt, dix mètres"),
        ("fr", "mille vingt, cinq mètres"),
        ("es", "cuarenta, cinco metros"),
        ("es", "treinta, y un metros"),
        ("it", "quaranta, cinque metri"),
    ],
)
def test_a_small_number_has_no_pause_within(engines, language: str, form: str) -> None:
    """It may be the second that puts the first right; larger ones have such pauses: "mil, quinientos"."""
    reads(engines, language, "distance", form, None)


@pytest.mark.parametrize(
    ("language", "form", "value"),
    [
        ("de", "zweitausend, fünfhundert meter", 2500),
        ("fr", "deux mille, cinq cents mètres", 2500),
        ("fr", "cent, quatre-vingts mètres", 180),
        ("es", "mil, quinientos metros", 1500),
        ("it", "duemila, cinquecento metri", 2500),
        ("fr", "deux, et demi mètres", 2.5),
    ],
)
def test_a_large_number_has_pauses_within(engines, language: str, form: str, value: float) -> None:
    reads(engines, language, "distance", form, value)


@pytest.mark.parametrize("language", ["en", *LANGUAGES])
@pytest.mark.parametrize("written", ["1, 234, 567", "1 500", "1 234 56", "12 345 6789", "1 234 567 8"])
def test_a_list_is_no_million(language: str, written: str) -> None:
    assert evaluate(words(written, language), "number", language) is None
