"""What a fit found of each force: models, and their errors on rows that they didn't learn from."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

from strainsite.answers._generated import FitReportFields, ForceReportFields, SplitReports
from strainsite.answers.reading import whole
from strainsite.answers.rows import table
from strainsite.errors import StrainsiteError
from strainsite.views import frames, html

if TYPE_CHECKING:
    import pandas as pd

    from strainsite.answers.rows import Row


class ForceReport(ForceReportFields):
    """What was found of one force."""

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


@dataclass(frozen=True, kw_only=True, repr=False)
class FitReport(FitReportFields):
    """What was learnt from, what was found of each force, and what the intervals promise."""

    forces: tuple[ForceReport, ...]
    raw: dict[str, Any] = field(default_factory=dict, compare=False)
    """The service's document, with what this client has no field for."""

    @classmethod
    def of(cls, document: dict[str, Any]) -> FitReport:
        """Reads a report as the service sends it, or as `strainsite force fit --json` writes it."""
        return whole(cls, document)

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
        return frames.frame(self._rows())

    def _rows(self) -> list[Row]:
        models = ((force, k, model) for force in self.forces for k, model in enumerate(force.models))
        return table("models", ({"force": force, "model": model, "chosen": k == 0} for force, k, model in models))

    def __repr__(self) -> str:
        """A line for each force."""
        return "\n".join(["FitReport:", *(f"  {force}" for force in self.forces), f"  {self.promise}"])

    def _repr_html_(self) -> str:
        """What each force is known by, then the columns of `frame`, those of single splits left out."""
        splits = {f"{split.name}_rmse_n" for split in fields(SplitReports)}
        rows = [{name: value for name, value in row.items() if name not in splits} for row in self._rows()]
        cells = [[_cell(value) for value in row.values()] for row in rows]
        lines = [str(force) for force in self.forces]
        head = [name.replace("_", " ") for name in rows[0]] if rows else []
        return html.bullets(lines) + html.paragraph(self.promise) + html.table(head, cells) + html.bullets(self.notes)


def _cell(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.3g}" if isinstance(value, float) else "none" if value is None else str(value)
