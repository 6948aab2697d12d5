"""Calls on the workers of a Dask scheduler."""

import logging
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError
from ipaddress import ip_address
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from flexbearing.printable import excerpt
from flexbearing.program.worker_processes import Done
from flexbearing.studies.engine.attempts import EngineLost
from flexbearing.studies.engine.certificates import Certificates

if TYPE_CHECKING:
    from distributed import Client, Future
    from distributed.security import Security

log = logging.getLogger(__name__)
PATIENCE = 30.0  # [s] for a scheduler to answer
LONGEST = 300  # characters of what it answers instead


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
        """Have a function called by whichever worker is free.

        Raises `EngineLost` when the scheduler is gone.
        """
        try:
            future = self._client.submit(function, argument, pure=False)
        except Exception as problem:
            raise _lost_or(problem) from problem
        self._running[future.key] = argument
        future.add_done_callback(self._ended.put)

    def as_completed(self) -> Iterator[Done]:
        """Yield calls as they end, on whichever worker; raises `EngineLost` when the scheduler is gone."""
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
            if future.status == "error" and not _is_of_dask(problem):
                return Done(argument, raised=problem)
            raise _lost_or(problem) from problem
        finally:
            future.release()

    def close(self) -> None:
        """Let go of calls that did not end."""
        self._client.close()


def _is_of_dask(problem: Exception) -> bool:
    """Whether an exception is of the scheduler or its connections, and not of what is computed."""
    return type(problem).__module__.partition(".")[0] == "distributed"


def _lost_or(problem: Exception) -> Exception:
    """What is raised in place of an exception of Dask; others are faults of this program."""
    if _is_of_dask(problem) or isinstance(problem, OSError | CancelledError):
        return EngineLost(f"the scheduler is gone ({type(problem).__name__})")
    return problem


def connected(address: str, certificates: Certificates | None = None) -> OnDask:
    """Engine of a running Dask scheduler; without encryption a warning says what that means.

    Raises `NoConnection` where there is no such address, nobody answers, or not without TLS or other
    certificates.
    """
    encrypted = _require_address(address)
    import asyncio
    from concurrent.futures import ThreadPoolExecutor

    from distributed import Client
    from distributed.security import Security

    security = certificates.security() if certificates else Security()
    role = security.get_tls_config_for_role("client")
    if encrypted and not (role["ca_file"] and role["cert"]):
        raise NoConnection(
            "it needs --tls-ca, --tls-cert and --tls-key, or the certificates of Dask's configuration"
        )
    if security.require_encryption and not encrypted:
        raise NoConnection("certificates are given, or required; the address must begin with tls://")
    with ThreadPoolExecutor(1) as another:  # a notebook has a loop in this thread
        threads = another.submit(asyncio.run, _threads(address, security)).result()
    for name in ("distributed", "distributed.client"):  # a lost scheduler is reported in a sentence
        logging.getLogger(name).setLevel(logging.CRITICAL)
    client = Client(address, timeout=PATIENCE, set_as_default=False, security=security)
    return OnDask(client, max(1, threads))


async def _threads(address: str, security: "Security") -> int:
    """How many calls a scheduler can have made at once; a client would not end if something else answers."""
    from asyncio import wait_for

    from distributed.comm.core import connect
    from distributed.core import send_recv

    try:
        options = security.get_connection_args("client")
        answering = await connect(address, timeout=PATIENCE, **options)
        identity: Any = await wait_for(send_recv(answering, op="identity", n_workers=-1), PATIENCE)
        await answering.close()
        return sum(worker["nthreads"] for worker in identity["workers"].values())
    except Exception as problem:  # of any kind, also one that takes all memory
        words = excerpt(f"{type(problem).__name__}: {problem}", LONGEST)
        raise NoConnection(f"no scheduler answers there: {words}") from problem


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
