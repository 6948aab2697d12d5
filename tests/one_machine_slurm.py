"""A SLURM controller with two nodes on this machine, on the loopback interface, for root."""

import os
import socket
import subprocess
import time
from contextlib import contextmanager
from pathlib import Path
from shutil import which

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation={base}/state
SlurmdSpoolDir={base}/spool.%n
SlurmctldPidFile={base}/slurmctld.pid
SlurmdPidFile={base}/slurmd.%n.pid
SlurmctldLogFile={base}/slurmctld.log
SlurmdLogFile={base}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=2
{nodes}
PartitionName=debug Nodes=n[1-2] Default=YES MaxTime=INFINITE State=UP
"""


def is_possible() -> bool:
    """Whether the daemons are installed and may be started."""
    return os.geteuid() == 0 and all(which(name) for name in ("slurmctld", "slurmd", "munged"))


def _until(command, output: str, wait: float = 20.0) -> None:
    """Run a command until it prints something."""
    by = time.monotonic() + wait
    while subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip() != output:
        assert time.monotonic() < by, f"{command} does not print {output!r}"
        time.sleep(0.1)


def _munge() -> bool:
    """Start the daemon that authenticates; whether it had to be."""
    if subprocess.run(["munge", "-n"], capture_output=True, check=False).returncode == 0:
        return False
    key = Path("/etc/munge/munge.key")
    if not key.exists():
        key.write_bytes(os.urandom(128))
        subprocess.run(["chown", "munge:munge", str(key)], check=True)
        key.chmod(0o400)
    subprocess.run(["install", "-d", "-m", "0755", "-o", "munge", "-g", "munge", "/run/munge"], check=True)
    subprocess.run(
        ["setpriv", "--reuid", "munge", "--regid", "munge", "--clear-groups", "munged"], check=True
    )
    return True


@contextmanager
def running(base: Path):
    """Two nodes of one core while this lasts; SLURM_CONF names them."""
    host = socket.gethostname().partition(".")[0]
    nodes = "\n".join(
        f"NodeName=n{n} NodeHostname={host} NodeAddr=127.0.0.1 Port={17000 + n} CPUs=1 RealMemory=4000"
        for n in (1, 2)
    )
    for folder in ("state", "spool.n1", "spool.n2"):
        (base / folder).mkdir()
    configuration = base / "slurm.conf"
    configuration.write_text(CONFIGURATION.format(host=host, base=base, nodes=nodes))
    before, munge = os.environ.get("SLURM_CONF"), _munge()
    os.environ["SLURM_CONF"] = str(configuration)
    try:
        subprocess.run(["slurmctld"], check=True)
        for n in (1, 2):
            subprocess.run(["slurmd", "-N", f"n{n}"], check=True)
        _until(["sinfo", "-h", "-t", "idle", "-o", "%D"], "2")
        yield
    finally:
        subprocess.run(["scancel", "-u", "root"], check=False)
        for pid in base.glob("*.pid"):
            os.kill(int(pid.read_text()), 15)
        if munge:
            os.kill(int(Path("/run/munge/munged.pid").read_text()), 15)
        os.environ.pop("SLURM_CONF")
        if before is not None:
            os.environ["SLURM_CONF"] = before
