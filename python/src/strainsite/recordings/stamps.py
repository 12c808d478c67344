"""Times of a topic's messages: by which clock, and in which order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

Clock = Literal["auto", "header", "receive"]
"""Which time a message has: its header's stamp, that at which it was received, or the first where there is one."""

CLOSEST_NS = 2
"""Nanoseconds from which on two times are two rows: the reader of recordings wants more than one, which its doubles
may round off."""
_PAUSE_INTERVALS = 10


@dataclass(frozen=True)
class TopicTimes:
    """How the times of a topic's messages were found."""

    topic: str
    has_signals: bool
    """Whether signals are read from it."""
    clock: Literal["header", "receive"]
    """Whether times are stamps of headers, or those at which the recorder received the messages."""
    rows: int
    """Messages that are in the recording."""
    duplicates: int
    """Messages left out, as another one has their time."""
    late: int
    """Messages that came after one of a later time; they stand where their time belongs."""
    unstamped: int
    """Messages left out, as their header's stamp is zero while others are not."""
    rate_hz: float | None
    """Messages a second, pauses apart; None of fewer than two."""
    delay_s: float | None
    """Median of the time of receipt less the header's stamp; None without stamps."""

    @property
    def by(self) -> str:
        """Its clock in words."""
        return "stamps of headers" if self.clock == "header" else "times of receipt"


@dataclass(frozen=True)
class Timed:
    """Times of a topic's messages in rising order."""

    times: TopicTimes
    stamps_ns: NDArray[np.int64]
    order: NDArray[np.intp]
    """Which message of the bag each of them is."""
    notes: tuple[str, ...]
    """What a reader of the recording should know of them."""


def timed(
    topic: str,
    received_ns: NDArray[np.int64],
    header_ns: NDArray[np.int64] | None,
    clock: Clock,
    *,
    has_signals: bool,
) -> Timed:
    """Orders a topic's messages by the clock that was asked for.

    Args:
        topic: The topic.
        received_ns: When each message was received.
        header_ns: Stamp of each header; None where messages have none.
        clock: `auto` takes headers' stamps where there are any.
        has_signals: Whether signals are read from it.

    Raises:
        ValueError: Headers were asked for, and there are none, or all their stamps are zero.

    """
    notes: list[str] = []
    stamped = np.zeros(received_ns.size, dtype=bool) if header_ns is None else header_ns != 0
    by_header = clock != "receive" and bool(stamped.any())
    if clock != "receive" and not by_header:
        why = "its messages have no header" if header_ns is None else "all stamps of its headers are zero"
        if clock == "header":
            raise ValueError(f"{why}: clock='receive' takes the times at which they were received")
        notes.append(f"{topic} has times of receipt: {why}")
    kept = np.flatnonzero(stamped) if by_header else np.arange(received_ns.size)
    found = (header_ns if by_header and header_ns is not None else received_ns)[kept]
    delay_s = None
    if header_ns is not None and stamped.any():
        delay_s = float(np.median((received_ns - header_ns)[stamped])) / 1e9
    sequence = np.argsort(found, kind="stable")
    late = int((found < np.maximum.accumulate(found)).sum())
    rising = found[sequence]
    new = np.diff(rising, prepend=rising[0] - CLOSEST_NS) >= CLOSEST_NS
    times = TopicTimes(
        topic=topic,
        has_signals=has_signals,
        clock="header" if by_header else "receive",
        rows=int(new.sum()),
        duplicates=int(new.size - new.sum()),
        late=late,
        unstamped=int(received_ns.size - kept.size),
        rate_hz=_rate(rising[new]),
        delay_s=delay_s,
    )
    return Timed(times, rising[new], kept[sequence[new]], (*notes, *_told(times)))


def rows(stamps_ns: list[NDArray[np.int64]]) -> NDArray[np.int64]:
    """Times of the rows: all of them, where one closer than two nanoseconds to a row is of that row."""
    every = np.unique(np.concatenate(stamps_ns))
    if (np.diff(every) >= CLOSEST_NS).all():
        return every
    found = [int(every[0])]
    for stamp in every.tolist():
        if stamp - found[-1] >= CLOSEST_NS:
            found.append(stamp)
    return np.array(found, dtype=np.int64)


def _rate(stamps_ns: NDArray[np.int64]) -> float | None:
    intervals = np.diff(stamps_ns)
    if intervals.size == 0:
        return None
    regular = intervals[intervals <= _PAUSE_INTERVALS * np.median(intervals)]
    return 1e9 / float(regular.mean())


def _told(times: TopicTimes) -> list[str]:
    every = times.rows + times.duplicates + times.unstamped
    told = []
    if times.duplicates:
        told.append(f"{times.topic}: {times.duplicates} of {every} messages are left out, as others have their times")
    if times.unstamped:
        told.append(f"{times.topic}: {times.unstamped} of {every} messages are left out, as their stamps are zero")
    if times.late:
        told.append(f"{times.topic}: {times.late} of {every} messages came late and stand where their times belong")
    return told
