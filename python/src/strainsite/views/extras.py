"""Packages that are only needed for some methods."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from strainsite.errors import MissingExtra

if TYPE_CHECKING:
    from types import ModuleType


def pandas() -> Any:  # noqa: ANN401 - a module, typed where it is used
    """The package pandas."""
    return _needed("pandas", "pandas")


def pyplot() -> Any:  # noqa: ANN401 - a module, typed where it is used
    """The module matplotlib.pyplot."""
    return _needed("matplotlib.pyplot", "plot")


def rosbag2() -> Any:  # noqa: ANN401 - a module without types
    """The module rosbags.rosbag2."""
    return _needed("rosbags.rosbag2", "bags")


def typesys() -> Any:  # noqa: ANN401 - a module without types
    """The module rosbags.typesys."""
    return _needed("rosbags.typesys", "bags")


def _needed(name: str, extra: str) -> ModuleType:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.partition(".")[0]
        raise MissingExtra(f"this needs {package}: pip install 'strainsite[{extra}]'") from error
