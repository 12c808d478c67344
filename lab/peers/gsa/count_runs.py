"""Counts the model runs that strainsite, OpenTURNS and SALib need for the same true error and prints a Markdown table.

python count_runs.py [--models ishigami,piston,...] [--seeds 3] [--tolerance 0.02] [--program PATH]
"""

import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from typing import Callable

import peer_models
import peers
import strainsite_runs

ROOT = pathlib.Path(__file__).resolve().parents[3]
# Errors below are rounding, and nobody is asked for less.
ROUNDING = 1e-12
# Runs tried are so much more than the ones before.
STEP = 1.25
# Where the search ends, runs, if strainsite didn't take more: larger fits of the chaos take long.
MOST_OF_CHAOS = 300
MOST_OF_SAMPLES = 20_000
# From so many runs on the worse half of the chaos's settings is dropped at each step, down to so many, and to so many
# once the tolerance is reached.
HALVED_FROM, KEPT, KEPT_AT_TOLERANCE = 40, 6, 2


def build():
    """The command line program."""
    command = ["cargo", "build", "--release", "--locked", "-q", "-p", "server", "--bin", "strainsite"]
    subprocess.run(command, cwd=ROOT, check=True)
    target = os.environ.get("CARGO_TARGET_DIR", ROOT / "target")
    return pathlib.Path(target) / "release" / "strainsite"


def growing(first, last):
    """Numbers of runs to try."""
    runs = first
    while runs <= last:
        yield runs
        runs = max(runs + 1, round(runs * STEP))


def fit(first_order, model, *arguments):
    """True error of a fit, and its own. One that fails, as with fewer runs than terms, is infinitely wrong."""
    try:
        indices, own = first_order(model, *arguments)
    except (RuntimeError, TypeError, ValueError, ZeroDivisionError):
        return math.inf, math.inf
    error = model.error(indices)
    return (error, own) if math.isfinite(error) else (math.inf, math.inf)


def in_hindsight(fits):
    """Median true error of the setting for which it is least, and that setting."""
    medians = {setting: statistics.median(error for error, _ in found) for setting, found in fits.items()}
    best = min(medians, key=medians.get)
    return medians[best], best


def by_own_error(fits):
    """Median true error of the settings that the fits' own errors choose, seed by seed, and the better design."""
    medians = {}
    for design in {setting[0] for setting in fits}:
        seeds = zip(*[found for setting, found in fits.items() if setting[0] == design])
        chosen = [min(found, key=lambda one: one[1])[0] for found in seeds]
        medians[design] = statistics.median(chosen)
    best = min(medians, key=medians.get)
    return medians[best], best


@dataclass
class Peer:
    title: str
    first_order: Callable
    # Numbers of runs to try for so many inputs up to a number, and settings for a model.
    counts: Callable
    settings: Callable
    # How a setting is chosen, by the column's title.
    choices: dict
    most_runs: int


PEERS = [
    Peer(
        "OpenTURNS chaos",
        peers.chaos,
        lambda inputs, most: growing(inputs + 2, most),
        peers.chaos_settings,
        {"own choice": by_own_error, "best setting": in_hindsight},
        MOST_OF_CHAOS,
    ),
    Peer(
        "SALib Saltelli",
        peers.saltelli,
        lambda inputs, most: [(inputs + 2) * 2**k for k in range(2, 17) if (inputs + 2) * 2**k <= most],
        lambda model: [()],
        {"": in_hindsight},
        MOST_OF_SAMPLES,
    ),
    Peer(
        "SALib RBD-FAST",
        peers.random_balance,
        lambda inputs, most: growing(64, most),
        lambda model: [()],
        {"": in_hindsight},
        MOST_OF_SAMPLES,
    ),
]


