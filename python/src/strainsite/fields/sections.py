"""The map along the line of an input, and signals around the wheel."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SectionNode:
    """The map at one solved value of the input; lists are rows x columns."""

    value: float
    ordinal: int
    """Place among the study's points."""
    cut_point: bool
    """Whether the input is at its mean, too."""
    reaction_n: float
    strain_x: tuple[float, ...]
    """Circumferential."""
    strain_y: tuple[float, ...]
    """Meridional."""
    displacement_mm: tuple[tuple[float, ...], ...] | None
    """From the sections' `inflated_mm` to the node's equilibrium; None of studies of earlier versions."""


@dataclass(frozen=True)
class FailedNode:
    """A value of the input without an equilibrium."""

    value: float
    reason: str


@dataclass(frozen=True)
class Sections:
    """Strains and displacements over the map at the solved nodes of one input, all others at their means."""

    input: str
    vary: str
    theta_deg: tuple[float, ...]
    """Angles of the columns."""
    phi_deg: tuple[float, ...]
    """Angles of the rows."""
    inflated_mm: tuple[tuple[float, ...], ...] | None
    """Where the points lie in the inflated state at the means; None of studies of earlier versions."""
    nodes: tuple[SectionNode, ...]
    """By value; a design of scattered points has the means alone."""
    failed: tuple[FailedNode, ...]


@dataclass(frozen=True)
class RingLoad:
    """A load of layouts."""

    depth_mm: float
    load_n: float | None


@dataclass(frozen=True)
class WheelRing:
    """Both directions around the wheel at one section angle; None where no layout has such a film."""

    section_deg: float
    load: RingLoad | None
    theta_deg: tuple[float, ...]
    strain_x: tuple[float, ...] | None
    strain_y: tuple[float, ...] | None
    slope_x_per_mm: tuple[float, ...] | None
    """Derivative by the depth."""
    slope_y_per_mm: tuple[float, ...] | None
    """Derivative by the depth."""


@dataclass(frozen=True)
class Rings:
    """What layouts' films read around the whole wheel."""

    unit: str
    """`strain`, or `V` of glued films."""
    rings: tuple[WheelRing, ...]
