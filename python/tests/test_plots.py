"""Figures: what is drawn is what the answers say, and it can be written."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.collections import QuadMesh
from matplotlib.patches import Rectangle

import strainsite

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from strainsite import Result


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    yield
    plt.close("all")


def test_the_map_is_drawn_with_its_values_and_the_locations(result: Result, tmp_path: Path) -> None:
    for value in ("first_order", "std", "strain", "error"):
        figure = result.plot_map("y", "P3", value)
        ax = figure.axes[0]
        mesh = next(artist for artist in ax.get_children() if isinstance(artist, QuadMesh))
        array = mesh.get_array()
        assert array is not None
        np.testing.assert_array_equal(np.ma.filled(array, np.nan), getattr(result.map("y", "P3"), value))
        assert {text.get_text() for text in ax.texts} == {"P1", "P2", "P3", "P4", "P5"}
        assert "°" in ax.get_xlabel()
        assert "°" in ax.get_ylabel()
    path = tmp_path / "map.png"
    figure.savefig(path)
    assert path.stat().st_size > 5_000
    with pytest.raises(strainsite.StrainsiteError, match="value is one of first_order, total, std, strain, error"):
        result.plot_map(value="colour")


def test_the_ranking_has_bars_with_errors_where_they_are_known(result: Result, coarse: Result, tmp_path: Path) -> None:
    for name, answer in (("draft", result), ("coarse", coarse)):
        figure = answer.plot_ranking()
        for ax, direction in zip(figure.axes, ("x", "y"), strict=True):
            values = [getattr(location, f"gsi_{direction}_percent") for location in answer.locations]
            errors = [getattr(location, f"gsi_{direction}_error_percent") for location in answer.locations]
            bars = [patch.get_height() for patch in ax.patches if isinstance(patch, Rectangle)]
            assert bars == [value for value in values if value is not None]
            assert len(ax.containers) == len(bars) + sum(error is not None for error in errors)
        figure.savefig(tmp_path / f"{name}.png")
        assert (tmp_path / f"{name}.png").stat().st_size > 5_000


def test_maps_can_be_drawn_into_figures_of_ones_own(result: Result) -> None:
    _, axes = plt.subplots(1, 2)
    for ax, direction in zip(axes, ("x", "y"), strict=True):
        assert result.map(direction, "P2").plot(ax=ax) is ax
