"""Map files: the poses that were written are the poses that are read."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from map_files import expected, maps

from intent_engine.errors import ConfigError
from intent_engine.language.locations import Location, LocationMap, from_text, load

ROOT = Path(__file__).resolve().parents[2]

# -- what is written is what is read --------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["home", "warehouse"])
def test_the_shipped_maps_load_without_doubts(name):
    places = load(ROOT / "locations" / f"{name}.yaml")
    assert places.frame == "map"
    assert places.warnings == ()
    assert places.files


def test_the_home_of_the_tutorials():
    home = load(ROOT / "locations" / "home.yaml")
    poses = {name: (place.x, place.y, place.yaw) for name, place in home.items()}
    assert poses == {
        "kitchen": (5.0, 2.0, 0.0),
        "living room": (8.0, 5.0, 1.57),
        "bedroom": (2.0, 8.0, 3.14),
        "entrance": (0.0, 0.0, 0.0),
        "dock": (10.0, 0.0, -1.57),
    }


@settings(deadline=None)
@given(maps(), st.sampled_from([True, False, None]), st.booleans())
def test_yaml_of_any_style_is_read_as_it_was_written(tmp_path_factory, places, flow, sort):
    path = tmp_path_factory.mktemp("map") / "map.yaml"
    data = {"frame": "hall", "locations": places}
    path.write_text(yaml.safe_dump(data, default_flow_style=flow, sort_keys=sort, width=1000), "utf-8")
    found = load(path)
    assert dict(found) == expected(places, "hall")
    assert found.frame == "hall"
    assert dict(LocationMap.from_mapping(places, "hall")) == dict(LocationMap.from_mapping(found)) == dict(found)


@settings(deadline=None)
@given(maps())
def test_csv_is_read_as_it_was_written(tmp_path_factory, places):
    path = tmp_path_factory.mktemp("map") / "map.csv"
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(["name", "x", "y", "yaw", "frame", "aliases", "tags"])
    for name, pose in places.items():
        lists = [";".join(pose.get(key, ())) for key in ("aliases", "tags")]
        writer.writerow([name, pose["x"], pose["y"], pose.get("yaw", ""), pose.get("frame", ""), *lists])
    path.write_text(text.getvalue(), "utf-8")
    assert dict(load(path)) == expected(places, "map")


def test_several_files_are_one_map(tmp_path):
    (tmp_path / "one.yaml").write_text("frame: level1\nlocations:\n  hall: {x: 1, y: 2}\n")
    (tmp_path / "two.csv").write_text("name,x,y\nlab,3,4\n")
    both = load([tmp_path / "one.yaml", tmp_path / "two.csv"])
    assert list(both) == ["hall", "lab"]
    assert (both["hall"].frame, both["lab"].frame) == ("level1", "map")
    (tmp_path / "two.csv").write_text("name,x,y\nthe hall,3,4\n")
    with pytest.raises(ConfigError, match="said like a name of 'hall'") as caught:
        load([tmp_path / "one.yaml", tmp_path / "two.csv"])
    assert caught.value.problems[0].file == str(tmp_path / "two.csv")


# -- embedding ------------------------------------------------------------------------------------------------


def test_a_dictionary_of_places():
    places = LocationMap.from_mapping(
        {
            "kitchen": (5, 2),
            "dock": [10.0, 0.0, -1.57],
            "lab": {"x": 1, "y": 2, "aliases": ["workshop"]},
            "hall": Location("hall", 1.0, 2.0, 0.5, "odom"),
            "desk": np.array([1.0, 2.0, 3.0], dtype=np.float32).tolist(),
            "shelf": tuple(np.array([1.0, 2.0], dtype=np.float32)),
        },
        frame="level1",
    )
    assert places["kitchen"] == Location("kitchen", 5.0, 2.0, 0.0, "level1")
    assert places["dock"].yaw == -1.57
    assert places["hall"].frame == "odom"
    assert places.index.resolve("the workshop").name == "lab"
    assert places.get("workshop") is None, "an alias is a way of speaking, not a name"
    assert (("workshop",), "lab") in list(places.names())
    assert len(places) == 6


def test_everything_wrong_with_a_dictionary_is_told_at_once():
    wrong = {
        "a b": 5,
        "c": "xy",
        3: (1, 2),
        "d": (1, 2, 3, 4),
        "e": (1, math.nan),
        "f": {"x": 1, "y": 2, "yow": 1},
        "": (1, 2),
    }
    with pytest.raises(ConfigError) as caught:
        LocationMap.from_mapping(wrong)
    assert len(caught.value.problems) == 7


def test_names_that_will_be_taken_for_orders_are_warned_of():
    places = LocationMap.from_mapping({"stop": (1, 2), "no": (1, 2), "7": (1, 2), "bus stop": (1, 2)})
    messages = [warning.message for warning in places.warnings]
    assert [message.split("'")[1] for message in messages] == ["stop", "no", "7"]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("quick.yaml", "locations:\n  lab: {x: 1, y: 2}\n  stop: {x: 1, y: 2}\n"),
        ("map.csv", "name,x,y\nlab,1,2\nstop,1,2\n"),
        ("nav2.yaml", "waypoints:\n  lab: {x: 1, y: 2}\n  stop: {x: 1, y: 2}\n"),
        ("list.yaml", "waypoints:\n  - {name: lab, x: 1, y: 2}\n  - {name: stop, x: 1, y: 2}\n"),
    ],
)
def test_a_warning_has_its_line_in_every_form(tmp_path, name, text):
    (tmp_path / name).write_text(text)
    (tmp_path / "other.csv").write_text("name,x,y\nhall,1,2\n")
    for files in ([tmp_path / name], [tmp_path / "other.csv", tmp_path / name]):
        (warning,) = load(files).warnings
        assert (warning.file, warning.line) == (str(tmp_path / name), 3)
        assert warning.source == text.splitlines()[2]


@pytest.mark.parametrize("yaw", [90.0, -90.0, 360.0, 6.3])
def test_a_yaw_of_more_than_a_turn_is_degrees_and_refused_in_every_form(tmp_path, yaw):
    rad = f"{math.radians(yaw):.4f}"
    for name, text in {
        "quick.yaml": f"locations:\n  east: {{x: 1, y: 2, yaw: {yaw}}}\n",
        "slow.yaml": f'locations: {{"east": {{"x": 1, "y": 2, "yaw": {yaw}}}}}\n',
        "map.csv": f"name,x,y,yaw\neast,1,2,{yaw}\n",
    }.items():
        (tmp_path / name).write_text(text)
        with pytest.raises(ConfigError, match=f"degrees are {rad}"):
            load(tmp_path / name)
    with pytest.raises(ConfigError, match=f"degrees are {rad}"):
        LocationMap.from_mapping({"east": (1, 2, yaw)})


def test_a_yaw_of_a_whole_turn_may_be_rounded_up(tmp_path):
    (tmp_path / "map.yaml").write_text("locations:\n  east: {x: 1, y: 2, yaw: -6.2832}\n")
    assert load(tmp_path / "map.yaml")["east"].yaw == -6.2832


def test_a_map_is_a_mapping_of_frozen_places():
    places = from_text("locations:\n  The Lab: {x: 1, y: 2, aliases: [bay three]}\n")
    assert dict(places) == {"The Lab": Location("The Lab", 1.0, 2.0, aliases=("bay three",))}
    assert list(places.names()) == [(("lab",), "The Lab"), (("bay", "three"), "The Lab")]
    with pytest.raises(AttributeError):
        places["The Lab"].x = 3.0
    assert LocationMap().index.resolve("lab").status == "unknown"


@pytest.mark.parametrize("name", ["foyer", "front desk", "meeting room 2"])
@pytest.mark.parametrize("key", ["aliases", "tags"])
def test_one_name_is_a_list_of_one(tmp_path, key, name):
    """In every form of a map, as one text is in a grammar."""
    wanted = Location("hall", 1.0, 2.0, **{key: (name,)})
    for number, text in enumerate(
        (
            f"locations:\n  hall: {{x: 1.0, y: 2.0, {key}: {name}}}\n",
            f"locations:\n  hall:\n    x: 1.0\n    y: 2.0\n    {key}: '{name}'\n",
            f"waypoints:\n- {{name: hall, x: 1.0, y: 2.0, {key}: {name}}}\n",
        )
    ):
        path = tmp_path / f"{number}.yaml"
        path.write_text(text)
        assert dict(load(path)) == {"hall": wanted}
    assert dict(LocationMap.from_mapping({"hall": {"x": 1.0, "y": 2.0, key: name}})) == {"hall": wanted}


@pytest.mark.parametrize("sign", [",", ";", " / ", "|", "\n"])
def test_several_names_in_one_text_are_told_as_a_list(sign):
    with pytest.raises(ConfigError, match=r"aliases of 'hall' must be a list of names\n +aliases: \[foyer, bar\]"):
        LocationMap.from_mapping({"hall": {"x": 1.0, "y": 2.0, "aliases": f"foyer{sign}bar"}})
