"""Outputs have one writer, one name that is no input, and appear whole or not at all."""

import json
import multiprocessing
import os
import signal
import stat
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from flexbearing.files import BadOutput, NotStored, lock, parts_of, require_folder, require_output, write
from flexbearing.files.atomic import host, part_name
from flexbearing.printable import all_printable, printable


@pytest.fixture
def path(tmp_path):
    return require_output(tmp_path / "out.h5")


HOLD = """
import sys, time
from pathlib import Path
from flexbearing.files import lock
with lock(Path(sys.argv[1])):
    print("held", flush=True)
    time.sleep(600)
"""


@pytest.fixture
def holder(path):
    """Another process that writes the output."""
    process = subprocess.Popen([sys.executable, "-c", HOLD, str(path)], stdout=subprocess.PIPE, text=True)
    with process:
        assert process.stdout
        process.stdout.readline()
        yield process
        process.kill()


def test_second_writer_is_told_process_and_host_of_the_first(path, holder):
    words = f"{path} is being written by process {holder.pid} on {host()}"
    with pytest.raises(BadOutput, match=words), lock(path):
        pass
    assert Path(f"{path}.lock").exists()


@pytest.mark.parametrize("way", [signal.SIGKILL, signal.SIGTERM])
def test_lock_of_a_dead_process_is_no_lock(path, holder, way):
    holder.send_signal(way)
    holder.wait()
    with lock(path):
        assert json.loads(Path(f"{path}.lock").read_text())["process"] == os.getpid()
    assert not Path(f"{path}.lock").exists()


def test_lock_names_host_process_and_start(path):
    with lock(path):
        signed = json.loads(Path(f"{path}.lock").read_text())
    assert (signed["host"], signed["process"]) == (host(), os.getpid())
    assert signed["started"].startswith("20")


def test_lock_of_another_host_is_named_and_stays(path):
    place = Path(f"{path}.lock")
    place.write_text('{"host": "node17", "process": 4711, "started": "2026-01-02T03:04:05+00:00"}')
    words = r"process 4711 on node17, since 2026.* remove .*out\.h5\.lock"
    with pytest.raises(BadOutput, match=words), lock(path):
        pass
    assert place.exists()


@pytest.mark.parametrize("content", ["", "\0" * 5000, "{}"])
def test_lock_that_was_never_signed_is_taken_over(path, content):
    place = Path(f"{path}.lock")
    place.write_text(content)
    with lock(path):
        pass
    assert not place.exists()


@pytest.mark.parametrize("content", ["{", "[1]", "[" * 4000, "title = 'mine'", '{"mine": 1}'])
def test_file_with_the_name_of_the_lock_is_not_touched(path, content):
    place = Path(f"{path}.lock")
    place.write_text(content)
    with pytest.raises(BadOutput, match=r"out\.h5\.lock: is in the way of the lock"), lock(path):
        pass
    assert place.read_text() == content


def test_threads_of_one_process_do_not_share_an_output(path):
    with lock(path), pytest.raises(BadOutput, match=f"process {os.getpid()} on"), lock(path):
        pass
    with lock(path):
        pass


def _count_alone(path, counter):
    for _ in range(50):
        try:
            with lock(Path(path)):
                seen = int(Path(counter).read_text())
                Path(counter).write_text(str(seen + 1))
        except BadOutput:
            continue


def test_never_two_at_once(path, tmp_path):
    """A counter that is read and written under the lock would be torn by a second writer."""
    counter = tmp_path / "counter"
    counter.write_text("0")
    work = multiprocessing.get_context("spawn")
    crowd = [work.Process(target=_count_alone, args=(str(path), str(counter))) for _ in range(3)]
    for process in crowd:
        process.start()
    for process in crowd:
        process.join()
    assert [process.exitcode for process in crowd] == [0, 0, 0]
    assert counter.read_text().isdigit()
    assert not Path(f"{path}.lock").exists()


def test_link_at_the_place_of_the_lock_is_not_followed(path, tmp_path):
    other = tmp_path / "mine.txt"
    other.write_text("mine")
    Path(f"{path}.lock").symlink_to(other)
    with pytest.raises(BadOutput, match="no lock"), lock(path):
        pass
    assert other.read_text() == "mine"


def test_lock_without_room_is_told_and_not_left_behind(path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "pwrite", full)
    with pytest.raises(NotStored, match=r"no lock out\.h5\.lock beside it: No space left.* -o"), lock(path):
        pass
    assert list(path.parent.iterdir()) == []


