"""Exports studies and compares what other programs read with the REST result, bit for bit.

Usage: check.py URL PROGRAM FOLDER
"""

import gzip
import json
import math
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path

import meshio
import numpy as np
import pandas as pd
import pyarrow.parquet as pq

SCENE = Path(__file__).resolve().parents[2] / "scenes" / "foot-tire.toml"
TABLES = ["indices", "locations", "layouts", "points", "signals", "candidates"]
LAYOUTS = {"spacings_deg": [60, 90], "positions": ["crown"], "level": "draft"}
SIGNALS = {"loads_n": [5, 20], "pressures_mpa": [0.2], "at_load_n": 5, "contact_deg": [0, 10], "positions": ["crown"]}
SIMULATED = [
    "bayes_angle_error_deg", "simulated_rms_angle_error_deg", "simulated_p95_angle_error_deg", "lost_share", "simulated_rms_depth_error_mm",
    "force_error_n",
]
MISSING = -1.0
KINDS = {"double": float, "int64": int, "bool": bool, "string": str}

DEPTHS = [
    {"name": f"P{k + 1}", "vary": f"ground.depths_mm[{k}]", "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}}
    for k in range(5)
]
GRID = {"circumferential": 31, "meridional": 11, "half_width_deg": 40}


def study(name, **changes):
    """A study of the paper's tire, small enough to take a second."""
    document = {
        "name": name,
        "scene": {"preset": "foot-tire"},
        "inputs": DEPTHS,
        "candidates": {"points": "P1-P5", "grid": GRID},
        "layouts": LAYOUTS,
        "method": {"kind": "mdrm", "nodes": 3},
        "accuracy": {"preset": "coarse"},
    }
    return {**document, **changes}


class Refused(Exception):
    """An answer that isn't 2xx: its status and its problem document."""


class Service:
    """The service under test."""

    def __init__(self, url):
        self.url = url

    def ask(self, path, body=None):
        """Headers and body of an answer."""
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.url + path, data=data, headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return answer.headers, answer.read()
        except urllib.error.HTTPError as error:
            raise Refused(error.code, json.loads(error.read())) from error

    def packed(self, path):
        """Headers and body of an answer to a client that takes gzip."""
        request = urllib.request.Request(self.url + path, headers={"Accept-Encoding": "gzip"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            return answer.headers, answer.read()

    def run(self, document):
        """Submits a study, waits until it is done and returns its identifier."""
        ident = json.loads(self.ask("/v1/studies", document)[1])["id"]
        ended = self.wait(f"/v1/studies/{ident}")
        assert ended["state"] == "done", ended
        return ident

    def wait(self, path):
        """A study or a sweep when it has ended, or as it is after a minute."""
        for _ in range(1200):
            seen = json.loads(self.ask(path)[1])
            if seen["state"] not in ("queued", "running"):
                break
            time.sleep(0.05)
        return seen

    def part(self, ident, part):
        """A part of a study's answer."""
        return json.loads(self.ask(f"/v1/studies/{ident}/{part}")[1])

    def export(self, ident, media_type, **query):
        """The bytes of an export, checked for their type."""
        text = "&".join(f"{name}={value}" for name, value in query.items())
        headers, body = self.ask(f"/v1/studies/{ident}/export?{text}")
        assert headers["Content-Type"].split(";")[0] == media_type, headers["Content-Type"]
        assert headers["Content-Disposition"].startswith("attachment; filename=")
        return body


def same(seen, expected, where):
    """The same value and type, numbers to the bit; None is nothing."""
    if expected is None:
        assert seen is None or (isinstance(seen, float) and math.isnan(seen)), (where, seen)
    elif isinstance(expected, float):
        assert np.float64(seen).tobytes() == np.float64(expected).tobytes(), (where, seen, expected)
    else:
        assert seen == expected and isinstance(seen, type(expected)), (where, seen, expected)


def at(values, index):
    """An entry of a list that may be absent."""
    return None if values is None else values[index]


def in_unit(unit, strain, volts, value):
    """A reading under the name of its unit."""
    return {strain: value if unit == "strain" else None, volts: value if unit == "V" else None}


def rows_of(table, result, evaluations):
    """The rows of a table as the REST documents have them, in the order of the columns."""
    if table == "indices":
        for output in result["outputs"]:
            error = output["error"]
            for k, each in enumerate(result["inputs"]):
                yield {
                    "location": output["location"], "direction": output["direction"], "input": each["name"],
                    "first_order": at(output["first_order"], k), "total": at(output["total"], k),
                    "error_mesh": error["mesh"], "error_quadrature": error["quadrature"],
                    "error_decomposition": error["decomposition"], "error_total": error["total"],
                    "mean_strain": output["mean"], "std_strain": output["std"], "method": output["method"],
                    "status": output["status"], "mdrm_first_order": at(output.get("mdrm_first_order"), k),
                }
    elif table == "locations":
        yield from result["locations"]
    elif table == "layouts":
        unit = result["layout_findings"]["unit"]
        for layout in result["layouts"]:
            score = layout["score"]
            error = score.get("error") or {}
            shear = score.get("shear") or {}
            forces = shear.get("worst_force_error_n") or [None] * 3
            yield {
                **{name: layout[name] for name in ["rank", "spacing_deg", "units", "position"]},
                "films": "+".join(layout["films"]), **in_unit(unit, "weakest_signal_strain", "weakest_signal_v", score["weakest_signal"]),
                **{name: score[name] for name in ["worst_angle_error_deg", "rms_angle_error_deg", "worst_depth_error_mm"]},
                "noise_strain": score["noise_strain"], "noise_v": score.get("noise_v"), "reason": score.get("reason"),
                "rank_certain": layout["rank_certain"], "name": layout.get("name"), "staggered": layout.get("staggered", False),
                "film_count": layout.get("film_count"),
                **{name: score.get(name) for name in SIMULATED},
                "simulated_p95_error_deg": error.get("simulated_p95_angle_error_deg"), "alike_sigmas": (score.get("alike") or {}).get("sigmas"),
                "worst_angle_mesh_error_deg": error.get("worst_angle_error_deg"), "doubt": layout.get("doubt"),
                "shear_angle_error_deg": shear.get("worst_angle_error_deg"),
                **{f"shear_force_{axis}_error_n": force for axis, force in zip("xyz", forces, strict=True)},
                "shear_reason": shear.get("reason"), "turn_deg": layout.get("turn_deg"),
                "worst_load_n": layout["worst_load_n"],
                "worst_force_error_n": (layout.get("worst_force") or {}).get("error_n"),
                "worst_force_load_n": (layout.get("worst_force") or {}).get("load_n"),
            }
    elif table == "candidates":
        for film in result["layout_findings"]["candidates"]:
            signal = in_unit(result["layout_findings"]["unit"], "signal", "signal_v", film["signal"])
            yield {"angle_information_error": None, "length_mm": None, "width_mm": None, **film, **signal}
    elif table == "signals":
        for row in result["signals"]["rows"]:
            error = row["error"] or {}
            yield {
                **{name: value for name, value in row.items() if name not in ("error", "reason")},
                "strain_error": error.get("strain"), "charge_error_nc": error.get("charge_nc"),
                "open_circuit_error_v": error.get("open_circuit_v"), "output_error_v": error.get("output_v"),
                "reason": row.get("reason"),
            }
    else:
        names = [place["name"] for place in result["cut_point"]["locations"]]
        for point in evaluations:
            strains = {place["name"]: place for place in point["locations"] or []}
            yield {
                "ordinal": point["ordinal"], "level": point["level"],
                **{each["name"]: at(point["values"], k) for k, each in enumerate(result["inputs"])},
                "reaction_n": point["reaction_n"],
                **{f"{n}_strain_{d}": strains.get(n, {}).get(f"strain_{d}") for n in names for d in "xy"},
                "newton_iterations": point["newton_iterations"], "wall_s": point["wall_s"],
                "reason": point.get("reason"), "key": point["key"],
            }


MEDIA_TYPES = {"csv": "text/csv", "parquet": "application/vnd.apache.parquet"}


def check_table(table, fetch, by_hand, path, expected, origin):
    """One table as CSV by pandas and as Parquet by pyarrow against its rows; returns the number of values."""
    files = {}
    for ending in MEDIA_TYPES:
        files[ending] = path.with_suffix(f".{ending}")
        files[ending].write_bytes(fetch(ending))
        said = subprocess.run([*by_hand, "--format", ending, "--table", table], capture_output=True, check=True)
        assert said.stdout == files[ending].read_bytes(), "REST and command line give the same file"
    frame = pd.read_csv(files["csv"])
    parquet = pq.read_table(files["parquet"])
    assert list(frame.columns) == parquet.column_names and set(frame.columns) == set(expected[0]), parquet.column_names
    assert len(frame) == parquet.num_rows == len(expected)
    metadata = {key.decode(): value.decode() for key, value in parquet.schema.metadata.items()}
    units = json.loads(metadata.pop("units"))
    assert metadata == {**origin, "table": table}, metadata
    assert list(units) == parquet.column_names
    for name in parquet.column_names:
        kind = str(parquet.schema.field(name).type)
        assert (units[name] is None) == (kind != "double"), (name, kind, units[name])
        column = [row[name] for row in expected]
        present = [value for value in column if value is not None]
        assert all(isinstance(value, KINDS[kind]) for value in present), (name, kind)
        for row, (a, b, value) in enumerate(zip(frame[name], parquet.column(name).to_pylist(), column)):
            # A CSV column of whole numbers with gaps is one of floats to pandas.
            plain = a.item() if isinstance(a, np.generic) else a
            as_number = float(value) if isinstance(plain, float) and isinstance(value, int) else value
            same(plain, as_number, (table, "csv", name, row))
            same(b, value, (table, "parquet", name, row))
    return 2 * len(expected) * len(parquet.column_names)


def check_tables(service, ident, program, folder, tables=TABLES):
    """The tables of a study against the REST documents; returns the number of values."""
    result = service.part(ident, "result")
    evaluations = service.part(ident, "evaluations")["evaluations"]
    origin = {
        "study": ident, "spec_sha256": result["study"]["spec_sha256"], "version": result["study"]["version"],
    }
    values = 0
    by_hand = [program, "export", ident, "--db", folder / "studies.db"]
    for table in tables:
        expected = [{**row, **origin} for row in rows_of(table, result, evaluations)]
        if table == "candidates" and not expected:
            # A tire that feels nothing has no layouts to score.
            continue
        assert expected, table
        fetch = lambda ending: service.export(ident, MEDIA_TYPES[ending], format=ending, table=table)
        values += check_table(table, fetch, by_hand, folder / f"{ident}-{table}", expected, origin)
    assert json.loads(service.export(ident, "application/json", format="json")) == result
    return values


def check_packed(service, ident):
    """What a client gets that takes gzip; a tag of it is known again. Events aren't packed."""
    path = f"/v1/studies/{ident}"
    for part in ("result", "evaluations", "export?format=csv", "export?format=parquet"):
        headers, whole = service.ask(f"{path}/{part}")
        packed_headers, packed = service.packed(f"{path}/{part}")
        assert headers["Content-Encoding"] is None and packed_headers["Content-Encoding"] == "gzip", part
        assert "accept-encoding" in packed_headers["Vary"].lower(), part
        assert gzip.decompress(packed) == whole, part
        if part == "result":
            # Its numbers are printed to the last digit: text of them packs to two fifths at worst.
            assert len(packed) < 0.4 * len(whole), (len(packed), len(whole))
            tag = packed_headers["ETag"]
            assert tag.startswith("W/") and tag[2:] == headers["ETag"], tag
            again = urllib.request.Request(service.url + f"{path}/{part}", headers={"If-None-Match": tag, "Accept-Encoding": "gzip"})
            try:
                urllib.request.urlopen(again, timeout=60)
                raise AssertionError("a known tag should need no body")
            except urllib.error.HTTPError as unchanged:
                assert unchanged.code == 304, unchanged.code
    headers, _ = service.packed(f"{path}/events")
    assert headers["Content-Encoding"] is None and headers["Content-Type"].startswith("text/event-stream"), headers


def settings_of(comparison):
    """What each study sets, by path: numbers where all are, else words, and JSON of what is neither."""
    paths = sorted({path for each in comparison["studies"] for path in each["set"] or {}})
    settings = {each["id"]: {} for each in comparison["studies"]}
    for path in paths:
        there = [each["set"][path] for each in comparison["studies"] if path in (each["set"] or {})]
        numbers = all(isinstance(value, (int, float)) for value in there)
        for each in comparison["studies"]:
            value = (each["set"] or {}).get(path)
            if value is not None and numbers:
                value = float(value)
            elif value is not None and not isinstance(value, str):
                value = json.dumps(value, separators=(",", ":"))
            settings[each["id"]][path] = value
    return settings


def answer_columns(answer):
    """A study's layout with its errors, and their differences from the baseline's."""
    line = {"answer_rank": answer.get("rank"), "layout": answer.get("words"), "layout_verdict": answer.get("verdict")}
    line |= {name: answer.get(name) for name in ["film_count", "meets"]}
    parts = {"error": "value", "claim": "error", "difference": "difference", "difference_error": "difference_error"}
    for name, unit in [("angle", "deg"), ("force", "n")]:
        figure = answer.get(f"{name}_{unit}") or {}
        line |= {f"{name}_{part}_{unit}": figure.get(field) for part, field in parts.items()}
        line[f"{name}_verdict"] = figure.get("verdict")
    return line


def rows_of_comparison(table, comparison):
    """The rows of a comparison's table as its document has them."""
    settings = settings_of(comparison)
    studies = {each["id"]: each for each in comparison["studies"]}
    names = ["location", "rank", "rank_certain", "rank_change", "rank_verdict"]
    for row in comparison["rows"] if table == "locations" else comparison["studies"]:
        study = studies[row["study"]] if table == "locations" else row
        cost = study["cost"] or {}
        line = {"study": study["id"], "name": study["name"], **settings[study["id"]]}
        if table == "locations":
            line |= {name: row[name] for name in names}
            line |= {f"{name}_{d}": value for d in "xy" for name, value in row[d].items()}
        else:
            line |= {name: value for name, value in study.items() if name not in ("id", "name", "set", "cost", "answer")}
            line |= answer_columns(study["answer"] or {})
            line |= {name: cost.get(name) for name in ["solves", "coarser_solves", "effect_solves", "reused", "wall_s", "cpu_s"]}
        origin = {name: study[name] for name in ["spec_sha256", "version"]}
        yield {**line, **origin, "baseline": comparison["baseline"]}


def check_comparison(service, program, folder):
    """The tables of a sweep's comparison, one design without an equilibrium; returns the number of values."""
    uniform = {"kind": "uniform", "min": 0.8, "max": 1.2}
    designs = [
        {"geometry.wall_mm": 3},
        {"geometry.wall_mm": 2.5, "accuracy.preset": "coarse"},
        {"inputs[0].distribution": uniform},
        {"carcass.stiffness_n_per_mm": 1.0},
    ]
    body = {"study": study("walls", candidates={"points": "P1-P5"}), "designs": [{"set": each} for each in designs]}
    body["designs"][1]["name"] = "thin, \"µ\""
    ident = json.loads(service.ask("/v1/sweeps", body)[1])["id"]
    sweep = service.wait(f"/v1/sweeps/{ident}")
    assert sweep["counts"]["done"] == 3 and sweep["counts"]["failed"] == 1, sweep["counts"]
    comparison = json.loads(service.ask(f"/v1/comparison?sweep={ident}")[1])
    verdicts = [row[d]["verdict"] for row in comparison["rows"] for d in "xy"]
    assert {"real", "noise", None} <= set(verdicts), verdicts
    values = 0
    by_hand = [program, "compare", ident, "--db", folder / "studies.db"]
    for table in ["locations", "designs"]:
        expected = list(rows_of_comparison(table, comparison))
        fetch = lambda ending: service.ask(f"/v1/comparison/export?sweep={ident}&format={ending}&table={table}")[1]
        origin = {"baseline": comparison["baseline"]}
        values += check_table(table, fetch, by_hand, folder / f"{ident}-{table}", expected, origin)
    whole = service.ask(f"/v1/comparison/export?sweep={ident}&format=json")[1]
    assert json.loads(whole) == comparison
    return values


def read(path):
    """A VTU file by meshio; what it saw is kept beside the file for other readers to compare with."""
    mesh = meshio.read(path)
    of_cells = {name: data[0] for name, data in mesh.cell_data.items()}
    np.savez(path.with_suffix(".npz"), points=mesh.points, **mesh.point_data, **of_cells)
    return mesh


def texts_of(mesh):
    """The texts of a VTU file: each is an array of UTF-8 bytes."""
    return {name: bytes(array).decode() for name, array in mesh.field_data.items()}


def check_map(service, ident, program, folder):
    """VTU by meshio against the REST documents; returns the number of values and of those that are missing."""
    result = service.part(ident, "result")
    shape, layers = result["map"]["shape"], result["map"]["layers"]
    path = folder / f"{ident}.vtu"
    path.write_bytes(service.export(ident, "application/xml", format="vtu"))
    arguments = ["--format", "vtu", "--db", folder / "studies.db"]
    by_hand = subprocess.run([program, "export", ident, *arguments], capture_output=True, check=True)
    assert by_hand.stdout == path.read_bytes(), "REST and command line give the same file"
    mesh = read(path)
    expected = {"displacement": shape["displacement_mm"]}
    for layer in layers:
        d = layer["direction"]
        expected[f"strain_{d}"] = layer["strain"]
        expected[f"std_{d}"] = layer["std"]
        for each, indices in zip(result["inputs"], layer["first_order"]):
            expected[f"first_order_{d}_{each['name']}"] = indices
        expected[f"first_order_error_{d}"] = layer["error"]
        for each, errors in zip(result["inputs"], layer["first_order_error"]):
            expected[f"first_order_error_{d}_{each['name']}"] = errors
    absent = [name for name, values in expected.items() if all(value is None for value in values)]
    partly = [name for name, values in expected.items() if any(value is None for value in values) and name not in absent]
    present = [name for name in expected if name not in absent]
    assert set(mesh.point_data) == {*present, *(f"{name}_known" for name in partly)}, sorted(mesh.point_data)
    assert mesh.points.tobytes() == np.array(shape["inflated_mm"]).tobytes()
    missing = 0
    for name in present:
        array = mesh.point_data[name]
        assert np.isfinite(array).all(), name
        filled = np.array([MISSING if value is None else value for value in expected[name]])
        assert array.dtype == np.float64 and array.tobytes() == filled.tobytes(), name
        if name in partly:
            known = [value is not None for value in expected[name]]
            assert mesh.point_data[f"{name}_known"].tolist() == [int(flag) for flag in known], name
            missing += known.count(False)
    texts = texts_of(mesh)
    assert texts["study"] == ident and texts["name"] == result["study"]["name"]
    assert texts["spec_sha256"] == result["study"]["spec_sha256"] and texts["version"] == result["study"]["version"]
    assert json.loads(texts["left_out"]) == absent, texts["left_out"]
    units = json.loads(texts["units"])
    assert set(units) == {"points", *present}, units
    if result["model"]["level"] != "draft":
        check_surface(result, mesh)
    return sum(mesh.point_data[name].size for name in present), missing


def check_surface(result, mesh):
    """Positions, cells and displacements are a tire's."""
    (cells,) = mesh.cells
    columns, rows = len(result["map"]["theta_deg"]), len(result["map"]["phi_deg"])
    assert cells.type == "quad" and len(cells.data) == (columns - 1) * (rows - 1)
    # Normals point away from the middle of the section; a quad's is the cross product of its diagonals.
    corners = mesh.points[cells.data]
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    centres = corners.mean(axis=1)
    ring = centres * [1, 0, 1]
    ring *= (37.5 / np.linalg.norm(ring, axis=1))[:, None]
    assert (np.einsum("ij,ij->i", normals, centres - ring) > 0).all()
    # What presses upward lifts the crown above the contact's centre by less than the depth, and more than the rest.
    middle = (rows // 2) * columns + columns // 2
    lift = mesh.point_data["displacement"][:, 2]
    assert 0.3 < lift[middle] < 1.0 and lift[middle] > 5 * abs(lift[0]), lift[middle]
    # Left and right, and both sides, are mirror images at the means. The solver's tolerance leaves 1e-6 mm where nothing mirrors them exactly.
    for array in [mesh.points, mesh.points + mesh.point_data["displacement"]]:
        grid = array.reshape(rows, columns, 3)
        assert np.abs(grid[:, ::-1] - grid * [-1, 1, 1]).max() < 1e-5
        assert np.abs(grid[::-1] - grid * [1, -1, 1]).max() < 1e-5
    # The recovered circumferential strain at the crown is that of the polyline within its spacing's error.
    crown = np.arange(columns) + (rows // 2) * columns
    current = mesh.points + mesh.point_data["displacement"]
    length = [np.linalg.norm(np.diff(points[crown], axis=0), axis=1) for points in (mesh.points, current)]
    polyline = length[1] / length[0] - 1
    strain = mesh.point_data["strain_x"][crown]
    between = 0.5 * (strain[1:] + strain[:-1])
    assert np.abs(polyline - between).max() < 0.15 * np.abs(strain).max(), np.abs(polyline - between).max()


def check_solve(program, folder, level, cell):
    """The whole mesh of one solve by meshio, against its JSON; returns the number of cells."""
    path = folder / f"solve-{level}.vtu"
    run = [program, "solve", SCENE, "--set", f"model.level={level}", "--vtu", path, "--json", "-"]
    answer = json.loads(subprocess.run(run, capture_output=True, check=True).stdout)
    mesh = read(path)
    (cells,) = mesh.cells
    assert cells.type == cell and len(cells.data) == answer["model"]["elements"], cells.type
    crown = np.argmin(np.abs(mesh.points - [0, 0, -50.0]).sum(axis=1))
    assert np.abs(mesh.points[crown] - [0, 0, -50.0]).max() < 1e-12
    inflated = mesh.points[crown] + mesh.point_data["displacement_inflated"][crown]
    same(float(-inflated[2]), answer["inflated"]["outer_radius_mm"], "inflated radius")
    pressed = mesh.points[crown] + mesh.point_data["displacement"][crown]
    # The ground is raised by 1 mm; the contact is a penalty that gives by less than 0.05 mm.
    depth = answer["inflated"]["outer_radius_mm"] + pressed[2]
    assert 0.95 < depth < 1.0, depth
    stress, von_mises, mean = (
        mesh.cell_data[name][0] for name in ["cauchy_stress_mpa", "von_mises_mpa", "mean_stress_mpa"]
    )
    assert np.allclose(stress[:, :3].mean(axis=1), mean, rtol=0, atol=1e-12)
    xx, yy, zz, xy, yz, xz = stress.T
    of_mean = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy**2 + yz**2 + xz**2))
    # A norm of a mean is no larger than the mean of the norm.
    assert (of_mean <= von_mises * (1 + 1e-12)).all() and (von_mises > 0).all()
    for array in [*mesh.point_data.values(), *(data[0] for data in mesh.cell_data.values())]:
        assert np.isfinite(array).all()
    texts = texts_of(mesh)
    assert "a quarter of the tire" in texts["symmetry"] and json.loads(texts["scene"])["model"]["level"] == level
    return len(cells.data)


def refused(service, ident, query, status):
    """A request that must fail."""
    try:
        service.ask(f"/v1/studies/{ident}/export?{query}")
    except Refused as refusal:
        seen, problem = refusal.args
        assert seen == status, problem
        return problem["detail"]
    raise AssertionError(f"{query} should be refused")


def main():
    url, program, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    service = Service(url)
    with_map = service.run(study("all known", signals=SIGNALS))
    # A draft doesn't know its mesh's error, and without contact its stiffness changes nothing: no strain has an index.
    stiffness = {"kind": "uniform", "min": 100.0, "max": 200.0}
    idle = service.run(study(
        "gaps <&\" µ", accuracy={"preset": "draft"},
        scene={"preset": "foot-tire", "ground": {"depths_mm": [0.0] * 5}, "contact": {"penalty_n_per_mm3": 150.0}},
        inputs=[{"name": "a, \"b\" <c> µ", "vary": "contact.penalty_n_per_mm3", "distribution": stiffness}],
        candidates={"points": "P1-P5", "grid": {**GRID, "half_width_deg": 180}},
        # A tire without cords bursts at this pressure: its row has a reason.
        signals={**SIGNALS, "films": ["bare"], "tires": [{"name": "weak, \"µ\"", "scene": {}}]},
    ))
    without = service.run(study(
        "no map", accuracy={"preset": "draft"}, candidates={"points": "P1-P5"},
        scene={"preset": "foot-tire", "contact": {"friction": 0.5}},
        layouts={**LAYOUTS, "spacings_deg": [15, 60], "positions": ["crown", "shoulder"], "shear": True},
    ))
    glued = service.run(study("volts", accuracy={"preset": "draft"}, layouts={**LAYOUTS, "film": "transfer"}))
    assert service.part(glued, "layouts")["findings"]["unit"] == "V"
    check_packed(service, with_map)
    values = sum(check_tables(service, ident, program, folder) for ident in (with_map, idle))
    values += check_tables(service, without, program, folder, ["layouts"])
    values += check_tables(service, glued, program, folder, ["layouts", "candidates"])
    print(f"tables: {values} values by pandas and pyarrow, as in the REST result")
    print(f"comparison: {check_comparison(service, program, folder)} values by pandas and pyarrow")
    for ident in (with_map, idle):
        numbers, missing = check_map(service, ident, program, folder)
        print(f"map: {numbers} values by meshio, {missing} of them missing")
    assert "candidates.grid" in refused(service, without, "format=vtu", 404)
    assert "parquet" in refused(service, without, "format=xls", 400)
    for level, cell in [("draft", "hexahedron"), ("coarse", "hexahedron27")]:
        print(f"solve: {check_solve(program, folder, level, cell)} cells of {level} by meshio")


main()
