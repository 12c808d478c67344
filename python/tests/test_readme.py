"""The first scripts of the pages that have some."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest
from service import BINARY, ROOT, said_by

if TYPE_CHECKING:
    from pathlib import Path


def first_script(readme: str) -> str:
    return str(re.findall(r"^```python\n(.*?)^```", (ROOT / readme).read_text(), re.MULTILINE | re.DOTALL)[0])


@pytest.mark.parametrize(
    ("readme", "said", "written"),
    [
        ("docs/sweeps.md", r"wall_mm = 2\.5 +P3 +1 .* (noise|unknown|real)\n", {"comparison.png", "map.png"}),
        ("python/README.md", r"1 +P3 ", {"ranking.png", "map.png", "points.csv"}),
    ],
)
def test_the_first_script_runs(readme: str, said: str, written: set[str], tmp_path: Path) -> None:
    script = first_script(readme)
    assert len(script.splitlines()) <= 12
    # What differs: where program and study are, and mesh and layouts, so that it takes a second.
    script = script.replace("target/release/strainsite", str(BINARY)).replace("studies/", f"{ROOT}/studies/")
    script, changed = re.subn('"(coarse|standard)"', '"draft", "layouts.spacings_deg": []', script)
    assert changed == 1
    printed = said_by(["-c", script], tmp_path, 60, MPLBACKEND="Agg")
    assert re.search(said, printed), printed
    assert written <= {path.name for path in tmp_path.iterdir()}
