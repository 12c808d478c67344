"""Studies side by side: which differences are real."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from strainsite.views import frames, html, plot

from .reading import read
from .result import Cost  # noqa: TC001 - fields are read by their types

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


ComparisonTable = Literal["locations", "designs"]

_COSTS = ("solves", "coarser_solves", "effect_solves", "reused", "wall_s", "cpu_s")


@dataclass(frozen=True)
class ComparedStudy:
    """One study of a comparison; without a result its figures are None."""

    id: str
    name: str
    """Its name, or that of the design."""
    set: dict[str, Any] | None
    """What the design sets, by path; None outside of a sweep."""
    state: str
    reason: str | None
    """Why it has no result."""
    spec_sha256: str | None
    version: str | None
    level: str | None
    """Mesh level."""
    reaction_n: float | None
    """Force with every input at its mean, N."""
    std_strain_x: float | None
    """Standard deviation of the circumferential strain at the centre: the signal of a film there."""
    std_strain_y: float | None
    best: str | None
    """First of the ranking."""
    best_certain: bool | None
    layout_spacing_deg: float | None
    """Angle between the units of the best layout."""
    layout_position: str | None
    cost: Cost | None
    """What it took."""


@dataclass(frozen=True)
class ComparedIndex:
    """A location's index in one direction, percent, and its difference from the baseline's, percentage points."""

    gsi_percent: float | None
    error_percent: float | None
    difference_percent: float | None
    difference_error_percent: float | None
    verdict: str | None
    """`real`, `noise`, or `unknown` where an error isn't known; None where there is nothing to compare."""


@dataclass(frozen=True)
class ComparedLocation:
    """One location of one study."""

    study: str
    """Identifier of the study."""
    location: str
    rank: int
    rank_certain: bool
    rank_change: int | None
    """Places lost since the baseline, negative when gained."""
    rank_verdict: str | None
    """Whether a change of the rank is `real`, `noise` or `unknown`; None without one."""
    x: ComparedIndex
    y: ComparedIndex


@dataclass(frozen=True, repr=False)
class Comparison:
    """Index and rank of each location of several studies, differences with their errors, and what each took."""

    baseline: str | None
    """Identifier of the study that the others are compared with."""
    studies: tuple[ComparedStudy, ...]
    rows: tuple[ComparedLocation, ...]
    notes: tuple[str, ...] = ()
    raw: dict[str, Any] = field(default_factory=dict, compare=False)
    """The service's document, with what this client has no field for."""

    @classmethod
    def of(cls, document: dict[str, Any]) -> Comparison:
        """Reads a comparison as the service sends it."""
        comparison = read(cls, document)
        object.__setattr__(comparison, "raw", document)
        return comparison

    def frame(self) -> pd.DataFrame:
        """A row for each location of each study with a result; columns of a direction end with `_x` or `_y`."""
        studies = {study.id: study for study in self.studies}
        rows = []
        for row in self.rows:
            line = self._begun(studies[row.study])
            of_row = ("location", "rank", "rank_certain", "rank_change", "rank_verdict")
            line |= {name: getattr(row, name) for name in of_row}
            for direction, index in (("x", row.x), ("y", row.y)):
                line |= {f"{name}_{direction}": value for name, value in frames.as_record(index).items()}
            rows.append(self._ended(line, studies[row.study]))
        return frames.plain(rows)

    def studies_frame(self) -> pd.DataFrame:
        """A row for each study: what differs, its state, why it has no result, force, signal, best layout, cost."""
        rows = []
        for study in self.studies:
            line = self._begun(study)
            left = {"id", "name", "set", "cost", "spec_sha256", "version"}
            line |= {name: value for name, value in frames.as_record(study).items() if name not in left}
            line |= {name: getattr(study.cost, name) if study.cost else None for name in _COSTS}
            rows.append(self._ended(line, study))
        return frames.plain(rows)

    def _begun(self, study: ComparedStudy) -> dict[str, Any]:
        """What rows begin with: the study, and every field that any design sets."""
        paths = sorted({path for other in self.studies for path in other.set or {}})
        settings = study.set or {}
        return {"study": study.id, "name": study.name} | {path: settings.get(path) for path in paths}

    def _ended(self, line: dict[str, Any], study: ComparedStudy) -> dict[str, Any]:
        """With where the row is from."""
        origin = {"spec_sha256": study.spec_sha256, "version": study.version, "baseline": self.baseline}
        return line | origin

    def plot(self, figure: Figure | None = None) -> Figure:
        """Each location's index over the designs, with error bars, both directions."""
        return plot.comparison(self, figure)

    def __repr__(self) -> str:
        """How many studies and locations."""
        locations = len({row.location for row in self.rows})
        return f"Comparison({len(self.studies)} studies, {locations} locations)"

    def _repr_html_(self) -> str:
        return html.comparison(self)
