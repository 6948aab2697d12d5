"""Calls on the workers of a Dask scheduler."""

from collections.abc import Callable, Iterator
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any

from flexbearing.program.processes import Done

if TYPE_CHECKING:
    from distributed import Client, Future

PAUSE = 0.2  # [s] between looks at the workers
FETCHING = 5.0  # [s] for an answer to arrive until the workers are looked at


class OnDask:
    """The engine of a scheduler that somebody else runs, or of `Local`."""

    def __init__(self, client: "Client", workers: int):
        self.workers = workers
        self._client = client
        self._running: dict[Any, Any] = {}  # arguments by the keys of their futures
        self._ended: SimpleQueue[Future] = SimpleQueue()

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Have a function called by whichever worker is free."""
        future = self._client.submit(function, argument, pure=False)
        self._running[future.key] = argument
        future.add_done_callback(self._ended.put)

    def as_completed(self) -> Iterator[Done]:
        """Yield calls as they end, on whichever worker."""
        while self._running:
            try:
                future = self._ended.get(timeout=PAUSE)
            except Empty:
                self._look_after_workers()
                continue
            yield self._done(self._running.pop(future.key), future)

    def _done(self, argument: Any, future: "Future") -> Done:
        from distributed.scheduler import KilledWorker

        try:
            return Done(argument, self._fetched(future))
        except KilledWorker:
            return Done(argument, died=True)
        except Exception as problem:  # of one task, which must not end the others
            return Done(argument, raised=problem)
        finally:
            future.release()

    def _fetched(self, future: "Future") -> Any:
        """The answer; one that died with its worker is computed again, which may need another worker."""
        while True:
            try:
                return future.result(FETCHING)
            except TimeoutError:
                if future.status == "error":  # of the function itself
                    raise
                self._look_after_workers()

    def _look_after_workers(self) -> None:
        """Whoever runs the scheduler runs its workers, too."""

    def close(self) -> None:
        """Let go of calls that did not end."""
        self._client.close()


def connected(address: str) -> OnDask:
    """Engine of a running Dask scheduler.

    Parameters
    ----------
    address : str
        such as tcp://node7:8786

    Returns
    -------
    OnDask

    Raises
    ------
    OSError
        where nobody answers
    """
    from distributed import Client

    client = Client(address, timeout=30, set_as_default=False)
    threads = sum(worker["nthreads"] for worker in client.scheduler_info(n_workers=-1)["workers"].values())
    return OnDask(client, max(1, threads))
