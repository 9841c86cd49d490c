"""Names found again from what was heard: never another place."""

from __future__ import annotations

import string
from pathlib import Path

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from intent_engine.language.locations import load
from intent_engine.language.names import Match, NameIndex
from intent_engine.language.numbers import english, english_words
from intent_engine.language.numbers.said import spell
from intent_engine.language.slots.name_words import is_identifier, name_words, without_article

ROOT = Path(__file__).resolve().parents[2]
MAPS = {name: load(ROOT / "locations" / f"{name}.yaml") for name in ("home", "warehouse")}

WORDS = [
    *(
        "kitchen",
        "corridor",
        "bedroom",
        "station",
        "cabinet",
        "warehouse",
        "laboratory",
        "garden",
        "terrace",
        "workshop",
    ),
    *(
        "library",
        "gallery",
        "platform",
        "counter",
        "junction",
        "reception",
        "pharmacy",
        "canteen",
        "entrance",
        "charging",
    ),
    *("loading", "packing", "storage", "meeting", "dining", "living"),
]
names = st.builds(
    lambda words, number: " ".join((*words, *number)),
    st.lists(st.sampled_from(WORDS), min_size=1, max_size=3),
    st.lists(st.integers(0, 300).map(str), max_size=1),
)
name_sets = st.lists(names, min_size=1, max_size=30, unique=True)


def _index(spoken: list[str]) -> NameIndex:
    return NameIndex([(name, name) for name in spoken])


# -- what is said exactly -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", MAPS)
@pytest.mark.parametrize("before", ["", "the ", "my ", "The "])
def test_every_name_and_alias_of_the_shipped_maps_is_its_place(name, before):
    places = MAPS[name]
    for place in places.values():
        for spoken in (place.name, *place.aliases):
            match = places.index.resolve(before + spoken)
            assert (match.status, match.name) == ("exact", place.name), spoken


@given(name_sets)
def test_every_name_is_itself(spoken):
    index = _index(spoken)
    for name in spoken:
        assert index.resolve(name) == index.resolve(name.split())
        assert (index.resolve(name).status, index.resolve(name).name) == ("exact", name)


SAME = [
    ("bay 3", "bay three", "number"),
    ("bay 3", "the bay number three", "number"),
    ("bay 3", "bay number 3", "exact"),
    ("bay 3", "Bay 03", "number"),
    ("bay 3", "bay_3", "exact"),
    ("bay 3", "bay #3", "exact"),
    ("Dock No. 4", "dock four", "number"),
    ("room 123", "room one two three", "number"),
    ("room 105", "room one oh five", "number"),
    ("gate 07", "gate zero seven", "number"),
    ("aisle twenty one", "aisle 21", "exact"),
    ("3rd floor", "third floor", "number"),
    ("third floor", "3rd floor", "number"),
    ("section 2.1", "section two point one", "number"),
    ("bay 3 g", "bay three g", "number"),
    ("the lab", "lab", "exact"),
    ("back of the yard", "back of yard", "exact"),
    ("a wing", "wing", "exact"),
    ("a wing", "a wing", "exact"),
    ("aisle a", "aisle A", "exact"),
    ("my office", "our office", "exact"),
    ("café", "Café", "exact"),
]


@pytest.mark.parametrize(("name", "said", "how"), SAME)
def test_the_same_words_by_value(name, said, how):
    match = NameIndex([(name, name), ("somewhere else", "other")]).resolve(said)
    assert (match.status, match.name, match.score, match.how) == ("exact", name, 1.0, how)


def test_an_article_that_tells_two_names_apart_is_heard():
    index = _index(["my office", "your office", "aisle", "aisle a"])
    assert index.resolve("my office").name == "my office"
    assert index.resolve("your office").name == "your office"
    assert index.resolve("aisle").name == "aisle"
    assert index.resolve("aisle a").name == "aisle a"
    assert index.resolve("the office").status == "ambiguous"


@given(
    st.sampled_from(["nose", "office", "bay 2", "coffee mug", "aisle b"]),
    st.sampled_from([("my", "your"), ("your", "my"), ("your", "our"), ("our", "your")]),
    st.sampled_from(["this", "that", "a", "the"]),
)
def test_whose_a_name_is_said_to_be_is_a_part_of_it(name: str, owners: tuple[str, str], article: str):
    """ "Your nose" is no "my nose"; who says "the nose" means either."""
    own, other = owners
    index = NameIndex([(f"{own} {name}", "mine"), ("lamp", "lamp")])
    for said in (f"{own} {name}", name, f"the {name}", f"{article} {name}"):
        assert index.resolve(said).name == "mine", said
    assert index.resolve(f"{other} {name}").name is None
    assert index.resolve(f"{other} {name}s").name is None
    for said in (own, other, article):  # of no name that the grammar gives to nobody
        assert NameIndex([(name, name), (f"a {name} box", "box")]).resolve(f"{said} {name}").name == name
    assert NameIndex([(f"a {name}", name)]).resolve(f"{other} {name}").name == name


