"""Links of Markdown pages that lead nowhere, to no file or to no heading of it, and pages of docs/ that no link leads to."""

import difflib
import os
import re
from functools import cache
from pathlib import Path
from urllib.parse import unquote

from pages import markdown

ELSEWHERE = re.compile(r"[a-zA-Z][\w+.-]*:|//")
LINES = re.compile(r"L\d+(-L\d+)?")
START = Path("docs/README.md")


def breaches(places):
    anchors = cache(lambda page: markdown.anchors((places.root / page).read_text()))
    leads = {}
    for page, text in places.pages():
        for line, target in markdown.links(text):
            if not ELSEWHERE.match(target):
                aim, anchor = aim_of(page, unquote(target), places)
                leads.setdefault(page, set()).add(aim)
                fault = fault_of(aim, anchor, places, anchors)
                if fault:
                    yield f"{page}:{line}: the link {target} {fault}"
    for page in sorted(unreached(places, leads)):
        yield f"{page}: no links lead to it from {START}, the index of the pages"


def aim_of(page, target, places):
    """The file that a link shows, with the heading."""
    path, _, anchor = target.partition("#")
    # One that begins with a slash begins at the root of the repository.
    aim = Path(os.path.normpath(path.lstrip("/") if path.startswith("/") else page.parent / path)) if path else page
    return (aim / "README.md" if aim / "README.md" in places else aim), anchor


def fault_of(aim, anchor, places, anchors):
    if aim not in places:
        return f"leads nowhere: there is no {aim}{places.also_called(aim)}"
    if not anchor or (aim.suffix != ".md" and LINES.fullmatch(anchor)):
        return None
    known = anchors(aim) if aim.suffix == ".md" else set()
    if anchor in known:
        return None
    nearest = difflib.get_close_matches(anchor, sorted(known), 1, 0.4)
    return f"names no heading of {aim}{''.join(f'; the nearest is #{name}' for name in nearest)}"


def unreached(places, leads):
    pages = {page for page, _ in places.pages() if START.parent in page.parents}
    reached, work = set(), [START]
    while work:
        page = work.pop()
        if page not in reached:
            reached.add(page)
            work.extend(leads.get(page, ()))
    return pages - reached if START in pages else set()
