from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import pytest
from service import BINARY, ROOT, Service, running

import strainsite
from strainsite import Client, Study, Sweep

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

mpl.use("Agg")

STUDY = ROOT / "studies/foot-tire.toml"
# Two layouts at one load in place of 21 at three.
FEW: dict[str, Any] = {"layouts": {"spacings_deg": [60, 90], "positions": ["crown"]}}
# The shipped study on the draft mesh, with a small map: under a second.
DRAFT = FEW | {"accuracy.preset": "draft", "candidates.grid": {"circumferential": 21, "meridional": 11}}
# Some seconds: 76 points, and those of layouts.
LONG = FEW | {"accuracy.preset": "draft", "method.nodes": 15, "name": "long"}


def pytest_configure() -> None:
    if not BINARY.exists():
        pytest.exit(f"{BINARY} isn't there: make build, or set STRAINSITE_BIN", 2)
    for name in [name for name in os.environ if name.startswith("STRAINSITE_")]:
        del os.environ[name]


@pytest.fixture(scope="session")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Service]:
    """One service for all tests that leave it as it is."""
    with running(tmp_path_factory.mktemp("service")) as service:
        yield service


@pytest.fixture(scope="session")
def client(service: Service) -> Iterator[Client]:
    with Client(service.url) as client:
        yield client


@pytest.fixture(scope="session")
def study(client: Client) -> Study:
    """A study that is done."""
    return client.submit(STUDY, set=DRAFT).wait(timeout=60)


@pytest.fixture(scope="session")
def result(study: Study) -> strainsite.Result:
    return study.result()


@pytest.fixture(scope="session")
def sweep(client: Client) -> Sweep:
    """Two designs of two inputs on the coarse mesh, from which on every index has an error."""
    few = FEW | {"accuracy.preset": "coarse", "method.nodes": 3, "method.check_points": 2}
    document = client.document("foot-tire", few)
    document["inputs"] = document["inputs"][1:3]
    grid = {"geometry.wall_mm": [3.0, 2.0], "carcass.angle_deg": [60.0]}
    return client.sweep(document, grid=grid, name="wall & cord").wait(timeout=100)


@pytest.fixture(scope="session")
def coarse(sweep: Sweep) -> strainsite.Result:
    """The answer of one of them."""
    return sweep.studies()[0].result()


@pytest.fixture(scope="session")
def films(client: Client) -> Study:
    """One that reads bare films under two loads."""
    document = client.document("foot-tire", {"accuracy.preset": "draft", "method.nodes": 3, "method.check_points": 0})
    document["inputs"] = document["inputs"][2:3]
    del document["layouts"]
    document["signals"] = {
        "loads_n": [5, 20],
        "pressures_mpa": [0.2],
        "at_load_n": 5,
        "contact_deg": [0, 10],
        "films": ["bare"],
    }
    return client.submit(document).wait(timeout=60)


@pytest.fixture(scope="session")
def arranged(client: Client) -> Study:
    """One of layouts: regular, staggered, listed and searched, at two depths, each with a film dead, with errors."""
    document = client.document("foot-tire", {"accuracy.preset": "coarse", "method.nodes": 3, "method.check_points": 0})
    document["inputs"] = document["inputs"][2:3]
    document["layouts"] = {
        "depths_mm": [1, 2],
        "spacings_deg": [60],
        "units": [9],
        "positions": ["crown"],
        "section_deg": [30],
        "staggered": True,
        "dead": True,
        "free": [
            {
                "name": "two",
                "films": [
                    {"theta_deg": 0, "phi_deg": 0, "angle_deg": 0},
                    {"theta_deg": 90, "phi_deg": 10, "angle_deg": 45},
                ],
            }
        ],
        "search": {"films": [3], "slots": 12, "section_deg": [0], "directions": ["x"]},
    }
    return client.submit(document).wait(timeout=120)


@pytest.fixture(scope="session")
def partly_failed(client: Client) -> Study:
    """One of which the point with the thinnest wall has no equilibrium."""
    return client.submit(inflated(2.2, 4.0)).wait(timeout=60)


def inflated(thinnest_mm: float, thickest_mm: float) -> dict[str, Any]:
    """A tire without cords under 0.1 MPa, which walls of less than 2.5 mm can't hold."""
    distribution = {"kind": "uniform", "min": thinnest_mm, "max": thickest_mm}
    return {
        "name": "as <thin> as can be",
        "scene": {"model": {"level": "draft"}, "pressure": {"internal_mpa": 0.1}},
        "inputs": [{"name": "wall", "vary": "geometry.wall_mm", "distribution": distribution}],
        "layouts": {"spacings_deg": [60], "positions": ["crown"]},
        "method": {"kind": "mdrm", "nodes": 5, "check_points": 1},
    }


@pytest.fixture
def own(tmp_path: Path) -> Iterator[Service]:
    """A service of the test's own, on one thread."""
    with running(tmp_path, "--threads", "1") as service:
        yield service
