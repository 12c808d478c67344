"""Trains nine scikit-learn variants on runs and says what they estimate of a run that they haven't seen.

python nine_variants.py RUN.csv ... --test RUN.csv [--rolling-start-off] [--json FILE]

Three models, each on three kinds of features:

| model | its 95 % intervals |
|---|---|
| ridge, its weight chosen by leave-one-out | 95 % of the residuals of left-out blocks of the training runs |
| gpr: ConstantKernel * RBF + WhiteKernel on an even subset of at most 800 rows | 1.96 predictive standard deviations |
| mlp: 50 nodes, Adam, on at most 4000 rows | as ridge's |

| features | |
|---|---|
| raw | the signals |
| start | the signals, the run's first reading taken off |
| rolling | mean, variance and slope of the last 10 rows of the signals |
"""

import argparse
import csv
import json
import pathlib
import statistics
import time
import warnings

import numpy as np
from sklearn.compose import TransformedTargetRegressor
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel
from sklearn.linear_model import RidgeCV
from sklearn.neural_network import MLPRegressor
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

WINDOW = 10
GPR_ROWS, MLP_ROWS = 800, 4000
# Runs are cut into so many blocks of equal duration; a fold leaves out every fifth.
BLOCKS, FOLDS = 10, 5
PROMISE = 0.95
MODELS, FEATURES = ("ridge", "gpr", "mlp"), ("raw", "start", "rolling")
FORCES = ("fx_n", "fy_n", "fz_n")


def read(file):
    """Times, signals and forces of a run; NaN where a force wasn't measured."""
    with open(file, newline="") as lines:
        header, *rows = csv.reader(lines)
    numbers = np.array([[float(x) if x else np.nan for x in row] for row in rows])
    signals = [k for k, name in enumerate(header) if name != "time_s" and name not in FORCES]
    forces = {name: numbers[:, k] for k, name in enumerate(header) if name in FORCES}
    return numbers[:, header.index("time_s")], numbers[:, signals], forces


def rolling(time_s, signals):
    """Mean, variance and slope of the last rows; of fewer at the beginning."""
    found = np.zeros((len(signals), 3, signals.shape[1]))
    for k in range(len(signals)):
        rows = slice(max(0, k + 1 - WINDOW), k + 1)
        values, times = signals[rows], time_s[rows] - time_s[rows].mean()
        found[k, 0], found[k, 1] = values.mean(axis=0), values.var(axis=0)
        found[k, 2] = times @ values / (times @ times) if k else 0.0
    return found.reshape(len(signals), -1)


def features(kind, time_s, signals, rolling_start_off):
    """What a model is given of a run."""
    off = signals - signals[0]
    if kind == "rolling":
        return rolling(time_s, off if rolling_start_off else signals)
    return off if kind == "start" else signals


def even_subset(rows, most):
    """Numbers of at most so many rows, evenly spread."""
    return np.unique(np.linspace(0, rows - 1, min(rows, most)).round().astype(int))


def fitted(model, x, y):
    """A model that was learnt, behind the scaling of its features."""
    if model == "ridge":
        return make_pipeline(StandardScaler(), RidgeCV(np.logspace(-3, 4, 15))).fit(x, y)
    rows = even_subset(len(y), GPR_ROWS if model == "gpr" else MLP_ROWS)
    if model == "gpr":
        signal = ConstantKernel(1.0, (1e-3, 1e4)) * RBF(np.sqrt(x.shape[1]), (1e-2, 1e4))
        kernel = signal + WhiteKernel(0.01, (1e-6, 10.0))
        regressor = GaussianProcessRegressor(kernel, normalize_y=True, n_restarts_optimizer=2, random_state=1)
    else:
        network = MLPRegressor(hidden_layer_sizes=(50,), max_iter=1000, random_state=1)
        regressor = TransformedTargetRegressor(network, transformer=StandardScaler())
    return make_pipeline(StandardScaler(), regressor).fit(x[rows], y[rows])


