"""What a transcript may move: nothing, where it is not sure that it was said; a stop, from less."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status
from intent_engine.judgement import CLEARLY, HARDLY_A_WORD, OTHER_WAY, SURE_BESIDE_A_STOP, SURE_THOUGH_HELD, Judge
from intent_engine.language.numbers.english import ALIKE, TEENS, TENS
from intent_engine.speech.endpoint import Outlook
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import (
    ANOTHER_WORD,
    SURE_ENOUGH,
    SURE_ENOUGH_OF_SEVERAL,
    SURE_ENOUGH_TO_STOP,
)

ROOT = Path(__file__).resolve().parent.parent
ONE, SEVERAL, STOP = "go forward two meters", "go forward two meters and turn left", "stop"


@pytest.fixture(scope="module")
def judge() -> Judge:
    return Judge(IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=ROOT / "locations" / "home.yaml"))


def heard(text: str, confidence: float | None, free: str = "oh forward to me does") -> Transcript:
    return Transcript(text, free_text=free, gap=1.0, confidence=confidence)


@pytest.mark.parametrize(
    ("text", "enough"), [(ONE, SURE_ENOUGH), (SEVERAL, SURE_ENOUGH_OF_SEVERAL), (STOP, SURE_ENOUGH_TO_STOP)]
)
def test_it_is_done_from_this_confidence_on(judge, text, enough):
    assert judge.meaning(heard(text, enough), (), ()).status is Status.ACCEPTED
    refused = judge.meaning(heard(text, enough - 0.01), (), ())
    assert refused.status is Status.REJECTED
    assert refused.actions == ()
    assert refused.text == "oh forward to me does", "what was heard, not what was looked for"
    assert refused.alternatives == (text,)
    assert refused.reason


@pytest.mark.parametrize(("confidence", "reason"), [(0.5, "perhaps 'go forward two meters'"), (0.1, "too different")])
def test_what_it_may_have_been_is_told_if_that_is_worth_it(judge, confidence, reason):
    assert reason in judge.meaning(heard(ONE, confidence), (), ()).reason


MOON = "Go to the moon."


@pytest.mark.parametrize("text", ["go to the lounge", "go", "go two miles and turn left", "burn a leaf", MOON])
def test_a_place_that_is_not_on_the_map_is_told_as_if_it_were_typed(judge, text):
    typed = judge.engine.parse(MOON)
    told = judge.meaning(heard(text, 0.1, MOON), (), ())
    assert (told.status, told.text, told.actions) == (Status.REJECTED, MOON, ())
    assert told.reason == typed.reason == "no place is called 'moon'"
    assert told.alternatives == typed.alternatives


@pytest.mark.parametrize(
    ("transcript", "reason"),
    [
        (heard("go to the lounge", 0.5, MOON), "perhaps 'go to the lounge'"),
        (replace(heard("go to the lounge", 0.1, MOON), score=CLEARLY - 0.01), "too different"),
        (heard("go to the lounge", 0.1, "we went to the moon"), "too different"),
        (heard("go to the lounge", 0.1, "don't go to the moon"), "too different"),
        (heard("do not go to the lounge", 0.1, MOON), "negated"),
    ],
    ids=["it is asked back", "hardly heard", "a story", "not to be done", "not to be done, perhaps"],
)
def test_but_only_where_it_was_clearly_said_and_nothing_else_is_worth_telling(judge, transcript, reason):
    assert reason in judge.meaning(transcript, (), ()).reason


WORDS = ["go to mars and turn left", "go to the", "turn left two", "don't go to the moon", "go to the kitchen", ""]
SENTENCES = st.sampled_from([ONE, SEVERAL, STOP, MOON, *WORDS])


@given(SENTENCES, SENTENCES, st.one_of(st.none(), st.floats(0, 1)), st.floats(-3, 0))
def test_only_the_wording_of_a_rejection_hangs_on_the_words_that_were_heard(judge, text, free, confidence, score):
    transcript = Transcript(text, score, free, gap=1.0, confidence=confidence)
    told = judge.meaning(transcript, (), ())
    otherwise = judge.meaning(replace(transcript, free_text="oh forward to me does"), (), ())
    assert (told.status, told.actions) == (otherwise.status, otherwise.actions)


@pytest.mark.parametrize(("gap", "status"), [(ANOTHER_WORD, Status.ACCEPTED), (ANOTHER_WORD + 0.01, Status.REJECTED)])
def test_a_stop_must_be_surer_where_another_word_is_much_likelier(judge, gap, status):
    wow = Transcript("whoa", free_text="Wow", gap=gap, confidence=SURE_ENOUGH_TO_STOP)
    assert judge.meaning(wow, (), ()).status is status
    sure = Transcript("whoa", free_text="Wow", gap=gap, confidence=SURE_ENOUGH)
    assert judge.meaning(sure, (), ()).status is Status.ACCEPTED


@pytest.mark.parametrize("text", [ONE, SEVERAL, STOP])
def test_a_recogniser_that_is_not_steered_is_believed(judge, text):
    assert judge.meaning(heard(text, None, text), (), ()).status is Status.ACCEPTED


def test_an_unsure_sentence_is_waited_for_by_the_words_that_were_heard(judge):
    meaning, outlook = judge.outlook(heard("go to the dock", 0.2, "go to the"), (), ())
    assert meaning is not None
    assert meaning.actions == ()
    assert outlook is Outlook.INCOMPLETE
    _, outlook = judge.outlook(heard("go to the dock", 0.2, "goats eat a dog"), (), ())
    assert outlook is Outlook.OTHER


@pytest.mark.parametrize(
    ("confidence", "score", "outlook"),
    [
        (0.9, CLEARLY - 0.01, Outlook.DOUBTFUL),
        (0.9, CLEARLY, Outlook.EXTENDABLE),
        (1.0, CLEARLY - 0.01, Outlook.EXTENDABLE),
        (None, CLEARLY - 0.01, Outlook.EXTENDABLE),
    ],
)
def test_what_was_hardly_heard_and_could_go_on_is_waited_for_longer(judge, confidence, score, outlook):
    left = Transcript("turn left", score, "turned left", gap=0.1, confidence=confidence)
    assert judge.outlook(left, (), ())[1] is outlook
    over = Transcript("go to the dock", score, "goat to the dock", gap=0.1, confidence=confidence)
    known = Outlook.SETTLED if confidence == 0.9 else Outlook.COMPLETE
    assert judge.outlook(over, (), ())[1] is known, "nothing can follow what was heard word by word"


@pytest.mark.parametrize(
    ("text", "outlooks"),
    [
        ("turn left", (Outlook.AMENDABLE, Outlook.EXTENDABLE)),
        ("go to the dock", (Outlook.COMPLETE, Outlook.COMPLETE)),
        ("turn left ninety degrees", (Outlook.COMPLETE, Outlook.COMPLETE)),
        ("turn left then turn right ninety degrees", (Outlook.SETTLED, Outlook.SETTLED)),
        ("pick up the cup", (Outlook.AMENDABLE, Outlook.EXTENDABLE)),
        ("put down the cup", (Outlook.EXTENDABLE, Outlook.DOUBTFUL)),
        ("put the cup on the table", (Outlook.AMENDABLE, Outlook.EXTENDABLE)),
        ("put the cup on the table then go forward", (Outlook.EXTENDABLE, Outlook.DOUBTFUL)),
        ("turn left then go forward", (Outlook.EXTENDABLE, Outlook.DOUBTFUL)),
    ],
)
def test_a_motion_that_can_be_put_right_is_waited_for_less(judge, text, outlooks):
    continuing = Judge(judge.engine, continuing=True)
    for score, outlook in zip((CLEARLY, CLEARLY - 0.01), outlooks, strict=True):
        assert continuing.outlook(Transcript(text, score, "-", gap=0.1, confidence=0.95), (), ())[1] is outlook


@pytest.mark.parametrize("text", ["Move backward for meters.", "Could you go back to meters?", "go forward to feet"])
def test_a_number_that_was_written_as_a_word_of_its_sound_is_one(judge, text):
    """Else the whole sentence would be waited for as one that may go on anyhow."""
    continuing = Judge(judge.engine, continuing=True)
    assert continuing.outlook(Transcript(text, 0.0, text, gap=0.0, confidence=1.0), (), ())[1] is Outlook.COMPLETE


def test_a_motion_that_cannot_be_put_right_waits_for_its_manner(judge):
    assert judge.outlook(Transcript("turn left ninety degrees", 0.0, "-", confidence=1.0), (), ())[1] is Outlook.SETTLED


@pytest.mark.parametrize(
    ("text", "outlook"),
    [("sleep for an hour", Outlook.EXTENDABLE), ("sleep for ten minutes", Outlook.SETTLED)],
)
def test_who_says_an_hour_may_go_on_after_a_rest(tmp_path, text, outlook):
    file = tmp_path / "timer.yaml"
    file.write_text(
        "slots: {length: duration}\nintents: {timer: {action: custom, sentences: ['sleep for {length}']}}\n"
    )
    judge = Judge(IntentEngine.from_files(file), continuing=True)
    assert judge.outlook(Transcript(text, 0.0, "-", confidence=1.0), (), ())[1] is outlook


def test_a_motion_is_not_waited_for_since_it_can_be_put_right(judge):
    continuing = Judge(judge.engine, continuing=True)
    heard = Transcript("go forward one meter", 0.0, "-", confidence=1.0)
    assert continuing.outlook(heard, (), ())[1] is Outlook.COMPLETE
    assert judge.outlook(heard, (), ())[1] is Outlook.EXTENDABLE


@pytest.mark.parametrize(("text", "done"), [("turn left fifteen degrees", False), ("stop", True)])
def test_a_word_that_was_not_heard_clearly_is_asked_back(judge, text, done):
    meaning = judge.meaning(Transcript(text, free_text=text, confidence=1.0, unclear=("fifteen",)), (), ())
    assert (meaning.status is Status.ACCEPTED) is done
    assert done or "say it again" in meaning.reason


@pytest.mark.parametrize(
    ("unclear", "reason"),
    [
        (("sixteen",), "'sixteen' may have been 'sixty'; say it again"),
        (("turn",), "'turn' was not heard clearly; say it again"),
        (("turn", "turn"), "'turn' was not heard clearly; say it again"),
        (("turn", "left"), "'turn' and 'left' were not heard clearly; say it again"),
        (("turn", "forty"), "'forty' may have been 'fourteen', 'turn' was not heard clearly; say it again"),
    ],
)
def test_what_was_not_clear_is_told_with_what_it_may_have_been(judge, unclear, reason):
    text = "turn left sixteen degrees"
    assert judge.meaning(Transcript(text, free_text=text, confidence=1.0, unclear=unclear), (), ()).reason == reason


def test_what_was_left_out_is_told_with_the_command_it_is_no_part_of(judge):
    text = "go to the kitchen"
    meaning = judge.meaning(Transcript(text, free_text=text, confidence=0.95, left_out=("do you",)), (), ())
    assert meaning.status is Status.REJECTED
    assert meaning.reason == "'do you' was said too, and is no part of 'go to the kitchen'; say it again"


@pytest.mark.parametrize("word", ALIKE)
def test_numbers_that_sound_alike_are_each_others(word):
    assert ALIKE[ALIKE[word]] == word
    low, high = sorted((TEENS | TENS)[one] for one in (word, ALIKE[word]))
    assert high == (low - 10) * 10


OWN_WAITS = """
intents:
  order: {action: {type: custom, name: order}, sentences: ["a latte [with milk]"], wait: 450 ms}
  wave: {action: {type: custom, name: wave}, sentences: ["wave [at me]"], wait: 0.2}
  bow: {action: {type: custom, name: bow}, sentences: ["bow [low]"]}
