"""A Slurm of this user's own on the loopback address: nothing in /etc, no service of the system, nothing left."""

import contextlib
import os
import pathlib
import pwd
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator

NODES = ["v1", "v2", "v3"]
# Until all nodes are idle, and until a program has ended, seconds.
PATIENCE = 60.0

CONFIGURATION = """\
ClusterName=test
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SlurmdTimeout=10
ReturnToService=2
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
{nodes}
PartitionName=all Nodes={names} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count: int) -> list[int]:
    """Ports that nobody listens on, all different."""
    with contextlib.ExitStack() as held:
        sockets = [held.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


def configure(folder: pathlib.Path) -> pathlib.Path:
    """Writes the key that all trust, and what the cluster is; nodes of one core each."""
    key = folder / "munge.key"
    key.write_bytes(secrets.token_bytes(128))
    key.chmod(0o400)
    for part in ["state", *(f"spool.{node}" for node in NODES)]:
        (folder / part).mkdir()
    ports = free_ports(1 + len(NODES))
    nodes = [
        f"NodeName={node} NodeHostname=localhost NodeAddr=127.0.0.1 Port={port} CPUs=1"
        for node, port in zip(NODES, ports[1:], strict=True)
    ]
    text = CONFIGURATION.format(
        folder=folder,
        user=pwd.getpwuid(os.getuid()).pw_name,
        ports=ports,
        nodes="\n".join(nodes),
        names=",".join(NODES),
    )
    path = folder / "slurm.conf"
    path.write_text(text)
    return path


# Debian has daemons where users' paths don't lead.
PATHS = f"{os.environ['PATH']}:/usr/sbin:/usr/local/sbin"


def start(folder: pathlib.Path, conf: pathlib.Path) -> None:
    """Starts all of it; each program goes to the background itself."""
    own = {"key-file": "munge.key", "socket": "munge.socket", "pid-file": "munged.pid", "log-file": "munged.log", "seed-file": "munge.seed"}
    munged = ["munged", "--force", *(f"--{option}={folder / name}" for option, name in own.items())]
    programs = [munged, ["slurmctld", "-f", conf], *(["slurmd", "-N", node, "-f", conf] for node in NODES)]
    for program in programs:
        subprocess.run(program, env={**os.environ, "PATH": PATHS}, check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def wait_for_nodes(environment: dict[str, str]) -> None:
    """Returns when all nodes are idle."""
    begun = time.monotonic()
    while True:
        said = subprocess.run(["sinfo", "-h", "-N", "-o", "%t"], env=environment, capture_output=True, text=True, check=False)
        if said.stdout.split() == ["idle"] * len(NODES):
            return
        if time.monotonic() - begun > PATIENCE:
            raise TimeoutError(f"nodes aren't idle: {said.stdout} {said.stderr}")
        time.sleep(0.2)


def is_alive(process: int) -> bool:
    """Whether a process runs; one that ended and that nobody waited for doesn't."""
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def stop(folder: pathlib.Path) -> None:
    """Ends what was started, nodes first, each by the number that it wrote."""
    files = [*folder.glob("slurmd.*.pid"), folder / "slurmctld.pid", folder / "munged.pid"]
    for file in files:
        with contextlib.suppress(OSError, ValueError):
            process = int(file.read_text())
            os.kill(process, signal.SIGTERM)
            begun = time.monotonic()
            while is_alive(process):
                if time.monotonic() - begun > PATIENCE:
                    os.kill(process, signal.SIGKILL)
                time.sleep(0.05)


@contextlib.contextmanager
def cluster() -> Iterator[dict[str, str]]:
    """Gives the environment in which Slurm's commands find a cluster of three nodes."""
    if shutil.which("slurmctld", path=PATHS) is None:
        sys.exit("there is no Slurm: on Debian it is apt-get install slurm-wlm munge")
    # A socket's path may have 107 bytes.
    with tempfile.TemporaryDirectory(prefix="slurm-", dir="/tmp") as name:
        folder = pathlib.Path(name)
        conf = configure(folder)
        environment = {**os.environ, "SLURM_CONF": str(conf)}
        try:
            start(folder, conf)
            wait_for_nodes(environment)
            yield environment
        except Exception:
            for log in sorted(folder.glob("*.log")):
                print(f"== {log.name}", *log.read_text(errors="replace").splitlines()[-5:], sep="\n")
            raise
        finally:
            stop(folder)