def estimate(model, x, y, block, x_test):
    """Estimates of new rows and half the widths of their 95 % intervals."""
    learnt = fitted(model, x, y)
    if model == "gpr":
        mean, deviation = learnt.predict(x_test, return_std=True)
        return mean, 1.959963984540054 * deviation
    residuals = []
    for fold in range(FOLDS):
        left_out = block % FOLDS == fold
        if left_out.any():
            residuals.append(np.abs(y[left_out] - fitted(model, x[~left_out], y[~left_out]).predict(x[left_out])))
    half = np.quantile(np.concatenate(residuals), PROMISE)
    return learnt.predict(x_test), np.full(len(x_test), half)


def interval_score(truth, low, high):
    """Width, and what the truth is outside at 2 / alpha (Gneiting and Raftery 2007, eq. 43), averaged over the rows."""
    outside = np.maximum(low - truth, 0.0) + np.maximum(truth - high, 0.0)
    return float(np.mean(high - low + 2.0 / (1.0 - PROMISE) * outside))


def rmse(residuals):
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(residuals))))


def figures(truth, mean, low, high):
    """How estimates with intervals fare."""
    return {
        "rmse_n": rmse(truth - mean),
        "coverage": float(np.mean((truth >= low) & (truth <= high))),
        "interval_score_n": interval_score(truth, low, high),
    }


def blocks(time_s):
    """The number of each row's block."""
    share = (time_s - time_s[0]) / (time_s[-1] - time_s[0])
    return np.minimum((BLOCKS * share).astype(int), BLOCKS - 1)


def nine(runs, test, rolling_start_off=False):
    """By force: the nine variants' figures on the test run, their median and best, and the training mean's."""
    warnings.simplefilter("ignore", ConvergenceWarning)
    read_runs = [read(file) for file in [*runs, test]]
    block = np.concatenate([blocks(time_s) for time_s, _, _ in read_runs[:-1]])
    rows_of = {kind: [features(kind, t, s, rolling_start_off) for t, s, _ in read_runs] for kind in FEATURES}
    result = {}
    for force in read_runs[-1][2]:
        y, truth = np.concatenate([run[2][force] for run in read_runs[:-1]]), read_runs[-1][2][force]
        known, tested = np.isfinite(y), np.isfinite(truth)
        y, truth = y[known], truth[tested]
        variants = {}
        for kind, of_runs in rows_of.items():
            x, x_test = np.concatenate(of_runs[:-1])[known], of_runs[-1][tested]
            for model in MODELS:
                began = time.perf_counter()
                mean, half = estimate(model, x, y, block[known], x_test)
                variants[f"{model} {kind}"] = figures(truth, mean, mean - half, mean + half)
                variants[f"{model} {kind}"]["seconds"] = time.perf_counter() - began
        result[force] = {"variants": variants, **over_variants(variants), "mean_rmse_n": rmse(truth - y.mean())}
    return result


def over_variants(variants):
    """Median and best of the variants."""
    errors = {name: found["rmse_n"] for name, found in variants.items()}
    scores = {name: found["interval_score_n"] for name, found in variants.items()}
    return {
        "median_rmse_n": statistics.median(errors.values()),
        "best_rmse_n": min(errors.values()),
        "best": min(errors, key=errors.get),
        "median_score_n": statistics.median(scores.values()),
        "best_score_n": min(scores.values()),
        "best_by_score": min(scores, key=scores.get),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", type=pathlib.Path)
    parser.add_argument("--test", type=pathlib.Path, required=True)
    parser.add_argument("--rolling-start-off", action="store_true", help="rolling features with the start value off")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    result = nine(arguments.runs, arguments.test, arguments.rolling_start_off)
    for force, found in result.items():
        print(f"{force}: RMSE of the training mean {found['mean_rmse_n']!r} N")
        print(f"  median of nine {found['median_rmse_n']!r} N, best {found['best_rmse_n']!r} N, {found['best']}")
        print(f"  interval score: best {found['best_score_n']!r} N, {found['best_by_score']}")
        print(f"  {'variant':14} {'RMSE, N':20} {'coverage':20} interval score, N")
        for name, variant in found["variants"].items():
            numbers = (variant["rmse_n"], variant["coverage"], variant["interval_score_n"])
            print(f"  {name:14} " + " ".join(f"{number!r:20}" for number in numbers))
    if arguments.json:
        arguments.json.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