def needed(peer, model, levels, seeds, most):
    """By choice of settings and level: fewest runs tried that come down to it, and stay there with the next number of runs,
    with their setting; None if none do. One number alone may be luck."""
    found = {choice: dict.fromkeys(levels) for choice in peer.choices}
    once = {choice: dict.fromkeys(levels) for choice in peer.choices}
    settings = peer.settings(model)
    for runs in peer.counts(len(model.laws), most):
        fits = {
            setting: [fit(peer.first_order, model, runs, seed, *([setting] if setting else [])) for seed in seeds]
            for setting in settings
        }
        for choice, choose in peer.choices.items():
            error, setting = choose(fits)
            for level in levels:
                if error > level:
                    once[choice][level] = None
                elif once[choice][level] is None:
                    once[choice][level] = (runs, setting)
                elif found[choice][level] is None:
                    found[choice][level] = once[choice][level]
        if all(None not in reached.values() for reached in found.values()):
            break
        if runs >= HALVED_FROM:
            middle = {setting: statistics.median(error for error, _ in fits[setting]) for setting in settings}
            reached_tolerance = all(reached[max(levels)] for reached in found.values())
            kept = KEPT_AT_TOLERANCE if reached_tolerance else max(KEPT, len(settings) // 2)
            settings = sorted(settings, key=middle.get)[:kept]
    return found


def measure(name, program, tolerance, seeds):
    """Runs of everyone for a model: at strainsite's own true error, and at the tolerance."""
    (model,) = peer_models.models([name])
    with tempfile.TemporaryDirectory() as folder:
        ours = [strainsite_runs.auto(program, model, tolerance, seed, pathlib.Path(folder)) for seed in seeds]
    middle = {key: statistics.median(one[key] for one in ours) for key in ("runs", "error", "claimed")}
    level = max(middle["error"], ROUNDING)
    levels = sorted({level, max(level, tolerance)})

    result = {
        **middle,
        "most_runs": max(one["runs"] for one in ours),
        "worst_error": max(one["error"] for one in ours),
        "covered": sum(one["error"] <= one["claimed"] for one in ours),
        "method": ", ".join(sorted({one["method"] for one in ours})),
    }
    for peer in PEERS:
        most = max(peer.most_runs, int(middle["runs"] * STEP))
        for choice, found in needed(peer, model, levels, seeds, most).items():
            result[column(peer, choice)] = {"same": found[level], "tolerance": found[levels[-1]], "most": most}
    return name, result


def column(peer, choice):
    return f"{peer.title}, {choice}" if choice else peer.title


def cells(result, peer, choice, level):
    """Runs of a peer, and their ratio to strainsite's."""
    found = result[column(peer, choice)]
    runs, sign = (found[level][0], "") if found[level] else (found["most"], "> ")
    return [f"{sign}{runs}", f"{sign}{runs / result['runs']:.1f}"]


def table(results, level):
    titles = ["model", "strainsite", "answered by", "true error", "claimed"]
    columns = [(peer, choice) for peer in PEERS for choice in peer.choices]
    for peer, choice in columns:
        titles += [column(peer, choice), "ratio"]
    lines = ["| " + " | ".join(titles) + " |", "| " + " | ".join("---" for _ in titles) + " |"]
    for name, result in results:
        row = [name, f"{result['runs']:.0f}", result["method"], f"{result['error']:.1e}", f"{result['claimed']:.1e}"]
        for peer, choice in columns:
            row += cells(result, peer, choice, level)
        lines.append("| " + " | ".join(row) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--models", default=",".join(peer_models.FORMULAS))
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--tolerance", type=float, default=0.02)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--program", type=pathlib.Path, help="a strainsite that is built already")
    arguments = parser.parse_args()
    program = (arguments.program or build()).resolve()
    results = []
    with ProcessPoolExecutor(arguments.processes) as pool:
        asked = [
            pool.submit(measure, name, program, arguments.tolerance, range(1, arguments.seeds + 1))
            for name in arguments.models.split(",")
        ]
        for one in asked:
            results.append(one.result())
            print(json.dumps(results[-1]), file=sys.stderr, flush=True)
    tolerance = arguments.tolerance
    print(f"Runs at strainsite's own true error, medians of {arguments.seeds} seeds:\n\n{table(results, 'same')}\n")
    print(f"Runs at a true error of {tolerance}, medians of {arguments.seeds} seeds:\n\n{table(results, 'tolerance')}")


if __name__ == "__main__":
    main()
