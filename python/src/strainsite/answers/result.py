"""The whole answer of a study."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from strainsite.errors import StrainsiteError
from strainsite.views import drawing, frames, html, ranking

from . import rows
from ._generated import ResultFields
from .maps import StrainMap
from .reading import whole

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd
    from matplotlib.figure import Figure

    from ._generated import Output


@dataclass(frozen=True, kw_only=True, repr=False)
class Result(ResultFields):
    """The whole answer of a study; `raw` is the document itself, with what this client has no field for."""

    raw: dict[str, Any] = field(default_factory=dict, compare=False)

    @classmethod
    def of(cls, document: dict[str, Any]) -> Result:
        """Reads a result document, as from the service or from `strainsite run --json`."""
        return whole(cls, document)

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
        return self._frame(rows.table("locations", ({"location": location} for location in self.locations)))

    def indices_frame(self) -> pd.DataFrame:
        """The indices as a pandas frame: a row for each location, direction and input."""
        return self._frame(rows.indices(self.outputs, self.inputs))

    def layouts_frame(self) -> pd.DataFrame:
        """The ranked layouts as a pandas frame, columns as in the exported table."""
        return self._frame(rows.table("layouts", ({"layout": layout, "unit": self._unit} for layout in self.layouts)))

    def forces_frame(self) -> pd.DataFrame:
        """How well each layout tells each force, columns as in the exported table; empty where the study has no rig."""
        return self._frame(rows.forces(self.layouts))

    def candidates_frame(self) -> pd.DataFrame:
        """The kinds of film for layouts as a pandas frame, columns as in the exported table; empty without any."""
        films = self.layout_findings.candidates if self.layout_findings else ()
        return self._frame(rows.table("candidates", ({"film": film, "unit": self._unit} for film in films)))

    def signals_frame(self) -> pd.DataFrame:
        """What films read as a pandas frame, columns as in the exported table; empty where the study asks for none."""
        readings = self.signals.rows if self.signals else ()
        return self._frame(rows.table("signals", ({"row": reading} for reading in readings)))

    @property
    def _unit(self) -> str | None:
        """The unit of the films' signals."""
        return self.layout_findings.unit if self.layout_findings else None

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
