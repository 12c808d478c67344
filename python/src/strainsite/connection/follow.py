"""Follows a study to its end: by its event stream, or by looking now and then where no stream is to be had."""

from __future__ import annotations

import json
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import httpx

from strainsite.errors import ProblemError

from .transport import TRY_AGAIN

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from .progress import Deadline, Progress
    from .transport import Transport

ENDED = frozenset({"done", "failed", "cancelled"})
# The service sends a sign of life every 15 s.
_QUIET_S = 45.0
# How soon to look again where there is no stream: often at first, for studies of a second.
_SHORTEST_S, _LONGEST_S = 0.1, 2.0
_TOO_MANY = 429


@dataclass(frozen=True)
class Event:
    """One event of a stream."""

    id: str | None
    kind: str
    data: dict[str, Any]


def parse(lines: Iterable[str]) -> Iterator[Event | None]:
    """Server-sent events; None for a line that is only a sign of life."""
    number: str | None = None
    kind, data = "message", list[str]()
    for line in lines:
        if not line:
            if data:
                yield Event(number, kind, _payload("\n".join(data)))
            kind, data = "message", []
            continue
        name, _, value = line.partition(":")
        value = value.removeprefix(" ")
        if name == "id":
            number = value
        elif name == "event":
            kind = value
        elif name == "data":
            data.append(value)
        yield None


def _payload(text: str) -> dict[str, Any]:
    try:
        value = json.loads(text)
    except ValueError:
        return {}
    return value if isinstance(value, dict) else {}


class Follower:
    """Follows one study; `run` comes back when it seems to have ended, and goes on where it was when called again."""

    def __init__(self, transport: Transport, path: str, deadline: Deadline, progress: Progress) -> None:
        self._transport = transport
        self._path = path
        self._deadline = deadline
        self._progress = progress
        self._patience = transport.patience()
        self._last: str | None = None

    def run(self, state: Callable[[], str]) -> None:
        """Follows until the end; `state` asks for the study's state, for when there is no stream."""
        while True:
            self._deadline.check()
            try:
                if self._read():
                    return
                error: Exception = httpx.RemoteProtocolError("its event stream ended before the study")
            except httpx.ReadTimeout as timeout:
                self._deadline.check()
                error = timeout
            except httpx.TransportError as broken:
                error = broken
            except ProblemError as problem:
                if problem.status == _TOO_MANY:
                    look(state, self._deadline)
                    return
                if problem.status not in TRY_AGAIN:
                    raise
                error = problem
            self._pause(error)

    def _pause(self, error: Exception) -> None:
        retry_after = error.retry_after if isinstance(error, ProblemError) else None
        if self._patience.again(retry_after, at_most=self._deadline.left()):
            return
        self._deadline.check()
        if isinstance(error, httpx.TransportError):
            raise self._transport.lost(error, self._patience) from error
        raise error

    def _read(self) -> bool:
        """Reads one stream; whether the study has ended."""
        headers = {"Accept": "text/event-stream"}
        if self._last is not None:
            headers["Last-Event-ID"] = self._last
        read_s = min(_QUIET_S, max(self._deadline.left(), 0.01))
        with self._transport.stream(f"{self._path}/events", headers, read_s) as response:
            if response.status_code == httpx.codes.NO_CONTENT:
                return True
            for event in parse(response.iter_lines()):
                self._patience.answered()
                self._deadline.check()
                if event is None:
                    continue
                self._last = event.id or self._last
                self._show(event)
                if event.kind in ENDED:
                    return True
        return False

    def _show(self, event: Event) -> None:
        done, total = event.data.get("done"), event.data.get("of")
        if event.kind in ("point-solved", "point-failed") and isinstance(done, int) and isinstance(total, int):
            self._progress.show(done, total)


def look(state: Callable[[], str], deadline: Deadline) -> None:
    """Asks for a state, less and less often, until it is one of an end."""
    pause = _SHORTEST_S
    while state() not in ENDED:
        deadline.check()
        time.sleep(min(pause, deadline.left()))
        pause = min(pause * 1.5, _LONGEST_S)
