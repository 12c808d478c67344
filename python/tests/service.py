"""The real program, started, killed and started again by tests; and a way to it on which things go wrong."""

from __future__ import annotations

import http.client
import http.server
import os
import re
import socket
import subprocess
import sys
import threading
import time
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

Trouble = str | int | tuple[int, dict[str, str]] | None
ROOT = Path(__file__).resolve().parents[2]
BINARY = Path(os.environ.get("STRAINSITE_BIN") or ROOT / "target/release/strainsite").resolve()


def said_by(script: Sequence[str | Path], folder: Path, timeout_s: float, **environment: str) -> str:
    """What Python prints when it runs a script in a folder."""
    ran = subprocess.run(
        [sys.executable, *script],
        cwd=folder,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        timeout=timeout_s,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class Service:
    """One process on one port and database, for as often as it is started."""

    def __init__(self, folder: Path, *arguments: str, token: str | None = None) -> None:
        self.database = folder / "service.db"
        self.port = free_port()
        self.url = f"http://127.0.0.1:{self.port}"
        self._said = folder / "said"
        self._log = folder / "log"
        self._arguments = arguments
        self._environment = {name: value for name, value in os.environ.items() if not name.startswith("STRAINSITE_")}
        if token is not None:
            self._environment["STRAINSITE_TOKEN"] = token
        self._process: subprocess.Popen[bytes] | None = None

    def start(self) -> Service:
        command = [str(BINARY), "serve", "--addr", f"127.0.0.1:{self.port}", "--db", str(self.database)]
        with self._said.open("wb") as said, self._log.open("ab") as log:
            self._process = subprocess.Popen(
                [*command, *self._arguments], env=self._environment, stdout=said, stderr=log
            )
        end = time.monotonic() + 20
        while re.search(r"^listening on .*\n", self._said.read_text(), re.MULTILINE) is None:
            assert self._process.poll() is None, self._log.read_text()
            assert time.monotonic() < end, self._log.read_text()
            time.sleep(0.01)
        return self

    def kill(self) -> None:
        assert self._process is not None
        self._process.kill()
        self._process.wait()

    def stop(self) -> None:
        assert self._process is not None
        self._process.terminate()
        try:
            self._process.wait(20)
        finally:
            self.kill()


@contextmanager
def running(folder: Path, *arguments: str, token: str | None = None) -> Iterator[Service]:
    service = Service(folder, *arguments, token=token).start()
    try:
        yield service
    finally:
        service.stop()


class Way:
    """A proxy to a service. Each request takes the next of `troubles`, if there is one; all are noted.

    A trouble is "unheard" (the connection breaks before the service hears of it), "unanswered" (the service does what
    it is asked, and the connection breaks before it can say so), a status with headers instead of the service's answer,
    or a number of bytes after which the answer breaks off.
    """

    def __init__(self, target: str) -> None:
        self.troubles: list[Trouble] = []
        self.requests: list[tuple[str, str, dict[str, str]]] = []
        self._server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), self._handler(target.removeprefix("http://")))
        self._server.daemon_threads = True
        self.url = f"http://127.0.0.1:{self._server.server_port}"
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)

    def __enter__(self) -> Way:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._server.shutdown()
        self._server.server_close()

    def keys(self) -> list[str]:
        return [headers["idempotency-key"] for method, _, headers in self.requests if method == "POST"]

    def _handler(self, target: str) -> type[http.server.BaseHTTPRequestHandler]:
        way = self

        class Handler(_Passing):
            def _next(self) -> Trouble:
                way.requests.append((self.command, self.path, {k.lower(): v for k, v in self.headers.items()}))
                return way.troubles.pop(0) if way.troubles else None

        Handler.target = target
        return Handler


class _Passing(http.server.BaseHTTPRequestHandler):
    target: str

    def _next(self) -> Trouble:
        raise NotImplementedError

    def _pass(self) -> None:
        self.close_connection = True
        trouble = self._next()
        body = self.rfile.read(int(self.headers.get("content-length", 0)))
        if trouble == "unheard":
            return
        if isinstance(trouble, tuple):
            self._head(trouble[0], {"content-length": "0", **trouble[1]})
            return
        headers = {name: value for name, value in self.headers.items() if name.lower() not in ("host", "connection")}
        with closing(http.client.HTTPConnection(self.target, timeout=20)) as connection:
            connection.request(self.command, self.path, body, headers)
            with connection.getresponse() as answer:
                if trouble == "unanswered":
                    answer.read()
                else:
                    self._forward(answer, trouble if isinstance(trouble, int) else None)

    def _head(self, status: int, headers: dict[str, str]) -> None:
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()

    def _forward(self, answer: http.client.HTTPResponse, most: int | None) -> None:
        kept = {k: v for k, v in answer.getheaders() if k.lower() not in ("transfer-encoding", "connection", "date")}
        self._head(answer.status, kept)
        sent = 0
        while chunk := answer.read1(4096):
            part = chunk if most is None else chunk[: most - sent]
            self.wfile.write(part)
            self.wfile.flush()
            sent += len(part)
            if sent == most:
                return

    do_GET = do_POST = do_DELETE = _pass  # noqa: N815 - http.server's names

    def log_message(self, format: str, *args: object) -> None:
        """Says nothing."""
