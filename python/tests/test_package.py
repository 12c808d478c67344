"""The package itself: what it imports, what it describes, and whether that is still what the service says."""

from __future__ import annotations

import dataclasses
import subprocess
import sys
import types
import typing
from pathlib import Path
from typing import TYPE_CHECKING, Any

import httpx
import pytest

import strainsite

if TYPE_CHECKING:
    from service import Service

    from strainsite import Result, Study

FOLDER = Path(__file__).resolve().parents[1]

# Ours, theirs, and what they have that ours leaves out: it is in `raw`, or of no use here.
DESCRIBED: list[tuple[type, str, set[str]]] = [
    (strainsite.StudySummary, "StudySummary", set()),
    (strainsite.Result, "StudyResult", {"map"}),
    (strainsite.StudyIdentity, "StudyIdentity", set()),
    (strainsite.Model, "ModelSummary", set()),
    (strainsite.Choice, "Choice", set()),
    (strainsite.Input, "InputReport", set()),
    (strainsite.Output, "Output", set()),
    (strainsite.CoarserIndices, "CoarserIndices", set()),
    (strainsite.FormMisses, "FormMisses", set()),
    (strainsite.ErrorParts, "IndexError", set()),
    (strainsite.Location, "RankedLocation", set()),
    (strainsite.Layout, "RankedLayout", set()),
    (strainsite.LayoutScore, "LayoutScore", set()),
    (strainsite.LayoutError, "LayoutError", set()),
    (strainsite.LoadScore, "LoadScore", set()),
    (strainsite.FilmPlace, "FilmPlace", set()),
    (strainsite.AlikeContacts, "AlikeContacts", set()),
    (strainsite.DeadFilm, "DeadFilm", set()),
    (strainsite.LayoutFindings, "LayoutFindings", set()),
    (strainsite.LayoutLoad, "LayoutLoad", set()),
    (strainsite.Knee, "Knee", set()),
    (strainsite.FrontLayout, "FrontLayout", set()),
    (strainsite.LayoutSearch, "LayoutSearch", set()),
    (strainsite.Candidates, "Candidates", set()),
    (strainsite.Candidate, "CandidateFilm", set()),
    (strainsite.OrderAgreement, "OrderAgreement", set()),
    (strainsite.StrainRing, "StrainRing", set()),
    (strainsite.Signals, "Signals", set()),
    (strainsite.SignalRow, "SignalRow", set()),
    (strainsite.SignalError, "SignalError", set()),
    (strainsite.SignalCurve, "SignalCurve", set()),
    (strainsite.FilmPair, "FilmPair", set()),
    (strainsite.AskewError, "AskewError", set()),
    (strainsite.DeadFilmError, "DeadFilmError", set()),
    (strainsite.FilmAnglesReport, "FilmAnglesReport", set()),
    (strainsite.ForceError, "ForceError", set()),
    (strainsite.ForceFindings, "ForceFindings", set()),
    (strainsite.SplitError, "SplitError", set()),
    (strainsite.TableError, "TableError", set()),
    (strainsite.TableReport, "TableReport", set()),
    (strainsite.TrialError, "TrialError", set()),
    (strainsite.WorstContact, "WorstContact", set()),
    (strainsite.ElsewhereError, "ElsewhereError", set()),
    (strainsite.ForcePrice, "ForcePrice", set()),
    (strainsite.PublishedTables, "PublishedTables", set()),
    (strainsite.PublishedRow, "PublishedRow", set()),
    (strainsite.PrintedFigures, "PrintedFigures", set()),
    (strainsite.Contradiction, "Contradiction", set()),
    (strainsite.RigFigures, "RigFigures", set()),
    (strainsite.TimeConstantRow, "TimeConstantRow", set()),
    (strainsite.StressWidth, "StressWidth", set()),
    (strainsite.Claim, "ClaimRow", set()),
    (strainsite.FailedPoint, "FailedPoint", set()),
    (strainsite.CutPoint, "CutPoint", {"residual_history"}),
    (strainsite.LocationStrain, "LocationStrain", {"error"}),
    (
        strainsite.Cost,
        "StudyCost",
        {"rungs_wall_s", "factorisation_share", "substitution_share", "assembly_share", "other_share"},
    ),
    (strainsite.Evaluation, "EvaluationView", {"reached"}),
    (strainsite.Estimate, "Estimate", set()),
    (strainsite.SolveForecast, "SolveForecast", set()),
    (strainsite.CountForecast, "CountForecast", set()),
    (strainsite.Forecast, "Forecast", set()),
    (strainsite.ExpectedAccuracy, "ExpectedAccuracy", set()),
    (strainsite.Answer, "Answer", set()),
    (strainsite.PlaceAnswer, "PlaceAnswer", set()),
    (strainsite.LayoutAnswer, "LayoutAnswer", set()),
    (strainsite.LeftOut, "LeftOut", set()),
    (strainsite.Surer, "Surer", set()),
    (strainsite.GradedNote, "GradedNote", set()),
    (strainsite.StrainMap, "MapView", set()),
    (strainsite.Preview, "Preview", set()),
    (strainsite.Sections, "Sections", set()),
    (strainsite.SectionNode, "SectionNode", set()),
    (strainsite.FailedNode, "FailedNode", set()),
    (strainsite.Rings, "Rings", set()),
    (strainsite.WheelRing, "WheelRing", set()),
    (strainsite.RingLoad, "RingLoad", set()),
    (strainsite.Preset, "Preset", set()),
    (strainsite.Presets, "Presets", set()),
    (strainsite.SweepSummary, "SweepSummary", set()),
    (strainsite.Design, "DesignView", set()),
    (strainsite.DesignCounts, "DesignCounts", set()),
    (strainsite.SweepEstimate, "SweepEstimate", set()),
    (strainsite.DesignEstimate, "DesignEstimate", set()),
    (strainsite.EstimatorSummary, "EstimatorSummary", set()),
    (strainsite.FitProgress, "FitProgress", set()),
    (strainsite.FitReport, "Report", set()),
    (strainsite.RecordingFigures, "RecordingFigures", set()),
    (strainsite.ForceReport, "ForceReport", set()),
    (strainsite.ModelReport, "ModelReport", set()),
    (strainsite.MemberReport, "MemberReport", set()),
    (strainsite.SplitReports, "SplitReports", set()),
    (strainsite.SplitReport, "SplitReport", set()),
    (strainsite.FitCost, "FitCost", set()),
    (strainsite.LeftOutRows, "LeftOutRows", set()),
    (strainsite.Comparison, "Comparison", set()),
    (strainsite.ComparedStudy, "ComparedStudy", set()),
    (strainsite.ComparedLocation, "ComparedLocation", set()),
    (strainsite.ComparedIndex, "ComparedIndex", set()),
]


