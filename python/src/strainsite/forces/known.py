"""How well forces are known by layouts' films, learnt from a virtual rig's runs."""

from __future__ import annotations

from dataclasses import dataclass

from .published import PublishedTables  # noqa: TC001 - fields are read by their types
from .trial import TrialError  # noqa: TC001


@dataclass(frozen=True)
class SplitError:
    """The chosen model on rows that were left out by one split."""

    by: str
    """`random` rows, later `time`, whole `run`s or `cycle`s."""
    rmse_n: float | None
    rmse_interval_n: tuple[float, float] | None
    """95 % of the bootstrap's samples of whole cycles."""
    nrmse_percent: float | None
    """Over the range of the tested forces."""
    mean_nrmse_percent: float | None
    """That of the training mean."""
    r2: float | None
    coverage: float | None
    """Share of tested rows within their 95 % intervals."""
    width_n: float | None
    """Mean width of these intervals."""
    reason: str | None = None
    """Why numbers are None."""


@dataclass(frozen=True)
class DeadFilmError:
    """With a film dead."""

    film: int
    """Counted from 0."""
    error: TrialError


@dataclass(frozen=True)
class AskewError:
    """With films that lie elsewhere than those that were learnt from."""

    std_deg: float
    """Standard deviation of their places around the wheel."""
    error: TrialError


@dataclass(frozen=True)
class ElsewhereError:
    """On another tire."""

    tire: str
    """In what it differs from the study's."""
    error: TrialError
    learnt: bool = False
    """Whether estimators learnt from runs on it, too."""


@dataclass(frozen=True)
class WorstContact:
    """Where on the wheel contacts are known worst."""

    deg: float
    rmse_n: float


@dataclass(frozen=True)
class ForceError:
    """How well a layout's films tell one force."""

    axis: str
    """`fx` along the wheel, `fy` across it, `fz` vertical."""
    chosen: str
    """The model; `mean` where none is better than the training mean."""
    features: str
    useful: bool
    """Whether its error on left-out runs is at most 95 % of the training mean's."""
    splits: tuple[SplitError, ...]
    leak: float | None
    """How far a random split would have misled."""
    fresh: TrialError
    """On runs that nobody learnt from: films have other gains there."""
    dead: DeadFilmError | None
    """Without the film whose loss costs most."""
    askew: AskewError
    worst_contact: WorstContact | None
    reason: str | None = None
    """Why numbers are None."""
    elsewhere: tuple[ElsewhereError, ...] = ()
    """The same films on other tires."""
    floor_n: float | None = None
    """About the least error that one instant's readings allow: the bound of Cramer and Rao, with the gait as prior."""


@dataclass(frozen=True)
class TableError:
    """Errors of a table of responses, relative to the largest signal or slope of a kind of film."""

    solves: int
    """That it was tested by."""
    signal_rms: float
    signal_worst: float
    angle_slope_rms: float
    angle_slope_worst: float
    depth_slope_rms: float
    depth_slope_worst: float
    force_worst: float
    """Over the largest load."""


@dataclass(frozen=True)
class FilmAnglesReport:
    """Glued films solved with the tire around the wheel; errors are over the largest signal of their kind."""

    level: str
    """Mesh level of the tire with a film."""
    angles_deg: tuple[float, ...]
    """From the contact; films that lie askew on both sides of it."""
    loads_n: tuple[float, ...]
    tested: int
    """Solves between them that tested the table."""
    signal_rms: float | None
    """None where nothing was tested."""
    signal_worst: float | None
    transfer_worst: float
    """The largest error that a transfer without this axis would have."""


@dataclass(frozen=True)
class TableReport:
    """A table of a tire's responses to any contact."""

    level: str
    largest_load_n: float
    largest_shift_mm: float
    """Of the ground at that load, along the wheel and across."""
    solves: int
    error: TableError | None
    """None where a load that tests it has no equilibrium."""
    films: FilmAnglesReport | None = None
    """Of glued films, whose wheel angle is an axis; None for films that resist nothing."""


@dataclass(frozen=True)
class ForcePrice:
    """A layout that knows a force better than all that have as many films or fewer."""

    axis: str
    films: int
    rmse_n: float
    """On runs that nobody learnt from."""
    layout_rank: int


@dataclass(frozen=True)
class ForceFindings:
    """What a virtual rig shows."""

    table: TableReport | None = None
    assumed: tuple[str, ...] = ()
    """What is assumed of the rig, whole sentences."""
    reasons: tuple[str, ...] = ()
    """Why something is missing, whole sentences."""
    price: tuple[ForcePrice, ...] = ()
    """What a force's error costs in films, the cheapest layout of each force first."""
    published: PublishedTables | None = None
    """The published study's tables beside the rig's; None where the study doesn't ask for them."""
