"""Results as objects, frames, arrays and files: equal to what the service says over REST."""

from __future__ import annotations

import io
import json
from typing import TYPE_CHECKING, Any

import httpx
import numpy as np
import pandas as pd
import pytest
from conftest import DRAFT, LONG, STUDY

import strainsite
from strainsite import Client, Result, Study

if TYPE_CHECKING:
    from pathlib import Path

    from service import Service


def rest(service: Service, study: Study, part: str, **params: str) -> httpx.Response:
    return httpx.get(f"{service.url}/v1/studies/{study.id}/{part}", params=params, trust_env=False).raise_for_status()


def exported(service: Service, study: Study, table: str) -> pd.DataFrame:
    """The service's CSV without the columns that say where it is from."""
    text = rest(service, study, "export", format="csv", table=table).text
    frame = pd.read_csv(io.StringIO(text))
    return frame.drop(columns=["study", "spec_sha256", "version"])


def assert_equal(frame: pd.DataFrame, table: pd.DataFrame) -> None:
    """The same columns and values, to the last bit; in a CSV 30.0 is written 30."""
    pd.testing.assert_frame_equal(frame, table.astype(frame.dtypes), check_exact=True)


def test_the_result_is_the_services(study: Study, service: Service, result: Result) -> None:
    assert result.raw == rest(service, study, "result").json()
    assert result.study.id == study.id
    assert result.locations == study.locations()
    assert result.layouts == study.layouts()
    assert [location.rank for location in result.locations] == [1, 2, 2, 4, 4]
    best = result.locations[0]
    assert best.name == "P3"
    centre = result.output("P3", "x")
    assert centre.first_order is not None
    assert best.gsi_x_percent == pytest.approx(100 * centre.first_order[2], rel=1e-12)
    with pytest.raises(strainsite.StrainsiteError, match="locations are P1, P2, P3, P4, P5"):
        result.output("P6", "x")


def test_the_answer_is_told_with_its_verdict_and_graded_notes(result: Result) -> None:
    answer = result.answer
    assert answer is not None
    assert answer.sentence
    assert answer.verdict == "unknown", "a draft knows no error"
    assert answer.place is not None
    assert answer.place.names == ("P3",)
    best = result.locations[0]
    index = best.gsi_x_percent if answer.place.direction == "x" else best.gsi_y_percent
    assert index is not None
    assert answer.place.index == pytest.approx(index / 100, rel=1e-12)
    assert answer.surer is not None
    assert answer.surer.level == "coarse"
    assert tuple(note.text for note in result.graded_notes) == result.notes


def test_frames_are_the_exported_tables(study: Study, service: Service, result: Result) -> None:
    assert_equal(result.locations_frame(), exported(service, study, "locations"))
    assert_equal(result.indices_frame(), exported(service, study, "indices"))
    assert_equal(result.layouts_frame(), exported(service, study, "layouts"))
    assert_equal(study.evaluations_frame(), exported(service, study, "points"))
    assert result.indices_frame().attrs["spec_sha256"] == result.study.spec_sha256


def test_points_without_an_equilibrium_are_rows_with_a_reason(partly_failed: Study, service: Service) -> None:
    frame = partly_failed.evaluations_frame()
    assert_equal(frame, exported(service, partly_failed, "points"))
    failed = frame[frame["reason"].notna()]
    assert 0 < len(failed) < len(frame)
    assert (failed["wall"] < 2.5).all()
    assert failed["reaction_n"].isna().all()
    found = partly_failed.result()
    assert {point.ordinal for point in found.failed_points} == set(failed["ordinal"])
    assert_equal(found.indices_frame(), exported(service, partly_failed, "indices"))


def test_signals_are_the_services(films: Study, study: Study, service: Service) -> None:
    found = films.result()
    assert found.signals == films.signals()
    assert found.signals is not None
    assert rest(service, films, "signals").json() == found.raw["signals"]
    assert {row.film for row in found.signals.rows} == {"bare"}
    assert all(row.open_circuit_v for row in found.signals.rows)
    assert found.cost.signal_solves == len({row.load_n for row in found.signals.rows})
    assert_equal(found.signals_frame(), exported(service, films, "signals"))
    assert study.result().signals is None
    assert study.result().signals_frame().empty
    with pytest.raises(strainsite.NotFound, match="asks for none"):
        study.signals()


