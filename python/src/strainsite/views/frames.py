"""Rows as pandas frames. Needs the extra `pandas`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .extras import pandas

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    import pandas as pd
    from numpy.typing import NDArray


def frame(rows: Sequence[Mapping[str, object]], origin: Mapping[str, object] | None = None) -> pd.DataFrame:
    """A frame of rows, which knows where it comes from, in `attrs`.

    Columns that hold nothing but None are numbers, because nan adds and plots.
    """
    table: pd.DataFrame = pandas().DataFrame(rows)
    empty = [name for name in table.columns if table[name].isna().all()]
    table = table.astype(dict.fromkeys(empty, "float64"))
    table.attrs.update(origin or {})
    return table


def columns(values: Mapping[str, NDArray[np.float64]], origin: Mapping[str, object] | None = None) -> pd.DataFrame:
    """A frame of columns, which knows where it comes from, in `attrs`."""
    table: pd.DataFrame = pandas().DataFrame(dict(values))
    table.attrs.update(origin or {})
    return table
