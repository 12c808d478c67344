"""Documents that an OpenAPI description has, as Python dataclasses."""

from __future__ import annotations

import re
import textwrap
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    Schema = dict[str, Any]

WIDTH = 120
PLAIN = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "object": "dict[str, Any]"}
# What stands for a field that was left out and can't be None; the service reads its own documents so, too.
NOTHING = {"int": "0", "float": "0.0", "bool": "False"}


class Description:
    """Schemas by name, and the exceptions to what follows from them.

    Args:
        schemas: The schemas of the OpenAPI document.
        names: Names of classes, by schema.
        fields: Types of fields with their defaults, by schema and field; None leaves a field out.

    """

    def __init__(
        self, schemas: Mapping[str, Schema], names: Mapping[str, str], fields: Mapping[tuple[str, str], str | None]
    ) -> None:
        self._schemas = schemas
        self._names = names
        self._fields = fields

    def name(self, kind: str) -> str:
        """The name of a schema's class."""
        return self._names.get(kind, kind)

    def reached(self, answers: Iterable[str]) -> list[str]:
        """The schemas with fields that answers consist of, by the names of their classes.

        Raises:
            ValueError: An exception is about none of these, or two classes have the same name.

        """
        found: dict[str, dict[str, Schema]] = {}
        waiting = list(answers)
        while waiting:
            kind = waiting.pop()
            if kind in found or not self._is_class(kind):
                continue
            found[kind], _ = self._fields_of(self._schemas[kind])
            waiting += references([schema for name, schema in found[kind].items() if (kind, name) not in self._fields])
        idle = [kind for kind in self._names if kind not in found]
        idle += [f"{kind}.{name}" for kind, name in self._fields if name not in found.get(kind, ())]
        if idle:
            raise ValueError(f"no answer has what these exceptions are about: {', '.join(idle)}")
        if len({self.name(kind) for kind in found}) < len(found):
            raise ValueError("two schemas give classes of the same name")
        return sorted(found, key=self.name)

    def words(self, kind: str) -> str:
        """The type of an argument that is one of several words."""
        schema = self._schemas[kind]
        return f"{kind} = Literal{schema['enum']}\n{docstring(schema['description'])}"

    def dataclass(self, kind: str) -> str:
        """The class of a schema."""
        text = self._schemas[kind].get("description", "")
        if len(text) > WIDTH - 10:
            text = re.sub(r"(?<=[.!?])\s+", "\n\n", text, count=1)
        lines = ["@dataclass(frozen=True, kw_only=True)", f"class {self.name(kind)}:", docstring(text, "    ")]
        fields, required = self._fields_of(self._schemas[kind])
        for name, schema in fields.items():
            if (kind, name) in self._fields:
                declared = self._fields[kind, name]
            else:
                declared = self._declared(schema, required=name in required)
            if declared is None:
                continue
            lines.append(f"    {name}: {declared}")
            if text := self._said(schema):
                lines.append(docstring(text, "    "))
        return "\n".join(lines)

    def _is_class(self, kind: str) -> bool:
        """Whether a schema has fields of its own; another is a name for a plain type."""
        return not {"properties", "allOf"}.isdisjoint(self._schemas[kind])

    def _fields_of(self, schema: Schema) -> tuple[dict[str, Schema], set[str]]:
        """The fields of a schema and of those that it extends, and which of them are always there."""
        fields: dict[str, Schema] = {}
        required = set(schema.get("required", ()))
        for part in schema.get("allOf", ()):
            theirs, always = self._fields_of(self._schemas[target(part)] if "$ref" in part else part)
            fields |= theirs
            required |= always
        return fields | schema.get("properties", {}), required

    def _declared(self, schema: Schema, *, required: bool) -> str:
        """The type of a field, with the default of one that may be left out."""
        annotation = self._type(schema)
        if annotation.endswith(" | None"):
            return f"{annotation} = None"
        if required:
            return annotation
        if annotation.startswith("tuple"):
            return f"{annotation} = ()"
        return f"{annotation} = {NOTHING[annotation]}" if annotation in NOTHING else f"{annotation} | None = None"

    def _type(self, schema: Schema) -> str:
        if "$ref" in schema:
            kind = target(schema)
            return self.name(kind) if self._is_class(kind) else self._type(self._schemas[kind])
        kinds = schema.get("type")
        parts = [part for part in schema.get("oneOf", ()) if part != {"type": "null"}]
        if len(parts) == 1:
            return f"{self._type(parts[0])} | None"
        if isinstance(kinds, list):
            (plain,) = (kind for kind in kinds if kind != "null")
            return f"{self._type({**schema, 'type': plain})} | None"
        if kinds == "array":
            return self._tuple(schema)
        if kinds not in PLAIN:
            raise ValueError(f"no type of Python is known for {schema}")
        return PLAIN[kinds]

    def _tuple(self, schema: Schema) -> str:
        """A list: of items one by one, of so many of one kind, or of any number of them."""
        least, most = schema.get("minItems", 0), schema.get("maxItems")
        alike = [schema["items"]] * most if least == most else []
        items = ", ".join(map(self._type, schema.get("prefixItems", alike)))
        return f"tuple[{items or self._type(schema['items']) + ', ...'}]"

    def _said(self, schema: Schema) -> str:
        """What a field is, and which words it may have."""
        texts = [part["description"] for part in (schema, *schema.get("oneOf", ())) if "description" in part]
        words = [f"`{word}`" for kind in references(schema) for word in self._schemas[kind].get("enum", ())]
        if not all(word in "".join(texts) for word in words):
            texts.append(f"One of {', '.join(words)}.")
        return " ".join(texts)


def references(schema: object) -> Iterator[str]:
    """The schemas that one refers to."""
    if isinstance(schema, dict):
        if "$ref" in schema:
            yield target(schema)
        schema = list(schema.values())
    if isinstance(schema, list):
        for part in schema:
            yield from references(part)


def target(reference: Schema) -> str:
    """The schema that is referred to."""
    return str(reference["$ref"]).rpartition("/")[2]


def docstring(text: str, indent: str = "") -> str:
    """A text in quotes, paragraph by paragraph."""
    text = re.sub(r"\bnull\b", "None", text).replace("\\", "\\\\")
    text = re.sub(r'"(?="")|"$', r'\\"', text)
    quoted = f'{indent}"""'
    paragraphs = [
        textwrap.fill(
            " ".join(paragraph.split()),
            WIDTH - 3,
            initial_indent=indent if k else quoted,
            subsequent_indent=indent,
            break_long_words=False,
            break_on_hyphens=False,
        )
        for k, paragraph in enumerate(text.split("\n\n"))
    ]
    return "\n\n".join(paragraphs) + (f"\n{quoted}" if len(paragraphs) > 1 else '"""')
