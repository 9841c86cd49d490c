"""Numbers of other languages, as people say them and as recognisers write them."""

from __future__ import annotations

import math
import string

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers import foreign
from intent_engine.language.numbers.spelled import figures_otherwise
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import evaluate, is_number_word, templates
from intent_engine.language.template import parse_template

DEGREE = math.pi / 180
KMH = 1 / 3.6
SAID = {
    "de": [
        ("zwei", "number", 2),
        ("zwo", "number", 2),
        ("einundzwanzig", "number", 21),
        ("dreihundertsechzig", "number", 360),
        ("zweitausendfünfhundert", "number", 2500),
        ("eine Million zweihunderttausend", "number", 1_200_000),
        ("2 Millionen", "number", 2e6),
        ("minus drei", "number", -3),
        ("2,5", "number", 2.5),
        ("anderthalb", "number", 1.5),
        ("einem", "number", 1),
        ("einer", "number", 1),
        ("ein einhalb Meter", "distance", 1.5),
        ("ein ein viertel", "number", 1.25),
        ("negativ sieben", "number", -7),
        ("3 Komma 2", "number", 3.2),
        ("3 Komma zwei fünf", "number", 3.25),
        ("eine Million und eine halbe Million", "number", None),
        ("zweieinhalb", "number", 2.5),
        ("null Komma zwei fünf", "number", 0.25),
        ("zwei Meter", "distance", 2),
        ("ein Meter zwanzig", "distance", 1.2),
        ("einen halben Meter", "distance", 0.5),
        ("drei Viertel Meter", "distance", 0.75),
        ("zwei Meter und dreißig Zentimeter", "distance", 2.3),
        ("neunzig Grad", "angle", 90 * DEGREE),
        ("90°", "angle", 90 * DEGREE),
        ("eine halbe Umdrehung", "angle", math.pi),
        ("eine Vierteldrehung", "angle", math.pi / 2),
        ("eine Minute dreißig", "duration", 90),
        ("anderthalb Minuten", "duration", 90),
        ("null Komma fünf Meter pro Sekunde", "speed", 0.5),
        ("zwei Stundenkilometer", "speed", 2 * KMH),
        ("fünfzig Prozent", "percent", 0.5),
    ],
    "fr": [
        ("vingt et un", "number", 21),
        ("quatre-vingt-dix", "number", 90),
        ("soixante-dix", "number", 70),
        ("mille deux cents", "number", 1200),
        ("10 mille", "number", 10_000),
        ("négatif six", "number", -6),
        ("un milliard et demi million", "number", None),
        ("90 miles à l'heure", "speed", 90 * 0.44704),
        ("deux millions et demi", "number", 2_500_000),
        ("moins trois", "number", -3),
        ("2,5", "number", 2.5),
        ("deux mètres", "distance", 2),
        ("deux mètres et demi", "distance", 2.5),
        ("un demi mètre", "distance", 0.5),
        ("un mètre vingt", "distance", 1.2),
        ("deux mille mètres", "distance", 2000),
        ("deux virgule cinq mètres", "distance", 2.5),
        ("un quart de tour", "angle", math.pi / 2),
        ("demi-tour", "angle", math.pi),
        ("trois quarts d'heure", "duration", 2700),
        ("une minute et demie", "duration", 90),
        ("un quart d'heure", "duration", 900),
        ("dix kilomètres à l'heure", "speed", 10 * KMH),
        ("deux mètres par seconde", "speed", 2),
    ],
    "es": [
        ("veintiún", "number", 21),
        ("metro y medio", "distance", 1.5),
        ("hora y media", "duration", 5400),
        ("minuto y cuarto", "duration", 75),
        ("veintitres", "number", 23),
        ("treinta y cinco", "number", 35),
        ("veinte y tres", "number", 23),
        ("ciento veinte y un", "number", 121),
        ("diez y seis", "number", 16),
        ("veinte y dos millones", "number", 22e6),
        ("veinte y tres coma cinco metros", "distance", 23.5),
        ("veinte metros y tres centímetros", "distance", 20.03),
        ("mil doscientos", "number", 1200),
        ("2 mil", "number", 2000),
        ("3 mil millones", "number", 3e9),
        ("negativo seis", "number", -6),
        ("menos tres", "number", -3),
        ("2,5", "number", 2.5),
        ("dos metros y medio", "distance", 2.5),
        ("medio metro", "distance", 0.5),
        ("dos coma cinco metros", "distance", 2.5),
        ("noventa grados", "angle", 90 * DEGREE),
        ("un cuarto de vuelta", "angle", math.pi / 2),
        ("media vuelta", "angle", math.pi),
        ("un minuto y medio", "duration", 90),
        ("tres cuartos de hora", "duration", 2700),
        ("diez kilómetros por hora", "speed", 10 * KMH),
    ],
    "it": [
        ("ventuno", "number", 21),
        ("mezz'ora", "duration", 1800),
        ("milleduecento", "number", 1200),
        ("due milioni", "number", 2e6),
        ("un milione duemiladuecento", "number", 1_002_200),
        ("3 milioni e mezzo", "number", 3_500_000),
        ("meno tre", "number", -3),
        ("2,5", "number", 2.5),
        ("due metri e mezzo", "distance", 2.5),
        ("mezzo metro", "distance", 0.5),
        ("due virgola cinque metri", "distance", 2.5),
        ("due punto cinque metri", "distance", 2.5),
        ("novanta gradi", "angle", 90 * DEGREE),
        ("un quarto di giro", "angle", math.pi / 2),
        ("un minuto e mezzo", "duration", 90),
        ("tre quarti d'ora", "duration", 2700),
        ("dieci chilometri all'ora", "speed", 10 * KMH),
        ("mezzo metro al secondo", "speed", 0.5),
    ],
}
ROWS = [(language, *row) for language, rows in SAID.items() for row in rows]


