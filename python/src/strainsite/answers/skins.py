"""The whole wheel's skins, as arrays."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from strainsite.errors import AnswerError

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, eq=False, repr=False)
class Surface:
    """Both skins of the whole wheel at the means, inflated and pressed.

    Points are of shape (rows, columns, 3): x in the rolling direction, y along the axle, z upward from the wheel's
    centre, mm. Rows run along the section, columns around the wheel; the last column's neighbour is the first.
    """

    level: str
    """Mesh level whose nodes these are."""
    phi_deg: NDArray[np.float64]
    """Section angles of the rows from the crown, degrees."""
    theta_deg: NDArray[np.float64]
    """Wheel angles of the columns from the contact centre, degrees."""
    inner_inflated_mm: NDArray[np.float32]
    """The inner skin before contact."""
    inner_displacement_mm: NDArray[np.float32]
    """From there to the equilibrium."""
    outer_inflated_mm: NDArray[np.float32]
    """The outer skin before contact."""
    outer_displacement_mm: NDArray[np.float32]
    """From there to the equilibrium."""
    ground_mm: NDArray[np.float64]
    """The ground's profile: x and z of its points, shape (points, 2)."""

    @classmethod
    def of(cls, content: bytes) -> Surface:
        """Reads a surface as the service sends it."""
        try:
            (length,) = struct.unpack_from("<I", content)
            header = json.loads(content[4 : 4 + length])
            ground = header["ground"]
            return cls(
                level=header["level"],
                phi_deg=np.array(header["phi_deg"], dtype=float),
                theta_deg=np.array(header["theta_deg"], dtype=float),
                ground_mm=np.column_stack([ground["x_mm"], ground["z_mm"]]),
                **{array["name"]: _points(content, 4 + length, header, array) for array in header["arrays"]},
            )
        except (KeyError, TypeError, ValueError, struct.error) as error:
            raise AnswerError(f"the service's surface isn't what this client knows: {error!r}") from error

    def __repr__(self) -> str:
        """How large it is."""
        return f"Surface({self.level}, {self.phi_deg.size} x {self.theta_deg.size})"


def _points(content: bytes, start: int, header: dict[str, Any], array: dict[str, Any]) -> NDArray[np.float32]:
    components = array["components"]
    numbers = np.frombuffer(content, "<f4", components * array["count"], start + array["offset"])
    return numbers.reshape(header["rows"], header["columns"], components)
