"""The whole answer of a study: in a sentence, and in full."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from strainsite.errors import StrainsiteError
from strainsite.forces.known import ForceFindings  # noqa: TC001 - fields are read by their types
from strainsite.views import drawing, frames, html, ranking

from . import rows
from .estimate import Estimate  # noqa: TC001 - fields are read by their types
from .findings import LayoutFindings  # noqa: TC001 - fields are read by their types
from .indices import Output  # noqa: TC001 - fields are read by their types
from .maps import StrainMap
from .model import Input, Model, StudyIdentity  # noqa: TC001 - fields are read by their types
from .points import Cost, CutPoint, FailedPoint  # noqa: TC001 - fields are read by their types
from .ranked import Layout, Location  # noqa: TC001 - fields are read by their types
from .reading import read
from .signals import Signals  # noqa: TC001 - fields are read by their types

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class PlaceAnswer:
    """The location that ranks first."""

    names: tuple[str, ...]
    """All that share the first rank or, where the verdict is tied, can't be told from the first."""
    direction: str
    """Of the strain, of those asked for, whose index is larger there."""
    index: float
    """First-order index of the location's own depth for that strain at the contact centre, 0 to 1."""
    error: float | None
    """None where it isn't known."""
    verdict: str
    """`certain`, `likely`, `tied` or `unknown`."""
    reason: str
    """Why, with the figures that decide."""
    sentence: str
    """The place in a sentence."""


@dataclass(frozen=True)
class LayoutAnswer:
    """The layout that ranks first."""

    rank: int
    """In the list of layouts."""
    words: str
    """What it is, as in `12 units of x and y at the crown, every 30 degrees`."""
    units: int
    """Of a layout without units its films."""
    film_count: int
    angle_error_deg: float
    """95 of 100 simulated contacts are estimated better than this at the worst load."""
    error_deg: float | None
    """Claimed error of that; None without a coarser mesh."""
    tied_with: tuple[int, ...]
    """Ranks of layouts that the errors can't tell from it."""
    verdict: str
    """`certain`, `likely`, `tied` or `unknown`."""
    reason: str
    """Why, with the figures that decide."""


@dataclass(frozen=True)
class LeftOut:
    """What the model leaves out that changes strains most."""

    what: str
    why: str
    effect: float
    """Largest change of a strain at the locations over the largest strain of its direction."""
    sentence: str
    """What it would do."""


@dataclass(frozen=True)
class Surer:
    """What a surer answer costs."""

    sentence: str
    level: str
    """Mesh level to ask for."""
    times: float | None
    """Its work over that of this study; None of solvers without a law of solve times."""
    expected_s: float | None
    """Wall-clock time with what the database has."""


@dataclass(frozen=True)
class Answer:
    """Where the films go, how sure that is, and what could overturn it."""

    sentence: str
    """The best layout and what it knows, or the best place where no layouts are asked for."""
    verdict: str
    """The weaker of place and layout: `certain`, `likely`, `tied` or `unknown`."""
    reason: str
    """Why it isn't surer, or why it is certain, with the figures that decide."""
    place: PlaceAnswer | None
    """None where no location has an index."""
    layout: LayoutAnswer | None
    """None where none is asked for, or none has a score."""
    left_out: LeftOut | None
    """None where no effect is known, as on the draft level."""
    surer: Surer | None
    """None at the top of the ladder."""


@dataclass(frozen=True)
class GradedNote:
    """What to know before believing the numbers, with what it does to them."""

    grade: str
    """`changes-answer`, `bears-on-figure` or `for-the-record`."""
    about: str
    """`place`, `layout`, `map`, `indices`, `signals`, `model` or `cost`."""
    text: str


