"""Which study, and what its model is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class StudyIdentity:
    """Which study, which document, which program."""

    id: str
    name: str
    spec_sha256: str
    """Hash of the canonical document."""
    version: str
    """Of the program and its solver."""


@dataclass(frozen=True)
class Choice:
    """One choice of the model with its reason."""

    what: str
    why: str
    effect: float | None
    """What leaving it out does to a strain at the locations, over the largest one; None where it isn't known."""


@dataclass(frozen=True)
class Model:
    """What was modelled, and what was left out."""

    dimension: str
    """`3d`, `3d-half` or `3d-quarter`."""
    level: str
    elements: int
    dofs: int
    modelled: tuple[Choice, ...]
    left_out: tuple[Choice, ...]


@dataclass(frozen=True)
class Input:
    """One thing that varied."""

    name: str
    vary: str
    """Path of the scene's field."""
    distribution: dict[str, Any]
