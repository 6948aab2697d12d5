"""Calls on the workers of a Dask scheduler."""

import logging
from collections.abc import Callable, Iterator
from ipaddress import ip_address
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from flexbearing.case.excerpt import excerpt
from flexbearing.program.processes import Done
from flexbearing.studies.engine.certificates import Certificates

if TYPE_CHECKING:
    from distributed import Client, Future

log = logging.getLogger(__name__)
PATIENCE = 30.0  # [s] for a scheduler to answer


class NoConnection(RuntimeError):
    """No scheduler answers this program there."""


class OnDask:
    """The engine of a scheduler that somebody else runs, or of `OnSlurm`."""

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
            future = self._ended.get()
            yield self._done(self._running.pop(future.key), future)

    def _done(self, argument: Any, future: "Future") -> Done:
        from distributed.scheduler import KilledWorker

        try:
            return Done(argument, future.result())
        except KilledWorker:
            return Done(argument, died=True)
        except Exception as problem:  # of one task, which must not end the others
            return Done(argument, raised=problem)
        finally:
            future.release()

    def close(self) -> None:
        """Let go of calls that did not end."""
        self._client.close()


def connected(address: str, certificates: Certificates | None = None) -> OnDask:
    """Engine of a running Dask scheduler; without encryption a warning says what that means.

    Parameters
    ----------
    address : str
        such as tls://node7:8786
    certificates : Certificates, optional
        instead of those of Dask's configuration

    Returns
    -------
    OnDask

    Raises
    ------
    NoConnection
        where there is no such address, nobody answers, or not without TLS or other certificates
    """
    encrypted = _require_address(address)
    if certificates and not encrypted:
        raise NoConnection("certificates are given; the address must begin with tls://")
    from distributed import Client

    security = certificates.security() if certificates else None
    try:
        client = Client(address, timeout=PATIENCE, set_as_default=False, security=security)
    except TypeError as problem:  # what Dask raises without certificates
        needed = "--tls-ca, --tls-cert and --tls-key, or the certificates of Dask's configuration"
        raise NoConnection(f"it needs {needed}: {problem}") from problem
    except (OSError, ValueError, RuntimeError) as problem:
        raise NoConnection(f"no scheduler answers there: {problem}") from problem
    threads = sum(worker["nthreads"] for worker in client.scheduler_info(n_workers=-1)["workers"].values())
    return OnDask(client, max(1, threads))


def _require_address(address: str) -> bool:
    """Whether an address is one of TLS; one of a network without it is warned of."""
    try:
        parts = urlsplit(address)
        if parts.scheme not in ("tcp", "tls") or not parts.hostname or parts.port is None:
            raise ValueError
    except ValueError:  # also of a port that is no number
        raise NoConnection("it must be tls://HOST:PORT or tcp://HOST:PORT") from None
    if parts.scheme == "tcp" and not _is_loopback(parts.hostname):
        log.warning(
            "--scheduler %s: without TLS whoever reaches its port may have code run as you; use tls://",
            excerpt(address),
        )
    return parts.scheme == "tls"


def _is_loopback(host: str) -> bool:
    try:
        return ip_address(host).is_loopback
    except ValueError:  # a name
        return host == "localhost"
