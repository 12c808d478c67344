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
