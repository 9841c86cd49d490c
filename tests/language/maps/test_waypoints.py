"""Waypoint files of Nav2 and of the programs around it."""

from __future__ import annotations

import math

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from map_files import problems_of

from intent_engine.language.locations import Location, from_text

HALF = math.sqrt(0.5)
WAYPOINTS = {
    "saved by the RViz panel": (
        f"waypoints:\n  waypoint0:\n    pose: [1.0, 2.0, 0.3]\n    orientation: [{HALF}, 0.0, 0.0, {HALF}]\n",
        Location("waypoint0", 1.0, 2.0, math.pi / 2),
    ),
    "poses by name": (
        "waypoints:\n- name: kitchen\n  frame_id: odom\n  pose:\n    position: {x: 1, y: 2, z: 0}\n"
        f"    orientation: {{x: 0, y: 0, z: {-HALF}, w: {HALF}}}\n",
        Location("kitchen", 1.0, 2.0, -math.pi / 2, "odom"),
    ),
    "stamped poses": (
        "waypoints:\n- {name: lab, pose: {header: {frame_id: odom}, pose: {position: {x: 1, y: 2}}}}\n",
        Location("lab", 1.0, 2.0, 0.0, "odom"),
    ),
    "position beside the name": (
        f"waypoints:\n- name: lab\n  position: {{x: 1, y: 2, z: 0}}\n  orientation: {{z: {HALF}, w: {HALF}}}\n",
        Location("lab", 1.0, 2.0, math.pi / 2),
    ),
    "numbers": (
        "frame_id: level1\nwaypoints:\n  lab: {x: 1, y: 2, yaw: 0.5, aliases: [workshop], tags: [room]}\n",
        Location("lab", 1.0, 2.0, 0.5, "level1", ("workshop",), ("room",)),
    ),
    "without a name": ("waypoints:\n- [1, 2, 0]\n", Location("waypoint 1", 1.0, 2.0)),
}


@pytest.mark.parametrize("case", WAYPOINTS)
def test_waypoints(case):
    text, expected = WAYPOINTS[case]
    (place,) = from_text(text).values()
    assert (place.x, place.y) == (expected.x, expected.y)
    assert place.yaw == pytest.approx(expected.yaw)
    assert place == Location(
        expected.name, place.x, place.y, place.yaw, expected.frame, expected.aliases, expected.tags
    )


@given(st.floats(-math.pi, math.pi), st.booleans())
def test_a_quaternion_is_its_yaw(yaw, as_list):
    w, z = math.cos(yaw / 2), math.sin(yaw / 2)
    orientation = [w, 0.0, 0.0, z] if as_list else {"w": w, "x": 0.0, "y": 0.0, "z": z}
    text = yaml.safe_dump({"waypoints": {"hall": {"pose": [1.0, 2.0, 3.0], "orientation": orientation}}})
    found = from_text(text)["hall"]
    assert math.remainder(found.yaw - yaw, 2 * math.pi) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize(
    ("row", "says"),
    [
        ("{latitude: 1.0, longitude: 2.0, yaw: 0.0}", "latitude and longitude"),
        ("[1, 2, 3]", "may be z or yaw"),
        ("{name: lab, pose: [1, 2, 3]}", "may be z or yaw"),
        ("{name: lab, x: 1, y: 2, th: 90}", "unknown key 'th'"),
        ("{name: lab, x: 1, y: 2, orientation: [0, 0, 0, 0]}", "length 0"),
        ("{name: lab, x: 1, y: 2, orientation: [0, 1]}", "no quaternion"),
        ("{name: lab, x: 1, y: 2, yaw: 1, orientation: [1, 0, 0, 0]}", "both yaw and orientation"),
        ("{name: lab, y: 2}", "needs 'x'"),
        ("{name: lab, x: .nan, y: 2}", "finite"),
        ("{name: on, x: 1, y: 2}", "YAML reads the name on"),
        ("five", "must be a pose"),
    ],
)
def test_waypoints_that_cannot_be_meant(tmp_path, row, says):
    (problem,) = problems_of(f"waypoints:\n- {row}\n", tmp_path / "waypoints.yaml")
    assert says in problem
