"""Submitting, waiting, cancelling; and what the service refuses."""

from __future__ import annotations

import pickle
import time
from typing import TYPE_CHECKING

import pytest
from conftest import DRAFT, LONG, STUDY, inflated
from service import Service, running

import strainsite
from strainsite import Client, Study

if TYPE_CHECKING:
    from pathlib import Path

TOKEN = "correct-horse-battery-staple"


def test_a_study_is_submitted_and_waited_for(study: Study, client: Client) -> None:
    assert study.state == "done"
    assert study.summary.points_done == study.summary.points_total == 26 + study.result().cost.layout_solves
    assert study.name.startswith("foot tire")
    assert study.id in repr(study)
    assert client.study(study.id).summary == study.summary
    assert study.wait(timeout=0) is study
    estimate = study.estimate
    assert estimate is not None
    assert estimate.solves.own == 26


def test_a_study_is_renamed_found_and_archived(client: Client) -> None:
    study = client.submit(STUDY, set=DRAFT)
    name = study.document["name"]
    assert study.rename("Thin 50%_wall").name == "Thin 50%_wall"
    assert study.document["name"] == name
    assert [found.id for found in client.studies(search="50%_WALL")] == [study.id]
    assert study.archive().summary.archived is not None
    assert list(client.studies(search="50%_wall")) == []
    assert [found.id for found in client.studies(search="50%_wall", archived="true")] == [study.id]
    assert study.unarchive().summary.archived is None
    with pytest.raises(strainsite.ProblemError, match="1 to 200 characters"):
        study.rename(" ")
    study.remove()


def test_a_removed_study_is_gone(client: Client) -> None:
    study = client.submit(STUDY, set=DRAFT)
    study.remove()
    with pytest.raises(strainsite.NotFound):
        client.study(study.id)
    assert study.id not in [other.id for other in client.studies()]


def test_overrides_reach_the_service(study: Study) -> None:
    assert study.document["accuracy"] == {"preset": "draft"}
    assert study.document["candidates"]["grid"]["circumferential"] == 21
    assert study.document["scene"]["geometry"]["wall_mm"] == 3.0


def test_an_estimate_solves_nothing(client: Client) -> None:
    before = [study.id for study in client.studies()]
    estimate = client.estimate("foot-tire", set={"method.nodes": 7})
    assert estimate.solves.own == 1 + 5 * 6 + 5
    assert estimate.wall_s is not None
    assert 0 < estimate.wall_s.least <= estimate.wall_s.expected <= estimate.wall_s.most
    assert [study.id for study in client.studies()] == before


def test_a_preview_ranks_places_and_stores_nothing(client: Client, study: Study) -> None:
    before = [known.id for known in client.studies()]
    preview = client.preview(STUDY, set=DRAFT)
    assert (preview.claim, preview.level, preview.solves) == ("none", "draft", 31)
    assert preview.locations == study.locations()
    assert preview.map == study.result().raw["map"]
    assert [known.id for known in client.studies()] == before


def test_a_scene_is_solved_with_gauges_and_derivatives(client: Client) -> None:
    wanted = {"model.level": "draft", "pressure.internal_mpa": 0.15}
    paths = ["ground.depths_mm[2]", "pressure.internal_mpa"]
    solved = client.solve("foot-tire", wanted, gauges=[(0, 0, 90), (0, 45)], derivatives=paths)
    assert solved.status == "converged"
    assert solved.model.level == "draft"
    across, shoulder = solved.gauges
    assert across.strain == pytest.approx(solved.locations[2].strain_y, rel=1e-9)
    assert shoulder.strain == pytest.approx(solved.section.shoulder.strain_x, rel=1e-9)
    assert [derivative["by"] for derivative in solved.derivatives] == paths
    # A central difference's own error is the square of its step.
    sides = [client.solve("foot-tire", wanted | {"pressure.internal_mpa": 0.15 + step}) for step in (-1e-4, 1e-4)]
    difference = (sides[1].reaction_n - sides[0].reaction_n) / 2e-4
    assert solved.derivatives[1]["reaction_n"] == pytest.approx(difference, rel=1e-4)

    with pytest.raises(strainsite.DocumentError, match="a gauge is"):
        client.solve("foot-tire", gauges=[(0,)])
    with pytest.raises(strainsite.DocumentError, match="neither a shipped scene"):
        client.solve("no-tire")
    with pytest.raises(strainsite.InvalidDocument) as caught:
        client.solve({"preset": "foot-tire"}, {"contact.friction": 0.5}, derivatives=["pressure.internal_mpa"])
    assert [fault.pointer for fault in caught.value.errors] == ["/scene/contact/friction"]


def test_every_fault_of_a_document_is_named_with_its_pointer(client: Client) -> None:
    with pytest.raises(strainsite.InvalidDocument) as caught:
        client.submit(STUDY, set={"method.nodes": 0, "scene.geometry.wal_mm": 2.5})
    problem = caught.value
    assert problem.status == 422
    assert {fault.pointer for fault in problem.errors} == {"/method/nodes", "/scene/geometry/wal_mm"}
    assert problem.document["request_id"] == problem.request_id
    for fault in problem.errors:
        assert str(fault) in str(problem)
    assert "wall_mm" in str(problem)


