"""Templates as they are put otherwise: with a particle or an adverb elsewhere, and with one verb for several things."""

from __future__ import annotations

import pytest

from intent_engine.language.template import parse_template
from intent_engine.language.templates.moved_manner import manner_moved
from intent_engine.language.templates.moved_particles import moved
from intent_engine.language.templates.shared_verbs import SharedVerbs
from intent_engine.language.templates.template_tree import Word, template_text

PARTICLES = {"turn": {"on", "off", "down"}, "pick": {"up"}}
ARTICLES = {"the", "a"}
PHRASES = {"both": parse_template("turn on"), "which": parse_template("[the] {lamp}")}


def ways(template: str) -> set[str]:
    values = {"state": {"on", "off"}}
    node = parse_template(template)
    found = moved(
        node, PARTICLES, ARTICLES, PHRASES, lambda name: values.get(name, frozenset()), lambda name: name == "text"
    )
    return {template_text(one) for one in found}


@pytest.mark.parametrize(
    ("template", "others"),
    [
        ("turn on [the] {lamp}", {"turn [the] {lamp} on"}),
        ("turn on {which}", {"turn {which} on"}),
        ("turn (on|off) [the] {lamp}", {"turn [the] {lamp} on", "turn [the] {lamp} off"}),
        ("turn {state} the {lamp}", {"turn the {lamp} {state}"}),
        (
            "turn on the {lamp} [in the {room}]",
            {"turn the {lamp} on [in the {room}]", "turn the {lamp} [in the {room}] on"},
        ),
        ("turn the {lamp} off [for {time}]", {"turn off the {lamp} [for {time}]"}),
        ("{both} the {lamp}", {"turn the {lamp} on"}),
        ("pick up [the] {text}", {"pick [the] {text} up"}),
        ("turn [the] {text} down", set()),  # "down the road"
        ("turn on", set()),
        ("turn the {lamp}", set()),
        ("push up the {lamp}", set()),
        ("turn on {lamp} the {room}", {"turn {lamp} the {room} on"}),  # before an article it is a preposition
    ],
)
def test_where_a_particle_may_stand(template: str, others: set[str]) -> None:
    assert ways(template) == others


def test_a_template_with_very_many_beginnings_is_left_as_it_is() -> None:
    many = " ".join("[so]" for _ in range(14))
    assert ways(f"{many} turn on the {{lamp}}") == set()


@pytest.mark.parametrize(
    ("template", "others"),
    [
        ("[{pace}] turn the {lamp}", {"turn the {lamp} {pace}"}),
        ("(slowly|gently) turn", {"turn (slowly|gently)"}),
        ("turn the {lamp} [{pace}]", {"{pace} turn the {lamp}"}),
        ("[{pace}] turn|push the {lamp} slowly", {"turn {pace}", "slowly push the {lamp}"}),
        ("[please] turn the {lamp}", set()),
        ("slowly", set()),
    ],
)
def test_where_an_adverb_may_stand(template: str, others: set[str]) -> None:
    found = manner_moved(parse_template(template), lambda word: word.endswith("ly"), lambda name: name == "pace")
    assert {template_text(one) for one in found} == others


SHARED = SharedVerbs(Word("and"), lambda name: name in ("lamp", "room", "row"), ARTICLES)


def nodes(node: object) -> int:
    items = getattr(node, "items", None) or ([node.item] if hasattr(node, "item") else ())
    return 1 + sum(map(nodes, items))


@pytest.mark.parametrize("template", ["wave", "go to the {count}", "{lamp} [please]", "wait {time}"])
def test_nothing_is_listed_where_no_named_thing_stands_behind_a_verb(template: str) -> None:
    assert not list(SHARED.more_of(parse_template(template)))


@pytest.mark.parametrize(
    "template",
    [
        "open the {lamp}",
        "put the {lamp} down",
        "turn on [the] {lamp} [in the {room}]",
        "fade {lamp} to {share} for {time}",
    ],
)
def test_things_are_listed_and_the_template_does_not_explode(template: str) -> None:
    node = parse_template(template)
    several = SHARED.several(node)
    assert "and" in template_text(several)
    assert nodes(several) < 30 * nodes(node)


def test_a_thing_is_listed_with_its_article_and_with_what_is_before_it() -> None:
    (more,) = SHARED.more_of(parse_template("look in the {room}"))
    assert template_text(more).startswith("[and ([in] the {room}) [and ([in] the {room})")
