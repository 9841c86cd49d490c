"""The path that a simulated robot drove: as a picture, as text for a terminal, and live."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from intent_engine.errors import ConfigError
from intent_engine.execution.robots.robot import Pose
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.execution.robots.trace import path_points

__all__ = ["LiveView", "path_text", "plot_path"]

_ARROWS = "→↗↑↖←↙↓↘"
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""Bit of each dot in a braille cell: row, column."""


def plot_path(
    robot: SimulatedRobot, file: str | os.PathLike[str], *, title: str = "", locations: Mapping[str, Pose] | None = None
) -> None:
    """Draw the path as a picture (PNG, SVG or PDF, by the file's ending).

    Args:
        robot: whose path.
        file: where to write it.
        title: above the picture.
        locations: places to show; None: those of the robot's map.

    Raises:
        ConfigError: matplotlib is not installed, or the file cannot be written.
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        raise ConfigError("drawing a picture needs matplotlib: pip install 'intent-engine[plot]'") from None
    points = path_points(robot.trace, robot.pose())
    places = robot.locations if locations is None else locations
    # A figure of its own, without pyplot: no window system, no global state.
    figure = Figure(figsize=(7.0, 6.0), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(True, color="0.92")
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    if title:
        axes.set_title(title)
    for name, place in places.items():
        axes.plot(place.x, place.y, "s", color="0.6", markersize=5)
        axes.annotate(name, (place.x, place.y), (5, 4), textcoords="offset points", color="0.35", fontsize=8)
    axes.plot([p.x for p in points], [p.y for p in points], "-", color="tab:blue", linewidth=2)
    first, last = points[0], points[-1]
    axes.plot(first.x, first.y, "o", color="tab:green", label="start")
    reach = 0.06 * max(_extent(points), 1.0)
    axes.annotate(
        "",
        (last.x + reach * math.cos(last.yaw), last.y + reach * math.sin(last.yaw)),
        (last.x, last.y),
        arrowprops={"arrowstyle": "->", "color": "tab:red", "linewidth": 2},
    )
    axes.plot(last.x, last.y, "o", color="tab:red", label=f"end ({last.x:.2f}, {last.y:.2f}) m")
    axes.legend(loc="best", fontsize=8)
    try:
        figure.savefig(os.fspath(file), dpi=120)
    except (OSError, ValueError) as error:
        raise ConfigError(f"{os.fspath(file)}: the picture cannot be written: {error}") from None


def path_text(
    robot: SimulatedRobot,
    width: int = 60,
    height: int = 20,
    *,
    locations: Mapping[str, Pose] | None = None,
    ascii_only: bool = False,
) -> str:
    """Draw the path with characters, x to the right and y upwards, with one scale for both.

    Args:
        robot: whose path.
        width: of the drawing, in characters.
        height: at most, in lines.
        locations: places to show; None: those of the robot's map.
        ascii_only: for terminals without braille and arrows.

    Returns:
        Lines without a newline at the end: the drawing, and one line of legend.
    """
    pose = robot.pose()
    return _draw(
        path_points(robot.trace, pose),
        pose,
        robot.locations if locations is None else locations,
        max(width, 10),
        max(height, 3),
        ascii_only,
    )


class LiveView:
    """The path, drawn again whenever it is shown: for ``rich.live.Live(LiveView(robot))`` and the like."""

    def __init__(self, robot: SimulatedRobot, width: int = 60, height: int = 20, ascii_only: bool = False) -> None:
        self._robot, self._width, self._height, self._ascii = robot, width, height, ascii_only

    def __str__(self) -> str:
        return path_text(self._robot, self._width, self._height, ascii_only=self._ascii)

    def __rich__(self) -> Any:
        from rich.text import Text

        return Text(str(self), no_wrap=True)


def _extent(points: Sequence[Pose]) -> float:
    xs, ys = [p.x for p in points], [p.y for p in points]
    return max(max(xs) - min(xs), max(ys) - min(ys))


def _draw(
    points: Sequence[Pose], end: Pose, places: Mapping[str, Pose], width: int, height: int, ascii_only: bool
) -> str:
    shown = [*points, *places.values()]
    left, right = min(p.x for p in shown), max(p.x for p in shown)
    low, high = min(p.y for p in shown), max(p.y for p in shown)
    # A cell is about twice as high as wide. At least a metre is shown, so that a turn on the spot is not a riddle.
    scale = max((right - left) / (width - 1), (high - low) / (2.0 * (height - 1)), 1.0 / (width - 1))
    rows = min(height, max(3, math.ceil((high - low) / (2.0 * scale)) + 1))
    middle_x, middle_y = (left + right) / 2.0, (low + high) / 2.0

    def column(x: float) -> float:
        return (x - middle_x) / scale + (width - 1) / 2.0

    def row(y: float) -> float:
        return (rows - 1) / 2.0 - (y - middle_y) / (2.0 * scale)

    cells = [[0] * width for _ in range(rows)]
    for a, b in pairwise(points):
        steps = max(1, math.ceil(max(abs(b.x - a.x), abs(b.y - a.y)) / scale * 4))
        for step in range(steps + 1):
            share = step / steps
            x = column(a.x + (b.x - a.x) * share) + 0.5
            y = row(a.y + (b.y - a.y) * share) + 0.5
            c, r = min(max(int(x), 0), width - 1), min(max(int(y), 0), rows - 1)
            cells[r][c] |= _DOTS[min(int((y - int(y)) * 4), 3)][min(int((x - int(x)) * 2), 1)]
    canvas = [[("." if ascii_only else chr(0x2800 + bits)) if bits else " " for bits in line] for line in cells]

    def mark(pose: Pose, text: str, keep: bool = False) -> None:
        r, c = round(row(pose.y)), round(column(pose.x))
        if not 0 <= r < rows:
            return
        c = max(min(c, width - len(text)), 0)
        for index, letter in enumerate(text):
            if c + index < width and not (keep and canvas[r][c + index] != " "):
                canvas[r][c + index] = letter

    for name, place in places.items():
        mark(place, f"+ {name}" if ascii_only else f"◇ {name}", keep=True)
    mark(points[0], "o")
    if ascii_only:
        mark(end, ">^<v"[round(end.yaw / (math.pi / 2)) % 4])
    else:
        mark(end, _ARROWS[round(end.yaw / (math.pi / 4)) % 8])
    drawing = "\n".join("".join(line).rstrip() for line in canvas)
    degrees = math.degrees(math.remainder(end.yaw, math.tau))
    legend = f"o start   {scale * (width - 1):.1f} m wide   end: x {end.x:.2f} m, y {end.y:.2f} m, {degrees:.0f} deg"
    return f"{drawing}\n{legend}"
