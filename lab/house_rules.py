"""The rules of the house: no import circle between files, no crowded folder, no file name twice, a short map."""

import subprocess
from pathlib import Path

from imports import circles, python, rust, web

MOST_ENTRIES = 15
CROWDED = {
    ".": "what users and their tools look for at the top",
    "migrations": "numbered, and never renumbered",
}

# Names that Rust or its habits ask for.
USUAL_STEMS = {"lib", "main", "mod", "build", "tests"}
TWICE = {}

MOST_LINES = {"ARCHITECTURE.md": 120}


def check(root):
    files = tracked(root)
    return [*import_circles(root, files), *crowded_folders(files), *names_twice(files), *long_pages(root, files)]


def tracked(root):
    """Files that are or could be committed."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    listed = subprocess.run(command, cwd=root, check=True, stdout=subprocess.PIPE, text=True).stdout
    return {Path(name) for name in listed.split("\0") if name and (root / name).is_file()}


def import_circles(root, files):
    edges = [edge for language in (rust, web, python) for edge in language.edges(root, files)]
    for circle in circles.circles(edges):
        members = sorted({file for file, _, _ in circle})
        imports = "".join(f"\n  {file}:{line}: imports {other}" for file, line, other in circle)
        yield f"{members[0]}: {len(members)} files import one another in a circle{imports}"


def crowded_folders(files):
    entries = {}
    for file in files:
        for part in (file, *file.parents[:-1]):
            entries.setdefault(str(part.parent), set()).add(part)
    for folder, inside in sorted(entries.items()):
        if len(inside) > MOST_ENTRIES and folder not in CROWDED:
            yield f"{folder}: {len(inside)} entries, more than {MOST_ENTRIES}"


def names_twice(files):
    """Of the sources of the Rust crates, tests and examples apart."""
    crates = [file.parent for file in files if file.name == "Cargo.toml"]
    places = {}
    for file in files:
        if file.suffix == ".rs" and any(file.is_relative_to(crate / "src") for crate in crates):
            places.setdefault(file.stem, []).append(str(file))
    for stem, same in sorted(places.items()):
        if len(same) > 1 and stem not in USUAL_STEMS | TWICE.keys():
            yield f"{stem}.rs: {len(same)} files of this name: {', '.join(sorted(same))}"


def long_pages(root, files):
    for page, most in MOST_LINES.items():
        if Path(page) in files:
            lines = len((root / page).read_text().splitlines())
            if lines > most:
                yield f"{page}: {lines} lines, more than {most}"
