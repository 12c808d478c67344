"""Forces learnt from recordings: what the client gives is what the service and the command line say."""

from __future__ import annotations

import json
import subprocess
from typing import TYPE_CHECKING, Any

import httpx
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from service import BINARY, Service, Way

import strainsite
from strainsite import Client, Estimator

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

# A second: two kinds of model on the signals alone, and the median of both.
RECIPE: dict[str, Any] = {
    "models": {"kinds": ["ridge", "gpr", "blend"], "gpr": {"restarts": 1, "search_rows": 60, "most_rows": 100}},
    "features": {"sets": ["raw"]},
}
RECIPE_TOML = """
[models]
kinds = ["ridge", "gpr", "blend"]
gpr = { restarts = 1, search_rows = 60, most_rows = 100 }
[features]
sets = ["raw"]
"""


def virtual_run(seed: int) -> pd.DataFrame:
    """Ten presses that two of three signals know, and a force that none of them does."""
    random = np.random.default_rng(seed)
    time = np.arange(150) * 0.1
    fz = np.maximum(np.sin(2 * np.pi * time / 1.5), 0) * np.repeat(random.uniform(5, 20, 10), 15)
    noise = random.normal(0, 0.2, (150, 3))
    signals = {"s1": 2 * fz + noise[:, 0], "s2": -fz + noise[:, 1], "s3": noise[:, 2]}
    return pd.DataFrame({"time_s": time, **signals, "fx_n": random.normal(0, 1, 150), "fz_n": fz})


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    yield
    plt.close("all")


@pytest.fixture(scope="module")
def runs() -> list[pd.DataFrame]:
    return [virtual_run(seed) for seed in (1, 2, 3)]


@pytest.fixture(scope="module")
def estimator(client: Client, runs: list[pd.DataFrame]) -> Estimator:
    return client.fit_forces({"monday.csv": runs[0], "tuesday.csv": runs[1]}, RECIPE, "rig <1>")


def rest(service: Service, estimator: Estimator, part: str = "") -> Any:
    answer = httpx.get(f"{service.url}/v1/estimators/{estimator.id}{part}", trust_env=False)
    return answer.raise_for_status().json()


def test_the_report_is_the_services(estimator: Estimator, service: Service) -> None:
    report = estimator.report()
    assert report.raw == rest(service, estimator, "/report")
    assert [(each.file, each.rows) for each in report.recordings] == [("monday.csv", 150), ("tuesday.csv", 150)]
    assert estimator.summary.recordings == report.recordings
    assert estimator.summary.forces == ("fx_n", "fz_n")
    assert estimator.recipe == RECIPE
    fx, fz = report.forces
    assert not fx.useful
    assert fx.chosen == "mean"
    assert "useless" in str(fx)
    assert fz.useful
    assert report.force("fz_n") == fz
    error = fz.models[0].validation
    assert error.by == "run"
    assert error.rmse_interval_n is not None
    assert error.rmse_interval_n[0] <= error.rmse_n <= error.rmse_interval_n[1] < 1
    assert fz.chosen == "blend"
    assert {member.model for member in fz.models[0].members} == {"ridge", "gpr"}
    assert f" raw, off by {error.rmse_n:.3g} N" in str(fz)
    assert str(fz).startswith("fz_n: blend of ")
    assert "runs left out" in repr(report)
    with pytest.raises(strainsite.StrainsiteError, match="forces are fx_n, fz_n"):
        report.force("fy_n")


def test_the_frame_has_every_model_on_every_split(estimator: Estimator) -> None:
    report = estimator.report()
    frame = report.frame()
    assert len(frame) == 2 * 4 == report.cost.candidates
    assert list(frame.groupby("force")["chosen"].sum()) == [1, 1]
    best = frame[(frame["force"] == "fz_n") & frame["chosen"]].iloc[0]
    first = report.force("fz_n").models[0]
    assert first.splits.random is not None
    assert best["random_rmse_n"] == first.splits.random.rmse_n
    assert best["run_rmse_n"] == best["rmse_n"] == first.validation.rmse_n
    assert best["leak_factor"] == pytest.approx(best["run_rmse_n"] / best["random_rmse_n"])


