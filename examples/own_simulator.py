"""A simulator of your own: strainsite says which points to run, and turns the outputs into Sobol indices.

The simulator here is a toy, a cantilever whose film reads the bending strain at its root, 6 F L / (E b h^2). Because it
is a product of functions of one input each, its indices have a closed form, beside which the answer is printed.
"""

import csv
import json
import math
import os
import subprocess
from pathlib import Path

PROGRAM = os.environ.get("STRAINSITE_BIN", "strainsite")

INPUTS = """
[[inputs]]
name = "force_n"
distribution = { kind = "normal", mean = 10.0, std = 1.0 }
[[inputs]]
name = "length_mm"
distribution = { kind = "uniform", min = 95.0, max = 105.0 }
[[inputs]]
name = "height_mm"
distribution = { kind = "uniform", min = 1.8, max = 2.2 }

[method]
kind = "mdrm"     # lines through the means: right where the inputs multiply, as they do here
nodes = 7
"""
MODULUS_MPA, WIDTH_MM = 70_000.0, 20.0


def simulate(force_n: float, length_mm: float, height_mm: float) -> float:
    """The toy: in your case a program that runs for hours."""
    return 6.0 * force_n * length_mm / (MODULUS_MPA * WIDTH_MM * height_mm**2)


def exact_indices() -> list[float]:
    """Of a product of factors g: S_i = (r_i - 1) / (r_1 r_2 r_3 - 1) with r = E[g^2] / E[g]^2."""
    low, high = 1.8, 2.2
    mean_square = (low**-3 - high**-3) / (3.0 * (high - low))  # of h^-4
    mean = (1.0 / low - 1.0 / high) / (high - low)  # of h^-2
    ratios = [1.0 + (1.0 / 10.0) ** 2, 1.0 + (10.0**2 / 12.0) / 100.0**2, mean_square / mean**2]
    return [(ratio - 1.0) / (math.prod(ratios) - 1.0) for ratio in ratios]


Path("inputs.toml").write_text(INPUTS, encoding="utf-8")

# 1. The points to run: a row each, with an identifier.
subprocess.run([PROGRAM, "gsa", "plan", "inputs.toml", "--output", "points.csv"], check=True)

# 2. Run them, in any order. A run that fails is written as nan: it costs accuracy, not the analysis.
with open("points.csv", encoding="utf-8") as points, open("values.csv", "w", encoding="utf-8", newline="") as values:
    writer = csv.writer(values)
    writer.writerow(["id", "strain"])
    for row in csv.DictReader(points):
        inputs = {name: float(text) for name, text in row.items() if name != "id"}
        writer.writerow([row["id"], repr(simulate(**inputs))])

# 3. The indices, each with its error.
analysis = subprocess.run(
    [PROGRAM, "gsa", "analyse", "inputs.toml", "values.csv", "--json", "-"], check=True, capture_output=True
)
answer = json.loads(analysis.stdout)
output = answer["outputs"][0]
print(f"{answer['evaluations']} runs, status {output['status']}, mean strain {output['mean']:.3e}")
names = ["force_n", "length_mm", "height_mm"]
for name, index, exact in zip(names, output["first_order"], exact_indices(), strict=True):
    print(f"{name:10}  first-order index {index:.6f}  exact {exact:.6f}  claimed error {output['error']['total']:.1e}")
