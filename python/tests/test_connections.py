"""Connections that break, services that are busy, killed or gone."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

import pytest
from conftest import DRAFT, LONG, STUDY
from service import Service, Way, free_port, running

import strainsite
from strainsite import Client, Study
from strainsite.connection.transport import seconds_to_wait

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@pytest.fixture
def way(own: Service) -> Iterator[Way]:
    with Way(own.url) as way:
        yield way


@pytest.mark.parametrize("trouble", ["unheard", "unanswered", 20])
def test_a_submission_that_is_sent_again_makes_one_study(way: Way, trouble: str | int) -> None:
    way.troubles = [trouble, trouble]
    with Client(way.url) as client:
        study = client.submit(STUDY, set=DRAFT)
        assert [known.id for known in client.studies()] == [study.id]
    first, *others = way.keys()
    assert others == [first, first]


def test_two_submissions_are_two_studies_unless_they_have_one_key(way: Way) -> None:
    with Client(way.url) as client:
        ids = {client.submit(STUDY, set=DRAFT).id for _ in range(2)}
        assert len(ids) == len(set(way.keys())) == 2
        kept = {client.submit(STUDY, set=DRAFT, key="night run 17").id for _ in range(2)}
        assert len(kept) == 1
        with pytest.raises(strainsite.InvalidDocument, match="another document"):
            client.submit(STUDY, set={**DRAFT, "name": "other"}, key="night run 17")


def test_a_busy_service_is_asked_again_when_it_says_so(way: Way) -> None:
    way.troubles = [(503, {"retry-after": "1"}), (507, {"retry-after": "0"}), (502, {}), (429, {"retry-after": "0"})]
    with Client(way.url) as client:
        began = time.monotonic()
        study = client.submit(STUDY, set=DRAFT)
        assert time.monotonic() - began >= 1.0
        assert [known.id for known in client.studies()] == [study.id]
    assert len(way.keys()) == 5
    assert len(set(way.keys())) == 1


def test_a_service_that_says_no_is_asked_once(way: Way) -> None:
    for status, kind in ((400, strainsite.ProblemError), (401, strainsite.Refused), (413, strainsite.ProblemError)):
        way.requests.clear()
        way.troubles = [(status, {})]
        with Client(way.url) as client, pytest.raises(kind) as caught:
            client.submit(STUDY)
        assert caught.value.status == status
        assert len(way.keys()) == 1


def test_a_wait_beyond_the_patience_is_not_begun(tmp_path: Path) -> None:
    with (
        running(tmp_path, "--threads", "1", "--max-waiting", "1") as service,
        Client(service.url, patience=2) as client,
    ):
        studies = []
        began = time.monotonic()
        with pytest.raises(strainsite.Busy, match="stud") as caught:
            studies += [client.submit(STUDY, set={**LONG, "method.seed": k}) for k in range(4)]
        assert caught.value.retry_after == 10.0
        assert time.monotonic() - began < 8.0


def test_what_retry_after_says() -> None:
    assert seconds_to_wait("2") == 2.0
    assert seconds_to_wait("Wed, 21 Oct 2015 07:28:00 GMT") == 0.0
    for text in (None, "soon", "nan", "inf"):
        assert seconds_to_wait(text) is None


def test_a_stream_that_breaks_is_taken_up_where_it_was(way: Way) -> None:
    with Client(way.url) as client:
        study = client.submit(STUDY, set=LONG)
        # Looking at the study, then streams that break after some events, in the middle of one, and before the first.
        way.troubles = [10**6, 700, 1200, "unheard"]
        study.wait(timeout=60)
    resumed = [headers.get("last-event-id") for _, path, headers in way.requests if path.endswith("/events")]
    assert len(resumed) == 4
    assert resumed[0] is None
    numbers = [int(number) for number in resumed[1:] if number is not None]
    assert len(numbers) == 3
    assert 0 < numbers[0] < numbers[1] == numbers[2]


def kill_in_the_middle(service: Service, study: Study) -> None:
    """Kills the service when some of the study's points are solved."""
    with Client(service.url) as client:
        seen = client.study(study.id)
        while seen.refresh().summary.points_done < 3:
            assert seen.summary.state in ("queued", "running")
            time.sleep(0.02)
    service.kill()


def test_a_wait_outlives_a_killed_service_that_comes_back(own: Service) -> None:
    with Client(own.url) as client:
        study = client.submit(STUDY, set=LONG)

        def kill_and_start() -> None:
            kill_in_the_middle(own, study)
            time.sleep(0.5)
            own.start()

        accident = threading.Thread(target=kill_and_start)
        accident.start()
        study.wait(timeout=60)
        accident.join()
        assert study.state == "done"
        assert study.summary.points_done == study.summary.points_total == 76 + study.result().cost.layout_solves
        assert study.result().cost.reused >= 3


def test_a_wait_ends_when_the_service_stays_away(own: Service) -> None:
    with Client(own.url, patience=1.0) as client:
        study = client.submit(STUDY, set=LONG)
        accident = threading.Thread(target=kill_in_the_middle, args=(own, study))
        accident.start()
        with pytest.raises(strainsite.ServerLost, match="start it again on the same") as caught:
            study.wait(timeout=60)
        accident.join()
        assert own.url in str(caught.value)
        began = time.monotonic()
        with pytest.raises(strainsite.ServerLost):
            study.refresh()
        assert 0.9 < time.monotonic() - began < 5.0


def test_the_time_to_wait_holds_while_the_service_is_away(own: Service) -> None:
    with Client(own.url, patience=60) as client:
        study = client.submit(STUDY, set=LONG)
        accident = threading.Thread(target=kill_in_the_middle, args=(own, study))
        accident.start()
        with pytest.raises(strainsite.WaitTimeout):
            study.wait(timeout=2)
        accident.join()


def test_a_service_that_was_never_there_is_soon_given_up() -> None:
    began = time.monotonic()
    with Client(f"http://127.0.0.1:{free_port()}") as client, pytest.raises(strainsite.ServerLost, match=r"local\(\)"):
        client.version()
    assert 2.0 < time.monotonic() - began < 6.0
    with Client(f"http://127.0.0.1:{free_port()}", patience=0) as client, pytest.raises(strainsite.ServerLost):
        client.version()


def test_something_else_at_the_address_is_not_taken_for_the_service(way: Way) -> None:
    way.troubles = [(200, {"content-type": "text/html"})]
    with Client(way.url) as client, pytest.raises(strainsite.AnswerError, match="isn't JSON"):
        client.version()
    way.troubles = [(301, {"location": "http://127.0.0.1:1/"})]
    with Client(way.url) as client, pytest.raises(strainsite.ProblemError) as caught:
        client.version()
    assert caught.value.status == 301
