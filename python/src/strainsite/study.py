"""A study in the service: waiting for it, cancelling it, and its answers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .answers import rows
from .answers._generated import (
    Candidates,
    Estimate,
    Evaluation,
    Layout,
    LayoutFindings,
    Location,
    Rings,
    Sections,
    Signals,
    StudySummary,
)
from .answers.maps import StrainMap
from .answers.reading import read, records
from .answers.result import Result
from .answers.skins import Surface
from .connection.download import download
from .connection.follow import ENDED, Follower
from .connection.progress import Deadline, Progress
from .entry import ListedEntry
from .errors import NotFound, StudyCancelled, StudyFailed
from .views import frames, html

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    import pandas as pd

    from .answers._generated import Table


class Study(ListedEntry[StudySummary]):
    """A study in the service.

    Attributes:
        summary: Where it stood when this was last asked for; `state` and `refresh` ask again.

    """

    _kind = StudySummary
    _list = "studies"

    @property
    def document(self) -> dict[str, Any]:
        """The canonical document: every default filled in, the scene inline."""
        return dict(self._transport.get(self._path)["document"])

    @property
    def estimate(self) -> Estimate | None:
        """What it was expected to take when it last started; None before that."""
        estimate = self._transport.get(self._path).get("estimate")
        return None if estimate is None else read(Estimate, estimate, "estimate")

    def wait(self, *, progress: bool = True, timeout: float | None = None) -> Study:
        """Waits until it is done; a bar shows points done and time left on terminals and in notebooks.

        A connection that breaks is taken up again where it was, for as long as the client's patience lasts.
        Interrupting this doesn't touch the study: `cancel` does.

        Raises:
            StudyFailed: It ended without an answer; the reason is the service's.
            StudyCancelled: Somebody cancelled it.
            WaitTimeout: `timeout` seconds were over; it goes on.
            ServerLost: The service didn't answer any more.

        """
        deadline = Deadline(self.id, timeout)
        with Progress(self.name, shown=progress) as bar:
            follower = Follower(self._transport, self._path, deadline, bar)

            def state() -> str:
                summary = self.refresh().summary
                bar.show(summary.points_done, summary.points_total)
                return summary.state

            while state() not in ENDED:
                follower.run(state)
        self._check()
        return self

    def result(self) -> Result:
        """The whole answer.

        Raises:
            StudyFailed: It ended without one.
            StudyCancelled: Somebody cancelled it.
            NotFound: It isn't done yet.

        """
        return Result.of(self._answer("result"))

    def locations(self) -> tuple[Location, ...]:
        """The ranked locations, best first."""
        return records(self._answer("locations").get("locations"), Location, "locations")

    def layouts(self) -> tuple[Layout, ...]:
        """The ranked layouts, best first."""
        return records(self._answer("layouts").get("layouts"), Layout, "layouts")

    def layout_findings(self) -> LayoutFindings | None:
        """What the layouts show together; None where the study asks for none."""
        found = self._answer("layouts").get("findings")
        return None if found is None else read(LayoutFindings, found, "findings")

    def candidates(self) -> Candidates:
        """The kinds of film for layouts by several criteria.

        Raises:
            NotFound: Its document asks for no layouts, or its budget left no time for them.

        """
        return read(Candidates, self._answer("candidates"), "candidates")

    def signals(self) -> Signals:
        """Films' signals over load, pressure and contact angle.

        Raises:
            NotFound: Its document asks for none.

        """
        return read(Signals, self._answer("signals"), "signals")

    def evaluations(self) -> tuple[Evaluation, ...]:
        """The points that have an outcome so far, while it runs too.

        Those of the plan come first, `result.cost.solves` of them; then the same on a coarser mesh, for the error of
        the mesh, what shows the effect of what the model leaves out, and what films' signals are read from.
        """
        answer = self._transport.get(f"{self._path}/evaluations")
        return records(answer.get("evaluations"), Evaluation, "evaluations")

    def evaluations_frame(self) -> pd.DataFrame:
        """The solved points as a pandas frame: inputs, force, strains at the locations; see `evaluations`."""
        names = [entry["name"] for entry in self.document["inputs"]]
        return frames.frame(rows.evaluations(self.evaluations(), names))

    def map(self, direction: str = "x", input: str | None = None) -> StrainMap:
        """One layer of the map over the inner surface: direction `x` or `y`, and an input (the first when left out)."""
        params = {"direction": direction, "index": "total"} | ({} if input is None else {"input": input})
        return StrainMap.of(self._answer("map", params))

    def sections(self, input: str | None = None) -> Sections:
        """The map at the solved values of an input (the first when left out), all others at their means.

        Raises:
            NotFound: Its document asks for no map.

        """
        params = {} if input is None else {"input": input}
        return read(Sections, self._answer("sections", params), "sections")

    def rings(self) -> Rings:
        """What layouts' films read around the whole wheel; without rings where it asks for no layouts."""
        return read(Rings, self._answer("rings"), "rings")

    def score_layouts(
        self,
        layouts: Sequence[Mapping[str, Any]],
        *,
        simulated: bool = False,
    ) -> tuple[Layout, ...]:
        """Scores layouts of your own, film by film, from what it has stored; nothing is solved.

        Args:
            layouts: Up to 50 like `{"films": [{"theta_deg": 0, "phi_deg": 0, "angle_deg": 90}]}`, with a `name` or
                without; films are of the kinds that the study has read.
            simulated: Whether errors are simulated beside the bounds, of four layouts at most.

        Raises:
            InvalidDocument: A film is of a kind that it has nothing of, or the layouts have other faults.
            ProblemError: Its document asks for no layouts, or their solves are no longer stored.

        """
        body = {"layouts": [dict(layout) for layout in layouts], "simulated": simulated}
        answer = self._transport.post(f"{self._path}/layouts:score", body)
        return records(answer.get("layouts"), Layout, "layouts")

    def surface(self) -> Surface:
        """Both skins of the whole wheel at the means.

        Raises:
            NotFound: It isn't done yet, or another solver solved it.

        """
        return Surface.of(self._transport.request("GET", f"{self._path}/surface").content)

    def export(
        self,
        format: str = "csv",
        table: Table | None = None,
        path: str | os.PathLike[str] | None = None,
    ) -> Path:
        """Writes the service's export to a file and returns its path.

        Args:
            format: `csv`, `parquet`, `vtu` (the map on the inner surface, for ParaView), `glb` (the whole wheel, for
                any 3-D viewer) or `json` (the result).
            table: `indices` (when left out), `locations`, `layouts`, `candidates`, `points`, `signals` or `forces`,
                for formats of one table.
            path: The file, or a folder; the name that the service proposes, in the working folder, when left out.

        """
        return download(self._transport, f"{self._path}/export", format, table, path)

    def _answer(self, part: str, params: dict[str, str] | None = None) -> dict[str, Any]:
        try:
            return self._transport.get(f"{self._path}/{part}", params)
        except NotFound:
            self.refresh()
            self._check()
            raise

    def _check(self) -> None:
        if self.summary.state == "failed":
            raise StudyFailed(self.id, self.summary.error or "the service gave no reason")
        if self.summary.state == "cancelled":
            raise StudyCancelled(self.id)

    def _repr_html_(self) -> str:
        summary = self.summary
        head = ("study", "state", "points", "id")
        points = f"{summary.points_done} of {summary.points_total or '?'}"
        row = (summary.name, summary.state, points, summary.id)
        return html.table(head, [row]) + html.paragraph(summary.error)


def id_of(study: Study | str) -> str:
    """The identifier of a study, or the one that was given."""
    return study if isinstance(study, str) else study.id
