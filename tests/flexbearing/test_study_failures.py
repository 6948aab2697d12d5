"""What ends a study early, or one of its variants: nothing finished is lost, the same table in the end.

Each is told once, in words. Numbers of tables are compared to 1e-9: how variants are bundled decides where
their solves begin, and with it the last digits.
"""

import csv
import os
import re
import signal
import subprocess
import sys
import time
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from pytest import approx

import fem.condense
import flexbearing
from flexbearing import __main__ as program
from tests.fem.processes import aborting
from tests.flexbearing.toy_studies import CASE
from tests.places import ROOT

pytestmark = pytest.mark.usefixtures("two_cores")

COMMAND = [sys.executable, "-m", "flexbearing", "study"]
PROGRESS = re.compile(r"(check|study|elastic rings)(: \d+ of \d+ .*|, \d+ s)")
LIMIT = 300  # [s] for anything to happen, however busy the machine is
COLLECT = '[collect]\nlife = "life_L10 [h]"\nslip = "cage_slip [%]"\n'


@pytest.fixture
def file(tmp_path):
    """A study whose journal has 350 kB; with result files, which take 0.1 s a variant, it is shorter."""
    return study(tmp_path, 1500)


@pytest.fixture
def with_files(tmp_path):
    return study(tmp_path, 24, 'results = "final"\n', "files")


def study(folder, count, head="", name="loads"):
    path = folder / f"{name}.toml"
    loads = f'[over]\n"operation.radial_load" = "2 kN .. 8 kN, {count}"\n'
    path.write_text(f'case = "{CASE}"\n{head}{loads}{COLLECT}')
    return path


def command(*words):
    return program.command(["study", *map(str, words)])


def started(*words):
    return subprocess.Popen(
        [*COMMAND, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT
    )


def told(errors):
    """What is said on the error output besides progress."""
    return [line for line in errors.splitlines() if not PROGRESS.fullmatch(line)]


def until(condition):
    began = time.monotonic()
    while not condition():
        assert time.monotonic() - began < LIMIT
        time.sleep(0.02)


def journal(folder, name="loads"):
    path = folder / f"{name}.journal.jsonl"
    return path.read_bytes() if path.exists() else b""


def finished(folder, name="loads"):
    """Whole lines with rows."""
    return [line for line in journal(folder, name).split(b"\n")[:-1] if b'"identity"' in line]


def table(folder, name="loads"):
    with (folder / f"{name}.csv").open(newline="") as opened:
        return list(csv.DictReader(opened))


def assert_same(rows, others):
    assert len(rows) == len(others)
    for row, other in zip(rows, others, strict=True):
        numbers, texts = parted(row)
        assert parted(other)[1] == texts
        assert parted(other)[0] == approx(numbers, rel=1e-9, abs=1e-12)


def parted(row):
    """Numbers and texts of a row, without the time that it took and the name of its file."""
    numbers, texts = {}, {}
    for heading, cell in row.items():
        if heading not in ("seconds", "result"):
            try:
                numbers[heading] = float(cell)
            except ValueError:
                texts[heading] = cell
    return numbers, texts


def undisturbed(file):
    """Table of a study that nothing happens to."""
    return computed_once(file.name, file.read_text())


@cache
def computed_once(name, text):
    with TemporaryDirectory() as place:
        file = Path(place) / name
        file.write_text(text)
        assert command(file, "-o", place, "--jobs", "1") == 0
        return table(file.parent, file.stem)


def assert_the_same_in_the_end(file, folder, before):
    """A start after the failure keeps every row that was there, adds the others, and gives the same table."""
    name = file.stem
    assert command(file, "-o", folder, "--jobs", "1") == 0
    after = finished(folder, name)
    assert after[: len(before)] == before
    identities = [re.search(rb'"identity": "(\w+)"', line)[1] for line in after]
    assert len({*identities}) == len(identities) == len(table(folder, name))
    assert_same(table(folder, name), undisturbed(file))
    assert not [path for path in folder.rglob("*") if path.suffix in (".lock", ".part", ".tmp")]


@pytest.mark.slow
def test_a_killed_worker(with_files, tmp_path):
    folder = tmp_path / "out"
    process = started(with_files, "-o", folder, "--jobs", "2")
    until(lambda: finished(folder, "files"))
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    os.kill(int(children[0]), signal.SIGKILL)
    before = finished(folder, "files")
    _, errors = process.communicate()
    assert (process.returncode, told(errors)) == (0, [])
    last = errors.splitlines()[-1]
    assert re.match(r"study: 24 of 24 variants, 0 failed, [12] tasks? repeated because .* died", last)
    assert_the_same_in_the_end(with_files, folder, before)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("number", "jobs"),
    [(signal.SIGKILL, 2), (signal.SIGTERM, 1), (signal.SIGINT, 2)],
    ids=["killed, two jobs", "terminated", "Ctrl-C, two jobs"],
)
def test_a_killed_driver(with_files, tmp_path, capsys, number, jobs):
    """Without last words where the system does not permit any: `--status` tells what is there."""
    folder = tmp_path / "out"
    process = started(with_files, "-o", folder, "--jobs", jobs)
    until(lambda: finished(folder, "files"))
    process.send_signal(number)
    _, errors = process.communicate()
    before = finished(folder, "files")
    kept = f"{len(before)} of 24 variants are kept, the same study goes on from there"
    if number == signal.SIGKILL:
        assert (process.returncode, told(errors)) == (-number, [])
    else:
        assert (process.returncode, told(errors)) == (128 + number, [f"interrupted: {kept}"])
        assert len(table(folder, "files")) == 24
    assert 0 < len(before) < 24
    assert command(with_files, "-o", folder, "--status") == 0
    assert f"24 variants, {len(before)} finished, 0 of them failed" in capsys.readouterr().out
    assert_the_same_in_the_end(with_files, folder, before)


