"""The documents that the service ships."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Preset:
    """A document to start from."""

    name: str
    title: str
    document: dict[str, Any]
    comment: str
    """What it is for."""


@dataclass(frozen=True)
class Presets:
    """The documents that the service ships."""

    studies: tuple[Preset, ...]
    scenes: tuple[Preset, ...]
