"""Imports between the files of Rust crates: `use`, `pub use` and every path in the code that leads to another module. `mod name;` is none."""

import tomllib
from functools import cache
from pathlib import Path

from imports import rust_source

source_of = cache(lambda path: rust_source.read(path.read_text()))


def edges(root, files):
    found = set()
    for manifest in sorted(file for file in files if file.name == "Cargo.toml"):
        described = tomllib.loads((root / manifest).read_text())
        if "package" in described:
            for start in targets(described, manifest.parent, files):
                found |= edges_of_target(root, start, files)
    return found


def targets(described, folder, files):
    """Files that a compiler starts from."""
    named = [folder / target["path"] for kind in ("bin", "test", "example", "bench") for target in described.get(kind, []) if "path" in target]
    usual = [folder / "src/lib.rs", folder / "src/main.rs", folder / "build.rs"]
    below = [
        file
        for file in files
        for place in ("src/bin", "tests", "examples", "benches")
        if file.suffix == ".rs" and (file.parent == folder / place or (file.name == "main.rs" and file.parent.parent == folder / place))
    ]
    return sorted({*below, *(file for file in [*usual, *named] if file in files)})


def edges_of_target(root, start, files):
    modules = module_tree(root, start, files)
    found = set()
    for module, file in modules.items():
        source = source_of(root / file)
        aliases = {}
        for scope, line, path in source.uses:
            path, name = (path[:-2], path[-1]) if "as" in path else (path, path[-1:] and path[-1])
            target = resolve(modules, module, scope, path, {})
            if target is None:
                continue
            if len(target[1]) == 0:
                aliases[(scope, name)] = target[0]
            found.add((file, line, modules[target[0]]))
        for scope, line, path in source.mentions:
            target = resolve(modules, module, scope, path, aliases)
            if target is not None:
                found.add((file, line, modules[target[0]]))
    return {(str(file), line, str(other)) for file, line, other in found if file != other}


def module_tree(root, start, files):
    """Every module of a target that has a file of its own, by its path."""
    modules, work = {}, [((), start, True)]
    while work:
        module, file, owns_folder = work.pop()
        modules[module] = file
        for child, given in source_of(root / file).children.items():
            folder = file.parent if owns_folder else file.parent / file.stem
            places = [file.parent / given] if given else [folder.joinpath(*child).with_suffix(".rs"), folder.joinpath(*child, "mod.rs")]
            for place in map(normal, places):
                if place in files:
                    work.append(((*module, *child), place, bool(given) or place.name == "mod.rs"))
    return modules


def normal(path):
    parts = []
    for part in path.parts:
        if part == ".." and parts:
            parts.pop()
        else:
            parts.append(part)
    return Path(*parts)


def resolve(modules, module, scope, path, aliases):
    """The module with a file of its own that a path leads to, and what is left of the path."""
    here, rest = (*module, *scope), path
    if not rest:
        return None
    if rest[0] == "crate":
        here, rest = (), rest[1:]
    elif rest[0] in ("self", "super"):
        while rest and rest[0] in ("self", "super"):
            here, rest = here[: len(here) - (rest[0] == "super")], rest[1:]
    else:
        begun = first_name(modules, module, scope, rest[0], aliases)
        if begun is None:
            return None
        here, rest = begun, rest[1:]
    while rest and (*here, rest[0]) in modules:
        here, rest = (*here, rest[0]), rest[1:]
    # An inline module lies in the file of the nearest module that has one.
    while here not in modules:
        here = here[:-1]
    return here, rest


def first_name(modules, module, scope, name, aliases):
    """A child or an imported module, seen from a scope or from those of the same file around it."""
    for size in range(len(scope), -1, -1):
        if (*module, *scope[:size], name) in modules:
            return (*module, *scope[:size], name)
        if (scope[:size], name) in aliases:
            return aliases[(scope[:size], name)]
    return None
