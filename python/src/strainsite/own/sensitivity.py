"""Indices of a model's outputs, each with its error."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from strainsite.answers._generated import SensitivityFields
from strainsite.answers.reading import whole
from strainsite.views import frames, html

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd
    from numpy.typing import NDArray

    from strainsite.answers.rows import Row


@dataclass(frozen=True, kw_only=True, repr=False)
class Sensitivity(SensitivityFields):
    """Sobol indices of a model, each with its error.

    `outputs` has all that is known of each output; arrays have a number for each input, in a row for each output
    where there are several, nan where there is none.
    """

    raw: dict[str, Any] = field(default_factory=dict, compare=False)
    """The service's document, with what this client has no field for."""

    @classmethod
    def of(cls, document: dict[str, Any]) -> Sensitivity:
        """Reads an analysis as the service sends it, or as `strainsite gsa analyse --json` writes it."""
        return whole(cls, document)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the inputs."""
        return self.inputs

    @property
    def S1(self) -> NDArray[np.float64]:  # noqa: N802 - as the field writes it
        """First-order indices."""
        return self._numbers([output.first_order for output in self.outputs])

    @property
    def S1_error(self) -> NDArray[np.float64]:  # noqa: N802 - as the field writes it
        """What each first-order index may be off by."""
        return self._numbers([output.error.by_input for output in self.outputs])

    @property
    def ST(self) -> NDArray[np.float64]:  # noqa: N802 - as the field writes it
        """Total indices; no error is claimed for them."""
        return self._numbers([output.total for output in self.outputs])

    def to_df(self) -> pd.DataFrame:
        """A row for each output and input: `output`, `input`, `S1`, `S1_error`, `ST`."""
        return frames.frame(self._rows())

    def _numbers(self, lists: Sequence[Sequence[float] | None]) -> NDArray[np.float64]:
        none = [np.nan] * len(self.inputs)
        numbers = np.array([none if numbers is None else list(numbers) for numbers in lists], dtype=float)
        return numbers[0] if len(lists) == 1 else numbers

    def _rows(self) -> list[Row]:
        columns = {"S1": self.S1, "S1_error": self.S1_error, "ST": self.ST}
        tables = {name: np.atleast_2d(numbers) for name, numbers in columns.items()}
        return [
            {"output": output.name, "input": name, **{column: float(of[k, i]) for column, of in tables.items()}}
            for k, output in enumerate(self.outputs)
            for i, name in enumerate(self.inputs)
        ]

    def __repr__(self) -> str:
        """A line for each input of each output, and what to do where they say little."""
        width = max(map(len, self.inputs), default=0)
        lines = [f"Sensitivity: {self.evaluations} runs"]
        rows = self._rows()
        for output in self.outputs:
            lines.append(f"{output.name}: {output.method}, {output.status}")
            own = [row for row in rows if row["output"] == output.name] if output.first_order is not None else []
            lines += [f"  {row['input']:<{width}}  S1 {_with_error(row)}  ST {row['ST']:.4f}" for row in own]
            lines += [f"  {output.reason}"] if output.reason else []
        return "\n".join([*lines, *([self.advice] if self.advice else [])])

    def _repr_html_(self) -> str:
        cells = [[row["output"], row["input"], _with_error(row), f"{row['ST']:.4f}"] for row in self._rows()]
        caption = f"{self.evaluations} runs"
        return html.table(("output", "input", "S1", "ST"), cells, caption=caption) + html.paragraph(self.advice)


def _with_error(row: Row) -> str:
    error = row["S1_error"]
    return f"{row['S1']:.4f}" if np.isnan(error) else f"{row['S1']:.4f} ±{error:.1e}"  # type: ignore[call-overload]
