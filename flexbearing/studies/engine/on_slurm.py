"""Workers in jobs of a SLURM queue, under a Dask scheduler in this process."""

import logging
import subprocess
from contextlib import ExitStack
from pathlib import Path
from shutil import which
from tempfile import NamedTemporaryFile, TemporaryDirectory
from typing import TYPE_CHECKING, Any

from flexbearing.files import require_folder
from flexbearing.program.threads import ONE_THREAD, VARIABLES
from flexbearing.studies.engine.certificates import Certificates, of_one_study
from flexbearing.studies.engine.on_dask import OnDask

if TYPE_CHECKING:
    from dask_jobqueue.slurm import SLURMCluster
    from distributed.security import Security

    from flexbearing.studies.file.slurm_profile import SlurmProfile

CALLS_AT_ONCE = "0.1s"  # of calls behind each other before another job is worth it: queues are slow
LOOK = "1s"  # between looks at the jobs: one that was cancelled, or failed, is replaced
_CONFIGURATION = {
    "distributed.scheduler.allowed-failures": 0,  # a study counts deaths itself
    "distributed.logging.distributed": "critical",
    "distributed.scheduler.dashboard.status.task-stream-length": 0,
    "distributed.scheduler.http.routes": [],
}
_HTTP = "127.0.0.1:0"  # of servers without TLS, which cannot be left out; with no routes they answer nothing
_OF_WORKERS = {**ONE_THREAD, VARIABLES[1]: "1", "DASK_DISTRIBUTED__WORKER__HTTP__ROUTES": "[]"}


class NoQueue(RuntimeError):
    """SLURM is not there, or refuses such jobs."""


class OnSlurm(OnDask):
    """The engine of a SLURM cluster: jobs come as long as calls wait, and go when none does.

    Scheduler and workers talk by TLS, as all of the network can reach them.
    """

    def __init__(self, profile: "SlurmProfile", tasks: int, certificates: Certificates | None = None):
        from distributed import Client

        if which("sbatch") is None:
            raise NoQueue("there is no sbatch here; start the study on a login node")
        logs = require_folder(Path(profile.logs).resolve())
        with ExitStack() as opened:
            folder = opened.enter_context(TemporaryDirectory(prefix="tls-", dir=logs))  # all nodes see it
            security = _security(certificates, Path(folder))
            cluster = _started(profile, security)
            opened.callback(cluster.close)
            _require_accepted(cluster)
            jobs = min(profile.jobs, -(-tasks // profile.cores))
            cluster.adapt(
                minimum_jobs=0,
                maximum_jobs=jobs,
                interval=LOOK,
                target_duration=CALLS_AT_ONCE,
            )
            super().__init__(Client(cluster, set_as_default=False), jobs * profile.cores)
            self._opened = opened.pop_all()

    def close(self) -> None:
        """Let go of calls that did not end, and cancel the jobs."""
        super().close()
        self._opened.close()


def _started(profile: "SlurmProfile", security: "Security") -> "SLURMCluster":
    from dask import config
    from dask_jobqueue.slurm import SLURMCluster

    try:
        with config.set(_CONFIGURATION):
            return SLURMCluster(**_options(profile), security=security)
    except (OSError, ValueError, RuntimeError) as problem:  # such as a network interface that is not there
        raise NoQueue(f"no scheduler starts here: {problem}") from problem


def _options(profile: "SlurmProfile") -> dict[str, Any]:
    """Arguments of the cluster: a worker of one thread for each core."""
    exports = [f"unset {VARIABLES[0]}", *(f"export {name}={value}" for name, value in _OF_WORKERS.items())]
    return {
        "queue": profile.queue,
        "account": profile.account,
        "cores": profile.cores,
        "processes": profile.cores,
        "memory": profile.memory,
        "walltime": profile.walltime,
        "interface": profile.interface,
        "job_extra_directives": list(profile.directives),
        "job_script_prologue": [*profile.prologue, *exports],
        "log_directory": str(Path(profile.logs).resolve()),
        "worker_extra_args": ["--no-dashboard", "--dashboard-address", _HTTP],
        "scheduler_options": {"dashboard_address": _HTTP},
        "silence_logs": logging.CRITICAL,
    }


def _security(certificates: Certificates | None, folder: Path) -> "Security":
    """Certificates of the options, else of Dask's configuration, else some that are made in a folder."""
    from distributed.security import Security

    configured = Security()
    roles = [configured.get_tls_config_for_role(role) for role in ("client", "scheduler", "worker")]
    complete = all(role["ca_file"] and role["cert"] and role["key"] for role in roles)
    if complete and not certificates:
        return configured
    return (certificates or of_one_study(folder)).security()


def _require_accepted(cluster: "SLURMCluster") -> None:
    """Have SLURM look at a job without queueing it."""
    with NamedTemporaryFile("w", suffix=".sh") as script:
        script.write(cluster.job_script())
        script.flush()
        looked = subprocess.run(
            ["sbatch", "--test-only", script.name], capture_output=True, text=True, check=False
        )
    if looked.returncode:
        raise NoQueue("; ".join(line.strip() for line in looked.stderr.splitlines() if line.strip()))