def test_one_spelling_for_two_names_is_a_question():
    match = NameIndex([("lab", "north lab"), ("lab", "south lab")]).resolve("lab")
    assert match.status == "ambiguous"
    assert [name for name, _ in match.candidates] == ["north lab", "south lab"]


# -- what is misheard -----------------------------------------------------------------------------------------

MISHEARD = [
    ("home", "kichen", "kitchen"),
    ("home", "the kitchin", "kitchen"),
    ("home", "living rome", "living room"),
    ("home", "livingroom", "living room"),
    ("home", "bed room", "bedroom"),
    ("home", "kit chen", "kitchen"),
    ("home", "entrence", "entrance"),
    ("warehouse", "bay tree", "bay 3"),
    ("warehouse", "bae three", "bay 3"),
    ("warehouse", "isle for", "aisle 4"),
    ("warehouse", "dock to", "loading dock 2"),
    ("warehouse", "dock too", "loading dock 2"),
    ("warehouse", "dock for", "loading dock 4"),
    ("warehouse", "bay ate", "bay 8"),
    ("warehouse", "loading duck four", "loading dock 4"),
    ("warehouse", "charging stations", "charging station"),
    ("warehouse", "pecking table", "packing table"),
]


@pytest.mark.parametrize(("places", "said", "name"), MISHEARD)
def test_misheard_names_are_understood(places, said, name):
    match = MAPS[places].index.resolve(said)
    assert (match.status, match.name) == ("fuzzy", name)
    assert 0.84 <= match.score < 1


@pytest.mark.parametrize(
    "said",
    [
        *("office", "garage", "love", "chicken", "bathroom", "cellar", "fridge", "duck", "dog", "beer", "coach", "no"),
        *(
            "dining room",
            "changing station",
            "no dock",
            "not the kitchen",
            "kitchen table",
            "kitchen the",
            "red room",
            "the",
            "door",
        ),
    ],
)
def test_other_words_are_no_place_of_a_home(said):
    assert MAPS["home"].index.resolve(said).name is None


@pytest.mark.parametrize("said", ["parking area", "passing table", "changing point", "way 3", "box 3", "raw", "to", ""])
def test_other_words_are_no_place_of_a_warehouse(said):
    assert MAPS["warehouse"].index.resolve(said).name is None


def test_letters_are_told_apart_and_heard_by_their_sound():
    index = _index([f"aisle {letter}" for letter in string.ascii_lowercase])
    for letter in string.ascii_lowercase:
        assert index.resolve(f"aisle {letter}").name == f"aisle {letter}"
    assert index.resolve("aisle bee").name == "aisle b"
    assert index.resolve("isle tea").name == "aisle t"
    assert index.resolve("aisle bravo").name == "aisle b"
    assert _index(["aisle b", "aisle c"]).resolve("aisle d").name is None


@pytest.mark.parametrize(
    ("said", "name"),
    [
        *((said, None) for said in ("four", "the four", "my 4", "these four", "4", "an 4")),
        *((said, "A4") for said in ("a four", "A4", "the a 4", "a4")),
        *((said, "A B") for said in ("a b", "the a b")),
        ("b", None),
        ("lab", "a lab"),
    ],
)
def test_the_letter_of_a_code_is_no_article(said, name):
    assert _index(["A4", "B4", "C4", "A B", "a lab"]).resolve(said).name == name


@pytest.mark.parametrize(
    ("said", "name"),
    [
        *((said, "B3") for said in ("bee three", "be 3", "bravo three", "the bee three")),
        *((said, "C4") for said in ("see four", "charlie 4")),
        *((said, None) for said in ("to three", "see me", "bee", "bravo", "be free", "delta 3")),
    ],
)
def test_the_letter_of_a_code_is_heard_by_its_sound_before_a_number(said, name):
    assert _index(["B3", "C4", "E7"]).resolve(said).name == name


def test_a_place_really_called_so_wins_over_a_sound():
    index = _index(["bay 3", "bay tree"])
    assert index.resolve("bay tree").name == "bay tree"
    assert index.resolve("bay three").name == "bay 3"


