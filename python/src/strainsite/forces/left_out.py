"""Rows that were left out, as they were estimated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from strainsite.answers.rows import record
from strainsite.views import estimates, frames

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True, repr=False)
class LeftOutRows:
    """Truth, estimate and 95 % interval of rows of one force, by a model that hadn't learnt from them."""

    force: str
    run: tuple[int, ...]
    """Place of each row's recording in the report, from 0."""
    time_s: tuple[float, ...]
    truth_n: tuple[float, ...]
    estimate_n: tuple[float, ...]
    low_n: tuple[float, ...]
    high_n: tuple[float, ...]

    def frame(self) -> pd.DataFrame:
        """A row for each row that was left out."""
        columns = {name: values for name, values in record(self).items() if name != "force"}
        rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        return frames.frame(rows, {"force": self.force})

    def plot(self, files: Sequence[str] = (), figure: Figure | None = None) -> Figure:
        """Truth, estimate and 95 % band over time, a panel for each recording, by the names of `files`."""
        rows = zip(self.run, self.time_s, self.truth_n, self.estimate_n, self.low_n, self.high_n, strict=True)
        runs: dict[int, list[estimates.Row]] = {}
        for run, *row in rows:
            runs.setdefault(run, []).append(estimates.Row(*row))
        named = [(files[run] if run < len(files) else f"recording {run + 1}", runs[run]) for run in sorted(runs)]
        return estimates.bands(self.force, named, figure)

    def __repr__(self) -> str:
        """Its force, and how many rows."""
        return f"LeftOutRows({self.force!r}, {len(self.time_s)} rows of {len(set(self.run))} recordings)"
