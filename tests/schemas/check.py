"""Holds the schemas of documents against the readers: see `run`."""

import copy
import functools
import json
import operator
import random
import re
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import jsonschema

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = sys.argv[1]
# Documents, the reader that fuzzing knows, and what ships.
DOCUMENTS = {"study": "study", "scene": "scene", "sweep": "sweep", "gsa": "inputs"}
FAULTS = 200
# Changed documents, and how many of them a reader has to take, so that the comparison says something.
NUDGED = (400, 200)
# A number that no field takes, texts and lists in the place of others, and a table where there is none.
# How faults of range, type and name begin; others are of rules between fields, or of paths.
OF_ONE_FIELD = r"(unknown field|must be (an? (number|whole number|list|table|text)|true or false|\"))"
WRONG = [1e300, -1e300, "text", [["list"]], {"table": 1}, True]


def main():
    schemas = {name: schema_of(name) for name in ["study", "scene", "sweep", "recipe", "gsa"]}
    for schema in schemas.values():
        jsonschema.Draft202012Validator.check_schema(schema.schema)
        is_bounded(schema.schema)
    print(f"{len(schemas)} schemas: every number has bounds")
    committed(schemas)
    shipped(schemas)
    fuzzed(schemas)
    nudged(schemas["study"])
    faulty(schemas["study"])
    exemplified()


def schema_of(name):
    said = subprocess.run([PROGRAM, "schema", name], capture_output=True, text=True, check=True)
    return jsonschema.Draft202012Validator(json.loads(said.stdout))


def is_bounded(schema):
    """Every number has least and greatest, and few tables take whatever one writes."""
    opaque = []

    def walk(part, at):
        if isinstance(part, list):
            for k, item in enumerate(part):
                walk(item, f"{at}/{k}")
        if not isinstance(part, dict):
            return
        if part.get("type") in ("number", "integer"):
            low = part.get("minimum", part.get("exclusiveMinimum"))
            assert low is not None and "maximum" in part, f"{at}: a number without bounds"
        if part.get("type") == "object" and "properties" not in part:
            opaque.append(at)
        if "properties" in part:
            undescribed = [name for name, of in part["properties"].items() if "description" not in of and "const" not in of and "Distribution" not in at]
            assert not undescribed, f"{at}: {undescribed} without a description"
        for name, item in part.items():
            walk(item, f"{at}/{name}")

    walk(schema, "")
    assert len(opaque) <= 3, f"opaque: {opaque}"


