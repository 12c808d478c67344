"""A database to attack: a service on it, studies for it, and verdicts."""

import json
import re
import sqlite3
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

from support import program
from support.program import BIN as PROGRAM

PATIENCE_S = 30


class Attacks(program.Attacks):
    """Attacks on a database, with services that end with them."""

    def __init__(self):
        super().__init__()
        self._services = []

    def run(self, *arguments, **options):
        return super().run(*arguments, **{"timeout": PATIENCE_S, **options})

    def serve(self, database):
        service = Service(self, database)
        self._services.append(service)
        return service

    def end(self):
        for service in self._services:
            service.end("kill")
        super().end()


class Service:
    """The program as a service, at a port of its own choice."""

    def __init__(self, attacks, database):
        # Into a file: nobody has to read it meanwhile.
        self.log = tempfile.TemporaryFile("w+")
        arguments = ("serve", "--addr", "127.0.0.1:0", "--db", database)
        self.process = attacks.start(*arguments, stdout=subprocess.PIPE, stderr=self.log, text=True)
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
