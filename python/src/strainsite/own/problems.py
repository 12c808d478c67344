"""Inputs of a model: SALib's problem, or a list as in files of inputs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from strainsite.documents import plain
from strainsite.errors import DocumentError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    Law = dict[str, Any]
    """A distribution as documents have it."""


@dataclass(frozen=True)
class Problem:
    """Inputs as the service has them."""

    inputs: list[dict[str, Any]]
    logarithmic: tuple[int, ...] = ()
    """Inputs of which the service has the logarithm: indices don't change with it."""
    outputs: tuple[str, ...] | None = None
    """Names of the outputs, where the problem has them."""

    @classmethod
    def of(cls, problem: Mapping[str, Any] | Sequence[Mapping[str, Any]]) -> Problem:
        """Reads a problem of SALib's, or a list of `{"name": ..., "distribution": {"kind": ...}}`.

        Raises:
            DocumentError: It is neither, or has something that has no counterpart; with every fault.

        """
        if isinstance(problem, Mapping):
            return _of_salib(problem)
        return cls(plain(list(problem), "inputs"))

    def points(self, rows: list[list[float]]) -> NDArray[np.float64]:
        """Points in the model's own units, a row each."""
        points = np.array(rows, dtype=float).reshape(len(rows), len(self.inputs))
        for k in self.logarithmic:
            points[:, k] = np.exp(points[:, k])
        return points


def _of_salib(problem: Mapping[str, Any]) -> Problem:
    faults = []
    names = [str(name) for name in _entries(problem, "names")]
    # SALib's ProblemSpec has a group for each input where nobody asked for groups.
    if _entries(problem, "groups") not in ([], names):
        faults.append("groups: indices of groups aren't computed here; leave groups out for an index of every input")
    if len(names) != problem.get("num_vars", len(names)):
        faults.append(f"num_vars is {problem['num_vars']}, and there are {len(names)} names")
    bounds = plain(_entries(problem, "bounds"), "bounds")
    dists = _entries(problem, "dists") or ["unif"] * len(names)
    for what, entries in (("bounds", bounds), ("dists", dists)):
        if len(entries) != len(names):
            faults.append(f"{what} has {len(entries)} entries, and there are {len(names)} names")
    inputs = []
    for name, bound, dist in zip(names, bounds, dists, strict=False):
        try:
            inputs.append({"name": name, "distribution": _law(dist, bound)})
        except DocumentError as error:
            faults.append(f"{name}: {error}")
    if not names:
        faults.append("a problem has names, bounds and, where they aren't uniform, dists")
    if faults:
        raise DocumentError("\n".join(faults))
    outputs = problem.get("outputs")
    logarithmic = tuple(k for k, dist in enumerate(dists) if dist == "logunif")
    return Problem(inputs, logarithmic, None if outputs is None else tuple(map(str, outputs)))


def _entries(problem: Mapping[str, Any], name: str) -> list[Any]:
    """A list of the problem, or array; empty where there is none."""
    entries = problem.get(name)
    return [] if entries is None else list(entries)


def _law(dist: str, bound: Any) -> Law:  # noqa: ANN401 - whatever stands there
    """A distribution of SALib's: the parameters that it calls bounds, in their order."""
    if dist not in LAWS:
        raise DocumentError(f"no law {dist!r} here: there are {', '.join(LAWS)}")
    law, names = LAWS[dist]
    if not isinstance(bound, list) or len(bound) != len(names) or not all(isinstance(b, int | float) for b in bound):
        raise DocumentError(f"bounds of {dist} are {', '.join(names)}; they are {bound!r}")
    return law(*bound)


def _triangular(low: float, high: float, peak: float) -> Law:
    return {"kind": "triangular", "min": low, "mode": low + peak * (high - low), "max": high}


def _logarithm(low: float, high: float) -> Law:
    if not 0 < low < high:
        raise DocumentError(f"bounds of logunif are above zero, the lower one first; they are {[low, high]}")
    return {"kind": "uniform", "min": math.log(low), "max": math.log(high)}


LAWS: dict[str, tuple[Callable[..., Law], tuple[str, ...]]] = {
    "unif": (lambda low, high: {"kind": "uniform", "min": low, "max": high}, ("lower", "upper")),
    "norm": (lambda mean, std: {"kind": "normal", "mean": mean, "std": std}, ("mean", "standard deviation")),
    "truncnorm": (
        lambda low, high, mean, std: {"kind": "normal", "mean": mean, "std": std, "truncate": [low, high]},
        ("lower", "upper", "mean", "standard deviation"),
    ),
    "lognorm": (
        lambda mu, sigma: {"kind": "lognormal", "mu": mu, "sigma": sigma},
        ("mean of the logarithm", "standard deviation of the logarithm"),
    ),
    "triang": (_triangular, ("lower", "upper", "peak as a share of the way between them")),
    "logunif": (_logarithm, ("lower", "upper")),
}
