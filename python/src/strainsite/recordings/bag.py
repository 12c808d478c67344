"""A ROS 2 bag: its topics, their types, its messages."""

from __future__ import annotations

import difflib
import re
from collections import defaultdict
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from strainsite.errors import BagError
from strainsite.views import extras

from .message_types import MessageTypes

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from pathlib import Path

_MOST_LISTED = 30
_SQLITE_HEAD = 100
_RECOVER = {
    ".mcap": "`mcap recover` writes what is whole of one that was cut off",
    ".db3": "`sqlite3 FILE .recover` writes what is whole of one that was cut off",
    "": "`ros2 bag reindex` writes its metadata.yaml anew, from files that are whole",
}


class Topic:
    """A topic of a bag.

    Attributes:
        name: Its name.
        connections: Those of rosbags that have its messages.
        types: The type of its messages; None where it isn't known.
        trouble: Why it isn't known.

    """

    def __init__(self, name: str, connections: Sequence[Any], definitions: Mapping[str, str]) -> None:
        self.name = name
        self.connections = connections
        self.types: MessageTypes | None = None
        self.trouble = ""
        self._store: Any = None
        names = sorted({str(connection.msgtype) for connection in connections})
        if len(names) > 1:
            self.trouble = f"has messages of {len(names)} types, {', '.join(names)}; one is read"
            return
        self.type_name = names[0]
        try:
            self._store = _typestore(connections[0], definitions)
        except Exception as error:  # noqa: BLE001 - a definition can be wrong in many ways
            self.trouble = f"has the type {names[0]}, whose definition can't be read: {error}"
            return
        if names[0] not in self._store.fielddefs:
            self.trouble = (
                f"has the type {names[0]}, which the bag doesn't define: give it as "
                f"definitions={{{names[0]!r}: 'float64[] data'}}, with the text of its .msg file"
            )
            return
        self.types = MessageTypes(names[0], self._store.fielddefs)

    def read(self, data: bytes) -> Any:  # noqa: ANN401 - a class that rosbags makes
        """The message of these bytes."""
        return self._store.deserialize_cdr(data, self.type_name)

    def described(self) -> str:
        """Its name, type and fields."""
        return f"{self.name} ({self.types.described() if self.types else self.trouble})"


class Bag:
    """An open bag.

    Attributes:
        path: Its file or folder.
        topics: Its topics by name.

    """

    def __init__(self, path: Path, reader: Any, definitions: Mapping[str, str]) -> None:  # noqa: ANN401 - rosbags'
        self.path = path
        self._reader = reader
        connections = defaultdict(list)
        for connection in reader.connections:
            connections[str(connection.topic)].append(connection)
        self.topics = {name: Topic(name, connections[name], definitions) for name in sorted(connections)}

    @property
    def is_empty(self) -> bool:
        """Whether it has no message."""
        return not self._reader.message_count

    def unknown(self, name: str) -> str:
        """A sentence on a topic that isn't there, with those that are."""
        close = difflib.get_close_matches(name, self.topics, 1)
        hint = f". Did you mean {close[0]}?" if close else ""
        listed = [topic.described() for topic in self.topics.values()]
        more = f"; and {len(listed) - _MOST_LISTED} more" if len(listed) > _MOST_LISTED else ""
        return f"the bag has no topic {name}; it has {'; '.join(listed[:_MOST_LISTED]) or 'none'}{more}{hint}"

    def messages(self, topics: Sequence[Topic]) -> Iterator[tuple[str, int, bytes]]:
        """Topic, time of receipt in ns, and bytes of each message of these topics.

        Raises:
            BagError: The file is damaged there.

        """
        connections = [connection for topic in topics for connection in topic.connections]
        with _read(self.path):
            for connection, received_ns, data in self._reader.messages(connections=connections):
                yield connection.topic, received_ns, data


@contextmanager
def opened(path: Path, definitions: Mapping[str, str]) -> Iterator[Bag]:
    """Opens a bag for the length of a block.

    Raises:
        BagError: It isn't there, is no bag, or is damaged.
        MissingExtra: The package rosbags isn't installed.

    """
    rosbag2 = extras.rosbag2()
    _check(path)
    with _read(path):
        reader = rosbag2.Reader(path)
        reader.open()
    try:
        yield Bag(path, reader, definitions)
    finally:
        reader.close()


