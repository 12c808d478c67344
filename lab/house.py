#!/usr/bin/env python3
"""Names every breach of the rules of the house, each with its place.

python3 lab/house.py               checks the repository
python3 lab/house.py --self-test   checks that every breach is found
"""

import sys
from pathlib import Path

import house_rules
import house_test

ROOT = Path(__file__).resolve().parent.parent


def main():
    if sys.argv[1:] == ["--self-test"]:
        sys.exit(house_test.failed())
    breaches = house_rules.check(ROOT)
    for breach in breaches:
        print(breach)
    if breaches:
        print(f"{len(breaches)} breaches of the rules of the house", file=sys.stderr)
    sys.exit(bool(breaches))


if __name__ == "__main__":
    main()
