"""Sweeps and comparisons: equal to what the service says, and to the studies that they consist of."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import httpx
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from conftest import DRAFT, LONG, STUDY, inflated
from service import Service, Way

import strainsite
from strainsite import Client, Comparison, StrainsiteError, Sweep

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from strainsite.answers._generated import ComparisonTable


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    yield
    plt.close("all")


def test_a_grid_is_every_combination(sweep: Sweep, client: Client) -> None:
    assert sweep.state == "done"
    assert sweep.summary.counts.done == len(sweep.designs) == 2
    expected = [{"geometry.wall_mm": w, "carcass.angle_deg": a} for w in (3.0, 2.0) for a in (60.0,)]
    assert [design.set for design in sweep.designs] == expected
    for study, design in zip(sweep.studies(), sweep.designs, strict=True):
        scene = study.document["scene"]
        assert scene["geometry"]["wall_mm"] == design.set["geometry.wall_mm"]
        assert scene["carcass"]["angle_deg"] == design.set["carcass.angle_deg"]
        assert study.result().locations[0].name == "P3"
    assert [known.id for known in client.sweeps()] == [sweep.id]
    designs = {design.study.id for design in sweep.designs}
    assert {study.id for study in client.studies(sweep=sweep)} == designs
    assert designs.isdisjoint(study.id for study in client.studies(sweep="none"))
    assert next(client.sweeps()).designs == client.find_sweep(sweep.id).designs == sweep.designs


def test_other_machines_solve_a_sweep(tmp_path: Path) -> None:
    every = 'for task in $TASKS; do "$PROGRAM" tasks run "$FOLDER" $task; done'
    service = Service(tmp_path, "--engine", "command", "--engine-command", every).start()
    try:
        with Client(service.url) as client:
            grid = {"geometry.wall_mm": [2.8, 3.2]}
            with pytest.raises(strainsite.InvalidDocument, match="this service has command"):
                client.sweep(STUDY, grid=grid, set=DRAFT, engine="slurm")
            swept = client.sweep(STUDY, grid=grid, set=DRAFT, engine="command").wait(progress=False, timeout=60)
            (engine,) = client.engines()
            (away,) = engine.sweeps
            assert (engine.name, away.sweep, away.designs) == ("command", swept.id, 2)
            assert [design.study.state for design in swept.resume(engine="command").designs] == ["done", "done"]
    finally:
        service.kill()


def test_the_comparison_is_the_services(sweep: Sweep, service: Service, client: Client) -> None:
    comparison = sweep.comparison()
    said = httpx.get(f"{service.url}/v1/comparison", params={"sweep": sweep.id}, trust_env=False).json()
    assert comparison.raw == said
    studies = sweep.studies()
    assert comparison.baseline == studies[0].id
    frame = comparison.frame()
    assert len(frame) == len(said["rows"]) == 2 * 5
    for line, row in zip(frame.to_dict("records"), said["rows"], strict=True):
        assert (line["study"], line["location"], line["rank"]) == (row["study"], row["location"], row["rank"])
        for direction in ("x", "y"):
            for name, value in row[direction].items():
                assert line[f"{name}_{direction}"] == value or (
                    value is None and line[f"{name}_{direction}"] is not value
                )
    again = client.compare(studies)
    assert again.rows == comparison.rows
    other = client.compare([study.id for study in studies], baseline=studies[1])
    assert other.baseline == studies[1].id
    assert sweep.comparison(baseline=studies[1]).rows == other.rows
    ranks = {study["id"]: (study["answer"] or {"rank": 0})["rank"] for study in said["studies"]}
    told = [study.id for study in sweep.comparison(best=1).studies]
    best = min(ranks, key=lambda study: ranks[study])
    assert told == [study for study in ranks if study in (best, studies[0].id)]


def test_differences_are_those_of_the_results(sweep: Sweep) -> None:
    results = {study.id: study.result() for study in sweep.studies()}
    comparison = sweep.comparison()
    base = {location.name: location for location in results[sweep.studies()[0].id].locations}
    verdicts = set()
    for row in comparison.rows:
        location = next(entry for entry in results[row.study].locations if entry.name == row.location)
        assert (row.rank, row.rank_certain) == (location.rank, location.rank_certain)
        for index, own, reference in (
            (row.x, location.gsi_x_percent, base[row.location].gsi_x_percent),
            (row.y, location.gsi_y_percent, base[row.location].gsi_y_percent),
        ):
            assert index.gsi_percent == own
            if index.difference_percent is None:
                continue
            assert own is not None
            assert reference is not None
            assert index.difference_percent == pytest.approx(own - reference, abs=1e-9)
            if index.difference_error_percent is not None:
                real = abs(index.difference_percent) > index.difference_error_percent
                assert index.verdict == ("real" if real else "noise")
            verdicts.add(index.verdict)
    assert verdicts <= {"real", "noise", "unknown", None}
    assert "real" in verdicts


def test_designs_are_named_and_reach_the_frames(sweep: Sweep) -> None:
    frame = sweep.designs_frame()
    assert list(frame["geometry.wall_mm"]) == [3.0, 2.0]
    assert (frame["state"] == "done").all()
    studies = sweep.comparison().studies_frame()
    assert list(studies["study"]) == list(frame["study"])
    assert (studies["reaction_n"] > 0).all()
    assert (studies["solves"] > 0).all()
    shown = sweep._repr_html_() + sweep.comparison()._repr_html_()
    assert "wall &amp; cord" in shown
    assert all(design.name in shown for design in sweep.designs)
    assert sweep.id in repr(sweep)
    assert "2 studies" in repr(sweep.comparison())


@pytest.mark.parametrize("table", ["locations", "designs"])
def test_the_exported_comparison_is_the_frame(
    sweep: Sweep, client: Client, tmp_path: Path, table: ComparisonTable
) -> None:
    comparison = sweep.comparison()
    frame = comparison.frame() if table == "locations" else comparison.studies_frame()
    path = sweep.export("csv", table, tmp_path)
    assert path == tmp_path / f"comparison-{table}.csv"
    read = pd.read_csv(path)
    pd.testing.assert_frame_equal(read, frame, check_dtype=False, check_exact=True)
    again = client.export_comparison(sweep.studies(), "parquet", table, tmp_path / "table", comparison.baseline)
    assert again.read_bytes()[:4] == b"PAR1"
    whole = client.export_comparison([study.id for study in sweep.studies()], "json", path=tmp_path / "whole.json")
    assert Comparison.of(json.loads(whole.read_text())).rows == comparison.rows


def test_a_comparison_of_nothing_is_no_file(client: Client, tmp_path: Path) -> None:
    with pytest.raises(StrainsiteError, match="at least one study"):
        client.export_comparison([], path=tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_the_comparison_is_drawn(sweep: Sweep, tmp_path: Path) -> None:
    comparison = sweep.comparison()
    figure = comparison.plot()
    for ax, direction in zip(figure.axes, ("x", "y"), strict=True):
        lines = [np.asarray(line.get_ydata(), dtype=float) for line in ax.lines if line.get_linewidth() == 0.8]
        drawn = sorted(np.concatenate(lines))
        values = [getattr(row, direction).gsi_percent for row in comparison.rows]
        assert drawn == sorted(value for value in values if value is not None)
    assert [label.get_text() for label in figure.axes[1].get_xticklabels()] == [
        "wall_mm = 3.0\nangle_deg = 60.0\n(baseline)",
        "wall_mm = 2.0\nangle_deg = 60.0",
    ]
    figure.savefig(tmp_path / "comparison.png")
    assert (tmp_path / "comparison.png").stat().st_size > 5_000


def test_a_sweep_is_extended_and_estimated_without_repeating_anything(own: Service) -> None:
    with Client(own.url) as client:
        sweep = client.sweep(STUDY, set=DRAFT, designs=[{"geometry.wall_mm": 2.5}]).wait(timeout=60)
        first = sweep.designs[0].study
        # Points of the plan, and those of layouts.
        whole = 26 + client.study(first.id).result().cost.layout_solves
        estimate = client.estimate_sweep(STUDY, set=DRAFT, grid={"scene.geometry.wall_mm": [2.5, 3.5]})
        assert [design.estimate.solves.left.expected for design in estimate.designs] == [0, whole]
        assert estimate.left.expected == whole
        sweep.extend(designs=[{"geometry.wall_mm": 2.5}, {"name": "thick", "set": {"geometry.wall_mm": 3.5}}])
        sweep.wait(timeout=60)
        assert [design.name for design in sweep.designs][1:] == ["thick"]
        assert sweep.designs[0].study.id == first.id


def test_a_sweep_is_cancelled_and_resumed(own: Service) -> None:
    with Client(own.url) as client:
        sweep = client.sweep(STUDY, set=LONG, grid={"geometry.wall_mm": [2.5, 3.0]})
        with pytest.raises(strainsite.WaitTimeout):
            sweep.wait(timeout=0.3)
        sweep.cancel()
        with pytest.raises(strainsite.StudyCancelled):
            sweep.wait(timeout=20)
        sweep.resume()
        assert sweep.state in ("queued", "running")
        sweep.cancel()


def test_a_sweep_that_is_sent_again_is_one(own: Service) -> None:
    with Way(own.url) as way, Client(way.url) as client:
        way.troubles = ["unanswered"]
        client.sweep(STUDY, set=DRAFT, grid={"geometry.wall_mm": [2.5, 3.0]}).cancel()
        assert len(list(client.sweeps())) == 1
        assert len(way.keys()) == 2
        assert len(set(way.keys())) == 1


def test_a_design_without_an_equilibrium_does_not_stop_the_others(own: Service) -> None:
    """The wall that can't hold the pressure is named with its reason."""
    with Client(own.url) as client:
        document = inflated(3.0, 4.0)
        sweep = client.sweep(document, grid={"pressure.internal_mpa": [0.1, 0.3]}).wait(timeout=60)
        assert sweep.summary.counts.done == sweep.summary.counts.failed == 1
        comparison = sweep.comparison()
        failed = comparison.studies[1]
        assert failed.state == "failed"
        assert "limit-point" in (failed.reason or "")
        assert failed.cost is None
        assert "limit-point" in comparison._repr_html_()
        assert comparison.studies_frame()["reason"].notna().tolist() == [False, True]
        with pytest.raises(strainsite.StudyFailed, match="limit-point"):
            client.sweep(document, grid={"pressure.internal_mpa": [0.3]}).wait(timeout=60)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({}, "either grid"),
        ({"grid": {}, "designs": []}, "either grid"),
        ({"grid": {"geometry.wall_mm": [float("nan")]}}, r"grid.geometry.wall_mm\[0\] is nan"),
    ],
)
def test_what_designs_can_not_be_is_said_before_anything_is_sent(
    client: Client, arguments: dict[str, Any], said: str
) -> None:
    with pytest.raises(strainsite.DocumentError, match=said):
        client.sweep("foot-tire", **arguments)


def test_what_the_service_refuses_of_a_sweep(client: Client) -> None:
    with pytest.raises(strainsite.InvalidDocument) as caught:
        client.sweep("foot-tire", grid={"geometry.wal_mm": [2.5], "geometry.wall_mm": [-1.0]})
    assert "wall_mm" in str(caught.value)
    with pytest.raises(strainsite.NotFound, match="no sweep"):
        client.find_sweep("nothing")
    with pytest.raises(strainsite.StrainsiteError, match="nothing to compare"):
        client.compare([])
    with pytest.raises(strainsite.NotFound):
        client.compare(["nothing"])
