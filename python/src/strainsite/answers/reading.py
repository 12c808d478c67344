"""JSON into typed objects; fields that this version doesn't know are passed over."""

from __future__ import annotations

import dataclasses
import functools
import types
import typing
from typing import TYPE_CHECKING, Any, TypeVar

from strainsite.errors import AnswerError

if TYPE_CHECKING:
    from collections.abc import Callable

    from _typeshed import DataclassInstance

    T = TypeVar("T", bound=DataclassInstance)


def read(kind: type[T], value: object, where: str = "") -> T:
    """A dataclass from a JSON object.

    Fields of the class that are missing take their default.

    Raises:
        AnswerError: A field that this client needs is missing, or of another type.

    """
    if not isinstance(value, dict):
        raise AnswerError(f"{where or kind.__name__} of the service's answer isn't an object")
    hints = _hints(kind)
    given: dict[str, Any] = {}
    for field in dataclasses.fields(kind):
        place = f"{where}.{field.name}" if where else field.name
        if field.name in value:
            given[field.name] = _convert(hints[field.name], value[field.name], place)
        elif field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING:
            raise AnswerError(f"the service's answer has no {place}: it is of another version than this client")
    return kind(**given)


def whole(kind: type[T], document: dict[str, Any]) -> T:
    """A dataclass that keeps the document itself, too, as `raw`."""
    return read(kind, {**document, "raw": document} if isinstance(document, dict) else document)


def records(values: object, kind: type[T], where: str) -> tuple[T, ...]:
    """A tuple of dataclasses from a JSON list."""
    if not isinstance(values, list):
        raise AnswerError(f"{where} of the service's answer isn't a list")
    return tuple(read(kind, value, f"{where}[{k}]") for k, value in enumerate(values))


@functools.cache
def _hints(kind: type) -> dict[str, Any]:
    return typing.get_type_hints(kind)


def _is_optional(hint: Any) -> bool:  # noqa: ANN401 - a type's description
    return types.NoneType in typing.get_args(hint)


def _convert(hint: Any, value: object, where: str) -> Any:  # noqa: ANN401 - whatever the hint says
    if _is_optional(hint):
        if value is None:
            return None
        hint = next(kind for kind in typing.get_args(hint) if kind is not types.NoneType)
    if dataclasses.is_dataclass(hint) and isinstance(hint, type):
        return read(hint, value, where)
    kind = typing.get_origin(hint) or hint
    if kind is tuple and isinstance(value, list):
        hints = typing.get_args(hint)
        hints = hints[:1] * len(value) if hints[-1] is ... else hints
        if len(hints) == len(value):
            return tuple(_convert(hints[k], one, f"{where}[{k}]") for k, one in enumerate(value))
    plain: dict[Any, Callable[[object], bool]] = {
        dict: lambda v: isinstance(v, dict),
        str: lambda v: isinstance(v, str),
        bool: lambda v: isinstance(v, bool),
        int: lambda v: isinstance(v, int) and not isinstance(v, bool),
        float: lambda v: isinstance(v, int | float) and not isinstance(v, bool),
    }
    if kind is typing.Any:
        return value
    if kind not in plain or not plain[kind](value):
        raise AnswerError(f"{where} of the service's answer is of an unexpected type: {value!r:.60}")
    return float(typing.cast("float", value)) if kind is float else value
