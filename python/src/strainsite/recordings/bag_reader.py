"""Recordings of ROS 2 bags."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from strainsite.errors import BagError

from . import column_names
from .arranged_rows import arranged
from .asked_column import AskedColumn
from .bag import opened
from .field_path import FieldPath
from .field_values import FieldValues
from .topic_stream import TopicStream

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping, Sequence

    from .bag import Bag
    from .recording import Recording
    from .stamps import Clock


def from_bag(
    path: str | os.PathLike[str],
    signals: str | Sequence[str] | Mapping[str, str],
    forces: Mapping[str, str] | None = None,
    *,
    clock: Clock = "auto",
    definitions: Mapping[str, str] | None = None,
) -> Recording:
    """Signals and forces of a ROS 2 bag as a recording, by the package rosbags (`pip install 'strainsite[bags]'`).

    A path names a topic and a field of its messages: `/ft/wrench.wrench.force.z` a number, `/films.data[3]` an
    element, `/films.data[0:12]` twelve of them, `/films.data` all, `/cells.cells[0:4].strain` a number of each of four.

    Rows are the times of all topics, and a cell is empty where its topic has nothing at that time. Nothing is
    interpolated: `strainsite force` does that, with the lines of `Recording.recipe`. Topics whose messages have the
    same stamps share rows, and need none.

    Args:
        path: An `.mcap` file, a `.db3` file, or the folder of a bag with its `metadata.yaml`.
        signals: Paths, whose columns are named by topic and field, as `films_0` to `films_11`; or paths by name, where
            a path to several numbers has its elements behind the name.
        forces: Paths to a number each by name of the force, as `{"fz_n": "/ft/wrench.wrench.force.z"}`; they must be
            in newtons.
        clock: Which time a message has. `header`: its header's stamp. `receive`: that at which it was recorded.
            `auto`: for each topic the header's stamp, or else the time of receipt. `Recording.topics` says which it is.
        definitions: Text of `.msg` files by type, `{"rig_msgs/msg/Films": "float64[] data"}`, for types that the bag
            doesn't define, as bags of ROS 2 Humble and before don't.

    Raises:
        BagError: The bag can't be read, or has no such topics or numbers; all faults that are found are in it.
        MissingExtra: The package rosbags isn't installed.

    """
    path = Path(path)
    faults: list[str] = []
    columns = _asked(signals, forces or {}, faults)
    if clock not in ("auto", "header", "receive"):
        faults.append(f"clock must be 'auto', 'header' or 'receive'; it is {clock!r}")
    with opened(path, definitions or {}) as bag:
        streams = _streams(bag, columns, faults)
        if faults:
            raise BagError(path, faults)
        for topic, received_ns, data in bag.messages([stream.topic for stream in streams.values()]):
            streams[topic].add(received_ns, data)
    for stream in streams.values():
        faults.extend(stream.faults())
    if faults:
        raise BagError(path, faults)
    return arranged(path, columns, streams, clock)


def _asked(
    signals: str | Sequence[str] | Mapping[str, str], forces: Mapping[str, str], faults: list[str]
) -> list[AskedColumn]:
    """The paths that were asked for."""
    named: list[tuple[str | None, str, bool]] = []
    if isinstance(signals, str):
        named.append((None, signals, False))
    elif hasattr(signals, "items"):
        named += [(name, text, False) for name, text in signals.items()]
    else:
        named += [(None, text, False) for text in signals]
    if not named:
        faults.append("no signal is named; signals=['/films.data[0:12]'] takes twelve")
    named += [(name, text, True) for name, text in forces.items()]
    columns = []
    for name, text, is_force in named:
        if name is not None and (why := column_names.unfit(name)):
            faults.append(f"{name!r}: {why}")
        if name is not None and not is_force and column_names.is_force(name):
            faults.append(f"{name!r}: is a name that the reader of recordings takes for a force; choose another")
        try:
            columns.append(AskedColumn(FieldPath.parse(text), name, is_force))
        except ValueError as error:
            faults.append(f"{text}: {error}")
    return columns


def _streams(bag: Bag, columns: Sequence[AskedColumn], faults: list[str]) -> dict[str, TopicStream]:
    """The topics that are to be read, each with the paths into it."""
    if bag.is_empty:
        faults.append("the bag has no message: nothing was recorded")
    streams: dict[str, TopicStream] = {}
    untold = set()
    for column in columns:
        path = column.path
        topic = bag.topics.get(path.topic)
        if topic is None or topic.types is None:
            if path.topic not in untold:
                faults.append(bag.unknown(path.topic) if topic is None else f"{path.topic} {topic.trouble}")
            untold.add(path.topic)
            continue
        try:
            checked = topic.types.checked(path)
        except ValueError as error:
            faults.append(f"{path.text}: {error}")
            continue
        if column.is_force and any(isinstance(step, slice) for step in checked.steps):
            faults.append(f"{path.text}: leads to several numbers; a force is one of them, as {path.topic}.data[0]")
            continue
        column.values = FieldValues(checked)
        streams.setdefault(topic.name, TopicStream(topic)).fields.append(column.values)
    return streams
