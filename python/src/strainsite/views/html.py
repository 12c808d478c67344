"""Tables, lists and paragraphs of HTML, as notebooks show them. All text is escaped here."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence


def table(head: Sequence[object], rows: Iterable[Sequence[object]], *, caption: str = "") -> str:
    """A table; its cells are shown as `str` has them."""
    header = "".join(f"<th>{escape(str(cell))}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows)
    above = f"<caption>{escape(caption)}</caption>" if caption else ""
    return f"<table>{above}<thead><tr>{header}</tr></thead><tbody>{body}</tbody></table>"


def bullets(texts: Iterable[str]) -> str:
    """A list; nothing without a text."""
    entries = "".join(f"<li>{escape(text)}</li>" for text in texts)
    return f"<ul>{entries}</ul>" if entries else ""


def paragraph(text: str | None) -> str:
    """A paragraph; nothing without a text."""
    return f"<p>{escape(text)}</p>" if text else ""


def with_error(value: float | None, error: float | None) -> str:
    """As in 72.86 ±2.94; or `none`."""
    if value is None:
        return "none"
    return f"{value:.2f}" if error is None else f"{value:.2f} ±{error:.2f}"


def difference(value: float | None, error: float | None) -> str:
    """As in +1.20 ±0.30; nothing where there is none."""
    if value is None:
        return ""
    return f"{value:+.2f}" if error is None else f"{value:+.2f} ±{error:.2f}"
