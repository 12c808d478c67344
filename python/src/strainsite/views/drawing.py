"""What figures have in common.

They need the extra `plot`, and are drawn with whatever backend and style matplotlib is set to.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from .extras import pyplot

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DIRECTIONS = {"x": "circumferential", "y": "meridional"}
# Okabe and Ito's, which the colour-blind can tell apart.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")


def empty_figure(width: float, height: float) -> Figure:
    """A figure of this size, inches."""
    return cast("Figure", pyplot().figure(figsize=(width, height), layout="constrained"))


def title(direction: str) -> str:
    """The title of a direction's axes."""
    return f"{DIRECTIONS.get(direction, direction)} strain ({direction})"


def down_to_zero(index: float, error: float) -> list[list[float]]:
    """Both lengths of an error bar; an index isn't negative."""
    return [[max(min(error, index), 0.0)], [error]]
