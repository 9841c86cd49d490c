"""Two models: what becomes of what both heard."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from two_models import FORWARD, LEFT, LIKELY, SOUND, Knows, Thinks, heard, two

from intent_engine.engine import IntentEngine
from intent_engine.speech.hypotheses.combination import AGREED
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.second_opinion import SURE_TOGETHER
from intent_engine.speech.thresholds import ANOTHER_WORD, SURE_ENOUGH_TO_STOP

SENTENCES = [FORWARD, LEFT, "go back", "stop", "turn left fifteen degrees"]
TEXTS = st.sampled_from([*SENTENCES, "the weather is nice", "don't turn left"])
SCORES = st.dictionaries(st.sampled_from(SENTENCES), st.floats(-30, -0.1), max_size=4)
DOUBTFUL = st.builds(Thinks, st.builds(heard, TEXTS, st.floats(0.05, 0.39), score=st.just(-0.9)), SCORES)


def both_think(engine, first: Transcript | Thinks, second: Transcript | Thinks) -> Transcript:
    both, *_ = two(engine, first, second)
    return both.transcribe(SOUND)


@given(DOUBTFUL, DOUBTFUL)
def test_what_is_taken_was_thought_of_by_one_and_refused_by_none(engine, one, other):
    found = both_think(engine, one, other)
    said = {one.transcript.text, other.transcript.text}
    assert found.text in said | set(one.scores) | set(other.scores)
    assert 0 <= found.confidence <= 1
    if "don't turn left" in said:
        assert engine.parse(found.text).refuses


@pytest.mark.parametrize(("freely", "refused"), [("ever go back", False), ("never go back", True)])
def test_what_one_takes_for_a_refusal_but_did_not_hear_is_for_both_to_weigh(engine, freely, refused):
    sure, never = "go back", "never go back"
    first = Thinks(heard(sure, 0.6), {sure: LIKELY, never: -9.0})
    second = Thinks(replace(heard(never, 0.6), free_text=freely), {sure: -2.0, never: LIKELY})
    found = both_think(engine, first, second)
    assert (found.text == never) is refused
    assert bool(engine.parse(found.text).actions) is not refused


@pytest.mark.parametrize(("other", "unclear"), [("go to the kitchen", ("go",)), ("go to the bedroom", ())])
def test_a_dont_is_looked_for_in_other_words_of_the_same_command(engine, other, unclear):
    """ "Don't go to the kitchen" is like "go on to the kitchen"."""
    said = "go on to the kitchen"
    both = Thinks(heard(said, 0.6), {said: LIKELY, other: -9.0}, shared={other: {"go": -9.0}})
    found = both_think(engine, both, replace(both))
    assert (found.text, found.unclear) == (said, unclear)


@given(st.floats(-12, LIKELY), st.floats(-12, LIKELY))
def test_who_agrees_is_believed_sooner_than_who_differs(engine, score, another):
    first = Thinks(heard(FORWARD, 0.5), {FORWARD: score})
    agreed = both_think(engine, first, Thinks(heard(FORWARD, 0.5), {FORWARD: another}))
    differed = both_think(engine, first, Thinks(heard(LEFT, 0.5), {LEFT: another}))
    assert agreed.text == FORWARD
    assert agreed.confidence > differed.confidence


def test_the_likelier_for_both_is_taken_though_neither_put_it_first(engine):
    first = Thinks(heard("goat bad", 0.5), {FORWARD: -1.0, "go back": -2.0, LEFT: -15.0})
    second = Thinks(heard("go pack", 0.5), {LEFT: -1.0, "go back": -2.0, FORWARD: -15.0})
    assert both_think(engine, first, second).text == "go back"


@pytest.mark.parametrize(
    ("first", "second", "unclear"),
    [
        (-1.0, 2.0, ()),
        (-2.5, -0.4, ()),
        (-2.5, -0.6, ("fifteen",)),
        (-3.1, 20.0, ("fifteen",)),
        (20.0, -3.1, ("fifteen",)),
        (1.0, None, ()),
        (-2.0, None, ("fifteen",)),
    ],
    ids=["one is sure", "both a little", "too little", "one heard fifty", "the other did", "alone", "alone and unsure"],
)
def test_of_a_number_like_another_what_both_heard_adds_up_if_neither_heard_the_other(engine, first, second, unclear):
    text = "turn left fifteen degrees"
    found = both_think(
        engine,
        Thinks(heard(text, 1.0, unclear=("fifteen",)), {text: LIKELY}, {"fifteen": first}),
        Thinks(heard(text, 1.0), {text: LIKELY}, {} if second is None else {"fifteen": second}),
    )
    assert found.unclear == unclear


def test_both_must_be_surer_of_a_stop_that_the_first_did_not_take_for_one(engine):
    doubtful = Thinks(heard("whoa", 0.3), {"whoa": -12.0})
    unsure = both_think(engine, doubtful, Thinks(heard("whoa", 0.5), {"whoa": -12.0}))
    assert (unsure.text, unsure.confidence) == ("whoa", 0.3), "wow"
    assert both_think(engine, doubtful, Thinks(heard("whoa", 0.97), {"whoa": -0.5})).confidence > 0.7


@pytest.mark.parametrize(("confidence", "waits"), [(SURE_ENOUGH_TO_STOP, False), (SURE_ENOUGH_TO_STOP - 0.01, True)])
def test_a_stop_that_is_one_already_waits_for_no_second_opinion(engine, confidence, waits):
    both, *_ = two(engine, heard("stop", confidence, score=-0.9), heard("don't stop", None))
    assert both.transcribe(SOUND).text == ("don't stop" if waits else "stop")


def test_a_stop_waits_for_a_second_opinion_where_another_word_is_much_likelier(engine):
    wow = heard("whoa", SURE_ENOUGH_TO_STOP, score=-0.9, gap=ANOTHER_WORD + 0.1)
    both, _, other = two(engine, wow, heard("wow", None))
    both.transcribe(SOUND)
    assert other.listened


def test_where_neither_heard_a_command_the_words_of_the_first_are_told(engine):
    nice = heard("nice weather", None, score=-0.9)
    assert both_think(engine, nice, heard("ice leather", None)).text == "nice weather"


@pytest.mark.parametrize(
    ("one", "other", "completed"),
    [("go forward", "go for two", False), ("go forward", FORWARD, True), ("", "go for two meet us", True)],
)
def test_of_a_sentence_that_goes_on_from_what_was_heard_one_must_have_heard_all(engine, one, other, completed):
    first = Thinks(heard(one or "p", 0.5), {"go forward": -3.0})
    first = replace(first, transcript=replace(first.transcript, free_text=one))
    second = Thinks(heard(other, 0.5), {FORWARD: LIKELY})
    found = both_think(engine, first, second)
    assert (found.text == FORWARD) is completed


def test_words_of_which_neither_heard_a_letter_are_not_added(engine):
    """Both heard all to the end; "then go forward" is what the grammar would have after it."""
    completed = f"{FORWARD} then go forward"
    first = Thinks(heard("go for what two meters", 0.5), {FORWARD: -6.0, completed: LIKELY})
    second = Thinks(heard("no forward too meters", 0.5), {FORWARD: -6.0})
    assert both_think(engine, first, second).text == FORWARD
    second = Thinks(heard("no forward too meters then no forward", 0.5), {FORWARD: -6.0, completed: LIKELY})
    assert both_think(engine, first, second).text == completed


@pytest.mark.parametrize("freely", ["pick up the flurb", "pick up the curb"])
def test_a_word_that_no_list_has_must_have_been_heard_by_both(engine, freely):
    """Nothing else tells whether it was said."""
    flurb = "pick up the flurb"
    first = Thinks(heard(flurb, 0.8), {flurb: LIKELY}, {"flurb": 0.3})
    second = Thinks(replace(heard(flurb, 0.8), free_text=freely), {flurb: LIKELY}, {"flurb": 0.3})
    found = both_think(engine, first, second)
    assert found.text == flurb
    assert found.unclear == (() if freely == flurb else ("flurb",))


@pytest.mark.parametrize(
    ("first", "second", "clear", "agreed"),
    [
        ("call jessica", "call jessica", {}, True),
        ("call jessica", "call jessika", {}, False),
        ("take the flurb", "take the flurb", {}, False),
        ("call number sixteen", "call number sixteen", {"sixteen": -9.0}, True),
    ],
)
def test_a_slot_without_a_list_takes_what_both_heard_word_by_word(tmp_path, first, second, clear, agreed):
    """However unlikely each finds it."""
    (tmp_path / "people.yaml").write_text(
        "language: en\nslots: {name: {type: text, max_words: 2}, thing: {type: text, known: [cup]}}\n"
        "intents: {call: {action: {type: custom, name: call}, sentences: ['call {name}', 'take {thing}']}}\n"
    )
    engine = IntentEngine.from_files(tmp_path / "people.yaml")
    found = both_think(engine, *(Thinks(heard(text, 0.1), {text: -9.0}, clear) for text in (first, second)))
    assert (found.text, found.sureness >= AGREED) == (first, agreed)
    assert found.unclear == (("sixteen",) if clear else ())


BLOCK = """
language: en
slots: {device: [block, stage], temp: {type: number, min: 0, max: 110}}
intents:
  heat: {action: custom, sentences: ["(heat|set) the {device} to {temp} degrees"]}