@dataclass(frozen=True)
class Preview:
    """A document's places on the draft mesh, solved at once and forgotten: figures without a claim."""

    claim: str
    """`none`."""
    level: str
    """`draft`."""
    wall_s: float
    solves: int
    left_out: tuple[str, ...]
    """What the study would have beside."""
    inputs: tuple[Input, ...]
    locations: tuple[Location, ...]
    """Best first."""
    cut_point: CutPoint
    map: dict[str, Any] | None
    """As in a result document; None where the document asks for none."""
    notes: tuple[str, ...]
    """What to know before believing the numbers."""


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
    signals: Signals | None
    """None where the study asks for none."""
    layout_findings: LayoutFindings | None
    """What the layouts show together; None where the study asks for none, and of earlier versions."""
    answer: Answer | None
    """The answer in a sentence, and how sure it is; None where nothing has a rank, and of earlier versions."""
    forces: ForceFindings | None = None
    """What a virtual rig shows; None where the study has none, and of earlier versions."""
    graded_notes: tuple[GradedNote, ...] = ()
    """The notes with what each does to the answer; empty of earlier versions."""
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
        return self._frame([rows.record(location) for location in self.locations])

    def indices_frame(self) -> pd.DataFrame:
        """The indices as a pandas frame: a row for each location, direction and input."""
        return self._frame(rows.indices(self.outputs, self.inputs))

    def layouts_frame(self) -> pd.DataFrame:
        """The ranked layouts as a pandas frame, columns as in the exported table."""
        return self._frame(rows.layouts(self.layouts))

    def candidates_frame(self) -> pd.DataFrame:
        """The kinds of film for layouts as a pandas frame, columns as in the exported table; empty without any."""
        found = self.layout_findings
        return self._frame([rows.record(candidate) for candidate in (found.candidates if found else ())])

    def signals_frame(self) -> pd.DataFrame:
        """What films read as a pandas frame, columns as in the exported table; empty where the study asks for none."""
        return self._frame(rows.signals(self.signals.rows if self.signals else ()))

    def _frame(self, table: Sequence[rows.Row]) -> pd.DataFrame:
        return frames.frame(table, origin=rows.record(self.study))

    def plot_ranking(self, figure: Figure | None = None) -> Figure:
        """Indices of the ranked locations with their errors, both directions side by side."""
        bars = [
            ranking.RankedLocation(
                location.name,
                location.rank_certain,
                x=ranking.Index(location.gsi_x_percent, location.gsi_x_error_percent),
                y=ranking.Index(location.gsi_y_percent, location.gsi_y_error_percent),
            )
            for location in self.locations
        ]
        return ranking.bars(bars, figure)

    def plot_map(self, direction: str = "x", input: str | None = None, value: str = "first_order") -> Figure:
        """One layer of the map on the unrolled inner surface, with the locations marked.

        Args:
            direction: `x` circumferential, `y` meridional.
            input: Name of the input; the first one when left out.
            value: `first_order`, `std`, `strain` or `error`.

        """
        layer = self.map(direction, input)
        figure = drawing.empty_figure(7.5, 3.6)
        layer.plot(value, locations=self.cut_point.locations, ax=figure.subplots())
        return figure

    def __repr__(self) -> str:
        """The ranking on one line."""
        ranked = ", ".join(f"{location.rank} {location.name}" for location in self.locations)
        return f"Result({self.study.name!r}: {ranked})"

    def _repr_html_(self) -> str:
        """The ranking with its errors, and what to know before believing it."""
        ranked = [
            (
                location.rank,
                location.name,
                html.with_error(location.gsi_x_percent, location.gsi_x_error_percent),
                html.with_error(location.gsi_y_percent, location.gsi_y_error_percent),
                "certain" if location.rank_certain else "not certain",
            )
            for location in self.locations
        ]
        head = ("rank", "location", "index x, %", "index y, %", "rank is")
        caption = f"{self.study.name}: {self.cost.solves} solves, {self.cost.wall_s:.2f} s"
        return html.table(head, ranked, caption=caption) + html.bullets(self.notes)
