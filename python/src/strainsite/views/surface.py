"""The map on the unrolled inner surface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from strainsite.errors import StrainsiteError

from .drawing import title
from .extras import pyplot

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

_NO_VALUE = "0.75"


@dataclass(frozen=True, eq=False)
class Layer:
    """What can be drawn of one direction; `phi_deg` counts the rows of each array, `theta_deg` the columns."""

    direction: str
    input: str
    theta_deg: NDArray[np.float64]
    phi_deg: NDArray[np.float64]
    quantities: Mapping[str, NDArray[np.float64]]
    """`first_order`, `total`, `std`, `strain` and `error`; nan where there is no value."""


def unrolled_map(layer: Layer, value: str, *, marks: Iterable[tuple[str, float]] = (), ax: Axes | None = None) -> Axes:
    """A layer on the unrolled inner surface; grey where there is no value.

    Args:
        layer: The layer.
        value: `first_order`, `total`, `std`, `strain` or `error`.
        marks: Names on the crown with their angles from the contact centre, degrees.
        ax: Where to draw; the current axes when left out.

    """
    ax = cast("Axes", pyplot().gca()) if ax is None else ax
    labels = {
        "first_order": f"first-order index of {layer.input}",
        "total": f"total index of {layer.input}",
        "std": "standard deviation of the strain",
        "strain": "strain at the means",
        "error": f"error of the index of {layer.input}",
    }
    if value not in labels:
        raise StrainsiteError(f"value is one of {', '.join(labels)}; it is {value!r}")
    data = np.ma.masked_invalid(layer.quantities[value])
    colours, low, high = _scale(value, data)
    mesh = ax.pcolormesh(layer.theta_deg, layer.phi_deg, data, cmap=colours, vmin=low, vmax=high, shading="nearest")
    ax.set_facecolor(_NO_VALUE)
    for name, theta_deg in marks:
        _mark(ax, name, theta_deg)
    ax.set_xlabel("angle from the contact centre, °")
    ax.set_ylabel("angle from the crown, °")
    ax.set_title(title(layer.direction))
    if ax.figure is not None:
        ax.figure.colorbar(mesh, ax=ax, label=labels[value])
    return ax


def _scale(value: str, data: np.ma.MaskedArray[Any, np.dtype[np.float64]]) -> tuple[str, float, float]:
    """Colours with their ends: indices from 0 to 1, so that maps compare; strains symmetric about 0."""
    largest = float(np.ma.max(np.ma.abs(data))) if data.count() else 1.0
    largest = largest or 1.0
    if value == "strain":
        return "RdBu_r", -largest, largest
    return "viridis", 0.0, 1.0 if value in {"first_order", "total"} else largest


def _mark(ax: Axes, name: str, theta_deg: float) -> None:
    ax.plot(theta_deg, 0.0, "o", markersize=5, color="white", markeredgecolor="black")
    ax.annotate(
        name,
        (theta_deg, 0.0),
        xytext=(0, 6),
        textcoords="offset points",
        ha="center",
        fontsize="small",
        bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
    )
