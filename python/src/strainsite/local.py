"""A service of one's own for the length of a `with` block."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from .client import Client
from .errors import LocalServerError

if TYPE_CHECKING:
    from collections.abc import Iterator

# A start takes 0.2 s; a large database, which is checked first, takes longer.
_START_S = 60.0
# Running solves end at their next Newton iteration.
_STOP_S = 20.0
# What would make the program listen elsewhere, or ask for another token.
_NOT_INHERITED = ("ADDR", "HOST", "TOKEN", "TOKEN_FILE", "CONFIG", "DB", "THREADS")


@contextmanager
def local(
    db: str | os.PathLike[str] | None = None,
    *,
    program: str | os.PathLike[str] | None = None,
    token: str | None = None,
    threads: int | None = None,
    patience: float | None = None,
) -> Iterator[Client]:
    """Starts the service on a free port of this machine, gives its client, and ends it with the block.

    Exceptions and Ctrl-C end it, too. Only a script that is killed leaves it running.

    Args:
        db: Its database, which is kept; one in a temporary folder, which isn't, when left out.
        program: The binary; STRAINSITE_BIN, or else `strainsite` of the PATH, when left out.
        token: A token that it asks for; none when left out.
        threads: Solves at once; all cores when left out.
        patience: As for `Client`.

    Raises:
        LocalServerError: The program isn't there, or ends instead of starting; with what it said.

    """
    binary = _find(program)
    with tempfile.TemporaryDirectory(prefix="strainsite-") as folder:
        database = Path(db) if db is not None else Path(folder) / "strainsite.db"
        command = [binary, "serve", "--addr", "127.0.0.1:0", "--db", os.fspath(database)]
        if threads is not None:
            command += ["--threads", str(threads)]
        said, log = Path(folder) / "said", Path(folder) / "log"
        process = _start(command, _environment(token), said, log)
        try:
            url = _await_url(process, said, log)
            with Client(url, token or "", patience=patience) as client:
                yield client
        finally:
            _stop(process)


def _find(program: str | os.PathLike[str] | None) -> str:
    wanted = os.fspath(program) if program is not None else os.environ.get("STRAINSITE_BIN") or "strainsite"
    found = shutil.which(wanted)
    if found is None:
        raise LocalServerError(
            f"the program {wanted!r} isn't there or can't be run: build it with `make build`, and say where it is as "
            "local(program=...), in STRAINSITE_BIN, or by the PATH"
        )
    return found


def _environment(token: str | None) -> dict[str, str]:
    dropped = {f"STRAINSITE_{name}" for name in _NOT_INHERITED}
    environment = {name: value for name, value in os.environ.items() if name not in dropped}
    # In the environment, unlike among the arguments, no list of processes shows it.
    return environment | ({"STRAINSITE_TOKEN": token} if token else {})


def _start(command: list[str], environment: dict[str, str], said: Path, log: Path) -> subprocess.Popen[bytes]:
    with said.open("wb") as stdout, log.open("wb") as stderr:
        try:
            return subprocess.Popen(
                command,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=stdout,
                stderr=stderr,
                # Ctrl-C interrupts the script, which then ends the service in its own time.
                start_new_session=True,
            )
        except OSError as error:
            raise LocalServerError(f"{command[0]} can't be started: {error}") from error


def _await_url(process: subprocess.Popen[bytes], said: Path, log: Path) -> str:
    end = time.monotonic() + _START_S
    while time.monotonic() < end:
        ended = process.poll() is not None
        match = re.search(r"^listening on (\S+)\n", said.read_text(errors="replace"), re.MULTILINE)
        if match is not None:
            return match[1]
        if ended:
            break
        time.sleep(0.01)
    state = "ended" if process.poll() is not None else f"isn't ready after {_START_S:g} s"
    words = log.read_text(errors="replace").strip()[-2000:]
    raise LocalServerError(f"the service {state} instead of starting: {words or 'it said nothing'}")


def _stop(process: subprocess.Popen[bytes]) -> None:
    process.terminate()
    try:
        process.wait(_STOP_S)
    except subprocess.TimeoutExpired:
        pass
    finally:
        # Also when the wait itself is interrupted; nothing happens to a process that has ended.
        process.kill()
        process.wait()
