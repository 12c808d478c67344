"""Frames, tables and figures of plain values."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_hex

from strainsite.views import designs, frames, html, ranking, surface

if TYPE_CHECKING:
    from collections.abc import Iterator


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    yield
    plt.close("all")


def test_a_column_without_a_value_is_one_of_numbers() -> None:
    frame = frames.frame([{"a": 1, "b": None}, {"a": 2, "b": None}], origin={"id": "7"})
    assert frame["b"].dtype == "float64"
    assert frame.attrs == {"id": "7"}
    assert frames.frame([]).empty


def test_html_is_escaped_and_leaves_out_what_is_empty() -> None:
    row = ("<b>", html.with_error(72.861, 2.94), html.difference(1.2, None))
    shown = html.table(("a & b", "", ""), [row], caption="<i>")
    assert shown == (
        "<table><caption>&lt;i&gt;</caption><thead><tr><th>a &amp; b</th><th></th><th></th></tr></thead>"
        "<tbody><tr><td>&lt;b&gt;</td><td>72.86 ±2.94</td><td>+1.20</td></tr></tbody></table>"
    )
    assert html.bullets(["<a>", "b"]) == "<ul><li>&lt;a&gt;</li><li>b</li></ul>"
    assert html.paragraph("<a>") == "<p>&lt;a&gt;</p>"
    assert html.bullets([]) == html.paragraph(None) == html.difference(None, None) == ""
    assert html.with_error(None, 1.0) == "none"
    assert html.with_error(1.0, None) == "1.00"
    assert html.difference(-1.0, 0.5) == "-1.00 ±0.50"


def test_the_ranking_says_what_is_not_known() -> None:
    known = ranking.Index(50.0, 60.0)
    entries = [
        ranking.RankedLocation("P1", certain=False, x=known, y=ranking.Index(40.0, None)),
        ranking.RankedLocation("P2", certain=True, x=known, y=ranking.Index(None, None)),
    ]
    figure = ranking.bars(entries)
    left, right = figure.axes
    assert [label.get_text() for label in left.get_xticklabels()] == ["P1 ?", "P2"]
    assert [text.get_text() for text in right.texts] == ["none"]
    assert len(left.patches) == 2
    assert to_hex(right.patches[0].get_facecolor(), keep_alpha=True).endswith("00")
    assert figure.get_supxlabel() == "hollow: the error isn't known; ?: the rank isn't certain"


def test_designs_within_the_errors_are_hollow_and_those_without_an_answer_are_gaps() -> None:
    points = [designs.DesignIndex(0, 10.0, 1.0, within=False), designs.DesignIndex(2, 11.0, None, within=True)]
    indices = {"P1": points, "P2": []}
    figure = designs.lines(["a", "b", "c"], {"x": indices, "y": indices})
    lines = [line for line in figure.axes[0].lines if line.get_linewidth() == 0.8]
    assert [np.asarray(line.get_xdata()).tolist() for line in lines] == [[-0.2, 1.8], []]
    faces = [to_hex(str(line.get_markerfacecolor())) for line in figure.axes[0].lines if line.get_marker() == "o"]
    assert faces == ["#0072b2", "#ffffff"]
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["P1", "P2"]


def test_a_map_of_nothing_is_drawn() -> None:
    nothing = np.full((2, 3), np.nan)
    angles = np.arange(3.0)
    layer = surface.Layer("z", "wall", angles, angles[:2], {"std": nothing})
    ax = surface.unrolled_map(layer, "std", marks=[("P1", 1.0)])
    assert ax.get_title() == "z strain (z)"
    assert [text.get_text() for text in ax.texts] == ["P1"]
