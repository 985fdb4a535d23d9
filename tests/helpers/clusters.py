"""Clusters of one machine, started for a test: Slurm with munge, each in a folder of its own."""

from __future__ import annotations

import getpass
import os
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from tests.limits import HANG

_SBIN = "/usr/sbin"


def require_slurm() -> None:
    """Skips the test where Slurm or munge is missing."""
    path = f"{os.environ.get('PATH', '')}:{_SBIN}"
    missing = [
        name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not shutil.which(name, path=path)
    ]
    if missing:
        pytest.skip(f"{missing[0]} is missing: Debian has it in slurm-wlm and munge")
    if os.geteuid():
        pytest.skip("slurmd of a test needs to be root")


@contextmanager
def one_node_slurm(folder: Path) -> Iterator[dict[str, str]]:
    """A Slurm of this machine alone; gives the variables with which its commands find it."""
    for name in ("state", "spool"):
        (folder / name).mkdir(parents=True)
    key, conf, munge_socket = folder / "munge.key", folder / "slurm.conf", folder / "munge.sock"
    key.write_bytes(os.urandom(1024))
    key.chmod(0o400)
    conf.write_text(_configuration(folder, munge_socket))
    files = {"key-file": key, "socket": munge_socket}
    files |= {f"{name}-file": folder / f"munged.{name}" for name in ("pid", "log", "seed")}
    munged = ["munged", "--force", "--foreground", *(f"--{name}={path}" for name, path in files.items())]
    daemons = [
        _started(munged, folder),
        _started(["slurmctld", "-D", "-f", str(conf)], folder),
        _started(["slurmd", "-D", "-f", str(conf)], folder),
    ]
    variables = {"SLURM_CONF": str(conf)}
    try:
        end = time.monotonic() + HANG
        while "idle" not in _said(["sinfo", "-h", "-o", "%T"], variables):
            assert time.monotonic() < end, (folder / "daemons.log").read_text()[-2000:]
            time.sleep(0.5)
        yield variables
    finally:
        _said(["scancel", "--full", f"--user={getpass.getuser()}"], variables)
        for daemon in reversed(daemons):
            daemon.terminate()
        for daemon in daemons:
            with suppress(subprocess.TimeoutExpired):
                daemon.wait(10)
            daemon.kill()


def _started(command: list[str], folder: Path) -> subprocess.Popen[bytes]:
    with open(folder / "daemons.log", "ab") as log:
        return subprocess.Popen([f"{_SBIN}/{command[0]}", *command[1:]], stdout=log, stderr=log)


def _said(command: list[str], variables: dict[str, str]) -> str:
    return subprocess.run(command, env={**os.environ, **variables}, capture_output=True, text=True).stdout


def _free_ports(count: int) -> list[int]:
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def _configuration(folder: Path, munge_socket: Path) -> str:
    host, user = socket.gethostname().partition(".")[0], getpass.getuser()
    controller, node = _free_ports(2)
    settings = {
        "ClusterName": "one",
        "SlurmctldHost": f"{host}(127.0.0.1)",
        "AuthType": "auth/munge",
        "AuthInfo": f"socket={munge_socket}",
        "SlurmUser": user,
        "SlurmdUser": user,
        "StateSaveLocation": folder / "state",
        "SlurmdSpoolDir": folder / "spool",
        "SlurmctldPidFile": folder / "slurmctld.pid",
        "SlurmdPidFile": folder / "slurmd.pid",
        "SlurmctldPort": controller,
        "SlurmdPort": node,
        "ProctrackType": "proctrack/pgid",
        "TaskPlugin": "task/none",
        "SwitchType": "switch/none",
        "MpiDefault": "none",
        "JobAcctGatherType": "jobacct_gather/none",
        "AccountingStorageType": "accounting_storage/none",
        "SelectType": "select/cons_tres",
        "SelectTypeParameters": "CR_Core",
        "SchedulerParameters": "sched_interval=2",
        "ReturnToService": 2,
    }
    lines = [f"{name}={value}" for name, value in settings.items()]
    lines.append(f"NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN")
    lines.append(
        f"PartitionName=one Nodes={host} Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4"
    )
    return "\n".join(lines) + "\n"
