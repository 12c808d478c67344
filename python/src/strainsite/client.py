"""The way to a service."""

from __future__ import annotations

import os
import uuid
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal
from urllib.parse import quote

from . import documents
from .answers._generated import (
    EngineList,
    Estimate,
    EstimatorSummary,
    Look,
    Presets,
    Preview,
    SolvedScene,
    StudySummary,
    SweepEstimate,
)
from .answers.comparison import Comparison
from .answers.reading import read
from .connection.download import download
from .connection.transport import LONGEST_CHECK_S, Transport
from .errors import DocumentError, StrainsiteError
from .forces.estimator import Estimator
from .forces.recordings import recipe as recipe_of
from .forces.recordings import recording
from .own import rounds
from .study import Study, id_of
from .sweep import Sweep

if TYPE_CHECKING:
    import ssl
    from collections.abc import Iterable, Iterator, Sequence
    from pathlib import Path
    from types import TracebackType

    from .answers._generated import ComparisonTable, Engine, State
    from .forces.recordings import Recipe, Run
    from .own.rounds import Model
    from .own.sensitivity import Sensitivity

    Document = Mapping[str, Any] | str | Path
    """A study: its fields, a TOML or JSON file, or the name of one that the service ships."""
    Archived = Literal["true", "false", "all"]

DEFAULT_URL = "http://127.0.0.1:8080"


