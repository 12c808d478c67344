"""The progress bar: on terminals, and nowhere else."""

from __future__ import annotations

import fcntl
import os
import pty
import re
import struct
import subprocess
import sys
import termios
import threading
from typing import TYPE_CHECKING

from conftest import STUDY

if TYPE_CHECKING:
    from strainsite import Client

CODE = """
import sys, strainsite
with strainsite.Client(sys.argv[1]) as client:
    changes = {"accuracy.preset": "draft", "name": "watched", "layouts.spacings_deg": [60]}
    client.submit(sys.argv[2], set=changes).wait(progress=sys.argv[3] == "yes")
"""


def on_a_terminal(*arguments: str) -> str:
    """What a script writes to a terminal of 80 columns."""
    leader, follower = pty.openpty()
    fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    said: list[bytes] = []

    def read() -> None:
        while True:
            try:
                part = os.read(leader, 4096)
            except OSError:  # Linux's way to say that nobody writes any more.
                return
            if not part:
                return
            said.append(part)

    reader = threading.Thread(target=read)
    reader.start()
    try:
        command = [sys.executable, "-c", CODE, *arguments]
        subprocess.run(command, stdout=follower, stderr=follower, timeout=60, check=True)
    finally:
        os.close(follower)
        reader.join()
        os.close(leader)
    return b"".join(said).decode()


def test_a_terminal_shows_points_done_and_time_left(client: Client) -> None:
    said = on_a_terminal(client.url, str(STUDY), "yes")
    # 26 of the plan, then those of the layouts.
    counts = [int(done) for done in re.findall(r"watched: .*?(\d+)/\d+ ", said)]
    assert counts == sorted(counts)
    assert counts[-1] > 26
    assert re.search(rf"{counts[-1]}/{counts[-1]} \[\d\d:\d\d<\d\d:\d\d", said)
    assert "watched" not in on_a_terminal(client.url, str(STUDY), "no")


def test_a_pipe_is_not_filled_with_it(client: Client) -> None:
    command = [sys.executable, "-c", CODE, client.url, str(STUDY), "yes"]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    assert ran.stderr == ran.stdout == ""