def test_layouts_are_the_services(arranged: Study, service: Service) -> None:
    result = arranged.result()
    assert result.layouts == arranged.layouts()
    assert result.layout_findings == arranged.layout_findings()
    assert result.layout_findings is not None
    kinds = arranged.candidates()
    assert kinds.candidates == result.layout_findings.candidates
    assert rest(service, arranged, "candidates").json()["candidates"] == result.raw["layout_findings"]["candidates"]
    assert_equal(result.layouts_frame(), exported(service, arranged, "layouts"))
    assert_equal(result.candidates_frame(), exported(service, arranged, "candidates"))
    assert {layout.position for layout in result.layouts} >= {"crown", "30 deg"}
    assert {layout.staggered for layout in result.layouts} == {False, True}
    [two] = [layout for layout in result.layouts if layout.name == "two"]
    assert two.spacing_deg is None
    assert [film.angle_deg for film in two.places] == [0, 45]
    for layout in result.layouts:
        assert [round(load.depth_mm or 0, 6) for load in layout.loads] == [1, 2]
        assert layout.score in [load.score for load in layout.loads]
        assert layout.score.error is not None
        assert layout.score.dead is not None
    assert [search.criterion for search in result.layout_findings.searches] == ["bound", "interval errors"]
    for search in result.layout_findings.searches:
        assert any(layout.places == search.best for layout in result.layouts)
    least = result.layout_findings.front[-1]
    assert result.layouts[least.index].score.simulated_p95_angle_error_deg == least.simulated_p95_angle_error_deg
    assert result.cost.layout_solves > 0


def test_errors_are_in_the_frames_where_they_are_known(coarse: Result) -> None:
    frame = coarse.locations_frame()
    assert (frame["gsi_x_error_percent"] > 0).any()


def test_maps_are_the_services(study: Study, service: Service, result: Result) -> None:
    for direction, name in (("x", "P1"), ("y", "P3"), ("x", None)):
        params = {"direction": direction, "index": "total"} | ({} if name is None else {"input": name})
        layer = rest(service, study, "map", **params).json()
        for found in (study.map(direction, name), result.map(direction, name)):
            assert found.strain.shape == (len(found.phi_deg), len(found.theta_deg)) == (11, 21)
            assert (found.direction, found.input) == (direction, name or "P1")
            for field in ("theta_deg", "phi_deg", "first_order", "total", "std", "strain", "error"):
                values = [np.nan if value is None else value for value in layer[field]]
                np.testing.assert_array_equal(getattr(found, field).ravel(), values)
            assert found.status.ravel().tolist() == layer["status"]
    # The inner surface above the contact centre is where P3 is.
    middle = result.map("y", "P3")
    row, column = np.argmin(np.abs(middle.phi_deg)), np.argmin(np.abs(middle.theta_deg))
    # A map keeps seven digits.
    assert middle.strain[row, column] == pytest.approx(result.cut_point.locations[2].strain_y, rel=5e-7)


def test_a_map_that_is_not_there_says_what_is(study: Study, result: Result, partly_failed: Study) -> None:
    for wrong in (("z", "P1"), ("x", "P9")):
        with pytest.raises(strainsite.StrainsiteError, match="direction is|input is one of P1"):
            result.map(*wrong)
        with pytest.raises(strainsite.ProblemError, match="direction is|input is one of P1"):
            study.map(*wrong)
    for mapless in (partly_failed.map, partly_failed.result().map):
        with pytest.raises(strainsite.StrainsiteError, match="candidates.grid"):
            mapless()


def test_null_in_a_map_is_nan(result: Result) -> None:
    raw = json.loads(json.dumps(result.raw))
    raw["map"]["layers"][0]["first_order"][0][5] = None
    found = Result.of(raw).map("x", "P1")
    assert np.isnan(found.first_order[0, 5])
    assert np.isfinite(found.first_order).sum() == found.first_order.size - 1


def test_sections_and_rings_are_the_services(study: Study, service: Service, result: Result) -> None:
    sections = study.sections("P3")
    assert (sections.input, len(sections.nodes), sections.failed) == ("P3", 5, ())
    answer = rest(service, study, "sections", input="P3").json()
    assert [node.strain_x for node in sections.nodes] == [tuple(node["strain_x"]) for node in answer["nodes"]]
    (means,) = [node for node in sections.nodes if node.cut_point]
    # A map keeps seven digits.
    np.testing.assert_allclose(result.map("y").strain.ravel(), means.strain_y, rtol=5e-7)
    displacements = np.array([node.displacement_mm for node in sections.nodes])
    assert displacements.shape == (5, 11 * 21, 3)
    # The deeper the ground at the centre, the higher it lifts the crown.
    assert (np.diff(displacements[:, 5 * 21 + 10, 2]) > 0).all()
    rings = study.rings()
    assert (rings.unit, [ring.section_deg for ring in rings.rings]) == ("strain", [0.0])
    assert len(rings.rings[0].strain_x or ()) == 360


