"""The path as text and as a picture."""

from __future__ import annotations

import math

import pytest

from intent_engine.actions import Move, Navigate, Turn
from intent_engine.errors import ConfigError
from intent_engine.execution.robots.path_view import LiveView, path_text, plot_path
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.execution.robots.trace import path_points


@pytest.fixture
def driven(stage):
    s = stage()
    s.executor.wait(s.executor.submit([Move(0.5, 3.0, 6.0), Turn(math.pi / 2, 1.0, math.pi / 2), Move(0.5, 2.0, 4.0)]))
    return s


def test_the_text_shows_start_end_places_and_way(driven):
    text = path_text(driven.robot, 50, 16)
    *drawing, legend = text.splitlines()
    assert len(drawing) <= 16
    assert max(len(line) for line in drawing) <= 50
    assert "◇ kitchen" in text
    assert "↑" in text
    assert legend.endswith("end: x 3.00 m, y 2.00 m, 90 deg")
    start_row = next(index for index, line in enumerate(drawing) if "o" in line.replace("dock", ""))
    end_row = next(index for index, line in enumerate(drawing) if "↑" in line)
    assert end_row < start_row


def test_ascii_is_ascii(driven):
    text = path_text(driven.robot, ascii_only=True)
    assert text.isascii()
    assert "^" in text


def test_a_robot_that_never_moved_can_be_drawn():
    text = path_text(SimulatedRobot(), 20, 5)
    assert "→" in text


def test_the_picture_is_written(driven, tmp_path):
    pytest.importorskip("matplotlib", reason="needs the plot extra")
    file = tmp_path / "path.png"
    plot_path(driven.robot, file, title="a square corner")
    assert file.read_bytes().startswith(b"\x89PNG")
    with pytest.raises(ConfigError, match="cannot be written"):
        plot_path(driven.robot, tmp_path / "missing" / "path.png")


def test_the_live_view_follows(stage):
    s = stage()
    view = LiveView(s.robot)
    s.executor.submit(Navigate("dock", 10.0, 0.0, 0.0))
    seen = set()
    for _ in range(5):
        s.clock.advance(4.0)
        seen.add(str(view))
    assert len(seen) == 5
    assert view.__rich__().plain == str(view)


def test_a_curve_is_cut_into_short_lines(stage):
    s = stage()
    s.robot.velocity(1.0, 1.0, 60.0)
    s.clock.advance(math.pi)
    points = path_points(s.robot.trace, s.robot.pose())
    assert len(points) > 30
    assert all(math.hypot(p.x, p.y - 1.0) == pytest.approx(1.0) for p in points)
