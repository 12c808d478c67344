"""Answers as rows of tables, with the columns of the exported ones."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from _typeshed import DataclassInstance

    from .indices import Output
    from .model import Input
    from .points import Evaluation
    from .ranked import Layout
    from .signals import SignalRow

Row = dict[str, object]

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
    "rank_certain",
    "name",
    "staggered",
    "film_count",
    "bayes_angle_error_deg",
    "simulated_rms_angle_error_deg",
    "simulated_p95_angle_error_deg",
    "simulated_p95_error_deg",
    "lost_share",
    "simulated_rms_depth_error_mm",
    "force_error_n",
    "alike_sigmas",
    "worst_angle_mesh_error_deg",
    "doubt",
    "shear_angle_error_deg",
    "shear_force_x_error_n",
    "shear_force_y_error_n",
    "shear_force_z_error_n",
    "shear_reason",
]


def record(value: DataclassInstance) -> Row:
    """The fields of a dataclass by name, not deeper."""
    return {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}


def indices(outputs: Sequence[Output], inputs: Sequence[Input]) -> list[Row]:
    """A row for each location, direction and input."""
    return [
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
        for output in outputs
        for k, varied in enumerate(inputs)
    ]


def layouts(layouts: Sequence[Layout]) -> list[Row]:
    """A row for each layout at its worst load, best first; films as in `x+y`."""
    rows = []
    for layout in layouts:
        row = record(layout) | record(layout.score)
        row["films"] = "+".join(layout.films)
        score, error = layout.score, layout.score.error
        row["weakest_signal_strain"] = score.weakest_signal
        row["simulated_p95_error_deg"] = error.simulated_p95_angle_error_deg if error else None
        row["worst_angle_mesh_error_deg"] = error.worst_angle_error_deg if error else None
        row["alike_sigmas"] = score.alike.sigmas if score.alike else None
        shear = score.shear
        forces = (shear and shear.worst_force_error_n) or (None, None, None)
        row["shear_angle_error_deg"] = shear.worst_angle_error_deg if shear else None
        row |= {f"shear_force_{axis}_error_n": force for axis, force in zip("xyz", forces, strict=True)}
        row["shear_reason"] = shear.reason if shear else None
        rows.append({name: row[name] for name in _LAYOUT_COLUMNS})
    return rows


def signals(readings: Sequence[SignalRow]) -> list[Row]:
    """A row for each film and pressing."""
    rows = []
    for reading in readings:
        row = record(reading)
        error, reason = reading.error, row.pop("reason")
        row["strain_error"] = error.strain if error else None
        row["charge_error_nc"] = error.charge_nc if error else None
        row["open_circuit_error_v"] = error.open_circuit_v if error else None
        row["output_error_v"] = error.output_v if error else None
        row["reason"] = reason
        del row["error"]
        rows.append(row)
    return rows


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


def _at(values: Sequence[float] | None, k: int) -> float | None:
    return None if values is None or k >= len(values) else values[k]
