"""How long to go on trying, and at what pace."""

from __future__ import annotations

import math
import random
import time

_FIRST_S = 0.1
_LONGEST_S = 5.0


class Patience:
    """One spell of trouble: waits between attempts until the seconds allowed are over."""

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds
        self._began: float | None = None
        self._attempts = 0

    def again(self, retry_after: float | None = None, *, at_most: float = math.inf) -> bool:
        """Waits before the next attempt; False, at once, when the wait would outlast the patience.

        Pauses double from 0.1 to 5 s, with a random part so that many clients don't come back together; `retry_after`
        seconds go before it when they are longer. A pause isn't longer than `at_most`, whatever else.
        """
        now = time.monotonic()
        self._began = self._began if self._began is not None else now
        pause = min(_FIRST_S * 2**self._attempts, _LONGEST_S) * random.uniform(0.5, 1.0)  # noqa: S311
        pause = max(pause, retry_after or 0.0)
        left = self._began + self.seconds - now
        if retry_after is None and 0.0 < left < pause:
            pause = left
        if pause > left:
            return False
        self._attempts += 1
        time.sleep(min(pause, at_most))
        return True

    def answered(self) -> None:
        """The trouble is over: the next one has the whole patience again."""
        self._began = None
        self._attempts = 0
