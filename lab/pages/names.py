"""Files that a page or a comment names and that aren't there.

A page names them in backticks: by their path from the root, beside the page, or below the sources of a package that the page names too, as
decisions do where they say "Where". Sources name pages by their path.
"""

import re
from itertools import product
from pathlib import Path

from pages import markdown

PART = r"[\w.*{},-]+"
# A file of one of our languages, and a folder: these are names of something in the repository, whatever the text says.
CERTAIN = re.compile(rf"{PART}(?:/{PART})*(?:\.(?:rs|py|ts|tsx|mjs)|/)")
# Others are where they begin as paths of the repository do.
POSSIBLE = re.compile(rf"{PART}(?:/{PART})+/?")
# "`fem`: `law_contract`, `load/`" and "`law_contract` of `fem`": of this package alone; files may lack their suffix.
LIST = re.compile(r"`([\w-]+)`:((?:,?\s`[^`\n]+`)+)|(`[^`\n]+`) of `([\w-]+)`")
LISTED = re.compile(r"`([a-z0-9_]+(?:/[a-z0-9_]+)*(?:\.rs|/)?)`")
# A part in capitals stands for any name.
ANY = re.compile(r"\b(?!README)[A-Z]{2,}\b")

SOURCES = ("src", "tests", "benches", "examples")
COMMENTED = {".rs", ".ts", ".tsx", ".py", ".toml", ".mjs"}
# Its pages are made up.
LEFT_OUT = {Path("lab/house_test.py")}
PAGE = re.compile(r"(?<![\w-])(?:\.\./)*((?:\w[\w.-]*/)+[\w.-]+\.md)\b")


def breaches(places):
    for page, text in places.pages():
        packages = packages_of(page, text, places)
        listed = dict(names_in_lists(page, text, places))
        for line, name in sorted({*names(page, text, places), *listed}):
            where = [listed[line, name]] if (line, name) in listed else packages
            if not all(is_there(spelt, page, where, places) for spelt in spellings(name)):
                yield breach(page, line, name, where, places)


def packages_of(page, text, places):
    """Folders of the packages that a page names, of whose files it gives the path, or that it belongs to."""
    words = {word for _, word in markdown.code(text)}
    holding = {places.package_of(path) for path in (page, *map(Path, words)) if path in places}
    return sorted({folder for folder, name in places.packages.items() if name in words} | holding - {None})


def names(page, text, places):
    """Single words in backticks, and words of commands, with their lines."""
    starts = places.inside[Path()] | places.inside[page.parent]
    for line, quoted in markdown.code(text):
        if CERTAIN.fullmatch(quoted):
            yield line, quoted
    for line, quoted in [*markdown.code(text), *markdown.blocks(text)]:
        yield from ((line, word) for word in quoted.split() if POSSIBLE.fullmatch(word) and word.split("/")[0] in starts)


def names_in_lists(page, text, places):
    """Each with its line, and the package that it must be in."""
    folder_of = {name: folder for folder, name in places.packages.items()}
    for line, match in markdown.found(text, LIST) if places.package_of(page) is None else ():
        package, first = (match[1], match.start(2)) if match[1] else (match[4], match.start(3))
        for name in LISTED.finditer(match.string, first, match.end()) if package in folder_of else ():
            if name[1] != package:
                yield (line + match.string.count("\n", match.start(), name.start()), name[1]), folder_of[package]


def spellings(name):
    """`a/{b,c}.rs` is two names."""
    parts = [part.split(",") if k % 2 else [part] for k, part in enumerate(re.split(r"[{}]", name))]
    return [ANY.sub("*", "".join(choice)) for choice in product(*parts)]


def is_there(name, page, packages, places):
    # A page outside docs/ speaks of the folder that it stands in.
    own = [page.parent] if page.parts[0] != "docs" and page.parent != Path() else []
    below = [*own, *(folder / part for folder in packages for part in SOURCES)]
    return any(places.has(name + suffix, [Path(), page.parent, *packages], below) for suffix in ("", ".rs"))


def breach(page, line, name, packages, places):
    of = ", ".join(places.packages[folder] for folder in packages) if len(packages) < 5 else "the packages that it names"
    looked = f"at the root, beside the page or in the sources of {of}" if packages else "at the root or beside the page"
    return f"{page}:{line}: there is no {name} {looked}{places.also_called(name)}"


def breaches_of_sources(places):
    for file in sorted(places.files):
        if (file.suffix in COMMENTED or file.name == "Makefile") and file not in LEFT_OUT and "dist" not in file.parts:
            text = (places.root / file).read_text()
            for match in PAGE.finditer(text) if ".md" in text else ():
                if not any(folder / match[1] in places for folder in file.parents):
                    line = text.count("\n", 0, match.start()) + 1
                    yield f"{file}:{line}: there is no page {match[1]}{places.also_called(match[1])}"
