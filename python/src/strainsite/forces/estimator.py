"""An estimator in the service: waiting for its fit, its report, and forces by it."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from strainsite.answers._generated import EstimatorSummary, EstimatorZero
from strainsite.answers.reading import read, records
from strainsite.connection.download import write_whole
from strainsite.connection.follow import look
from strainsite.connection.progress import Deadline, Progress
from strainsite.entry import Entry
from strainsite.errors import AnswerError, FitFailed, ProblemError, StrainsiteError
from strainsite.views import frames, html

from .left_out import LeftOutRows
from .recordings import recording
from .report import FitReport

if TYPE_CHECKING:
    import os

    import pandas as pd
    from matplotlib.figure import Figure

    from .recordings import Run

# 409: asked for what only a fit that is done has.
_NOTHING_YET = 409


class Estimator(Entry[EstimatorSummary]):
    """An estimator of forces in the service, and the fit that makes it.

    Attributes:
        summary: Where it stood when this was last asked for; `state` and `refresh` ask again.

    """

    _kind = EstimatorSummary
    _list = "estimators"

    @property
    def recipe(self) -> dict[str, Any]:
        """The recipe as it was submitted."""
        return dict(self._transport.get(self._path)["recipe"])

    def wait(self, *, progress: bool = True, timeout: float | None = None) -> Estimator:
        """Waits until it is done; a bar shows models judged, on terminals and in notebooks.

        Raises:
            FitFailed: It ended without a model, or somebody cancelled it; the reason is the service's.
            WaitTimeout: `timeout` seconds were over; it goes on.
            ServerLost: The service didn't answer any more.

        """
        deadline = Deadline(self.id, timeout)
        with Progress(self.name, shown=progress, unit="model") as bar:

            def state() -> str:
                summary = self.refresh().summary
                if summary.progress is not None:
                    bar.show(summary.progress.done, summary.progress.of or None)
                return summary.state

            look(state, deadline)
        self._check()
        return self

    def report(self) -> FitReport:
        """What was found of each force, and what the intervals promise.

        Raises:
            FitFailed: It ended without a model.
            ProblemError: It isn't done yet (409).

        """
        return FitReport.of(self._answer("report"))

    def model(self) -> dict[str, Any]:
        """The model as a document, which `strainsite force apply` reads."""
        return self._answer("model")

    def save(self, path: str | os.PathLike[str] | None = None) -> Path:
        """Writes the model to a file, for `strainsite force apply`, and returns its path.

        Args:
            path: The file, or a folder; the estimator's identifier in the working folder when left out.

        """
        proposed = f"{self.id}.json"
        target = Path(proposed) if path is None else Path(path)
        target = target / proposed if target.is_dir() else target
        write_whole(target, json.dumps(self.model()).encode())
        return target

    def apply(self, run: Run, *, name: str = "run.csv") -> pd.DataFrame:
        """The forces of a recording as a pandas frame; `apply_rows` is the same without pandas.

        Its columns are `time_s`, then `<force>`, `<force>_low` and `<force>_high` of each force, N, with 95 % between
        them, then `outside`: 1 where a signal is beyond those that were learnt from.

        Args:
            run: A CSV file, its text, a pandas frame or what `recordings.from_bag` reads, with the signals of the
                recordings that were learnt from.
            name: What messages call all but a file.

        Raises:
            DocumentError: A file can't be read.
            InvalidDocument: A signal is missing, or the recording has other faults.

        """
        return frames.frame(self.apply_rows(run, name=name))

    def apply_rows(self, run: Run, *, name: str = "run.csv") -> list[dict[str, float | None]]:
        """The forces of a recording as a row by column for each of its rows; arguments as for `apply`."""
        headers = {"Content-Type": "application/json", "Accept": "text/csv, application/problem+json"}
        content = json.dumps(recording(run, name)).encode()
        answer = self._transport.request("POST", f"{self._path}:apply", content=content, headers=headers)
        try:
            return [
                {_named(column): float(cell) if cell else None for column, cell in row.items()}
                for row in csv.DictReader(io.StringIO(answer.text))
            ]
        except (TypeError, ValueError) as error:
            raise AnswerError(f"the service's estimates aren't what this client knows: {error}") from error

    def zero(self, rest: Run | None, *, name: str = "rest.csv") -> dict[str, float]:
        """Gives it the zero of a recording without load, and returns each signal's.

        `apply` estimates by it from then on.

        Args:
            rest: As for `apply`, without load, or with forces whose rows without one count; None forgets the zero, so
                that recordings begin as they did when it was learnt.
            name: What messages call all but a file.

        Raises:
            DocumentError: A file can't be read.
            InvalidDocument: A signal is missing, or a force acts in all rows.

        """
        content = json.dumps({} if rest is None else recording(rest, name)).encode()
        headers = {"Content-Type": "application/json"}
        answer = self._transport.request("POST", f"{self._path}:zero", content=content, headers=headers)
        if rest is None:
            return {}
        zero = read(EstimatorZero, answer.json(), "zero")
        return dict(zip(zero.signals, zero.zero, strict=True))

    def left_out(self, force: str | None = None) -> LeftOutRows:
        """Rows that were left out, as they were estimated; of the first force when none is named.

        Raises:
            StrainsiteError: There is no such force.

        """
        found = records(self._answer("left-out").get("forces"), LeftOutRows, "forces")
        for rows in found:
            if force in (None, rows.force):
                return rows
        raise StrainsiteError(f"forces are {', '.join(rows.force for rows in found)}; it is {force!r}")

    def plot(self, force: str | None = None, figure: Figure | None = None) -> Figure:
        """Truth, estimate and 95 % band of the rows that were left out, a panel for each recording."""
        files = [recording.file for recording in self.summary.recordings]
        return self.left_out(force).plot(files, figure)

    def _answer(self, part: str) -> dict[str, Any]:
        try:
            return self._transport.get(f"{self._path}/{part}")
        except ProblemError as problem:
            if problem.status != _NOTHING_YET:
                raise
            self.refresh()
            self._check()
            raise

    def _check(self) -> None:
        if self.summary.state == "failed":
            raise FitFailed(self.id, self.summary.error or "the service gave no reason")
        if self.summary.state == "cancelled":
            raise FitFailed(self.id, "it was cancelled")

    def _repr_html_(self) -> str:
        summary = self.summary
        head = ("estimator", "state", "forces", "id")
        row = (summary.name, summary.state, ", ".join(summary.forces), summary.id)
        return html.table(head, [row]) + html.paragraph(summary.error)


def _named(cell: str) -> str:
    """The name in a cell, without the apostrophe that keeps spreadsheets from computing it."""
    bare = cell.lstrip("'")
    return cell[1:] if cell != bare and bare.startswith(("=", "+", "-", "@", "\t", "\r", "\n")) else cell
