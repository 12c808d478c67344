"""The published study's tables of force errors beside a virtual rig's."""

from __future__ import annotations

from dataclasses import dataclass

from .trial import TrialError  # noqa: TC001 - fields are read by their types


@dataclass(frozen=True)
class Contradiction:
    """A printed figure that can't be true beside the others."""

    figure: str
    """`r2`, `nrmse_percent`, or `both` where two cells contradict each other."""
    implied: float | None
    """What the other cells and this one's RMSE imply; None where none tells."""
    detail: str


@dataclass(frozen=True)
class PrintedFigures:
    """Figures as the published study prints them."""

    nrmse_percent: float
    rmse_n: float | None
    r2: float | None
    mean_nrmse_percent: float | None
    """What the mean of the tested forces would have reached, by what the three figures imply."""
    contradiction: Contradiction | None = None


@dataclass(frozen=True)
class RigFigures:
    """Figures of a virtual rig."""

    rmse_n: float
    nrmse_percent: float | None
    mean_nrmse_percent: float | None
    """What the mean of the learnt forces would have reached."""
    r2: float | None


@dataclass(frozen=True)
class PublishedRow:
    """One figure of the published study beside the rig's."""

    table: int
    """Number of the published table."""
    gait: str
    model: str
    features: str
    axis: str
    """`fx` along the wheel, `fy` across it, `fz` vertical."""
    by: str
    """What the rig's model is tested by: `random` readings, later `time`, or another `run`."""
    printed: PrintedFigures
    rig: RigFigures | None
    fresh: RigFigures | None
    """The rig's model on a run with other gains; None where that is what `rig` has."""
    reason: str | None = None
    """Why numbers are None."""


@dataclass(frozen=True)
class TimeConstantRow:
    """A layout's force on runs with other gains, with another time constant."""

    time_constant_s: float
    axis: str
    chosen: str
    """The model."""
    error: TrialError


@dataclass(frozen=True)
class PublishedTables:
    """Tables 4, 5, 6, 8 and 9 of the published study and the rig's figures for the same rows, by one layout."""

    layout_rank: int
    rows: tuple[PublishedRow, ...]
    time_constants: tuple[TimeConstantRow, ...]
    """Not in the published study, which states none."""
    assumed: tuple[str, ...]
    """What was done where the published study doesn't say what it did, whole sentences."""
