"""What can go wrong, each with the problem document or the study that it is about."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping, Sequence


class StrainsiteError(Exception):
    """Anything that this package raises on purpose."""


class DocumentError(StrainsiteError):
    """A study document that can't be read, or an override that doesn't fit into it; nothing was sent."""


class BagError(StrainsiteError):
    """A bag that no recording can be made of; its text lists every fault.

    Attributes:
        path: The bag.
        faults: Each with what is wrong, where, and what would be right.

    """

    def __init__(self, path: str | os.PathLike[str], faults: Sequence[str]) -> None:
        self.path = path
        self.faults = tuple(faults)
        # What it is made of, so that it can be sent to another process.
        super().__init__(path, self.faults)

    def __str__(self) -> str:
        """The fault, or every one on a line of its own."""
        if len(self.faults) == 1:
            return f"{self.path}: {self.faults[0]}"
        return "\n".join([f"{self.path} has {len(self.faults)} faults", *(f"  {fault}" for fault in self.faults)])


class ServerLost(StrainsiteError):
    """The service didn't answer for as long as the client's patience lasts."""


class LocalServerError(StrainsiteError):
    """A local server couldn't be started."""


class AnswerError(StrainsiteError):
    """The service's answer isn't what this client knows: another version, or something stands between."""


@dataclass(frozen=True)
class Fault:
    """One fault of a document."""

    pointer: str
    """JSON pointer into the document that was sent; empty for the whole."""
    detail: str
    """What is wrong, and what would be right."""

    def __str__(self) -> str:
        """The place and the fault, on one line."""
        return f"{self.pointer}: {self.detail}" if self.pointer else self.detail


class ProblemError(StrainsiteError):
    """A request that the service refused; its text lists every fault of the document.

    Attributes:
        status: HTTP status.
        title: The status in words.
        detail: A sentence for people.
        errors: Every fault of the document, with its JSON pointer.
        request_id: The request's identifier in the service's log.
        retry_after: Seconds after which to try again, where the service said so.
        document: The whole problem document.

    """

    hint = ""

    def __init__(self, status: int, document: Mapping[str, Any], *, retry_after: float | None = None) -> None:
        self.status = status
        self.title = str(document.get("title") or "Error")
        self.detail = str(document.get("detail") or "the service gave no reason")
        self.errors = tuple(
            Fault(str(fault.get("pointer", "")), str(fault.get("detail", ""))) for fault in document.get("errors") or ()
        )
        request_id = document.get("request_id")
        self.request_id = None if request_id is None else str(request_id)
        self.retry_after = retry_after
        self.document = dict(document)
        # What it is made of, so that it can be sent to another process.
        super().__init__(status, self.document)

    def __str__(self) -> str:
        """The problem, every fault on a line of its own, and the request."""
        lines = [f"{self.status} {self.title}: {self.detail}{self.hint}"]
        lines += [f"  {fault}" for fault in self.errors]
        if self.request_id is not None:
            lines.append(f"  (request {self.request_id})")
        return "\n".join(lines)


class Refused(ProblemError):
    """401 or 403: the token is missing or wrong, or the service doesn't answer under this name."""

    hint = "\n  give it as Client(token=...) or in the environment variable STRAINSITE_TOKEN"

    def __init__(self, status: int, document: Mapping[str, Any], *, retry_after: float | None = None) -> None:
        if status != 401:  # noqa: PLR2004 - a token doesn't help against 403
            self.hint = ""
        super().__init__(status, document, retry_after=retry_after)


class NotFound(ProblemError):
    """404: there is no such study, or it hasn't what was asked for; `detail` says which."""


class InvalidDocument(ProblemError):
    """422: the document has faults, all of them in `errors`; or it would take more memory than there is."""


class Busy(ProblemError):
    """429, 503 or 507: the service couldn't take this on for as long as the client's patience lasts."""


class StudyFailed(StrainsiteError):
    """A study or sweep ended without an answer.

    Attributes:
        id: Its identifier.
        reason: Why, a sentence.

    """

    def __init__(self, identifier: str, reason: str) -> None:
        self.id = identifier
        self.reason = reason
        super().__init__(identifier, reason)

    def __str__(self) -> str:
        """Which, and why."""
        return f"{self.id} failed: {self.reason}"


class FitFailed(StrainsiteError):
    """A fit ended without an estimator.

    Attributes:
        id: Its identifier.
        reason: Why, a sentence.

    """

    def __init__(self, identifier: str, reason: str) -> None:
        self.id = identifier
        self.reason = reason
        super().__init__(identifier, reason)

    def __str__(self) -> str:
        """Which, and why."""
        return f"{self.id} failed: {self.reason}"


class StudyCancelled(StrainsiteError):
    """A study or sweep was cancelled; what it has solved is kept, and the same document finds it.

    Attributes:
        id: Its identifier.

    """

    def __init__(self, identifier: str) -> None:
        self.id = identifier
        super().__init__(identifier)

    def __str__(self) -> str:
        """Which."""
        return f"{self.id} was cancelled"


class WaitTimeout(StrainsiteError, TimeoutError):
    """The time given to `wait` was over; the study or sweep goes on.

    Attributes:
        id: Its identifier.
        seconds: The time that it was given.

    """

    def __init__(self, identifier: str, seconds: float) -> None:
        self.id = identifier
        self.seconds = seconds
        super().__init__(identifier, seconds)

    def __str__(self) -> str:
        """Which, after how long, and what to do."""
        return f"{self.id} isn't done after {self.seconds:g} s; it goes on: wait() again"


class MissingExtra(StrainsiteError, ImportError):
    """A method needs a package that isn't installed; the message has the command that installs it."""


def problem(status: int, document: Mapping[str, Any], *, retry_after: float | None = None) -> ProblemError:
    """The exception of a status."""
    kinds: dict[int, type[ProblemError]] = {
        401: Refused,
        403: Refused,
        404: NotFound,
        422: InvalidDocument,
        429: Busy,
        503: Busy,
        507: Busy,
    }
    return kinds.get(status, ProblemError)(status, document, retry_after=retry_after)
