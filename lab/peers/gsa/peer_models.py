"""The models of `gsa/tests/data/mdrm.json` that are compared: formulas here, laws and exact indices there."""

import json
import pathlib
from dataclasses import dataclass
from typing import Callable

import numpy as np
from scipy import stats

DATA = pathlib.Path(__file__).resolve().parents[3] / "gsa" / "tests" / "data" / "mdrm.json"
# Largest relative difference from the values in the data file, which were computed with more digits.
FORMULA_ERROR = 1e-11


@dataclass
class Model:
    name: str
    # Each a kind and its two parameters.
    laws: list
    exact: np.ndarray
    formula: Callable

    def run(self, x):
        """Values at points, one row each."""
        return self.formula(*np.asarray(x).T)

    def quantiles(self, u):
        """Points of the inputs from points of the unit cube."""
        return np.column_stack([QUANTILES[kind](u[:, i], *p) for i, (kind, *p) in enumerate(self.laws)])

    def error(self, first_order):
        """Largest error of a first-order index."""
        return float(np.max(np.abs(np.asarray(first_order) - self.exact)))


QUANTILES = {
    "uniform": lambda u, low, high: low + (high - low) * u,
    "normal": lambda u, mean, std: stats.norm.ppf(u, mean, std),
    "lognormal": lambda u, mu, sigma: np.exp(stats.norm.ppf(u, mu, sigma)),
}


def borehole(r_w, r, t_u, h_u, t_l, h_l, length, k_w):
    log = np.log(r / r_w)
    return 2.0 * np.pi * t_u * (h_u - h_l) / (log * (1.0 + 2.0 * length * t_u / (log * r_w**2 * k_w) + t_u / t_l))


def piston(mass, surface, volume, spring, pressure, ambient, filling):
    a = pressure * surface + 19.62 * mass - spring * volume / surface
    v = surface / (2.0 * spring) * (np.sqrt(a**2 + 4.0 * spring * pressure * volume / filling * ambient) - a)
    return 2.0 * np.pi * np.sqrt(mass / (spring + surface**2 * pressure * volume * ambient / (filling * v**2)))


def product(*x):
    return np.prod(x, axis=0)


def sobol_g(*x):
    shares = [0.5, 1.0, 2.0, 5.0, 10.0]
    return product(*[(np.abs(4.0 * x - 2.0) + a) / (1.0 + a) for x, a in zip(x, shares)])


FORMULAS = {
    "ishigami": lambda a, b, c: np.sin(a) + 7.0 * np.sin(b) ** 2 + 0.1 * c**4 * np.sin(a),
    "poly_sign_change": lambda a, b, c: a + b + c + a * b * c,
    "piston": piston,
    "additive_linear_normal": lambda *x: 10.0 + sum((i + 1) * x for i, x in enumerate(x)),
    "h0_zero_rho_nonzero": lambda a, b, c: a**2 + b**2 + c**2,
    "shifted_product_plus": lambda *x: 10.0 + product(*[1.0 + s * x for s, x in zip([0.5, 0.3, 0.6, 0.2, 0.7], x)]),
    "product_5_lognormal": product,
    "product_5_uniform": product,
    "borehole_uniform": borehole,
    "borehole_normal_lognormal": borehole,
    "sobol_g_c": sobol_g,
}


def models(names):
    """The models of these names, their formulas checked."""
    entries = {entry["name"]: entry for entry in json.loads(DATA.read_text())["models"]}
    return [model(entries[name]) for name in names]


def model(entry):
    name = entry["name"]
    found = Model(name, entry["inputs"], np.array(entry["exact"]["first_order"]), FORMULAS[name])
    for point in entry["values"]:
        value, expected = found.run([point["x"]])[0], point["y"]
        if not abs(value - expected) <= FORMULA_ERROR * abs(expected):
            raise SystemExit(f"{name} gives {value} instead of {expected}")
    return found
