"""Paths of numbers in a bag: a topic, and a field of its messages."""

from __future__ import annotations

import re
from dataclasses import dataclass

Step = str | int | slice
"""A field's name, an element's place, or a range of elements."""

_STEP = re.compile(r"\.([A-Za-z]\w*)|\[(\d+)\]|\[(\d*):(\d*)\]")


@dataclass(frozen=True)
class FieldPath:
    """A topic and the way from its messages to a number, or to several by one range of elements."""

    text: str
    """The path as it was asked for."""
    topic: str
    steps: tuple[Step, ...]

    @classmethod
    def parse(cls, text: str) -> FieldPath:
        """Reads a path such as `/ft/wrench.wrench.force.z` or `/films.data[0:12]`.

        Raises:
            ValueError: It is no such path; the message says what one is.

        """
        topic, point, _ = text.partition(".")
        at = len(topic)
        steps: list[Step] = []
        while (found := _STEP.match(text, at)) is not None:
            steps.append(_step(found))
            at = found.end()
        if not point or at < len(text) or not steps or not re.fullmatch(r"/?[\w/~-]+", topic):
            rest = f", which can't be read from {text[at:]!r} on" if steps and at < len(text) else ""
            raise ValueError(f"must be a topic, a point and a field, as /ft.wrench.force.z or /films.data[0:12]{rest}")
        ranges = [step for step in steps if isinstance(step, slice)]
        if len(ranges) > 1:
            raise ValueError("has two ranges of elements; one is the most")
        for step in ranges:
            if step.stop is not None and step.stop <= (step.start or 0):
                raise ValueError(f"has a range without an element, [{step.start or ''}:{step.stop}]; [0:12] has twelve")
        return cls(text, "/" + topic.removeprefix("/"), tuple(steps))


def written(steps: tuple[Step, ...]) -> str:
    """Steps as they stand in a path."""
    words = []
    for step in steps:
        if isinstance(step, slice):
            words.append(f"[{'' if step.start is None else step.start}:{'' if step.stop is None else step.stop}]")
        else:
            words.append(f".{step}" if isinstance(step, str) else f"[{step}]")
    return "".join(words)


def _step(found: re.Match[str]) -> Step:
    name, place, start, stop = found.groups()
    if name is not None:
        return name
    if place is not None:
        return int(place)
    return slice(int(start) if start else None, int(stop) if stop else None)
