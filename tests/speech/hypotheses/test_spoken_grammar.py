"""What a grammar says of words that may have been spoken."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.networks.approximate import FreeWord
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("turn left ninety degrees", True),
        ("please turn left ninety degrees", True),
        ("turn left ninety degrees please", True),
        ("turn left please and go forward", True),
        ("turn left and then go forward two meters", True),
        ("go to the kitchen i mean the bedroom", True),
        ("turn left no right", True),
        ("turn like by sixteen degrees", True),
        ("turn right five hundred and fourteen degrees", False),
        ("turn right three hundred and sixty degrees", True),
        ("pick up the cup", True),
        ("pick up the florble", False),
    ],
)
def test_what_people_say_is_plain(engine, grammar, text, plain):
    meaning = engine.parse(text)
    assert meaning.status is Status.ACCEPTED
    assert grammar.plain(text.split(), meaning) is plain


@pytest.mark.parametrize(
    ("language", "text", "inside"),
    [
        ("en", "turn like by sixteen degrees", ["like"]),
        ("en", "turn left please and go forward", ["please"]),
        ("en", "please turn left thank you", []),
        ("de", "fahr bitte mal in die küche", ["bitte", "mal", "mal"]),
        ("de", "fahr in die küche bitte", []),
    ],
)
def test_words_that_say_nothing_between_others(root, language, text, inside):
    engine = IntentEngine.from_files(root / "grammars" / f"{language}.yaml", locations=root / "locations/zuhause.yaml")
    assert SpokenGrammar(engine).empty_inside(text.split(), language) == inside


@pytest.fixture(scope="module")
def german(root) -> SpokenGrammar:
    engine = IntentEngine.from_files(root / "grammars/de.yaml", locations=root / "locations/zuhause.yaml")
    return SpokenGrammar(engine)


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("Ge einen halben Meter zurück.", "geh einen halben meter zurück"),
        ("Far drei Meter zurück", "fahr drei meter zurück"),
        ("Fahr 25 Zentimeta vorwärts", "fahr fünfundzwanzig zentimeter vorwärts"),
        ("Drehe dich um 45° nach rächts", "drehe dich um fünfundvierzig grad nach rechts"),
        ("Fahrer bitte anderthalb Meter vorwärts.", "fahre bitte anderthalb meter vorwärts"),
        ("Far 1,5 Meter vor", "fahr eins komma fünf meter vor"),
        ("Kom bitte zur Ladestation", "komm bitte zur ladestation"),
        ("Dreh dich mal nach lings", "dreh dich mal nach links"),
    ],
)
def test_german_numbers_and_politeness_are_looked_for(german, heard, said):
    assert tuple(said.split()) in german.near(german.words(heard, "de"), "de")


@pytest.mark.parametrize("heard", ["Far nicht in die Küche", "Treh dich nicht um", "Nim nicht die Tasse"])
def test_what_shall_not_be_done_is_nearest_to_itself_in_german(german, heard):
    nearest, *_ = german.near(german.words(heard, "de"), "de")
    assert "nicht" in nearest
    assert not german.parse(" ".join(nearest), "de").actions


def test_a_short_word_that_may_stand_anywhere_is_not_made_up(german):
    """ "Dreh dich um 90 Grad nach" goes on; with a "noch" for the "nach" it was a turn to the left."""
    for sentence in german.near(german.words("Dreh dich um 90 Grad nach", "de"), "de"):
        assert sentence[-1] != "noch" or not german.possible(sentence, (), "de")


def test_a_number_is_plain_in_every_language(root):
    german = IntentEngine.from_files(root / "grammars" / "de.yaml")
    for text in ("fahr einen halben meter vor", "geh zweieinhalb meter nach hinten", "fahr 2 meter vor"):
        assert SpokenGrammar(german).plain(text.split(), german.parse(text), "de"), text
    text = "nimm die flurbe"
    assert not SpokenGrammar(german).plain(text.split(), german.parse(text), "de")


@pytest.mark.parametrize(
    ("text", "unknown"),
    [
        ("take the cup", False),
        ("put the cup on the table", False),
        ("go to the kitchen and pick up the bottle", False),
        ("take meter from the living room", True),
        ("pick up the florble", True),
        ("go to the kitchen and pick up the meter", True),
    ],
)
def test_a_word_of_the_grammar_is_no_thing_that_it_knows(engine, grammar, text, unknown):
    meaning = engine.parse(text)
    assert meaning.status is Status.ACCEPTED
    assert grammar.unknown(text.split(), meaning, "en") is unknown


@pytest.mark.parametrize(
    ("text", "story", "possible"),
    [
        ("turn left", (), True),
        ("do not turn left", (), True),
        ("the orchestra played", (), False),
        ("turn left", ("when",), False),
        ("head to the kitchen", ("had",), True),
        ("so now", (), False),
        ("take me to duck", (), False),
    ],
    ids=["a command", "a refusal", "no sentence", "a story", "what may have been misheard", "sounds", "a near name"],
)
def test_what_may_be_meant(grammar, text, story, possible):
    assert grammar.possible(text.split(), story) is possible


@pytest.mark.parametrize(
    ("text", "lead"), [("turn left", 0), ("and then please turn left", 3), ("please", 0), ("all right turn left", 2)]
)
def test_what_says_nothing_at_the_beginning(grammar, text, lead):
    assert grammar.lead(text.split()) == lead


@pytest.mark.parametrize(
    ("language", "words", "negated"),
    [
        ("en", "never go back", True),
        ("en", "dont go back", True),
        ("en", "when we go back", True),
        ("en", "ever go back", False),
        ("en", "a hundred percent get me a mocha", False),
        ("de", "fahr nicht zurueck", True),
        ("de", "fahr zurueck", False),
    ],
)
def test_a_word_with_which_nothing_is_done(language, words, negated):
    spoken = SpokenGrammar(IntentEngine.from_files(["grammars/en.yaml", "grammars/de.yaml"]))
    assert spoken.negated(words.split(), language) is negated


def test_a_stop_of_words_that_may_stand_anywhere(engine_of):
    spoken = SpokenGrammar(
        engine_of("""
