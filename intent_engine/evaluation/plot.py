"""Accuracy and latency in one picture: neither says much without the other."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from intent_engine.errors import ConfigError, Problem
from intent_engine.evaluation.scoring import Outcome, Score

__all__ = ["plot_scores"]


def plot_scores(
    scores: Sequence[Score], outcomes: Sequence[Outcome], path: Path, *, goal: float | None = None, title: str = ""
) -> None:
    """Draw accuracy against noise, one line a model, and the distribution of the time to the action.

    Args:
        scores: one for each condition.
        outcomes: of all conditions.
        path: PNG, SVG or PDF.
        goal: share of commands that should be right, drawn as a line.
        title: stands above both.

    Raises:
        ConfigError: matplotlib is not installed, or the file cannot be written.
    """
    try:
        from matplotlib.figure import Figure
    except ImportError:
        hint = "pip install 'intent-engine[evaluate]'"
        raise ConfigError(Problem("drawing needs matplotlib, which is not installed", hint=hint)) from None
    figure = Figure(figsize=(10, 4.2), layout="constrained")
    if title:
        figure.suptitle(title)
    left, right = figure.subplots(1, 2)
    models = list(dict.fromkeys(found.model for found in scores))
    noises = list(dict.fromkeys(found.noise for found in scores))
    for index, model in enumerate(models):
        rows = [found for found in scores if found.model == model and found.accuracy is not None]
        shift = (index - (len(models) - 1) / 2) * 0.06
        places = [noises.index(found.noise) + shift for found in rows]
        shares = [100 * (found.accuracy or 0.0) for found in rows]
        below = [share - 100 * (found.accuracy_low or 0.0) for share, found in zip(shares, rows, strict=True)]
        above = [100 * (found.accuracy_high or 0.0) - share for share, found in zip(shares, rows, strict=True)]
        left.errorbar(places, shares, yerr=[below, above], marker="o", capsize=3, label=model)
        times = sorted(
            1000 * one.latency for one in outcomes if one.condition.model == model and one.latency is not None
        )
        if times:
            right.step(
                times, [100 * (place + 1) / len(times) for place in range(len(times))], where="post", label=model
            )
    left.set_xticks(range(len(noises)), [noise if noise != "none" else "no noise" for noise in noises])
    left.set(ylim=(0, 104), xlabel="noise (signal to noise)", ylabel="commands right in %", title="Accuracy")
    left.set_xlim(-0.5, len(noises) - 0.5)
    if goal is not None:
        left.axhline(100 * goal, color="grey", linestyle=":", linewidth=1)
    right.set(
        ylim=(0, 104),
        xlabel="end of speech to action in ms",
        ylabel="of the commands that were right, in %",
        title="Time to the action",
    )
    right.set_xlim(left=min(0.0, right.get_xlim()[0]))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.spines[["top", "right"]].set_visible(False)
    if models:
        left.legend(frameon=False, loc="lower left")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, dpi=150)
    except ValueError as error:
        hint = "end its name in .png, .svg or .pdf"
        raise ConfigError(Problem(f"cannot be drawn: {error}", str(path), hint=hint)) from None
    except OSError as error:
        raise ConfigError(Problem(f"cannot be written: {error.strerror or error}", str(path))) from None
