"""The quick reader of plainly written maps: the same as a YAML parser, or nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from map_files import maps, metres, spoken

from intent_engine.language.loading.yaml_source import YamlSource, parse_yaml
from intent_engine.language.maps.map_rows import PlainMap, read_map

PIECES = ["", " ", "#", " #", ":", ": ", "- ", "'", '"', "[", "]", "{", "}", ",", "1", "\n", "\t", "é", "&a", "*a", "|"]

LISTS = st.lists(spoken | st.sampled_from(["no", "Yes", "null"]), max_size=2)


def fields(found: PlainMap) -> dict[str, Any]:
    """What was read, as a YAML parser gives it, ``yaw`` always."""
    return {
        name: dict(zip(("x", "y", "yaw"), found.poses[3 * place : 3 * place + 3], strict=True))
        | found.particulars.get(name, {})
        for place, name in enumerate(found.names)
    }


def check(text: str) -> None:
    """The quick reader's answer, if it has one, is the YAML parser's."""
    quick = read_map(text)
    if quick is None:
        return
    source = parse_yaml(text, YamlSource("map.yaml"))
    assert not source.problems
    assert source.data.get("frame") == quick.frame
    assert {name: {"yaw": 0.0, **pose} for name, pose in source.data["locations"].items()} == fields(quick)
    assert set(source.data) <= {"frame", "locations"}


def changed(text: str, data: st.DataObject) -> str:
    """A text with up to two places where something else stands."""
    for _ in range(data.draw(st.integers(0, 2))):
        at = data.draw(st.integers(0, len(text)))
        cut = data.draw(st.integers(0, 2))
        text = text[:at] + data.draw(st.sampled_from(PIECES)) + text[at + cut :]
    return text


@settings(deadline=None, max_examples=300)
@given(maps(), st.sampled_from([True, False, None]), st.data())
def test_the_quick_reader_reads_what_a_yaml_parser_reads(places, style, data):
    """Or nothing: also on files with a mistake, or merely written in an unusual way."""
    text = "frame: map\n" + yaml.safe_dump({"locations": places}, default_flow_style=style, width=1000)
    check(changed(text, data))


@settings(deadline=None, max_examples=300)
@given(st.dictionaries(spoken, st.tuples(metres, metres, metres, LISTS, LISTS), min_size=1), st.booleans(), st.data())
def test_so_it_does_where_fields_stand_in_the_usual_order(places, flow, data):
    rows = ["locations:"]
    for name, (x, y, yaw, aliases, tags) in places.items():
        values = [f"x: {x:.6f}", f"y: {y:.3f}"] + ([f"yaw: {yaw:.2f}"] if yaw > 0 else [])
        values += [f"{key}: [{', '.join(one)}]" for key, one in (("aliases", aliases), ("tags", tags)) if one]
        rows += [f"  {name}: {{{', '.join(values)}}}"] if flow else [f"  {name}:", *(f"    {one}" for one in values)]
    check(changed("\n".join(rows) + data.draw(st.sampled_from(["", "\n", "\n\n", "\n# end"])), data))


FLOW = "locations:\n  bay 1: {x: 1, y: 2.5, yaw: -.5, aliases: [first bay, b one]}  # near the door\n"
BLOCK = "locations:\n  bay 1:\n    x: 1\n    y: 2.5\n    yaw: -.5\n    aliases:\n    - first bay\n    - b one\n"
LAST = "  dock: {yaw: 0, x: 3, y: 4, tags: [charger]}  # by the door\n"
POSES = "  hall: {x: 1, y: 2}\n  lab: {x: 3.5, y: -4, yaw: 1.5}\n"
POSES_BELOW = "  hall:\n    x: 1\n    y: 2\n  lab:\n    x: 3.5\n    y: -4\n    yaw: 1.5\n"


def test_plain_maps_of_both_shapes_are_read_quickly():
    bay = {"bay 1": {"x": 1.0, "y": 2.5, "yaw": -0.5, "aliases": ["first bay", "b one"]}}
    for text in (FLOW, BLOCK, FLOW.replace("bay 1", '"bay 1"')):
        found = read_map(text)
        assert found is not None
        assert fields(found) == bay


@pytest.mark.parametrize("head", ["", "# places\n\n", "frame: map  # of the house\n"])
@pytest.mark.parametrize("shape", [POSES, POSES_BELOW], ids=["flow", "block"])
def test_places_in_the_usual_order_and_then_others_are_one_map(head, shape):
    found = read_map(head + "locations:\n" + shape + LAST)
    assert found is not None
    assert fields(found) == {
        "hall": {"x": 1.0, "y": 2.0, "yaw": 0.0},
        "lab": {"x": 3.5, "y": -4.0, "yaw": 1.5},
        "dock": {"x": 3.0, "y": 4.0, "yaw": 0.0, "tags": ["charger"]},
    }


@pytest.mark.parametrize(
    "text",
    [
        "locations:\n" + POSES + POSES,
        "locations:\n" + POSES + "  no: {x: 1, y: 2}\n",
        "locations:\n  on: {x: 1, y: 2}\n" + POSES,
        "locations:\n" + POSES + f"  far: {{x: 1{'0' * 400}, y: 2}}\n",
        "locations:\n" + POSES + "  half: {x: 1}\n",
        "locations:\n" + POSES + "frame: map\n",
        "frame: no\nlocations:\n" + POSES,
        "locations:\n",
        "",
    ],
    ids=["twice", "boolean", "boolean first", "infinite", "no y", "frame last", "frame", "none", "empty"],
)
def test_what_is_wrong_or_unusual_is_left_to_the_parser(text):
    assert read_map(text) is None


@pytest.mark.parametrize("name", ["home", "warehouse"])
def test_the_shipped_maps_load_the_quick_way(name):
    file = Path(__file__).parents[3] / "locations" / f"{name}.yaml"
    assert read_map(file.read_text("utf-8")) is not None