ON_ITS_OWN_DISK = """
disk=$1; size=$2; kept=$3; shift 3
mount -t tmpfs -o size=$size tmpfs "$disk"
"$@"; echo "exit code $?"
cp -r "$disk" "$kept/full"
mount -o remount,size=100m "$disk"
"$@"; echo "exit code $?"
cp -r "$disk" "$kept/free"
"""
NAMESPACE = ["unshare", "--user", "--map-root-user", "--mount", "bash", "-c"]  # whose mounts end with it


def may_mount():
    try:
        words = [*NAMESPACE, "mount -t tmpfs tmpfs /mnt"]
        return subprocess.run(words, capture_output=True, check=False).returncode == 0
    except FileNotFoundError:
        return False


needs_mounts = pytest.mark.skipif(not may_mount(), reason="needs file systems of its own")


@pytest.mark.slow
@needs_mounts
@pytest.mark.parametrize(
    ("name", "size", "jobs"), [("loads", "200k", 1), ("files", "500k", 2)], ids=["rows", "result files"]
)
def test_a_full_disk(file, with_files, tmp_path, name, size, jobs):
    (tmp_path / "disk").mkdir()
    study = {"loads": file, "files": with_files}[name]
    words = [*COMMAND, study, "-o", tmp_path / "disk", "--jobs", str(jobs)]
    done = subprocess.run(
        [*NAMESPACE, ON_ITS_OWN_DISK, "bash", tmp_path / "disk", size, tmp_path, *words],
        capture_output=True, text=True, cwd=ROOT, check=True,
    )  # fmt: skip
    assert re.findall(r"exit code (\d)", done.stdout) == ["3", "0"]
    (message,) = told(done.stderr)
    assert message.startswith(str(tmp_path / "disk"))
    assert "not written: No space left on device" in message
    before = finished(tmp_path / "full", name)
    assert before
    assert re.search(r"; \d+ of \d+ variants are kept, the same study goes on from there$", message)
    assert finished(tmp_path / "free", name)[: len(before)] == before
    assert_same(table(tmp_path / "free", name), undisturbed(study))


READ_ONLY = 'mount --bind "$1" "$1"; mount -o remount,bind,ro "$1"; shift; exec "$@"'


@pytest.mark.slow
@needs_mounts
def test_a_read_only_folder(file, tmp_path):
    """Where a study was killed before."""
    folder = tmp_path / "out"
    assert command(file, "-o", folder, "--jobs", "1") == 0
    path = folder / "loads.journal.jsonl"
    path.write_bytes(b"".join(journal(folder).splitlines(keepends=True)[:700]))
    before = {path: path.read_bytes() for path in folder.iterdir()}
    rows = finished(folder)
    for place in (folder, folder / "below"):
        done = subprocess.run(
            [*NAMESPACE, READ_ONLY, "bash", folder, *COMMAND, file, "-o", place],
            capture_output=True, text=True, cwd=ROOT, check=False,
        )  # fmt: skip
        (message,) = told(done.stderr)
        assert (done.returncode, done.stdout) == (2, "")
        assert message.startswith(f"{place}: no folder to write to: ")
    assert before == {path: path.read_bytes() for path in folder.iterdir()}
    assert_the_same_in_the_end(file, folder, rows)


@pytest.mark.slow
def test_two_studies_on_one_folder(with_files, tmp_path, capsys):
    folder = tmp_path / "out"
    with started(with_files, "-o", folder, "--jobs", "1") as first:
        until(lambda: finished(folder, "files"))
        first.send_signal(signal.SIGSTOP)
        before, content = finished(folder, "files"), journal(folder, "files")
        assert command(with_files, "-o", folder, "--jobs", "1") == 2
        assert journal(folder, "files") == content
        first.send_signal(signal.SIGCONT)
        _, errors = first.communicate()
    (message,) = told(capsys.readouterr().err)
    assert f"files.journal.jsonl is being written by process {first.pid} on {os.uname().nodename}" in message
    assert (first.returncode, told(errors)) == (0, [])
    assert_the_same_in_the_end(with_files, folder, before)


RINGS = f"""
case = "{CASE}"
[over]
"outer.kind" = "ring"
"outer.width" = "19 mm"
"outer.support" = "seat"
"accuracy.structure" = "solid"
"accuracy.element_order" = 2
"accuracy.mesh_size" = "12 mm"
"outer.thickness" = ["3 mm", "4 mm"]
"operation.radial_load" = ["2 kN", "5 kN"]
[collect]
load = "max_roller_load [N]"
rigid = "rigid.max_roller_load [N]"
"""


