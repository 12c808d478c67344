"""What studies, sweeps and estimators in the service have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Generic, Protocol, Self, TypeVar

from .answers.reading import read

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

    from .connection.transport import Transport

    class Summary(DataclassInstance, Protocol):
        """Where an entry stands."""

        @property
        def id(self) -> str:
            """Its identifier."""

        @property
        def name(self) -> str:
            """Its name in lists."""

        @property
        def state(self) -> str:
            """Whether it waits, runs or has ended."""


S = TypeVar("S", bound="Summary")


class Entry(Generic[S]):
    """An entry of one of the service's lists.

    Attributes:
        summary: Where it stood when this was last asked for; `state` and `refresh` ask again.

    """

    summary: S
    _kind: type[S]
    _list: ClassVar[str]

    def __init__(self, transport: Transport, summary: S) -> None:
        self._transport = transport
        self.summary = summary
        self._path = f"/v1/{self._list}/{summary.id}"

    def _take(self, document: dict[str, Any]) -> Self:
        """What the service says of it."""
        self.summary = read(self._kind, document)
        return self

    @property
    def id(self) -> str:
        """Its identifier."""
        return self.summary.id

    @property
    def name(self) -> str:
        """Its name in lists: as it was submitted, unless it was renamed."""
        return self.summary.name

    @property
    def state(self) -> str:
        """Asks the service: `queued`, `running`, `done`, `failed` or `cancelled`."""
        return self.refresh().summary.state

    def refresh(self) -> Self:
        """Asks the service where it stands."""
        return self._take(self._transport.get(self._path))

    def cancel(self) -> Self:
        """Cancels it; what is solved is kept. Nothing happens to one that has ended."""
        return self._take(self._transport.request("DELETE", self._path).json())

    def remove(self) -> None:
        """Removes it for good, at work or not, with all that no other entry has.

        Raises:
            ProblemError: It is a design of a sweep, with which it can be removed (409).

        """
        self._transport.request("DELETE", f"{self._path}?purge")

    def __repr__(self) -> str:
        """Name, state as last seen, identifier."""
        return f"{type(self).__name__}({self.name!r}, {self.summary.state}, {self.id})"


class ListedEntry(Entry[S]):
    """An entry that can be renamed, and left out of its list."""

    def rename(self, name: str) -> Self:
        """Gives it another name in lists; its document keeps the one that was submitted.

        Raises:
            ProblemError: It is no name: 1 to 200 characters without control characters (422).

        """
        return self._change({"name": name})

    def archive(self) -> Self:
        """Leaves it out of lists; nothing of it is lost."""
        return self._change({"archived": True})

    def unarchive(self) -> Self:
        """Takes it back into lists."""
        return self._change({"archived": False})

    def _change(self, change: dict[str, Any]) -> Self:
        return self._take(self._transport.patch(self._path, change))
