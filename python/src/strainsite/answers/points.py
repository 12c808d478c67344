"""What was solved, and what that took."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class LocationStrain:
    """The strain at a location at one point of a study."""

    name: str
    theta_deg: float
    strain_x: float
    strain_y: float
    von_mises_mpa: float


@dataclass(frozen=True)
class FailedPoint:
    """A point without an equilibrium; the indices come from the others."""

    ordinal: int
    values: tuple[float, ...]
    cause: str


@dataclass(frozen=True)
class CutPoint:
    """The response with every input at its mean."""

    values: tuple[float, ...]
    reaction_n: float
    inflated_outer_radius_mm: float
    locations: tuple[LocationStrain, ...]
    depth_mm: float | None = None
    """Of the ground at the contact centre, above the inflated outer radius."""


@dataclass(frozen=True)
class Evaluation:
    """One solved point of a study. What doesn't exist without an equilibrium is None, and `reason` says why."""

    ordinal: int
    key: str
    """Hash of all that determines its outcome."""
    level: str | None
    values: tuple[float, ...] | None
    """The inputs, in their order."""
    reaction_n: float | None
    locations: tuple[LocationStrain, ...] | None
    newton_iterations: int | None
    wall_s: float
    reason: str | None
    depth_mm: float | None = None
    """Of the ground at the contact centre, above the inflated outer radius."""


@dataclass(frozen=True)
class Cost:
    """What a study took."""

    solves: int
    reused: int
    """Points that were known before."""
    newton_iterations: int
    wall_s: float
    cpu_s: float
    peak_memory_bytes: int
    coarser_solves: int = 0
    effect_solves: int = 0
    signal_solves: int = 0
    """Of films' signals, on both meshes."""
    layout_solves: int = 0
    """Of layouts' loads, on both meshes."""
    table_solves: int = 0
    """Of a rig's table of responses."""
    factorisations: int = 0
