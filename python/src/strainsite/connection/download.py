"""Files that the service makes."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from strainsite.errors import StrainsiteError

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable, Mapping

    from .transport import Transport


def download(
    transport: Transport,
    address: str,
    format: str,
    table: str | None,
    path: str | os.PathLike[str] | None,
    params: Mapping[str, str] | None = None,
) -> Path:
    """Writes an export to a file, or into a folder under the name that the service proposes, and returns its path."""
    wanted = {**(params or {}), "format": format} | ({} if table is None else {"table": table})
    answer = transport.request("GET", address, params=wanted)
    proposed = re.search(r'filename="([^"/\\]+)"', answer.headers.get("content-disposition", ""))
    if proposed is None:
        raise StrainsiteError(f"{address} answered without a file")
    target = Path(proposed[1]) if path is None else Path(path)
    target = target / proposed[1] if target.is_dir() else target
    write_whole(target, answer.content)
    return target


def write_whole(path: Path, content: bytes | Iterable[bytes]) -> None:
    """All of a file, in one piece or in several, or nothing, so that no half of one is taken for the whole."""
    part = path.with_name(f".{path.name}.part")
    try:
        part.unlink(missing_ok=True)
        with part.open("xb") as out:  # A link of that name isn't followed.
            out.writelines([content] if isinstance(content, bytes) else content)
        part.replace(path)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise StrainsiteError(f"{path} can't be written: {error}") from error
