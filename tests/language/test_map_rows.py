"""The quick reader of plainly written maps: the same as a YAML parser, or nothing."""

from __future__ import annotations

import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from map_files import maps

from intent_engine.language.map_rows import read_rows
from intent_engine.language.yaml_source import YamlSource, parse_yaml

PIECES = ["", " ", "#", " #", ":", ": ", "- ", "'", '"', "[", "]", "{", "}", ",", "1", "\n", "\t", "é", "&a", "*a", "|"]


@settings(deadline=None, max_examples=300)
@given(maps(), st.data())
def test_the_quick_reader_reads_what_a_yaml_parser_reads(places, data):
    """Or nothing: also on files with a mistake, or merely written in an unusual way."""
    style = data.draw(st.sampled_from([True, False, None]))
    head, body = "frame: map\n", yaml.safe_dump({"locations": places}, default_flow_style=style, width=1000)
    text = head + body
    for _ in range(data.draw(st.integers(0, 2))):
        at = data.draw(st.integers(0, len(text)))
        cut = data.draw(st.integers(0, 2))
        piece = data.draw(st.sampled_from(PIECES))
        text = text[:at] + piece + text[at + cut :]
    quick = read_rows(text)
    if quick is None:
        return
    rows, frame = quick
    source = parse_yaml(text, YamlSource("map.yaml"))
    assert not source.problems
    assert source.data.get("frame") == frame
    assert source.data["locations"] == dict(rows)
    assert set(source.data) <= {"frame", "locations"}


def test_plain_maps_of_both_shapes_are_read_quickly():
    flow = "locations:\n  bay 1: {x: 1, y: 2.5, yaw: -.5, aliases: [first bay, b one]}  # near the door\n"
    block = "locations:\n  bay 1:\n    x: 1\n    y: 2.5\n    yaw: -.5\n    aliases:\n    - first bay\n    - b one\n"
    fields = {"x": 1.0, "y": 2.5, "yaw": -0.5, "aliases": ["first bay", "b one"]}
    assert read_rows(flow) == read_rows(block) == ([("bay 1", fields)], None)
    assert read_rows(flow.replace("bay 1", '"bay 1"')) == read_rows(flow)