class Client:
    """A strainsite service.

    Every submission carries an idempotency key, so that a request is sent again when the connection breaks or the
    service is busy, without making a second study. Use it as a context manager, or `close` it. Threads may share it.

    Args:
        url: Its address; STRAINSITE_URL, or else http://127.0.0.1:8080, when left out.
        token: Its token; STRAINSITE_TOKEN when left out, none when empty.
        timeout: Seconds for one answer.
        patience: Seconds for which a service that doesn't answer, or is busy, is tried; 30 when left out, but 3 as long
            as it has never answered. 0 tries once.
        verify: As in httpx: whether, or by which `ssl.SSLContext`, a proxy's certificate is checked.

    Raises:
        StrainsiteError: The address or the token can't be one.

    """

    def __init__(
        self,
        url: str | None = None,
        token: str | None = None,
        *,
        timeout: float = 30.0,
        patience: float | None = None,
        verify: ssl.SSLContext | bool = True,
    ) -> None:
        url = url or os.environ.get("STRAINSITE_URL") or DEFAULT_URL
        token = os.environ.get("STRAINSITE_TOKEN", "") if token is None else token
        self._transport = Transport(url, token.rstrip("\r\n"), timeout=timeout, patience=patience, verify=verify)

    @property
    def url(self) -> str:
        """The service's address; opened in a browser it shows the dashboard."""
        return self._transport.url

    def close(self) -> None:
        """Closes the connections; studies go on."""
        self._transport.close()

    def __enter__(self) -> Client:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        """Its address; never its token."""
        return f"Client({self.url!r})"

    def version(self) -> str:
        """The version of the service."""
        return str(self._transport.get("/healthz").get("version", ""))

    def presets(self) -> Presets:
        """The studies and scenes that the service ships."""
        return read(Presets, self._transport.get("/v1/presets"))

    def document(self, document: Document, set: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """The document that `submit` would send.

        Args:
            document: A study as a mapping; a TOML or JSON file, whose scene file is put in; or the name of a shipped
                study.
            set: Fields to change, by path: `{"scene.geometry.wall_mm": 2.5, "inputs[0].distribution.max": 1.2}`.
                Tables that aren't there are made, None removes a field, and numbers may be numpy's.

        Raises:
            DocumentError: A file can't be read, or a path doesn't fit.

        """
        return self._changed("study", document, set)

    def _changed(
        self, kind: Literal["study", "scene"], document: Document, set: Mapping[str, Any] | None
    ) -> dict[str, Any]:
        if isinstance(document, str) and not documents.is_file(document):
            return documents.changed(self._preset(kind, document), set)
        if isinstance(document, str | os.PathLike):
            return documents.changed(documents.from_file(document), set)
        return documents.changed(document, set)

    def _preset(self, kind: Literal["study", "scene"], name: str) -> dict[str, Any]:
        presets = self.presets()
        shipped = presets.studies if kind == "study" else presets.scenes
        known = {preset.name: preset.document for preset in shipped}
        if name not in known:
            names = ", ".join(sorted(known))
            raise DocumentError(
                f"{name!r} is neither a shipped {kind} ({names}) nor a file: files end with .toml or .json"
            )
        return known[name]

    def submit(
        self,
        document: Document,
        set: Mapping[str, Any] | None = None,
        *,
        priority: int = 0,
        key: str | None = None,
    ) -> Study:
        """Submits a study; it waits for its turn in the service.

        Args:
            document: As for `document`.
            set: As for `document`.
            priority: -100 to 100: studies of higher priority go first.
            key: Its idempotency key, 1 to 255 visible ASCII characters; a new one when left out. The same document
                under the same key finds the same study.

        Raises:
            DocumentError: Nothing was sent: a file can't be read, or a path doesn't fit.
            InvalidDocument: The document has faults, all of which it names; or it would take too much memory.
            Busy: Too many studies wait.

        """
        answer = self._submit("/v1/studies", self.document(document, set), priority, key)
        return Study(self._transport, read(StudySummary, answer))

    def estimate(self, document: Document, set: Mapping[str, Any] | None = None) -> Estimate:
        """What a study would cost, and be worth, before anything is solved.

        Raises:
            DocumentError: As for `submit`.
            InvalidDocument: As for `submit`.

        """
        return read(Estimate, self._transport.post("/v1/studies:estimate", self.document(document, set)))

    def preview(self, document: Document, set: Mapping[str, Any] | None = None) -> Preview:
        """A document's ranked places on the draft mesh, solved at once; nothing is stored.

        One preview is solved at a time in the whole service: a newer one ends the one before.

        Raises:
            DocumentError: As for `submit`.
            InvalidDocument: As for `submit`.
            ProblemError: A newer one was asked for (409), or it took longer than 10 s (503).

        """
        return read(Preview, self._transport.post("/v1/studies:preview", self.document(document, set)))

    def solve(
        self,
        scene: Document,
        set: Mapping[str, Any] | None = None,
        *,
        gauges: Iterable[Sequence[float]] = (),
        derivatives: Iterable[str] = (),
    ) -> SolvedScene:
        """One equilibrium of a scene, solved at once; nothing is stored.

        Args:
            scene: A scene as a mapping; a TOML or JSON file; or the name of a shipped scene.
            set: Fields to change, by path: `{"geometry.wall_mm": 2.5, "model.level": "coarse"}`; as for `document`.
            gauges: Points of the inner surface where the strain is read: `(theta, phi)` or `(theta, phi, angle)`,
                degrees. Theta is the wheel angle from the contact, phi the section angle from the crown, the angle
                that to the circumferential direction.
            derivatives: Numbers of the scene by which the answer is differentiated, by path: `"ground.depths_mm[2]"`.

        Raises:
            DocumentError: Nothing was sent: a file can't be read, or a path or a gauge doesn't fit.
            InvalidDocument: The scene has faults, all of which it names; or no equilibrium; or takes too much memory.
            ProblemError: It took longer than 80 s, with those before it (503).

        """
        question = {
            "scene": self._changed("scene", scene, set),
            "gauges": [_gauge(place) for place in gauges],
            "derivatives": list(derivatives),
        }
        return read(SolvedScene, self._transport.post("/v1/scenes:solve", question))

    def study(self, id: str) -> Study:
        """The study of this identifier.

        Raises:
            NotFound: There is none.

        """
        return Study(self._transport, read(StudySummary, self._transport.get(f"/v1/studies/{_part(id)}")))

    def studies(
        self,
        state: State | None = None,
        sweep: Sweep | str | None = None,
        *,
        search: str | None = None,
        archived: Archived = "false",
    ) -> Iterator[Study]:
        """All studies that aren't archived, newest first; pages are asked for as they are needed.

        Args:
            state: Those of this state alone.
            sweep: Designs of this sweep alone, or with `"none"` studies that are no design of any.
            search: Those alone whose name has this, whatever the case, or whose identifier begins so.
            archived: `"true"`: archived ones alone; `"all"`: those, too.

        """
        asked = {
            "state": state,
            "sweep": sweep.id if isinstance(sweep, Sweep) else sweep,
            "search": search,
            "archived": archived,
        }
        for entry in self._pages("studies", {name: value for name, value in asked.items() if value is not None}):
            yield Study(self._transport, read(StudySummary, entry))

    def sweep(
        self,
        document: Document,
        *,
        grid: Mapping[str, Sequence[Any]] | None = None,
        designs: Sequence[Mapping[str, Any]] | None = None,
        name: str | None = None,
        set: Mapping[str, Any] | None = None,
        priority: int = 0,
        engine: str | None = None,
        key: str | None = None,
    ) -> Sweep:
        """Submits one study for each of several designs of its scene.

        Args:
            document: As for `document`.
            grid: Values of the scene's fields by path, `{"geometry.wall_mm": [2.5, 3.0]}`: every combination is a
                design.
            designs: Or each design by itself: `{"geometry.wall_mm": 2.5}`, or with a name
                `{"name": "thin", "set": {...}}`.
            name: Name of the sweep; the study's when left out.
            set: Fields of the document that all designs have, as for `document`.
            priority: As for `submit`.
            engine: One of `engines`, whose machines solve the designs; the answers are the same.
            key: As for `submit`.

        Raises:
            DocumentError: As for `submit`; or neither `grid` nor `designs` is given, or both.
            InvalidDocument: The study or a design has faults; or there is no such engine.
            ProblemError: The engine is missing or refuses, in its own words.

        """
        body = {"study": self.document(document, set), **documents.designs_body(grid, designs)}
        if name is not None:
            body["name"] = name
        answer = self._submit("/v1/sweeps", body, priority, key, engine, timeout=LONGEST_CHECK_S)
        return Sweep(self._transport, answer)

    def engines(self) -> tuple[Engine, ...]:
        """Schedulers and commands by which other machines solve designs of sweeps, with what they are at."""
        return read(EngineList, self._transport.get("/v1/engines")).engines

    def estimate_sweep(
        self,
        document: Document,
        *,
        grid: Mapping[str, Sequence[Any]] | None = None,
        designs: Sequence[Mapping[str, Any]] | None = None,
        set: Mapping[str, Any] | None = None,
    ) -> SweepEstimate:
        """What a sweep would cost, before anything is solved; arguments as for `sweep`."""
        body = {"study": self.document(document, set), **documents.designs_body(grid, designs)}
        return read(SweepEstimate, self._transport.post("/v1/sweeps:estimate", body))

    def find_sweep(self, id: str) -> Sweep:
        """The sweep of this identifier.

        Raises:
            NotFound: There is none.

        """
        return Sweep(self._transport, self._transport.get(f"/v1/sweeps/{_part(id)}"))

    def sweeps(self, *, search: str | None = None, archived: Archived = "false") -> Iterator[Sweep]:
        """All sweeps that aren't archived, newest first; pages are asked for as they are needed.

        Args:
            search: Those alone whose name has this, whatever the case, or whose identifier begins so.
            archived: `"true"`: archived ones alone; `"all"`: those, too.

        """
        asked = {"archived": archived, **({} if search is None else {"search": search})}
        for entry in self._pages("sweeps", asked):
            yield Sweep(self._transport, entry)

    def fit_forces(
        self,
        runs: Sequence[Run] | Mapping[str, Run],
        recipe: Recipe | None = None,
        name: str | None = None,
        *,
        wait: bool = True,
        key: str | None = None,
    ) -> Estimator:
        """Learns forces from recorded signals, and how far estimates of them are off.

        Args:
            runs: Recordings, each of a run: CSV files, their texts, pandas frames or what `recordings.from_bag` reads,
                with seconds, signals and the forces that were measured. In a mapping all but files have the names of
                its keys.
            recipe: Which columns, features and models: a TOML or JSON file, its text, or a mapping; all defaults
                when left out.
            name: Its name in lists.
            wait: Whether to wait until it is done.
            key: As for `submit`.

        Raises:
            DocumentError: Nothing was sent: a file can't be read, or no run is given.
            InvalidDocument: The recipe or a recording has faults, all of which it names.
            FitFailed: It ended without a model.

        """
        body: dict[str, Any] = {"recipe": recipe_of(recipe), "recordings": _recordings(runs)}
        if name is not None:
            body["name"] = name
        estimator = Estimator(self._transport, read(EstimatorSummary, self._submit("/v1/estimators", body, 0, key)))
        return estimator.wait() if wait else estimator

    def look(self, runs: Sequence[Run] | Mapping[str, Run], recipe: Recipe | None = None) -> Look:
        """What each column of recordings is taken for and what stands in it, before anything is learnt from them.

        Args:
            runs: Recordings, as for `fit_forces`; forces aren't needed.
            recipe: As for `fit_forces`: its columns say what is read.

        Raises:
            DocumentError: Nothing was sent: a file can't be read, or no run is given.
            InvalidDocument: The recipe has faults, all of which it names. Those of recordings are in the answer.

        """
        body = {"recipe": recipe_of(recipe), "recordings": _recordings(runs)}
        return read(Look, self._transport.post("/v1/recordings:look", body))

    def estimator(self, id: str) -> Estimator:
        """The estimator of this identifier.

        Raises:
            NotFound: There is none.

        """
        return Estimator(self._transport, read(EstimatorSummary, self._transport.get(f"/v1/estimators/{_part(id)}")))

    def estimators(self) -> Iterator[Estimator]:
        """All estimators, newest first; pages are asked for as they are needed."""
        for entry in self._pages("estimators", {}):
            yield Estimator(self._transport, read(EstimatorSummary, entry))

    def analyse(
        self,
        problem: Mapping[str, Any] | Sequence[Mapping[str, Any]],
        model: Model,
        *,
        method: Mapping[str, Any] | None = None,
        outputs: Sequence[str] | None = None,
        by_row: bool = False,
    ) -> Sensitivity:
        """Sobol indices of a model that this script runs; arguments as for `strainsite.analyse`.

        Raises:
            DocumentError: Nothing was sent: the problem can't be read, or has groups.
            InvalidDocument: Inputs or method have faults, all of which it names.
            StrainsiteError: The model's answer has another shape than the points.

        """
        return rounds.run(self._transport, problem, model, method=method, outputs=outputs, by_row=by_row)

    def compare(self, studies: Iterable[Study | str], baseline: Study | str | None = None) -> Comparison:
        """Compares studies: index and rank of each location, and which differences are real.

        Args:
            studies: Studies or their identifiers.
            baseline: Which of them the others are compared with; the first one when left out.

        Raises:
            StrainsiteError: No study is given.
            NotFound: One of them isn't there.

        """
        return Comparison.of(self._transport.get("/v1/comparison", _compared(studies, baseline)))

    def export_comparison(
        self,
        studies: Iterable[Study | str],
        format: str = "csv",
        table: ComparisonTable | None = None,
        path: str | os.PathLike[str] | None = None,
        baseline: Study | str | None = None,
    ) -> Path:
        """Writes a comparison of studies to a file and returns its path; a sweep's own is `Sweep.export`.

        Args:
            studies: Studies or their identifiers.
            format: `csv`, `parquet` or `json` (the whole comparison).
            table: `locations` (when left out) or `designs`, for formats of one table.
            path: The file, or a folder; the name that the service proposes, in the working folder, when left out.
            baseline: Which of them the others are compared with; the first one when left out.

        Raises:
            StrainsiteError: No study is given, or the file can't be written.
            NotFound: One of them isn't there.

        """
        params = _compared(studies, baseline)
        return download(self._transport, "/v1/comparison/export", format, table, path, params)

    def _submit(
        self,
        path: str,
        body: Mapping[str, Any],
        priority: int,
        key: str | None,
        engine: str | None = None,
        timeout: float | None = None,
    ) -> dict[str, Any]:
        asked = {"priority": str(priority) if priority else None, "engine": engine}
        params = {name: value for name, value in asked.items() if value is not None}
        key = key or str(uuid.uuid4())
        return self._transport.post(path, body, key=key, params=params or None, timeout=timeout)

    def _pages(self, kind: str, params: Mapping[str, str]) -> Iterator[Any]:
        cursor: str | None = None
        while True:
            page = self._transport.get(f"/v1/{kind}", {**params, **({"cursor": cursor} if cursor else {})})
            yield from page.get(kind, [])
            cursor = page.get("next_cursor")
            if not cursor:
                return


def _recordings(runs: Sequence[Run] | Mapping[str, Run]) -> list[dict[str, str]]:
    named = runs.items() if isinstance(runs, Mapping) else [(f"run{k}.csv", run) for k, run in enumerate(runs, 1)]
    recordings = [recording(run, file) for file, run in named]
    if not recordings:
        raise DocumentError("there is nothing to learn from: give at least one recording")
    return recordings


def _gauge(place: Sequence[float]) -> dict[str, float]:
    names = ("theta_deg", "phi_deg", "angle_deg")
    if len(place) not in (2, 3):
        raise DocumentError(f"a gauge is (theta, phi) or (theta, phi, angle), degrees; it is {tuple(place)}")
    return {name: float(angle) for name, angle in zip(names, place, strict=False)}


def _part(identifier: str) -> str:
    """An identifier as one part of a path, whatever somebody typed."""
    return quote(identifier, safe="")


def _compared(studies: Iterable[Study | str], baseline: Study | str | None) -> dict[str, str]:
    ids = [id_of(study) for study in studies]
    if not ids:
        raise StrainsiteError("there is nothing to compare: give at least one study")
    return {"studies": ",".join(ids)} | ({} if baseline is None else {"baseline": id_of(baseline)})
