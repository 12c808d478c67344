"""Study documents on their way to the service: from files, with scenes put in and single fields changed."""

from __future__ import annotations

import copy
import json
import math
import re
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .errors import DocumentError

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping, Sequence

_STEP = re.compile(r"\.?(?P<name>[A-Za-z_][A-Za-z0-9_-]*)|\[(?P<index>\d+)\]")
_EXAMPLE = "a path is written as in scene.ground.depths_mm[0]"


def is_file(document: object) -> bool:
    """Whether this names a file; any other text names a document that the service ships."""
    return not isinstance(document, str) or Path(document).suffix.lower() in (".toml", ".json")


def from_file(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Reads a study from TOML or JSON, with the scene file that it names put in.

    The scene file is looked for beside the study first, then in the working folder, as the command line does.
    """
    path = Path(path)
    document = _read(path)
    scene = document.get("scene")
    if isinstance(scene, str):
        beside = path.parent / scene
        document["scene"] = _read(beside if beside.exists() else Path(scene))
    return document


def _read(path: Path) -> dict[str, Any]:
    try:
        text = path.read_text(encoding="utf-8")
        value = json.loads(text) if path.suffix.lower() == ".json" else tomllib.loads(text)
    except (OSError, UnicodeDecodeError) as error:
        raise DocumentError(f"{path} can't be read: {error}") from error
    except ValueError as error:
        raise DocumentError(f"{path}: {error}") from error
    if not isinstance(value, dict):
        raise DocumentError(f"{path} holds {_shown(value)} where a table is expected")
    return value


def changed(document: Mapping[str, Any], changes: Mapping[str, Any] | None) -> dict[str, Any]:
    """A copy of a document with fields set by their paths; a field that is set to None is removed.

    Tables that a path goes through and that aren't there are made; the service knows which fields exist.
    """
    result = copy.deepcopy(dict(document))
    faults = []
    for path, value in (changes or {}).items():
        try:
            _set(result, path, value)
        except DocumentError as error:
            faults.append(str(error))
    try:
        result = plain(result)
    except DocumentError as error:
        faults.append(str(error))
    if faults:
        raise DocumentError("\n".join(faults))
    return result


def steps(path: str) -> list[str | int]:
    """The names and indices of a path."""
    found: list[str | int] = []
    at = 0
    while at < len(path):
        match = _STEP.match(path, at)
        separated = path[at] in ".["
        if match is None or separated != bool(found):
            raise DocumentError(f"{path!r} isn't a path; {_EXAMPLE}")
        name, index = match["name"], match["index"]
        found.append(name if name is not None else int(index))
        at = match.end()
    if not found:
        raise DocumentError(f"an empty text isn't a path; {_EXAMPLE}")
    return found


def _set(document: dict[str, Any], path: str, value: object) -> None:
    *way, last = steps(path)
    place: Any = document
    walked = ""
    for step in way:
        place = _enter(place, step, walked, path)
        walked += f"[{step}]" if isinstance(step, int) else f".{step}" if walked else step
    _check(place, last, walked, path)
    if value is not None:
        place[last] = value
    elif isinstance(last, int) or last in place:
        del place[last]
    else:
        raise DocumentError(f"{path}: there is nothing to remove")


def _enter(place: Any, step: str | int, walked: str, path: str) -> Any:  # noqa: ANN401 - JSON
    _check(place, step, walked, path)
    if isinstance(step, str) and step not in place:
        place[step] = {}
    return place[step]


def _check(place: object, step: str | int, walked: str, path: str) -> None:
    """Says what is wrong when a step can't be made."""
    here = walked or "the document"
    if isinstance(step, str):
        if isinstance(place, dict):
            return
        if isinstance(place, list):
            raise DocumentError(f"{path}: {here} is a list of {len(place)}; say which, as in {here}[0].{step}")
        raise DocumentError(f"{path}: {here} is {_shown(place)}, which has no fields")
    if isinstance(place, list):
        if step < len(place):
            return
        raise DocumentError(f"{path}: {here} has {len(place)} entries, counted from 0")
    if place == {}:
        raise DocumentError(f"{path}: {here} isn't in the document; set the whole list")
    raise DocumentError(f"{path}: {here} is {_shown(place)}, not a list")


def plain(value: Any, where: str = "") -> Any:  # noqa: ANN401 - JSON
    """What JSON can hold: numbers of numpy as numbers, arrays and tuples as lists; nothing else."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, dict):
        return {str(name): plain(field, f"{where}.{name}" if where else str(name)) for name, field in value.items()}
    if isinstance(value, list | tuple):
        return [plain(entry, f"{where}[{k}]") for k, entry in enumerate(value)]
    if isinstance(value, float) and not math.isfinite(value):
        raise DocumentError(f"{where} is {value}, which isn't a number")
    if value is None or isinstance(value, str | bool | int | float):
        return value
    raise DocumentError(f"{where} is {_shown(value)}, which a document can't hold")


def designs_body(
    grid: Mapping[str, Sequence[Any]] | None, designs: Sequence[Mapping[str, Any]] | None
) -> dict[str, Any]:
    """The part of a request that says which designs."""
    if (grid is None) == (designs is None):
        raise DocumentError('say either grid={"geometry.wall_mm": [2.5, 3.0]} or designs=[{"geometry.wall_mm": 2.5}]')
    if grid is not None:
        return {"grid": plain(_in_scene(grid), "grid")}
    full = [design if "set" in design else {"set": design} for design in designs or ()]
    listed = [{**design, "set": _in_scene(design["set"])} for design in full]
    return {"designs": plain(listed, "designs")}


def _in_scene(paths: Mapping[str, Any]) -> dict[str, Any]:
    """Paths as the service has them: those of the scene's fields begin within it, however they were written."""
    return {path.removeprefix("scene."): values for path, values in paths.items()}


def _shown(value: object) -> str:
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list):
        return "a list"
    return f"{value!r} ({type(value).__name__})" if not isinstance(value, str) else f"the text {value!r}"