language: en
fillers: [now, so]
operators: {stop: [so now]}
intents:
  go: {action: move, sentences: ["go [now]", "now so"], defaults: {direction: forward, distance: 1 m}}
""")
    )
    assert spoken.parse("now so").actions
    assert not spoken.possible(("now", "so"))
    assert spoken.possible(("go", "now"))
    assert spoken.possible(("so", "now"))


def test_sentences_like_the_words_heard_are_near(grammar):
    assert ("go", "forward", "two", "meters") in grammar.near(["go", "for", "word", "two", "meters"])
    assert grammar.near(["xylophone"]) == []


@pytest.mark.parametrize(
    "heard", ["go forward half the meter", "turn left half the turn", "go back for half the minute"]
)
def test_near_a_quantity_that_nobody_says_is_one_that_people_say(grammar, heard):
    """And not only others that are none."""
    said = tuple(heard.replace("the", "a").split())
    first = next(words for words in grammar.near(heard.split()) if grammar.possible(words, heard=heard.split()))
    assert first == said


def test_numbers_are_words(grammar):
    assert grammar.words("Turn left by 15 degrees!") == ["turn", "left", "by", "fifteen", "degrees"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1. Go to the kitchen.", "go to the kitchen"),
        ("1 meter back.", "one meter back"),
        ("1.5 meters back", "one point five meters back"),
        ("90. degrees left", "ninety degrees left"),
        ("Go back 1. Meter", "go back one meter"),
        ("1.", "one"),
    ],
)
def test_the_number_of_a_sentence_in_a_list_was_not_said(grammar, text, words):
    assert grammar.words(text) == words.split()


def test_what_is_known_is_of_the_grammar_that_is_loaded(tmp_path):
    """A robot that learns a command hears it."""
    file = tmp_path / "en.yaml"
    intent = "intents:\n  {0}:\n    sentences: [{0}]\n    action: {{type: custom, name: {0}}}\n"
    file.write_text("language: en\n" + intent.format("dance"))
    engine = IntentEngine.from_files(file)
    grammar = SpokenGrammar(engine)
    before = grammar.search()
    assert grammar.near(["dance"]) == [("dance",)]
    assert grammar.search() is before, "what was learnt of it is kept"
    assert grammar.parse("dance").actions
    assert grammar.parse("dance") is grammar.parse("dance"), "nor is it read again what a sentence means"
    file.write_text("language: en\n" + intent.format("whistle"))
    engine.reload()
    assert grammar.near(["dance"]) == []
    assert not grammar.parse("dance").actions
    assert grammar.near(["whistle"]) == [("whistle",)]
    assert grammar.search() is not before


def test_free_words_are_words():
    assert FreeWord("cup") == "cup"


def test_please_says_nothing(engine):
    grammar = SpokenGrammar(engine)
    assert grammar.says_nothing(["please"])
    assert not grammar.says_nothing(["please", "slowly"])
    assert not grammar.says_nothing(["six", "miles"])


@pytest.mark.parametrize(
    ("text", "unlisted"),
    [
        ("pick up the red cup", []),
        ("grab the yellow to the box", ["to"]),
        ("go forward two meters then pick up the flurb", ["flurb"]),
        ("go to the kitchen then turn left", []),
    ],
)
def test_the_words_of_a_slot_that_no_list_has_there(engine, text, unlisted):
    assert SpokenGrammar(engine).unlisted(engine.parse(text)) == unlisted


def test_what_a_sentence_says_by_itself_is_listed(engine_of) -> None:
    """Nobody says "up" with "lift the arm", so no model has to hear it."""
    engine = engine_of("""
