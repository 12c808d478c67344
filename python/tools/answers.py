"""Writes src/strainsite/answers/_generated.py, the types of the service's answers, from its description.

python tools/answers.py          writes it
python tools/answers.py --check  fails when the committed one isn't what the description gives
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from description import Description

ROOT = Path(__file__).resolve().parents[2]
DESCRIPTION = ROOT / "web/openapi.json"
TARGET = ROOT / "python/src/strainsite/answers/_generated.py"

# What methods of the client answer; all that these consist of follows from the description.
ANSWERS = (
    "Candidates",
    "Comparison",
    "DesignView",
    "EngineList",
    "Estimate",
    "EstimatorSummary",
    "EstimatorZero",
    "EvaluationView",
    "LeftOutRows",
    "Look",
    "ModelAnalysis",
    "Presets",
    "Preview",
    "Report",
    "Rings",
    "Sections",
    "SolvedScene",
    "StudyResult",
    "StudySummary",
    "SweepEstimate",
    "SweepSummary",
)
# Words that these methods take. In answers words are plain texts, as a newer service may have more of them.
WORDS = ("ComparisonTable", "State", "Table")

# Exceptions, each with its reason. Classes that scripts know by another name than the description's:
NAMES = {
    "CandidateFilm": "Candidate",  # an entry of `candidates`
    "ClaimRow": "Claim",  # an entry of `claims`; the description's own Claim is its words
    "DesignView": "Design",  # an entry of `designs`
    "EngineView": "Engine",  # an entry of `engines`
    "EvaluationView": "Evaluation",  # an entry of `evaluations`
    "Fault": "RecordingFault",  # an entry of a look's `faults`; errors have a Fault of their own
    "IndexError": "ErrorParts",  # Python has an IndexError of its own
    "InputReport": "Input",  # an entry of `inputs`
    "ModelSummary": "Model",  # what `model` is
    "RankedLayout": "Layout",  # an entry of `layouts`
    "RankedLocation": "Location",  # an entry of `locations`
    "StrainFields_f64": "Strains",  # of a place, both directions
    "StudyCost": "Cost",  # what `cost` is
    # Those that do something are written by hand, on a base with their fields.
    "Comparison": "ComparisonFields",
    "ForceReport": "ForceReportFields",
    "LeftOutRows": "LeftOutRowsFields",
    "ModelAnalysis": "SensitivityFields",
    "Report": "FitReportFields",
    "StudyResult": "ResultFields",
}
# Fields with another type and default than the description's, or None where they are left out:
FIELDS = {
    ("SolvedScene", "derivatives"): "tuple[dict[str, Any], ...] = ()",  # each has the answer's own fields beside `by`
    ("Preview", "map"): "dict[str, Any] | None = None",  # scripts read it by its keys
    ("StudyResult", "climb"): "dict[str, Any] | None = None",  # scripts read it by its keys
    ("StudyResult", "map"): None,  # a method, which makes arrays of what `raw` has
}

HEAD = '''\
"""What the service answers, class by class.

Made from web/openapi.json by python/generate: not edited by hand.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal'''


def main() -> None:
    """Writes the module, or compares it with the one that is there."""
    document = json.loads(DESCRIPTION.read_text(encoding="utf-8"))
    description = Description(document["components"]["schemas"], NAMES, FIELDS)
    try:
        text = formatted(module(description, ANSWERS, WORDS, columns_of(document["x-tables"])))
    except ValueError as error:
        sys.exit(f"{error}; the exceptions are in python/tools/answers.py")
    if sys.argv[1:] != ["--check"]:
        TARGET.write_text(text, encoding="utf-8")
    elif TARGET.read_text(encoding="utf-8") != text:
        sys.exit(f"{TARGET.relative_to(ROOT)} isn't what web/openapi.json gives: run python/generate and commit it")


def columns_of(tables: dict[str, Any]) -> str:
    """Columns of tables as their names, the pointers of their values, and the unit of the rows that have one."""
    exported = {name: [each for each in table["columns"] if each["exported"]] for name, table in tables.items()}
    columns = {
        name: [(each["name"], each["at"], each.get("of_unit")) for each in table]
        for name, table in exported.items()
        if table
    }
    return f"COLUMNS: dict[str, list[tuple[str, str, str | None]]] = {columns}"


def module(description: Description, answers: tuple[str, ...], words: tuple[str, ...], columns: str) -> str:
    """The whole module: names for `import *`, the words of arguments, the classes by name, the columns of tables."""
    kinds = description.reached(answers)
    # A base is imported by the class that is made of it.
    public = [name for name in map(description.name, kinds) if not name.endswith("Fields")]
    parts = [HEAD, f"__all__ = {public}"]
    parts += [description.words(kind) for kind in words]
    parts += [description.dataclass(kind) for kind in kinds]
    return "\n\n".join([*parts, columns])


def formatted(text: str) -> str:
    """As the formatter would leave it."""
    command = [sys.executable, "-m", "ruff", "format", "--quiet", "--stdin-filename", str(TARGET), "-"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


if __name__ == "__main__":
    main()
