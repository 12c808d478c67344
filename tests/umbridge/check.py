"""Asks a tire as PyPI's umbridge asks models, and has `strainsite gsa run` ask one that the package serves.

Usage: check.py PROGRAM FOLDER
"""

import contextlib
import http.client
import json
import math
import socket
import subprocess
import sys
import time
from pathlib import Path

import emcee
import numpy as np
import umbridge

import toy_model

HERE = Path(__file__).resolve().parent
STUDY = HERE.parents[1] / "studies" / "foot-tire.toml"
PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
AT_ONCE = 100
LIMIT_S = 100
MOST_OWN_MS = 2.0
STEPS = 120


@contextlib.contextmanager
def running(*command, **options):
    """A process that ends with the block."""
    process = subprocess.Popen(command, cwd=FOLDER, text=True, **options)
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def program(*arguments):
    """What the program prints, and what it says, when it succeeds."""
    ran = subprocess.run([PROGRAM, *arguments], cwd=FOLDER, capture_output=True, text=True, timeout=LIMIT_S)
    assert ran.returncode == 0, (arguments, ran.stderr)
    return ran.stdout, ran.stderr


def refused(ask, words):
    """Sees that a question is refused in these words."""
    try:
        found = ask()
    except Exception as error:
        assert words in str(error), error
        return
    raise AssertionError(f"{found} instead of a refusal: {words}")


def tire_is_asked():
    """Every operation of the protocol, and depths of the ground that a sampler finds from strains."""
    serve = [PROGRAM, "umbridge", str(STUDY), "--set", "accuracy.preset=draft", "--addr", "127.0.0.1:0"]
    with running(*serve, stdout=subprocess.PIPE) as served:
        url = served.stdout.readline().strip().removeprefix("listening on ")
        assert umbridge.supported_models(url) == ["forward"]
        tire = umbridge.HTTPModel(url, "forward")
        assert (tire.get_input_sizes(), tire.get_output_sizes()) == ([5], [5, 5, 1])
        assert tire.supports_evaluate() and tire.supports_gradient() and tire.supports_apply_jacobian()
        assert not tire.supports_apply_hessian()
        derivatives_agree(tire)
        refused(lambda: tire([[1.0, 1.0]]), "5 numbers")
        refused(lambda: tire([[1.0] * 5], {"level": "x"}), "level is one of")
        refused(lambda: umbridge.HTTPModel(url, "backward"), "backward")
        sampled(tire)


def derivatives_agree(tire):
    """Derivatives against each other, and against differences of values."""
    at, step, by = np.array([1, 1.1, 0.9, 1, 1.2]), 1e-4, np.array([0.3, -1, 0.5, 0.2, 0.7])
    above, below = (tire([(at + sign * step * by).tolist()]) for sign in (1, -1))
    for output, size in enumerate(tire.get_output_sizes()):
        along = np.array(tire.apply_jacobian(output, 0, [at.tolist()], by.tolist()))
        differences = (np.array(above[output]) - np.array(below[output])) / (2 * step)
        assert np.abs(along - differences).max() < 1e-3 * np.abs(along).max(), (along, differences)
        weights = np.linspace(1, 2, size)
        gradient = np.array(tire.gradient(output, 0, [at.tolist()], weights.tolist()))
        assert math.isclose(gradient @ by, weights @ along, rel_tol=1e-9), (gradient, along)