"""


@pytest.mark.parametrize(
    ("text", "wait"),
    [
        ("a latte", 0.45),
        ("wave", 0.2),
        ("bow", None),
        ("wave and a latte", 0.45),
        ("bow and wave", 0.2),
        ("fetch a pony", None),
        ("don't wave", None),
    ],
)
def test_an_intent_says_how_long_it_waits_for_more(tmp_path, text, wait):
    (tmp_path / "own.yaml").write_text(OWN_WAITS, encoding="utf-8")
    judge = Judge(IntentEngine.from_files(tmp_path / "own.yaml"))
    transcript = heard(text, 1.0)
    meaning, _ = judge.outlook(transcript, (), ())
    assert judge.wait(transcript, meaning) == wait


OWN_RISK = """
intents:
  order: {action: {type: custom, name: order}, sentences: ["a large latte"], min_confidence: 0.4}
  launch: {action: {type: custom, name: launch}, sentences: ["launch the rocket"], min_confidence: 0.95}
  wave: {action: {type: custom, name: wave}, sentences: ["wave at me"]}
  halt: {action: stop, sentences: ["cut it"], min_confidence: 0.95}
"""


@pytest.mark.parametrize(
    ("text", "enough"),
    [
        ("a large latte", 0.4),
        ("launch the rocket", 0.95),
        ("wave at me", SURE_ENOUGH),
        ("a large latte and wave at me", SURE_ENOUGH_OF_SEVERAL),
        ("a large latte and launch the rocket", 0.95),
        ("cut it", SURE_ENOUGH_TO_STOP),
    ],
)
def test_an_intent_says_how_sure_it_must_be_but_a_stop_is_never_harder(tmp_path, text, enough):
    (tmp_path / "own.yaml").write_text(OWN_RISK, encoding="utf-8")
    judge = Judge(IntentEngine.from_files(tmp_path / "own.yaml"))
    assert judge.meaning(heard(text, enough), (), ()).status is Status.ACCEPTED
    assert judge.meaning(heard(text, enough - 0.01), (), ()).actions == ()


@pytest.mark.parametrize(
    ("text", "free_text", "score", "confidence", "stops"),
    [
        ("go", "Oh", HARDLY_A_WORD - 0.1, 0.74, True),
        ("go", "Oh", HARDLY_A_WORD - 0.1, SURE_THOUGH_HELD, False),
        ("go", "Go!", HARDLY_A_WORD - 0.1, 0.9, True),
        ("go", "Go!", HARDLY_A_WORD + 0.1, 0.9, True),
        ("lets go", "Let's go!", HARDLY_A_WORD + 0.1, 0.78, True),
        ("lets go", "Let's go!", HARDLY_A_WORD + 0.1, SURE_THOUGH_HELD, False),
        ("moving on", "moving of moving,", -0.5, 0.79, True),
        ("moving on", "moving of moving,", -0.5, SURE_THOUGH_HELD, False),
        ("go two meters", "Go 2 meters", HARDLY_A_WORD + 0.1, 0.74, False),
        ("back", "Oh", HARDLY_A_WORD - 0.1, 0.09, True),
        ("seven", "7", -0.3, 0.0, False),
        ("stop", "Oh", HARDLY_A_WORD - 0.1, 0.46, True),
        ("go back", "start spreading", HARDLY_A_WORD - 0.1, 0.34, True),
        ("go back", "please now take one", HARDLY_A_WORD - 0.1, 0.34, False),
        ("don't stop", "Oh", HARDLY_A_WORD - 0.1, 1.0, True),
    ],
)
def test_a_stop_that_was_felt_stays_one_unless_another_was_heard(judge, text, free_text, score, confidence, stops):
    """What was "stop" in noise became "go" (0.74), and the robot drove on."""
    transcript = Transcript(text, score, free_text, gap=1.0, confidence=confidence)
    alone = judge.meaning(transcript, (), ())
    held = judge.held(transcript, alone)
    assert held.stops is stops
    if not stops or alone.stops:
        assert held is alone


@pytest.mark.parametrize(
    ("text", "alternatives", "behind", "confidence", "done"),
    [
        ("go", ("come", "stop"), (), SURE_BESIDE_A_STOP - 0.01, False),
        ("go", ("come", "stop"), (1.0, 6.0), SURE_BESIDE_A_STOP - 0.01, False),
        ("go", ("come", "stop"), (1.0, 7.0), SURE_ENOUGH, True),
        ("go", ("come", "stop"), (), SURE_BESIDE_A_STOP, True),
        ("go", ("come", "right"), (), SURE_ENOUGH, True),
        ("go back two meters", ("stop",), (), SURE_ENOUGH, True),
    ],
)
def test_a_word_that_may_have_been_a_stop_must_be_surer(judge, text, alternatives, behind, confidence, done):
    """Of 464 "stop" in noise four were heard "go", and the robot drove off. But any word is compared with a "stop"."""
    transcript = Transcript(text, -2.0, text, alternatives=alternatives, behind=behind, confidence=confidence)
    assert bool(judge.meaning(transcript, (), ()).actions) is done


@pytest.mark.parametrize(
    ("text", "other", "nats", "done"),
    [
        ("going forward slowly", "going rearward slowly", OTHER_WAY - 0.1, False),
        ("going forward slowly", "going rearward slowly", OTHER_WAY, True),
        ("going forward slowly", "going onward slowly", 0.1, True),
        ("turn left", "turn right", 0.5, False),
        ("turn left and go back", "turn left and go forward", 0.5, False),
        ("go to the kitchen", "go back", 0.5, True),
        ("stop", "go back", 0.5, True),
    ],
)
def test_what_may_as_well_have_been_the_other_way_is_asked_back(judge, text, other, nats, done):
    transcript = Transcript(text, -0.9, "go wound", gap=0.4, confidence=0.95, alternatives=(other,), behind=(nats,))
    found = judge.meaning(transcript, (), ())
    assert bool(found.actions) is done
    if not done:
        assert found.alternatives == (text, other)
        assert found.reason == f"{text!r} or {other!r}, the other way? say it again"
    exactly = replace(transcript, text=text, free_text=text, gap=0.0, confidence=1.0)
    assert judge.meaning(exactly, (), ()).actions, "word by word there is nothing to ask"


def test_the_other_way_is_asked_back_in_a_state_that_both_need(engine_of):
    judge = Judge(
        engine_of(
            "intents:\n  crawl:\n    action: {type: move, direction: '{way}'}\n    requires: [docked]\n"
            "    sentences: ['crawl {way}']\nslots:\n  way: {type: choice, values: [forward, backward]}\n"
        )
    )
    words, other = "crawl forward", "crawl backward"
    transcript = Transcript(words, -0.9, "all forward", gap=0.4, confidence=0.95, alternatives=(other,), behind=(0.5,))
    assert judge.meaning(transcript, ("docked",), ()).reason.endswith("the other way? say it again")
    assert "docked" in judge.meaning(transcript, (), ()).reason


BOX = """
language: en
intents:
  fold: {action: custom, sentences: ["fold it [now]"]}
  unfold: {action: custom, sentences: ["unfold it [now]"]}
  wrap: {action: custom, sentences: ["wrap it"]}
  undo: {action: {type: custom, name: fold}, sentences: ["unlace it"]}
  lace: {action: {type: custom, name: fold}, sentences: ["lace it"]}
