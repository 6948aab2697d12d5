"""Worker processes on this machine, under a Dask scheduler in this process, with which they end."""

import logging
import os
import sys
from tempfile import TemporaryFile
from typing import IO, Any

from flexbearing.program.interpreter import Interpreter
from flexbearing.studies.engine.engine import NoWorkers
from flexbearing.studies.engine.on_dask import OnDask

STARTS = 5  # of workers that end before any task does, until the study is given up
LAST_WORDS = 400  # bytes of their error output that are quoted
_CONFIGURATION = {
    "distributed.scheduler.allowed-failures": 0,  # a study counts deaths itself
    "distributed.scheduler.http.routes": [],
}
_OF_WORKERS = {
    "DASK_LOGGING__DISTRIBUTED": "error",
    # Nobody looks at what it samples a hundred times a second, beside the work.
    "DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False",
}
_log = logging.getLogger("distributed")


class Local(OnDask):
    """The engine of several jobs on one machine."""

    def __init__(self, jobs: int):
        from dask import config
        from distributed import Client, LocalCluster

        self._level = _log.level
        _log.setLevel(logging.CRITICAL)  # what becomes of workers is told by the study
        with config.set(_CONFIGURATION):
            self._cluster = LocalCluster(
                n_workers=0,
                processes=True,
                protocol="tcp://",
                host="127.0.0.1",
                dashboard_address="127.0.0.1:0",  # any port: two studies at a time have two
                silence_logs=False,
            )
        super().__init__(Client(self._cluster, set_as_default=False), jobs)
        self._failed_starts = 0
        self._processes: list[tuple[Interpreter, IO[bytes]]] = []
        try:
            for _ in range(jobs):
                self._start()
        except BaseException:
            self.close()
            raise

    def _start(self) -> None:
        errors = TemporaryFile()  # noqa: SIM115  # closed with its process
        process = Interpreter(self.workers, errors)
        process.send(_work_for, self._cluster.scheduler_address)
        self._processes.append((process, errors))

    def as_completed(self) -> Any:
        """Yield calls as they end; a worker that died is replaced."""
        for done in super().as_completed():
            if not done.died:
                self._failed_starts = 0
            self._look_after_workers()
            yield done

    def _look_after_workers(self) -> None:
        ended = [(process, errors) for process, errors in self._processes if process.code is not None]
        for process, errors in ended:
            self._processes.remove((process, errors))
            process.end()
            words = _last_words(errors)
            self._failed_starts += 1
            if self._failed_starts > STARTS * self.workers:
                raise NoWorkers(f"worker processes end with {process.code}: {words}")
            self._start()

    def close(self) -> None:
        """End workers, scheduler and whatever they compute."""
        for process, errors in self._processes:
            process.end()
            errors.close()
        self._processes.clear()
        super().close()
        self._cluster.close()
        _log.setLevel(self._level)


def _last_words(errors: IO[bytes]) -> str:
    with errors:
        errors.seek(0)
        words = errors.read().decode(errors="replace")[-LAST_WORDS:]
    return "; ".join(line.strip() for line in words.splitlines() if line.strip()) or "without a word"


def _work_for(scheduler: str) -> None:
    """What a worker process does; its end is that of the process."""
    os.environ |= _OF_WORKERS
    try:
        from distributed.cli.dask_worker import main

        main([scheduler, "--no-nanny", "--nthreads", "1", "--no-dashboard", "--death-timeout", "30"])
    except Exception as problem:
        sys.exit(f"{type(problem).__name__}: {problem}")
