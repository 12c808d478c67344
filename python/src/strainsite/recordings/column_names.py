"""Names of columns, which the reader of recordings takes for what they are."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .field_path import FieldPath

TIME = "time_s"
# What `strainsite force` takes for the time and for forces where a recipe names none: of forces the first group that
# a file has. `named_columns.rs` of its sources has the same.
_TIMES = {TIME, "time", "t", "timestamp", "seconds", "sec"}
_FORCES = ("f._n", "force_n", "f_n", "f.", "force_[xyz]_n", "force_[xyz]", "force")
_LONGEST = 200


def is_time(name: str) -> bool:
    """Whether a column of this name may be taken for the time."""
    return _plain(name) in _TIMES


def is_force(name: str) -> bool:
    """Whether a column of this name may be taken for a force."""
    return any(re.fullmatch(group, _plain(name)) for group in _FORCES)


def usual_forces(names: Sequence[str]) -> list[str]:
    """The columns that are taken for forces where a recipe names none."""
    for group in _FORCES:
        if found := [name for name in names if re.fullmatch(group, _plain(name))]:
            return found
    return []


def unfit(name: str) -> str | None:
    """What keeps a name from being one of a column; None where nothing does."""
    if not 1 <= len(name) <= _LONGEST or name != name.strip():
        return f"must be a name of 1 to {_LONGEST} characters without spaces around it"
    if not name.isprintable() or set(name) & set(',;"*?#%'):
        return 'must be a name without any of , ; " * ? # % and without line breaks'
    if is_time(name):
        return "is a name that the reader of recordings takes for the time; choose another"
    return None


def of_value(path: FieldPath, element: int | None) -> str:
    """A name by topic and field, with the place of an element of a range.

    The field `data`, which says nothing, is left out.
    """
    words = re.findall(r"\w+", path.topic)
    words += [str(element if isinstance(step, slice) else step) for step in path.steps if step != "data"]
    name = "_".join(words)
    return f"signal_{name}" if is_time(name) or is_force(name) else name


def _plain(name: str) -> str:
    """A name as the reader compares it: small letters, bars for spaces, no unit behind it."""
    lower = name.lower()
    for unit in ("[s]", "(s)", "[n]", "(n)"):
        if lower.endswith(unit):
            lower = lower.removesuffix(unit)
            break
    return lower.strip().replace(" ", "_")
