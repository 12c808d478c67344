"""The files and folders of the repository, by their names."""

import json
import re
import tomllib
from pathlib import Path

# What makes a folder a package, and where its name stands.
MANIFESTS = {
    "Cargo.toml": lambda text: tomllib.loads(text).get("package", {}).get("name"),
    "pyproject.toml": lambda text: tomllib.loads(text).get("project", {}).get("name"),
    "package.json": lambda text: json.loads(text).get("name"),
}


class Places:
    def __init__(self, root, files):
        self.root = root
        self.files = files
        self.all = files | {folder for file in files for folder in file.parents}
        self.by_name, self.inside = {}, {}
        for place in sorted(self.all):
            self.by_name.setdefault(place.name, []).append(place)
            self.inside.setdefault(place.parent, set()).add(place.name)
        named = {file.parent: MANIFESTS[file.name]((root / file).read_text()) for file in files if file.name in MANIFESTS}
        self.packages = {folder: name for folder, name in named.items() if name}

    def __contains__(self, path):
        return path in self.all

    def pages(self):
        return [(file, (self.root / file).read_text()) for file in sorted(self.files) if file.suffix == ".md"]

    def package_of(self, path):
        """The innermost package that holds a file or folder."""
        return next((folder for folder in (path, *path.parents) if folder in self.packages), None)

    def has(self, name, at=(), below=()):
        """Whether a name, of which a star is any part, stands in one of the folders `at`, or anywhere below one of `below`."""
        shape = re.compile("(?:(.*)/)?" + "[^/]*".join(map(re.escape, name.rstrip("/").split("*"))))
        last = Path(name).name
        candidates = self.all if "*" in last else self.by_name.get(last, [])
        heads = [Path(match[1] or ".") for match in map(shape.fullmatch, map(str, candidates)) if match]
        return any(head in at or any(head.is_relative_to(folder) for folder in below) for head in heads)

    def also_called(self, name):
        """Where else there is a file or folder of this name, for who has to mend a page."""
        last = Path(name).name
        found = [str(place) for place in self.by_name.get(last) or self.by_name.get(f"{last}.rs", [])]
        if not found:
            return ""
        return f"; of this name there {'is' if len(found) == 1 else 'are'} {', '.join(found[:3])}{' ...' if len(found) > 3 else ''}"