language: en
slots: {thing: {type: text}}
intents:
  lift:
    action: custom
    sentences: [{say: "lift the arm", slots: {way: up}}, {say: "lower the {thing}", slots: {way: all down}}]
""")
    grammar = SpokenGrammar(engine)
    assert grammar.unlisted(engine.parse("lift the arm")) == []
    assert grammar.unlisted(engine.parse("lower the flurb")) == ["flurb"]


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("Kitchen", "kitchen"),
        ("Living Room", "living room"),
        ("Bay B12", "bay b twelve"),
        ("Room 204", "room two oh four"),
        ("X-ray", "x ray"),
        ("Dr. Miller's office", "doctor miller's office"),
        ("Café Luna", "cafe luna"),
        ("ICU", "ICU"),
    ],
)
def test_a_place_is_listed_however_the_map_writes_it(root, tmp_path, name, said):
    (tmp_path / "map.yaml").write_text(f'locations:\n  "{name}": {{x: 1, y: 2}}\n', "utf-8")
    engine = IntentEngine.from_files(root / "grammars" / "en.yaml", locations=tmp_path / "map.yaml")
    grammar, meaning = SpokenGrammar(engine), engine.parse(f"go to {said}")
    assert meaning.slots == {"place": name}
    assert grammar.unlisted(meaning) == []
    assert grammar.unlisted(engine.parse(f"go to {said} and then pick up the flurb")) == ["flurb"]


@pytest.mark.parametrize(
    ("words", "share"),
    [("go to the kitchen", 1.0), ("go 2.5 meters", 1.0), ("go to my gorgeous kitchen unicorn", 4 / 6), ("", 1.0)],
)
def test_how_many_of_the_words_heard_the_grammar_has(grammar, words, share):
    assert grammar.share_known(words.split()) == pytest.approx(share)


PEOPLE = """
language: en
fillers: [please]
slots:
  name: {type: text, max_words: 2}
  thing: {type: text, known: [cup, ball]}
