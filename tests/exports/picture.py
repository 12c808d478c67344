"""Reads exported VTU files as ParaView does, by VTK, checks them against what meshio read, and draws them off screen.

Usage: picture.py FOLDER PICTURES
"""

import math
import sys
from pathlib import Path

import numpy as np
import pyvista as pv
import vtk

pv.OFF_SCREEN = True


def check(path, mesh):
    """The same arrays as meshio's, to the bit; units and texts where VTK keeps them."""
    seen = np.load(path.with_suffix(".npz"))
    assert mesh.points.tobytes() == seen["points"].tobytes()
    names = {*mesh.point_data.keys(), *mesh.cell_data.keys()}
    assert names == {name for name in seen.files if name != "points"}
    for name in names:
        assert np.asarray(mesh[name]).tobytes() == seen[name].tobytes(), name
    units = vtk.vtkDataArray.UNITS_LABEL()
    assert mesh.GetPointData().GetArray("displacement").GetInformation().Get(units) == "mm"
    fields = mesh.GetFieldData()
    assert fields.GetArray("version").GetComponentName(0) == bytes(mesh.field_data["version"]).decode()


def volume(mesh, points):
    """Volume of 27-node bricks by VTK's own interpolation, and their smallest Jacobian, from 27 points each."""
    cells = mesh.cells.reshape(-1, 28)[:, 1:]
    brick = vtk.vtkTriQuadraticHexahedron()
    gauss = [(0.5 + x * math.sqrt(0.15), w / 18) for x, w in [(-1, 5), (0, 8), (1, 5)]]
    total, smallest = 0.0, math.inf
    for a, wa in gauss:
        for b, wb in gauss:
            for c, wc in gauss:
                derivatives = [0.0] * 81
                brick.InterpolationDerivs([a, b, c], derivatives)
                table = np.array(derivatives).reshape(3, 27)
                jacobians = np.linalg.det(np.einsum("an,cni->cai", table, points[cells]))
                smallest = min(smallest, jacobians.min())
                total += wa * wb * wc * jacobians.sum()
    return total, smallest


def check_bricks(mesh):
    """VTK sees bricks that aren't inverted, and rubber that keeps its volume."""
    volumes = []
    for moved in [0.0, mesh["displacement_inflated"], mesh["displacement"]]:
        total, smallest = volume(mesh, mesh.points + moved)
        assert smallest > 0, smallest
        volumes.append(total)
    # Each brick keeps its volume to what 1e-8 of the forces leave.
    assert max(volumes) / min(volumes) - 1 < 1e-8, volumes
    print(f"whole mesh: {volumes[0]:.2f} mm^3 in all states, differences below {max(volumes) - min(volumes):.1e}")


def draw(mesh, scalars, views, path):
    """One panel for each array, warped by the displacement."""
    warped = mesh.warp_by_vector("displacement", factor=1.0)
    plotter = pv.Plotter(shape=(1, len(scalars)), window_size=(700 * len(scalars), 700))
    for k, (name, view) in enumerate(zip(scalars, views)):
        plotter.subplot(0, k)
        plotter.add_mesh(warped.copy(), scalars=name, show_edges=True)
        plotter.add_axes()
        plotter.view_vector(view)
    plotter.screenshot(path)
    plotter.close()
    print(path)


def main():
    folder, pictures = Path(sys.argv[1]), Path(sys.argv[2])
    for path in sorted(folder.glob("*.vtu")):
        mesh = pv.read(path)
        check(path, mesh)
        if "von_mises_mpa" in mesh.cell_data:
            if path.stem.endswith("coarse"):
                check_bricks(mesh)
                draw(mesh, ["von_mises_mpa"] * 2, [(-1, -0.6, -0.3), (0.5, -1, 0.3)], pictures / "solve.png")
        elif "first_order_x_P3" in mesh.point_data:
            above = (0.15, 0.3, 1.0)
            scalars = ["strain_x", "strain_y", "first_order_x_P3", "first_order_y_P3"]
            draw(mesh, scalars, [above] * 4, pictures / "map.png")


main()
