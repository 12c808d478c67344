"""What stands in a Markdown page: links, anchors, and what is in backticks, each with its line."""

import re
from collections import Counter

FENCED = re.compile(r"^[ \t]*(`{3,}|~{3,}).*?(?:^[ \t]*\1[`~]*[ \t]*$|\Z)", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"(?<!`)(`+)(?!`)((?:(?!\n\s*\n).)+?)(?<!`)\1(?!`)", re.DOTALL)
# Of links and pictures, of references, and of HTML.
TARGET = re.compile(r"""\]\(\s*<?([^)\s>]+)>?(?:\s+"[^"]*")?\s*\)|^ {0,3}\[[^\]^]+\]:\s*(\S+)|<[^>]*\b(?:href|src)="([^"]+)\"""", re.MULTILINE)
HEADING = re.compile(r"^ {0,3}#{1,6}[ \t]+(.+?)(?:[ \t]+#+)?[ \t]*$", re.MULTILINE)
NAMED = re.compile(r"""<[^>]*\b(?:id|name)="([^"]+)\"""")


def links(text):
    for line, match in found(blank(text, CODE), TARGET):
        yield line, next(target for target in match.groups() if target)


def anchors(text):
    """As GitHub makes them of headings: in small letters, without punctuation; one that comes again gets a number."""
    names = {match[1] for _, match in found(blank(text, CODE), NAMED)}
    times = Counter()
    for _, heading in found(text, HEADING):
        shown = re.sub(r"!?\[([^\]]*)\]\([^)]*\)|<[^>]+>", r"\1", heading[1])
        name = re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")
        names.add(f"{name}-{times[name]}" if times[name] else name)
        times[name] += 1
    return names


def code(text):
    return [(line, match[2]) for line, match in found(text, CODE)]


def blocks(text):
    for match in FENCED.finditer(text):
        first = text.count("\n", 0, match.start()) + 1
        yield from enumerate(match[0].splitlines(), first)


def found(text, pattern):
    """Matches outside blocks of code, with their lines."""
    prose = blank(text, FENCED)
    return [(prose.count("\n", 0, match.start()) + 1, match) for match in pattern.finditer(prose)]


def blank(text, pattern):
    """Spaces where the pattern is, so that all else keeps its place."""
    return pattern.sub(lambda match: re.sub(r"\S", " ", match[0]), text)
