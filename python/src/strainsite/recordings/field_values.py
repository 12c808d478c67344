"""Numbers of one path, message by message."""

from __future__ import annotations

from array import array
from typing import TYPE_CHECKING, Any

import numpy as np

from .field_path import FieldPath, written

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray


class FieldValues:
    """What a path leads to in each message of its topic.

    Attributes:
        path: The path, checked against the type of the messages.
        fault: What was wrong with a message, and with which; nothing is read any more from there on.

    """

    def __init__(self, path: FieldPath) -> None:
        self.path = path
        self.fault: str | None = None
        self._values = array("d")
        self._count = 0
        # Length of each array on the way as it is in the first message.
        self._lengths: dict[int, int] = {}

    def add(self, message: object) -> None:
        """Takes the numbers of the next message."""
        if self.fault is not None:
            return
        self._count += 1
        try:
            self._values.extend(self._found(message, 0))
        except _Unlike as unlike:
            self.fault = str(unlike)

    @property
    def elements(self) -> list[int] | None:
        """Places of the elements that the path's range has; None where the path leads to one number."""
        for at, step in enumerate(self.path.steps):
            if isinstance(step, slice):
                return list(range(self._lengths.get(at, 0)))[step]
        return None

    def columns(self) -> NDArray[np.float64]:
        """The numbers, of shape (columns, messages)."""
        width = 1 if self.elements is None else len(self.elements)
        return np.frombuffer(self._values, dtype=np.float64).reshape(-1, width).T

    def _found(self, value: Any, at: int) -> Sequence[float]:  # noqa: ANN401 - a part of a message
        steps = self.path.steps
        for place in range(at, len(steps)):
            step = steps[place]
            if isinstance(step, str):
                value = getattr(value, step)
                continue
            self._check_length(len(value), place)
            value = value[step]
            if isinstance(step, slice):
                if place == len(steps) - 1:
                    numbers: Sequence[float] = value.tolist() if isinstance(value, np.ndarray) else value
                    return numbers
                return [number for part in value for number in self._found(part, place + 1)]
        return (value,)

    def _check_length(self, length: int, place: int) -> None:
        known = self._lengths.get(place)
        if known == length:
            return
        name = self.path.topic + written(self.path.steps[:place])
        if known is not None:
            raise _Unlike(
                f"{name} has {length} elements in message {self._count} of the topic, and {known} before: "
                "columns need as many in all"
            )
        step = self.path.steps[place]
        last = step.stop or (step.start or 0) + 1 if isinstance(step, slice) else int(step) + 1
        if length < last:
            raise _Unlike(f"{name} has {length} elements; the path takes those up to element {last - 1}, from 0 on")
        self._lengths[place] = length


class _Unlike(Exception):
    """A message whose arrays don't fit the path, or the messages before it."""
