"""First-order indices by OpenTURNS and SALib from a number of runs."""

import functools
import itertools
import math
import warnings

import numpy as np
import openturns as ot
from SALib.analyze import rbd_fast
from SALib.analyze import sobol as sobol_analysis
from SALib.sample import latin
from SALib.sample import sobol as sobol_sample

ot.Log.Show(ot.Log.NONE)
ot.TBB.Disable()

# Largest candidate basis of the chaos: larger ones take minutes and were no better.
MOST_TERMS = 300
# Hyperbolic truncation (1: by total degree) with the degrees tried.
TRUNCATIONS = {1.0: (1, 2, 3, 4, 6, 8, 10), 0.5: (4, 6, 10, 14)}

LAWS = {"uniform": ot.Uniform, "normal": ot.Normal, "lognormal": ot.LogNormal}


def enumeration(inputs, truncation):
    if truncation == 1.0:
        return ot.LinearEnumerateFunction(inputs)
    return ot.HyperbolicAnisotropicEnumerateFunction(inputs, truncation)


@functools.cache
def terms_of(inputs, truncation, degree):
    """Size of a basis."""
    if truncation == 1.0:
        return math.comb(inputs + degree, degree)
    return enumeration(inputs, truncation).getBasisSizeFromTotalDegree(degree)


def chaos_settings(model):
    """Designs, truncations, degrees and kinds of polynomials that make sense for a model."""
    inputs = len(model.laws)
    kinds = ["own", "hermite"] if any(law[0] == "lognormal" for law in model.laws) else ["own"]
    found = []
    for truncation, degrees in TRUNCATIONS.items():
        # Counting the terms of a basis that is far too large takes longer than using one that isn't.
        fitting = itertools.takewhile(lambda p: terms_of(inputs, truncation, p) <= MOST_TERMS, degrees)
        found += itertools.product(("lhs", "sobol"), [truncation], fitting, kinds)
    return found


def chaos(model, runs, seed, setting):
    """Sparse polynomial chaos by least-angle regression: indices, and its corrected leave-one-out error."""
    design, truncation, degree, kind = setting
    ot.RandomGenerator.SetSeed(1000 + seed)
    law = ot.JointDistribution([LAWS[kind](*parameters) for kind, *parameters in model.laws])
    # Of a lognormal input the other choice is Hermite polynomials of its logarithm.
    polynomials = [
        ot.HermiteFactory()
        if name == "lognormal" and kind == "hermite"
        else ot.StandardDistributionPolynomialFactory(law.getMarginal(i))
        for i, (name, *_) in enumerate(model.laws)
    ]
    enumerate_terms = enumeration(len(model.laws), truncation)
    basis = ot.OrthogonalProductPolynomialFactory(polynomials, enumerate_terms)
    terms = terms_of(len(model.laws), truncation, degree)
    if design == "lhs":
        experiment = ot.LHSExperiment(law, runs)
    else:
        experiment = ot.LowDiscrepancyExperiment(ot.SobolSequence(), law, runs)
        experiment.setRandomize(True)
    x = experiment.generate()
    y = ot.Sample(np.asarray(model.run(np.array(x))).reshape(-1, 1))
    selection = ot.LeastSquaresMetaModelSelectionFactory(ot.LARS(), ot.CorrectedLeaveOneOut())
    fit = ot.FunctionalChaosAlgorithm(
        x, y, law, ot.FixedStrategy(basis, terms), ot.LeastSquaresStrategy(selection)
    )
    fit.run()
    result = fit.getResult()
    indices = ot.FunctionalChaosSobolIndices(result)
    own = min(result.getErrorHistory(), default=math.inf)
    return [indices.getSobolIndex(i) for i in range(len(model.laws))], own


def cube(model):
    n = len(model.laws)
    return {"num_vars": n, "names": [f"x{i + 1}" for i in range(n)], "bounds": [[0.0, 1.0]] * n}


def saltelli(model, runs, seed):
    """Saltelli's sample on a scrambled Sobol sequence, first-order indices only; the most base points that fit."""
    base = 2 ** int(math.log2(runs / (len(model.laws) + 2)))
    u = sobol_sample.sample(cube(model), base, calc_second_order=False, scramble=True, seed=seed)
    # A quantile at the end of the cube may be infinite.
    y = model.run(model.quantiles(np.clip(u, 1e-12, 1.0 - 1e-12)))
    found = sobol_analysis.analyze(cube(model), y, calc_second_order=False, num_resamples=2, seed=seed)
    return found["S1"], None


def random_balance(model, runs, seed):
    """RBD-FAST on a Latin hypercube."""
    u = latin.sample(cube(model), runs, seed=seed)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = rbd_fast.analyze(cube(model), u, model.run(model.quantiles(u)), num_resamples=2, seed=seed)
    return found["S1"], None
