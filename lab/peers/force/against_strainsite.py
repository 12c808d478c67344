"""Compares `strainsite force` with nine scikit-learn variants on unseen runs and prints a Markdown table.

python against_strainsite.py [--cases quick|all|counted|FAMILY:SEED:RUNS,...] [--rolling-start-off] [--json FILE]

A case is a family of virtual recordings, a seed, and how many runs are learnt from; the next run of the same sensor is
estimated. strainsite's recipe is empty. The program is $STRAINSITE_BIN, or else target/release/strainsite.

What the nine found is kept in a folder of the system's temporary files, until the scripts here change.
"""

import argparse
import csv
import hashlib
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import nine_variants
import virtual_recordings

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = os.environ.get("STRAINSITE_BIN") or str(HERE.parents[2] / "target" / "release" / "strainsite")
RECIPE = ""
QUICK = [("press", 1, 1), ("press", 2, 2), ("press", 3, 3), ("shear", 1, 2), ("fingers", 1, 2), ("tire", 1, 2)]
ALL = [(family, seed, runs) for family in virtual_recordings.FAMILIES for seed in (1, 2, 3) for runs in (1, 2, 3)]
# The 24 cases, 60 forces, of which README.md counts what holds: odd seeds learn from one run, even ones from two.
COUNTED = [(family, seed, 1 if seed % 2 else 2) for seed in range(7, 13) for family in virtual_recordings.FAMILIES]
# A model is useful when its RMSE is at most this share of the training mean's.
USEFUL_SHARE = 0.95
TITLES = {
    "case": "case",
    "force": "force",
    "mean_n": "mean, N",
    "rmse_n": "strainsite, N",
    "over_median": "over median of nine",
    "over_best": "over best of nine",
    "best": "best of nine",
    "coverage": "coverage",
    "nine_coverage": "the nine's",
    "score_over_best": "interval score over best",
    "claimed_over_true": "claimed over true RMSE",
    "chosen": "chosen",
    "useful": "useful: said / true",
    "fit_s": "fit, s",
}
# What is counted, by what it says of a row.
CLAIMS = {
    "no worse than the median of nine": lambda row: row["over_median"] <= 1.0,
    "coverage at least 90 %, 80 % where one run was learnt": lambda row: row["coverage"] >= (0.8 if row["case"].endswith(":1") else 0.9),
    "interval score at most 1.7 times the best of nine's": lambda row: row["score_over_best"] <= 1.7,
    "claimed RMSE within a factor of 2.5 of the true one": lambda row: 1 / 2.5 <= row["claimed_over_true"] <= 2.5,
    "useful or useless, said rightly": lambda row: row["agree"],
}


def run(*arguments):
    """Runs strainsite."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{PROGRAM} {' '.join(map(str, arguments))}: {done.stderr}")


def ours(runs, test, folder):
    """By force: what strainsite says of the test run, what it claims, and how long the fit took."""
    recipe, model, report, out = (folder / name for name in ("recipe.toml", "model.json", "report.json", "out.csv"))
    recipe.write_text(RECIPE)
    began = time.perf_counter()
    run("force", "fit", recipe, *runs, "-o", model, "--json", report)
    fit_s = time.perf_counter() - began
    run("force", "apply", model, test, "-o", out)
    with open(out, newline="") as lines:
        estimates = {float(row["time_s"]): row for row in csv.DictReader(lines)}
    time_s, _, forces = nine_variants.read(test)
    found = {}
    for said in json.loads(report.read_text())["forces"]:
        force, best = said["force"], said["models"][0]
        truth = forces[force]
        rows = [k for k in np.flatnonzero(np.isfinite(truth)) if time_s[k] in estimates]
        columns = [[float(estimates[time_s[k]][force + end]) for k in rows] for end in ("", "_low", "_high")]
        found[force] = {
            **nine_variants.figures(truth[rows], *map(np.array, columns)),
            "rows_without_estimate": int(np.isfinite(truth).sum()) - len(rows),
            "claimed_n": best["validation"]["rmse_n"],
            "claimed_coverage": best["validation"]["coverage"],
            "chosen": f"{said['chosen']} {said['chosen_features']}",
            "said_useful": best["better_than_mean"],
            "fit_s": fit_s,
        }
    return found


def nine(case, runs, test, rolling_start_off):
    """The nine variants' figures, from an earlier time where they are kept."""
    sources = b"".join((HERE / name).read_bytes() for name in ("nine_variants.py", "virtual_recordings.py"))
    name = f"{case}-{int(rolling_start_off)}-{hashlib.sha256(sources).hexdigest()[:16]}.json"
    kept = pathlib.Path(tempfile.gettempdir()) / "strainsite-peers" / name.replace(":", "-")
    if not kept.exists():
        kept.parent.mkdir(exist_ok=True)
        found = nine_variants.nine(runs, test, rolling_start_off)
        kept.write_text(json.dumps(found))
    return json.loads(kept.read_text())


