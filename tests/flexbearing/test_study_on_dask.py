"""Studies on a Dask scheduler that somebody else runs: addresses, certificates, the same table."""

import json
import logging
import socket
import subprocess
import sys
from functools import partial
from pathlib import Path
from threading import Thread

import pytest

from flexbearing.case import BadCase
from flexbearing.studies.engine import EngineLost, on_dask
from flexbearing.studies.engine.certificates import certificates
from flexbearing.studies.engine.on_dask import NoConnection, connected
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.placement import Placement
from flexbearing.studies.run import Work, run
from tests.flexbearing.toy_studies import cubes, no_ring, toy
from tests.places import ROOT

pytestmark = pytest.mark.usefixtures("two_cores")

FORTY = '"operation.radial_load" = "2 kN .. 41 kN, 40"'


def computed(prepared, folder, engine, **options):
    work = Work(partial(cubes, texts=prepared.texts), no_ring)
    return run(prepared, folder, work, lambda tasks: engine, **options)


@pytest.fixture(scope="module")
def security():
    pytest.importorskip("cryptography")
    from distributed.security import Security

    return Security.temporary()


@pytest.fixture(scope="module")
def files(security, tmp_path_factory):
    """Certificate of the authority, certificate and key."""
    texts = security.tls_ca_file, security.tls_client_cert, security.tls_client_key
    folder = tmp_path_factory.mktemp("certificates")
    for name, text in zip(("ca", "cert", "key"), texts, strict=True):
        (folder / f"{name}.pem").write_text(text)
    return tuple(folder / f"{name}.pem" for name in ("ca", "cert", "key"))


@pytest.mark.parametrize(
    "address", ["no such protocol://x", "node7:8786", "tcp://node7", "tls://node7:port", "ucx://node7:1", ""]
)
def test_what_is_no_address_is_told(address, tmp_path):
    start = Placement(scheduler=address).engine(toy(tmp_path).plan)
    with pytest.raises(BadCase, match=r"--scheduler .*: it must be tls://HOST:PORT or tcp://HOST:PORT"):
        start(1)


def test_a_scheduler_that_does_not_answer_is_told(monkeypatch):
    monkeypatch.setattr(on_dask, "PATIENCE", 0.2)
    with pytest.raises(NoConnection, match="no scheduler answers there: OSError: Timed out"):
        connected("tcp://127.0.0.1:1")


def test_what_is_no_scheduler_is_told(monkeypatch):
    """Dask takes the first bytes of another server for the size of a message."""
    monkeypatch.setattr(on_dask, "PATIENCE", 0.5)
    with socket.create_server(("127.0.0.1", 0)) as server:
        Thread(target=greet, args=(server,)).start()
        with pytest.raises(NoConnection, match="no scheduler answers there"):
            connected(f"tcp://127.0.0.1:{server.getsockname()[1]}")


def greet(server):
    with server.accept()[0] as connection:
        connection.sendall(100 * b"SSH-2.0-OpenSSH_9.2p1")
        connection.recv(1)


@pytest.mark.parametrize(
    ("address", "warned"),
    [
        ("tcp://192.0.2.7:8786", True),
        ("tcp://[2001:db8::7]:8786", True),
        ("tcp://127.0.0.1:8786", False),
        ("tcp://[::1]:8786", False),
        ("tcp://localhost:8786", False),
        ("tls://192.0.2.7:8786", False),
    ],
)
def test_a_network_without_tls_is_warned_of(address, warned, caplog, monkeypatch):
    monkeypatch.setattr(on_dask, "PATIENCE", 0.01)
    with pytest.raises(NoConnection):
        connected(address)
    warnings = [text for text in caplog.messages if "whoever reaches its port may have code run" in text]
    assert len(warnings) == warned


def test_tls_needs_certificates_and_certificates_tls(files):
    with pytest.raises(NoConnection, match="it needs --tls-ca, --tls-cert and --tls-key"):
        connected("tls://127.0.0.1:1")
    with pytest.raises(NoConnection, match="the address must begin with tls://"):
        connected("tcp://127.0.0.1:1", certificates(*files))


def test_files_that_are_no_certificates_are_told(files, tmp_path):
    plan, (authority, certificate, key) = toy(tmp_path).plan, files
    wrong = {
        (authority, None, None): "all three are needed for TLS, 1 given",
        (authority, certificate, tmp_path / "none"): "--tls-key .*none: there is no such file",
        (authority, certificate, Path("/dev/zero")): "--tls-key .*: is no plain file",
        (authority, key, certificate): "no certificates and key in PEM form",
        (tmp_path / "toy.toml", certificate, key): "no certificates and key in PEM form",
    }
    for tls, words in wrong.items():
        with pytest.raises(BadCase, match=words):
            Placement(scheduler="tls://127.0.0.1:1", tls=tls).engine(plan)
    with pytest.raises(BadCase, match="only --scheduler and --slurm have connections"):
        Placement(tls=files).engine(plan)


@pytest.mark.slow
@pytest.mark.parametrize("how", ["without", "options", "configuration of Dask"])
def test_a_running_scheduler_computes_and_stays(how, tmp_path, request):
    from dask import config
    from distributed import LocalCluster

    prepared, options, given, configured = toy(tmp_path, FORTY), {}, (), {}
    if how != "without":
        files = request.getfixturevalue("files")
        options = {"security": request.getfixturevalue("security"), "protocol": "tls://"}
        given = files if how == "options" else ()
        configured = dict(zip(("ca-file", "client.cert", "client.key"), map(str, files), strict=True))
    alone = computed(prepared, tmp_path, Serial())
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", **options) as cluster:
        for folder in ("one", "two"):
            with config.set({f"distributed.comm.tls.{name}": file for name, file in configured.items()}):
                engine = connected(cluster.scheduler_address, certificates(*given))
            assert engine.workers == 2
            assert str(computed(prepared, tmp_path / folder, engine).rows) == str(alone.rows)


@pytest.mark.slow
def test_a_scheduler_that_is_killed_leaves_no_failed_row_and_the_next_start_goes_on(tmp_path):
    prepared, started = toy(tmp_path, FORTY), []
    place = tmp_path / "scheduler.json"
    file = ("--scheduler-file", str(place), "--no-dashboard")
    calls = (
        ("dask_scheduler", "--host", "127.0.0.1", "--port", "0", *file),
        ("dask_worker", "--no-nanny", *file),
    )
    try:
        for name, *options in calls:
            words = [sys.executable, "-m", f"distributed.cli.{name}", *options]
            started.append(subprocess.Popen(words, stderr=subprocess.DEVNULL, cwd=ROOT))
        while not (place.exists() and place.read_text()):
            pass
        engine = connected(json.loads(place.read_text())["address"])
        # Its tracebacks come before the sentence, or do not: by which of its tasks is cancelled first.
        assert not logging.getLogger("distributed.client").isEnabledFor(logging.ERROR)
        with pytest.raises(EngineLost, match=r"the scheduler is gone \(\w+\)") as lost:
            computed(
                prepared, tmp_path, engine, tell=lambda progress: progress.done > 10 and started[0].kill()
            )
    finally:
        for process in started:
            process.kill()
            process.wait()
    rows = prepared.rows(tmp_path)
    assert f"{len(rows)} of 40 variants are kept, the same study goes on from there" in lost.value.__notes__
    assert 10 < len(rows) < 40
    assert all(row.converged for row in rows.values())
    assert computed(prepared, tmp_path, Serial()).failed == 0