def words(text: str) -> list[str]:
    return [token.word for token in tokenize(text)]


@pytest.mark.parametrize(("language", "said", "kind", "value"), ROWS)
def test_a_quantity_of_another_language(language: str, said: str, kind: str, value: float) -> None:
    assert evaluate(words(said), kind, language) == pytest.approx(value)


@pytest.mark.parametrize(
    ("language", "said", "name"),
    [
        ("de", "halle drei", "halle 3"),
        ("de", "raum zweihundertvier", "raum 204"),
        ("de", "raum zwei null vier", "raum 2 0 4"),
        ("fr", "bureau vingt et un", "bureau 21"),
        ("es", "sala doce b", "sala 12 b"),
        ("it", "sala uno", "sala 1"),
        ("fr", "salle une", "salle 1"),
        ("it", "una sala uno b", "una sala uno b"),  # "b" may be a word of its own
        ("fr", "un", "un"),
        ("de", "die große halle", "die große halle"),
        ("de", "anderthalb meter", "anderthalb meter"),
    ],
)
def test_the_numbers_of_a_name_in_digits(language: str, said: str, name: str) -> None:
    assert " ".join(foreign.in_digits(said.split(), language)) == name


NOTHING = [("de", "und"), ("de", "Meter"), ("fr", "et"), ("es", "y"), ("it", "e"), ("de", "minus"), ("de", "komma")]


@pytest.mark.parametrize(
    ("language", "said"), [*NOTHING, ("de", "Million Meter"), ("fr", "un sur zéro"), ("xx", "zwei")]
)
def test_what_is_no_number(language: str, said: str) -> None:
    assert evaluate(words(said), "number", language) is None


@pytest.mark.parametrize(("language", "said"), [("es", "1,5 metros y medio"), ("fr", "1,5 mètre et demi")])
def test_a_decimal_and_a_half_is_no_quantity(language: str, said: str) -> None:
    assert evaluate(words(said.replace(",", ".")), "distance", language) is None
    assert evaluate(words(said.replace(",5", "")), "distance", language) == 1.5


@pytest.mark.parametrize("language", ["de", "es", "fr", "it"])
@settings(max_examples=60, deadline=None)
@given(number=st.integers(0, 10**9))
def test_figures_mean_the_same_in_every_language(language: str, number: int) -> None:
    assert foreign.number([str(number)], language) == number
    assert foreign.number(words(f"{number},5"), language) == number + 0.5


@pytest.mark.parametrize("language", ["de", "es", "fr", "it"])
@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_no_words_raise(language: str, data: st.DataObject) -> None:
    table = units(language)
    assert table is not None
    known = sorted(
        {word for group in table.words.values() for word in group} | {"zwei", "deux", "dos", "due", "7", "-2"}
    )
    said = data.draw(
        st.lists(st.one_of(st.sampled_from(known), st.text(string.ascii_lowercase, min_size=1)), max_size=7)
    )
    for kind in ("number", "ordinal", "distance", "angle", "duration", "speed", "angular_speed", "percent"):
        value = evaluate(said, kind, language)
        assert value is None or (isinstance(value, float) and math.isfinite(value))


@pytest.mark.parametrize("language", ["de", "en", "es", "fr", "it", "xx"])
def test_the_spoken_forms_of_a_language_can_be_read(language: str) -> None:
    for template in templates(language).values():
        parse_template(template)


def test_number_words_are_told_from_others() -> None:
    for language, rows in SAID.items():
        for said, kind, _ in rows:
            if kind == "number":
                assert all(word[0].isdigit() or is_number_word(word, language) for word in words(said)), said
    assert not is_number_word("haus", "de")
    assert not is_number_word("two", "en"), "English number words are spelled out in templates"
    assert is_number_word("3rd", "en")
    assert not is_number_word("3", "en")


@pytest.mark.parametrize(("said", "value"), [("-3 Komma 2", -3.2), ("8 k", 8000), ("-2,5 k", -2500)])
def test_figures_go_on_in_words(said: str, value: float) -> None:
    assert evaluate(words(said), "number", "de") == pytest.approx(value)


