"""Solves the tire of a deck with FElupe: mean dilatation, PARDISO.

python felupe_tire.py DECK DISPLACEMENTS: writes the displacements of the inflated and of the pressed tire, prints JSON.
"""

import json
import sys
import time

import felupe
import numpy as np
import pypardiso

from read_deck import read_deck

# Load steps: of the pressure, then of the ground. One each takes the fewest iterations, and cut-backs are allowed.
INFLATING = 1
PRESSING = 1
# Relative residual of an equilibrium; the other programs' too.
TOLERANCE = 1e-6
# Most iterations of a load step.
ITERATIONS = 16


def face_area(points):
    """Area of a quadrilateral from its corners in order around it."""
    diagonals = points[2] - points[0], points[3] - points[1]
    return 0.5 * np.linalg.norm(np.cross(*diagonals))


def supports(deck, displacement):
    """One boundary for each axis that is held somewhere."""
    held = {}
    for axis in range(3):
        mask = np.zeros(displacement.region.mesh.npoints, dtype=bool)
        mask[deck.held[axis]] = True
        skip = [other != axis for other in range(3)]
        held[f"axis {axis}"] = felupe.Boundary(displacement, mask=mask, skip=skip)
    return held


def solve(deck):
    """Displacements of the inflated and of the pressed tire, reaction, iterations."""
    mesh = felupe.Mesh(deck.nodes, deck.bricks, "hexahedron")
    mesh.add_points([0.0, 0.0, deck.parked])
    region = felupe.RegionHexahedron(mesh)
    field = felupe.FieldContainer([felupe.Field(region, dim=3)])
    rubber = felupe.Hyperelastic(felupe.mooney_rivlin, C10=deck.c10, C01=deck.c01)
    solid = felupe.SolidBodyNearlyIncompressible(rubber, field, bulk=2.0 / deck.d1)

    inner = np.zeros(mesh.npoints, dtype=bool)
    inner[np.unique(deck.pressure_faces)] = True
    surface = felupe.RegionHexahedronBoundary(mesh, only_surface=True, mask=inner)
    on_surface = felupe.FieldContainer([felupe.Field(surface, dim=3)])
    cavity = felupe.SolidBodyPressure(on_surface)

    # A node's penalty is a force over a penetration: the deck's over the area of a face at the crown.
    crown = deck.nodes[deck.tread_faces[0]]
    contact = felupe.ContactRigidPlane(
        field,
        points=np.unique(deck.tread_faces),
        centerpoint=-1,
        normal=[0.0, 0.0, 1.0],
        multiplier=deck.penalty * face_area(crown),
    )

    boundaries = supports(deck, field[0])
    ground = np.zeros(mesh.npoints, dtype=bool)
    ground[-1] = True
    boundaries["ground, sideways"] = felupe.Boundary(field[0], mask=ground, skip=[0, 0, 1])
    boundaries["ground"] = felupe.Boundary(field[0], mask=ground, skip=[1, 1, 0])

    states, iterations = [], 0
    for loads in (
        {cavity: np.linspace(0.0, deck.pressure, INFLATING + 1)[1:]},
        {boundaries["ground"]: np.linspace(0.0, deck.rise, PRESSING + 1)[1:]},
    ):
        counter = Counter()
        step = felupe.Step([solid, cavity, contact], ramp=loads, boundaries=boundaries)
        felupe.Job([step], plugins=[counter, felupe.CutbackPlugin()]).evaluate(
            x0=field,
            solver=pypardiso.spsolve,
            tol=TOLERANCE,
            maxiter=ITERATIONS,
            verbose=0,
        )
        iterations += counter.iterations
        states.append(field[0].values[:-1].copy())
    force = np.asarray(contact.results.force.toarray()).reshape(-1, 3)
    return states, force[-1, 2], iterations


class Counter(felupe.Plugin):
    """Counts iterations, those of failed load steps too."""

    def __init__(self):
        self.iterations = 0

    def after_iteration(self, context, state):
        self.iterations += 1


def main(deck_file, displacement_file):
    deck = read_deck(deck_file)
    begin = time.perf_counter()
    states, reaction, iterations = solve(deck)
    wall = time.perf_counter() - begin
    np.savetxt(displacement_file, np.vstack(states))
    print(json.dumps({"wall_s": wall, "iterations": iterations, "reaction_n": abs(float(reaction))}))


if __name__ == "__main__":
    main(*sys.argv[1:])
