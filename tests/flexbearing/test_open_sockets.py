"""No command listens while it computes: sockets of the program and of all its processes, by the system."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.flexbearing.toy_studies import CASE, COLLECT
from tests.places import CONFIGS

STUDY = f'case = "{CASE}"\n[over]\n"operation.radial_load" = "2 kN .. 8 kN, 8000"\n{COLLECT}\n'
LOOKS = 100  # at a command and its workers
LISTENS, ACCEPTS = "0A", 0x10000  # a TCP socket in /proc/net/tcp, a Unix socket in /proc/net/unix


def descendants(process):
    """The process and all that it started; those that end meanwhile have none."""
    yield process
    for children in Path(f"/proc/{process}/task").glob("*/children"):
        try:
            numbers = children.read_text().split()
        except (FileNotFoundError, ProcessLookupError):
            continue
        for child in numbers:
            yield from descendants(int(child))


def open_to_others():
    """By inode: TCP sockets that listen, UDP sockets with a port, Unix sockets with a name or that listen."""
    found = {}
    for kind in ("tcp", "tcp6", "udp", "udp6"):
        for line in Path(f"/proc/net/{kind}").read_text().splitlines()[1:]:
            _, address, _, state, *rest = line.split()
            if kind.startswith("udp") or state == LISTENS:
                found[rest[5]] = f"{kind} {address}"
    for line in Path("/proc/net/unix").read_text().splitlines()[1:]:
        _, _, _, flags, _, _, inode, *name = line.split()
        if name or int(flags, 16) & ACCEPTS:
            found[inode] = f"unix {name}"
    return found


def sockets(process):
    """Inodes of the sockets that a process has open."""
    for entry in Path(f"/proc/{process}/fd").glob("*"):
        try:
            target = str(entry.readlink())
        except (FileNotFoundError, ProcessLookupError):
            continue
        if target.startswith("socket:"):
            yield target.removeprefix("socket:[").removesuffix("]")


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        pytest.param(["study", "study.toml", "--jobs", "2"], marks=pytest.mark.slow),
        ["map", CASE, "--over", "operation.radial_load=2 kN..8 kN,8000", "-o", "map.csv"],
        pytest.param(
            ["run", CONFIGS / "joshi2015_fourpoint.toml", "--set", "friction.model=kalker"],
            marks=pytest.mark.slow,
        ),
    ],
    ids=lambda words: words[0],
)
def test_nothing_listens_while_workers_compute(words, tmp_path):
    (tmp_path / "study.toml").write_text(STUDY)
    command = [sys.executable, "-m", "flexbearing", *words]
    environment = os.environ | {"FLEXBEARING_THREADS": "2"}
    looks, found = 0, set()
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=tmp_path, env=environment
    ) as process:
        while process.poll() is None and looks < LOOKS:
            together = set(descendants(process.pid))
            looks += len(together) == 3
            inodes = {inode for each in together for inode in sockets(each)}
            found |= {words for inode, words in open_to_others().items() if inode in inodes}
            time.sleep(0.02)
        process.terminate()
    assert looks > LOOKS / 4
    assert not found
