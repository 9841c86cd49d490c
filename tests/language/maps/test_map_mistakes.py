"""What people get wrong in a map file: every mistake told at once, each with its place."""

from __future__ import annotations

import contextlib
import math
import os

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from map_files import problems_of

from intent_engine.errors import ConfigError
from intent_engine.language.locations import from_text, load

MISTAKES = {
    "not finite": ("locations:\n  hall: {x: .nan, y: 2}\n", ["2:13 x of 'hall' must be a finite number, not nan"]),
    "infinite": ("locations:\n  hall: {x: 1, y: -.inf}\n", ["2:19 y of 'hall' must be a finite number, not -inf"]),
    "too large": (f"locations:\n  hall: {{x: 1{'0' * 400}, y: 2}}\n", ["2:13 x of 'hall' must be a finite number"]),
    "missing": ("locations:\n  hall: {x: 1}\n", ["2:3 'hall' needs 'y'"]),
    "boolean": ("locations:\n  hall: {x: yes, y: 2}\n", ["2:13 'x' must be a number"]),
    "octal, to YAML": ("locations:\n  hall: {x: 010, y: -07}\n", ["2:13 'x' must be a number", "2:21 'y' must be"]),
    "minutes, to YAML": ("locations:\n  hall: {x: 1:30, y: 2}\n", ["2:13 'x' must be a number"]),
    "misspelt key": ("locations:\n  hall: {x: 1, y: 2, yawn: 3}\n", ["2:22 unknown key 'yawn' (did you mean 'yaw'?)"]),
    "misspelt top": ("location:\n  hall: {x: 1, y: 2}\n", ["1:1 unknown key 'location' (did you mean"]),
    "YAML's on": ("locations:\n  on: {x: 1, y: 2}\n", ["2:3 YAML reads the name on as a value", ]),
    "a number": ("locations:\n  5: {x: 1, y: 2}\n", ['2:3 YAML reads the name 5 as a value']),
    "YAML's no": ("locations:\n  hall: {x: 1, y: 2, aliases: [no]}\n", ["2:32 YAML reads no as false"]),
    "empty name": ("locations:\n  '': {x: 1, y: 2}\n", ["2:3 the name '' has no word that can be said"]),
    "no word": ("locations:\n  '?!': {x: 1, y: 2}\n", ["2:3 the name '?!' has no word that can be said"]),
    "twice": ("locations:\n  hall: {x: 1, y: 2}\n  hall: {x: 1, y: 3}\n", ["3:3 'hall' stands twice"]),
    "alias twice": (
        "locations:\n  hall: {x: 1, y: 2, aliases: [foyer]}\n  lab: {x: 1, y: 3, aliases: [foyer]}\n",
        ["3:30 'foyer' is said like a name of 'hall'"],
    ),
    "said alike": (
        "locations:\n  bay 3: {x: 1, y: 2}\n  the bay three: {x: 1, y: 3}\n",
        ["3:3 'the bay three' is said like a name of 'bay 3'"],
    ),
    "aliases as one text": (
        "locations:\n  hall: {x: 1, y: 2, aliases: foyer; front desk}\n",
        ["2:31 'aliases' must be a list (write it as a list: [foyer, front desk])"],
    ),
    "aliases with commas": (
        "locations:\n  hall:\n    x: 1\n    y: 2\n    aliases: foyer, entrance,\n",
        ["5:14 'aliases' must be a list (write it as a list: [foyer, entrance])"],
    ),
    "aliases on lines": (
        "locations:\n  hall:\n    x: 1\n    y: 2\n    aliases:\n      foyer\n      entrance\n",
        ["6:7 YAML reads these lines as one text (begin each with '- '"],
    ),
    "aliases of a waypoint": (
        "waypoints:\n- {name: hall, x: 1, y: 2, aliases: foyer / entrance}\n",
        ["2:37 aliases of 'hall' must be a list of names (aliases: [foyer, entrance])"],
    ),
    "aliases of a waypoint on lines": (
        "waypoints:\n- name: hall\n  x: 1\n  y: 2\n  tags:\n    foyer\n    entrance\n",
        ["6:5 YAML reads these lines as one text"],
    ),
    "an empty alias": ("locations:\n  hall: {x: 1, y: 2, aliases: ''}\n", ["2:31 'aliases' is empty"]),
    "a list": ("locations:\n- hall\n", ["2:1 'locations' must be a mapping"]),
    "the tutorial's tuple": (
        "locations:\n  hall: [5.0, 2.0, 0.5]\n",
        ["2:9 'hall' must be a mapping (key: value) (write {x: 5.0, y: 2.0, yaw: 0.5})"],
    ),
    "the same as Python has it": (
        "locations:\n  hall: (5.0, 2.0)\n",
        ["2:9 'hall' must be a mapping (key: value) (write {x: 5.0, y: 2.0})"],
    ),
    "the tutorial's dictionary": (
        '{"hall": [5.0, 2.0, 0.0], "lab": {"x": 1, "y": 2}}',
        ["1:2 the places stand at the top, and belong below 'locations' (as in  locations: {hall: {x"],
    ),
    "the same in other forms of a pose": (
        "hall: (5.0, 2.0)\nlab: {position: {x: 1, y: 2}}\n",
        ["1:1 the places stand at the top, and belong below 'locations'"],
    ),
    "a list without a name": (
        "- {name: hall, x: 1, y: 2}\n- {name: lab, position: {x: 1, y: 2}}\n",
        ["1:1 the places stand in a list that has no name (write  waypoints:  on a line above it)"],
    ),
    "a list below locations": (
        "frame: map\nlocations:\n- {name: hall, pose: [1, 2, 0]}\n",
        ["2:1 the places stand in a list (write waypoints in the place of locations"],
    ),
    "a table": ("name,x,y,yaw\nhall,1,2,0\n", ["is a table, as CSV files are (give it a name that ends with .csv)"]),
    "another name for locations": ("places:\n  hall: {x: 1, y: 2}\n", ["1:1 unknown key 'places': places are listed"]),
    "locations in capitals": ("LOCATIONS:\n  hall: {x: 1, y: 2}\n", ["1:1 unknown key 'LOCATIONS' (did you mean 'loc"]),
    "the picture of a map": ("image: map.pgm\nresolution: 0.05\norigin: [-1, -1, 0]\n", ["is the picture of a floor"]),
    "units": (
        "locations:\n  hall: {x: 1 m, y: 2, yaw: 90 deg}\n",
        ["2:13 'x' must be a number (a plain number, in m)", "2:29 'yaw' must be a number (in rad, without a unit"],
    ),
    "commas that were to part a value": (
        "locations:\n  hall: {x: 1,5, y: 2}\n  lab: {x: 1, y: 2, aliases: shop, big shop, bay}\n",
        ["2:15 unknown key '5': the ',' before it begins a key (a number has a point: 1.5)",
         "3:36 unknown key 'big shop': the ',' before it begins a key (write it as a list: aliases: [shop, big shop",
         "3:46 unknown key 'bay': the ',' before it begins a key (write it as a list: aliases: [shop, big shop"],
    ),
    "other words for the fields": (
        "locations:\n  hall: {x: 1, y: 2, z: 0}\n  lab: {x: 1, y: 2, theta: 0}\n",
        ["2:22 unknown key 'z' (a place lies on the floor", "3:21 unknown key 'theta' (that is yaw, in rad)"],
    ),
    "empty": ("", ["is empty"]),
    "several at once": (
        "frame: 5\nlocations:\n  hall: {x: 1}\n  lab: {x: .nan, y: 2}\n  c: {x: 1, y: 2, yow: 3}\n  off: {x: 1, y: 2}",
        ["1:8 'frame' must be", "3:3 'hall' needs", "4:12 x of 'lab'", "5:19 unknown key 'yow'", "6:3 YAML reads"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", MISTAKES)
def test_mistakes_in_yaml(tmp_path, case):
    text, expected = MISTAKES[case]
    found = problems_of(text, tmp_path / "map.yaml")
    assert len(found) == len(expected), found
    for problem, beginning in zip(found, expected, strict=True):
        assert beginning in problem


CSV_MISTAKES = {
    "semicolons": ("name;x;y\nhall;5,5;2\n", ["1:1 has its columns parted by ';' (part them by ','"]),
    "tabs": ("name\tx\ty\nhall\t5.5\t2\n", ["1:1 has its columns parted by tabs (part them by ','"]),
    "degrees": ("name,x,y,yaw_deg\nhall,1,2,90\n", ["1:1 column 'yaw_deg' is not known (that is yaw, in rad: 90"]),
    "a header alone": ("name,x,y\n", ["1:1 has no place below its header"]),
    "no number": ("name,x,y\nhall,five,2\n", ["2:6 x of 'hall' must be a finite number, not 'five'"]),
    "nan": ("name,x,y\nhall,1,nan\n", ["2:8 y of 'hall' must be a finite number, not nan"]),
    "missing": ("name,x,y\nhall,1\n", ["2:1 place 'hall' needs 'y'"]),
    "no column": ("name,x,yaw\nhall,1,2\n", ["1:1 has no column y"]),
    "misspelt column": ("name,x,y,yaww\nhall,1,2,3\n", ["1:1 column 'yaww' is not known (did you mean 'yaw'?)"]),
    "column twice": ("name,x,y,x\nhall,1,2,3\n", ["1:1 column 'x' stands twice"]),
    "aliases by commas": (
        'name,x,y,aliases\nhall,1,2,"foyer, lobby"\nbar,1,3,pub|inn\n',
        ["2:1 aliases are not separated by ',' (separate them by ';': foyer; lobby)", "3:1 aliases are not separated"],
    ),
    "too many": ("name,x,y\nhall, the other,1,2\n", ["2:1 has 4 fields, but there are 3 columns"]),
    "open quote": ('name,x,y\nhall,1,2\n"lab,1,2\n', ["3:1 is not valid CSV"]),
    "empty": ("", ["is empty"]),
    "empty name": ("name,x,y\n,1,2\n", ["2:1 the name '' has no word"]),
    "letters that stand in the name as well": (
        "name,x,y,yaw\nbar,a,b,c\n",
        ["2:5 x of 'bar' must", "2:7 y of 'bar' must", "2:9 yaw of 'bar' must"],
    ),
    "a cell behind aliases": ('name,aliases,x,y\nhall,"a 1; foyer",1,a\n', ["2:21 y of 'hall' must"]),
    "several": ("name,x,y\nhall,1,2\n# a note\n\nhall,1,3\nlab,a,b\n", ["5:1 place 'hall' stands twice", "6:", "6:"]),
}


def test_a_list_without_a_name_in_json_is_told_in_words_of_json(tmp_path):
    found = problems_of('[{"name": "hall", "x": 1, "y": 2}]', tmp_path / "map.json")
    assert found == ['1:1 the places stand in a list that has no name (write {"waypoints": before it, and } behind)']


def test_empty_cells_at_the_end_as_spreadsheets_write_them(tmp_path):
    (tmp_path / "map.csv").write_text("name,x,y,,\nhall,1,2,,\nlab,3,4\n,,,,\n", "utf-8")
    assert list(load(tmp_path / "map.csv")) == ["hall", "lab"]


@pytest.mark.parametrize("case", CSV_MISTAKES)
def test_mistakes_in_csv(tmp_path, case):
    text, expected = CSV_MISTAKES[case]
    found = problems_of(text, tmp_path / "map.csv")
    assert len(found) == len(expected), found
    for problem, beginning in zip(found, expected, strict=True):
        assert beginning in problem


@settings(max_examples=300, deadline=None)
@given(st.one_of(st.binary(max_size=200), st.text(max_size=200).map(str.encode)), st.sampled_from(["yaml", "csv"]))
def test_any_file_is_a_map_or_told_what_is_wrong(tmp_path_factory, content, kind):
    path = tmp_path_factory.getbasetemp() / f"any.{kind}"
    path.write_bytes(content)
    with contextlib.suppress(ConfigError):
        load(path)


_json = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(["name", "pose", "position", "orientation", "x", "y", "yaw", "header"]), inner
        )
    ),
    max_leaves=12,
)


@settings(max_examples=300, deadline=None)
@given(st.dictionaries(st.sampled_from(["waypoints", "locations", "frame", "frame_id"]), _json))
def test_any_structure_is_a_map_or_told_what_is_wrong(data):
    with contextlib.suppress(ConfigError):
        places = from_text(yaml.safe_dump(data))
        assert all(math.isfinite(place.x + place.y + place.yaw) for place in places.values())


@pytest.mark.parametrize(
    ("name", "says"), [("none.yaml", "no such file"), (".", "is a folder"), ("none.csv", "no such")]
)
def test_files_that_are_not_there(tmp_path, name, says):
    with pytest.raises(ConfigError, match=says):
        load(tmp_path / name)


def test_a_map_that_comes_through_a_pipe_is_read_once():
    """As ``--locations <(some program)`` gives it."""
    for text in ("locations:\n  hall: {x: 1, y: 2}\n", "waypoints:\n- {name: hall, x: 1, y: 2}\n"):
        reader, writer = os.pipe()
        os.write(writer, text.encode())
        os.close(writer)
        try:
            assert list(load(f"/dev/fd/{reader}")) == ["hall"]
        finally:
            os.close(reader)
