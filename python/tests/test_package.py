"""The package itself: what it imports, exports and says of itself."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import strainsite
from strainsite.answers import _generated

if TYPE_CHECKING:
    from strainsite import Result, Study

FOLDER = Path(__file__).resolve().parents[1]


def test_what_is_exported_is_every_class_of_answers_and_what_makes_them() -> None:
    exported: set[str] = set(vars(strainsite)["__all__"])
    assert exported >= {*_generated.__all__, "Client", "Comparison", "FitReport", "Result", "StrainsiteError", "local"}
    assert not exported & {"TYPE_CHECKING", "answers", "client"}
    assert not any(name.endswith("Fields") for name in exported)


def test_pandas_and_matplotlib_are_loaded_only_when_they_are_used() -> None:
    code = "import strainsite, sys; print({'pandas', 'matplotlib'} & set(sys.modules))"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert said.stdout.strip() == "set()"


def test_a_missing_extra_is_named_with_its_command(
    result: Result, study: Study, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    for method, extra in (
        (result.locations_frame, "pandas"),
        (study.evaluations_frame, "pandas"),
        (result.plot_ranking, "plot"),
        (result.plot_map, "plot"),
    ):
        with pytest.raises(strainsite.MissingExtra, match=rf"pip install 'strainsite\[{extra}\]'"):
            method()


def test_the_package_is_typed_and_knows_its_version() -> None:
    from importlib.metadata import requires, version

    assert version("strainsite") == "0.2.0"
    assert (Path(strainsite.__file__).parent / "py.typed").exists()
    needed = [line for line in requires("strainsite") or () if "extra ==" not in line]
    assert {line.split("<")[0].split(">")[0] for line in needed} == {"httpx", "numpy", "tqdm"}


def test_the_reference_says_what_the_code_says() -> None:
    said = subprocess.run([sys.executable, FOLDER / "tools/reference.py"], capture_output=True, text=True, check=True)
    assert (FOLDER / "docs/reference.md").read_text() == said.stdout, "run python/generate and commit what it writes"