def sampled(tire):
    """Depths that gave strains with noise are within three standard deviations of those that emcee finds."""
    truth, noise, random = np.array([1, 1.05, 0.95, 1.1, 0.9]), 2e-4, np.random.default_rng(1)
    x, y, _ = tire([truth.tolist()])
    data = np.array(x + y) + noise * random.normal(size=10)

    def log_probability(depths):
        if np.any(depths < 0.7) or np.any(depths > 1.3):
            return -np.inf
        x, y, _ = tire([depths.tolist()])
        return -0.5 * np.sum(((np.array(x + y) - data) / noise) ** 2)

    sampler = emcee.EnsembleSampler(12, 5, log_probability)
    sampler._random.seed(1)
    begun = time.monotonic()
    sampler.run_mcmc(1 + 0.02 * random.normal(size=(12, 5)), STEPS)
    chain = sampler.get_chain(discard=STEPS // 2, flat=True)
    apart = np.abs(chain.mean(0) - truth) / chain.std(0)
    assert apart.max() < 3, (chain.mean(0), chain.std(0))
    print(f"emcee: 12 walkers, {STEPS} steps in {time.monotonic() - begun:.1f} s, {apart.max():.1f} standard deviations from the truth at most")


def write_inputs(method):
    """Three uniform inputs."""
    law = f'distribution = {{ kind = "uniform", min = {-math.pi!r}, max = {math.pi!r} }}'
    inputs = "".join(f'[[inputs]]\nname = "x{k}"\n{law}\n' for k in (1, 2, 3))
    (FOLDER / "inputs.toml").write_text(f"{inputs}[method]\n{method}\n")


def planned_and_analysed():
    """Indices by `gsa plan` and `gsa analyse`, with the function called here."""
    values = FOLDER / "told.csv"
    values.write_text("id,y1,y2\n")
    arguments = ["gsa", "plan", "inputs.toml"]
    while rows := program(*arguments)[0].splitlines()[1:]:
        with values.open("a") as table:
            for row in rows:
                point, *x = row.split(",")
                table.write(",".join([point, *map(repr, toy_model.values([float(cell) for cell in x]))]) + "\n")
        arguments = ["gsa", "plan", "inputs.toml", "--values", values.name]
    return program("gsa", "analyse", "inputs.toml", values.name, "--json", "-")[0]


def ran():
    """Points that the model ran, by how often; they are forgotten."""
    file = FOLDER / "ran"
    lines = file.read_text().splitlines() if file.exists() else []
    file.unlink(missing_ok=True)
    return {line: lines.count(line) for line in set(lines)}


def points_so_far():
    file = FOLDER / "ran"
    return file.read_text().count("\n") if file.exists() else 0


def killed_and_started_again(ask):
    """Indices are those of plan and analyse though the command was killed twice, and no point but those in flight is run twice."""
    for number, method in enumerate(('kind = "saltelli"\nsamples = 256', 'kind = "auto"', 'kind = "mdrm"')):
        write_inputs(method)
        expected, kills = planned_and_analysed(), 0
        asking = [*ask, "--config", '{"seconds": 0.05}', "--at-once", str(AT_ONCE), "--db", f"{number}.db", "--json", "-"]
        for wanted in (5, 150, 500):
            with running(PROGRAM, *asking, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as killed:
                begun = time.monotonic()
                while points_so_far() < wanted and killed.poll() is None and time.monotonic() - begun < LIMIT_S:
                    time.sleep(0.002)
                kills += killed.poll() is None
        found, said = program(*asking)
        counts = ran()
        twice = sum(counts.values()) - len(counts)
        assert found == expected, (found, expected)
        assert kills > 0 and twice <= kills * AT_ONCE, (kills, twice)
        print(f"{method.split()[2]}: {said.splitlines()[0]}; {AT_ONCE} at once, {kills} kills, {twice} in flight and run again; the indices of plan and analyse, to the bit")


def failures_are_told(ask):
    """A model that raises an exception or answers with NaN has failed runs."""
    write_inputs('kind = "mdrm"\nnodes = 7')
    found, said = program(*ask, "--config", '{"raises_beyond": 2.9, "nan_below": -2.9}', "--db", "failed.db", "-o", "values.csv", "--json", "-")
    assert found == program("gsa", "analyse", "inputs.toml", "values.csv", "--json", "-")[0]
    assert "3 failed" in said and "HTTP 500" in said and "isn't finite" in said, said
    print("; ".join(said.splitlines()[:4]))


def time_is_small(ask, port):
    """Time of a run that isn't the model's: beside a bare client on one connection."""
    write_inputs('kind = "saltelli"\nsamples = 256')
    ran()
    begun = time.monotonic()
    program(*ask, "--db", "timed.db")
    wall = time.monotonic() - begun
    points = [json.loads(line) for line in ran()]
    connection = http.client.HTTPConnection("127.0.0.1", port)
    begun = time.monotonic()
    for x in points:
        connection.request("POST", "/Evaluate", json.dumps({"name": "toy", "input": [x[:1], x[1:]], "config": {}}))
        assert connection.getresponse().read()
    bare = time.monotonic() - begun
    ours, alone = (1e3 * seconds / len(points) for seconds in (wall, bare))
    assert ours - alone < MOST_OWN_MS, (ours, alone)
    print(f"one at a time: {ours:.2f} ms a run, planned, stored and analysed; a bare client in Python {alone:.2f} ms")


tire_is_asked()
with socket.create_server(("127.0.0.1", 0)) as free:
    port = free.getsockname()[1]
with running(sys.executable, str(HERE / "toy_model.py"), str(port), "ran", stderr=subprocess.DEVNULL):
    # The command waits for a server that isn't there yet.
    ask = ["gsa", "run", "inputs.toml", "--model", f"http://127.0.0.1:{port}"]
    killed_and_started_again(ask)
    failures_are_told(ask)
    time_is_small(ask, port)
