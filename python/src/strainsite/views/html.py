"""Objects as notebooks show them."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from strainsite.answers.comparison import Comparison
    from strainsite.answers.result import Result
    from strainsite.answers.summary import StudySummary
    from strainsite.sweep import Sweep


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


def sweep(sweep: Sweep) -> str:
    """The designs of a sweep and where they stand."""
    rows = [(design.ordinal, design.name, design.study.state, design.study.error or "") for design in sweep.designs]
    return _table(f"{sweep.name}: {sweep.summary.state}", ("", "design", "state", ""), rows)


def comparison(comparison: Comparison) -> str:
    """A row for each location of each study with a result, and why the others have none."""
    names = {study.id: study.name for study in comparison.studies}
    rows = []
    for row in comparison.rows:
        cells: list[Any] = [
            names.get(row.study, row.study),
            row.location,
            row.rank if row.rank is not None else "",
        ]
        for index in (row.x, row.y):
            cells.append(with_error(index.gsi_percent, index.error_percent) if index else "")
            cells.append(_difference(index.difference_percent, index.difference_error_percent) if index else "")
            cells.append(index.verdict or "" if index else "")
        rows.append(cells)
    head = ("study", "location", "rank", "x, %", "difference", "", "y, %", "difference", "")
    failed = "".join(
        f"<li>{escape(study.name)}: {escape(study.state)}{escape(f', {study.reason}' if study.reason else '')}</li>"
        for study in comparison.studies
        if study.state != "done"
    )
    return _table("against " + names.get(comparison.baseline or "", "nothing"), head, rows) + (
        f"<ul>{failed}</ul>" if failed else ""
    )


def with_error(value: float | None, error: float | None) -> str:
    """As in 72.86 ±2.94; or `none`."""
    if value is None:
        return "none"
    return f"{value:.2f}" if error is None else f"{value:.2f} ±{error:.2f}"


def _difference(value: float | None, error: float | None) -> str:
    return "" if value is None else f"{value:+.2f}" if error is None else f"{value:+.2f} ±{error:.2f}"


def _table(caption: str, head: Sequence[object], rows: Iterable[Sequence[object]]) -> str:
    header = "".join(f"<th>{escape(str(cell))}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows)
    above = f"<caption>{escape(caption)}</caption>" if caption else ""
    return f"<table>{above}<thead><tr>{header}</tr></thead><tbody>{body}</tbody></table>"