def test_layouts_of_ones_own_are_scored(study: Study) -> None:
    films = [{"theta_deg": 15.0 * k, "phi_deg": 0.0, "angle_deg": 90.0 * (k % 2)} for k in range(24)]
    whole, less = study.score_layouts([{"name": "mine", "films": films}, {"films": films[:-1]}])
    assert (whole.name, whole.film_count, less.name) == ("mine", 24, "layout 2")
    bounds = [layout.score.rms_angle_error_deg for layout in (whole, less)]
    assert bounds[0] is not None
    assert bounds[1] is None or bounds[1] > bounds[0]
    assert whole.score.simulated_p95_angle_error_deg is None
    (simulated,) = study.score_layouts([{"films": films}], simulated=True)
    assert simulated.score.simulated_p95_angle_error_deg is not None


def test_the_surface_is_the_whole_wheel(study: Study, result: Result) -> None:
    surface = study.surface()
    rows, columns = surface.phi_deg.size, surface.theta_deg.size
    assert surface.level == result.model.level
    assert surface.inner_inflated_mm.shape == surface.outer_displacement_mm.shape == (rows, columns, 3)
    crown = (np.flatnonzero(surface.phi_deg == 0)[0], np.flatnonzero(surface.theta_deg == 0)[0])
    shape = result.raw["map"]["shape"]
    assert surface.inner_inflated_mm[crown] == pytest.approx(shape["inflated_mm"][5 * 21 + 10], abs=1e-5)
    assert surface.inner_displacement_mm[crown] == pytest.approx(shape["displacement_mm"][5 * 21 + 10], abs=1e-5)
    lowest = (surface.outer_inflated_mm + surface.outer_displacement_mm)[..., 2].min()
    assert lowest == pytest.approx(surface.ground_mm[:, 1].max(), abs=0.05)


def test_exports_are_the_services_files(study: Study, service: Service, tmp_path: Path) -> None:
    for table in ("indices", "locations", "layouts", "candidates", "points", "signals"):
        path = study.export("csv", table, tmp_path)
        assert path == tmp_path / f"{study.id}-{table}.csv"
        assert path.read_bytes() == rest(service, study, "export", format="csv", table=table).content
    points = study.export("parquet", "points", tmp_path)
    assert points.name == f"{study.id}-points.parquet"
    assert points.read_bytes() == rest(service, study, "export", format="parquet", table="points").content
    surface = study.export("vtu", path=tmp_path)
    assert surface.name == f"{study.id}.vtu"
    assert surface.read_bytes() == rest(service, study, "export", format="vtu").content
    named = study.export("json", path=tmp_path / "result.json")
    assert json.loads(named.read_bytes()) == rest(service, study, "result").json()
    with pytest.raises(strainsite.ProblemError, match="format is"):
        study.export("docx", path=tmp_path / "no")
    assert not (tmp_path / "no").exists()
    with pytest.raises(strainsite.StrainsiteError, match="can't be written"):
        study.export("csv", path=tmp_path / "no/such/folder.csv")


def test_a_notebook_shows_the_ranking_and_escapes_names(study: Study, result: Result, partly_failed: Study) -> None:
    shown = result._repr_html_()
    best = result.locations[0]
    assert best.gsi_x_percent is not None
    assert f"{best.gsi_x_percent:.2f}" in shown
    assert all(location.name in shown for location in result.locations)
    assert study.id in study._repr_html_()
    assert "as &lt;thin&gt; as can be" in partly_failed._repr_html_()
    assert "<thin>" not in partly_failed.result()._repr_html_()


def test_before_anything_is_solved_there_are_no_points(own: Service) -> None:
    with Client(own.url) as client:
        client.submit(STUDY, set=LONG, priority=1)
        queued = client.submit(STUDY, set=DRAFT)
        assert queued.evaluations() == ()
        assert queued.evaluations_frame().empty
        assert queued.estimate is None


def test_answers_of_a_newer_service_are_read_and_of_a_foreign_one_refused(result: Result) -> None:
    newer: dict[str, Any] = {**result.raw, "colour": "green"}
    assert Result.of(newer).locations == result.locations
    assert Result.of(newer).raw["colour"] == "green"
    for wrong, said in (
        ({"locations": [{**result.raw["locations"][0], "rank": "first"}]}, r"locations\[0\].rank .*unexpected type"),
        ({"cost": 7}, "cost .*isn't an object"),
        ({"notes": "none"}, "notes .*unexpected type"),
    ):
        with pytest.raises(strainsite.AnswerError, match=said):
            Result.of({**result.raw, **wrong})
    short = dict(result.raw)
    del short["locations"]
    with pytest.raises(strainsite.AnswerError, match="no locations: it is of another version"):
        Result.of(short)