"""


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("and fold it", "unfold it"),
        ("And fold it now.", "unfold it now"),
        ("then fold it", None),
        ("fold it", None),
        ("unfold it", None),
        ("and wrap it", None),
        ("wrap it and fold it", None),
        ("and lace it", None),  # both do the same
    ],
)
@pytest.mark.parametrize("state", [(), ("docked",)])
def test_an_and_that_may_be_the_beginning_of_another_verb_is_asked_back(engine_of, text, other, state):
    grammar = BOX.replace("action: custom,", "action: custom, requires: [docked],") if state else BOX
    found = Judge(engine_of(grammar)).meaning(Transcript(text, free_text=text, confidence=1.0), state, ())
    assert bool(found.actions) is (other is None)
    if other is not None:
        assert found.reason == f"{text!r} or {other!r}? say it again"
        assert found.alternatives == (text, other)


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("do a full circle turn and clockwise", "do a full circle turn anticlockwise"),
        ("turn left and clockwise", None),  # one command with "anticlockwise" does not exist
        ("do a full circle turn then clockwise", None),
        ("go forward and turn left", None),
    ],
)
def test_so_is_one_between_two_commands_if_the_same_sound_is_one(judge, text, other):
    found = judge.meaning(Transcript(text, free_text=text, confidence=1.0), (), ())
    assert found.alternatives == ((text, other) if other else ())
    assert len(found.actions) == (0 if other else 2)