def compared(case, force, ours, nine):
    """A row of the table."""
    coverages = [variant["coverage"] for variant in nine["variants"].values()]
    mean_n = nine["mean_rmse_n"]
    # Where the mean is given, it is the nine who say whether more could have been known.
    of_truth = ours["rmse_n"] if ours["said_useful"] else nine["median_rmse_n"]
    return {
        "case": case,
        "force": force,
        "mean_n": mean_n,
        "rmse_n": ours["rmse_n"],
        "over_median": ours["rmse_n"] / nine["median_rmse_n"],
        "over_best": ours["rmse_n"] / nine["best_rmse_n"],
        "best": nine["best"],
        "coverage": ours["coverage"],
        "nine_coverage": f"{min(coverages):.2f} to {max(coverages):.2f}",
        "score_over_best": ours["interval_score_n"] / nine["best_score_n"],
        "claimed_over_true": ours["claimed_n"] / ours["rmse_n"],
        "chosen": ours["chosen"],
        "useful": f"{yes(ours['said_useful'])} / {yes(of_truth <= USEFUL_SHARE * mean_n)}",
        "agree": ours["said_useful"] == (of_truth <= USEFUL_SHARE * mean_n),
        "fit_s": ours["fit_s"],
    }


def yes(said):
    return "yes" if said else "no"


def measure(family, seed, learnt, rolling_start_off):
    """The rows of a case."""
    case = f"{family}:{seed}:{learnt}"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        *runs, test = virtual_recordings.write_runs(family, seed, learnt + 1, folder)
        by_us = ours(runs, test, folder)
        by_nine = nine(case, runs, test, rolling_start_off)
    return [{**compared(case, force, by_us[force], by_nine[force]), "ours": by_us[force]} for force in by_us]


def cell(value):
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def table(rows):
    """A Markdown table."""
    lines = ["| " + " | ".join(TITLES.values()) + " |", "| " + " | ".join("---" for _ in TITLES) + " |"]
    lines += ["| " + " | ".join(cell(row[key]) for key in TITLES) + " |" for row in rows]
    return "\n".join(lines)


def summary(rows):
    """Medians and extremes over the table's rows."""
    lines = []
    for key in ("over_median", "over_best", "coverage", "score_over_best", "claimed_over_true", "fit_s"):
        values = [row[key] for row in rows]
        lines.append(f"- {TITLES[key]}: median {statistics.median(values):.3g}, {min(values):.3g} to {max(values):.3g}")
    for claim, holds in CLAIMS.items():
        lines.append(f"- {claim}: {sum(map(holds, rows))} of {len(rows)}")
    return "\n".join(lines)


def cases(text):
    """Cases by name, or one by one."""
    named = {"quick": QUICK, "all": ALL, "counted": COUNTED}
    if text in named:
        return named[text]
    return [(family, int(seed), int(runs)) for family, seed, runs in (case.split(":") for case in text.split(","))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=cases, default="quick", metavar="quick|all|counted|FAMILY:SEED:RUNS,...")
    parser.add_argument("--rolling-start-off", action="store_true", help="rolling features with the start value off")
    parser.add_argument("--json", type=pathlib.Path, help="all figures, with every digit")
    arguments = parser.parse_args()
    rows = []
    for family, seed, learnt in arguments.cases:
        found = measure(family, seed, learnt, arguments.rolling_start_off)
        rows += found
        print(json.dumps(found), file=sys.stderr, flush=True)
    print(f"{table(rows)}\n\n{summary(rows)}")
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
