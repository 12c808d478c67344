"""Requests to the service: the token, retries, and refusals as exceptions."""

from __future__ import annotations

import email.utils
import ipaddress
import json
import math
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import httpx

from strainsite.errors import AnswerError, ProblemError, ServerLost, StrainsiteError, problem

from .patience import Patience

if TYPE_CHECKING:
    import ssl
    from collections.abc import Iterator, Mapping

# What passes: too much at once, the disk full, a proxy whose service is being started again.
TRY_AGAIN = frozenset({429, 502, 503, 504, 507})
# Thousands of designs are checked for minutes before a sweep is taken in.
LONGEST_CHECK_S = 600.0
# A service that never answered is rather not there than about to come back.
_PATIENCE_AT_FIRST_S = 3.0
_PATIENCE_S = 30.0


class Transport:
    """One service, and how long to try to reach it.

    Every request of this client may be sent twice without harm: reads, changes and cancellations by their nature,
    submissions by their idempotency key. So all of them are retried when the connection fails or the service is busy.
    """

    def __init__(
        self,
        url: str,
        token: str,
        *,
        timeout: float,
        patience: float | None,
        verify: ssl.SSLContext | bool,
    ) -> None:
        try:
            parsed = httpx.URL(url)
        except httpx.InvalidURL as error:
            raise StrainsiteError(f"{url!r} isn't an address: {error}") from error
        if parsed.scheme not in ("http", "https") or not parsed.host:
            raise StrainsiteError(f"{url!r} isn't an address like http://127.0.0.1:8080")
        if not (token.isascii() and token.isprintable()):
            raise StrainsiteError("the token has characters that can't be sent in a header")
        self.url = str(parsed).rstrip("/")
        self._patience = patience
        self._timeout = timeout
        self._reached = False
        headers = {"Accept": "application/json, application/problem+json"}
        if token:
            headers["Authorization"] = f"Bearer {token}"
        self._http = httpx.Client(
            base_url=self.url,
            headers=headers,
            timeout=timeout,
            verify=verify,
            # A proxy of the environment can't reach this machine's own addresses.
            trust_env=not _is_loopback(parsed.host),
        )

    def close(self) -> None:
        """Closes the connections."""
        self._http.close()

    def patience(self) -> Patience:
        """Patience for a request that is sent now."""
        if self._patience is not None:
            return Patience(self._patience)
        return Patience(_PATIENCE_S if self._reached else _PATIENCE_AT_FIRST_S)

    def get(self, path: str, params: Mapping[str, str] | None = None) -> dict[str, Any]:
        """The JSON object at an address."""
        return _object(self.request("GET", path, params=params))

    def post(
        self,
        path: str,
        body: Mapping[str, Any] | None = None,
        *,
        key: str | None = None,
        params: Mapping[str, str] | None = None,
        timeout: float | None = None,
    ) -> dict[str, Any]:
        """The answer to a document, a JSON object; `timeout` counts where it is longer than the client's."""
        headers = {"Idempotency-Key": key} if key is not None else {}
        content = None
        if body is not None:
            headers["Content-Type"] = "application/json"
            content = json.dumps(body, allow_nan=False).encode()
        return _object(self.request("POST", path, content=content, headers=headers, params=params, timeout=timeout))

    def patch(self, path: str, change: Mapping[str, Any]) -> dict[str, Any]:
        """The JSON object with which a change is answered; the same change again changes nothing."""
        content = json.dumps(change, allow_nan=False).encode()
        return _object(self.request("PATCH", path, content=content, headers={"Content-Type": "application/json"}))

    def request(
        self,
        method: str,
        path: str,
        *,
        content: bytes | None = None,
        headers: Mapping[str, str] | None = None,
        params: Mapping[str, str] | None = None,
        timeout: float | None = None,
    ) -> httpx.Response:
        """Sends until it is answered for good, or the patience is over."""
        patience = self.patience()
        limit = max(self._timeout, timeout or 0.0)
        while True:
            try:
                response = self._http.request(
                    method, path, content=content, headers=headers, params=params, timeout=limit
                )
            except httpx.TransportError as error:
                if not patience.again():
                    raise self.lost(error, patience) from error
                continue
            self._reached = True
            if response.is_success:
                return response
            retry_after = seconds_to_wait(response.headers.get("retry-after"))
            if response.status_code not in TRY_AGAIN or not patience.again(retry_after):
                raise refusal(response)

    @contextmanager
    def stream(self, path: str, headers: Mapping[str, str], read_s: float) -> Iterator[httpx.Response]:
        """One attempt at an answer that is read as it comes; a broken connection is httpx's TransportError."""
        timeout = httpx.Timeout(self._timeout, read=read_s)
        with self._http.stream("GET", path, headers=headers, timeout=timeout) as response:
            self._reached = True
            if not response.is_success:
                response.read()
                raise refusal(response)
            yield response

    def lost(self, error: httpx.TransportError, patience: Patience) -> ServerLost:
        """What a user should know when nothing answers."""
        cause = str(error) or type(error).__name__
        advice = (
            "is it still running? Its studies are kept in its database: start it again on the same one"
            if self._reached
            else "is it running, and is this its address? Start it with `strainsite serve`, or use strainsite.local()"
        )
        return ServerLost(f"{self.url} doesn't answer, tried for {patience.seconds:g} s ({cause}): {advice}")


def refusal(response: httpx.Response) -> ProblemError:
    """The exception of an answer that is no success."""
    retry_after = seconds_to_wait(response.headers.get("retry-after"))
    try:
        document = response.json()
    except ValueError:
        document = None
    if not isinstance(document, dict):
        document = {"title": response.reason_phrase, "detail": response.text[:200] or "no reason was given"}
    return problem(response.status_code, document, retry_after=retry_after)


def seconds_to_wait(header: str | None) -> float | None:
    """A Retry-After header, in seconds from now."""
    if header is None:
        return None
    try:
        seconds = float(header)
    except ValueError:
        try:
            seconds = email.utils.parsedate_to_datetime(header).timestamp() - time.time()
        except ValueError:
            return None
    return max(seconds, 0.0) if math.isfinite(seconds) else None


def _object(response: httpx.Response) -> dict[str, Any]:
    try:
        value = response.json()
    except ValueError as error:
        raise AnswerError(f"{response.request.url} answered something that isn't JSON") from error
    if not isinstance(value, dict):
        raise AnswerError(f"{response.request.url} answered something that isn't a JSON object")
    return value


def _is_loopback(host: str) -> bool:
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False
