"""A small Slurm on this machine: munged, slurmctld and slurmd of its own in a temporary folder, on free ports.

Everything runs as the user who runs the test; nothing that the machine's own Slurm has is read or written.
"""

import os
import secrets
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "srun", "sbatch", "squeue", "scancel", "sinfo")
FOLDERS = "/usr/sbin:/usr/bin"  # daemons of Debian are not on every user's path
READY = 60.0  # s

CONF = """
ClusterName=tremolo_test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmctldPort={controller}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1
ReturnToService=2
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def missing():
    """Programs that are not installed."""
    return [name for name in PROGRAMS if shutil.which(name, path=f"{os.environ['PATH']}:{FOLDERS}") is None]


def _free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class SmallSlurm:
    """Starts the daemons; `environment` is that of commands which use them. Ends them on leaving. `nodes` of them are this machine:
    the first has its name."""

    def __init__(self, nodes=1):
        host = socket.gethostname().split(".")[0]
        self.nodes = [host, *(f"{host}-{number}" for number in range(2, nodes + 1))]
        self._place = tempfile.TemporaryDirectory(prefix="tremolo_slurm_")
        self.folder = Path(self._place.name)
        self.environment = {**os.environ, "PATH": f"{os.environ['PATH']}:{FOLDERS}", "SLURM_CONF": str(self.folder / "slurm.conf")}
        self._daemons = []

    def __enter__(self):
        try:
            self._start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def _start(self):
        self.folder.chmod(0o755)  # munged wants a socket that all can reach
        (self.folder / "state").mkdir(mode=0o755)
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(1024))
        key.chmod(0o600)
        controller, *daemons = _free_ports(1 + len(self.nodes))
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (self.folder / "slurm.conf").write_text(CONF.format(
            host=self.nodes[0], user=user, folder=self.folder, controller=controller,
            nodes="\n".join(f"NodeName={node} NodeHostname={self.nodes[0]} NodeAddr=127.0.0.1 Port={port} "
                            f"CPUs={len(os.sched_getaffinity(0))} State=UNKNOWN" for node, port in zip(self.nodes, daemons))))
        self._launch("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                     f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log",
                     f"--seed-file={self.folder}/munged.seed", "--num-threads=1")
        self._wait("munged", lambda: (self.folder / "munge.socket").exists())
        self._launch("slurmctld", "-D", "-c")
        for node in self.nodes:
            self._launch("slurmd", "-D", "-N", node)
        self._wait("its nodes", lambda: f"{len(self.nodes)} idle" in self.command("sinfo", "--noheader", "--format=%D %t").stdout)

    def _launch(self, name, *options):
        log = open(self.folder / f"{name}.out", "w")
        self._daemons.append(subprocess.Popen([shutil.which(name, path=self.environment["PATH"]), *options], stdout=log,
                                              stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, env=self.environment))
        log.close()

    def _wait(self, what, there):
        end = time.monotonic() + READY
        while not there():
            if time.monotonic() > end or any(daemon.poll() is not None for daemon in self._daemons):
                logs = "\n".join(f"--- {path.name}\n{path.read_text(errors='replace')[-2000:]}" for path in self.folder.glob("*.[lo][ou][gt]"))
                raise AssertionError(f"Slurm has not brought up {what}\n{logs}")
            time.sleep(0.1)

    def command(self, *words):
        return subprocess.run(words, capture_output=True, text=True, env=self.environment, timeout=60)

    def __exit__(self, *_):
        for daemon in reversed(self._daemons):
            daemon.terminate()
        for daemon in self._daemons:
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self._place.cleanup()
