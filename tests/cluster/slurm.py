"""A Slurm of this user's own on the loopback address: nothing in /etc, no service of the system, nothing left."""

import contextlib
import dataclasses
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

# A job of a node that was lost begins again when its credential has expired: after two minutes where nothing is said.
CONFIGURATION = """\
ClusterName=test
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=10
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


def call(program: list[str | pathlib.Path]) -> None:
    """Calls a program that goes to the background itself."""
    subprocess.run(program, env={**os.environ, "PATH": PATHS}, check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def is_alive(process: int, folder: pathlib.Path) -> bool:
    """Whether a program of this folder's runs under a number; one that ended, and that nobody waited for, has no command line any more."""
    try:
        return str(folder).encode() in pathlib.Path(f"/proc/{process}/cmdline").read_bytes()
    except OSError:
        return False


@dataclasses.dataclass
class Cluster:
    """A cluster of three nodes."""

    folder: pathlib.Path
    conf: pathlib.Path
    # Nodes that are in a world of processes of their own, each with the program that holds it.
    apart: dict[str, subprocess.Popen[bytes]] = dataclasses.field(default_factory=dict)

    @property
    def environment(self) -> dict[str, str]:
        """The environment in which Slurm's commands find it."""
        return {**os.environ, "SLURM_CONF": str(self.conf)}

    def said(self, *command: str) -> str | None:
        """What one of Slurm's commands says; none when it fails."""
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, timeout=PATIENCE)
        return done.stdout if done.returncode == 0 else None

    def start(self) -> None:
        """Starts all of it."""
        own = {"key-file": "munge.key", "socket": "munge.socket", "pid-file": "munged.pid", "log-file": "munged.log", "seed-file": "munge.seed"}
        call(["munged", "--force", *(f"--{option}={self.folder / name}" for option, name in own.items())])
        self.start_controller()
        for node in NODES:
            call(["slurmd", "-N", node, "-f", self.conf])
        self.wait_for_nodes()

    def start_controller(self) -> None:
        """Starts what gives out the jobs."""
        call(["slurmctld", "-f", self.conf])

    def kill_controller(self) -> None:
        """Ends it without a chance to write anything."""
        os.kill(int((self.folder / "slurmctld.pid").read_text()), signal.SIGKILL)

    def start_apart(self, node: str) -> None:
        """Starts a node anew so that all its processes end with it, as on a machine that loses its power; takes the rights of root."""
        self.stop_by(self.folder / f"slurmd.{node}.pid")
        command = ["unshare", "-pf", "--kill-child", "--mount-proc", "slurmd", "-D", "-N", node, "-f", self.conf]
        self.apart[node] = subprocess.Popen(command, env={**os.environ, "PATH": PATHS}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def kill_apart(self, node: str) -> None:
        """Takes the power off such a node."""
        process = self.apart.pop(node)
        process.kill()
        process.wait()

    def wait_for_nodes(self) -> None:
        """Returns when all nodes are idle."""
        begun = time.monotonic()
        while True:
            said = self.said("sinfo", "-h", "-N", "-o", "%t") or ""
            if said.split() == ["idle"] * len(NODES):
                return
            if time.monotonic() - begun > PATIENCE:
                raise TimeoutError(f"nodes aren't idle: {said}")
            time.sleep(0.2)

    def stop_by(self, file: pathlib.Path) -> None:
        """Ends the program that wrote its number into a file."""
        with contextlib.suppress(OSError, ValueError):
            process, begun = int(file.read_text()), time.monotonic()
            while is_alive(process, self.folder):
                os.kill(process, signal.SIGTERM if time.monotonic() - begun < PATIENCE else signal.SIGKILL)
                time.sleep(0.05)

    def stop(self) -> None:
        """Ends what was started, nodes first."""
        for node in list(self.apart):
            self.kill_apart(node)
        for file in [*self.folder.glob("slurmd.*.pid"), self.folder / "slurmctld.pid", self.folder / "munged.pid"]:
            self.stop_by(file)


@contextlib.contextmanager
def cluster() -> Iterator[Cluster]:
    """Gives a cluster of three idle nodes, of which nothing is left afterwards."""
    if shutil.which("slurmctld", path=PATHS) is None:
        sys.exit("there is no Slurm: on Debian it is apt-get install slurm-wlm munge")
    # A socket's path may have 107 bytes.
    with tempfile.TemporaryDirectory(prefix="slurm-", dir="/tmp") as name:
        folder = pathlib.Path(name)
        own = Cluster(folder, configure(folder))
        try:
            own.start()
            yield own
        except BaseException:
            for log in sorted(folder.glob("*.log")):
                print(f"== {log.name}", *log.read_text(errors="replace").splitlines()[-5:], sep="\n")
            raise
        finally:
            own.stop()