@pytest.fixture(scope="module")
def schemas(service: Service) -> dict[str, Any]:
    description = httpx.get(f"{service.url}/openapi.json", trust_env=False).raise_for_status().json()
    return dict(description["components"]["schemas"])


def properties(schemas: dict[str, Any], name: str) -> dict[str, Any]:
    """The properties of a schema, those of what it extends included."""
    schema = schemas[name]
    found = dict(schema.get("properties", {}))
    for part in schema.get("allOf", ()):
        found |= part.get("properties", {})
    return found


def can_be_null(schema: dict[str, Any]) -> bool:
    alternatives = [*schema.get("oneOf", ()), *schema.get("anyOf", ()), schema]
    return any(
        "null" in kinds if isinstance(kinds := one.get("type"), list) else kinds == "null" for one in alternatives
    )


@pytest.mark.parametrize(("kind", "name", "left_out"), DESCRIBED, ids=lambda value: getattr(value, "__name__", None))
def test_types_have_the_fields_that_the_service_describes(
    kind: type, name: str, left_out: set[str], schemas: dict[str, Any]
) -> None:
    theirs = properties(schemas, name)
    ours = {field.name for field in dataclasses.fields(kind)} - {"raw"}
    assert ours == set(theirs) - left_out
    assert left_out <= set(theirs)
    if kind is strainsite.StrainMap:
        return
    hints = typing.get_type_hints(kind)
    optional = {field for field in ours if types.NoneType in typing.get_args(hints[field])}
    assert optional == {field for field in ours if can_be_null(theirs[field])}


def test_every_type_is_compared() -> None:
    compared = {kind for kind, _, _ in DESCRIBED}
    for name in strainsite.__all__:
        kind = getattr(strainsite, name)
        # Faults stand in problem documents; a surface is no JSON.
        if dataclasses.is_dataclass(kind) and kind not in {strainsite.Fault, strainsite.Surface}:
            assert kind in compared, name


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

    assert version("strainsite") == "0.1.0"
    assert (Path(strainsite.__file__).parent / "py.typed").exists()
    needed = [line for line in requires("strainsite") or () if "extra ==" not in line]
    assert {line.split("<")[0].split(">")[0] for line in needed} == {"httpx", "numpy", "tqdm"}


def test_the_reference_says_what_the_code_says() -> None:
    said = subprocess.run([sys.executable, FOLDER / "tools/reference.py"], capture_output=True, text=True, check=True)
    renew = "$(python/environment)/bin/python python/tools/reference.py > python/docs/reference.md"
    assert (FOLDER / "docs/reference.md").read_text() == said.stdout, renew
