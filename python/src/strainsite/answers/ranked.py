"""Locations and layouts, best first."""

from __future__ import annotations

from dataclasses import dataclass

from strainsite.forces.known import ForceError  # noqa: TC001 - fields are read by their types


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
class FilmPlace:
    """A film of a layout."""

    theta_deg: float
    """Wheel angle."""
    phi_deg: float
    """Section angle from the crown."""
    angle_deg: float
    """Angle of its length to the circumferential direction: 0 is x, 90 is y."""


@dataclass(frozen=True)
class AlikeContacts:
    """Two contacts that readings can hardly tell apart."""

    angle_deg: float
    """Of the first; its depth is that of the load."""
    other_angle_deg: float
    other_depth_mm: float
    sigmas: float
    """Distance of their readings in standard deviations of the noise."""


@dataclass(frozen=True)
class DeadFilm:
    """What is left when the film dies whose loss costs most."""

    film: int
    """Counted from 0."""
    simulated_p95_angle_error_deg: float | None
    bayes_angle_error_deg: float | None


@dataclass(frozen=True)
class LayoutError:
    """What the mesh and the number of simulated contacts leave open, each in the unit of its score."""

    worst_angle_error_deg: float | None
    rms_angle_error_deg: float | None
    worst_depth_error_mm: float | None
    simulated_rms_angle_error_deg: float | None
    simulated_p95_angle_error_deg: float | None


@dataclass(frozen=True)
class ShearError:
    """Claimed errors of bounds with four unknowns, by the coarser mesh."""

    worst_angle_error_deg: float | None
    worst_force_error_n: tuple[float | None, float | None, float | None] | None


@dataclass(frozen=True)
class ShearScore:
    """Cramer-Rao bounds with four unknowns: contact angle, depth, and the ground's shifts along and across."""

    worst_angle_error_deg: float | None
    """At the worst angle."""
    worst_force_error_n: tuple[float | None, float | None, float | None] | None
    """Of the ground's forces along the wheel, across it (None where no film feels it) and up, at the worst angle."""
    error: ShearError | None
    """None without a coarser mesh."""
    reason: str | None
    """What can't be told."""


@dataclass(frozen=True)
class LayoutScore:
    """How well a layout sees the contact, over all angles at which it can touch down."""

    weakest_signal: float | None
    """Strain of the film that sees most, at the contact angle where that is least."""
    worst_angle_error_deg: float | None
    """Cramer-Rao bound, at the worst angle."""
    rms_angle_error_deg: float | None
    """Cramer-Rao bound, root mean square over the angles."""
    worst_depth_error_mm: float | None
    """Cramer-Rao bound of a uniform depth, at the worst angle."""
    bayes_angle_error_deg: float | None
    """Bound with a flat prior, root mean square over the angles: finite where the others aren't."""
    simulated_rms_angle_error_deg: float | None
    """Of the angle as estimated from noisy readings."""
    simulated_rms_angle_error_deg_se: float | None
    """Standard error by the number of simulated contacts."""
    simulated_p95_angle_error_deg: float | None
    """95 % of simulated contacts are estimated better than this."""
    simulated_p95_angle_error_deg_se: float | None
    lost_share: float | None
    """Share of simulated contacts that are off by more than 20 degrees."""
    simulated_rms_depth_error_mm: float | None
    force_error_n: float | None
    """The same as a vertical force: by the slope of force over depth."""
    alike: AlikeContacts | None
    """The two contacts, more than 20 degrees apart, that look most alike."""
    dead: DeadFilm | None
    """Where the study asks for it."""
    shear: ShearScore | None
    """With forces along and across the wheel unknown, too, where the study asks for it."""
    noise_strain: float
    """Of each film, in the unit of the signal: strain, or volts of glued films."""
    error: LayoutError | None
    """None without a coarser mesh."""
    reason: str | None
    """Why numbers are None."""


@dataclass(frozen=True)
class LoadScore:
    """A layout's scores at one load."""

    depth_mm: float | None
    """How far the ground stands above the inflated outer radius."""
    load_n: float | None
    """Vertical force."""
    score: LayoutScore


@dataclass(frozen=True)
class Layout:
    """Films around the wheel, ranked. What results of earlier versions lack is None or empty."""

    rank: int
    rank_certain: bool | None
    """Whether the errors leave no doubt about the rank."""
    name: str | None
    """Of a layout that was listed film by film, or found by the search."""
    spacing_deg: float | None
    """None of a layout without units."""
    units: int
    """Of a layout without units its number of films."""
    position: str
    """`crown`, `shoulder`, `sidewall`, an angle as `30 deg`, or `mixed`."""
    films: tuple[str, ...]
    """Directions of the films of each unit: `x`, `y`, or an angle as `45`."""
    film_count: int | None
    """All films of the wheel."""
    doubt: str | None
    """Which figures may be off by more than a fifth."""
    score: LayoutScore
    """At the load where its error is largest."""
    staggered: bool = False
    """Whether the films of a unit are spread evenly between two units."""
    places: tuple[FilmPlace, ...] = ()
    """The films of a layout without units."""
    loads: tuple[LoadScore, ...] = ()
    """At every load."""
    force_error: tuple[ForceError, ...] | None = None
    """How well its films tell the forces; None where the study has no rig."""
