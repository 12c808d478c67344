"""Bags by two writers that share no code: rosbags' own, and mcap-ros2-support."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from mcap_ros2.writer import Writer as OtherWriter

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

# None of them has types throughout.
mcap_writer: Any = importlib.import_module("mcap.writer")
rosbag2: Any = importlib.import_module("rosbags.rosbag2")
typesys: Any = importlib.import_module("rosbags.typesys")

START_NS = 1_700_000_000_123_456_789
FILMS = "rig_msgs/msg/Films"
WRENCH = "geometry_msgs/msg/WrenchStamped"
PLAIN = "std_msgs/msg/Float64"
DEFINITIONS = {
    FILMS: "std_msgs/Header header\nstring name\nfloat64[] data\nfloat32[3] small\nrig_msgs/Cell[] cells\n",
    "rig_msgs/msg/Cell": "float64 strain\nbool on\n",
    WRENCH: "std_msgs/Header header\ngeometry_msgs/Wrench wrench\n",
    "geometry_msgs/msg/Wrench": "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n",
    "geometry_msgs/msg/Vector3": "float64 x\nfloat64 y\nfloat64 z\n",
    "std_msgs/msg/Header": "builtin_interfaces/Time stamp\nstring frame_id\n",
    "builtin_interfaces/msg/Time": "int32 sec\nuint32 nanosec\n",
    PLAIN: "float64 data\n",
}
PARTS = {
    FILMS: ["std_msgs/msg/Header", "builtin_interfaces/msg/Time", "rig_msgs/msg/Cell"],
    WRENCH: [
        "std_msgs/msg/Header",
        "builtin_interfaces/msg/Time",
        "geometry_msgs/msg/Wrench",
        "geometry_msgs/msg/Vector3",
    ],
    PLAIN: [],
}


@dataclass(frozen=True)
class Message:
    """A message of a bag that is to be written."""

    topic: str
    type: str
    received_ns: int
    value: dict[str, Any]


def header(stamp_ns: int) -> dict[str, Any]:
    return {"stamp": {"sec": stamp_ns // 10**9, "nanosec": stamp_ns % 10**9}, "frame_id": "rig"}


def films(
    stamp_ns: int, data: Sequence[float], *, received_ns: int | None = None, topic: str = "/films", **other: Any
) -> Message:
    value = {"header": header(stamp_ns), "name": "film", "data": list(data), "small": [0.1, 0.2, 0.3], "cells": []}
    return Message(topic, FILMS, stamp_ns + 300_000 if received_ns is None else received_ns, value | other)


def wrench(stamp_ns: int, fz: float, *, received_ns: int | None = None, topic: str = "/ft/wrench") -> Message:
    zero = {"x": 0.0, "y": 0.0, "z": 0.0}
    value = {"header": header(stamp_ns), "wrench": {"force": {**zero, "z": fz}, "torque": zero}}
    return Message(topic, WRENCH, stamp_ns + 500_000 if received_ns is None else received_ns, value)


def plain(received_ns: int, number: float, *, topic: str) -> Message:
    return Message(topic, PLAIN, received_ns, {"data": number})


def by_rosbags(
    folder: Path, messages: Sequence[Message], plugin: str = "MCAP", *, compressed: bool = False, empty: str = ""
) -> Path:
    """A folder with the bag that rosbags writes; a topic `empty` of films has no message."""
    store = typesys.get_typestore(typesys.Stores.EMPTY)
    types: dict[str, Any] = {}
    for name, text in DEFINITIONS.items():
        types.update(typesys.get_types_from_msg(text, name))
    types.pop("builtin_interfaces/msg/Time")
    store.register(types)
    writer = rosbag2.Writer(folder, version=9, storage_plugin=rosbag2.StoragePlugin[plugin])
    if compressed:
        writer.set_compression(rosbag2.CompressionMode.STORAGE, rosbag2.CompressionFormat.ZSTD)
    with writer:
        topics = {message.topic: message.type for message in messages} | ({empty: FILMS} if empty else {})
        connections = {topic: writer.add_connection(topic, kind, typestore=store) for topic, kind in topics.items()}
        for message in messages:
            made = _made(store, message.type, message.value)
            writer.write(connections[message.topic], message.received_ns, store.serialize_cdr(made, message.type))
    return folder


def by_another(path: Path, messages: Sequence[Message]) -> Path:
    """A file that mcap-ros2-support writes."""
    rule = "\n" + "=" * 80 + "\n"
    with path.open("wb") as out, OtherWriter(out) as writer:
        schemas = {}
        for message in messages:
            if message.type not in schemas:
                parts = [f"MSG: {name.replace('/msg/', '/')}\n{DEFINITIONS[name]}" for name in PARTS[message.type]]
                text = rule.join([DEFINITIONS[message.type], *parts])
                schemas[message.type] = writer.register_msgdef(message.type, text)
            writer.write_message(
                message.topic, schemas[message.type], message.value, message.received_ns, message.received_ns
            )
    return path


def by_channels(path: Path, channels: Sequence[tuple[str, str, str]], messages: Sequence[Message]) -> Path:
    """A file with several channels for one topic, each a type, the language of its definition, and the definition."""
    store = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    for name in ("rig_msgs/msg/Cell", FILMS):
        store.register(typesys.get_types_from_msg(DEFINITIONS[name], name))
    with path.open("wb") as out:
        writer = mcap_writer.Writer(out)
        writer.start("ros2")
        numbers = [
            writer.register_channel(messages[0].topic, "cdr", writer.register_schema(kind, language, text.encode()))
            for kind, language, text in channels
        ]
        for at, message in enumerate(messages):
            data = bytes(store.serialize_cdr(_made(store, message.type, message.value), message.type))
            writer.add_message(numbers[at % len(numbers)], message.received_ns, data, message.received_ns)
        writer.finish()
    return path


def _made(store: Any, kind: str, value: dict[str, Any]) -> Any:
    """A message of rosbags' classes."""
    import numpy as np

    fields = {}
    for name, (node, description) in store.fielddefs[kind][1]:
        given = value[name]
        if node.name == "NAME":
            given = _made(store, description, given)
        elif node.name != "BASE":
            inner, inner_kind = description[0]
            if inner.name == "NAME":
                given = [_made(store, inner_kind, part) for part in given]
            else:
                given = np.array(given, dtype=inner_kind[0])
        fields[name] = given
    return store.types[kind](**fields)
