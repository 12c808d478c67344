"""What one Rust file says of modules: which it declares, which paths it names."""

import re
from dataclasses import dataclass, field

# Comments and literals name no module.
SILENT = re.compile(
    r"""//[^\n]* | /\*.*?\*/ | \bb?r(?P<hashes>\#*)".*?"(?P=hashes) | \bb?"(?:\\.|[^"\\])*" | "(?:\\.|[^"\\])*" | b?'(?:\\[^']+|[^'\\])'""",
    re.DOTALL | re.VERBOSE,
)
TOKEN = re.compile(r"[A-Za-z_][A-Za-z0-9_]*|::|\S")
PATH_ATTRIBUTE = re.compile(r'#\[path\s*=\s*"([^"]+)"\]\s*(?:pub(?:\([^)]*\))?\s+)?mod\s+(\w+)\s*;')
WORD = re.compile(r"[A-Za-z_]\w*$")


@dataclass
class Source:
    """Modules are named by their path below the file's own."""

    # module declared by `mod name;`: its file as a `#[path]` attribute gives it, or None
    children: dict[tuple, str | None] = field(default_factory=dict)
    # scope, line, path
    uses: list[tuple] = field(default_factory=list)
    mentions: list[tuple] = field(default_factory=list)


def read(text):
    attributes = {name: path for path, name in PATH_ATTRIBUTE.findall(text)}
    tokens = tokenise(text)
    source, scopes, depth, at = Source(), [((), 0)], 0, 0
    while at < len(tokens):
        word, line = tokens[at]
        scope = scopes[-1][0]
        follow = tokens[at + 1][0] if at + 1 < len(tokens) else ""
        after = tokens[at + 2][0] if at + 2 < len(tokens) else ""
        if word == "mod" and WORD.match(follow) and after in ";{":
            if after == ";":
                source.children[(*scope, follow)] = attributes.get(follow)
            else:
                depth += 1
                scopes.append(((*scope, follow), depth))
            at += 3
        elif word == "pub" and follow == "(":
            at = 1 + next(i for i in range(at, len(tokens)) if tokens[i][0] == ")")
        elif word == "use" and (follow in ("{", "::") or WORD.match(follow)):
            at, paths = use_tree(tokens, at + 1, ())
            source.uses += [(scope, line, path) for path in paths]
        elif WORD.match(word) and follow == "::":
            at, path = plain_path(tokens, at)
            source.mentions.append((scope, line, path))
        else:
            depth += (word == "{") - (word == "}")
            if word == "}" and depth < scopes[-1][1]:
                scopes.pop()
            at += 1
    return source


def tokenise(text):
    silent = SILENT.sub(lambda match: " " + "\n" * match[0].count("\n"), text)
    return [(word[0], number) for number, line in enumerate(silent.split("\n"), 1) for word in TOKEN.finditer(line)]


def plain_path(tokens, at):
    """The path that begins here, and where it ends."""
    path = [tokens[at][0]]
    at += 1
    while at + 1 < len(tokens) and tokens[at][0] == "::" and WORD.match(tokens[at + 1][0]):
        path.append(tokens[at + 1][0])
        at += 2
    return at + (at < len(tokens) and tokens[at][0] == "::"), tuple(path)


def use_tree(tokens, at, before):
    """All paths of a `use`, with the name each is known by behind `as`; and where it ends."""
    path, paths = before, []
    while tokens[at][0] not in (";", ",", "}"):
        word = tokens[at][0]
        if word == "{":
            at += 1
            while tokens[at][0] != "}":
                at, inner = use_tree(tokens, at, path)
                paths += inner
                at += tokens[at][0] == ","
            return at + 1, paths
        if word == "as":
            path = (*path, "as", tokens[at + 1][0])
            at += 2
        else:
            path = (*path, word) if WORD.match(word) else path
            at += 1
    return at, [path]
