"""Where studies and sweeps stand, and the documents to start from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

State = Literal["queued", "running", "done", "failed", "cancelled"]

Archived = Literal["true", "false", "all"]


@dataclass(frozen=True)
class StudySummary:
    """Where a study stands. Times are RFC 3339, UTC."""

    id: str
    name: str
    """Name in lists: the document's, unless `rename` changed it."""
    state: str
    """`queued`, `running`, `done`, `failed` or `cancelled`."""
    spec_sha256: str
    points_total: int | None
    """Points of its plan, as far as that is known."""
    points_done: int
    error: str | None
    """Why it failed, a sentence."""
    priority: int
    created: str
    started: str | None
    finished: str | None
    archived: str | None = None
    """When it was archived; None unless it is."""


@dataclass(frozen=True)
class Design:
    """One design of a sweep."""

    ordinal: int
    name: str
    """What tells it from the others, as `wall_mm = 2.5`."""
    set: dict[str, Any]
    """What differs from the study, by path."""
    study: StudySummary


@dataclass(frozen=True)
class DesignCounts:
    """Designs by where they stand."""

    queued: int
    running: int
    done: int
    failed: int
    cancelled: int


@dataclass(frozen=True)
class SweepSummary:
    """Where a sweep stands. Times are RFC 3339, UTC."""

    id: str
    name: str
    state: str
    """`queued`; `running` while some designs haven't ended; `cancelled` when any was; `done` when any has a result; or
    `failed`."""
    counts: DesignCounts
    points_total: int | None
    """Points of all designs, once all of their plans are known."""
    points_done: int
    priority: int
    created: str
    finished: str | None
    archived: str | None = None
    """When it was archived; None unless it is."""


@dataclass(frozen=True)
class Preset:
    """A document to start from."""

    name: str
    title: str
    document: dict[str, Any]
    comment: str
    """What it is for."""


@dataclass(frozen=True)
class Presets:
    """The documents that the service ships."""

    studies: tuple[Preset, ...]
    scenes: tuple[Preset, ...]
