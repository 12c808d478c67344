"""Runs the program in a folder of its own, and tells what became of each attack."""

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

BIN = os.environ.get("STRAINSITE_BIN") or str(Path(__file__).resolve().parents[3] / "target/release/strainsite")
REPOSITORY = Path(__file__).resolve().parents[3]
INPUTS = """
[[inputs]]
name = "a"
distribution = { kind = "uniform", min = 0.0, max = 1.0 }
[[inputs]]
name = "b"
distribution = { kind = "uniform", min = 0.0, max = 1.0 }
"""


def bounded():
    """A program that takes all memory ends alone."""
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))


class Attacks:
    """A folder, the program in it, and the attacks so far."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.folder = Path(self._folder.name)
        self._lost = 0
        self._env = {k: v for k, v in os.environ.items() if not k.startswith("STRAINSITE_")}

    def run(self, *arguments, **options):
        """The ended program."""
        options = {"preexec_fn": bounded, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "timeout": 5, **options}
        command = [BIN, *map(str, arguments)]
        try:
            return subprocess.run(command, cwd=self.folder, env=self._env, **options)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(command, None, "", "it didn't end")

    def start(self, *arguments, **options):
        """The running program."""
        return subprocess.Popen([BIN, *map(str, arguments)], cwd=self.folder, env=self._env, **options)

    def write(self, name, text):
        """A file in the folder."""
        path = self.folder / name
        path.write_text(text)
        return path

    def survived(self, attack, held, seen=""):
        """A line for an attack."""
        self._lost += not held
        print(f"{'survived' if held else 'LOST'}: {attack}" + ("" if held else f": {str(seen)[:500]}"))

    def end(self):
        """Ends with 1 when an attack succeeded."""
        self._folder.cleanup()
        sys.exit(1 if self._lost else 0)
