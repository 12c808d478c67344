"""What a fit found of each force: models, and their errors on rows that they didn't learn from."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from strainsite.answers.reading import read
from strainsite.answers.rows import record
from strainsite.errors import StrainsiteError
from strainsite.views import frames, html

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class RecordingFigures:
    """One recording that was learnt from."""

    file: str
    rows: int
    labelled: int
    """Rows with at least one force."""
    cycles: int
    rate_hz: float | None
    """Rows a second, pauses apart."""
    sha256: str
    """Hash of its text."""


@dataclass(frozen=True)
class SplitReport:
    """A model on rows that one split left out."""

    by: str
    """What was left out: `random` rows, `cycle`, `run`, `time` or `frequency`."""
    rmse_n: float
    """Root of the mean squared error."""
    rmse_interval_n: tuple[float, float] | None
    """95 % of the bootstrap's samples of whole cycles."""
    nrmse_percent: float | None
    """RMSE over the range of the tested forces."""
    mean_nrmse_percent: float | None
    """That of the training mean."""
    r2: float | None
    coverage: float | None
    """Share of tested rows within their 95 % intervals."""
    width_n: float | None
    """Mean width of these intervals."""


@dataclass(frozen=True)
class SplitReports:
    """A model on every split; None where there is none, with the reason in the notes."""

    random: SplitReport | None
    """A fifth of the rows, drawn at random: their neighbours were learnt from."""
    cycle: SplitReport | None
    """Cycles left out."""
    run: SplitReport | None
    """Runs left out."""
    time: SplitReport | None
    """Later rows on earlier ones."""
    frequency: SplitReport | None
    """Slow, middling or fast cycles left out."""


@dataclass(frozen=True)
class MemberReport:
    """A model that is part of a blend."""

    model: str
    features: str


@dataclass(frozen=True)
class ModelReport:
    """One model with one set of features."""

    model: str
    """`ridge`, `gpr`, `ann`, `blend`, the median of several, or `mean`, the training mean."""
    features: str
    """`raw`, `slopes`, `rolling` or `all`."""
    validation: SplitReport
    """On the split that chooses."""
    splits: SplitReports
    leak_factor: float | None
    """RMSE on the strictest split over that on the random one: how far a random split would have misled."""
    better_than_mean: bool
    """Whether its error is at most 95 % of the training mean's on the split that chooses."""
    members: tuple[MemberReport, ...] = ()
    """The models whose median a blend is; of others none."""


@dataclass(frozen=True)
class ForceReport:
    """What was found of one force."""

    force: str
    """Its column."""
    chosen: str
    """The model that estimates it; `mean` where nothing is better."""
    chosen_features: str
    rolled_r2: float | None
    """R2 of the chosen model where forces are rolled against signals: what chance would do."""
    models: tuple[ModelReport, ...]
    """The chosen one first, then by their error."""

    @property
    def useful(self) -> bool:
        """Whether the chosen model knows it better than the training mean does."""
        return any(model.better_than_mean for model in self.models[:1])

    def __str__(self) -> str:
        """The model with its error on what was left out, or that none is any use."""
        if not self.models:
            return f"{self.force}: {self.chosen}"
        error = self.models[0].validation
        left_out = {"random": "rows", "time": "later rows"}.get(error.by, f"{error.by}s")
        if not self.useful:
            mean = f"the training mean, off by {error.rmse_n:.3g} N"
            return f"{self.force}: useless: no model knows it better than {mean}"
        low_high = error.rmse_interval_n
        between = "" if low_high is None else f" ({low_high[0]:.3g} to {low_high[1]:.3g})"
        named = [f"{member.model} {member.features}" for member in self.models[0].members]
        chosen = f"blend of {', '.join(named[:-1])} and {named[-1]}" if named else self.chosen
        return f"{self.force}: {chosen}, off by {error.rmse_n:.3g} N{between} on {left_out} left out"


@dataclass(frozen=True)
class FitCost:
    """What a fit took."""

    candidates: int
    """Models that were judged, of all forces."""
    wall_s: float


@dataclass(frozen=True, repr=False)
class FitReport:
    """What was learnt from, what was found of each force, and what the intervals promise."""

    recordings: tuple[RecordingFigures, ...]
    forces: tuple[ForceReport, ...]
    promise: str
    """What the 95 % intervals promise."""
    notes: tuple[str, ...]
    """What to know before believing it."""
    cost: FitCost
    raw: dict[str, Any] = field(default_factory=dict, compare=False)
    """The service's document, with what this client has no field for."""

    @classmethod
    def of(cls, document: dict[str, Any]) -> FitReport:
        """Reads a report as the service sends it, or as `strainsite force fit --json` writes it."""
        report = read(cls, document)
        object.__setattr__(report, "raw", document)
        return report

    def force(self, name: str) -> ForceReport:
        """What was found of the force of this name.

        Raises:
            StrainsiteError: There is none.

        """
        for found in self.forces:
            if found.force == name:
                return found
        raise StrainsiteError(f"forces are {', '.join(found.force for found in self.forces)}; it is {name!r}")

    def frame(self) -> pd.DataFrame:
        """A row for each force and model: error on the split that chooses, RMSE on every split, leak factor."""
        rows = []
        for force in self.forces:
            for k, model in enumerate(force.models):
                row: dict[str, object] = {"force": force.force, "model": model.model, "features": model.features}
                row["chosen"] = k == 0
                row |= record(model.validation)
                low, high = model.validation.rmse_interval_n or (None, None)
                del row["rmse_interval_n"]
                row |= {"rmse_low_n": low, "rmse_high_n": high}
                for split, found in record(model.splits).items():
                    row[f"{split}_rmse_n"] = getattr(found, "rmse_n", None)
                row |= {"leak_factor": model.leak_factor, "better_than_mean": model.better_than_mean}
                rows.append(row)
        return frames.frame(rows)

    def __repr__(self) -> str:
        """A line for each force."""
        return "\n".join(["FitReport:", *(f"  {force}" for force in self.forces), f"  {self.promise}"])

    def _repr_html_(self) -> str:
        head = ("force", "model", "features", "RMSE, N", "95 %", "NRMSE, %", "mean's, %", "covered", "width, N", "leak")
        rows = [
            (force.force, model.model, model.features, *_cells(model.validation), _digits(model.leak_factor))
            for force in self.forces
            for model in force.models
        ]
        lines = [str(force) for force in self.forces]
        return html.bullets(lines) + html.paragraph(self.promise) + html.table(head, rows) + html.bullets(self.notes)


def _cells(error: SplitReport) -> tuple[str, ...]:
    between = error.rmse_interval_n
    return (
        _digits(error.rmse_n),
        "" if between is None else f"{_digits(between[0])} to {_digits(between[1])}",
        _digits(error.nrmse_percent),
        _digits(error.mean_nrmse_percent),
        _digits(error.coverage),
        _digits(error.width_n),
    )


def _digits(value: float | None) -> str:
    return "none" if value is None else f"{value:.3g}"
