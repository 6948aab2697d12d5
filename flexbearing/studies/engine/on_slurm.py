"""Workers in jobs of a SLURM queue, under a Dask scheduler in this process."""

import logging
import subprocess
from pathlib import Path
from shutil import which
from tempfile import NamedTemporaryFile
from typing import TYPE_CHECKING, Any

from flexbearing.program.threads import ONE_THREAD, VARIABLES
from flexbearing.studies.engine.on_dask import OnDask

if TYPE_CHECKING:
    from dask_jobqueue.slurm import SLURMCluster

    from flexbearing.studies.file.slurm_profile import SlurmProfile

CALLS_AT_ONCE = "0.1s"  # of calls behind each other before another job is worth it: queues are slow
LOOK = "1s"  # between looks at the jobs: one that was cancelled, or failed, is replaced
_CONFIGURATION = {
    "distributed.scheduler.allowed-failures": 0,  # a study counts deaths itself
    "distributed.logging.distributed": "critical",
    "distributed.scheduler.dashboard.status.task-stream-length": 0,
}


class NoQueue(RuntimeError):
    """SLURM is not there, or refuses such jobs."""


class OnSlurm(OnDask):
    """The engine of a SLURM cluster: jobs come as long as calls wait, and go when none does."""

    def __init__(self, profile: "SlurmProfile", tasks: int):
        from dask import config
        from dask_jobqueue.slurm import SLURMCluster
        from distributed import Client

        if which("sbatch") is None:
            raise NoQueue("there is no sbatch here; start the study on a login node")
        with config.set(_CONFIGURATION):
            self._cluster = SLURMCluster(**_options(profile))
        try:
            _require_accepted(self._cluster)
            jobs = min(profile.jobs, -(-tasks // profile.cores))
            self._cluster.adapt(
                minimum_jobs=0,
                maximum_jobs=jobs,
                interval=LOOK,
                target_duration=CALLS_AT_ONCE,
            )
            super().__init__(Client(self._cluster, set_as_default=False), jobs * profile.cores)
        except BaseException:
            self._cluster.close()
            raise

    def close(self) -> None:
        """Let go of calls that did not end, and cancel the jobs."""
        super().close()
        self._cluster.close()


def _options(profile: "SlurmProfile") -> dict[str, Any]:
    """Arguments of the cluster: a worker of one thread for each core."""
    threads = {**ONE_THREAD, VARIABLES[1]: "1"}
    exports = [f"unset {VARIABLES[0]}", *(f"export {name}={value}" for name, value in threads.items())]
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
        "scheduler_options": {"dashboard_address": None},
        "silence_logs": logging.CRITICAL,
    }


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
