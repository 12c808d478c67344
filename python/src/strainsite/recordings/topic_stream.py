"""Messages of one topic as they come: their times, and the numbers of every path that leads into them."""

from __future__ import annotations

from array import array
from typing import TYPE_CHECKING

import numpy as np

from .stamps import Clock, Timed, timed

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from .bag import Topic
    from .field_values import FieldValues


class TopicStream:
    """Times and numbers of a topic's messages, in the order of the bag.

    Attributes:
        topic: The topic.
        fields: The paths into its messages, each with its numbers.
        fault: Why a message couldn't be read; nothing is read any more from there on.

    """

    def __init__(self, topic: Topic) -> None:
        self.topic = topic
        self.fields: list[FieldValues] = []
        self.fault: str | None = None
        self._received_ns = array("q")
        self._has_header = topic.types is not None and topic.types.has_header
        self._header_ns = array("q")

    def add(self, received_ns: int, data: bytes) -> None:
        """Takes the next message."""
        if self.fault is not None:
            return
        try:
            self._received_ns.append(received_ns)
            message = self.topic.read(data)
        except Exception as error:  # noqa: BLE001 - bytes that aren't what the type says fail in many ways
            place = f"message {len(self._received_ns)} of {self.topic.name}"
            self.fault = f"{place} can't be read as {self.topic.type_name}: {error}"
            return
        if self._has_header:
            stamp = message.header.stamp
            self._header_ns.append(stamp.sec * 1_000_000_000 + stamp.nanosec)
        for field in self.fields:
            field.add(message)

    def faults(self) -> Iterable[str]:
        """What was wrong with its messages."""
        if self.fault is not None:
            yield self.fault
        elif not self._received_ns:
            yield f"{self.topic.name} has no message: nothing was published while the bag was recorded"
        for field in self.fields:
            if field.fault is not None:
                yield f"{field.path.text}: {field.fault}"

    def timed(self, clock: Clock, *, has_signals: bool) -> Timed:
        """Its messages in the order of their times.

        Raises:
            ValueError: It hasn't the clock that is asked for.

        """
        header_ns = _whole_numbers(self._header_ns) if self._has_header else None
        return timed(self.topic.name, _whole_numbers(self._received_ns), header_ns, clock, has_signals=has_signals)


def _whole_numbers(numbers: array[int]) -> NDArray[np.int64]:
    return np.frombuffer(numbers, dtype=np.int64)
