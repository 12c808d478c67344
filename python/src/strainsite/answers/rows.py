"""Answers as rows of tables: the columns of the exported ones, as the service describes them."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

from ._generated import COLUMNS

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from _typeshed import DataclassInstance

    from ._generated import (
        ComparedStudy,
        ComparisonFields,
        Evaluation,
        Input,
        Layout,
        Output,
    )

Row = dict[str, object]


def record(value: DataclassInstance) -> Row:
    """The fields of a dataclass by name, not deeper."""
    return {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}


def table(name: str, parts: Iterable[Row]) -> list[Row]:
    """The rows of a table.

    Args:
        name: Name of the table, as `layouts`.
        parts: What each row is made of, by the names that the columns' pointers begin with; `unit` is that of its
            films' signals.

    """
    return [{column: _value(row, at, unit) for column, at, unit in COLUMNS[name]} for row in parts]


def _value(row: Row, pointer: str, unit: str | None) -> object:
    """What stands at a JSON pointer; texts of a list are joined as in `x+y`."""
    if unit is not None and row["unit"] != unit:
        return None
    value: object = row
    for step in pointer.split("/")[1:]:
        if isinstance(value, dict):
            value = value[step]
        elif isinstance(value, (list, tuple)):
            value = value[int(step)]
        elif value is not None:
            value = getattr(value, step)
    return "+".join(value) if isinstance(value, (list, tuple)) else value


def indices(outputs: Iterable[Output], inputs: Sequence[Input]) -> list[Row]:
    """A row for each location, direction and input."""

    def own(output: Output, k: int) -> Row:
        lists = {name: getattr(output, name) for name in ("first_order", "total", "mdrm_first_order")}
        return {name: _at(values, k) for name, values in lists.items()}

    rows = (
        {"output": output, "input": varied, "own": own(output, k)}
        for output in outputs
        for k, varied in enumerate(inputs)
    )
    return table("indices", rows)


def forces(layouts: Iterable[Layout]) -> list[Row]:
    """A row for each layout and force; its error on left-out cycles, or runs where there are no cycles."""
    rows: list[Row] = []
    for layout in layouts:
        for force in layout.force_error or ():
            splits = {split.by: split for split in force.splits}
            left_out = splits.get("cycle") or splits.get("run")
            rows.append({"layout": layout, "force": force, "left_out": left_out})
    return table("forces", rows)


def evaluations(points: Sequence[Evaluation], inputs: Sequence[str]) -> list[Row]:
    """A row for each solved point: inputs, force, strains at the locations, why there is no equilibrium."""
    seen = next((point.locations for point in points if point.locations), ())
    rows = []
    for point in points:
        row: Row = {"ordinal": point.ordinal, "level": point.level}
        row |= {name: _at(point.values, k) for k, name in enumerate(inputs)}
        row["reaction_n"] = point.reaction_n
        strains = {location.name: location for location in point.locations or ()}
        for location in seen:
            here = strains.get(location.name)
            row[f"{location.name}_strain_x"] = here.strain_x if here else None
            row[f"{location.name}_strain_y"] = here.strain_y if here else None
        row["newton_iterations"] = point.newton_iterations
        row["wall_s"] = point.wall_s
        row["reason"] = point.reason
        row["key"] = point.key
        rows.append(row)
    return rows


def compared(comparison: ComparisonFields) -> list[Row]:
    """A row for each location of each study with a result."""
    studies = {study.id: study for study in comparison.studies}
    located = [(row, studies[row.study]) for row in comparison.rows]
    parts: list[Row] = [{"row": row, "study": study, "comparison": comparison} for row, study in located]
    rows = zip(located, table("compared_locations", parts), strict=True)
    return [_named(study, comparison) | row for (_, study), row in rows]


def compared_studies(comparison: ComparisonFields) -> list[Row]:
    """A row for each study."""
    parts: list[Row] = [{"study": study, "comparison": comparison} for study in comparison.studies]
    rows = zip(comparison.studies, table("designs", parts), strict=True)
    return [_named(study, comparison) | row for study, row in rows]


def _named(study: ComparedStudy, comparison: ComparisonFields) -> Row:
    """What rows of a study begin with: which it is, and every field that any design sets."""
    paths = sorted({path for other in comparison.studies for path in other.set or {}})
    settings = study.set or {}
    return {"study": study.id, "name": study.name} | {path: settings.get(path) for path in paths}


def _at(values: Sequence[float] | None, k: int) -> float | None:
    return None if values is None or k >= len(values) else values[k]