def committed(schemas):
    """The files that editors read beside the shipped documents, and those documents as taplo checks them."""
    for name, file in [("study", "studies/generated/study.schema.json"), ("scene", "scenes/generated/scene.schema.json")]:
        said = f"strainsite schema {name} > {file}"
        assert json.loads((ROOT / file).read_text()) == schemas[name].schema, f"{file} is another schema: run {said} and commit it"
    taplo = Path(sys.executable).with_name("taplo")
    files = [*ROOT.glob("studies/*.toml"), *ROOT.glob("scenes/*.toml")]
    ended = subprocess.run([taplo, "check", *files], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    print(f"taplo checks {len(files)} documents by the schemas that they name")


def exemplified():
    """Recorded answers in the service's description are of their types: each fits the schema of its operation."""
    described = json.loads((ROOT / "web/openapi.json").read_text())
    count = 0
    for path, item in described["paths"].items():
        for method, operation in item.items():
            for status, response in operation.get("responses", {}).items():
                for content in response.get("content", {}).values():
                    if "example" not in content:
                        continue
                    # References lead into the description.
                    schema = jsonschema.Draft202012Validator({**content["schema"], "components": described["components"]})
                    fits(schema, content["example"], f"the example of {method} {path} {status}")
                    count += 1
    print(f"{count} examples of answers fit: otherwise lab/examples.py records them anew")


def shipped(schemas):
    files = [("study", file) for file in ROOT.glob("studies/*.toml")] + [("scene", file) for file in ROOT.glob("scenes/*.toml")]
    for name, file in files:
        fits(schemas[name], tomllib.loads(file.read_text()), file)
    said = subprocess.run([PROGRAM, "presets", "--json", "-"], capture_output=True, text=True, check=True)
    for kind, name in [("studies", "study"), ("scenes", "scene")]:
        for preset in json.loads(said.stdout)[kind]:
            fits(schemas[name], preset["document"], f"canonical {preset['name']}")
    print(f"{2 * len(files)} documents that ship fit")


def fits(schema, document, what):
    error = jsonschema.exceptions.best_match(schema.iter_errors(document))
    assert error is None, f"{what}: {error.json_path}: {error.message}"


def fuzzed(schemas):
    """What the readers took of the fuzzed texts."""
    for name, reader in DOCUMENTS.items():
        texts = [json.loads(line) for line in (ROOT / f"tests/fuzz/corpus/{reader}.jsonl").read_text().splitlines()]
        outcomes = (ROOT / f"tests/fuzz/outcomes/{reader}.txt").read_text().splitlines()
        count = 0
        for k, (text, outcome) in enumerate(zip(texts, outcomes, strict=True)):
            document = parsed(text) if outcome.endswith(" read") else None
            # Sweeps are typed, too, or are further designs.
            if document is None or (name == "sweep" and "study" not in document):
                continue
            count += 1
            fits(schemas[name], document, f"{reader} {k}: {text[:300]!r}")
        print(f"{count} of {len(texts)} fuzzed {reader} texts are read, and fit")


def parsed(text):
    try:
        return json.loads(text) if text.lstrip().startswith("{") else tomllib.loads(text)
    except ValueError:
        return None


def nudged(schema):
    """Studies that ship with two figures changed or left out: what the reader takes, the schema takes. Fuzzed studies are hardly ever whole."""
    documents, draw, cases = studies(), random.Random(2), []
    for _ in range(NUDGED[0]):
        document = draw.choice(documents)
        for place in draw.sample(list(leaves(document, ())), 2):
            document = without(document, place) if draw.random() < 0.2 else put(document, place, near(draw, value_at(document, place)))
        cases.append(document)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        ended = list(pool.map(lambda case: validated(folder, *case), enumerate(cases)))
    taken = [document for document, end in zip(cases, ended, strict=True) if end.returncode == 0]
    assert len(taken) >= NUDGED[1], f"only {len(taken)} of {len(cases)} changed studies are read"
    for document in taken:
        fits(schema, document, json.dumps(document)[:300])
    print(f"{len(taken)} of {len(cases)} studies with two figures changed are read, and fit")


def near(draw, value):
    """A value of the same type, not far from this one; texts stay."""
    if isinstance(value, list):
        return [near(draw, item) for item in value]
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value + draw.choice([-1, 1])
    return value * draw.choice([0.5, 0.9, 1.1, 2]) if isinstance(value, float) else value


def studies():
    said = subprocess.run([PROGRAM, "presets", "--json", "-"], capture_output=True, text=True, check=True)
    return [preset["document"] for preset in json.loads(said.stdout)["studies"]]


def validated(folder, number, document):
    file = Path(folder) / f"{number}.json"
    file.write_text(json.dumps(document))
    return subprocess.run([PROGRAM, "validate", file], capture_output=True, text=True)


def faulty(schema):
    """Faults of range, type and name in documents that have every field: the schema finds them as the reader does."""
    draw, cases = random.Random(1), []
    for document in studies():
        places = list(leaves(document, ()))
        cases += [(document, place, wrong) for place in places for wrong in WRONG]
        cases += [(document, (*place, "colour"), 1) for place in tables(document, ())]
    cases = draw.sample(cases, 3 * FAULTS)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        refused = list(pool.map(lambda case: is_refused(folder, case), enumerate(cases)))
    for (document, place, wrong), outcome in zip(cases, refused, strict=True):
        if outcome is None:
            fits(schema, put(document, place, wrong), f"{wrong!r} at {place}, which the reader takes")
    found = [case for case, outcome in zip(cases, refused, strict=True) if outcome]
    assert len(found) >= FAULTS, f"only {len(found)} of {len(cases)} changes are faults"
    for document, place, wrong in found:
        changed = put(document, place, wrong)
        assert not schema.is_valid(changed), f"the reader refuses {wrong!r} at {place}, the schema takes it"
    print(f"{len(found)} faults that the reader finds are found by the schema")


def is_refused(folder, numbered):
    """Whether the reader finds a fault of range, type or name at the place that was changed; None where it takes the document."""
    number, (document, place, wrong) = numbered
    ended = validated(folder, number, put(document, place, wrong))
    if ended.returncode == 0:
        return None
    pointer = re.escape("/" + "/".join(map(str, place)))
    return ended.returncode == 2 and re.search(rf"(?m)^{pointer}(/\d+)*: {OF_ONE_FIELD}", ended.stderr) is not None


def put(document, place, value):
    changed = copy.deepcopy(document)
    inner = changed
    for step in place[:-1]:
        inner = inner[step]
    inner[place[-1]] = value
    return changed


def without(document, place):
    changed = copy.deepcopy(document)
    value_at(changed, place[:-1]).pop(place[-1])
    return changed


def value_at(document, place):
    return functools.reduce(operator.getitem, place, document)


def leaves(value, at):
    if isinstance(value, dict):
        for name, item in value.items():
            yield from leaves(item, (*at, name))
    elif isinstance(value, list) and value and isinstance(value[0], dict):
        for k, item in enumerate(value):
            yield from leaves(item, (*at, k))
    else:
        yield at


def tables(value, at):
    if isinstance(value, dict):
        yield at
        for name, item in value.items():
            yield from tables(item, (*at, name))
    elif isinstance(value, list):
        for k, item in enumerate(value):
            yield from tables(item, (*at, k))


if __name__ == "__main__":
    main()