def test_a_saved_model_says_on_the_command_line_what_the_service_says(
    estimator: Estimator, runs: list[pd.DataFrame], tmp_path: Path
) -> None:
    signals = runs[2].drop(columns=["fx_n", "fz_n"])
    found = estimator.apply(signals)
    names = ["time_s", *(f"{force}{end}" for force in ("fx_n", "fz_n") for end in ("", "_low", "_high")), "outside"]
    assert list(found.columns) == names
    assert found["fz_n"].between(found["fz_n_low"], found["fz_n_high"]).all()
    assert np.sqrt(((found["fz_n"] - runs[2]["fz_n"]) ** 2).mean()) < 1
    path = tmp_path / "run.csv"
    signals.to_csv(path, index=False)
    rows = estimator.apply_rows(path)
    assert rows == found.to_dict("records") == estimator.apply_rows(path.read_text())
    rest = signals.head(3)
    zero = estimator.zero(rest)
    assert zero == {name: float(np.median(rest[name])) for name in zero}
    assert not estimator.apply(signals).equals(found)
    assert estimator.zero(None) == {}
    assert estimator.apply(signals).equals(found)
    model = estimator.save(tmp_path)
    assert model == tmp_path / f"{estimator.id}.json"
    assert json.loads(model.read_text()) == estimator.model()
    subprocess.run([BINARY, "force", "apply", model, path, "-o", tmp_path / "forces.csv"], check=True)
    pd.testing.assert_frame_equal(pd.read_csv(tmp_path / "forces.csv").astype(float), found, check_exact=True)


def test_rows_left_out_are_the_services_and_are_drawn(
    estimator: Estimator, service: Service, runs: list[pd.DataFrame], tmp_path: Path
) -> None:
    rows = estimator.left_out("fz_n")
    (said,) = [left for left in rest(service, estimator, "/left-out")["forces"] if left["force"] == "fz_n"]
    for name, values in said.items():
        assert getattr(rows, name) == (values if name == "force" else tuple(values))
    assert estimator.left_out().force == "fx_n"
    frame = rows.frame()
    assert list(frame["truth_n"]) == pytest.approx([*runs[0]["fz_n"], *runs[1]["fz_n"]], abs=1e-12)
    error = np.sqrt(((frame["estimate_n"] - frame["truth_n"]) ** 2).mean())
    assert error == pytest.approx(estimator.report().force("fz_n").models[0].validation.rmse_n, rel=0.05)
    figure = estimator.plot("fz_n")
    assert [ax.get_title() for ax in figure.axes] == ["monday.csv", "tuesday.csv"]
    measured, estimated = figure.axes[1].get_lines()
    np.testing.assert_array_equal(measured.get_ydata(), frame[frame["run"] == 1]["truth_n"])
    np.testing.assert_array_equal(estimated.get_ydata(), frame[frame["run"] == 1]["estimate_n"])
    figure.savefig(tmp_path / "forces.png")
    assert (tmp_path / "forces.png").stat().st_size > 5_000
    with pytest.raises(strainsite.StrainsiteError, match="forces are fx_n, fz_n; it is 'fy_n'"):
        estimator.plot("fy_n")


def test_columns_are_looked_at_before_anything_is_learnt(client: Client, runs: list[pd.DataFrame]) -> None:
    found = client.look({"monday.csv": runs[0], "broken.csv": "time_s,s1,s2,s3,fx_n,fz_n\n0,x,1,2,3,4\n"})
    (monday,) = found.recordings
    assert [(column.column, column.taken) for column in monday.columns] == [
        ("time_s", "time"),
        *((name, "signal") for name in ("s1", "s2", "s3")),
        ("fx_n", "force"),
        ("fz_n", "force"),
    ]
    # Noise alone: its deviation within three of a median's of 149 differences.
    assert monday.columns[3].noise == pytest.approx(0.2, rel=0.35)
    assert monday.series is not None
    assert max(value for value in monday.series.columns[-1].greatest if value is not None) == runs[0]["fz_n"].max()
    (fault,) = found.faults
    assert fault.detail.startswith("broken.csv, line 2, column s1")


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1", "utf-16"])
def test_a_file_is_read_in_whichever_letters_it_is_written(
    client: Client, runs: list[pd.DataFrame], tmp_path: Path, encoding: str
) -> None:
    path = tmp_path / "monday.csv"
    renamed = runs[0].rename(columns={"s1": "s1_µV"})
    path.write_text(renamed.to_csv(index=False, lineterminator="\n"), encoding=encoding)
    (monday,) = client.look([path]).recordings
    assert [column.column for column in monday.columns] == ["time_s", "s1_µV", "s2", "s3", "fx_n", "fz_n"]


