"""Locations and layouts, best first."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Location:
    """A candidate location in the ranking. Indices and their errors are in percent."""

    rank: int
    name: str
    input: str | None
    """The input that is its own: the depth of the station below it."""
    gsi_x_percent: float | None
    """Index of this location's own depth for the circumferential strain at the centre."""
    gsi_y_percent: float | None
    mean_gsi_x_percent: float | None
    """Mean over the strains at all locations."""
    mean_gsi_y_percent: float | None
    own_gsi_x_percent: float | None
    """For the strain at this location itself."""
    own_gsi_y_percent: float | None
    mdrm_gsi_x_percent: float | None
    """What M-DRM said, valid or not."""
    mdrm_gsi_y_percent: float | None
    rank_x: int | None
    rank_y: int | None
    rank_certain: bool
    """Whether the errors leave no doubt about the rank; never where another location is equal, as mirror images are."""
    gsi_x_error_percent: float | None
    """Error of `gsi_x_percent`, percentage points."""
    gsi_y_error_percent: float | None


@dataclass(frozen=True)
class LayoutScore:
    """How well a layout sees the contact, over all angles at which it can touch down."""

    weakest_signal: float | None
    """Strain of the film that sees most, at the contact angle where that is least."""
    worst_angle_error_deg: float | None
    rms_angle_error_deg: float | None
    worst_depth_error_mm: float | None
    noise_strain: float
    reason: str | None
    """Why numbers are None."""


@dataclass(frozen=True)
class Layout:
    """Units around the wheel, ranked."""

    rank: int
    spacing_deg: float
    units: int
    position: str
    """`crown`, `shoulder` or `sidewall`."""
    films: tuple[str, ...]
    score: LayoutScore