def _check(path: Path) -> None:
    kinds = "a bag is an .mcap file, a .db3 file, or the folder of such files with its metadata.yaml"
    if not path.exists():
        raise BagError(path, [f"isn't there; {kinds}"])
    if path.is_dir():
        inside = sorted(entry for entry in path.iterdir() if entry.suffix in (".mcap", ".db3"))
        if not (path / "metadata.yaml").exists():
            named = ", ".join(entry.name for entry in inside)
            other = f", or name one of its files: {named}" if inside else f"; {kinds}"
            raise BagError(path, [f"is a folder without metadata.yaml: `ros2 bag reindex` writes it{other}"])
        for entry in inside:
            _check_file(entry)
        return
    if path.suffix == ".bag":
        raise BagError(path, ["is a bag of ROS 1: `rosbags-convert --src FILE --dst FOLDER` makes one of ROS 2 of it"])
    if path.suffix not in _RECOVER:
        raise BagError(path, [f"is no bag by its name; {kinds}"])
    _check_file(path)


def _check_file(path: Path) -> None:
    """Finds what readers of a file don't: messages that it lacks, or that lie beside it."""
    size = path.stat().st_size
    if not size:
        raise BagError(path, ["is a file without a byte: nothing was recorded, or nothing was copied"])
    if path.suffix != ".db3":
        return
    with path.open("rb") as file:
        head = file.read(_SQLITE_HEAD)
    # The size of a page, where 1 stands for 65536, and how many there are: sqlite reads what is left of a shorter file.
    page = int.from_bytes(head[16:18]) if head[16:18] != b"\0\1" else 65536
    whole = page * int.from_bytes(head[28:32])
    if size < whole:
        raise BagError(path, [f"can't be read: it has {size} of {whole} bytes; {_RECOVER['.db3']}"])
    log = path.with_name(f"{path.name}-wal")
    if log.exists() and log.stat().st_size:
        close = f"`sqlite3 {path.name} 'PRAGMA wal_checkpoint'` adds them"
        raise BagError(path, [f"wasn't closed: {log.name} has messages of it; {close}"])


@contextmanager
def _read(path: Path) -> Iterator[None]:
    """Tells of whatever rosbags meets in a file that isn't whole, in one way."""
    try:
        yield
    except (BagError, GeneratorExit):
        raise
    except Exception as error:
        # Damage shows as errors of rosbags, sqlite, the unpacking of bytes and the decompression.
        said = str(error).rstrip(".") or type(error).__name__
        raise BagError(path, [f"can't be read: {said}; {_RECOVER.get(path.suffix, _RECOVER[''])}"]) from error


def _typestore(connection: Any, definitions: Mapping[str, str]) -> Any:  # noqa: ANN401 - rosbags' types
    """The types that a connection's messages consist of: the bag's own, else those of ROS 2 and of the caller."""
    typesys = extras.typesys()
    form = connection.msgdef.format.name
    if form == "NONE":
        store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
        for name, text in definitions.items():
            store.register(typesys.get_types_from_msg(text, _whole(name)))
        return store
    store = typesys.get_typestore(typesys.Stores.EMPTY)
    text = connection.msgdef.data
    if form == "MSG":
        store.register(typesys.get_types_from_msg(text, connection.msgtype))
        return store
    rule = "=" * 80 + "\n"
    parts = [part.partition("\n")[2] for part in text.split(rule)[1:]] if text.startswith(f"{rule}IDL: ") else [text]
    types: dict[str, Any] = {}
    for part in parts:
        # Lines of the preprocessor name files that stand here, too; not every release of rosbags reads them.
        types.update(typesys.get_types_from_idl(re.sub(r"(?m)^[ \t]*#.*$", "", part)))
    store.register(types)
    return store


def _whole(name: str) -> str:
    """A type's name with its `msg`."""
    return name if name.count("/") != 1 else name.replace("/", "/msg/")