def test_files_texts_and_frames_are_the_same_recording(
    client: Client, estimator: Estimator, runs: list[pd.DataFrame], tmp_path: Path
) -> None:
    path = tmp_path / "monday.csv"
    runs[0].to_csv(path, index=False, lineterminator="\n")
    recipe = tmp_path / "recipe.toml"
    recipe.write_text(RECIPE_TOML)
    indexed = runs[1].set_index("time_s")
    again = client.fit_forces([path, indexed], recipe)
    hashes = [recording.sha256 for recording in estimator.summary.recordings]
    assert [recording.sha256 for recording in again.summary.recordings] == hashes
    assert [recording.file for recording in again.summary.recordings] == ["monday.csv", "run2.csv"]
    assert again.report().forces == estimator.report().forces
    text = client.fit_forces([path.read_text(), runs[1]], RECIPE_TOML, wait=False)
    assert text.wait(progress=False, timeout=60).report().forces == estimator.report().forces
    assert [known.id for known in client.estimators()][:2] == [text.id, again.id]
    assert client.estimator(again.id).summary.state == "done"
    text.remove()
    with pytest.raises(strainsite.NotFound):
        client.estimator(text.id)


def test_all_faults_are_told(client: Client, runs: list[pd.DataFrame], tmp_path: Path) -> None:
    with pytest.raises(strainsite.InvalidDocument) as told:
        client.fit_forces([runs[0].drop(columns=["fx_n", "fz_n"])])
    assert "run1.csv" in str(told.value)
    with pytest.raises(strainsite.InvalidDocument, match="/recipe/models/kinds"):
        client.fit_forces([runs[0]], {"models": {"kinds": ["tree"]}})
    with pytest.raises(strainsite.DocumentError, match="nothing to learn from"):
        client.fit_forces([])
    with pytest.raises(strainsite.DocumentError, match="can't be read"):
        client.fit_forces([tmp_path / "none.csv"])
    with pytest.raises(strainsite.DocumentError, match="neither TOML nor JSON"):
        client.fit_forces([runs[0]], "models = [")
    with pytest.raises(strainsite.DocumentError, match="run1.csv is a int"):
        client.fit_forces([7])  # type: ignore[list-item]


def test_a_signal_that_is_missing_is_told(estimator: Estimator, runs: list[pd.DataFrame]) -> None:
    with pytest.raises(strainsite.InvalidDocument, match="s2"):
        estimator.apply(runs[2].drop(columns=["s2"]))


def test_an_unanswered_submission_makes_one_estimator(service: Service, runs: list[pd.DataFrame]) -> None:
    with Way(service.url) as way, Client(way.url) as client:
        way.troubles = ["unanswered"]
        made = client.fit_forces(runs[:2], RECIPE, "once")
        assert len(set(way.keys())) == 1
        assert len(way.keys()) == 2
        assert [known.id for known in client.estimators() if known.name == "once"] == [made.id]


def test_a_cancelled_fit_has_no_answer(own: Service, runs: list[pd.DataFrame]) -> None:
    with Client(own.url) as client:
        # Networks of many rows: seconds.
        fit = client.fit_forces(runs, name="long", wait=False)
        with pytest.raises(strainsite.ProblemError, match="report"):
            fit.report()
        fit.cancel()
        with pytest.raises(strainsite.FitFailed, match="cancelled"):
            fit.wait(timeout=60)
        with pytest.raises(strainsite.FitFailed, match="cancelled"):
            fit.report()
        assert fit.state == "cancelled"


def test_a_notebook_shows_the_report_and_escapes_names(estimator: Estimator) -> None:
    shown = estimator._repr_html_() + estimator.report()._repr_html_()
    assert "rig &lt;1&gt;" in shown
    assert "fz_n: " in shown
    assert "useless" in shown
    assert estimator.id in repr(estimator)
    assert "300 rows of 2 recordings" in repr(estimator.left_out())
