"""Figures. They need the extra `plot`, and are drawn with whatever backend and style matplotlib is set to."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from strainsite.errors import StrainsiteError

from .extras import pyplot

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainsite.answers.compared import ComparedIndex, ComparedLocation, ComparedStudy
    from strainsite.answers.comparison import Comparison
    from strainsite.answers.maps import StrainMap
    from strainsite.answers.points import LocationStrain
    from strainsite.answers.ranked import Location
    from strainsite.answers.result import Result

_DIRECTIONS = {"x": "circumferential", "y": "meridional"}
# Okabe and Ito's, which the colour-blind can tell apart.
_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
_NO_VALUE = "0.75"


def unrolled_map(
    strain_map: StrainMap,
    value: str = "first_order",
    *,
    locations: Iterable[LocationStrain] = (),
    ax: Axes | None = None,
) -> Axes:
    """A layer of the map on the unrolled inner surface; grey where there is no value.

    Args:
        strain_map: The layer.
        value: `first_order`, `std`, `strain` or `error`.
        locations: Locations to mark; they lie on the crown.
        ax: Where to draw; the current axes when left out.

    """
    ax = cast("Axes", pyplot().gca()) if ax is None else ax
    direction, varied = strain_map.direction, strain_map.input
    labels = {
        "first_order": f"first-order index of {varied}",
        "std": "standard deviation of the strain",
        "strain": "strain at the means",
        "error": f"error of the index of {varied}",
    }
    if value not in labels:
        raise StrainsiteError(f"value is one of {', '.join(labels)}; it is {value!r}")
    data = np.ma.masked_invalid(getattr(strain_map, value))
    colours, low, high = _scale(value, data)
    mesh = ax.pcolormesh(
        strain_map.theta_deg, strain_map.phi_deg, data, cmap=colours, vmin=low, vmax=high, shading="nearest"
    )
    ax.set_facecolor(_NO_VALUE)
    for location in locations:
        ax.plot(location.theta_deg, 0.0, "o", markersize=5, color="white", markeredgecolor="black")
        ax.annotate(
            location.name,
            (location.theta_deg, 0.0),
            xytext=(0, 6),
            textcoords="offset points",
            ha="center",
            fontsize="small",
            bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        )
    ax.set_xlabel("angle from the contact centre, °")
    ax.set_ylabel("angle from the crown, °")
    ax.set_title(f"{_DIRECTIONS.get(direction, direction)} strain ({direction})")
    if ax.figure is not None:
        ax.figure.colorbar(mesh, ax=ax, label=labels[value])
    return ax


def map_figure(strain_map: StrainMap, value: str, locations: Iterable[LocationStrain]) -> Figure:
    """A figure with a layer of the map."""
    figure = _figure((7.5, 3.6))
    unrolled_map(strain_map, value, locations=locations, ax=figure.subplots())
    return figure


def _scale(value: str, data: np.ma.MaskedArray[Any, np.dtype[np.float64]]) -> tuple[str, float, float]:
    """Colours with their ends: indices from 0 to 1, so that maps compare; strains symmetric about 0."""
    largest = float(np.ma.max(np.ma.abs(data))) if data.count() else 1.0
    largest = largest or 1.0
    if value == "strain":
        return "RdBu_r", -largest, largest
    return "viridis", 0.0, 1.0 if value == "first_order" else largest


def ranking(result: Result, figure: Figure | None = None) -> Figure:
    """Indices of the ranked locations with their errors, best first, both directions side by side.

    A hollow bar has an error that isn't known; a name with a question mark has a rank that isn't certain.
    """
    figure = figure or _figure((8.0, 3.6))
    names = [f"{entry.name}{'' if entry.rank_certain else ' ?'}" for entry in result.locations]
    axes = cast("Sequence[Axes]", figure.subplots(1, 2, sharey=True))
    for ax, direction in zip(axes, _DIRECTIONS, strict=True):
        for k, location in enumerate(result.locations):
            index, error = _index(location, direction)
            if index is None:
                ax.annotate("none", (k, 0.0), ha="center", va="bottom", color="0.4")
                continue
            face = "none" if error is None else _COLOURS[0]
            ax.bar(k, index, width=0.65, facecolor=face, edgecolor=_COLOURS[0])
            if error is not None:
                ax.errorbar(k, index, yerr=_down_to_zero(index, error), color="black", capsize=4)
        ax.set_xticks(range(len(names)), names)
        ax.set_xlabel("location, best first")
        ax.set_title(f"{_DIRECTIONS[direction]} strain ({direction})")
        ax.set_ylim(bottom=0.0)
    axes[0].set_ylabel("first-order index of its own depth\nfor the strain at the centre, %")
    legend = []
    if any(None in (entry.gsi_x_error_percent, entry.gsi_y_error_percent) for entry in result.locations):
        legend.append("hollow: the error isn't known")
    if not all(entry.rank_certain for entry in result.locations):
        legend.append("?: the rank isn't certain")
    if legend:
        figure.supxlabel("; ".join(legend), fontsize="small", color="0.3")
    return figure


def _down_to_zero(index: float, error: float) -> list[list[float]]:
    """Both lengths of an error bar; an index isn't negative."""
    return [[max(min(error, index), 0.0)], [error]]


