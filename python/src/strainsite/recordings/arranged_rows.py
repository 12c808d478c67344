"""Rows of several topics: all their times, each with what came then."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainsite.errors import BagError

from .recording import Recording
from .stamps import Clock, Timed, rows

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from numpy.typing import NDArray

    from .asked_column import AskedColumn
    from .topic_stream import TopicStream

# The reader of recordings wants rows to be further apart.
_CLOSEST_S = 1e-9
# Delays that differ by more than this, s, are those of clocks that differ.
_OTHER_DELAY_S = 0.05


def arranged(path: Path, columns: Sequence[AskedColumn], streams: Mapping[str, TopicStream], clock: Clock) -> Recording:
    """The recording of what was read.

    Raises:
        BagError: A topic hasn't the clock that is asked for, times don't fit, or two columns have one name.

    """
    times = _times(path, columns, streams, clock)
    stamps_ns = rows([timed.stamps_ns for timed in times.values()])
    time_s = (stamps_ns - stamps_ns[0]) / 1e9
    faults = [*_apart(times), *_close(time_s)]
    signals: dict[str, NDArray[np.float64]] = {}
    forces: dict[str, NDArray[np.float64]] = {}
    for column in columns:
        timed = times[column.path.topic]
        places = np.searchsorted(stamps_ns, timed.stamps_ns, side="right") - 1
        for name, numbers in column.named():
            if name in signals or name in forces:
                faults.append(f"{column.path.text}: {name} stands twice; every column has a name of its own")
                continue
            cells = np.full(stamps_ns.size, np.nan)
            cells[places] = numbers[timed.order]
            (forces if column.is_force else signals)[name] = cells
    if faults:
        raise BagError(path, faults)
    return Recording(
        path=path,
        time_s=time_s,
        signals=signals,
        forces=forces,
        start_ns=int(stamps_ns[0]),
        topics=tuple(timed.times for timed in times.values()),
        notes=(*(note for timed in times.values() for note in timed.notes), *_clocks(times)),
    )


def _times(
    path: Path, columns: Sequence[AskedColumn], streams: Mapping[str, TopicStream], clock: Clock
) -> dict[str, Timed]:
    with_signals = {column.path.topic for column in columns if not column.is_force}
    faults = []
    times: dict[str, Timed] = {}
    for name, stream in streams.items():
        try:
            times[name] = stream.timed(clock, has_signals=name in with_signals)
        except ValueError as error:
            faults.append(f"{name}: {error}")
    if faults:
        raise BagError(path, faults)
    return times


def _apart(times: Mapping[str, Timed]) -> list[str]:
    """A fault where topics have no time in common."""
    latest = max(times.values(), key=lambda timed: int(timed.stamps_ns[0]))
    earliest = min(times.values(), key=lambda timed: int(timed.stamps_ns[-1]))
    if latest.stamps_ns[0] <= earliest.stamps_ns[-1]:
        return []
    told = [
        f"{timed.times.topic} from {int(timed.stamps_ns[0])} to {int(timed.stamps_ns[-1])} ns by {timed.times.by}"
        for timed in (earliest, latest)
    ]
    return [f"topics have no time in common: {' and '.join(told)}; clock='receive' takes one clock for all"]


def _close(time_s: NDArray[np.float64]) -> list[str]:
    """A fault where rows lie closer than doubles tell."""
    if (np.diff(time_s) >= _CLOSEST_S).all():
        return []
    detail = (
        f"times reach over {float(time_s[-1]):.6g} s, at whose end doubles don't tell rows apart: a stamp is far off; "
        "clock='receive' takes the times of receipt"
    )
    return [detail]


def _clocks(times: Mapping[str, Timed]) -> list[str]:
    """Notes where topics' times may be of different clocks."""
    headers = [name for name in times if times[name].times.clock == "header"]
    receipts = [name for name in times if name not in headers]
    if headers and receipts:
        note = (
            f"{', '.join(headers)} by stamps of headers, {', '.join(receipts)} by times of receipt, which are later "
            "by what lies between a sensor and the recorder; clock='receive' takes one clock for all"
        )
        return [note]
    delays = {name: delay for name in headers if (delay := times[name].times.delay_s) is not None}
    if delays and max(delays.values()) - min(delays.values()) > _OTHER_DELAY_S:
        told = ", ".join(f"{name} {delay:.3g} s" for name, delay in delays.items())
        return [f"messages were received later than their stamps say by {told}: their clocks may differ by as much"]
    return []
