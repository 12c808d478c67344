"""A progress bar on terminals and in notebooks, and the time allowed for waiting."""

from __future__ import annotations

import math
import sys
import time
from typing import TYPE_CHECKING, Any

from tqdm.auto import tqdm

from strainsite.errors import WaitTimeout

if TYPE_CHECKING:
    from types import TracebackType


class Progress:
    """Points done of all, and the time left; silent where nobody could watch it, as in a pipe."""

    def __init__(self, name: str, *, shown: bool, unit: str = "point") -> None:
        watched = sys.stderr.isatty() or "ipykernel" in sys.modules
        self._words = ""
        self._bar: tqdm[Any] = tqdm(
            desc=name, unit=unit, disable=not (shown and watched), dynamic_ncols=True, leave=True
        )

    def __enter__(self) -> Progress:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._bar.close()

    def show(self, done: int, total: int | None, words: str = "") -> None:
        """Sets the bar; a study that climbs to a tolerance learns its total on the way."""
        if self._bar.disable:
            return
        if done < self._bar.n:
            self._bar.reset(total)
        changed = (total, words) != (self._bar.total, self._words)
        self._bar.total, self._words = total, words
        self._bar.set_postfix_str(words, refresh=False)
        self._bar.update(done - self._bar.n)
        if changed:
            self._bar.refresh()


class Deadline:
    """The time that `wait` was given; endless when it is None."""

    def __init__(self, identifier: str, seconds: float | None) -> None:
        self._identifier = identifier
        self._seconds = seconds
        self._end = math.inf if seconds is None else time.monotonic() + seconds

    def left(self) -> float:
        """Seconds left, not negative."""
        return max(self._end - time.monotonic(), 0.0)

    def check(self) -> None:
        """Raises WaitTimeout when the time is over."""
        if self._seconds is not None and self.left() <= 0.0:
            raise WaitTimeout(self._identifier, self._seconds)