intents:
  call: {action: {type: custom, name: call}, sentences: ["call {name}", "bring {thing} to {name}", "take {thing}"]}
"""


@pytest.fixture(scope="module")
def people(engine_of) -> SpokenGrammar:
    return SpokenGrammar(engine_of(PEOPLE))


@pytest.mark.parametrize(
    ("text", "taken"),
    [
        ("call jessica", True),
        ("please call uncle bob", True),
        ("bring the cup to jessica", True),
        ("call jessica and then take the cup", True),
        ("take the cup and bring the ball to uncle bob", True),
        ("please call jessica then call uncle bob", True),
        ("call jessica and then take the flurb", False),
        ("call jessica and then", False),
        ("take the cup and take the ball", False),
        ("bring the flurb to jessica", False),
        ("take the flurb", False),
        ("take the cup", False),
        ("greet jessica", False),
        ("", False),
    ],
)
def test_a_slot_without_a_list_takes_words_as_they_are_heard(people, text, taken):
    """In one that has a list a word that it does not have may be a misheard one that it has."""
    assert people.takes_as_heard(text.split()) is taken


@pytest.mark.parametrize(
    ("words", "fits"),
    [("code a x", True), ("code a x today", False), ("ring", False), ("stop", False), ("and the clockwise", False)],
)
def test_words_as_they_are_fit_a_pattern_of_which_nobody_knows_what_else_it_has(tmp_path, words, fits):
    (tmp_path / "g.yaml").write_text(
        "language: en\nintents:\n"
        "  code: {action: custom, regex: 'code [a-z](?: [a-z]{3}| [a-z])'}\n"
        "  ring: {action: custom, sentences: [ring, clockwise]}\n"
        "  stop: {action: stop, sentences: [stop]}\n",
        "utf-8",
    )
    engine = IntentEngine.from_files(tmp_path / "g.yaml")
    assert not engine.matcher().patterns.networks
    assert SpokenGrammar(engine).fits_pattern(words.split()) is fits


@pytest.mark.parametrize("number", ["seventy", "twenty", "two and a half", "minus three"])
def test_a_number_beyond_its_limits_may_have_been_said(engine_of, number):
    gates = SpokenGrammar(
        engine_of("""
slots: {gate: {type: number, min: 1, max: 16, whole: true}}
intents: {bring: {action: custom, sentences: ["bring it to gate {gate}"]}}
""")
    )
    assert gates.possible(("bring", "it", "to", "gate", *number.split()))


def test_the_other_names_of_places_are_known_words(engine):
    """Else "head lounge" is half unknown, like talk, and "go to the family room" compared with all other sentences."""
    grammar = SpokenGrammar(engine)
    for said in ("go to the family room", "head lounge", "navigate to the charging station"):
        words = said.split()
        assert grammar.share_known(words) == 1
        assert not grammar.unknown(words, grammar.parse(said))


@pytest.mark.parametrize(
    ("words", "any_"),
    [
        ("take the cup", True),
        ("please put the ball on the table", True),
        ("turn left ninety degrees", False),
        ("go to the kitchen", False),
        ("stop", False),
        ("what a nice day", True),
    ],
)
def test_whether_a_slot_could_hold_any_other_words(engine, words, any_):
    assert SpokenGrammar(engine).holds_any_words(words.split(), "en") is any_


DOCK, BOTH, LOUNGE = (
    tuple(text.split())
    for text in ("go to the lounge no the dock", "go to the lounge and the dock", "go to the lounge")
)


@pytest.mark.parametrize(
    ("heard", "left"),
    [
        (["go to the lounge know the duck", "go to the lounge no the dock"], [DOCK]),
        (["go to the lounge know the duck", "go to the lounge and the duck"], [DOCK, BOTH, LOUNGE]),
        (["go to the lounge as you know the duck", "go to the lounge as you know"], [DOCK, BOTH, LOUNGE]),
        (["no go to the lounge", "no go to the lounge"], [DOCK, BOTH, LOUNGE]),
        (["go to the lounge no the dock"], [DOCK, BOTH, LOUNGE]),
    ],
    ids=["by both", "by one", "what is known", "at the beginning", "one model"],
)
def test_what_both_heard_taken_back_is_not_all_done(grammar, heard, left):
    assert grammar.taking_back([DOCK, BOTH, LOUNGE], [one.split() for one in heard]) == left
    assert grammar.taking_back([BOTH, LOUNGE], [one.split() for one in heard]) == [BOTH, LOUNGE]


def test_what_only_means_something_in_a_state_may_have_been_said(engine_of):
    """A recogniser does not know in which state the robot is, and a sentence sounds the same in each."""
    docks = SpokenGrammar(engine_of("intents: {undock: {action: custom, requires: [docked], sentences: [leave now]}}"))
    assert docks.parse("leave now").actions


DOORS = """
language: en
slots: {dance: [waltz, tango]}
intents:
  sit: {action: custom, sentences: ["sit down"]}
  stand: {action: custom, sentences: ["stand up"]}
  dance: {action: custom, sentences: ["dance the {dance}"]}
  follow: {action: custom, sentences: ["follow me"]}