# -- questions and suggestions --------------------------------------------------------------------------------


def test_near_ties_are_a_question():
    match = _index(["mane hall", "maine hall"]).resolve("mayne hall")
    assert match.status == "ambiguous"
    assert {name for name, _ in match.candidates} == {"mane hall", "maine hall"}


def test_aliases_of_one_place_are_no_rivals():
    match = NameIndex([("mane hall", "hall"), ("maine hall", "hall")]).resolve("mayne hall")
    assert (match.status, match.name) == ("fuzzy", "hall")


def test_a_number_left_out_is_a_question():
    match = MAPS["warehouse"].index.resolve("the bay")
    assert match.status == "ambiguous"
    assert [name for name, _ in match.candidates] == ["bay 1", "bay 2", "bay 3"]


@pytest.mark.parametrize("said", ["bay 99", "bay ninety nine", "bay 3 3", "bay -3", "bay 1/2", "bay 3.5", "third bay"])
def test_a_number_that_is_not_there_is_never_another(said):
    match = MAPS["warehouse"].index.resolve(said)
    assert match.name is None
    assert match.candidates


THINGS = NameIndex(
    [
        (name, name)
        for name in ("box", "battery", "knife", "roof", "tray", "glass", "light", "lights", "tooth", "mouse", "workman")
    ]
)


@pytest.mark.parametrize(
    ("said", "name"),
    [
        ("boxes", "box"),
        ("the batteries", "battery"),
        ("knives", "knife"),
        ("teeth", "tooth"),
        ("mice", "mouse"),
        ("the workmen", "workman"),
        ("rooves", "roof"),
        ("trays", "tray"),
        ("glasses", "glass"),
        ("lights", "lights"),
        ("light", "light"),
        ("bosses", None),
        ("foxes", None),
    ],
)
def test_more_of_a_thing_is_that_thing(said, name):
    assert THINGS.resolve(said).name == name


@given(st.text(alphabet=string.ascii_lowercase, min_size=1, max_size=20))
def test_what_is_unknown_comes_with_the_three_nearest(said):
    match = MAPS["home"].index.resolve(said)
    assume(match.status == "unknown")
    assert len(match.candidates) == 3
    scores = [score for _, score in match.candidates]
    assert scores == sorted(scores, reverse=True)
    assert len({name for name, _ in match.candidates}) == 3


# -- laws -----------------------------------------------------------------------------------------------------


@given(name_sets, st.data())
def test_a_typo_in_a_long_name_is_never_another_place(spoken, data):
    name = data.draw(st.sampled_from(spoken))
    letters = [place for place, letter in enumerate(name) if letter.isalpha()]
    assume(len(letters) >= 7)
    place = data.draw(st.sampled_from(letters))
    letter = data.draw(st.sampled_from(string.ascii_lowercase))
    typo = data.draw(st.sampled_from([name[:place] + name[place + 1 :], name[:place] + letter + name[place + 1 :]]))
    assume(typo not in spoken)
    assert _index(spoken).resolve(typo).name in (name, None)


@given(name_sets, names)
def test_names_that_differ_in_a_number_never_cross(spoken, said):
    match = _index(spoken).resolve(said)
    if match.name is not None:
        mine = [word for word in name_words(said) if is_identifier(word)]
        assert mine == [word for word in name_words(match.name) if is_identifier(word)]


@settings(max_examples=25)
@given(st.sampled_from(["de", "es", "fr", "it"]), *[st.integers(0, 999)] * 2)
def test_nor_do_numbers_in_words_of_other_languages(language: str, said: int, known: int) -> None:
    """ "Sala tres" is never "sala trece", nor "salle soixante-sept" "salle soixante-dix-sept"."""
    index = NameIndex([(f"sala {' '.join(spell(known, language))}", "there")], language)
    for heard in (str(said), " ".join(spell(said, language))):
        assert index.resolve(f"sala {heard}").name == ("there" if said == known else None)


@pytest.mark.parametrize(
    ("language", "said", "known"),
    [
        ("es", "sala trece", "sala tres"),
        ("fr", "salle soixante-sept", "salle soixante-dix-sept"),
        ("de", "Raum einhundertsieben", "Raum einhundertsiebzehn"),
        ("it", "sala cinquantadue", "sala cinquantotto"),
    ],
)
def test_such_numbers_sound_alike(language: str, said: str, known: str) -> None:
    index = NameIndex([(known, known)], language)
    assert index.resolve(said).name is None
    assert index.resolve(known).name == known


