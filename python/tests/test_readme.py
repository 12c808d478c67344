"""The script that the READMEs promise."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from typing import TYPE_CHECKING

from service import BINARY, ROOT

if TYPE_CHECKING:
    from pathlib import Path


def first_script(readme: str) -> str:
    return str(re.findall(r"^```python\n(.*?)^```", (ROOT / readme).read_text(), re.MULTILINE | re.DOTALL)[0])


def test_the_script_of_both_readmes_runs(tmp_path: Path) -> None:
    script = first_script("README.md")
    assert script == first_script("python/README.md")
    assert len(script.splitlines()) <= 12
    # What differs: where program and study are, and the mesh, so that it takes a second.
    script = script.replace("target/release/strainsite", str(BINARY)).replace("studies/", f"{ROOT}/studies/")
    script = re.sub('"(coarse|standard)"', '"draft"', script)
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    ran = subprocess.run(
        [sys.executable, "-c", script],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    assert re.search(r"1 +P3 ", ran.stdout), ran.stdout
    written = {path.name for path in tmp_path.iterdir()}
    assert {"ranking.png", "map.png", "points.csv"} <= written