def test_whole_file_or_the_old_one(path, monkeypatch):
    write(path, b"old")

    def full(self, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(NotStored, match=r"out\.h5: not written: No space left on device.*is unchanged"):
        write(path, b"new")
    assert path.read_bytes() == b"old"
    assert parts_of(path) == []


def test_interrupted_writing_leaves_no_part(path, monkeypatch):
    def stop(_):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", stop)
    with pytest.raises(KeyboardInterrupt):
        write(path, b"new")
    assert list(path.parent.iterdir()) == []


def test_disk_that_does_not_keep_what_is_written_is_seen(path, monkeypatch):
    write(path, b"old")
    monkeypatch.setattr(Path, "read_bytes", lambda self: b"rubbish")
    with pytest.raises(NotStored, match="did not keep"):
        write(path, b"new")
    monkeypatch.undo()
    assert (path.read_bytes(), parts_of(path)) == (b"old", [])


def test_names_of_parts_are_never_the_same_and_say_whose_they_are(path):
    names = {part_name(path, suffix) for _ in range(50) for suffix in (".part", ".tmp")}
    assert len(names) == 100
    for name in names:
        name.touch()
    assert {(who, process) for _, who, process in parts_of(path)} == {(host(), os.getpid())}
    assert {part for part, *_ in parts_of(path)} == names


@pytest.mark.parametrize("link", ["itself", "symbolic", "hard", "through a folder"])
def test_output_is_no_input(tmp_path, link):
    case = tmp_path / "case.toml"
    case.write_text("kind")
    out = {"itself": case, "through a folder": tmp_path / "sub" / ".." / "case.toml"}.get(
        link, tmp_path / "out"
    )
    (tmp_path / "sub").mkdir()
    if link == "symbolic":
        out.symlink_to(case)
    if link == "hard":
        out.hardlink_to(case)
    with pytest.raises(BadOutput, match="which is read here"):
        require_output(out, [tmp_path / "other", case])
    assert case.read_text() == "kind"


def test_output_behind_a_link_is_written_where_the_link_leads(tmp_path):
    (tmp_path / "scratch").mkdir()
    (tmp_path / "out.h5").symlink_to(tmp_path / "scratch" / "big.h5")
    assert require_output(tmp_path / "out.h5") == (tmp_path / "scratch" / "big.h5").resolve()


def test_impossible_outputs_are_refused(tmp_path):
    (tmp_path / "file").touch()
    protected = tmp_path / "protected.h5"
    protected.touch()
    protected.chmod(stat.S_IRUSR)
    loop = tmp_path / "loop"
    loop.symlink_to(loop)
    os.mkfifo(tmp_path / "pipe")
    impossible = {
        tmp_path: "is a folder",
        tmp_path / "file" / "out.h5": "Not a directory|File exists",
        tmp_path / ("x" * 300): "name too long",
        tmp_path / ("x" * 245): "name too long",  # of its part
        tmp_path / "out.part": "unfinished",
        tmp_path / "nul\0.h5": "null",
        protected: "write-protected",
        loop: "cannot be written",
        tmp_path / "pipe": "no file",
        "/proc/nothing/out.h5": "no folder",
        "/sys/kernel/out.h5": "no folder",  # where the superuser may write, it seems
    }
    for name, words in impossible.items():
        with pytest.raises(BadOutput, match=f"(?i){words}"):
            require_output(name)
    for name in (tmp_path / "file", "/proc/nothing", "/sys/kernel", f"{tmp_path}/nul\0"):
        with pytest.raises(BadOutput, match="no folder to write to"):
            require_folder(name)
    assert {path.name for path in tmp_path.iterdir()} == {"file", "loop", "pipe", "protected.h5"}


def test_many_writers_of_one_file_leave_one_of_their_files(path):
    texts = [bytes([number]) * 10_000 for number in range(20)]
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda text: write(path, text), texts))
    assert path.read_bytes() in texts
    assert [entry.name for entry in path.parent.iterdir()] == ["out.h5"]


def test_control_characters_are_shown_and_not_obeyed():
    assert printable("Ring\x1b]0;title\x07 \u202eabc\n\x9b31m ü\ttab") == (
        "Ring\\x1b]0;title\\x07 \\u202eabc\n\\x9b31m ü\ttab"
    )
    nested = {"a\x1b": ["\x00", 1.5, {"b": ("c\r",)}]}
    assert all_printable(nested) == {"a\\x1b": ["\\x00", 1.5, {"b": ("c\\r",)}]}
