"""A database to attack: a service on it, studies for it, and verdicts."""

import json
import os
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("STRAINSITE_BIN", str(ROOT / "target/release/strainsite"))
PATIENCE_S = 30


class Attacks:
    """A folder of its own, removed at the end, and whether everything was survived."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="strainsite-attack."))
        self.broke = 0
        self.services = []

    def run(self, *arguments, **more):
        environment = {key: value for key, value in os.environ.items() if not key.startswith("STRAINSITE_")}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, capture_output=True, text=True,
                              timeout=PATIENCE_S, **more)

    def serve(self, database):
        service = Service(self.folder, database)
        self.services.append(service)
        return service

    def survived(self, what, held, seen=""):
        self.broke += not held
        print(f"{'survived' if held else 'BROKE'}: {what}" + ("" if held else f"; seen: {seen}"))

    def end(self):
        for service in self.services:
            service.end("kill")
        shutil.rmtree(self.folder, ignore_errors=True)
        sys.exit(1 if self.broke else 0)


class Service:
    """The program as a service, at a port of its own choice."""

    def __init__(self, folder, database):
        environment = {key: value for key, value in os.environ.items() if not key.startswith("STRAINSITE_")}
        command = [PROGRAM, "serve", "--addr", "127.0.0.1:0", "--db", str(database)]
        # Into a file: nobody has to read it meanwhile.
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=self.log, text=True)
        told = re.match("listening on (.*)", self.process.stdout.readline())
        self.url = told and told[1]

    def ask(self, path, document=None):
        """Status and document of an answer."""
        body = None if document is None else json.dumps(document).encode()
        request = urllib.request.Request(self.url + path, body, {"Content-Type": "application/json"} if body else {})
        try:
            with urllib.request.urlopen(request, timeout=PATIENCE_S) as answer:
                return answer.status, json.load(answer)
        except urllib.error.HTTPError as error:
            with error:
                return error.code, json.load(error)

    def wait(self, study, state="done"):
        begun = time.monotonic()
        while time.monotonic() - begun < PATIENCE_S:
            if self.ask(f"/v1/studies/{study}")[1]["state"] == state:
                return
            time.sleep(0.02)
        raise TimeoutError(f"the study isn't {state}")

    def end(self, how="terminate"):
        """Exit code and log."""
        if self.process.poll() is None:
            getattr(self.process, how)()
        code = self.process.wait(PATIENCE_S)
        self.process.stdout.close()
        self.log.seek(0)
        return code, self.log.read()


def study(points=5):
    """A study of a few quick solves."""
    return {
        "name": "attacked",
        "scene": {"preset": "foot-tire"},
        "inputs": [{"name": "P3", "vary": "ground.depths_mm[2]", "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}}],
        "candidates": {"points": "P1-P5"},
        "method": {"kind": "mdrm", "nodes": 5, "check_points": points},
        "accuracy": {"preset": "draft"},
    }


def studies(database):
    """How many studies a database has."""
    connection = sqlite3.connect(database)
    try:
        return connection.execute("select count(*) from studies").fetchone()[0]
    finally:
        connection.close()
