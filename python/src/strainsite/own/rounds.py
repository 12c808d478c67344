"""Rounds of an analysis: points from the service, values from the model, until no more points are asked for."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING, Any

import numpy as np

from strainsite.errors import StrainsiteError

from .problems import Problem
from .sensitivity import Sensitivity

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from numpy.typing import NDArray

    from strainsite.connection.transport import Transport

    Model = Callable[[NDArray[np.float64]], Any]


# An analysis has a minute, and waits half of one for its turn.
_LONGEST_S = 120.0


def run(
    transport: Transport,
    problem: Mapping[str, Any] | Sequence[Mapping[str, Any]],
    model: Model,
    *,
    method: Mapping[str, Any] | None,
    outputs: Sequence[str] | None,
    by_row: bool,
) -> Sensitivity:
    """The analysis of a model; arguments as for `strainsite.analyse`."""
    asked = Problem.of(problem)
    body: dict[str, Any] = {"inputs": asked.inputs, **({} if method is None else {"method": dict(method)})}
    told = _Told(outputs or asked.outputs, {entry.get("name") for entry in asked.inputs})
    while True:
        answer = Sensitivity.of(transport.post("/v1/analyses", body, timeout=_LONGEST_S))
        if answer.wanted == 0:
            return answer
        points = asked.points([list(row) for row in answer.points.rows])
        told.add(answer.points.ids, _values(model, points, by_row=by_row))
        body["values"] = told.csv()


def _values(model: Model, points: NDArray[np.float64], *, by_row: bool) -> NDArray[np.float64]:
    """What the model answers, a row each point and a column each output."""
    answered = [model(point) for point in points] if by_row else model(points)
    try:
        values = np.asarray(answered, dtype=float)
    except (TypeError, ValueError) as error:
        raise StrainsiteError(f"the model's answer isn't an array of numbers: {error}") from error
    if values.ndim not in (1, 2) or len(values) != len(points):
        wanted = f"({len(points)},) or ({len(points)}, k)"
        advice = "" if by_row else "; or does it take one point at a time: by_row=True?"
        raise StrainsiteError(f"the model's answer has the shape {values.shape}, not {wanted}{advice}")
    return values.reshape(len(points), -1)


class _Told:
    """Values so far, as a table that keeps all digits."""

    def __init__(self, names: Sequence[str] | None, inputs: set[object]) -> None:
        self._names = None if names is None else list(names)
        self._inputs = inputs
        self._text = io.StringIO()

    def add(self, ids: Sequence[int], values: NDArray[np.float64]) -> None:
        """Appends points; a value that isn't finite is a run that failed."""
        rows = csv.writer(self._text, lineterminator="\n")
        if self._text.tell() == 0:
            rows.writerow(["id", *self._checked_names(values.shape[1])])
        for number, row in zip(ids, values, strict=True):
            rows.writerow([number, *(f"{y:.16e}" if np.isfinite(y) else "" for y in row)])

    def _checked_names(self, count: int) -> list[str]:
        names = self._names or (["y"] if count == 1 else [f"y{k}" for k in range(1, count + 1)])
        if len(names) != count:
            raise StrainsiteError(f"the model answers {count} outputs, and {len(names)} names are given: {names}")
        if same := self._inputs.intersection(names):
            named = sorted(map(str, same))
            raise StrainsiteError(f"outputs have names of inputs, {named}: name them by outputs=[...]")
        return names

    def csv(self) -> str:
        """The table so far."""
        return self._text.getvalue()
