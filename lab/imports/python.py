"""Imports between Python files. Those below `if TYPE_CHECKING` count like all others: who reads one file has to read the other, whatever runs."""

import ast


def edges(root, files):
    modules = {name: file for file in files if file.suffix == ".py" for name in names(file)}
    found = set()
    for file in files:
        if file.suffix == ".py":
            for node in statements(ast.parse((root / file).read_text())):
                for target in imported(node, file, modules):
                    if target != file:
                        found.add((str(file), node.lineno, str(target)))
    return found


def names(file):
    """A file by its place in the repository and by every shorter ending of it: a package's folder may lie anywhere."""
    parts = file.parent.parts if file.name == "__init__.py" else file.with_suffix("").parts
    yield parts
    # Beside the file that imports it, or below a `src`.
    if "src" in parts:
        yield parts[parts.index("src") + 1 :]


def statements(tree):
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        yield from statements(node)


def imported(node, file, modules):
    """The modules that a statement names; `from a import b` means a.b where that is a module, and else a."""
    folder = file.parent.parts
    if isinstance(node, ast.Import):
        candidates = [[start + tuple(alias.name.split("."))] for alias in node.names for start in ((), folder)]
    else:
        base = tuple(node.module.split(".")) if node.module else ()
        starts = [folder[: len(folder) - node.level + 1] + base] if node.level else [base, folder + base]
        candidates = [[(*start, alias.name), start] for start in starts for alias in node.names]
    for names_of_one in candidates:
        yield from [modules[name] for name in names_of_one if name in modules][:1]
