"""Designs that a cluster solves in tests of seconds, and what must come of them."""

import os
import pathlib
import sqlite3
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = pathlib.Path(os.environ.get("STRAINSITE_BIN", HERE / "../../target/release/strainsite")).resolve()
WALLS = [2.4, 2.7, 3.0, 3.3, 3.6, 3.9]
STUDY = ["foot-tire", "--set", "accuracy.preset=draft", "--set", "layouts.spacings_deg=[]"]


def sweep(walls: list[float] = WALLS) -> list[str]:
    """Arguments of a sweep over some walls."""
    return [*STUDY, "--grid", f"geometry.wall_mm={','.join(map(str, walls))}"]


# Tasks of one design, asked of Slurm.
ELSEWHERE = ["--engine", "slurm", "--minutes", "0.01"]
# Longest time of a command, s.
MOST_S = 300


def told(command: list[str | pathlib.Path], folder: pathlib.Path) -> str:
    """What a command says, which must succeed."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=MOST_S, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def contents(database: pathlib.Path) -> tuple[list[str], int]:
    """Hashes of what the results say, in the order of the designs, and how many points there are."""
    query = "select content_sha256 from results join studies on id = study order by name"
    with sqlite3.connect(database) as connection:
        hashes = [content for (content,) in connection.execute(query)]
        (points,) = connection.execute("select count(*) from evaluations").fetchone()
    return hashes, points


def local(folder: pathlib.Path) -> tuple[list[str], int]:
    """What this machine alone makes of the sweep."""
    told([PROGRAM, "sweep", *sweep(), "--db", "local.db"], folder)
    found = contents(folder / "local.db")
    assert len(found[0]) == len(WALLS), found
    return found


def tasks_at_work(folder: pathlib.Path) -> list[pathlib.Path]:
    """Processes of tasks that lie somewhere in a folder, as /proc lists them."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            is_task = b"strainsite\0tasks\0run\0" in (process / "cmdline").read_bytes()
            if is_task and (process / "cwd").readlink().is_relative_to(folder):
                found.append(process)
        except OSError:
            continue
    return found
