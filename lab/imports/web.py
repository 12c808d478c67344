"""Imports between TypeScript and JavaScript files, those of types alone among them."""

import re

from imports.rust import normal

SUFFIXES = (".ts", ".tsx", ".mjs", ".js", ".jsx")
IMPORT = re.compile(r"""(?:\bfrom|\bimport\s*\(|^\s*import)\s*["'](\.[^"']*)["']""", re.MULTILINE)


def edges(root, files):
    found = set()
    for file in files:
        if file.suffix in SUFFIXES and "dist" not in file.parts:
            text = (root / file).read_text()
            for match in IMPORT.finditer(text):
                target = imported(normal(file.parent / match[1]), files)
                if target is not None and target != file:
                    found.add((str(file), text.count("\n", 0, match.start(1)) + 1, str(target)))
    return found


def imported(path, files):
    """As the bundler looks for it; `./x.js` may be written for x.ts."""
    plain = path.with_suffix("") if path.suffix in SUFFIXES else path
    places = [path, *(plain.with_name(plain.name + suffix) for suffix in SUFFIXES), *(path / f"index{suffix}" for suffix in SUFFIXES)]
    return next((place for place in places if place in files), None)
