"""Strains with their Sobol indices."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ErrorParts:
    """Parts of the error of an index, absolute; None where a part isn't known."""

    mesh: float | None
    quadrature: float | None
    decomposition: float | None
    total: float | None
    reason: str | None
    """Why a part is None."""


@dataclass(frozen=True)
class CoarserIndices:
    """Indices of the same points on a coarser mesh, from which the mesh's error comes."""

    first_order: tuple[float, ...]
    factor: float
    """What the finer mesh may be off, over its difference from the coarser one."""


@dataclass(frozen=True)
class FormMisses:
    """What a form misses at the check points: the method's error, and how much of it two studies share."""

    nodes: tuple[int, ...]
    """Which node of its input's rule each coordinate of each check point is, point after point."""
    residuals: tuple[float, ...]
    """Strain minus the form's at each check point, over the standard deviation."""
    contributions: tuple[float, ...]
    """What each of them adds to the error of a first-order index, input after input."""
    weight: float
    fitted: int
    images: tuple[int, ...] = ()
    """Of each check point, which one is its mirror image; empty where contact or inputs aren't symmetric."""


@dataclass(frozen=True)
class Output:
    """The strain at one location in one direction, with the Sobol index of each input."""

    location: str
    direction: str
    """`x` circumferential, `y` meridional."""
    mean: float | None
    std: float | None
    first_order: tuple[float, ...] | None
    """In the order of the inputs."""
    total: tuple[float, ...] | None
    method: str
    status: str
    """`ok`, `constant` (no variance, no indices) or `product-form-broken` (another method took over)."""
    reason: str | None
    mdrm_first_order: tuple[float, ...] | None
    """What M-DRM said, where its product form is broken."""
    error: ErrorParts
    coarser: CoarserIndices | None
    """None where there is no coarser mesh."""
    misses: FormMisses | None
    """None without check points, or where the method has no form."""
