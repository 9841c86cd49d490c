"""Laws about every sentence that the shipped grammars have, not only about those that someone thought of.

A failure shows the shortest sentence that breaks a law. Then the sentence goes into ``tests/language``, and either the
grammar, the sampler or the language room is mended.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from intent_engine.actions import Custom, Stop
from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.done_again import said_by_itself
from intent_engine.language.quantities import is_number_word
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.testing import assert_means, moves, sentences

ROOT = Path(__file__).resolve().parent.parent
ENGLISH = ROOT / "grammars" / "en.yaml"
LOCATIONS = ROOT / "locations"
GRAMMARS = {
    "in the warehouse": (ENGLISH, LOCATIONS / "warehouse.yaml"),
    "coffee": (ROOT / "examples" / "coffee" / "coffee.yaml", LOCATIONS / "home.yaml"),
    **{file.stem: (file, LOCATIONS / "home.yaml") for file in sorted((ROOT / "grammars").glob("*.yaml"))},
    "de": (ROOT / "grammars" / "de.yaml", LOCATIONS / "zuhause.yaml"),
}
IDIOMS = ("go ahead and", "go on and", "go and")
"""Fillers that a command with its verb and a joint would be as well, and hardly ever are."""


@cache
def engine_of(name):
    grammar, locations = GRAMMARS[name]
    return IntentEngine.from_files(grammar, locations=locations)


def law(noise=(), state=(), examples=250):
    """A property of each engine and of every sentence of its grammar."""

    def decorate(function):
        @pytest.mark.parametrize("name", GRAMMARS)
        def test(name):
            engine = engine_of(name)

            @settings(max_examples=examples, deadline=None, derandomize=True)
            @given(sentences(engine, noise=noise, state=state))
            def holds(said):
                function(engine, said)

            holds()

        test.__doc__ = function.__doc__
        return test

    return decorate


@law()
def test_a_sentence_means_what_it_was_made_from(engine, said):
    assert_means(engine.parse(said.text), said.expected)


@law(noise="fillers")
def test_fillers_change_no_meaning(engine, said):
    assert_means(engine.parse(said.text), said.expected)


@law(noise=["fillers", "spelling"])
def test_what_recognisers_write_changes_no_meaning(engine, said):
    assert_means(engine.parse(said.text), said.expected)


@law(noise=["negation", "fillers", "spelling"])
def test_what_is_negated_moves_nothing(engine, said):
    found = engine.parse(said.text)
    assert not moves(found), found.actions
    unfinished = found.status is Status.INCOMPLETE  # "in place of again": "again" says nothing, and what is meant?
    if found.actions != (Stop(),) and not unfinished:  # "mach nicht weiter": "nicht weiter" is one
        assert_means(found, said.expected)


@law(noise=["correction", "fillers"], examples=150)
def test_the_last_word_counts(engine, said):
    found = engine.parse(said.text)
    if "there shall be none" in found.reason:  # "a latte with milk no cream" may be one without
        assert "with" in said.text.split()
        assert not found.actions
    else:
        assert_means(found, said.expected)


@law(state=["moving"])
def test_a_moving_robot_obeys_as_one_at_rest(engine, said):
    assert_means(engine.parse(said.text, state=["moving"]), said.expected)


@pytest.mark.parametrize("name", [name for name in GRAMMARS if name != "coffee"])
def test_of_two_commands_each_means_what_it_means_alone(name):
    engine = engine_of(name)
    grammar = engine.grammar
    joints = [" ".join(words) for words in grammar.operators.sequence]
    # What says "cancel", "wait" or "about" of its own is about more than itself, and "again" about what was before.
    special = PhraseSet((*grammar.fillers, *grammar.operators.cancel))
    back = {intent.name for intent in grammar.intents.values() if intent.action.name == "again"}

    def plain(said):
        words = said.text.split()
        stops = isinstance(said.expected.actions[0], Stop)
        known = grammar.operators.closed.isdisjoint(words) and special.find(words) is None
        alone = any(map(said_by_itself, said.expected.actions))
        return known and not (stops or alone) and said.expected.intent not in back

    @settings(max_examples=150, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.filter_too_much])
    @given(sentences(engine).filter(plain), st.sampled_from(joints), sentences(engine).filter(plain))
    def holds(first, joint, second):
        both = (first.expected, second.expected)
        steps = [{"intent": one.intent, "slots": one.slots} for one in both]
        actions = first.expected.actions + second.expected.actions
        text = f"{first.text} {joint} {second.text}"
        assume(joint != "and" or not f"{first.text} and".endswith(IDIOMS))
        numbers = [is_number_word(one.text.split()[at]) for one, at in ((first, -1), (second, 0))]
        assume(joint != "and" or not all(numbers))  # "bay 1 and 1 m/s back" may be one number
        found = engine.parse(text)
        assume("may be meant for both" not in found.reason)  # "left and right ninety degrees": asked about
        assume("or the way back" not in found.reason)  # "to the kitchen and back", "come and back"
        assert_means(found, Interpretation(text, Status.ACCEPTED, "compound", {"steps": steps}, actions, 1.0))

    holds()


@pytest.mark.parametrize("name", [name for name in GRAMMARS if name != "coffee"])
def test_a_list_of_commands_is_done_whole_and_in_order_or_not_at_all(name):
    """Words alone most of all: "left then right then left" has the most ways to be taken for something else."""
    engine = engine_of(name)
    matcher = engine.matcher()
    joints = [" ".join(words) for words in engine.grammar.operators.sequence]
    plain = [joint for joint in joints if joint in ("and", "then", "and then", "und", "dann", "und dann")]
    assert len(plain) == 3

    @cache  # of the parts, each is asked about several times
    def actions(text):
        found = engine.parse(text)
        return found.actions if found.status is Status.ACCEPTED else ()

    def repeats(action):
        return isinstance(action, Custom) and action.name == "again"

    def usable(text):
        return not any(isinstance(action, Stop) or repeats(action) for action in actions(text))

    words = sorted(word for word in matcher.strict.next_words(matcher.strict.start()) if actions(word) and usable(word))
    alone = st.sampled_from(words)
    command = alone | alone | sentences(engine).map(lambda said: said.text).filter(actions).filter(usable)
    joint = st.sampled_from(plain) | st.sampled_from([*joints, *(f", {joint}" for joint in plain)])

    @settings(max_examples=400, deadline=None, derandomize=True)
    @given(command, st.lists(st.tuples(joint, command), min_size=1, max_size=3))
    def holds(first, others):
        parts = [first, *(part for _, part in others)]
        text = first + "".join(f"{between if between[0] == ',' else ' ' + between} {part}" for between, part in others)
        for (between, part), before in zip(others, parts, strict=False):
            if matcher.read(Utterance.of(f"{before} {between} {part}").words):
                return  # a sentence of its own: "komm dann in den Flur"
        if any(idiom in text for idiom in IDIOMS):
            return
        assert actions(text) in ((), sum(map(actions, parts), ())), text

    holds()


@law(examples=120)
def test_every_beginning_of_a_sentence_may_go_on(engine, said):
    words = Utterance.of(said.text).words
    for count in range(1, len(words)):
        begun = " ".join(words[:count])
        if Utterance.of(begun).words == words[:count]:  # else "2 s swivel" would be a stutter, as "2s swivel" is none
            found = engine.prefix(begun)
            assert found.status is not PrefixStatus.IMPOSSIBLE, begun
            assert found.next_words, begun
    assert engine.prefix(said.text).status in (PrefixStatus.COMPLETE, PrefixStatus.EXTENDABLE)


@law()
def test_an_article_behind_a_sentence_says_that_it_broke_off(engine, said):
    last = said.text.split()[-1]
    article = {"en": "the", "de": "die"}[engine.grammar.language]
    assume(last != article)  # which is a stutter
    assert not moves(engine.parse(f"{said.text} {article}"))


@law()
def test_a_quotation_does_what_is_quoted_or_nothing(engine, said):
    """The sign that ends it is no inches or feet."""
    meant = engine.parse(said.text).actions
    for begin, end in ('""', "“”", "''", "‘’", "„“", "«»"):
        assert engine.parse(f"{begin}{said.text}{end}").actions in ((), meant)
