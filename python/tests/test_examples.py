"""The examples, one after another in one folder, and the first scripts of pages: they run, and say what they should."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from service import BINARY, ROOT, said_by

EXAMPLES = ROOT / "examples"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("examples")


def run(folder: Path, *arguments: str | Path) -> str:
    return said_by(arguments, folder, 100, STRAINSITE_BIN=str(BINARY))


def test_the_first_ranking_and_what_its_database_holds(folder: Path) -> None:
    said = run(folder, EXAMPLES / "first_ranking.py")
    assert re.search(r"^1  P3  x +\d+\.\d+ ± *\d+\.\d+ %   y +\d+\.\d+ ±", said, re.MULTILINE), said
    assert {"tire.db", "ranking.png", "map.png", "points.csv"} <= {path.name for path in folder.iterdir()}
    again = run(folder, EXAMPLES / "first_ranking.py")
    assert again.startswith("0 solves to go"), again
    said = run(folder, EXAMPLES / "read_database.py")
    assert "2 studies are done" in said
    slopes = [float(text) for text in re.findall(r"^P\d: +(\S+) N/mm$", said, re.MULTILINE)]
    assert len(slopes) == 5
    # The ground is symmetric, and pressing any station deeper takes force.
    assert min(slopes) > 0
    assert slopes[0] == pytest.approx(slopes[4], rel=0.2)


def test_a_sweep_says_which_differences_are_real(folder: Path) -> None:
    said = run(folder, EXAMPLES / "wall_and_cord.py")
    assert len(re.findall(r"^.* done .* P3 ", said, re.MULTILINE)) == 4, said
    assert re.search(r"^.*: P3 x -\d+\.\d+ ±\d+\.\d+ points, rank 1$", said, re.MULTILINE), said
    assert (folder / "comparison.png").exists()


def test_the_notebook_runs_from_top_to_bottom(folder: Path) -> None:
    code = (
        "import sys, nbclient, nbformat\n"
        "book = nbformat.read(sys.argv[1], as_version=4)\n"
        "nbclient.NotebookClient(book, timeout=100, kernel_name='python3').execute()\n"
        "for cell in book.cells:\n"
        "    for output in cell.get('outputs', []):\n"
        "        print(sorted(output.get('data', {})), output.get('data', {}).get('text/html', ''))\n"
    )
    said = run(folder, "-c", code, EXAMPLES / "ranking_map_comparison.ipynb")
    assert said.count("image/png") == 3
    assert "index x, %" in said
    assert "against " in said
    book = json.loads((EXAMPLES / "ranking_map_comparison.ipynb").read_text())
    assert not any(cell.get("outputs") for cell in book["cells"]), "commit the notebook without outputs"


def test_a_simulator_of_ones_own_gets_the_exact_indices(folder: Path) -> None:
    said = run(folder, EXAMPLES / "own_simulator.py")
    found = re.findall(r"first-order index (\S+)  exact (\S+) ", said)
    assert len(found) == 3
    assert all(index == exact for index, exact in found), said


def test_forces_are_learnt_and_known_on_another_run(folder: Path) -> None:
    said = run(folder, EXAMPLES / "learn_forces.py")
    errors = [
        float(text)
        for text in re.findall(r"^f[xz]_n: [\w ,]+, off by (\S+) N .* on runs left out$", said, re.MULTILINE)
    ]
    assert len(errors) == 2, said
    assert max(errors) < 1
    assert re.search(r"^fz_n: off by 0\.\d+ N on the fifth run, \d+% of its rows", said, re.MULTILINE), said
    assert {"forces.png", "model.json"} <= {path.name for path in folder.iterdir()}


def test_every_example_is_run_and_listed() -> None:
    tested = set(re.findall(r'EXAMPLES / "(\w+\.(?:py|ipynb))"', Path(__file__).read_text()))
    shipped = {path.name for path in EXAMPLES.iterdir() if path.suffix in (".py", ".ipynb")}
    assert shipped == tested
    listed = set(re.findall(r"\]\(([^)]+\.(?:py|ipynb))\)", (EXAMPLES / "README.md").read_text()))
    assert listed == shipped


def first_script(readme: str) -> str:
    return str(re.findall(r"^```python\n(.*?)^```", (ROOT / readme).read_text(), re.MULTILINE | re.DOTALL)[0])


@pytest.mark.parametrize(
    ("readme", "said", "written"),
    [
        ("docs/use/sweeps.md", r"wall_mm = 2\.5 +P3 +1 .* (noise|unknown|real)\n", {"comparison.png", "map.png"}),
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


def test_the_page_of_own_models_runs_from_python_and_on_the_command_line(tmp_path: Path) -> None:
    page = (ROOT / "docs/use/own-model.md").read_text()
    blocks = re.findall(r"^```(?:python|toml|console)\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    printed = said_by(["-c", blocks[0]], tmp_path, 60, STRAINSITE_BIN=str(BINARY))
    files = {named[1]: block for block in blocks if (named := re.match(r"# (\S+)\n", block))}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    block = next(block for block in blocks if block.startswith("$ echo"))
    commands = "\n".join(line[2:] for line in block.splitlines() if line.startswith("$ "))
    shell = f'set -e; strainsite() {{ "{BINARY}" "$@"; }}; python() {{ "{sys.executable}" "$@"; }}\n{commands}'
    told = subprocess.run(["bash", "-c", shell], cwd=tmp_path, capture_output=True, text=True, check=True)  # noqa: S607
    shown = [line.strip() for line in page.splitlines()]
    for line in [*printed.splitlines()[:5], *told.stdout.splitlines()[:5], told.stderr.splitlines()[-1]]:
        assert line.strip() in shown, line