@pytest.mark.parametrize("said", ["veinte y", "diez y tres", "veinte y diez", "y tres", "dos y tres"])
def test_what_no_number_is_said_as(said: str) -> None:
    assert evaluate(words(said), "number", "es") is None


@pytest.mark.parametrize(
    ("language", "said"),
    [("de", "zwei Punkt fünf Meter"), ("fr", "deux point cinq mètres"), ("es", "dos punto cinco metros"),
     ("it", "due punto cinque metri")],
)  # fmt: skip
def test_a_point_is_said_beside_a_comma(language: str, said: str) -> None:
    assert evaluate(words(said), "distance", language) == 2.5


@pytest.mark.parametrize(
    ("language", "figures", "said"),
    [
        ("fr", "21", ("vingt", "et", "un")), ("fr", "21", ("vingt", "et", "une")),
        ("fr", "71", ("soixante", "et", "onze")), ("es", "35", ("treinta", "y", "cinco")),
        ("es", "23", ("veintitrés",)), ("es", "23", ("veinte", "y", "tres")), ("it", "21", ("ventuno",)),
        ("de", "21", ("einundzwanzig",)),
    ],
)  # fmt: skip
def test_figures_as_they_are_said(language: str, figures: str, said: tuple[str, ...]) -> None:
    length, ways = figures_otherwise((figures, "b"), language)
    assert length == 1
    assert said in ways


@pytest.mark.parametrize("words", [("1",), ("021",), ("2.5",), ("table",)])
def test_what_is_no_whole_number_is_not_said_otherwise(words: tuple[str, ...]) -> None:
    assert figures_otherwise(words, "fr") == (0, ())


NUMBERED = """
language: {language}
slots: {{place: location}}
intents:
  go: {{action: {{type: navigate, location: "{{place}}"}}, sentences: ["{go} {{place}}"]}}
  come: {{action: custom, sentences: ["{come}"]}}
"""


@pytest.mark.parametrize(
    ("language", "go", "come", "said", "place"),
    [
        ("fr", "va à la", "viens", "va à la table vingt et un", "table 21"),
        ("fr", "va à la", "viens", "va à la table soixante et onze", "table 71"),
        ("fr", "va à la", "viens", "va à la table vingt", "table 20"),
        ("es", "ve a la", "ven", "ve a la fila treinta y cinco", "fila 35"),
        ("es", "ve a la", "ven", "ve a la fila veinte y tres", "fila 23"),
    ],
)
def test_a_place_has_its_number_in_words_that_join(engine_of, language, go, come, said, place) -> None:
    name = place.split()[0]
    places = {f"{name} {number}": (float(number), 0.0) for number in (1, 5, 20, 21, 23, 35, 71)}
    engine = engine_of(NUMBERED.format(language=language, go=go, come=come), locations=places)
    assert engine.parse(said).slots == {"place": place}
    joint = "et" if language == "fr" else "y"
    both = engine.parse(f"{said} {joint} {come}")
    assert [step["intent"] for step in both.slots["steps"]] == ["go", "come"]
    assert not engine.parse(f"{go} {name} vingt et douze" if language == "fr" else f"{go} {name} veinte y doce").actions


@pytest.mark.parametrize(
    ("said", "place"), [("2", "zimmer zwei"), ("zwo", "zimmer zwei"), ("zwei", "zimmer zwei"), ("3", None)]
)
def test_a_map_may_have_numbers_in_words(engine_of, said: str, place: str | None) -> None:
    """Recognisers write them in figures."""
    engine = engine_of(NUMBERED.format(language="de", go="fahr in", come="komm"), locations={"zimmer zwei": (1.0, 0.0)})
    assert engine.parse(f"fahr in zimmer {said}").slots.get("place") == place


def test_a_language_of_text2num_without_a_file_of_units(engine_of) -> None:
    own = "operators: {negation: [não], stop: [pare]}" + NUMBERED.format(language="pt", go="vai para", come="vem")
    engine = engine_of(own, locations={"sala 3": (1.0, 0.0)})
    assert engine.parse("vai para sala três").slots == {"place": "sala 3"}
    assert not engine.parse("vai para sala quatro").actions


@pytest.mark.parametrize("language", ["ca", "nl", "pt", "sv", "xx"])
@pytest.mark.parametrize("kind", ["number", "ordinal"])
def test_words_of_a_language_without_a_file_are_no_error(engine_of, language: str, kind: str) -> None:
    own = f"language: {language}\noperators: {{negation: [nee], stop: [halt]}}\nslots: {{place: location, n: {kind}}}\n"
    own += 'intents:\n  a: {action: custom, sentences: ["aa {n}"]}\n  b: {action: custom, sentences: ["bb {place}"]}\n'
    engine = engine_of(own, locations={"sala 3": (1.0, 0.0)})
    assert engine.parse("aa 3").slots == {"n": 3}
    for said in ("aa primer", "aa drie", "bb sala tres", "bb sala três", "bb sala"):
        engine.parse(said)  # raises nothing
