"""Indices over designs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from .drawing import COLOURS, DIRECTIONS, down_to_zero, empty_figure, title

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class DesignIndex:
    """A location's index in one design, percent."""

    design: int
    """Place of the design, from the left."""
    value: float
    error: float | None
    within: bool
    """Whether it differs from the baseline within the errors alone."""


def lines(
    designs: Sequence[str],
    indices: Mapping[str, Mapping[str, Sequence[DesignIndex]]],
    figure: Figure | None = None,
) -> Figure:
    """Each location's index over the designs with its error, both directions.

    Full markers differ from the baseline for real, hollow ones within the errors; a design without an answer is a gap.

    Args:
        designs: What stands below the designs.
        indices: By direction, `x` and `y`, and location; the same locations in both.
        figure: Where to draw; a new one when left out.

    """
    figure = figure or empty_figure(max(6.0, 2.5 + 1.1 * len(designs)), 6.4)
    axes = cast("Sequence[Axes]", figure.subplots(2, 1, sharex=True))
    for ax, direction in zip(axes, DIRECTIONS, strict=True):
        _direction(ax, indices[direction])
        ax.set_title(title(direction))
        # Errors may be larger than what an index can be.
        ax.set_ylim(0.0, min(ax.get_ylim()[1], 105.0))
    axes[1].set_xticks(range(len(designs)), designs, fontsize="small")
    axes[1].set_xlim(-0.5, len(designs) - 0.5)
    figure.supylabel("first-order index of its own depth for the strain at the centre, %", fontsize="medium")
    figure.supxlabel(
        "full: differs from the baseline for real; hollow: within the errors", fontsize="small", color="0.3"
    )
    handles, names = axes[0].get_legend_handles_labels()
    if handles:
        figure.legend(handles, names, title="location", loc="outside right upper")
    return figure


def _direction(ax: Axes, indices: Mapping[str, Sequence[DesignIndex]]) -> None:
    """A line for each location, side by side so that their errors don't hide one another."""
    for n, (name, points) in enumerate(indices.items()):
        colour = COLOURS[n % len(COLOURS)]
        shift = 0.4 * (n / max(len(indices) - 1, 1) - 0.5)
        places = [point.design + shift for point in points]
        # Drawn even when it is empty, so that every location has its place in the legend.
        ax.plot(places, [point.value for point in points], color=colour, linewidth=0.8, label=name)
        for place, point in zip(places, points, strict=True):
            ax.errorbar(
                place,
                point.value,
                yerr=None if point.error is None else down_to_zero(point.value, point.error),
                marker="o",
                color=colour,
                markerfacecolor="white" if point.within else colour,
                capsize=3,
            )
