"""What is compared: studies, and their locations with their indices."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .points import Cost  # noqa: TC001 - fields are read by their types


@dataclass(frozen=True)
class ComparedStudy:
    """One study of a comparison; without a result its figures are None."""

    id: str
    name: str
    """Its name, or that of the design."""
    set: dict[str, Any] | None
    """What the design sets, by path; None outside of a sweep."""
    state: str
    reason: str | None
    """Why it has no result."""
    spec_sha256: str | None
    version: str | None
    level: str | None
    """Mesh level."""
    reaction_n: float | None
    """Force with every input at its mean, N."""
    std_strain_x: float | None
    """Standard deviation of the circumferential strain at the centre: the signal of a film there."""
    std_strain_y: float | None
    best: str | None
    """First of the ranking."""
    best_certain: bool | None
    layout_spacing_deg: float | None
    """Angle between the units of the best layout."""
    layout_position: str | None
    cost: Cost | None
    """What it took."""


@dataclass(frozen=True)
class ComparedIndex:
    """A location's index in one direction, percent, and its difference from the baseline's, percentage points."""

    gsi_percent: float | None
    error_percent: float | None
    difference_percent: float | None
    difference_error_percent: float | None
    verdict: str | None
    """`real`, `noise`, or `unknown` where an error isn't known; None where there is nothing to compare."""


@dataclass(frozen=True)
class ComparedLocation:
    """One location of one study."""

    study: str
    """Identifier of the study."""
    location: str
    rank: int
    rank_certain: bool
    rank_change: int | None
    """Places lost since the baseline, negative when gained."""
    rank_verdict: str | None
    """Whether a change of the rank is `real`, `noise` or `unknown`; None without one."""
    x: ComparedIndex
    y: ComparedIndex
