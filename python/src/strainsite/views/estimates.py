"""Estimates over time beside the truth."""

from __future__ import annotations

import itertools
import math
import statistics
from typing import TYPE_CHECKING, NamedTuple, cast

from .drawing import COLOURS, empty_figure

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# A longer time between rows than so many usual ones is a pause, over which no line is drawn.
_PAUSE = 10.0


class Row(NamedTuple):
    """One row of a run, with the ends of its interval."""

    time_s: float
    truth_n: float
    estimate_n: float
    low_n: float
    high_n: float


def bands(force: str, runs: Sequence[tuple[str, Sequence[Row]]], figure: Figure | None = None) -> Figure:
    """Truth, estimate and 95 % band over time, a panel for each run below one another."""
    figure = figure or empty_figure(8.0, 1.2 + 1.8 * max(len(runs), 1))
    axes = cast("Sequence[Sequence[Axes]]", figure.subplots(max(len(runs), 1), 1, sharey=True, squeeze=False))
    for (ax,), (run, rows) in zip(axes, runs, strict=False):
        _run(ax, rows)
        ax.set_title(run, fontsize="medium")
    axes[-1][0].set_xlabel("time, s")
    figure.supylabel(f"{force}, N", fontsize="medium")
    handles, names = axes[0][0].get_legend_handles_labels()
    if handles:
        figure.legend(handles, names, loc="outside upper right", ncols=len(handles), fontsize="small")
    return figure


def _run(ax: Axes, rows: Sequence[Row]) -> None:
    drawn = _with_gaps(sorted(rows))
    times = [row.time_s for row in drawn]
    low, high = [row.low_n for row in drawn], [row.high_n for row in drawn]
    ax.fill_between(times, low, high, color=COLOURS[5], alpha=0.4, linewidth=0.0, label="95 %")
    ax.plot(times, [row.truth_n for row in drawn], color=COLOURS[6], linewidth=1.0, label="measured")
    ax.plot(times, [row.estimate_n for row in drawn], color=COLOURS[1], linewidth=1.0, label="estimated")


def _with_gaps(rows: Sequence[Row]) -> list[Row]:
    """With a row of nothing in each pause."""
    steps = [later.time_s - earlier.time_s for earlier, later in itertools.pairwise(rows)]
    if not steps:
        return list(rows)
    longest = _PAUSE * statistics.median(steps)
    drawn = [rows[0]]
    for row, step in zip(rows[1:], steps, strict=True):
        if step > longest:
            drawn.append(Row(row.time_s, math.nan, math.nan, math.nan, math.nan))
        drawn.append(row)
    return drawn