@given(st.integers(0, 9999), st.integers(0, 9999))
def test_a_number_is_its_value_and_no_other(said, known):
    from intent_engine.language.numbers.numerals import numeral_value

    match = _index([f"bay {known}"]).resolve(f"bay {said}")
    assert (match.name is not None) == (said == known)
    assert numeral_value(name_words(f"bay {said}")[1]) == said


@given(st.integers(0, 99_999))
def test_number_words_are_digits(value):
    words = _in_words(value)
    assert english.number(words) == value
    assert name_words(["bay", *words]) == ("bay", str(value))


@given(name_sets, st.text(max_size=40), st.randoms())
def test_the_order_of_the_file_decides_nothing(spoken, noise, random):
    shuffled = list(spoken)
    random.shuffle(shuffled)
    one, other = _index(spoken), _index(shuffled)
    for said in (noise, *spoken[:3], spoken[0] + noise, spoken[0][1:], " ".join(spoken[:2])):
        assert one.resolve(said) == other.resolve(said)


@settings(max_examples=300)
@given(st.one_of(st.text(max_size=200), st.lists(st.text(max_size=12), max_size=12)))
def test_nothing_that_is_said_is_an_error(said):
    for index in (MAPS["warehouse"].index, _index([]), _index(["a", "the", "3", "bay 3"])):
        match = index.resolve(said)
        assert isinstance(match, Match)
        assert match == index.resolve(said)
        assert (match.name is not None) == (match.status in ("exact", "fuzzy"))
        assert 0 <= match.score <= 1
        assert -1e-9 <= match.margin <= 1
        assert len(match.candidates) <= 3
        if match.name is not None:
            assert match.candidates[0][0] == match.name


@given(st.lists(st.text(max_size=20), max_size=10), st.text(max_size=20))
def test_any_text_may_be_a_name(spoken, said):
    index = _index(spoken)
    index.resolve(said)
    for name in spoken:
        match = index.resolve(name)
        if name_words(name):
            assert name in {name for name, _ in match.candidates} or match.status == "ambiguous"


@given(st.lists(st.sampled_from([*WORDS, "the", "a", "my", "3", "three"]), min_size=1, max_size=4))
def test_naming_twice_changes_nothing(words):
    once = name_words(words)
    assert name_words(once) == once
    assert without_article(without_article(once)) == without_article(once)


def _in_words(value: int) -> list[str]:
    ones = {number: word for word, number in (*english_words.DIGITS.items(), *english_words.TEENS.items())}
    tens = {number: word for word, number in english_words.TENS.items() if word != "fourty"}
    if value == 0:
        return ["zero"]
    for scale, word in ((1000, "thousand"), (100, "hundred")):
        if value >= scale:
            rest = _in_words(value % scale) if value % scale else []
            return [*_in_words(value // scale), word, *rest]
    if value in ones:
        return [ones[value]]
    rest = [ones[value % 10]] if value % 10 else []
    return [tens[value // 10 * 10], *rest]


def test_names_that_are_all_as_unlike_are_suggested_in_their_own_order():
    """More than are compared, and a word like none of them: which three are told must not be the file's doing."""
    spoken = [f"{word} {number}" for word in WORDS[:3] for number in range(9)]
    expected = _index(spoken).resolve("p").candidates
    assert expected
    assert _index(spoken[::-1]).resolve("p").candidates == expected


@given(name_sets, st.data(), st.sampled_from(["in", "at", "huh", "or so", "then", "is"]), st.booleans())
def test_a_name_that_was_said_as_it_is_takes_no_other_word_in(
    spoken: list[str], data: st.DataObject, other: str, before: bool
) -> None:
    """ "Charging station huh" is no way to say "charging station": the words beside a name say something."""
    name = data.draw(st.sampled_from(spoken))
    index = _index(spoken)
    assume(index.resolve(name).status == "exact")
    assert index.resolve(f"{other} {name}" if before else f"{name} {other}").name is None
    words = name.split()
    at = data.draw(st.integers(1, len(words)))
    assert index.resolve([*words[:at], *other.split(), *words[at:]]).name is None


@pytest.mark.parametrize("other", ["or", "and", "to", "no", "in", "er"])
def test_a_name_takes_no_word_between_its_own(other: str) -> None:
    """ "Bath or room" is no way to say "bathroom", nor "turbo or boost" "turbo boost"."""
    index = _index(["turbo boost", "bathroom", "charging station"])
    for said in (f"turbo {other} boost", f"bath {other} room", f"charging {other} station"):
        assert index.resolve(said).name is None, said
    assert index.resolve("charging the station").name == "charging station"
    assert index.resolve("bath room").name == "bathroom"
