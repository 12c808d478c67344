"""Rows that were left out, as they were estimated."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainsite.answers._generated import LeftOutRowsFields
from strainsite.views import estimates, frames

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import pandas as pd
    from matplotlib.figure import Figure


class LeftOutRows(LeftOutRowsFields):
    """Truth, estimate and 95 % interval of rows of one force, by a model that hadn't learnt from them."""

    def frame(self) -> pd.DataFrame:
        """A row for each row that was left out."""
        columns = ("run", "time_s", "truth_n", "estimate_n", "low_n", "high_n")
        rows = [dict(zip(columns, row, strict=True)) for row in self._rows()]
        return frames.frame(rows, {"force": self.force})

    def plot(self, files: Sequence[str] = (), figure: Figure | None = None) -> Figure:
        """Truth, estimate and 95 % band over time, a panel for each recording, by the names of `files`."""
        runs: dict[int, list[estimates.Row]] = {}
        for run, *row in self._rows():
            runs.setdefault(run, []).append(estimates.Row(*row))
        named = [(files[run] if run < len(files) else f"recording {run + 1}", runs[run]) for run in sorted(runs)]
        return estimates.bands(self.force, named, figure)

    def _rows(self) -> Iterator[tuple[int, float, float, float, float, float]]:
        return zip(self.run, self.time_s, self.truth_n, self.estimate_n, self.low_n, self.high_n, strict=True)

    def __repr__(self) -> str:
        """Its force, and how many rows."""
        return f"LeftOutRows({self.force!r}, {len(self.time_s)} rows of {len(set(self.run))} recordings)"
