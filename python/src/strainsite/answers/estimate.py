"""What studies and sweeps are expected to cost, and to be worth."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Forecast:
    """A figure with its range."""

    least: float
    expected: float
    most: float


@dataclass(frozen=True)
class CountForecast:
    """A number of solves with its range."""

    least: int
    expected: int
    most: int


@dataclass(frozen=True)
class SolveForecast:
    """Equilibria that are expected to be solved."""

    own: int
    """Points of the plan."""
    coarser: int
    """The same on a coarser mesh, for the error of the mesh."""
    effects: int
    """Solves that show what the model leaves out."""
    signals: int
    """Solves of films' signals, on both meshes."""
    known: int
    """How many of these the database has already."""
    left: CountForecast
    layouts: int = 0
    """Solves of layouts' loads, on both meshes."""
    tables: int = 0
    """Solves of a rig's table of responses."""


@dataclass(frozen=True)
class ExpectedAccuracy:
    """Largest error of an index where studies of this kind were measured, absolute."""

    fidelity: str
    """Mesh and method in a few words."""
    error_true: float | None
    error_claimed: float | None
    reason: str | None
    """Why there are no figures."""


@dataclass(frozen=True)
class Estimate:
    """What a study is expected to cost, and to be worth."""

    solves: SolveForecast
    wall_s: Forecast | None
    """None where `reasons` says why."""
    peak_memory_bytes: int
    accuracy: ExpectedAccuracy
    threads: int
    measured_solves: int
    """Solves by which the times were corrected for the service's machine; 0: they are another machine's."""
    reasons: tuple[str, ...]
    """Why figures are ranges or None."""


@dataclass(frozen=True)
class DesignEstimate:
    """What a design would cost; what an earlier one solves is known to it."""

    name: str
    estimate: Estimate


@dataclass(frozen=True)
class SweepEstimate:
    """What a sweep would cost."""

    designs: tuple[DesignEstimate, ...]
    left: CountForecast
    """Solves of all designs that are left to do."""
    wall_s: Forecast | None
    """None where a design's reasons say why."""
    peak_memory_bytes: int
