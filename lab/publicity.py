"""Names that a crate makes public though nothing outside needs them: no other crate mentions them, nor do they stand in a signature, a field or a variant of a
public item that one does."""

import re

from imports.rust_source import SILENT

ITEM = re.compile(
    r"^[ \t]*pub (?:const (?=fn|unsafe)|async |unsafe |extern )*(fn|struct|enum|trait|const|static|type|mod|union) (\w+)", re.M
)
# What an implementation of a trait hands out.
ASSOCIATED = re.compile(r"^[ \t]+type \w+ = ([^;]*);", re.M)
WORD = re.compile(r"\w+")
# What may stand in a signature; other items with a name that does are a coincidence.
TYPES = ("struct", "enum", "union", "trait", "type")


def breaches(root, files):
    """Each name with its place, of the library crates among all files of the repository; a crate alone is somebody else's library."""
    whole = {file: silent((root / file).read_text()) for file in files if file.suffix == ".rs"}
    sources = {file: without_tests(text) for file, text in whole.items()}
    crates = sorted({file.parent for file in files if file.name == "Cargo.toml" and file.parent / "src/lib.rs" in sources})
    if len(crates) == 1:
        return
    homes = {file: home(file, crates) for file in sources}
    words = {file: set(WORD.findall(text)) for file, text in whole.items()}
    for crate in crates:
        outside = set().union(*(words[file] for file, other in homes.items() if other != crate))
        items = [item for file in sorted(sources) if homes[file] == crate for item in public_items(file, sources[file])]
        handed = {word for file in sources if homes[file] == crate for given in ASSOCIATED.findall(sources[file]) for word in WORD.findall(given)}
        needed = {item["name"] for item in items if item["name"] in outside | handed}
        grown = True
        while grown:
            seen = set().union(*(item["face"] for item in items if item["name"] in needed))
            more = {item["name"] for item in items if item["kind"] in TYPES and item["name"] in seen} - needed
            needed |= more
            grown = bool(more)
        for item in items:
            if item["name"] not in needed:
                yield f"{item['place']}: `{item['name']}` is public, and nothing outside `{crate}` needs it"


def home(file, crates):
    """The library crate whose part a source is; None of programs, tests, benches and examples, which see it from outside."""
    within = [crate for crate in crates if file.is_relative_to(crate / "src")]
    is_program = file.name == "main.rs" or "bin" in file.parts
    return None if is_program or not within else max(within, key=lambda crate: len(crate.parts))


def silent(text):
    """Without comments and literals; lines stay."""
    return SILENT.sub(lambda match: " " + "\n" * match[0].count("\n"), text)


def without_tests(text):
    """Up to the tests at the end."""
    tests = re.search(r"(?m)^#\[cfg\(test\)\]\n(?:#.*\n)*(?:pub(?:\(crate\))? )?mod \w+ \{", text)
    return text[: tests.start()] if tests else text


def public_items(file, text):
    for found in ITEM.finditer(text):
        kind, name = found.groups()
        if text[: found.start()].rstrip().rsplit("\n", 1)[-1].lstrip().startswith("#[proc_macro"):
            continue  # public by what it is
        line = text[: found.start()].count("\n") + 1
        yield {"place": f"{file}:{line}", "name": name, "kind": kind, "face": set(WORD.findall(face(kind, text[found.end() :])))}


def face(kind, rest):
    """What others see of an item: of a function its signature, of a type its public fields or variants, of a constant its type."""
    if kind == "mod":
        return ""
    if kind == "fn":
        return signature(rest)
    if kind in ("const", "static"):
        return re.match(r"[^=;]*", rest)[0]
    if kind == "type":
        return re.match(r"[^;]*", rest)[0]
    head = re.match(r"[^{;]*", rest)[0]
    if kind == "struct":
        body = block(rest[len(head) :])
        shown = re.findall(r"pub (?!\()[^\n]*(?:\n(?![ \t]*(?:pub|#|\w+:|\}))[^\n]*)*", body)
        return head + " ".join(shown)
    return head + block(rest[len(head) :])


def signature(text):
    """Up to the body, or the end of a declaration: neither begins within brackets."""
    depth = 0
    for at, letter in enumerate(text):
        depth += (letter in "([") - (letter in ")]")
        if depth == 0 and letter in "{;":
            return text[:at]
    return text


def block(text):
    """The braces that a text begins with, and what is between."""
    depth = 0
    for at, letter in enumerate(text):
        depth += (letter == "{") - (letter == "}")
        if depth == 0:
            return text[: at + 1]
    return text
