"""Reads a database without a service: what is in it, its tables as pandas frames, and a figure of merit of one's own.

    python examples/read_database.py [tire.db]

The commands `list`, `show` and `export` are what scripts may hold on to. The tables inside of the file are plain SQLite
and may be read, too, but change with the program's version; only the program should write to them.
"""

import io
import json
import os
import sqlite3
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd

PROGRAM = os.environ.get("STRAINSITE_BIN", "strainsite")
DATABASE = sys.argv[1] if len(sys.argv) > 1 else "tire.db"


def said(*arguments: str) -> str:
    """What the program writes to its standard output about this database."""
    command = [PROGRAM, *arguments, "--db", DATABASE]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def table(study: str, name: str) -> pd.DataFrame:
    """One of a study's tables: indices, locations, layouts or points."""
    return pd.read_csv(io.StringIO(said("export", study, "--format", "csv", "--table", name)))


done = json.loads(said("list", "--state", "done", "--json", "-"))["studies"]
print(f"{len(done)} studies are done")
if not done:
    sys.exit(f"run examples/first_ranking.py first: it fills {DATABASE}")

# Rows of several studies go below each other: each says which study it is of, and which version of the program.
ranking = pd.concat([table(study["id"], "locations") for study in done])
print(ranking[["study", "rank", "name", "gsi_x_percent", "gsi_y_percent", "rank_certain"]].to_string(index=False))

# The points of the newest study hold more than indices: how stiff is the contact about its means? A plane through the
# points of its plan, N per mm of each station's depth. The points after these are solved on a coarser mesh for the
# error of the mesh, and with what the model leaves out.
newest = done[0]["id"]
result = json.loads(said("export", newest, "--format", "json"))
inputs = [entry["name"] for entry in result["inputs"]]
points = table(newest, "points")
points = points[(points["ordinal"] < result["cost"]["solves"]) & points["reaction_n"].notna()]
matrix = np.column_stack([points[inputs] - points[inputs].mean(), np.ones(len(points))])
slopes, *_ = np.linalg.lstsq(matrix, points["reaction_n"], rcond=None)
for name, slope in zip(inputs, slopes, strict=False):
    print(f"{name}: {slope:6.2f} N/mm")
print(f"together {slopes[:-1].sum():.2f} N/mm, from {len(points)} points")

# The file itself, opened so that nothing can be changed by oversight.
with sqlite3.connect(f"{Path(DATABASE).resolve().as_uri()}?mode=ro", uri=True) as connection:
    solved, bytes_ = connection.execute("select count(*), sum(length(response)) from evaluations").fetchone()
print(f"{solved} equilibria in the database, {bytes_ / 1e6:.1f} MB of responses")
