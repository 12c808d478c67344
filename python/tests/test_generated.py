"""Types that are made of a description, and what they read."""

from __future__ import annotations

import dataclasses
import sys
import types
from typing import Any

import answers
import pytest
from description import Description

from strainsite import AnswerError
from strainsite.answers.reading import read

HUB = {"$ref": "#/components/schemas/Hub"}
SCHEMAS: dict[str, Any] = {
    "Spoke": {
        "description": "A spoke.",
        "required": ["force_n", "state", "span", "notes"],
        "properties": {
            "hub": {"oneOf": [{"type": "null"}, {**HUB, "description": "Where it ends."}]},
            "force_n": {"type": "number", "description": "N; not null."},
            "state": {"$ref": "#/components/schemas/Tension", "description": "How it is."},
            "span": {"type": "array", "prefixItems": [{"type": "number"}, {"type": "integer"}], "items": False},
            "notes": {"type": "array", "items": {"type": ["string", "null"]}},
            "turns": {"type": "integer"},
            "spares": {"type": "array", "items": HUB},
            "colour": {"type": "string"},
            "loads": {"type": ["object", "null"]},
        },
    },
    "Tension": {"type": "string", "enum": ["tight", "loose"], "description": "How tight."},
    "Hub": {"description": "A hub.", "required": ["bolts"], "properties": {"bolts": {"type": "integer"}}},
    "Bent": {
        "description": "A bent spoke.",
        "allOf": [
            {"$ref": "#/components/schemas/Spoke"},
            {"required": ["at_mm"], "properties": {"at_mm": {"type": "number"}}},
        ],
    },
}
LEAST = {"force_n": 3, "state": "broken", "span": [1, 2], "notes": ["a", None]}


def made(
    names: dict[str, str] | None = None, fields: dict[tuple[str, str], str | None] | None = None, **schemas: Any
) -> Any:
    """The module of two kinds of spoke; `text` is how it is written."""
    description = Description({**SCHEMAS, **schemas}, names or {}, fields or {})
    module = types.ModuleType("made")
    sys.modules["made"] = module
    text = answers.module(description, ("Bent", "Spoke"), ("Tension",), "")
    exec(text, vars(module))  # noqa: S102 - our own
    vars(module)["text"] = text
    return module


def declared(kind: type) -> dict[str, tuple[object, object]]:
    missing = dataclasses.MISSING
    return {
        field.name: (field.type, "" if field.default is missing else field.default)
        for field in dataclasses.fields(kind)
    }


def test_fields_follow_their_schemas() -> None:
    module = made()
    spoke: dict[str, tuple[object, object]] = {
        "hub": ("Hub | None", None),
        "force_n": ("float", ""),
        "state": ("str", ""),
        "span": ("tuple[float, int]", ""),
        "notes": ("tuple[str | None, ...]", ""),
        "turns": ("int", 0),
        "spares": ("tuple[Hub, ...]", ()),
        "colour": ("str | None", None),
        "loads": ("dict[str, Any] | None", None),
    }
    assert declared(module.Spoke) == spoke
    assert declared(module.Bent) == spoke | {"at_mm": ("float", "")}
    assert module.__all__ == ["Bent", "Hub", "Spoke"]


def test_descriptions_are_docstrings() -> None:
    module = made()
    assert module.Spoke.__doc__ == "A spoke."
    for said in ("N; not None.", "How it is. One of `tight`, `loose`.", "Where it ends.", "How tight."):
        assert f'"""{said}"""' in module.text
    words = 'a "quote", a \\ and """ three. ' + "A long sentence. " * 20 + 'It ends with "this"'
    hub = {**SCHEMAS["Hub"], "description": words, "properties": {"bolts": {"type": "integer", "description": words}}}
    module = made(Hub=hub)
    assert " ".join(module.Hub.__doc__.split()) == words
    assert max(map(len, module.text.splitlines())) <= 120


def test_what_is_newer_is_passed_over_and_what_is_left_out_has_its_default() -> None:
    spoke = read(made().Spoke, {**LEAST, "material": "steel", "spares": [{"bolts": 5, "thread": "M3"}]})
    assert (spoke.force_n, spoke.state, spoke.span, spoke.notes) == (3.0, "broken", (1.0, 2), ("a", None))
    assert (spoke.hub, spoke.turns, spoke.colour, spoke.loads) == (None, 0, None, None)
    assert [hub.bolts for hub in spoke.spares] == [5]
    with pytest.raises(AnswerError, match="span .*unexpected type"):
        read(made().Spoke, {**LEAST, "span": [1, 2, 3]})
    with pytest.raises(AnswerError, match=r"no spares\[0\].bolts: it is of another version"):
        read(made().Spoke, {**LEAST, "spares": [{}]})


def test_exceptions_change_names_and_fields() -> None:
    fields = {("Spoke", "hub"): None, ("Spoke", "colour"): 'str = "black"', ("Spoke", "spares"): None}
    module = made({"Bent": "BentFields"}, fields, Bent={**SCHEMAS["Bent"], "allOf": [HUB]})
    assert module.__all__ == ["Spoke"]
    assert declared(module.BentFields) == {"bolts": ("int", "")}
    assert "hub" not in declared(module.Spoke)
    assert declared(module.Spoke)["colour"] == ("str", "black")
    assert not hasattr(module, "Hub"), "nothing has one any more"


@pytest.mark.parametrize(
    ("names", "fields", "schemas", "said"),
    [
        ({"Rim": "Felloe"}, {}, {}, "exceptions are about: Rim"),
        ({}, {("Spoke", "size"): None}, {}, r"exceptions are about: Spoke\.size"),
        ({"Spoke": "Hub"}, {}, {}, "two schemas give classes of the same name"),
        ({}, {}, {"Hub": {"properties": {"bolts": {"anyOf": []}}}}, "no type of Python is known for .*anyOf"),
    ],
)
def test_what_can_not_be_made_is_said(names: Any, fields: Any, schemas: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        made(names, fields, **schemas)
