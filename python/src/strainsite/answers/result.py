"""What a study found, as typed objects. Strains are plain numbers; names carry the units of all else."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from strainsite.errors import StrainsiteError
from strainsite.views import frames, html, plot

from .estimate import Estimate  # noqa: TC001 - fields are read by their types
from .maps import StrainMap
from .reading import read

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class StudyIdentity:
    """Which study, which document, which program."""

    id: str
    name: str
    spec_sha256: str
    """Hash of the canonical document."""
    version: str
    """Of the program and its solver."""


@dataclass(frozen=True)
class Choice:
    """One choice of the model with its reason."""

    what: str
    why: str
    effect: float | None
    """What leaving it out does to a strain at the locations, over the largest one; None where it isn't known."""


@dataclass(frozen=True)
class Model:
    """What was modelled, and what was left out."""

    dimension: str
    """`3d`, `3d-half` or `3d-quarter`."""
    level: str
    elements: int
    dofs: int
    modelled: tuple[Choice, ...]
    left_out: tuple[Choice, ...]


@dataclass(frozen=True)
class Input:
    """One thing that varied."""

    name: str
    vary: str
    """Path of the scene's field."""
    distribution: dict[str, Any]


@dataclass(frozen=True)
class ErrorParts:
    """Parts of the error of an index, absolute; None where a part isn't known."""

    mesh: float | None
    quadrature: float | None
    decomposition: float | None
    total: float | None
    reason: str | None
    """Why a part is None."""


@dataclass(frozen=True)
class CoarserIndices:
    """Indices of the same points on a coarser mesh, from which the mesh's error comes."""

    first_order: tuple[float, ...]
    factor: float
    """What the finer mesh may be off, over its difference from the coarser one."""


@dataclass(frozen=True)
class FormMisses:
    """What a form misses at the check points: the method's error, and how much of it two studies share."""

    nodes: tuple[int, ...]
    """Which node of its input's rule each coordinate of each check point is, point after point."""
    residuals: tuple[float, ...]
    """Strain minus the form's at each check point, over the standard deviation."""
    contributions: tuple[float, ...]
    """What each of them adds to the error of a first-order index, input after input."""
    weight: float
    fitted: int
    images: tuple[int, ...] = ()
    """Of each check point, which one is its mirror image; empty where contact or inputs aren't symmetric."""


@dataclass(frozen=True)
class Output:
    """The strain at one location in one direction, with the Sobol index of each input."""

    location: str
    direction: str
    """`x` circumferential, `y` meridional."""
    mean: float | None
    std: float | None
    first_order: tuple[float, ...] | None
    """In the order of the inputs."""
    total: tuple[float, ...] | None
    method: str
    status: str
    """`ok`, `constant` (no variance, no indices) or `product-form-broken` (another method took over)."""
    reason: str | None
    mdrm_first_order: tuple[float, ...] | None
    """What M-DRM said, where its product form is broken."""
    error: ErrorParts
    coarser: CoarserIndices | None
    """None where there is no coarser mesh."""
    misses: FormMisses | None
    """None without check points, or where the method has no form."""


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
    factorisations: int = 0


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


@dataclass(frozen=True, repr=False)
class Result:
    """The whole answer of a study; `raw` is the document itself, with what this client has no field for."""

    study: StudyIdentity
    model: Model
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]
    locations: tuple[Location, ...]
    """Best first."""
    layouts: tuple[Layout, ...]
    """Best first."""
    notes: tuple[str, ...]
    """What to know before believing the numbers."""
    failed_points: tuple[FailedPoint, ...]
    cut_point: CutPoint
    cost: Cost
    estimate: Estimate | None
    climb: dict[str, Any] | None
    """How the accuracy asked for was looked for; None where a level was asked for."""
    raw: dict[str, Any] = field(default_factory=dict, compare=False)

    @classmethod
    def of(cls, document: dict[str, Any]) -> Result:
        """Reads a result document, as from the service or from `strainsite run --json`."""
        result = read(cls, document)
        object.__setattr__(result, "raw", document)
        return result

    def output(self, location: str, direction: str) -> Output:
        """The strain at one location in one direction."""
        for output in self.outputs:
            if (output.location, output.direction) == (location, direction):
                return output
        known = ", ".join(dict.fromkeys(output.location for output in self.outputs))
        raise StrainsiteError(f"no output {location!r}, {direction!r}: locations are {known}, directions x and y")

    def map(self, direction: str = "x", input: str | None = None) -> StrainMap:
        """One layer of the map over the inner surface: direction `x` or `y`, and an input (the first when left out)."""
        return StrainMap.of_result(self.raw, direction, input)

    def locations_frame(self) -> pd.DataFrame:
        """The ranked locations as a pandas frame, columns as in the exported table."""
        return frames.locations(self)

    def indices_frame(self) -> pd.DataFrame:
        """The indices as a pandas frame: a row for each location, direction and input."""
        return frames.indices(self)

    def layouts_frame(self) -> pd.DataFrame:
        """The ranked layouts as a pandas frame, columns as in the exported table."""
        return frames.layouts(self)

    def plot_ranking(self, figure: Figure | None = None) -> Figure:
        """Indices of the ranked locations with their errors, both directions side by side."""
        return plot.ranking(self, figure)

    def plot_map(self, direction: str = "x", input: str | None = None, value: str = "first_order") -> Figure:
        """One layer of the map on the unrolled inner surface, with the locations marked.

        Args:
            direction: `x` circumferential, `y` meridional.
            input: Name of the input; the first one when left out.
            value: `first_order`, `std`, `strain` or `error`.

        """
        return plot.map_figure(self.map(direction, input), value, self.cut_point.locations)

    def __repr__(self) -> str:
        """The ranking on one line."""
        ranking = ", ".join(f"{location.rank} {location.name}" for location in self.locations)
        return f"Result({self.study.name!r}: {ranking})"

    def _repr_html_(self) -> str:
        return html.result(self)
