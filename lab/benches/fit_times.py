#!/usr/bin/env python3
"""What fits take beside what `force fit --dry-run` says, on one thread: python3 lab/benches/fit_times.py STRAINSITE"""

import json
import math
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

KINDS = (["ridge"], ["gpr"], ["ann"], ["ridge", "gpr", "ann", "blend"])
# Rows of all runs, signals, runs.
SIZES = ((200, 2, 1), (200, 12, 3), (1500, 2, 3), (1500, 12, 3), (6000, 4, 2), (6000, 15, 2))


def recording(path, rows, signals, seed):
    """Presses twice and a half a second at 100 Hz; signals that saturate, with noise."""
    draws = random.Random(seed)
    lines = ["time_s," + ",".join(f"s{k}" for k in range(signals)) + ",fz_n"]
    for row in range(rows):
        force = 10 * max(0, math.sin(2 * math.pi * row / 40 + seed)) ** 2
        read = [math.tanh(force / (5 + k)) * (1 + 0.1 * k) + 0.02 * draws.gauss(0, 1) for k in range(signals)]
        lines.append(",".join([f"{0.01 * row:.2f}", *(f"{x:.5f}" for x in read), f"{force:.4f}"]))
    path.write_text("\n".join(lines) + "\n")


def compare(program, folder, kinds, size):
    """The forecast of a fit, s, and the time that it took."""
    rows, signals, runs = size
    recipe = folder / "recipe.toml"
    recipe.write_text(f"[models]\nkinds = {json.dumps(kinds)}\n")
    files = [folder / f"{run}.csv" for run in range(runs)]
    for run, path in enumerate(files):
        recording(path, rows // runs, signals, run)
    fit = [program, "force", "fit", recipe, *files, "--threads", "1", "--json", "-"]
    said = json.loads(subprocess.run([*fit, "--dry-run"], check=True, capture_output=True).stdout)
    begun = time.monotonic()
    subprocess.run(fit, check=True, capture_output=True)
    return said["wall_s"], time.monotonic() - begun


def main(program):
    """Prints the table."""
    print("| models | rows | signals | runs | forecast, s | took, s |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for kinds in KINDS:
            for size in SIZES:
                said, took = compare(program, Path(folder), kinds, size)
                forecast = "{expected:.1f} ({least:.1f} to {most:.1f})".format(**said)
                print(f"| {', '.join(kinds)} | {' | '.join(map(str, size))} | {forecast} | {took:.1f} |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
