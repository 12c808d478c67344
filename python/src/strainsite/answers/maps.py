"""A layer of the map over the inner surface, as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from strainsite.errors import AnswerError, StrainsiteError
from strainsite.views import surface

if TYPE_CHECKING:
    from collections.abc import Iterable

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from ._generated import LocationStrain


@dataclass(frozen=True, eq=False, repr=False)
class StrainMap:
    """First-order index of one input over the inner surface, for one direction.

    Arrays are of shape (rows, columns): `phi_deg` counts the rows, `theta_deg` the columns. What doesn't exist is nan.
    """

    direction: str
    """`x` circumferential, `y` meridional."""
    input: str
    """Name of the input."""
    theta_deg: NDArray[np.float64]
    """Angles of the columns from the contact centre, degrees."""
    phi_deg: NDArray[np.float64]
    """Angles of the rows from the crown, degrees."""
    first_order: NDArray[np.float64]
    """First-order index of the input."""
    total: NDArray[np.float64]
    """Total index of the input; no error of its own is known."""
    std: NDArray[np.float64]
    """Standard deviation of the strain."""
    strain: NDArray[np.float64]
    """Strain with every input at its mean."""
    error: NDArray[np.float64]
    """Error of the first-order index, absolute."""
    status: NDArray[np.str_]
    """`ok`, `constant`, `product-form-broken` or `unusable`."""

    @classmethod
    def of(cls, layer: dict[str, Any]) -> StrainMap:
        """Reads a layer as the service sends it."""
        try:
            theta, phi = (np.array(layer[name], dtype=float) for name in ("theta_deg", "phi_deg"))
            shape = (phi.size, theta.size)

            def grid(name: str) -> NDArray[np.float64]:
                # null is None here, which becomes nan.
                return np.array(layer[name], dtype=float).reshape(shape)

            return cls(
                direction=layer["direction"],
                input=layer["input"],
                theta_deg=theta,
                phi_deg=phi,
                first_order=grid("first_order") if layer.get("first_order") else np.full(shape, np.nan),
                total=grid("total") if layer.get("total") else np.full(shape, np.nan),
                std=grid("std"),
                strain=grid("strain"),
                error=grid("error"),
                status=np.array(layer["status"], dtype=str).reshape(shape),
            )
        except (KeyError, TypeError, ValueError) as error:
            raise AnswerError(f"the service's map isn't what this client knows: {error!r}") from error

    @classmethod
    def of_result(cls, result: dict[str, Any], direction: str, name: str | None) -> StrainMap:
        """Takes a layer out of a result document."""
        found = result.get("map")
        if found is None:
            raise StrainsiteError("this study has no map: its document asks for no candidates.grid")
        layers = {layer["direction"]: layer for layer in found["layers"]}
        if direction not in layers:
            raise StrainsiteError(f"direction is one of {', '.join(layers)}; it is {direction!r}")
        inputs = [entry["name"] for entry in result["inputs"]]
        name = inputs[0] if name is None else name
        if name not in inputs:
            raise StrainsiteError(f"input is one of {', '.join(inputs)}; it is {name!r}")
        layer = layers[direction]
        indices, totals = layer["first_order"], layer["total"]
        k = inputs.index(name)
        return cls.of(
            {
                **layer,
                "input": name,
                "theta_deg": found["theta_deg"],
                "phi_deg": found["phi_deg"],
                "first_order": indices[k] if k < len(indices) else None,
                "total": totals[k] if k < len(totals) else None,
            }
        )

    def plot(
        self,
        value: str = "first_order",
        *,
        locations: Iterable[LocationStrain] = (),
        ax: Axes | None = None,
    ) -> Axes:
        """Draws it on the unrolled surface: `first_order`, `total`, `std`, `strain` or `error`."""
        quantities = {
            "first_order": self.first_order,
            "total": self.total,
            "std": self.std,
            "strain": self.strain,
            "error": self.error,
        }
        layer = surface.Layer(self.direction, self.input, self.theta_deg, self.phi_deg, quantities)
        marks = [(location.name, location.theta_deg) for location in locations]
        return surface.unrolled_map(layer, value, marks=marks, ax=ax)

    def __repr__(self) -> str:
        """What it is of, and how large."""
        rows, columns = self.strain.shape
        return f"StrainMap(direction={self.direction!r}, input={self.input!r}, {rows} x {columns})"
