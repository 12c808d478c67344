"""Objects as notebooks show them."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from .result import Result
    from .study import StudySummary


def result(result: Result) -> str:
    """The ranking with its errors, and what to know before believing it."""
    rows = [
        (
            location.rank,
            location.name,
            with_error(location.gsi_x_percent, location.gsi_x_error_percent),
            with_error(location.gsi_y_percent, location.gsi_y_error_percent),
            "certain" if location.rank_certain else "not certain",
        )
        for location in result.locations
    ]
    head = ("rank", "location", "index x, %", "index y, %", "rank is")
    notes = "".join(f"<li>{escape(note)}</li>" for note in result.notes)
    caption = f"{result.study.name}: {result.cost.solves} solves, {result.cost.wall_s:.2f} s"
    return _table(caption, head, rows) + (f"<ul>{notes}</ul>" if notes else "")


def study(summary: StudySummary) -> str:
    """Where a study stands."""
    head = ("study", "state", "points", "id")
    points = f"{summary.points_done} of {summary.points_total or '?'}"
    reason = f"<p>{escape(summary.error)}</p>" if summary.error else ""
    return _table("", head, [(summary.name, summary.state, points, summary.id)]) + reason


def with_error(value: float | None, error: float | None) -> str:
    """As in 72.86 ±2.94; or `none`."""
    if value is None:
        return "none"
    return f"{value:.2f}" if error is None else f"{value:.2f} ±{error:.2f}"


def _table(caption: str, head: Sequence[object], rows: Iterable[Sequence[object]]) -> str:
    header = "".join(f"<th>{escape(str(cell))}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows)
    above = f"<caption>{escape(caption)}</caption>" if caption else ""
    return f"<table>{above}<thead><tr>{header}</tr></thead><tbody>{body}</tbody></table>"
