"""Columns that a caller asked for: a path, and what is found there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import column_names

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from .field_path import FieldPath
    from .field_values import FieldValues


@dataclass
class AskedColumn:
    """A path that was asked for."""

    path: FieldPath
    name: str | None
    """The name that the caller gave it; None where topic and field name it."""
    is_force: bool
    values: FieldValues | None = None
    """What it leads to; None until the topic is known to have it."""

    def named(self) -> list[tuple[str, NDArray[np.float64]]]:
        """Each number that the path leads to, of shape (messages,), with the name of its column."""
        if self.values is None:
            return []
        numbers = self.values.columns()
        elements = self.values.elements
        path = self.values.path
        if elements is None:
            return [(self.name or column_names.of_value(path, None), numbers[0])]
        names = [f"{self.name}_{at}" if self.name else column_names.of_value(path, at) for at in elements]
        return list(zip(names, numbers, strict=True))
