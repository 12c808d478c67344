"""What estimates are worth on runs that nobody learnt from."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class TrialError:
    """Estimates against true forces on runs that nobody learnt from."""

    rmse_n: float | None
    nrmse_percent: float | None
    r2: float | None
    coverage: float | None
    """Share of the true forces within their 95 % intervals."""
    outside: float | None = None
    """Share of the rows that are flagged: a signal is beyond what was learnt from. None of earlier versions."""
