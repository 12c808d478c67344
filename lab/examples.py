#!/usr/bin/env python3
"""Records the examples in the service's description: what the program answers to each operation, with its lists cut short.

python3 lab/examples.py [PROGRAM]   writes server/src/http/generated/examples.json; PROGRAM is target/release/strainsite when left out

It is run again when an answer has a new field: tests/schemas holds each example against its operation's schema.
"""

import contextlib
import json
import re
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FILE = ROOT / "server/src/http/generated/examples.json"
# Entries of a list that are kept: numbers and words, and all else.
KEPT = {True: 3, False: 1}
DEPTHS = [{"name": f"P{k}", "vary": f"ground.depths_mm[{k - 1}]", "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}} for k in (2, 3)]
STUDY = {
    "name": "two depths",
    "scene": {"preset": "foot-tire"},
    "inputs": DEPTHS,
    "method": {"kind": "mdrm", "nodes": 3},
    "candidates": {"grid": {"circumferential": 5, "meridional": 3}},
    "accuracy": {"preset": "draft"},
    "layouts": {"spacings_deg": [60], "positions": ["crown"]},
    "signals": {"loads_n": [5, 10, 15], "films": ["coupled"], "positions": ["crown"], "directions": ["x"]},
}
PLAIN = {name: part for name, part in STUDY.items() if name not in ("layouts", "signals", "candidates")}
SCENE = {
    "scene": {"preset": "foot-tire", "model": {"level": "draft"}},
    "gauges": [{"theta_deg": 0, "phi_deg": 45, "angle_deg": 90}],
    "derivatives": ["pressure.internal_mpa"],
}
FILMS = [{"theta_deg": 0, "phi_deg": 0, "angle_deg": 90}, {"theta_deg": 60, "phi_deg": 0, "angle_deg": 0}]


def run(file, noise):
    """A recording of two signals that follow a force, with something off that differs from run to run."""
    rows = "".join(f"{k / 100},{2 * force}.{k * noise % 7},{9 - force}.{k * noise % 7},{force}\n" for k, force in enumerate([0, 3, 5, 2] * 6))
    return {"file": file, "text": "time_s,s1,s2,fz_n\n" + rows}


RUNS = [run("monday.csv", 3), run("tuesday.csv", 5)]
RECIPE = {"columns": {"forces": "fz_n", "threshold_n": 0.5}, "models": {"kinds": ["ridge"]}}
ANSWERS = "locations layouts candidates signals evaluations rings sections layouts/fields map result export?format=json".split()
# Other machines are this one.
ENGINE = ["--engine", "command", "--engine-command", 'for task in $TASKS; do "$PROGRAM" tasks run "$FOLDER" $task; done']
TRADE = ["trade", "--up-to", "coarse", "--reference-level", "coarse", "--reference-method", "mdrm"]


@contextlib.contextmanager
def service(program):
    """Address of a service with a database of its own, which knows the trade of the plain study."""
    with tempfile.TemporaryDirectory() as folder:
        database = ["--db", f"{folder}/studies.db"]
        Path(f"{folder}/plain.json").write_text(json.dumps(PLAIN))
        subprocess.run([program, *TRADE, *database, f"{folder}/plain.json"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        command = [program, "serve", "--addr", "127.0.0.1:0", *ENGINE, *database]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as running:
            try:
                yield next(line.split()[-1] for line in running.stdout if line.startswith("listening on "))
            finally:
                running.terminate()


class Recorder:
    """Requests to a service, and the answers to each operation."""

    def __init__(self, url):
        self.url, self.examples = url, {}

    def ask(self, method, path, body=None):
        """The answer, which is the operation's example: the path without identifiers and query."""
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.url + path, data, {"content-type": "application/json"}, method=method)
        with urllib.request.urlopen(request) as answer:
            told = json.load(answer)
        operation = re.sub(r"[0-9a-f-]{36}", "{id}", path).partition("?")[0]
        self.examples[f"{method.lower()} {operation}"] = shortened(told)
        return told

    def wait(self, path):
        for _ in range(600):
            with urllib.request.urlopen(self.url + path) as answer:
                state = json.load(answer)["state"]
            if state not in ("queued", "running"):
                assert state == "done", f"{path} {state}"
                return
            time.sleep(0.1)
        raise SystemExit(f"{path} takes too long")


def shortened(told):
    """The answer with the beginnings of its lists."""
    if isinstance(told, dict):
        return {name: shortened(part) for name, part in told.items()}
    if isinstance(told, list):
        is_plain = not any(isinstance(entry, (dict, list)) for entry in told)
        return [shortened(entry) for entry in told[: KEPT[is_plain]]]
    return told


def record(ask, wait):
    """Asks for every operation that answers with JSON."""
    for path in ("/healthz", "/readyz", "/v1/presets"):
        ask("GET", path)
    record_studies(ask, wait)
    record_sweeps(ask, wait)
    record_estimators(ask, wait)
    record_analyses(ask)


def record_studies(ask, wait):
    ask("POST", "/v1/studies:estimate", STUDY)
    ask("POST", "/v1/studies:preview", PLAIN)
    ask("POST", "/v1/scenes:solve", SCENE)
    traded, study = [f"/v1/studies/{ask('POST', '/v1/studies', document)['id']}" for document in (PLAIN, STUDY)]
    wait(traded)
    ask("GET", f"{traded}/trade")
    wait(study)
    for part in ANSWERS:
        ask("GET", f"{study}/{part}")
    ask("POST", f"{study}/layouts:score", {"layouts": [{"name": "mine", "films": FILMS}], "simulated": True})
    ask("GET", study)
    ask("PATCH", study, {"archived": True})
    ask("DELETE", study)
    ask("GET", "/v1/studies?limit=1")


def record_sweeps(ask, wait):
    document = {"name": "two walls", "study": PLAIN, "grid": {"geometry.wall_mm": [2.5, 3]}}
    ask("POST", "/v1/sweeps:estimate", document)
    identity = ask("POST", "/v1/sweeps?engine=command", document)["id"]
    sweep = f"/v1/sweeps/{identity}"
    wait(sweep)
    ask("POST", f"{sweep}/designs", {"designs": [{"name": "thick", "set": {"geometry.wall_mm": 3.5}}]})
    wait(sweep)
    ask("GET", sweep)
    ask("GET", "/v1/sweeps")
    ask("GET", "/v1/engines")
    ask("PATCH", sweep, {"archived": True})
    ask("POST", f"{sweep}/resume")
    ask("DELETE", sweep)
    ask("GET", f"/v1/comparison?sweep={identity}")
    ask("GET", f"/v1/comparison/export?sweep={identity}&format=json")


def record_analyses(ask):
    """A sum of two inputs at the points that its method asks for."""
    inputs = [{"name": name, "distribution": {"kind": "uniform", "min": 0, "max": 1}} for name in "ab"]
    document = {"inputs": inputs, "method": {"kind": "mdrm", "nodes": 3, "check_points": 2}}
    points = ask("POST", "/v1/analyses", document)["points"]
    values = {"outputs": ["y"], "ids": points["ids"], "rows": [[a + 2 * b] for a, b in points["rows"]]}
    # Without the last one, so that a point is still to be run.
    ask("POST", "/v1/analyses", document | {"method": {"kind": "auto", "nodes": 3, "check_points": 2}, "values": values})


def record_estimators(ask, wait):
    ask("POST", "/v1/recordings:look", {"recipe": RECIPE, "recordings": RUNS})
    estimator = f"/v1/estimators/{ask('POST', '/v1/estimators', {'name': 'rig, week 47', 'recipe': RECIPE, 'recordings': RUNS})['id']}"
    wait(estimator)
    for part in ("", "/report", "/left-out"):
        ask("GET", estimator + part)
    ask("POST", f"{estimator}:zero", {"file": "rest.csv", "text": "time_s,s1,s2\n0,0.1,9\n0.01,0.2,9.1\n"})
    ask("DELETE", estimator)
    ask("GET", "/v1/estimators")


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/release/strainsite")
    with service(program) as url:
        recorder = Recorder(url)
        record(recorder.ask, recorder.wait)
    lines = [f"{json.dumps(name)}: {json.dumps(example, ensure_ascii=False)}" for name, example in sorted(recorder.examples.items())]
    FILE.write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main()
