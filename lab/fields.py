#!/usr/bin/env python3
"""Makes the tables of all fields that documents have, of their schemas in web/openapi.json.

python3 lab/fields.py            writes docs/use/fields.md
python3 lab/fields.py --check    fails where the committed page is another
"""

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/use/fields.md"
DOCUMENTS = {
    "Scene": "what is pressed, and how",
    "Study": "what varies, and what is asked",
    "Sweep": "a study, and what its designs set otherwise",
    "Recipe": "forces from recordings: `strainsite force fit`",
    "Inputs": "a model of your own: `strainsite gsa`",
}
# What stands above this line is written by hand.
MARK = "<!-- What follows is made by lab/fields.py. -->\n\n"
REFERENCE = "#/components/schemas/"


def page():
    schemas = json.loads((ROOT / "web/openapi.json").read_text())["components"]["schemas"]
    schemas = {name.removesuffix("Document"): schema for name, schema in schemas.items() if name.endswith("Document")}
    told, parts = set(), []
    for name, what in DOCUMENTS.items():
        parts.append(f"## {name}: {what}\n")
        parts += sections(name, schemas, told)
    head, _, _ = PAGE.read_text().partition(MARK)
    return head + MARK + "\n".join(parts)


def sections(name, schemas, told):
    """The table of a definition, and those of all that it refers to and that weren't told before."""
    if name in told or name not in schemas:
        return
    told.add(name)
    schema = schemas[name]
    kinds = schema.get("oneOf", [schema])
    yield f"### {name}\n\n{schema.get('description', '')}\n"
    yield "| field | value | default | |\n|---|---|---|---|"
    shared = set.intersection(*({field for field in kind["properties"] if "const" not in kind["properties"][field]} for kind in kinds))
    rows = []
    for kind in kinds:
        tag = next((f"{field} = \"{of['const']}\"" for field, of in kind["properties"].items() if "const" in of), None)
        for field, of in kind["properties"].items():
            if "const" in of:
                rows.append(row(tag, of, of.get("default") is not None))
            elif field not in shared or len(kinds) == 1 or kind is kinds[-1]:
                rows.append(row(field, of, field not in kind.get("required", [])))
    yield "\n".join(dict.fromkeys(rows)) + "\n"
    for inner in references(schema):
        yield from sections(inner, schemas, told)


def row(name, schema, is_optional):
    default = schema.get("default", None)
    default = "" if default is None or isinstance(default, dict) else f"`{json.dumps(default)}`"
    if not is_optional:
        default = "required"
    return f"| `{name}` | {value(schema)} | {default} | {schema.get('description', '')} |"


def value(schema):
    """What a field takes, in words."""
    if "$ref" in schema:
        name = schema["$ref"].removeprefix(REFERENCE).removesuffix("Document")
        return f"[{name}](#{name.lower()})"
    if "anyOf" in schema:
        return " or ".join(value(option) for option in schema["anyOf"])
    if "enum" in schema:
        return ", ".join(f"`{option}`" for option in schema["enum"])
    kind = schema.get("type")
    if kind == "array":
        least, most = schema.get("minItems", 0), schema.get("maxItems")
        count = f"{least}" if least == most else f"{least} to {most}" if most else f"{least} or more"
        return f"list of {count}: {value(schema['items']) if 'items' in schema else 'any values'}"
    if kind in ("number", "integer"):
        return number(schema)
    if kind == "string":
        return f"text of 1 to {schema['maxLength']} characters" if "maxLength" in schema else "text"
    return {"boolean": "true or false", "object": "table by path", "null": "null"}.get(kind, "a kind of table")


def number(schema):
    low = f"above {plain(schema['exclusiveMinimum'])}" if "exclusiveMinimum" in schema else plain(schema["minimum"])
    unit = f" {schema['x-unit']}" if "x-unit" in schema else ""
    return f"{'whole number, ' if schema['type'] == 'integer' else ''}{low} to {plain(schema['maximum'])}{unit}"


def plain(x):
    """A number as the faults of documents have it."""
    size = abs(x)
    if size and not 1e-4 <= size < 1e7:
        digits, power = f"{x:e}".split("e")
        return f"{digits.rstrip('0').rstrip('.')}e{int(power)}"
    return str(int(x)) if float(x).is_integer() else f"{x:g}"


def references(schema):
    text = json.dumps(schema)
    for part in text.split(f'"{REFERENCE}')[1:]:
        yield part.split('"')[0].removesuffix("Document")


def main():
    text = page()
    if sys.argv[1:] != ["--check"]:
        PAGE.write_text(text)
    elif PAGE.read_text() != text:
        sys.exit("docs/use/fields.md isn't what web/openapi.json gives: run python3 lab/fields.py and commit it")


if __name__ == "__main__":
    main()
