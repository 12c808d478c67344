"""Studies side by side: which differences are real."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from strainsite.views import designs, frames, html

from . import rows
from ._generated import ComparisonFields
from .reading import whole

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from ._generated import ComparedIndex, ComparedStudy


@dataclass(frozen=True, kw_only=True, repr=False)
class Comparison(ComparisonFields):
    """Index and rank of each location of several studies, differences with their errors, and what each took."""

    raw: dict[str, Any] = field(default_factory=dict, compare=False)
    """The service's document, with what this client has no field for."""

    @classmethod
    def of(cls, document: dict[str, Any]) -> Comparison:
        """Reads a comparison as the service sends it."""
        return whole(cls, document)

    def frame(self) -> pd.DataFrame:
        """A row for each location of each study with a result; columns of a direction end with `_x` or `_y`."""
        return frames.frame(rows.compared(self))

    def studies_frame(self) -> pd.DataFrame:
        """A row for each study: what differs, its state, why it has no result, force, signal, best layout, cost."""
        return frames.frame(rows.compared_studies(self))

    def plot(self, figure: Figure | None = None) -> Figure:
        """Each location's index over the designs, with error bars, both directions."""
        labels = [self._label(study) for study in self.studies]
        return designs.lines(labels, {direction: self._indices(direction) for direction in ("x", "y")}, figure)

    def _label(self, study: ComparedStudy) -> str:
        """A study's name as it stands below its axis: each thing that it sets on a line."""
        text = study.name.replace(", ", "\n")
        if study.id == self.baseline:
            text += "\n(baseline)"
        return text if study.state == "done" else f"{text}\n({study.state})"

    def _indices(self, direction: str) -> dict[str, list[designs.DesignIndex]]:
        """The indices that there are, by location; all locations are named."""
        places = {study.id: k for k, study in enumerate(self.studies)}
        found: dict[str, list[designs.DesignIndex]] = {row.location: [] for row in self.rows}
        for row in self.rows:
            index = row.x if direction == "x" else row.y
            if row.study in places and index.gsi_percent is not None:
                within = index.verdict in ("noise", "unknown")
                point = designs.DesignIndex(places[row.study], index.gsi_percent, index.error_percent, within)
                found[row.location].append(point)
        return found

    def __repr__(self) -> str:
        """How many studies and locations."""
        locations = len({row.location for row in self.rows})
        return f"Comparison({len(self.studies)} studies, {locations} locations)"

    def _repr_html_(self) -> str:
        """A row for each location of each study with a result, and why the others have none."""
        names = {study.id: study.name for study in self.studies}
        head = ("study", "location", "rank", "x, %", "difference", "", "y, %", "difference", "")
        rows = [
            (names.get(row.study, row.study), row.location, row.rank, *_cells(row.x), *_cells(row.y))
            for row in self.rows
        ]
        without = [
            f"{study.name}: {study.state}{f', {study.reason}' if study.reason else ''}"
            for study in self.studies
            if study.state != "done"
        ]
        caption = "against " + names.get(self.baseline or "", "nothing")
        return html.table(head, rows, caption=caption) + html.bullets(without)


def _cells(index: ComparedIndex) -> tuple[str, str, str]:
    """An index, its difference from the baseline's, and the verdict."""
    shown = html.with_error(index.gsi_percent, index.error_percent)
    difference = html.difference(index.difference_percent, index.difference_error_percent)
    return shown, difference, index.verdict or ""
