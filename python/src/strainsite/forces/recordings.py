"""Recordings and recipes on their way to the service."""

from __future__ import annotations

import codecs
import json
import os
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

from strainsite.documents import from_file, plain
from strainsite.errors import DocumentError
from strainsite.recordings.recording import Recording

if TYPE_CHECKING:
    from collections.abc import Mapping

    import pandas as pd

    Run = pd.DataFrame | Recording | str | os.PathLike[str]
    """A recording: a CSV file, its text, a pandas frame, or what was read from a bag."""
    Recipe = Mapping[str, Any] | str | os.PathLike[str]
    """What is to be done: fields, a TOML or JSON file, or its text."""


def recording(run: Run, name: str) -> dict[str, str]:
    """One recording as the service takes it; a file has its own name, all else the one that is given."""
    if isinstance(run, Recording):
        return {"file": name, "text": run.text()}
    if isinstance(run, str) and "\n" in run:
        return {"file": name, "text": run}
    if isinstance(run, str | os.PathLike):
        return {"file": Path(run).name, "text": _text(Path(run))}
    if not hasattr(run, "to_csv"):
        kinds = "a CSV file, its text, a pandas frame or a bag's Recording"
        raise DocumentError(f"a recording is {kinds}; {name} is a {type(run).__name__}")
    # An index with a name is a column, as after `set_index`. Floats are written with all their digits.
    table = run.reset_index() if run.index.name is not None else run
    return {"file": name, "text": table.to_csv(index=False, lineterminator="\n")}


def recipe(given: Recipe | None) -> dict[str, Any]:
    """A recipe as fields; all are at their defaults when none is given, or an empty text."""
    if given is None or given == "":
        return {}
    if isinstance(given, str) and ("\n" in given or "=" in given or given.lstrip().startswith("{")):
        return _read(given)
    if isinstance(given, str | os.PathLike):
        return from_file(given)
    return dict(plain(dict(given)))


def _text(path: Path) -> str:
    """The text of a file as the command line reads it: UTF-16 with its mark, UTF-8, or else Latin-1."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise DocumentError(f"{path} can't be read: {error}") from error
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return content.decode("utf-16", errors="replace")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def _read(text: str) -> dict[str, Any]:
    try:
        return dict(json.loads(text) if text.lstrip().startswith("{") else tomllib.loads(text))
    except ValueError as error:
        raise DocumentError(f"the recipe is neither TOML nor JSON: {error}") from error
