"""A sweep in the service: one study for each of several designs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Self

from .answers._generated import Design, SweepSummary
from .answers.comparison import Comparison
from .answers.reading import read, records
from .connection.download import download
from .connection.follow import look
from .connection.progress import Deadline, Progress
from .connection.transport import LONGEST_CHECK_S
from .documents import designs_body
from .entry import ListedEntry
from .errors import StudyCancelled, StudyFailed
from .study import Study, id_of
from .views import frames, html

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    import pandas as pd

    from .answers._generated import ComparisonTable
    from .connection.transport import Transport


class Sweep(ListedEntry[SweepSummary]):
    """A sweep in the service.

    Attributes:
        summary: Where it stood when this was last asked for; `state` and `refresh` ask again.

    """

    _kind = SweepSummary
    _list = "sweeps"

    def __init__(self, transport: Transport, document: dict[str, Any]) -> None:
        super().__init__(transport, read(SweepSummary, document))
        self._designs = _designs(document)

    def _take(self, document: dict[str, Any]) -> Self:
        self._designs = _designs(document)
        return super()._take(document)

    @property
    def designs(self) -> tuple[Design, ...]:
        """Its designs, as last seen; the service tells those of large sweeps a part at a time."""
        if self._designs is None:
            self.refresh()
        told = self._designs or ()
        while len(told) < self._count:
            page = self._transport.get(self._path, {"from": str(len(told))})
            further = _designs(page)
            if not further:
                break
            told += further
        self._designs = told
        return told

    @property
    def _count(self) -> int:
        """All designs, however many were told."""
        counts = self.summary.counts
        return counts.queued + counts.running + counts.done + counts.failed + counts.cancelled

    def studies(self) -> tuple[Study, ...]:
        """The study of each design."""
        return tuple(Study(self._transport, design.study) for design in self.designs)

    def wait(self, *, progress: bool = True, timeout: float | None = None) -> Sweep:
        """Waits until every design has ended; a bar shows points done, time left and designs done.

        A design without an answer doesn't end the wait: `comparison` says why it has none.

        Raises:
            StudyFailed: No design has an answer.
            StudyCancelled: Somebody cancelled it.
            WaitTimeout: `timeout` seconds were over; it goes on.
            ServerLost: The service didn't answer any more.

        """
        deadline = Deadline(self.id, timeout)
        with Progress(self.name, shown=progress) as bar:

            def state() -> str:
                summary = self.refresh().summary
                ended = self._count - summary.counts.queued - summary.counts.running
                bar.show(summary.points_done, summary.points_total, f"{ended} of {self._count} designs")
                return summary.state

            look(state, deadline)
        if self.summary.state == "failed":
            reasons = {design.study.error for design in self.designs if design.study.error}
            raise StudyFailed(self.id, "; ".join(sorted(reasons)) or "no design has an answer")
        if self.summary.state == "cancelled":
            raise StudyCancelled(self.id)
        return self

    def resume(self, engine: str | None = None) -> Sweep:
        """Lets designs that were cancelled or failed run again, as new studies; what is solved isn't solved again.

        Args:
            engine: One of `Client.engines`, whose machines solve what the sweep lacks.

        """
        params = None if engine is None else {"engine": engine}
        return self._take(self._transport.post(f"{self._path}/resume", params=params))

    def extend(
        self,
        *,
        grid: Mapping[str, Sequence[Any]] | None = None,
        designs: Sequence[Mapping[str, Any]] | None = None,
    ) -> Sweep:
        """Adds designs, as `Client.sweep` takes them; those that it has already aren't run again."""
        body = designs_body(grid, designs)
        return self._take(self._transport.post(f"{self._path}/designs", body, timeout=LONGEST_CHECK_S))

    def comparison(self, baseline: Study | str | None = None, best: int | None = None) -> Comparison:
        """Compares its designs, with the first one or with `baseline`.

        Args:
            baseline: The design that the others are compared with; the first one when left out.
            best: Designs that are told at most, the best ones; 1000 when left out. `export` has them all.

        """
        most = {} if best is None else {"best": str(best)}
        return Comparison.of(self._transport.get("/v1/comparison", {**self._compared(baseline), **most}))

    def export(
        self,
        format: str = "csv",
        table: ComparisonTable | None = None,
        path: str | os.PathLike[str] | None = None,
        baseline: Study | str | None = None,
    ) -> Path:
        """Writes the comparison of its designs to a file and returns its path.

        Args:
            format: `csv`, `parquet` or `json` (the whole comparison).
            table: `locations` (when left out) or `designs`, for formats of one table.
            path: The file, or a folder; the name that the service proposes, in the working folder, when left out.
            baseline: The design that the others are compared with; the first one when left out.

        """
        return download(self._transport, "/v1/comparison/export", format, table, path, self._compared(baseline))

    def _compared(self, baseline: Study | str | None) -> dict[str, str]:
        if baseline is None:
            return {"sweep": self.id}
        return {"sweep": self.id, "baseline": id_of(baseline)}

    def designs_frame(self) -> pd.DataFrame:
        """The designs as a pandas frame: ordinal, name, what differs, state, points, study."""
        rows = [
            {
                "ordinal": design.ordinal,
                "name": design.name,
                **design.set,
                "state": design.study.state,
                "points_done": design.study.points_done,
                "points_total": design.study.points_total,
                "error": design.study.error,
                "study": design.study.id,
            }
            for design in self.designs
        ]
        return frames.frame(rows)

    def _repr_html_(self) -> str:
        rows = [(design.ordinal, design.name, design.study.state, design.study.error or "") for design in self.designs]
        caption = f"{self.name}: {self.summary.state}"
        return html.table(("", "design", "state", ""), rows, caption=caption)


def _designs(document: dict[str, Any]) -> tuple[Design, ...] | None:
    """Designs of a sweep; lists of sweeps leave them out."""
    listed = document.get("designs")
    return None if listed is None else records(listed, Design, "designs")
