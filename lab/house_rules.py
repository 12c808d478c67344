"""The rules of the house: no import circle between files or folders, no name public that nothing outside its crate needs, no crowded folder, no file name twice, a
short map, pages that name what is there, comments that begin with a noun."""

import re
import subprocess
from pathlib import Path

import comments
import publicity
from imports import circles, python, rust, web
from pages import links, names
from pages.places import Places

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
    of_rust = rust.edges(root, files)
    return [
        *import_circles(root, files, of_rust),
        *folder_circles(root, of_rust),
        *publicity.breaches(root, files),
        *crowded_folders(files),
        *names_twice(files),
        *long_pages(root, files),
        *pages_astray(root, files),
        *comments.breaches(root, files),
    ]


def tracked(root):
    """Files that are or could be committed."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    listed = subprocess.run(command, cwd=root, check=True, stdout=subprocess.PIPE, text=True).stdout
    return {Path(name) for name in listed.split("\0") if name and (root / name).is_file()}


def import_circles(root, files, of_rust):
    edges = [*of_rust, *web.edges(root, files), *python.edges(root, files)]
    for circle in circles.circles(edges):
        members = sorted({file for file, _, _ in circle})
        imports = "".join(f"\n  {file}:{line}: imports {other}" for file, line, other in circle)
        yield f"{members[0]}: {len(members)} files import one another in a circle{imports}"


def folder_circles(root, of_rust):
    """Circles between the folders right below a crate's `src`, and files there. Tests may look anywhere."""
    edges = set()
    for file, line, other in of_rust:
        here, there = folder(file), folder(other)
        if here and there and here != there and here.parent == there.parent and line < first_test_line((root / file).read_text()):
            edges.add((str(here), f"{file}:{line}", str(there)))
    for circle in circles.circles(edges):
        members = sorted({here for here, _, _ in circle})
        if not any((root / member).is_dir() for member in members):
            continue  # files, which are told as such
        imports = "".join(f"\n  {place}: imports {there}" for _, place, there in circle)
        yield f"{members[0]}: {len(members)} folders import one another in a circle{imports}"


def folder(file):
    """What a file is in below its crate's `src`; None of a crate's roots, of tests and of what lies elsewhere."""
    parts = Path(file).with_suffix("").parts
    if "src" not in parts[:-1] or parts[-1] == "tests" or parts[-1].endswith("_tests"):
        return None
    below = parts.index("src") + 1
    return None if parts[below] in ("lib", "main") else Path(*parts[: below + 1])


def first_test_line(text):
    """The line from which a file holds nothing but its tests."""
    found = re.search(r"(?m)^#\[cfg\(test\)\]\n(?:#.*\n)*(?:pub(?:\(crate\))? )?mod \w+ \{", text)
    return text[: found.start()].count("\n") + 1 if found else len(text)


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


def pages_astray(root, files):
    """Links, and names of files, that lead nowhere."""
    places = Places(root, files)
    return [*links.breaches(places), *names.breaches(places), *names.breaches_of_sources(places)]