@pytest.mark.slow
def test_a_variant_that_crashes_the_mesher(tmp_path, monkeypatch, capsys):
    file, folder, mesh = tmp_path / "rings.toml", tmp_path / "out", fem.condense.in_subprocess
    file.write_text(RINGS)

    def crashing(function, part, *arguments, report):
        if part.thickness == 4e-3:
            return mesh(aborting, report=report)
        return mesh(function, part, *arguments, report=report)

    monkeypatch.setattr(fem.condense, "in_subprocess", crashing)
    assert command(file, "-o", folder, "--jobs", "1") == 1
    assert told(capsys.readouterr().err) == []
    rows = table(folder, "rings")
    assert [row["status"] for row in rows] == ["converged"] * 2 + ["not solved"] * 2
    assert [bool(row["load [N]"]) for row in rows] == [True, True, False, False]
    crash = "outer ring: the process that meshes and condenses ended by signal 6 (Aborted); its last words: "
    assert [row["message"].startswith(crash) for row in rows] == [False, False, True, True]
    monkeypatch.undo()
    before = finished(folder, "rings")
    assert command(file, "-o", folder, "--jobs", "1") == 1
    assert finished(folder, "rings") == before
    assert command(file, "-o", folder, "--jobs", "1", "--retry-failed") == 0
    assert finished(folder, "rings")[:4] == before
    assert_same(table(folder, "rings"), undisturbed(file))


BAD = {5: "-1 kN", 50: "-2 kN", 77: "-1e9 N"}


def loads(bad):
    return [bad.get(number, f"{2 + 0.05 * number:.2f} kN") for number in range(100)]


@pytest.mark.slow
def test_three_bad_variants_of_a_hundred(tmp_path, capsys):
    """They are told before the first variant is computed; the others of a former study stay."""
    file, folder = tmp_path / "loads.toml", tmp_path / "out"

    def write(bad):
        listed = ", ".join(f'"{load}"' for load in loads(bad))
        file.write_text(f'case = "{CASE}"\n[over]\n"operation.radial_load" = [{listed}]\n{COLLECT}')

    write({number: "5 kN" for number in BAD})
    assert command(file, "-o", folder, "--jobs", "1") == 0
    before = {path: path.read_bytes() for path in folder.iterdir()}
    rows = finished(folder)
    write(BAD)
    capsys.readouterr()
    assert command(file, "-o", folder, "--jobs", "1") == 2
    *problems, count = told(capsys.readouterr().err)
    assert count == "loads: 3 of 100 variants cannot be computed; none was."
    assert [re.match(r"loads: variant (\d+) ", line)[1] for line in problems] == ["6", "51", "78"]
    assert before == {path: path.read_bytes() for path in folder.iterdir()}
    write({})
    assert_the_same_in_the_end(file, folder, rows)


THIN_RINGS = f"""
case = "{CASE}"
[over]
"outer.kind" = "ring"
"outer.width" = "19 mm"
"operation.tilt" = "fixed"
"accuracy.element_order" = 2
"outer.thickness" = ["3 mm", "4 mm"]
"operation.radial_load" = ["2 kN", "5 kN"]
[collect]
load = "max_roller_load [N]"
"""


@pytest.mark.parametrize("jobs", ["1", pytest.param("2", marks=pytest.mark.slow)])
def test_a_cache_that_cannot_be_written_is_told_once(tmp_path, monkeypatch, capsys, jobs):
    """Root may write to any folder, but not to one below a file."""
    file, place = tmp_path / "rings.toml", tmp_path / "no folder"
    file.write_text(THIN_RINGS)
    place.write_text("")
    monkeypatch.setenv("FLEXBEARING_CACHE", str(place / "cache"))
    assert command(file, "-o", tmp_path / "out", "--jobs", jobs) == 0
    (message,) = told(capsys.readouterr().err)
    assert message == (
        f"the cache {place / 'cache'} cannot be written: Not a directory; "
        "the next study condenses its rings again, FLEXBEARING_CACHE names another folder"
    )
    assert command(file, "-o", tmp_path / "out", "--jobs", jobs) == 0
    assert told(capsys.readouterr().err) == []
    place.unlink()
    assert command(file, "-o", tmp_path / "kept", "--jobs", jobs) == 0
    assert told(capsys.readouterr().err) == []
    assert_same(table(tmp_path / "kept", "rings"), table(tmp_path / "out", "rings"))


def test_python_is_told_what_workers_complained_of(tmp_path, monkeypatch):
    file = tmp_path / "rings.toml"
    file.write_text(THIN_RINGS)
    (tmp_path / "no folder").write_text("")
    monkeypatch.setenv("FLEXBEARING_CACHE", str(tmp_path / "no folder"))
    table = flexbearing.study(file, tmp_path / "out", jobs=1)
    assert table.complaints == (f"the cache {tmp_path / 'no folder'} cannot be written: File exists",)
    assert flexbearing.study(file, tmp_path / "out", jobs=1).complaints == ()