def _index(location: Location, direction: str) -> tuple[float | None, float | None]:
    if direction == "x":
        return location.gsi_x_percent, location.gsi_x_error_percent
    return location.gsi_y_percent, location.gsi_y_error_percent


def comparison(comparison: Comparison, figure: Figure | None = None) -> Figure:
    """Each location's index over the designs with its error, both directions.

    Full markers differ from the baseline for real, hollow ones within the errors; a design without an answer is a gap.
    """
    names = list(dict.fromkeys(row.location for row in comparison.rows))
    designs = comparison.studies
    figure = figure or _figure((max(6.0, 2.5 + 1.1 * len(designs)), 6.4))
    places = {study.id: k for k, study in enumerate(designs)}
    axes = cast("Sequence[Axes]", figure.subplots(2, 1, sharex=True))
    for ax, direction in zip(axes, _DIRECTIONS, strict=True):
        for n, name in enumerate(names):
            shift = 0.4 * (n / max(len(names) - 1, 1) - 0.5)
            rows = [row for row in comparison.rows if row.location == name and row.study in places]
            shifted = {study: k + shift for study, k in places.items()}
            _series(ax, rows, direction, name, _COLOURS[n % len(_COLOURS)], shifted)
        ax.set_title(f"{_DIRECTIONS[direction]} strain ({direction})")
        # Errors may be larger than what an index can be.
        ax.set_ylim(0.0, min(ax.get_ylim()[1], 105.0))
    axes[1].set_xticks(range(len(designs)), [_lines(study, comparison.baseline) for study in designs], fontsize="small")
    axes[1].set_xlim(-0.5, len(designs) - 0.5)
    figure.supylabel("first-order index of its own depth for the strain at the centre, %", fontsize="medium")
    figure.supxlabel(
        "full: differs from the baseline for real; hollow: within the errors", fontsize="small", color="0.3"
    )
    handles, _ = axes[0].get_legend_handles_labels()
    if handles:
        figure.legend(handles, names, title="location", loc="outside right upper")
    return figure


def _lines(study: ComparedStudy, baseline: str | None) -> str:
    """A design's name below its axis: each thing that it sets on a line."""
    text = study.name.replace(", ", "\n")
    if study.id == baseline:
        text += "\n(baseline)"
    return text if study.state == "done" else f"{text}\n({study.state})"


def _series(
    ax: Axes,
    rows: Sequence[ComparedLocation],
    direction: str,
    name: str,
    colour: str,
    places: dict[str, float],
) -> None:
    points: list[tuple[float, ComparedIndex]] = []
    for row in rows:
        index = row.x if direction == "x" else row.y
        if index.gsi_percent is not None:
            points.append((places[row.study], index))
    # Drawn even when it is empty, so that every location has its place in the legend.
    ax.plot(
        [place for place, _ in points],
        [index.gsi_percent for _, index in points if index.gsi_percent is not None],
        color=colour,
        linewidth=0.8,
        label=name,
    )
    for place, index in points:
        value = cast("float", index.gsi_percent)
        error = index.error_percent
        within = index.verdict in ("noise", "unknown")
        ax.errorbar(
            place,
            value,
            yerr=None if error is None else _down_to_zero(value, error),
            marker="o",
            color=colour,
            markerfacecolor="white" if within else colour,
            capsize=3,
        )


def _figure(size: tuple[float, float]) -> Figure:
    return cast("Figure", pyplot().figure(figsize=size, layout="constrained"))
