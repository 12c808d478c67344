"""A recording: signals and forces over time, as `strainsite force` reads it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from strainsite.connection.download import write_whole
from strainsite.errors import BagError
from strainsite.views import frames

from . import column_names

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator, Mapping

    import pandas as pd
    from numpy.typing import NDArray

    from .stamps import TopicTimes

# Rows that are text at once: what bounds the memory that a file of an hour takes.
_ROWS_AT_ONCE = 10_000
# Beyond it the reader of recordings takes no number.
_LARGEST = 1e100
_PAUSE_INTERVALS = 10


@dataclass(frozen=True, eq=False, repr=False)
class Recording:
    """A run of one bag. A row has what came at its time; what didn't is nan here, and an empty cell in the file.

    All arrays are of shape (rows,). Cells that are to be left out may be set to nan before the file is written.
    """

    path: Path
    """The bag that it is of."""
    time_s: NDArray[np.float64]
    """Seconds from the first row on, rising."""
    signals: Mapping[str, NDArray[np.float64]]
    """Signals by name of their column, in the units of the bag."""
    forces: Mapping[str, NDArray[np.float64]]
    """Forces by name of their column, N."""
    start_ns: int
    """Time of the first row, nanoseconds since 1970 by the clock of the bag."""
    topics: tuple[TopicTimes, ...]
    """How the times of each topic were found."""
    notes: tuple[str, ...]
    """What should be known of its times: clocks that were taken, messages that are left out."""

    @property
    def has_gaps(self) -> bool:
        """Whether a row lacks a signal, as rows of other topics do; a recipe with `rate_hz` is needed then."""
        return any(bool(np.isnan(column).any()) for column in self.signals.values())

    @property
    def rate_hz(self) -> float | None:
        """Messages a second of the fastest topic with signals, to three digits; None of one message."""
        rates = [times.rate_hz for times in self.topics if times.has_signals and times.rate_hz is not None]
        return float(f"{max(rates):.3g}") if rates else None

    @property
    def recipe(self) -> str:
        """The lines of a recipe that this recording needs, as TOML; empty where it needs none.

        `rate_hz` where a row lacks a signal: signals and forces are then brought to one clock, by interpolation.
        `pause_s` beside it: intervals between rows of several topics tell no pause. `forces` where their names aren't
        usual ones.
        """
        lines = []
        names = [*self.signals, *self.forces]
        if self.forces and column_names.usual_forces(names) != list(self.forces):
            lines += ["[columns]", f"forces = {json.dumps([*self.forces], ensure_ascii=False)}"]
        if self.has_gaps and self.rate_hz is not None:
            pause_s = float(f"{_PAUSE_INTERVALS / self.rate_hz:.3g}")
            lines += ["[preprocess]", f"rate_hz = {self.rate_hz!r}", f"pause_s = {pause_s!r}"]
        return "".join(f"{line}\n" for line in lines)

    def to_csv(self, path: str | os.PathLike[str]) -> Path:
        """Writes the file that `strainsite force fit` and `apply` read, and returns its path.

        Numbers have the fewest digits that read back to the same doubles.

        Args:
            path: The file, or a folder; it is named after the bag then.

        Raises:
            BagError: A number is infinite, or beyond 1e100.
            StrainsiteError: The file can't be written.

        """
        target = Path(path)
        target = target / f"{self.path.stem}.csv" if target.is_dir() else target
        self._check()
        write_whole(target, (part.encode() for part in self._parts()))
        return target

    def text(self) -> str:
        """The text of the file that `to_csv` writes."""
        self._check()
        return "".join(self._parts())

    def frame(self) -> pd.DataFrame:
        """A pandas frame with the columns of the file."""
        return frames.columns(self._columns(), {"bag": str(self.path), "notes": self.notes})

    def _columns(self) -> dict[str, NDArray[np.float64]]:
        return {column_names.TIME: self.time_s, **self.signals, **self.forces}

    def _parts(self) -> Iterator[str]:
        columns = self._columns()
        yield ",".join(columns) + "\n"
        for begin in range(0, self.time_s.size, _ROWS_AT_ONCE):
            # `repr` is the shortest text that reads back to the same double; nan alone differs from itself.
            cells = [
                [repr(number) if number == number else "" for number in column[begin : begin + _ROWS_AT_ONCE].tolist()]  # noqa: PLR0124
                for column in columns.values()
            ]
            yield "".join(",".join(row) + "\n" for row in zip(*cells, strict=True))

    def _check(self) -> None:
        faults = []
        for name, column in self._columns().items():
            beyond = np.flatnonzero(np.abs(column) > _LARGEST)
            if beyond.size:
                row = int(beyond[0])
                more = f", and so are {beyond.size - 1} more" if beyond.size > 1 else ""
                faults.append(
                    f"{name} is {float(column[row])!r} at {float(self.time_s[row])!r} s{more}: numbers must be finite "
                    "and at most 1e100; set those that weren't measured to nan"
                )
        if faults:
            raise BagError(self.path, faults)

    def __repr__(self) -> str:
        """Its size, each topic's clock, the notes, and what a recipe needs."""
        forces = f"forces {', '.join(self.forces)}" if self.forces else "no force"
        size = f"{self.time_s.size} rows in {self.time_s[-1]:.6g} s, {len(self.signals)} signals, {forces}"
        lines = [f"Recording({str(self.path)!r}: {size})"]
        for times in self.topics:
            rate = "" if times.rate_hz is None else f" at {times.rate_hz:.4g} Hz"
            lines.append(f"  {times.topic}: {times.rows} messages{rate}, by {times.by}")
        lines += [f"  {note}" for note in self.notes]
        if self.recipe:
            lines += ["  a recipe needs:", *(f"    {line}" for line in self.recipe.splitlines())]
        return "\n".join(lines)
