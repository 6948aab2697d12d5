"""The exit code speaks of the computation, whatever becomes of what is printed."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

import flexbearing
from tests.places import ROOT

PAPER = ROOT / "configs" / "mao2016.toml"
PROGRAM = shlex.join([sys.executable, "-m", "flexbearing"])
RIGID = "--set outer.kind=rigid --set inner.kind=rigid"
PROGRESS = re.compile(r"^.*, \d+ s\n|^.*(: \d+ % done)\n", re.MULTILINE)  # of a slow machine
FULL = pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")


def shell(line, cwd, **environment):
    """A command line as a shell runs it, `flexbearing` in it being the program; ${PIPESTATUS[0]} counts."""
    line = line.replace("flexbearing", PROGRAM) + "; exit ${PIPESTATUS[0]}"
    environment = os.environ | {"PYTHONPATH": str(ROOT), "PYTHONUNBUFFERED": ""} | environment
    done = subprocess.run(
        ["bash", "-c", line], capture_output=True, cwd=cwd, env=environment, check=False, timeout=300
    )
    complained = PROGRESS.sub("", done.stderr.decode())
    return done.returncode, done.stdout.decode(errors="replace"), complained


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    path = tmp_path_factory.mktemp("run") / "r.h5"
    flexbearing.run(PAPER, ["outer.kind=rigid", "inner.kind=rigid"], output=path)
    return path


LOST = "standard output could not be written ({}): what it should hold is lost\n"
NO_SPACE, CLOSED = LOST.format("No space left on device"), LOST.format("Bad file descriptor")
STREAMS = {  # what a shell does with them, what is complained about
    "| head -n 1": "",
    "| true": "",
    "> /dev/full": NO_SPACE,
    ">&-": CLOSED,
    "2>&-": "",
    "2>/dev/full": "",
    "<&-": "",
    "<&- >&- 2>&-": "",
    "> /dev/full 2>/dev/full": "",
}


@FULL
@pytest.mark.parametrize(
    "streams",
    [
        name if name in ("| head -n 1", ">&-") else pytest.param(name, marks=pytest.mark.slow)
        for name in STREAMS
    ],
)
def test_run_that_converged_ends_with_zero_whatever_its_streams(streams, tmp_path):
    code, said, complained = shell(f"flexbearing run {PAPER} {RIGID} -o r.h5 {streams}", tmp_path)
    assert (code, complained) == (0, STREAMS[streams])
    assert "Traceback" not in said
    assert flexbearing.read(tmp_path / "r.h5").attributes["status"] == "converged"
    assert [path.name for path in tmp_path.iterdir()] == ["r.h5"]


@FULL
@pytest.mark.parametrize(
    "streams",
    [pytest.param(streams, marks=pytest.mark.slow) for streams in (">&-", "> /dev/full", "| true")],
)
def test_run_that_did_not_converge_still_ends_with_one(streams, tmp_path):
    words = f"run {PAPER} {RIGID} --set 'operation.radial_load=0 N' -o r.h5"
    assert shell(f"flexbearing {words} {streams}", tmp_path)[0] == 1


@FULL
@pytest.mark.parametrize(
    "words",
    [
        "summary {}",
        *(
            pytest.param(words, marks=pytest.mark.slow)
            for words in ("summary {} --json", "explain", "cache list", "--version")
        ),
    ],
)
def test_text_that_could_not_be_delivered_is_no_success(words, result, tmp_path):
    command = f"flexbearing {words.format(result)}"
    assert shell(f"{command} > /dev/full", tmp_path) == (3, "", NO_SPACE)
    assert shell(f"{command} >&-", tmp_path) == (3, "", CLOSED)
    code, _, complained = shell(f"{command} | head -c 1", tmp_path)
    assert (code, complained) == (0, "")  # a reader that left has read enough


@pytest.mark.slow
@FULL
def test_verdict_of_a_check_is_its_exit_code(tmp_path):
    assert shell(f"flexbearing check {PAPER} >&- 2>&-", tmp_path)[0] == 0
    assert shell("flexbearing check nowhere.toml >&- 2>&-", tmp_path)[0] == 2
    assert shell("flexbearing check nowhere.toml 2>/dev/full", tmp_path)[0] == 2


@pytest.mark.parametrize(
    "encoding",
    [pytest.param(name, marks=pytest.mark.slow) for name in ("ascii", "latin-1", "ascii:strict")],
)
def test_every_encoding_has_a_form_for_every_character(encoding, tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(PAPER.read_text().replace("Squirrel-cage", "Käfig ψ 保持架"))
    for words in ("check case.toml", f"run case.toml {RIGID} -o r.h5", "summary r.h5", "plot r.h5"):
        code, _, complained = shell(f"flexbearing {words}", tmp_path, PYTHONIOENCODING=encoding)
        assert (code, complained) == (0, "")
    assert "\\u03c8" in shell("flexbearing summary r.h5", tmp_path, PYTHONIOENCODING="ascii")[1]


@pytest.mark.slow
def test_frames_of_a_page_suit_the_encoding(result, tmp_path):
    plain = shell(f"flexbearing summary {result} --all", tmp_path, PYTHONIOENCODING="ascii")[1]
    assert plain.isascii()
    assert "\\u25" not in plain
    assert "──" in shell(f"flexbearing summary {result} --all", tmp_path, PYTHONIOENCODING="utf-8")[1]


@FULL
@pytest.mark.slow
def test_unbuffered_streams_tolerate_as_much(result, tmp_path):
    for words, code in ((f"summary {result} > /dev/full", 3), (f"summary {result} | head -n 1", 0)):
        assert shell(f"flexbearing {words}", tmp_path, PYTHONUNBUFFERED="1")[0] == code


def test_completion_of_the_shell_works(tmp_path):
    words = {"_FLEXBEARING_COMPLETE": "complete_bash", "COMP_WORDS": "flexbearing che", "COMP_CWORD": "1"}
    code = "import sys; sys.argv = ['flexbearing']; from flexbearing.__main__ import main; main()"
    program = [sys.executable, "-c", code]
    done = subprocess.run(
        program, capture_output=True, text=True, env=os.environ | words, cwd=ROOT, check=False
    )
    assert (done.returncode, done.stdout.strip(), done.stderr) == (0, "check", "")
