"""Writes `estimation/tests/data/gpr.json`: what scikit-learn says of small data sets whose formulas are stated there.

python exact_figures.py             # the small data set; a large one that is in the file stays
python exact_figures.py --large     # the large one, with the other figures kept; minutes

Tests in Rust make the same rows from the formulas and compare.
"""

import argparse
import json
import math
import pathlib
import time
import warnings

import numpy as np
import scipy
import sklearn
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel
from sklearn.neural_network import MLPRegressor

FILE = pathlib.Path(__file__).resolve().parents[3] / "estimation" / "tests" / "data" / "gpr.json"
ROWS, FEATURES, NEW_ROWS = 60, 3, 5
LARGE_ROWS, LARGE_FEATURES = 1500, 15
# Ranges of variance, lengths and noise: those of `Bounds` in estimation/src/model/gpr/hyperparameters.rs.
VARIANCE, LENGTH, NOISE = (1e-3, 1e4), (1e-2, 1e4), (1e-6, 1e1)
RESTARTS = 50
# Hyperparameters that nothing has been learnt for.
FIXED = {
    "shared": {"variance": 1.7, "lengths": [0.9], "noise": 0.05},
    "each": {"variance": 1.7, "lengths": [0.9, 1.4, 2.3], "noise": 0.05},
}
NETWORK = {"hidden_layer_sizes": (8,), "activation": "tanh", "alpha": 1e-3, "max_iter": 5000, "tol": 1e-12}
NETWORKS = 10

FORMULA = {
    "x": "x[i][j] = sin(0.7 * i * (j + 1) + j), i = 0..n-1, j = 0..d-1",
    "y": "y[i] = 3 + 2 * sin(2 * x[i][0]) + x[i][1] * x[i][2] + 0.2 * sin(5 * i * i)",
    "new": "new[k][j] = 0.9 * cos(1.3 * k + 2 * j), k = 0..4",
    "z": "z[i] = (y[i] - y_mean) / y_std, y_std with divisor n",
}
LARGE_FORMULA = {
    "press": "p = 1 - cos(0.05 * i)",
    "place": "a = sin(0.0071 * i), b = cos(0.0113 * i)",
    "x": "x[i][j] = p * (1 + 0.5 * sin(j + 2 * a) + 0.3 * cos(2 * j + b)) + 0.02 * sin((j + 3) * i * i)",
    "y": "y[i] = 8 * p + 3 * p * p * (1 + 0.2 * a * b) + 0.5 * sin(7 * i * i)",
    "z": FORMULA["z"],
}


def rows(n):
    """Features and values of the small data set; library functions of one number, as Rust's are."""
    x = np.array([[math.sin(0.7 * i * (j + 1) + j) for j in range(FEATURES)] for i in range(n)])
    y = [3 + 2 * math.sin(2 * x0) + x1 * x2 + 0.2 * math.sin(5 * i * i) for i, (x0, x1, x2) in enumerate(x)]
    return x, np.array(y)


def new_rows():
    """Points that nothing was measured at."""
    return np.array([[0.9 * math.cos(1.3 * k + 2 * j) for j in range(FEATURES)] for k in range(NEW_ROWS)])


def large_rows():
    """Features and values that resemble a soft sensor pressed 9 to 10 times at wandering places."""
    x, y = np.zeros((LARGE_ROWS, LARGE_FEATURES)), np.zeros(LARGE_ROWS)
    for i in range(LARGE_ROWS):
        p, a, b = 1 - math.cos(0.05 * i), math.sin(0.0071 * i), math.cos(0.0113 * i)
        for j in range(LARGE_FEATURES):
            shape = 1 + 0.5 * math.sin(j + 2 * a) + 0.3 * math.cos(2 * j + b)
            x[i, j] = p * shape + 0.02 * math.sin((j + 3) * i * i)
        y[i] = 8 * p + 3 * p * p * (1 + 0.2 * a * b) + 0.5 * math.sin(7 * i * i)
    return x, y


def scaled(y):
    """Values with mean 0 and standard deviation 1."""
    return (y - y.mean()) / y.std()


def kernel(variance, lengths, noise):
    """v RBF(l) + n, with the ranges of the search."""
    length = lengths[0] if len(lengths) == 1 else lengths
    signal = ConstantKernel(variance, VARIANCE) * RBF(length, LENGTH)
    return signal + WhiteKernel(noise, NOISE)


def fixed(hyperparameters, x, z):
    """A process whose hyperparameters stay; alpha = 0, so that nothing but the noise is on the diagonal."""
    return GaussianProcessRegressor(kernel(**hyperparameters), alpha=0.0, optimizer=None).fit(x, z)


def left_out(hyperparameters, x, z):
    """Mean and deviation of each row, by a process of all others."""
    means, deviations = [], []
    for i in range(len(z)):
        others = np.arange(len(z)) != i
        mean, deviation = fixed(hyperparameters, x[others], z[others]).predict(x[[i]], return_std=True)
        means.append(float(mean[0]))
        deviations.append(float(deviation[0]))
    return means, deviations


