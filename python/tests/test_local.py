"""A service for the length of a block."""

from __future__ import annotations

import os
import sys
import time
from typing import TYPE_CHECKING

import pytest
from conftest import DRAFT, LONG, STUDY
from service import BINARY

import strainsite
from strainsite import Client

if TYPE_CHECKING:
    from pathlib import Path


def assert_gone(client: Client) -> None:
    with Client(client.url, patience=0) as again, pytest.raises(strainsite.ServerLost):
        again.version()


def test_a_local_service_ends_with_its_block_and_keeps_its_database(tmp_path: Path) -> None:
    database = tmp_path / "kept.db"
    with strainsite.local(database, program=BINARY, threads=2) as client:
        study = client.submit(STUDY, set=DRAFT).wait(timeout=60)
    assert_gone(client)
    with strainsite.local(database, program=BINARY) as client:
        assert client.study(study.id).result().study.id == study.id


def test_it_ends_after_an_exception_and_in_the_middle_of_a_study() -> None:
    began = time.monotonic()
    with pytest.raises(strainsite.InvalidDocument), strainsite.local(program=BINARY) as client:  # noqa: PT012
        client.submit(STUDY, set={**LONG, "accuracy.preset": "standard"})
        client.submit(STUDY, set={"method.nodes": 0})
    assert_gone(client)
    assert time.monotonic() - began < 20.0


def test_its_token_is_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("STRAINSITE_TOKEN", "the-token-of-another-service")
    monkeypatch.setenv("STRAINSITE_ADDR", "127.0.0.1:1")
    monkeypatch.setenv("STRAINSITE_BIN", str(BINARY))
    with strainsite.local() as client, Client(client.url, "") as stranger:
        assert list(client.studies()) == list(stranger.studies()) == []
    with strainsite.local(token="one-of-its-own-for-this") as client:
        assert list(client.studies()) == []
        with Client(client.url) as stranger, pytest.raises(strainsite.Refused):
            list(stranger.studies())


def test_a_program_that_is_not_there_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for program in ("no-such-program", tmp_path / "none", tmp_path):
        with (
            pytest.raises(strainsite.LocalServerError, match="make build"),
            strainsite.local(program=program),
        ):
            pytest.fail("it can't start")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(strainsite.LocalServerError, match="'strainsite'"), strainsite.local():
        pytest.fail("it can't start")
    (tmp_path / "strainsite").symlink_to(BINARY)
    with strainsite.local() as client:
        assert client.version()


def test_a_program_that_does_not_start_is_quoted(tmp_path: Path) -> None:
    broken = tmp_path / "broken.db"
    broken.write_text("no database")
    with (
        pytest.raises(strainsite.LocalServerError, match=r"(?s)ended instead of starting: .*broken\.db"),
        strainsite.local(broken, program=BINARY),
    ):
        pytest.fail("it can't start")
    script = tmp_path / "script"
    script.write_text("not a program")
    script.chmod(0o755)
    with pytest.raises(strainsite.LocalServerError, match="script can't be started"), strainsite.local(program=script):
        pytest.fail("it can't start")


def test_nothing_is_left_behind(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with strainsite.local(program=BINARY) as client:
        client.submit(STUDY, set=DRAFT)
        assert os.listdir(tmp_path)  # noqa: PTH208 - a list is shorter
    assert not any(tmp_path.iterdir())
    assert "strainsite" in sys.modules