"""


@pytest.mark.parametrize(
    ("second", "unclear"),
    [
        ("the block at ninety five degrees", ("set",)),
        ("did the block at ninety five degrees", ("set",)),
        ("set the block at ninety five degrees", ()),
        ("send the block to ninety five degrees", ()),
    ],
)
def test_without_a_verb_that_one_heard_a_thing_is_only_told_of(engine_of, second, unclear):
    """ "Is the block at ninety five degrees"."""
    said = "set the block to ninety five degrees"
    first, other = (
        Thinks(heard(text, 0.6, score=-0.9), {said: LIKELY}) for text in ("the block at ninety five degrees", second)
    )
    found = both_think(engine_of(BLOCK), first, other)
    assert (found.text, found.unclear) == (said, unclear)


SAMPLES = """
language: en
slots: {unit: {type: choice, values: {one: otter one, two: otter two}}, samples: {type: number, min: 1, max: 20}}
intents:
  sample: {action: custom, sentences: ["{unit} take {samples} samples"]}
"""


@pytest.mark.parametrize(("second", "left_out"), [("took", ("took",)), ("take", ())])
def test_who_took_something_is_told_of(engine_of, second, left_out):
    """Where both heard it: one of two may have misheard."""
    said, freely = (f"otter one {verb} six samples" for verb in ("take", "took"))
    first = Thinks(heard(freely, 0.6, score=-0.9), {said: LIKELY})
    other = Thinks(heard(said.replace("take", second), 0.6, score=-0.9), {said: LIKELY})
    assert both_think(engine_of(SAMPLES), first, other).left_out == left_out


def test_what_both_heard_to_the_end_is_not_left_out(engine):
    text = f"{FORWARD} at six miles"
    first = Thinks(replace(heard(FORWARD, 0.5), free_text=text), {FORWARD: LIKELY})
    for second_heard, left_out in ((text, ("miles",)), (FORWARD, ())):
        second = Thinks(replace(heard(FORWARD, 0.5), free_text=second_heard), {FORWARD: LIKELY})
        assert both_think(engine, first, second).left_out == left_out
    first = second = Thinks(replace(heard(FORWARD, 0.5), free_text=f"{FORWARD} please"), {FORWARD: LIKELY})
    assert both_think(engine, first, second).left_out == ()


@pytest.mark.parametrize(("freely", "left_out"), [(f"do you {FORWARD}", ("do you",)), (f"please {FORWARD}", ())])
def test_what_both_heard_at_the_beginning_is_not_left_out(engine, freely, left_out):
    """ "Do you go forward two meters?" is a question."""
    both = Thinks(replace(heard(FORWARD, 0.5), free_text=freely), {FORWARD: LIKELY})
    assert both_think(engine, both, both).left_out == left_out
    one = Thinks(replace(heard(FORWARD, 0.5), free_text=FORWARD), {FORWARD: LIKELY})
    assert both_think(engine, one, both).left_out == ()


def test_a_stop_is_one_whatever_was_heard_before_it(engine):
    both = Thinks(replace(heard("stop moving", 0.5), free_text="do you stop moving"), {"stop moving": LIKELY})
    assert both_think(engine, both, both).left_out == ()


def test_what_neither_thought_of_is_asked_of_both(engine):
    """ "Put down the mug" is far ahead of all others, until somebody thinks of the book."""
    mug, book, bowl = "put down the mug", "put down the book", "put down the bowl"
    alone = Thinks(heard(mug, 0.5), {mug: -4.0, book: -3.0, bowl: LIKELY})
    first = Knows(alone.transcript, alone.scores, thought_of=frozenset({mug}))
    second = replace(first)
    assert both_think(engine, first, second).confidence > SURE_TOGETHER
    second.others = {mug: (book,)}
    found = both_think(engine, first, second)
    assert (found.text, found.alternatives) == (mug, (book,))
    assert found.confidence < SURE_TOGETHER
    first.others, second.others = {bowl: (book, mug)}, {mug: (bowl,)}
    found = both_think(engine, first, second)
    assert (found.text, set(found.alternatives)) == (bowl, {mug, book}), (
        "the second time beside the one that is likelier"
    )


@pytest.mark.parametrize(
    ("before", "score", "taken"), [("goat", -1.5, True), ("goat", -20.0, False), ("who is going", -1.5, False)]
)
def test_what_was_heard_before_a_command_may_be_its_own_beginning(engine, before, score, taken):
    """ "Goat forward two meters" may be "go forward two meters"; as "forward two meters" it leaves out a word."""
    short = FORWARD.removeprefix("go ")
    freely = replace(heard(short, 0.5), free_text=f"{before} {short}")
    thinks = Knows(freely, {short: -2.0, FORWARD: score}, begins={short: (FORWARD,)}, thought_of=frozenset({short}))
    found = both_think(engine, thinks, replace(thinks))
    assert (found.text, found.left_out) == ((FORWARD, ()) if taken else (short, (before,)))


def test_how_likely_the_other_way_is_is_told_though_nobody_thought_of_it(engine):
    forward, backward = "go forward two meters", "go back two meters"
    others = {f"{way} two meters": -7.5 for way in ("go on", "go straight", "go ahead", "move forward")}
    freely = replace(heard(forward, 0.5), free_text="go fourth two meters")
    scores = {forward: -6.0, backward: -7.5, **others}
    thinks = Knows(freely, scores, thought_of=frozenset({forward, *others}))
    found = both_think(engine, thinks, thinks)
    assert found.text == forward
    behind = dict(zip(found.alternatives, found.behind, strict=True))
    assert behind[backward] >= 1.5, "also behind all of those that mean the same"