def at_fixed(hyperparameters):
    """Everything about a process with these hyperparameters, of scaled values z."""
    x, y = rows(ROWS)
    z = scaled(y)
    process = fixed(hyperparameters, x, z)
    value, gradient = process.log_marginal_likelihood(process.kernel_.theta, eval_gradient=True)
    mean, deviation = process.predict(new_rows(), return_std=True)
    left_out_mean, left_out_std = left_out(hyperparameters, x, z)
    return {
        **hyperparameters,
        "theta": process.kernel_.theta.tolist(),
        "log_likelihood": float(value),
        "gradient": gradient.tolist(),
        "new_mean": mean.tolist(),
        "new_std": deviation.tolist(),
        "left_out_mean": left_out_mean,
        "left_out_std": left_out_std,
    }


def optimum(x, y, lengths, restarts):
    """The greatest likelihood that restarts find."""
    start = {"variance": 1.0, "lengths": [1.0] * lengths, "noise": 0.01}
    wanted = {"alpha": 0.0, "normalize_y": True, "n_restarts_optimizer": restarts, "random_state": 1}
    process = GaussianProcessRegressor(kernel(**start), **wanted).fit(x, y)
    theta = process.kernel_.theta
    found = {
        "restarts": restarts,
        "log_likelihood": float(process.log_marginal_likelihood(theta)),
        "theta": theta.tolist(),
        "gradient": process.log_marginal_likelihood(theta, eval_gradient=True)[1].tolist(),
    }
    return process, found


def small_optimum(lengths):
    """The optimum of the small data set, and what it says of the new points, in the unit of y."""
    x, y = rows(ROWS)
    process, found = optimum(x, y, lengths, RESTARTS)
    mean, deviation = process.predict(new_rows(), return_std=True)
    return {**found, "new_mean": mean.tolist(), "new_std": deviation.tolist()}


def networks():
    """The least loss that each network comes down to."""
    x, y = rows(ROWS)
    z = scaled(y)
    losses = [
        float(MLPRegressor(solver="lbfgs", random_state=seed, max_fun=10**6, **NETWORK).fit(x, z).loss_)
        for seed in range(NETWORKS)
    ]
    return {
        "settings": {**NETWORK, "solver": "lbfgs", "targets": "z", "random_states": list(range(NETWORKS))},
        "loss": "mean over rows of (output - z)^2 / 2, plus alpha / (2 n) times squared weights, biases apart",
        "losses": losses,
        "least_loss": min(losses),
    }


def small():
    """All figures of the small data set."""
    x, y = rows(ROWS)
    return {
        "versions": {"scikit-learn": sklearn.__version__, "numpy": np.__version__, "scipy": scipy.__version__},
        "kernel": "v exp(-1/2 sum_j ((x_j - x'_j) / l_j)^2), noise n added to the diagonal; no other jitter",
        "theta_order": "ln v, then ln l (one, or one for each feature), then ln n",
        "std": "of a new reading, its noise included",
        "bounds": {"variance": VARIANCE, "length": LENGTH, "noise": NOISE},
        "small": {
            "n": ROWS,
            "d": FEATURES,
            "formula": FORMULA,
            "check": {"x_last": x[-1].tolist(), "y_last": float(y[-1]), "new_last": new_rows()[-1].tolist()},
            "y_mean": float(y.mean()),
            "y_std": float(y.std()),
            "fixed": {name: at_fixed(hyperparameters) for name, hyperparameters in FIXED.items()},
            "optimum": {"shared": small_optimum(1), "each": small_optimum(FEATURES)},
            "network": networks(),
        },
    }


def large(restarts):
    """The optimum of the large data set, with one length."""
    x, y = large_rows()
    began = time.perf_counter()
    _, found = optimum(x, y, 1, restarts)
    seconds = time.perf_counter() - began
    return {
        "n": LARGE_ROWS,
        "d": LARGE_FEATURES,
        "formula": LARGE_FORMULA,
        "check": {"x_last": x[-1].tolist(), "y_last": float(y[-1])},
        "y_mean": float(y.mean()),
        "y_std": float(y.std()),
        "optimum": {"shared": {**found, "seconds": seconds}},
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--large", action="store_true")
    parser.add_argument("--restarts", type=int, default=RESTARTS, help="of the large one")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=FILE)
    arguments = parser.parse_args()
    # That a hyperparameter ends at its bound, or a network at its iterations, is seen in the figures.
    warnings.simplefilter("ignore", ConvergenceWarning)
    if arguments.large:
        data = large(arguments.restarts)
    # Read late: the small figures may have been written meanwhile.
    figures = json.loads(arguments.output.read_text()) if arguments.output.exists() else {}
    if arguments.large:
        figures["large"] = data
    else:
        figures |= small()
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    # Floats are written with the fewest digits that read back bit for bit.
    arguments.output.write_text(json.dumps(figures, indent=1) + "\n")


if __name__ == "__main__":
    main()
