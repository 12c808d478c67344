"""Prints docs/reference.md: every public class, method and field with the first lines of what it says of itself."""

from __future__ import annotations

import ast
import dataclasses
import inspect
import operator
import re
import textwrap

import strainsite

# A list that type checkers don't see.
PUBLIC: list[str] = vars(strainsite)["__all__"]

GROUPS = {
    "The way to a service": ["Client", "local"],
    "Studies": ["Study", "StudySummary", "Estimate", "Preview"],
    "Answers": [
        "Result",
        "Answer",
        "StrainMap",
        "Sections",
        "Rings",
        "Surface",
        "Location",
        "Layout",
        "LayoutFindings",
        "Signals",
        "ForceFindings",
        "ForceError",
        "Output",
        "Evaluation",
    ],
    "Sweeps and comparisons": ["Sweep", "SweepSummary", "Design", "SweepEstimate", "Comparison"],
    "Forces": [
        "Estimator",
        "EstimatorSummary",
        "FitReport",
        "ForceReport",
        "ModelReport",
        "SplitReport",
        "LeftOutRows",
        "recordings.from_bag",
        "Recording",
        "TopicTimes",
    ],
    "Models of your own": ["analyse", "Sensitivity", "ModelOutput"],
    "Errors": [
        name
        for name in PUBLIC
        if inspect.isclass(getattr(strainsite, name)) and issubclass(getattr(strainsite, name), Exception)
    ],
}
GROUPS["Parts of these"] = [name for name in PUBLIC if not any(name in names for names in GROUPS.values())]


def main() -> None:
    """Prints the whole page."""
    print("# Reference of the Python client\n")
    print("Written by `python/generate` from the docstrings; a test compares. Units are in the names; strains are")
    print("plain numbers. The [README](../README.md) has the tour.")
    for title, names in GROUPS.items():
        print(f"\n## {title}")
        for name in names:
            describe(name, operator.attrgetter(name)(strainsite))


def describe(name: str, thing: object) -> None:
    """Prints one class or function."""
    is_error = inspect.isclass(thing) and issubclass(thing, Exception)
    # The client makes all objects but itself.
    hidden = inspect.isclass(thing) and name != "Client"
    head = f"class {name}({', '.join(base.__name__ for base in thing.__bases__)})" if is_error else name  # type: ignore[attr-defined]
    print(f"\n### `{head if hidden else name + signature(thing)}`\n\n{body(thing)}")
    if not inspect.isclass(thing):
        return
    lines = [f"- `{field}`: `{kind}`{said and '. ' + ' '.join(said.split())}" for field, kind, said in fields(thing)]
    for member, value in members(thing).items():
        if member.startswith("_") or is_error:
            continue
        if isinstance(value, property):
            lines.append(f"- `.{member}`: {first(value.fget)}")
        elif isinstance(value, classmethod):
            lines.append(f"- `{name}.{member}{signature(value.__func__)}`: {first(value.__func__)}")
        elif inspect.isfunction(value):
            lines.append(f"- `.{member}{signature(value)}`: {first(value)}")
    if lines:
        print("\n**Members**\n\n" + "\n".join(lines))


def members(kind: type) -> dict[str, object]:
    """What a class has, and its bases within the client, its own last."""
    own = [base for base in kind.__mro__ if base.__module__.startswith("strainsite")]
    return {name: value for base in reversed(own) for name, value in vars(base).items()}


def fields(kind: type) -> list[tuple[str, str, str]]:
    """Fields of a dataclass and of its bases: name, type, and the text below it."""
    found: dict[str, tuple[str, str]] = {}
    for base in filter(dataclasses.is_dataclass, reversed(kind.__mro__)):
        source = ast.parse(textwrap.dedent(inspect.getsource(base))).body[0]
        assert isinstance(source, ast.ClassDef)  # noqa: S101 - a class's source is a class
        name = ""
        for statement in source.body:
            if isinstance(statement, ast.AnnAssign) and isinstance(statement.target, ast.Name):
                name = statement.target.id
                found[name] = (ast.unparse(statement.annotation), found.get(name, ("", ""))[1])
            elif name and isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant):
                found[name] = (found[name][0], str(statement.value.value))
    return [(name, *words) for name, words in found.items()]


def signature(function: object) -> str:
    """Arguments and answer as they are written, without `self`."""
    text = str(inspect.signature(function))  # type: ignore[arg-type]
    text = re.sub(r"(: |-> )'([^']*)'", r"\1\2", text)
    text = re.sub(r"^\((self|cls)(, )?", "(", text)
    return re.sub(r" -> None$", "", text)


def first(thing: object) -> str:
    """The first paragraph of a docstring on one line."""
    paragraph = (inspect.getdoc(thing) or "").split("\n\n", maxsplit=1)[0]
    return " ".join(paragraph.split())


def body(thing: object) -> str:
    """A whole docstring, its sections as lists."""
    text = inspect.getdoc(thing) or ""
    text = re.sub(r"^(Args|Attributes|Raises):\n", r"**\1**\n\n", text, flags=re.MULTILINE)
    text = re.sub(r"\n        +", " ", text)
    return re.sub(r"^    (\w+): ", r"- `\1`: ", text, flags=re.MULTILINE).rstrip()


if __name__ == "__main__":
    main()
