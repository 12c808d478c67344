"""Sensitivity of any model, with a service of one's own for as long as that takes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from strainsite.local import local

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping, Sequence

    from .rounds import Model
    from .sensitivity import Sensitivity


def analyse(
    problem: Mapping[str, Any] | Sequence[Mapping[str, Any]],
    model: Model,
    *,
    method: Mapping[str, Any] | None = None,
    outputs: Sequence[str] | None = None,
    by_row: bool = False,
    program: str | os.PathLike[str] | None = None,
) -> Sensitivity:
    """Sobol indices of a model of your own, each with its error.

    The method `auto`, the usual one, asks for points until the largest error of an index is below 0.02.
    `Client.analyse` is the same by a service that runs already.

    Args:
        problem: SALib's problem, as it is: `names`, `bounds` and `dists` (unif, norm, truncnorm, lognorm, triang,
            logunif). Or a list of inputs, `{"name": "a", "distribution": {"kind": "uniform", "min": 0, "max": 1}}`.
        model: Called with an array of points, a row each; answers a number for each row, or an array of (rows,
            outputs). What isn't finite is a run that failed.
        method: `{"kind": "auto", "tolerance": 0.01, "most_runs": 300}`, or another kind with its settings.
        outputs: Names of the outputs; `y`, or `y1`, `y2` and so on, when left out.
        by_row: Whether the model is called with one point at a time.
        program: As for `local`.

    Raises:
        DocumentError: Nothing was sent: the problem can't be read, or has groups.
        InvalidDocument: Inputs or method have faults, all of which it names.
        StrainsiteError: The model's answer has another shape than the points.
        LocalServerError: The program isn't there.

    """
    with local(program=program) as client:
        return client.analyse(problem, model, method=method, outputs=outputs, by_row=by_row)
