"""The whole answer of a study."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from strainsite.errors import StrainsiteError
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
