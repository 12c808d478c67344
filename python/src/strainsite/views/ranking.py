"""The ranking as bars."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, cast

from .drawing import COLOURS, DIRECTIONS, down_to_zero, empty_figure, title

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


class Index(NamedTuple):
    """A Sobol index with its error, percent; None where it isn't known."""

    value: float | None
    error: float | None


@dataclass(frozen=True)
class RankedLocation:
    """A location with its index in either direction."""

    name: str
    certain: bool
    x: Index
    y: Index


def bars(locations: Sequence[RankedLocation], figure: Figure | None = None) -> Figure:
    """Indices of the locations with their errors, both directions side by side.

    A hollow bar has an error that isn't known; a name with a question mark has a rank that isn't certain.
    """
    figure = figure or empty_figure(8.0, 3.6)
    names = [f"{location.name}{'' if location.certain else ' ?'}" for location in locations]
    columns = {"x": [location.x for location in locations], "y": [location.y for location in locations]}
    axes = cast("Sequence[Axes]", figure.subplots(1, 2, sharey=True))
    for ax, direction in zip(axes, DIRECTIONS, strict=True):
        for k, index in enumerate(columns[direction]):
            _bar(ax, k, index)
        ax.set_xticks(range(len(names)), names)
        ax.set_xlabel("location, best first")
        ax.set_title(title(direction))
        ax.set_ylim(bottom=0.0)
    axes[0].set_ylabel("first-order index of its own depth\nfor the strain at the centre, %")
    if said := _legend(locations):
        figure.supxlabel("; ".join(said), fontsize="small", color="0.3")
    return figure


def _bar(ax: Axes, k: int, index: Index) -> None:
    if index.value is None:
        ax.annotate("none", (k, 0.0), ha="center", va="bottom", color="0.4")
        return
    face = "none" if index.error is None else COLOURS[0]
    ax.bar(k, index.value, width=0.65, facecolor=face, edgecolor=COLOURS[0])
    if index.error is not None:
        ax.errorbar(k, index.value, yerr=down_to_zero(index.value, index.error), color="black", capsize=4)


def _legend(locations: Sequence[RankedLocation]) -> list[str]:
    said = []
    if any(None in (location.x.error, location.y.error) for location in locations):
        said.append("hollow: the error isn't known")
    if not all(location.certain for location in locations):
        said.append("?: the rank isn't certain")
    return said
