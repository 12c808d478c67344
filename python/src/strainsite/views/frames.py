"""Answers as pandas frames, with the columns of the exported tables. Needs the extra `pandas`."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

from .extras import pandas

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import pandas as pd
    from _typeshed import DataclassInstance

    from strainsite.answers.points import Evaluation
    from strainsite.answers.result import Result

_LAYOUT_COLUMNS = [
    "rank",
    "spacing_deg",
    "units",
    "position",
    "films",
    "weakest_signal_strain",
    "worst_angle_error_deg",
    "rms_angle_error_deg",
    "worst_depth_error_mm",
    "noise_strain",
    "reason",
]


def locations(result: Result) -> pd.DataFrame:
    """A row for each location, best first."""
    return _frame([dict(as_record(location)) for location in result.locations], result)


def indices(result: Result) -> pd.DataFrame:
    """A row for each location, direction and input."""
    rows = []
    for output in result.outputs:
        for k, varied in enumerate(result.inputs):
            rows.append(
                {
                    "location": output.location,
                    "direction": output.direction,
                    "input": varied.name,
                    "first_order": _at(output.first_order, k),
                    "total": _at(output.total, k),
                    "error_mesh": output.error.mesh,
                    "error_quadrature": output.error.quadrature,
                    "error_decomposition": output.error.decomposition,
                    "error_total": output.error.total,
                    "mean_strain": output.mean,
                    "std_strain": output.std,
                    "method": output.method,
                    "status": output.status,
                    "mdrm_first_order": _at(output.mdrm_first_order, k),
                }
            )
    return _frame(rows, result)


def layouts(result: Result) -> pd.DataFrame:
    """A row for each layout, best first; films as in `x+y`."""
    rows = []
    for layout in result.layouts:
        row = dict(as_record(layout)) | dict(as_record(layout.score))
        row["films"] = "+".join(layout.films)
        row["weakest_signal_strain"] = layout.score.weakest_signal
        rows.append({name: row[name] for name in _LAYOUT_COLUMNS})
    return _frame(rows, result)


def evaluations(points: Sequence[Evaluation], inputs: Sequence[str]) -> pd.DataFrame:
    """A row for each solved point: inputs, force, strains at the locations, why there is no equilibrium."""
    seen = next((point.locations for point in points if point.locations), ())
    rows = []
    for point in points:
        row: dict[str, Any] = {"ordinal": point.ordinal, "level": point.level}
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
    return plain(rows)


def _at(values: Sequence[float] | None, k: int) -> float | None:
    return None if values is None or k >= len(values) else values[k]


def plain(rows: list[dict[str, Any]]) -> pd.DataFrame:
    """A frame of rows; columns that hold nothing but None are numbers, because nan adds and plots."""
    frame: pd.DataFrame = pandas().DataFrame(rows)
    empty = [name for name in frame.columns if frame[name].isna().all()]
    return frame.astype(dict.fromkeys(empty, "float64"))


def as_record(value: DataclassInstance) -> Mapping[str, Any]:
    """The fields of a dataclass by name, not deeper."""
    return {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}


def _frame(rows: list[dict[str, Any]], result: Result) -> pd.DataFrame:
    """A frame that knows where it comes from, in `attrs`."""
    frame = plain(rows)
    frame.attrs.update(as_record(result.study))
    return frame
