"""Types of messages: whether a path leads to numbers in them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from .field_path import FieldPath, Step, written

if TYPE_CHECKING:
    from collections.abc import Sequence

_NUMBERS = {
    "bool",
    "byte",
    "char",
    "float32",
    "float64",
    *(f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)),
}
_HEADER = "std_msgs/msg/Header"


class MessageTypes:
    """The type of a topic's messages, with the types of their fields.

    Args:
        name: Name of the type, as `geometry_msgs/msg/WrenchStamped`.
        definitions: Fields by name of a type, as rosbags' typestore has them.

    """

    def __init__(self, name: str, definitions: dict[str, Any]) -> None:
        self.name = name
        self._definitions = definitions

    @property
    def has_header(self) -> bool:
        """Whether each message has a header, and in it a stamp."""
        return any(name == "header" and _type(kind) == _HEADER for name, kind in self._fields(self.name))

    def described(self) -> str:
        """The type with its fields, on one line."""
        return f"{self.name}: {self._listed(self.name)}"

    def checked(self, path: FieldPath) -> FieldPath:
        """The path where it leads to numbers; one to a whole array has a range of all its elements added.

        Raises:
            ValueError: It leads to none; the message says what is there.

        """
        kind: Any = (_Node.NAME, self.name)
        for at, step in enumerate(path.steps):
            kind = self._within(kind, step, path.topic + written(path.steps[:at]))
        if _node(kind) in (_Node.ARRAY, _Node.SEQUENCE) and _type(kind[1][0]) in _NUMBERS:
            if any(isinstance(step, slice) for step in path.steps):
                raise ValueError("leads to an array for each element of its range; take one element of it by [0]")
            return replace(path, steps=(*path.steps, slice(None, None)))
        if _type(kind) not in _NUMBERS:
            raise ValueError(f"is no number but {self._what(kind)}")
        return path

    def _within(self, kind: Any, step: Step, place: str) -> Any:  # noqa: ANN401 - rosbags' description of a type
        node = _node(kind)
        if node == _Node.NAME:
            fields = dict(self._fields(kind[1]))
            if isinstance(step, str):
                # A field that is called like a word of Python has a bar behind it.
                for name in (step, f"{step}_"):
                    if name in fields:
                        return fields[name]
                raise ValueError(f"has no field {step!r}: {place} has {self._listed(kind[1])}")
            raise ValueError(f"takes an element of {place}, which is a message with {self._listed(kind[1])}")
        if node == _Node.BASE:
            raise ValueError(f"goes on behind {place}, which is {_type(kind)}")
        inner, length = kind[1]
        if isinstance(step, str):
            detail = f"takes a field of {place}, which is an array: take an element by [0], or some by [0:12]"
            raise ValueError(detail)  # noqa: TRY004 - what a caller wrote, not what a program passed
        last = step if isinstance(step, int) else (step.stop or (step.start or 0) + 1) - 1
        if node == _Node.ARRAY and last >= length:
            raise ValueError(f"takes element {last} of {place}, which has {length}, from 0 on")
        return inner

    def _what(self, kind: Any) -> str:  # noqa: ANN401
        if _node(kind) == _Node.NAME:
            return f"a message with {self._listed(kind[1])}"
        if _node(kind) == _Node.BASE:
            return _type(kind)
        inner = self._what(kind[1][0])
        return f"an array, each element {inner}: take an element by [0], or some by [0:12]"

    def _fields(self, name: str) -> Sequence[tuple[str, Any]]:
        fields: Sequence[tuple[str, Any]]
        _, fields = self._definitions.get(name, ((), ()))
        return fields

    def _listed(self, name: str) -> str:
        return ", ".join(f"{field} ({_type(kind)})" for field, kind in self._fields(name)) or "no field"


class _Node:
    """Names of rosbags' kinds of types."""

    BASE = "BASE"
    NAME = "NAME"
    ARRAY = "ARRAY"
    SEQUENCE = "SEQUENCE"


def _node(kind: Any) -> str:  # noqa: ANN401
    return str(getattr(kind[0], "name", kind[0]))


def _type(kind: Any) -> str:  # noqa: ANN401
    """A type as it is written in a definition."""
    node = _node(kind)
    if node == _Node.NAME:
        return str(kind[1])
    if node == _Node.BASE:
        return str(kind[1][0])
    inner, length = kind[1]
    return f"{_type(inner)}[{length}]" if node == _Node.ARRAY else f"{_type(inner)}[]"
