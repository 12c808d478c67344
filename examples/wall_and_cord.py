"""A thinner wall, a steeper cord: what does that do to the ranking, and is the difference real?

Sweeps wall and cord angle of the shipped study on the coarse mesh and prints which differences from the present design
are beyond their errors. What other scripts solved on `tire.db` is found there.
"""

import strainsite

# The present design comes first: the others are compared with it.
GRID = {"geometry.wall_mm": [3.0, 2.5], "carcass.angle_deg": [55.0, 60.0]}
# Layouts aren't asked for: they would take longer than all the rest.
CHANGES = {"accuracy.preset": "coarse", "layouts.spacings_deg": []}

with strainsite.local("tire.db") as client:
    sweep = client.sweep("foot-tire", grid=GRID, set=CHANGES, name="wall and cord").wait()
    comparison = sweep.comparison()

    # Designs with the force that the same depths take, the best location, and what each cost.
    columns = ["name", "state", "reaction_n", "best", "best_certain", "solves", "reused", "wall_s"]
    print(comparison.studies_frame()[columns].to_string(index=False))

    # Percentage points against the present design. "real" is beyond the error of the difference, "noise" within it.
    # That error is less than the errors of both indices: meshes of one kind err alike.
    for row in comparison.rows:
        for direction, index in (("x", row.x), ("y", row.y)):
            if index.verdict == "real":
                name = next(study.name for study in comparison.studies if study.id == row.study)
                points = f"{index.difference_percent:+.2f} ±{index.difference_error_percent:.2f} points"
                print(f"{name}: {row.location} {direction} {points}, rank {row.rank}")
    for note in comparison.notes:
        print("-", note)
    comparison.plot().savefig("comparison.png")
