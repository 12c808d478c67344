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
from .errors import NotFound, StudyCancelled, StudyFailed
from .views import frames, html

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    import pandas as pd

    from .answers._generated import Table
    from .connection.transport import Transport


class Study:
    """A study in the service.

    Attributes:
        summary: Where it stood when this was last asked for; `state` and `refresh` ask again.

    """

    def __init__(self, transport: Transport, summary: StudySummary) -> None:
        self._transport = transport
        self.summary = summary
        self._path = f"/v1/studies/{summary.id}"

    @property
    def id(self) -> str:
        """Its identifier."""
        return self.summary.id

    @property
    def name(self) -> str:
        """Its name in lists: the document's, unless `rename` changed it."""
        return self.summary.name

    @property
    def state(self) -> str:
        """Asks the service: `queued`, `running`, `done`, `failed` or `cancelled`."""
        return self.refresh().summary.state

    @property
    def document(self) -> dict[str, Any]:
        """The canonical document: every default filled in, the scene inline."""
        return dict(self._transport.get(self._path)["document"])

    @property
    def estimate(self) -> Estimate | None:
        """What it was expected to take when it last started; None before that."""
        estimate = self._transport.get(self._path).get("estimate")
        return None if estimate is None else read(Estimate, estimate, "estimate")

    def refresh(self) -> Study:
        """Asks the service where it stands."""
        self.summary = read(StudySummary, self._transport.get(self._path))
        return self

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

    def cancel(self) -> Study:
        """Cancels it; what it has solved is kept. Nothing happens to a study that has ended."""
        answer = self._transport.request("DELETE", self._path)
        self.summary = read(StudySummary, answer.json())
        return self

    def rename(self, name: str) -> Study:
        """Gives it another name in lists; document and result keep the one that was submitted.

        Raises:
            ProblemError: It is no name: 1 to 200 characters without control characters (422).

        """
        return self._change({"name": name})

    def archive(self) -> Study:
        """Leaves it out of lists; nothing of it is lost."""
        return self._change({"archived": True})

    def unarchive(self) -> Study:
        """Takes it back into lists."""
        return self._change({"archived": False})

    def _change(self, change: Mapping[str, Any]) -> Study:
        self.summary = read(StudySummary, self._transport.patch(self._path, change))
        return self

    def remove(self) -> None:
        """Removes it for good, running or not, with its result and the points that no other study has.

        Raises:
            ProblemError: It is a design of a sweep, with which it can be removed (409).

        """
        self._transport.request("DELETE", f"{self._path}?purge")

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

    def __repr__(self) -> str:
        """Name, state as last seen, identifier."""
        return f"Study({self.name!r}, {self.summary.state}, {self.id})"

    def _repr_html_(self) -> str:
        summary = self.summary
        head = ("study", "state", "points", "id")
        points = f"{summary.points_done} of {summary.points_total or '?'}"
        row = (summary.name, summary.state, points, summary.id)
        return html.table(head, [row]) + html.paragraph(summary.error)


def id_of(study: Study | str) -> str:
    """The identifier of a study, or the one that was given."""
    return study if isinstance(study, str) else study.id
