"""Sensitivity of models that the script runs: claims hold on functions whose indices are known."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from service import BINARY

import strainsite
from strainsite import Client, Sensitivity
from strainsite.own.problems import Problem

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Points = NDArray[np.float64]

# Test functions that SALib ships, with the problems that its users have for them.
ISHIGAMI = {"num_vars": 3, "names": ["x1", "x2", "x3"], "bounds": [[-math.pi, math.pi]] * 3, "groups": None}
WEIGHTS = np.array([0, 1, 4.5, 9, 99, 99, 99, 99])
EIGHT = [f"x{k}" for k in range(1, 9)]
# As SALib's ProblemSpec has it, which makes a group of each input.
SOBOL_G = {"num_vars": 8, "names": EIGHT, "bounds": np.tile([0.0, 1.0], (8, 1)), "groups": EIGHT}
# One input of each law.
LAWS: dict[str, Any] = {
    "num_vars": 6,
    "names": ["u", "n", "t", "l", "p", "g"],
    "bounds": [[-1, 3], [5, 0.7], [0, 2, 1, 1], [-0.5, 0.4], [1, 4, 0.25], [1, 10]],
    "dists": ["unif", "norm", "truncnorm", "lognorm", "triang", "logunif"],
}


def ishigami(x: Points) -> Points:
    values: Points = np.sin(x[:, 0]) * (1 + 0.1 * x[:, 2] ** 4) + 7 * np.sin(x[:, 1]) ** 2
    return values


def sobol_g(x: Points) -> Points:
    values: Points = ((np.abs(4 * x - 2) + WEIGHTS) / (1 + WEIGHTS)).prod(axis=1)
    return values


def variances() -> Points:
    """Of the inputs of `LAWS`."""
    # Of a normal law of unit width within one of its mean.
    density, share = math.exp(-0.5) / math.sqrt(2 * math.pi), math.erf(1 / math.sqrt(2))
    low, mode, high = 1, 1.75, 4
    moment = (10 - 1) / math.log(10)
    return np.array(
        [
            16 / 12,
            0.7**2,
            1 - 2 * density / share,
            (math.exp(0.16) - 1) * math.exp(-1 + 0.16),
            (low**2 + mode**2 + high**2 - low * mode - low * high - mode * high) / 18,
            (10**2 - 1) / (2 * math.log(10)) - moment**2,
        ]
    )


def assert_holds(found: Sensitivity, exact: Points) -> None:
    errors = np.abs(found.S1 - exact)
    assert (errors <= found.S1_error + 1e-12).all(), f"{found!r}\nis {exact}"


def test_claims_hold_on_functions_that_salib_ships(client: Client) -> None:
    found = client.analyse(ISHIGAMI, ishigami)
    assert_holds(found, np.array([0.31390519114781146, 0.4424111447900408, 0.0]))
    assert found.S1_error.max() <= 0.02
    assert np.allclose(found.ST, [0.5575888552099592, 0.4424111447900408, 0.24368366406214773], atol=0.02)
    assert found.names == ("x1", "x2", "x3")
    assert found.evaluations < 100

    shares = 1 / 3 / (1 + WEIGHTS) ** 2
    # Its kinks take more points than a test has time for: the claims are wide, and hold.
    kinked = client.analyse(SOBOL_G, sobol_g, method={"kind": "auto", "most_runs": 150})
    assert_holds(kinked, shares / (np.prod(1 + shares) - 1))

    linear = client.analyse(LAWS, lambda x: x.sum(axis=1))
    assert_holds(linear, variances() / variances().sum())
    assert linear.S1_error.max() <= 0.02


def test_several_outputs_point_by_point_and_failed_runs() -> None:
    def model(x: Points) -> list[float]:
        assert x.shape == (3,)
        value = float(ishigami(x[None])[0])
        return [value, math.nan if abs(x[0]) > 3 else x[0] + x[1]]

    inputs = [
        {"name": name, "distribution": {"kind": "uniform", "min": -np.pi, "max": np.float64(np.pi)}} for name in "abc"
    ]
    found = strainsite.analyse(
        inputs, model, method={"kind": "mdrm", "nodes": 9}, outputs=["y", "z, N"], by_row=True, program=BINARY
    )
    assert found.S1.shape == found.S1_error.shape == found.ST.shape == (2, 3)
    frame = found.to_df()
    assert list(frame.columns) == ["output", "input", "S1", "S1_error", "ST"]
    assert list(frame["output"]) == ["y"] * 3 + ["z, N"] * 3
    assert frame["S1"][0] == found.S1[0, 0] == found.outputs[0].first_order[0]  # type: ignore[index]
    said = repr(found)
    assert said.startswith(f"Sensitivity: {found.evaluations} runs\ny: ")
    assert "\n  a  S1 0." in said
    assert "±" in said
    assert "<caption>" in found._repr_html_()


def test_a_claim_as_large_as_the_indices_says_what_to_do(client: Client) -> None:
    found = client.analyse(ISHIGAMI, ishigami, method={"kind": "mdrm"})
    assert found.advice is not None
    assert 'kind = "auto"' in found.advice
    assert found.advice in repr(found)


def test_problems_that_have_no_counterpart_are_refused_with_every_fault(client: Client) -> None:
    faulty = {
        "num_vars": 3,
        "names": ["a", "b"],
        "bounds": [[0, 1], [0]],
        "dists": ["beta", "unif"],
        "groups": ["g"] * 2,
    }
    with pytest.raises(strainsite.DocumentError) as refused:
        client.analyse(faulty, ishigami)
    said = str(refused.value).split("\n")
    assert [line.split(" ")[0] for line in said] == ["groups:", "num_vars", "a:", "b:"]
    with pytest.raises(strainsite.DocumentError, match="logunif are above zero"):
        Problem.of({"names": ["a"], "bounds": [[0, 1]], "dists": ["logunif"]})
    with pytest.raises(strainsite.InvalidDocument, match="/inputs/0/distribution"):
        client.analyse({"names": ["a"], "bounds": [[1, 0]]}, ishigami)


def test_answers_of_another_shape_are_refused(client: Client) -> None:
    for model, said in (
        (lambda x: x[0] + x[1], "by_row=True"),
        (lambda _: 1.0, "by_row=True"),
    ):
        with pytest.raises(strainsite.StrainsiteError, match=said):
            client.analyse(ISHIGAMI, model)
    with pytest.raises(strainsite.StrainsiteError, match="names of inputs"):
        client.analyse(ISHIGAMI, ishigami, outputs=["x1"])
    with pytest.raises(strainsite.StrainsiteError, match="answers 1 outputs"):
        client.analyse({**ISHIGAMI, "outputs": ["a", "b"]}, ishigami)
