"""What a study's layouts show together."""

from __future__ import annotations

from dataclasses import dataclass

from .ranked import FilmPlace  # noqa: TC001 - fields are read by their types


@dataclass(frozen=True)
class Knee:
    """From how many units on more of them bring no more than their number.

    The worst bound of the angle times the root of the number of units stays within twice that of a dense ring.
    """

    section_deg: float
    """From the crown."""
    films: tuple[str, ...]
    """Directions of the films of each unit."""
    units: int | None
    """None where even the most that were tried aren't enough."""
    dense_deg: float
    """Worst bound times the root of the number of units of a dense ring."""
    of_60_deg: float | None
    """The same of units every 60 degrees, over that of a dense ring; None where they are blind."""


@dataclass(frozen=True)
class LoadShear:
    """What dragging the ground a little shows at a load."""

    slopes_n_per_mm: tuple[float, float]
    """Forces along the wheel and across it by the shifts that way."""
    sliding_n: float
    """Force from which the ground slides."""


@dataclass(frozen=True)
class LayoutLoad:
    """A load at which layouts are scored."""

    depth_mm: float | None
    """How far the ground stands above the inflated outer radius."""
    load_n: float | None
    """Vertical force."""
    force_slope_n_per_mm: float | None
    shear: LoadShear | None
    """Where forces along and across the wheel are unknown, too."""
    knees: tuple[Knee, ...]
    reason: str | None
    """Why there are no scores."""


@dataclass(frozen=True)
class FrontLayout:
    """A layout that no other beats with as few films."""

    film_count: int
    simulated_p95_angle_error_deg: float
    """At its worst load."""
    index: int
    """Where it stands in the list of layouts, from 0."""


@dataclass(frozen=True)
class LayoutSearch:
    """What a search looked at."""

    films: int
    """Of each layout."""
    places: int
    """That a film may have."""
    method: str
    """`exhaustive`, or `greedy and exchange`."""
    criterion: str
    """What it went by: `bound`, or `interval errors`, which count contacts that are mistaken for others, too."""
    looked_at: int
    """Layouts whose criterion was computed."""
    bayes_angle_error_deg: float
    """Bound of the best one with a flat prior, root mean square over angles and loads."""
    best: tuple[FilmPlace, ...]
    """Its films."""


@dataclass(frozen=True)
class Candidate:
    """A kind of film: where in the section, along which direction, how large."""

    section_deg: float
    """From the crown."""
    direction: str
    """Of its length."""
    length_mm: float | None
    """None of a point."""
    width_mm: float | None
    """None of a point."""
    signal: float
    """The largest around the wheel, over all loads."""
    angle_information: float
    """Root of the mean information on the contact angle over the turn and the loads, 1/degree."""
    angle_information_error: float | None
    """By the coarser mesh."""
    depth_information: float
    """Root of the mean information on the depth, 1/mm."""
    effective_independence: float
    """Its share in what all candidates together tell apart, 0 to 1."""
    pivot_rank: int | None
    """Its place among those that pivoting picks; None of those that add nothing."""
    centre_std: float
    """Standard deviation of the signal at the contact's centre over the study's depths: the paper ranks by this."""


@dataclass(frozen=True)
class OrderAgreement:
    """How far two criteria order the candidates alike."""

    first: str
    second: str
    tau: float | None
    """Kendall's tau-b: 1 the same order, -1 the reverse."""


@dataclass(frozen=True)
class StrainRing:
    """Signals around the wheel at one load, of one kind of film: strains, or volts of glued films."""

    section_deg: float
    direction: str
    depth_mm: float
    strain: tuple[float, ...]
    """From -180 to 179 degrees from the contact."""
    by_depth: tuple[float, ...]
    """Derivative by the depth, 1/mm."""
    strain_error: float | None
    """The largest, by the coarser mesh."""
    by_depth_error: float | None


@dataclass(frozen=True)
class LayoutFindings:
    """What a study's layouts show together: loads, knees, fronts, second opinions."""

    level: str
    """Of the mesh, which is fine to 60 degrees from the contact."""
    coarser_level: str | None
    """Of the mesh that shows the errors."""
    loads: tuple[LayoutLoad, ...]
    front: tuple[FrontLayout, ...]
    """Layouts that no other beats with as few films, least films first."""
    tau_of_bound: float | None
    """Kendall's tau between the order by simulated errors and that by the bound."""
    candidates: tuple[Candidate, ...]
    agreement: tuple[OrderAgreement, ...]
    """Of each two criteria of the candidates."""
    rings: tuple[StrainRing, ...]
    unit: str = "strain"
    """Of films' signals: `strain`, or `V` of glued films."""
    size_mm: tuple[float, ...] | None = None
    """Length and width of the layouts' films; None of points."""
    searches: tuple[LayoutSearch, ...] = ()
    reasons: tuple[str, ...] = ()
    """Why something is missing."""


@dataclass(frozen=True)
class Candidates:
    """Kinds of film by several criteria, and how far these order them alike."""

    candidates: tuple[Candidate, ...]
    agreement: tuple[OrderAgreement, ...]