"""


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Don't sit down, stand up.", True),
        ("Don't dance the waltz but the tango.", True),
        ("Would you mind following me?", True),
        ("Would you mind following me and sitting down?", True),
        ("Don't sit down, dance the polka.", False),
        ("Would you mind swallowing me?", False),
    ],
)
def test_words_of_how_a_command_is_put_are_no_strange_ones(engine_of, text, plain):
    """No sentence of this grammar has a "don't", or a "following"."""
    grammar = SpokenGrammar(engine_of(DOORS))
    meaning = grammar.parse(text)
    assert bool(meaning.actions) is plain
    assert grammar.plain(grammar.words(text), meaning) is plain


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("turn the land in the hall on", "turn the lamp in the hall on"),
        ("open the door and the wind though", "open the door and the window"),
        ("close the door and the wind though and the gate", "close the door and the window and the gate"),
    ],
)
def test_sentences_that_are_put_otherwise_are_near(engine_of, heard, said):
    grammar = SpokenGrammar(
        engine_of(
            "slots: {lamp: [lamp, fan], opening: [door, window, gate], room: [hall, lab]}\nintents:\n"
            "  'on': {action: custom, sentences: ['turn on the {lamp} [in the {room}]']}\n"
            "  open: {action: custom, sentences: ['open the {opening}']}\n"
            "  close: {action: custom, sentences: ['close the {opening}']}\n"
        )
    )
    assert tuple(said.split()) in grammar.near(heard.split())
    assert grammar.put_otherwise(said.split())
    assert not grammar.put_otherwise(["open", "the", "door", "and", "turn", "on", "the", "lamp"])


CODES = """
language: en
slots:
  place: location
  bay: [B5, C12]
  time: duration
intents:
  go: {action: {type: navigate, location: "{place}"}, sentences: ["go to {place}"]}
  scan: {action: custom, sentences: ["scan bay {bay} [for {time}]"]}
"""


def test_letters_are_those_of_codes_and_not_of_units(tmp_path):
    """ "4 s" are four seconds, of which nobody asks whether they were a bay."""
    (tmp_path / "codes.yaml").write_text(CODES)
    (tmp_path / "map.yaml").write_text("frame: map\nlocations: {gate h7: {x: 1, y: 2}}\n")
    engine = IntentEngine.from_files(tmp_path / "codes.yaml", locations=tmp_path / "map.yaml")
    letters = SpokenGrammar(engine).letters("en")
    assert letters >= {"b", "c", "h"}
    assert letters.isdisjoint("sm")
