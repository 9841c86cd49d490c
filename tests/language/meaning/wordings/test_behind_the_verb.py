"""Words that stand behind the verb of a command, and that no grammar has: "und fahr *dann* in die Küche"."""

from __future__ import annotations

import pytest

GRAMMAR = """
language: de
slots:
  tisch: {type: number, min: 1, max: 30, whole: true}
  raum: [Küche, Bar]
  lampe: [Licht, Barlicht]
  meter: {type: distance}
  gerät: [Hammer, Zange, Kiste]
  "on": boolean
intents:
  fahr: {action: custom, sentences: ["(fahr|fahren sie) in die {raum}"]}
  vor: {action: custom, sentences: ["fahr [{meter}] vor"]}
  dreh: {action: custom, sentences: ["dreh dich um"]}
  räum: {action: custom, sentences: ["(räum|räumen sie) tisch {tisch} ab"]}
  licht: {action: custom, sentences: ["mach das {lampe} {on}"]}
  hol: {action: custom, sentences: ["hol (den|die) {gerät}"]}
"""
FRENCH = """
language: fr
slots: {table: {type: number, max: 30, whole: true}, lieu: [cuisine, terrasse], distance: distance}
intents:
  va: {action: custom, sentences: ["va à la {lieu}"]}
  avance: {action: custom, sentences: ["avance [de] {distance}"]}
  débarrasse: {action: custom, sentences: ["débarrasse la table {table}"]}
"""
SPANISH = """
language: es
slots: {lugar: [cocina, terraza]}
intents:
  ve: {action: custom, sentences: ["ve a la {lugar}"]}
"""
ITALIAN = """
language: it
slots: {luogo: [cucina, terrazza]}
intents:
  vai: {action: custom, sentences: ["vai in {luogo}"]}
"""


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("fahr dann in die Küche", "dann fahr in die Küche"),
        ("räum Tisch zehn ab und fahr dann in die Küche", "räum Tisch zehn ab und fahr in die Küche"),
        ("räum Tisch zehn ab, fahr danach in die Küche", "räum Tisch zehn ab und fahr in die Küche"),
        ("räum erst Tisch zehn ab und dann fahr in die Bar", "räum Tisch zehn ab und fahr in die Bar"),
        (
            "Räumen Sie zuerst Tisch zehn ab und fahren Sie dann in die Bar",
            "räum Tisch zehn ab und fahr in die Bar",
        ),
        ("dreh dich um und fahr anschließend zwei Meter vor", "dreh dich um und fahr zwei Meter vor"),
        ("und fahr dann in die Küche", "fahr in die Küche"),
        ("fahr dann in die Küche, nein, in die Bar", "fahr in die Bar"),
        ("wenn du fertig bist, fahr dann in die Küche", "fahr in die Küche"),
        ("hol mir bitte mal die Zange", "hol die Zange"),
        ("hol mir dann die Zange", "hol die Zange"),
        ("räum Tisch zehn ab und mach uns das Licht an", "räum Tisch zehn ab und mach das Licht an"),
        ("mach das Licht wieder an", "mach das Licht an"),
        ("fahr noch einmal in die Küche", "fahr in die Küche"),
    ],
)
def test_it_is_the_command_without_them(engine_of, said: str, meant: str) -> None:
    engine = engine_of(GRAMMAR)
    assert engine.parse(said).actions == engine.parse(meant).actions != ()
    assert engine.parse(said, spoken=True).actions == engine.parse(meant).actions


BRING = """
language: de
slots: {gerät: [Hammer, Zange]}
intents:
  nimm: {action: custom, sentences: ["hol (den|die) {gerät}"]}
  bring: {action: custom, sentences: ["hol mir (den|die) {gerät}"]}
"""


@pytest.mark.parametrize(
    "said",
    [
        "hol mir dann die Zange",
        "hol mir wieder die Zange",
        "kannst du mir die Zange holen",
        "du sollst mir die Zange holen",
    ],
)
def test_for_whom_it_is_done_matters_where_the_grammar_says_so(engine_of, said: str) -> None:
    assert engine_of(BRING).parse(said).intent == "bring"


@pytest.mark.parametrize("said", ["hol mir dann", "hol mir bald die Zange"])
def test_what_is_brought_is_not_taken(engine_of, said: str) -> None:
    assert engine_of(BRING).parse(said).actions == ()


@pytest.mark.parametrize(
    "said",
    [
        "fahr dann nicht in die Küche",
        "fahr dann",
        "fahr, dann in die Küche",
        "er fährt dann in die Küche",
        "mach dann das Licht an, wenn Gäste kommen",
        "wenn Gäste kommen, mach dann das Licht an",
        "fahr erst dann vor",  # not before something that was not said
        "fahr dann erst vor",
        "räum Tisch zehn ab und fahr zuerst in die Küche",  # which of them is the first?
        "fahr mir vor",
        "fahr vor mir",
        "Tom sagt, hol mir die Zange",
        "wieder Tisch zehn ab",
        "mach das Licht immer wieder an",
        "mach das Licht nie wieder an",
        "mach wieder und wieder das Licht an",
    ],
)
def test_what_says_more_or_less_is_none(engine_of, said: str) -> None:
    assert engine_of(GRAMMAR).parse(said).actions == ()


@pytest.mark.parametrize(
    ("grammar", "said", "meant"),
    [
        (FRENCH, "débarrasse la table dix et va ensuite à la cuisine", "débarrasse la table dix et va à la cuisine"),
        (FRENCH, "débarrasse d'abord la table dix, puis va à la cuisine", "débarrasse la table dix et va à la cuisine"),
        (SPANISH, "ve a la terraza y ve luego a la cocina", "ve a la terraza y ve a la cocina"),
        (ITALIAN, "vai in terrazza e vai poi in cucina", "vai in terrazza e vai in cucina"),
    ],
)
def test_other_languages(engine_of, grammar: str, said: str, meant: str) -> None:
    engine = engine_of(grammar)
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize("said", ["avance après deux mètres", "va après à la cuisine", "avance d'abord"])
def test_a_word_with_a_time_or_a_way_of_its_own_is_none(engine_of, said: str) -> None:
    assert engine_of(FRENCH).parse(said).actions == ()
