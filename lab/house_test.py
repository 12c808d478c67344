"""Small repositories, each with one breach of the rules, and one without any."""

import os
import subprocess
import tempfile
from pathlib import Path

import house_rules

CRATE = {"a/Cargo.toml": '[package]\nname = "a"\n'}
PARENT = {**CRATE, "a/src/lib.rs": "pub mod disc;\npub mod ring;\npub fn radius() {}\n", "a/src/disc.rs": "pub struct Disc;\n"}
DEEP = {**PARENT, "a/src/ring/tests.rs": "use super::*;\n"}

# What is built, and what the only breach must say; None: no breach.
CASES = {
    "modules that only declare each other": (
        {
            **DEEP,
            "a/src/ring.rs": 'use crate::disc::Disc;\nuse super::radius;\n// use of crate::ring\nconst S: &str = "crate::ring";\n#[cfg(test)]\nmod tests;\n',
        },
        None,
    ),
    "use": (
        {**PARENT, "a/src/ring.rs": "use crate::disc::Disc;\n", "a/src/disc.rs": "use super::{radius, ring};\n"},
        "a/src/disc.rs: 2 files import one another in a circle\n  a/src/disc.rs:1: imports a/src/ring.rs\n  a/src/ring.rs:1: imports a/src/disc.rs",
    ),
    "re-export": (
        {**PARENT, "a/src/lib.rs": "mod disc;\nmod ring;\npub use ring::Ring;\npub fn radius() {}\n", "a/src/ring.rs": "use crate::radius;\n"},
        "a/src/lib.rs:3: imports a/src/ring.rs",
    ),
    "path in the code": (
        {**PARENT, "a/src/ring.rs": "fn f() {\n    crate::disc::f::<u8>();\n}\n", "a/src/disc.rs": "use super::ring as r;\nfn f() { r::f() }\n"},
        "a/src/ring.rs:2",
    ),
    "within an inline module": (
        {
            **PARENT,
            "a/src/ring.rs": "mod inner {\n    mod deeper {\n        use super::super::super::disc;\n    }\n}\n",
            "a/src/disc.rs": "use super::ring::inner;\n",
        },
        "a/src/ring.rs:3",
    ),
    "file of a path attribute": (
        {**CRATE, "a/tests/x.rs": '#[path = "../shared/y.rs"]\nmod y;\nuse y::Y;\nstruct X;\n', "a/shared/y.rs": "pub use super::X;\n"},
        "a/shared/y.rs:1: imports a/tests/x.rs",
    ),
    "folders": (
        {
            **CRATE,
            "a/src/lib.rs": "pub mod disc;\npub mod ring;\n",
            "a/src/disc/mod.rs": "pub mod edge;\npub mod face;\n",
            "a/src/disc/edge.rs": "use crate::ring::Ring;\n",
            "a/src/disc/face.rs": "pub struct Face;\n",
            "a/src/ring.rs": "use crate::disc::face::Face;\npub struct Ring;\n",
        },
        "a/src/disc: 2 folders import one another in a circle\n  a/src/disc/edge.rs:1: imports a/src/ring\n  a/src/ring.rs:1: imports a/src/disc",
    ),
    "names that others need": (
        {
            **CRATE,
            "a/src/lib.rs": "pub mod disc;\n",
            "a/src/disc.rs": "pub fn radius(of: [f64; 2]) -> Disc {}\npub struct Disc {\n    pub edge: Edge,\n}\npub(crate) struct Face;\npub struct Edge;\n",
            "b/Cargo.toml": '[package]\nname = "b"\n',
            "b/src/lib.rs": "use a::disc::radius;\n",
        },
        None,
    ),
    "name that nothing outside needs": (
        {
            **CRATE,
            "a/src/lib.rs": "pub fn ring() -> Ring {}\npub struct Ring {\n    edge: Edge,\n}\npub struct Edge;\n",
            "b/Cargo.toml": '[package]\nname = "b"\n',
            "b/src/lib.rs": "// Edge\nuse a::ring;\n",
        },
        "a/src/lib.rs:5: `Edge` is public, and nothing outside `a` needs it",
    ),
    "a folder's tests": (
        {
            **CRATE,
            "a/src/lib.rs": "pub mod disc;\npub mod ring;\n",
            "a/src/disc/mod.rs": "pub mod edge;\npub mod face;\n",
            "a/src/disc/edge.rs": "pub struct Edge;\n\n#[cfg(test)]\nmod tests {\n    use crate::ring::Ring;\n}\n",
            "a/src/disc/face.rs": "pub struct Face;\n",
            "a/src/ring.rs": "use crate::disc::face::Face;\npub struct Ring;\n",
        },
        None,
    ),
    "types of TypeScript": ({"web/a.ts": 'import type {\n  B,\n} from "./b";\n', "web/b.tsx": 'export * from "./a.js";\n'}, "web/a.ts:3: imports web/b.tsx"),
    "folder of TypeScript": (
        {"web/views/index.ts": 'import "../a";\n', "web/a.ts": 'const v = await import("./views");\n'},
        "web/a.ts:1: imports web/views/index.ts",
    ),
    "Python": (
        {"p/src/q/__init__.py": "", "p/src/q/a.py": "from .b import B\n", "p/src/q/b.py": "def f():\n    from q import a\n"},
        "p/src/q/b.py:2: imports p/src/q/a.py",
    ),
    "Python package": ({"p/src/q/__init__.py": "from .a import A\n", "p/src/q/a.py": "from q import B\n"}, "p/src/q/__init__.py:1: imports p/src/q/a.py"),
    "Python's types": (
        {"p/a.py": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from .b import B\n", "p/b.py": "from .a import A\n"},
        "p/a.py:3: imports p/b.py",
    ),
    "full folder": ({f"docs/page{i}/x.md": "" for i in range(15)}, None),
    "crowded folder": ({f"docs/page{i}/x.md": "" for i in range(16)}, "docs: 16 entries, more than 15"),
    "usual names": (
        {**CRATE, "a/src/x/mod.rs": "", "a/src/y/mod.rs": "", "a/src/x/tests.rs": "", "a/src/y/tests.rs": "", "a/src/z.rs": "", "a/tests/z.rs": ""},
        None,
    ),
    "name twice": ({**CRATE, "a/src/x/climb.rs": "", "a/src/climb.rs": ""}, "climb.rs: 2 files of this name: a/src/climb.rs, a/src/x/climb.rs"),
    "short map": ({"ARCHITECTURE.md": "line\n" * 120}, None),
    "long map": ({"ARCHITECTURE.md": "line\n" * 121}, "ARCHITECTURE.md: 121 lines, more than 120"),
    "links that hold": (
        {
            "docs/x.md": "# A `b_c`, or [d](y/) (e)!\n## Same\n## Same\n[1](#a-b_c-or-d-e) [2](#same-1) [3](../r%20s.md#f) [4](y/#f) ![5](p.svg)\n[6](http://x.y/z) [7]( y/ \"t\")\n[r]: y/README.md\n",
            "docs/y/README.md": '<a id="f"></a>\n`[8](no)`\n```toml\n[9](no)\n```\n[10](/docs/x.md)\n',
            "docs/p.svg": "",
            "r s.md": "## F\n",
        },
        None,
    ),
    "link to nothing": (
        {"docs/x.md": "```\n# no\n```\nsee\n[y](../y.md)\n", "docs/use/y.md": ""},
        "docs/x.md:5: the link ../y.md leads nowhere: there is no y.md; of this name there is docs/use/y.md",
    ),
    "link to no heading": ({"x.md": "[y](y.md#mesh-lines)\n", "y.md": "# Mesh line\n"}, "x.md:1: the link y.md#mesh-lines names no heading of y.md; the nearest is #mesh-line"),
    "page that no index leads to": (
        {"docs/README.md": "[x](use/x.md)\n", "docs/use/x.md": "[y](/r.md)\n", "r.md": "[z](docs/z.md)\n", "docs/z.md": "", "docs/use/lost.md": "[x](x.md)\n"},
        "docs/use/lost.md: no links lead to it from docs/README.md, the index of the pages",
    ),
    "names that hold": (
        {
            **CRATE,
            "docs/x.md": "Crate `a`: `y/disc.rs`, `y/`; `a`: `ring`, `y/disc`; `ring` of `a`. `a/src/y`, `a/src/{y,z}/NAME.rs`, `a/src/*`, `text/plain`, `my.toml`\n```\nrun a/src/y/disc.rs b/c\n```\n",
            "a/src/y/disc.rs": "// [x](docs/x.md) and z.md\n",
            "a/src/z/pin.rs": "",
            "a/tests/ring.rs": "",
            "t/README.md": "`u/v.py`, `v.py`\n",
            "t/u/v.py": "",
        },
        None,
    ),
    "name of nothing": (
        {**CRATE, "b/Cargo.toml": '[package]\nname = "b"\n', "docs/x.md": "Crate `a`:\n`disc.rs`; crate `b`\n", "a/src/y.rs": "", "b/src/disc.rs": ""},
        "docs/x.md:2: there is no disc.rs at the root, beside the page or in the sources of a; of this name there is b/src/disc.rs",
    ),
    "name without a suffix": ({**CRATE, "docs/x.md": "`a`: `disc`\n", "a/src/y.rs": ""}, "docs/x.md:1: there is no disc at the root, beside the page or in the sources of a"),
    "path of nothing": ({"docs/x.md": "```\nsh t/run t/walk\n```\n", "t/run": ""}, "docs/x.md:2: there is no t/walk at the root or beside the page"),
    "page of a comment": ({**CRATE, "docs/x.md": "", "a/src/y.rs": "//! y\n\n// docs/x.md, docs/gone.md\n"}, "a/src/y.rs:3: there is no page docs/gone.md"),
    "comments of nouns": (
        {**CRATE, "a/src/y.rs": "//! Rings.\n\n/// Radius,\n/// of the ring.\n// Of no concern.\n//// Of none.\n/// Whether it turns. Of all.\n/// The edge: the same.\n"},
        None,
    ),
    "comment without a noun": ({**CRATE, "a/src/y.rs": "//! Rings.\n\n/// `Of` a ring.\n"}, "a/src/y.rs:3: the comment begins with no noun: `Of` a ring."),
    "comment of a participle": ({**CRATE, "a/src/y.rs": "/// Seed of it.\nx\n/// Asked of rings.\n"}, "a/src/y.rs:3: the comment begins with no noun: Asked of rings."),
    "comment of all of them": ({**CRATE, "a/src/y.rs": "/// All rings.\nx\n/// All of them.\n"}, "a/src/y.rs:3: the comment begins with no noun: All of them."),
    "comment of the same": ({**CRATE, "a/src/y.rs": "/// The same, turned.\n"}, "a/src/y.rs:1: the comment begins with no noun: The same, turned."),
}


def failed():
    # Within a hook or a rebase Git names the repository it works on in these, and `git init` would write into that one.
    for name in [name for name in os.environ if name.startswith("GIT_")]:
        del os.environ[name]
    names = [name for name, (files, expected) in CASES.items() if not passes(name, files, expected)]
    print(f"{len(CASES) - len(names)} of {len(CASES)} cases pass")
    return bool(names)


def passes(name, files, expected):
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            (Path(folder) / path).parent.mkdir(parents=True, exist_ok=True)
            (Path(folder) / path).write_text(text)
        subprocess.run(["git", "init", "--quiet"], cwd=folder, check=True)
        breaches = house_rules.check(Path(folder))
    right = len(breaches) == 1 and expected in breaches[0] if expected else not breaches
    if not right:
        print(f"{name}:\n  expected {expected}\n  observed {breaches}")
    return right