def test_what_is_not_there_is_not_found(client: Client) -> None:
    for wrong in ("no-such-study", "../../healthz", "a b/c?d#e"):
        with pytest.raises(strainsite.NotFound, match="no study"):
            client.study(wrong)
    with pytest.raises(strainsite.ProblemError, match="-100 to 100") as caught:
        client.submit(STUDY, priority=1000)
    assert caught.value.status == 400


def test_without_the_right_token_nobody_is_let_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with running(tmp_path, token=TOKEN) as service:
        for token in (None, "", "wrong-horse-battery-staple"):
            with (
                Client(service.url, token) as client,
                pytest.raises(strainsite.Refused, match="STRAINSITE_TOKEN") as no,
            ):
                client.submit(STUDY, set=DRAFT)
            assert no.value.status == 401
        with Client(service.url, f"{TOKEN}\n") as client:
            assert list(client.studies()) == []
            assert TOKEN not in repr(client)
        monkeypatch.setenv("STRAINSITE_URL", service.url)
        monkeypatch.setenv("STRAINSITE_TOKEN", TOKEN)
        with Client() as client:
            assert list(client.studies()) == []


def test_addresses_and_tokens_that_can_not_be_are_refused_at_once() -> None:
    for url in ("127.0.0.1:8080", "ftp://127.0.0.1", "http://", "http://[::1"):
        with pytest.raises(strainsite.StrainsiteError, match="isn't an address"):
            Client(url)
    with pytest.raises(strainsite.StrainsiteError, match="token") as caught:
        Client(token="späte-umlaute")
    assert "umlaute" not in str(caught.value)


def test_a_study_is_cancelled(own: Service) -> None:
    with Client(own.url) as client:
        study = client.submit(STUDY, set=LONG)
        with pytest.raises(strainsite.WaitTimeout, match="it goes on") as late:
            study.wait(timeout=0.3)
        assert late.value.id == study.id
        assert isinstance(late.value, TimeoutError)
        with pytest.raises(strainsite.NotFound, match="has no result"):
            study.result()
        study.cancel()
        with pytest.raises(strainsite.StudyCancelled):
            study.wait(timeout=20)
        with pytest.raises(strainsite.StudyCancelled):
            study.result()
        assert study.cancel().state == "cancelled"
        assert [study.id for study in client.studies("cancelled")] == [study.id]


def test_a_study_without_an_answer_says_why(client: Client) -> None:
    study = client.submit(inflated(1.5, 1.9))
    with pytest.raises(strainsite.StudyFailed, match="limit-point") as caught:
        study.wait(timeout=60)
    assert caught.value.id == study.id
    assert study.summary.state == "failed"
    with pytest.raises(strainsite.StudyFailed, match="limit-point"):
        study.locations()
    assert "limit-point" in study._repr_html_()


def test_lists_go_over_all_pages(own: Service) -> None:
    with Client(own.url) as client:
        first = client.submit(STUDY, set=LONG)
        ids = [client.submit(STUDY, set={**LONG, "method.seed": k}).id for k in range(2, 60)]
        assert [study.id for study in client.studies()] == [*reversed(ids), first.id]
        with pytest.raises(strainsite.ProblemError, match="state is one of"):
            list(client.studies("ended"))  # type: ignore[arg-type]


def test_where_no_stream_is_to_be_had_a_study_is_looked_at(tmp_path: Path) -> None:
    with running(tmp_path, "--max-streams", "0") as service, Client(service.url) as client:
        study = client.submit(STUDY, set=DRAFT).wait(timeout=60)
        assert study.summary.state == "done"
        began = time.monotonic()
        slow = client.submit(STUDY, set={**LONG, "accuracy.preset": "standard"})
        with pytest.raises(strainsite.WaitTimeout):
            slow.wait(timeout=0.5)
        assert time.monotonic() - began < 5.0


def test_the_service_says_its_version_and_its_presets(client: Client) -> None:
    assert client.version()
    presets = client.presets()
    names = {preset.name for preset in presets.studies}
    assert names == {"foot-tire", "foot-tire-paper", "forces", "layouts", "placement"}
    assert all(preset.comment and preset.document for preset in (*presets.studies, *presets.scenes))


def test_errors_can_be_sent_to_other_processes() -> None:
    document = {"title": "Too Many Requests", "detail": "later", "errors": [{"pointer": "/a", "detail": "b"}]}
    for error in (
        strainsite.Busy(429, document, retry_after=2.0),
        strainsite.Refused(401, {}),
        strainsite.StudyFailed("id", "a reason"),
        strainsite.StudyCancelled("id"),
        strainsite.WaitTimeout("id", 1.5),
        strainsite.ServerLost("gone"),
    ):
        copy = pickle.loads(pickle.dumps(error))  # noqa: S301 - our own
        assert (type(copy), str(copy), vars(copy)) == (type(error), str(error), vars(error))
