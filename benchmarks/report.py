"""What a benchmark hands to the collector besides rows: tables of its own, and plots."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Table:
    """A table for the page, as it is."""

    title: str
    columns: list[str]
    rows: list[list[str]]
    note: str = ""
    """What a reader must know to read it; Markdown."""


@dataclass(frozen=True)
class Plot:
    """Lines over one axis, both axes logarithmic."""

    title: str
    file: str
    """Name of the picture in ``docs/images/``, ending in .svg."""
    x: str
    y: str
    series: dict[str, list[list[float]]]
    """Name -> [x, y] points; the first is ours."""


@dataclass(frozen=True)
class Report:
    """All that one benchmark found."""

    rows: list[dict[str, Any]]
    tables: list[Table] = field(default_factory=list)
    plots: list[Plot] = field(default_factory=list)

    @staticmethod
    def of(found: Report | list[dict[str, Any]]) -> Report:
        """A part may also be its rows alone."""
        return found if isinstance(found, Report) else Report(found)

    def extras(self, module: str) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
        """Tables and plots as results.json keeps them."""
        return (
            [{"module": module, **asdict(table)} for table in self.tables],
            [{"module": module, **asdict(plot)} for plot in self.plots],
        )


def markdown(table: dict[str, Any]) -> str:
    """A table of results.json for the page."""
    columns = table["columns"]
    lines = [f"**{table['title']}**\n", "| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    lines += ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |" for row in table["rows"]]
    return "\n".join(lines) + "\n" + (f"\n{table['note']}\n" if table["note"] else "")


def draw(plots: list[dict[str, Any]], path: Path) -> None:
    """Plots of one picture side by side, as a small SVG that is the same for the same numbers."""
    import matplotlib as mpl

    mpl.use("svg")
    from matplotlib import pyplot as plt

    style: dict[Any, Any] = {"svg.hashsalt": "intent-engine", "svg.fonttype": "none", "font.size": 9, "axes.grid": True,
             "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False}  # fmt: skip
    with plt.rc_context(style):
        figure, axes = plt.subplots(1, len(plots), figsize=(4.6 * len(plots), 3.4), squeeze=False)
        for axis, plot in zip(axes[0], plots, strict=True):
            for place, (name, points) in enumerate(plot["series"].items()):
                emphasis = {"linewidth": 2.2, "color": "#00796b"} if place == 0 else {"linewidth": 1.1}
                axis.plot(*zip(*points, strict=True), marker="o", markersize=3, label=name, **emphasis)
            axis.set(xscale="log", yscale="log", xlabel=plot["x"], ylabel=plot["y"], title=plot["title"])
            axis.legend(frameon=False, fontsize=8)
        figure.tight_layout()
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, metadata={"Date": None})
        plt.close(figure)
