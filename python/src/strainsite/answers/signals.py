"""Films' signals over load, pressure and contact angle."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SignalError:
    """Errors of a film's reading by the mesh, absolute."""

    strain: float
    charge_nc: float
    open_circuit_v: float
    output_v: float


@dataclass(frozen=True)
class SignalRow:
    """What one film reads of one pressing. What isn't solved is None, and `reason` says why."""

    tire: str
    """The study's own is `own`."""
    film: str
    """`bare`, `transfer` or `coupled`."""
    position: str
    """`crown`, `shoulder` or `sidewall`."""
    direction: str
    """Of its length: `x` circumferential, `y` meridional."""
    over: str
    """Which curve it is a point of: `load`, `pressure` or `contact`."""
    load_n: float
    pressure_mpa: float
    contact_deg: float
    """Wheel angle from the film to the contact."""
    depth_mm: float | None
    strain: float | None
    """Mean along the film since inflation."""
    tension_1_n_per_mm: float | None
    """Mean along the film since inflation."""
    charge_nc: float | None
    open_circuit_v: float | None
    output_v: float | None
    """Amplitude at the amplifier."""
    output_std_v: float | None
    """Standard deviation of that by noise, gain and temperature."""
    state: str | None
    """`ok`, `beyond-yield` or `wrinkled`."""
    error: SignalError | None
    """None without a coarser mesh."""
    reason: str | None


@dataclass(frozen=True)
class SignalCurve:
    """The open circuit's voltage of one film over loads, pressures or contact angles."""

    tire: str
    film: str
    position: str
    direction: str
    over: str
    slope: float | None
    """V per N, per MPa or per degree, of the line of least squares."""
    monotone: str | None
    """`up`, `down` or `no`."""
    monotone_certain: bool
    """Whether every step is larger than the errors of its two ends together."""
    linear_r2: float | None


@dataclass(frozen=True)
class FilmPair:
    """The difference of two films at the crown, 30 degrees before and behind a point of the wheel."""

    tire: str
    film: str
    direction: str
    contact_deg: tuple[float, ...]
    """Wheel angles from that point to the contact."""
    values: tuple[float | None, ...]
    """V."""
    monotone: str | None
    linear_r2: float | None


@dataclass(frozen=True)
class StressWidth:
    """A Gaussian in the von Mises stress of the inner surface around the wheel at the crown."""

    tire: str
    load_n: float
    depth_mm: float | None
    amplitude_mpa: float | None
    width_deg: float | None
    """Standard deviation."""
    offset_mpa: float | None
    r2: float | None
    reason: str | None


@dataclass(frozen=True)
class Claim:
    """Whether a claim holds of one film."""

    tire: str
    film: str
    position: str
    direction: str
    claim: str
    """`voltage rises with load`, `voltage falls with pressure` or `linear over the contact angle`."""
    holds: str
    """`yes`, `no` or `uncertain`."""
    detail: str


@dataclass(frozen=True)
class Signals:
    """Films' signals over load, pressure and contact angle, and what they show."""

    rows: tuple[SignalRow, ...]
    curves: tuple[SignalCurve, ...]
    pairs: tuple[FilmPair, ...]
    widths: tuple[StressWidth, ...]
    claims: tuple[Claim, ...]
