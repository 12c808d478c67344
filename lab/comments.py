"""Documentation of Rust begins with the noun that it describes, or with the verb of what a function does."""

import re

# Words after which a reader still doesn't know what a thing is. "Whether" stays: it says that a thing is true or false.
NAMELESS = set(
    """
    it its they their them these those this that such same one ones none
    anybody anything everybody everything nobody nothing somebody something
    what whatever which who whom whose how why where when
    about above across after against along among around as at because before behind below beside between beyond by down during except far
    for from in inside into like near of off on onto out outside over since so then there through till to toward towards under until up upon
    while with within without
    but if not
    """.split()
)
QUANTIFIER = re.compile(r"\W*(?:all|any|both|each|most|some)(?: of (?:it|them|these|those)\b|[,.:;])")
PARTICIPLE = re.compile(r"\W*(?!(?:seed|speed|token)\b)\w+(?:ed|en|pt)(?:[,.;]| (\w+))")

COMMENT = re.compile(r"\s*//[/!](?!/)(.*)")


def breaches(root, files):
    for file in sorted(files):
        if file.suffix == ".rs":
            for line, text in begins((root / file).read_text()):
                if is_nameless(text.lower()):
                    yield f"{file}:{line}: the comment begins with no noun: {text}"


def begins(source):
    """First lines of comments, with their numbers."""
    inside = False
    for line, text in enumerate(source.splitlines(), 1):
        comment = COMMENT.match(text)
        if comment and not inside:
            yield line, comment[1].strip()
        inside = bool(comment)


def is_nameless(text):
    """Whether a text in lower case begins with such a word, of "the same" the second; with "all of them"; or as in "asked of rings"."""
    first = re.match(r"\W*(?:the (?=same\b))?([\w'-]+)", text)
    participle = PARTICIPLE.match(text)
    return bool((first and first[1] in NAMELESS) or QUANTIFIER.match(text) or (participle and (participle[1] or "of") in NAMELESS))
