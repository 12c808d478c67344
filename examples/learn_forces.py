"""Forces from the signals of a sensor: how far off they are on a run that wasn't learnt from, and on a fifth one.

Makes four runs of a virtual sensor whose four signals follow two forces, each run with gains and offsets of its own,
as if the sensor had been put on anew. With recordings of your own, give their CSV files instead.
"""

import numpy as np
import pandas as pd
import strainsite

# Two kinds of model, and few rows for the second one, so that this takes seconds; `None` has all.
GPR = {"restarts": 3, "search_rows": 100, "most_rows": 300}
RECIPE = {"models": {"kinds": ["ridge", "gpr"], "gpr": GPR}, "features": {"sets": ["raw"]}}
RNG = np.random.default_rng(7)
# What each signal reads of 1 N along x and z, mV.
READS = np.array([[1.0, 0.4], [0.3, 0.9], [-0.5, 0.7], [0.2, -0.6]])


def run() -> pd.DataFrame:
    """Eight presses of random heights in 20 s, 20 rows a second."""
    time = np.arange(0.0, 20.0, 0.05)
    press = np.maximum(np.sin(2 * np.pi * 0.4 * time), 0.0) * RNG.uniform(5, 20, 8)[(time * 0.4).astype(int)]
    forces = np.column_stack([press * np.sin(0.7 * time + RNG.uniform(0, 6)), press])
    gains, offsets = RNG.normal(1.0, 0.05, 4), RNG.normal(0.0, 0.3, 4)
    signals = np.tanh(forces @ READS.T / 40) * 40 * gains + offsets + RNG.normal(0.0, 0.1, (time.size, 4))
    frame = pd.DataFrame({"time_s": time} | {f"film_{k}_mv": signals[:, k] for k in range(4)})
    return frame.assign(fx_n=forces[:, 0], fz_n=forces[:, 1])


with strainsite.local("tire.db") as client:
    estimator = client.fit_forces([run() for _ in range(4)], RECIPE, "virtual sensor")
    report = estimator.report()
    # Each force: the model, and its error on runs that it didn't learn from.
    for force in report.forces:
        print(force)
        error, random = force.models[0].validation, force.models[0].splits.random
        print(f"  {error.nrmse_percent:.1f} % of its range; the training mean {error.mean_nrmse_percent:.0f} %")
        if random is not None:
            print(f"  a random split would have said {random.rmse_n:.2f} N")
    print(report.promise)
    estimator.plot("fz_n").savefig("forces.png")

    # Another run of the same sensor, as if its forces weren't known. The model runs without a service, too:
    # strainsite force apply model.json run.csv
    estimator.save("model.json")
    fifth = run()
    found = estimator.apply(fifth.drop(columns=["fx_n", "fz_n"]))
    for name in ("fx_n", "fz_n"):
        inside = fifth[name].between(found[f"{name}_low"], found[f"{name}_high"]).mean()
        error = np.sqrt(((found[name] - fifth[name]) ** 2).mean())
        print(f"{name}: off by {error:.2f} N on the fifth run, {inside:.0%} of its rows within their intervals")
