"""Runs the same tire in strainsite, CalculiX and FElupe and prints a Markdown table.

python measure_tires.py [--sizes small,middle,large] [--runs 5] [--programs strainsite,calculix,felupe] [--keep FOLDER]
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
COLUMNS = [
    ("wall_s", "wall s", "{:.2f}"),
    ("peak_mb", "peak MB", "{:.0f}"),
    ("warm_wall_s", "warm point s", "{:.2f}"),
    ("iterations", "iterations", "{:.0f}"),
    ("reaction_n", "reaction N", "{:.3f}"),
    ("y", "strain y", "{:.4f}"),
    ("x", "strain x", "{:.4f}"),
    ("y_since_inflation", "y since inflation", "{:.4f}"),
    ("x_since_inflation", "x since inflation", "{:.4f}"),
]


def build():
    """The Rust program."""
    command = ["cargo", "build", "--release", "--locked", "-q", "-p", "lab", "--example", "peers"]
    subprocess.run(command, cwd=ROOT, check=True)
    target = os.environ.get("CARGO_TARGET_DIR", ROOT / "target")
    return pathlib.Path(target) / "release" / "examples" / "peers"


def run(command, folder, threads):
    """Output, wall time (s) and peak memory (MB) of a process."""
    environment = {**os.environ, "OMP_NUM_THREADS": str(threads), "MKL_NUM_THREADS": str(threads)}
    with open(folder / "output", "w+") as output:
        begin = time.perf_counter()
        child = subprocess.Popen(
            [str(word) for word in command], cwd=folder, stdout=output, stderr=subprocess.STDOUT, env=environment
        )
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.perf_counter() - begin
        child.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    if child.returncode != 0:
        sys.exit(f"{command[0]} ended with {child.returncode}:\n{text[-2000:]}")
    return text, wall, usage.ru_maxrss / 1024


def last_json(text):
    return json.loads(text.strip().splitlines()[-1])


def strainsite(peers, size, folder, threads):
    text, _, peak = run([peers, "solve", size], folder, threads)
    return {**last_json(text), "peak_mb": peak}


def calculix(peers, size, folder, threads):
    _, wall, peak = run(["ccx", size], folder, threads)
    states, force = [], None
    for line in (folder / f"{size}.dat").read_text().splitlines():
        words = line.split()
        if "for set" in line:
            displacements = words[0] == "displacements"
            if displacements:
                states.append([])
        elif words and displacements:
            states[-1].append(" ".join(words[1:]))
        elif words:
            force = float(words[2])
    (folder / "displacements").write_text("\n".join(line for state in states for line in state))
    lines = (folder / f"{size}.cvg").read_text().splitlines()
    iterations = sum(line.split()[:1] == ["1"] for line in lines)
    strains = last_json(run([peers, "read", size, "displacements"], folder, 1)[0])
    return {**strains, "wall_s": wall, "peak_mb": peak, "iterations": iterations, "reaction_n": force}


def felupe(peers, size, folder, threads):
    script = HERE / "felupe_tire.py"
    text, _, peak = run([sys.executable, script, f"{size}.inp", "displacements"], folder, threads)
    strains = last_json(run([peers, "read", size, "displacements"], folder, 1)[0])
    return {**strains, **last_json(text), "peak_mb": peak}


PROGRAMS = {"strainsite": strainsite, "calculix": calculix, "felupe": felupe}


def measure(peers, size, programs, runs, threads, folder):
    """Medians of each program at a size. Programs take turns, so that a busy minute doesn't hit one of them alone."""
    (folder / f"{size}.inp").write_text(subprocess.run([peers, "deck", size], check=True, capture_output=True, text=True).stdout)
    results = {name: [] for name in programs}
    for _ in range(runs):
        for name in programs:
            results[name].append(PROGRAMS[name](peers, size, folder, threads))
            print(size, name, json.dumps(results[name][-1]), file=sys.stderr)
    return {
        name: {key: statistics.median(result[key] for result in found) for key in found[0]}
        for name, found in results.items()
    }


def table(medians):
    titles = ["nodes", "program"] + [title for _, title, _ in COLUMNS] + ["wall / strainsite's", "memory / strainsite's"]
    lines = ["| " + " | ".join(titles) + " |", "| " + " | ".join("---" for _ in titles) + " |"]
    for programs in medians.values():
        base = programs.get("strainsite")
        for name, result in programs.items():
            cells = [f"{result['nodes']:.0f}", name]
            cells += [form.format(result[key]) if key in result else "" for key, _, form in COLUMNS]
            cells += [f"{result[key] / base[key]:.1f}" if base else "" for key in ("wall_s", "peak_mb")]
            lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sizes", default="small,middle,large")
    parser.add_argument("--programs", default="strainsite,calculix,felupe")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for decks and outputs; a temporary one when absent")
    arguments = parser.parse_args()
    peers = build()
    medians = {}
    with tempfile.TemporaryDirectory() as temporary:
        folder = (arguments.keep or pathlib.Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        for size in arguments.sizes.split(","):
            medians[size] = measure(
                peers, size, arguments.programs.split(","), arguments.runs, arguments.threads, folder
            )
    print(f"Medians of {arguments.runs} runs, {arguments.threads} threads, relative residual 1e-6:\n")
    print(table(medians))


if __name__ == "__main__":
    main()
