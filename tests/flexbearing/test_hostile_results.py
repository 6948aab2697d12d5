"""Result files from elsewhere: refused in one sentence or read as they are; nothing followed or exhausted."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import flexbearing
from flexbearing.__main__ import command
from flexbearing.quantities.roller import LAYOUT
from flexbearing.results import BadResult
from tests.flexbearing.hostile_results import VALUES, corpus
from tests.places import ROOT

PAPER = ROOT / "configs" / "mao2016.toml"
ROLLERS, SLICES = 11, 6
RING = [
    "inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", f"accuracy.slices={SLICES}",
    f"bearing.rollers={ROLLERS}",
]  # fmt: skip
NAMES = ["digest", "case_file", *(name for name, entry in LAYOUT.attributes.items() if not entry.optional)]
CORPUS = corpus(NAMES, ROLLERS, SLICES)
# What a file may say: its digest is right, and every name and number is of a form that a run could write.
TEXTS = "title|ending|message|case_text|case_file|created|method"
READ = re.compile(
    rf"attribute: (({TEXTS}) as (empty )?text|(assumed|case_overrides) as (no )?texts"
    r"|digest as (whole number|number|(empty )?text|(no )?texts)|wall_time_s as number|no case_file"
    r"|status (not solved|unfinished)|time huge|title of (control|mathematics|lines)|notes of control"
    r"|method of mathematics)"
    r"|case: .*|array: without limit|group: group beside"
    r"|content: (one (roller|slice) (fewer|left)|one unknown fewer|numbers: (?!NaN).*|diverged: .*"
    r"|\w+: (zero|huge))"
)
DRAWN = [name for name in CORPUS if re.match("content: (numbers: (?!NaN)|diverged)", name)] + [
    "content: one roller left", "content: inner_load: huge", "content: residual: zero",
    "attribute: title of mathematics", "attribute: method of mathematics", "attribute: status unfinished",
]  # fmt: skip
STARTED = [
    "content: one unknown fewer", "content: one roller fewer", "content: numbers: huge",
    "content: unknowns: huge", "content: unknowns: zero", "attribute: status unfinished",
    "content: diverged: NaN",
]  # fmt: skip
WITH_FIELDS = [
    "case: nothing", "case: no TOML", "case: nested", "case: huge", "case: of balls", "case: misspelt",
    "case: overrides", "case: other rollers", "case: rigid", "case: drawing", "content: one roller fewer",
]  # fmt: skip
BOUNDED = [
    "array: 10^12 numbers in pieces", "array: 10^12 numbers never written", "array: bomb",
    "file: 10^12 bytes", "file: 10^13 zeros", "file: 3 GB of zeros", "file: 3 GB of zeros behind",
    "file: endless device", "attribute: 9000 long notes", "link: endless storage",
]  # fmt: skip


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    path = tmp_path_factory.mktemp("good") / "good.h5"
    flexbearing.run(PAPER, RING, output=path)
    return path


@pytest.fixture
def hostile(good, tmp_path, monkeypatch):
    """Makes a file of the corpus; a good result lies beside it."""
    monkeypatch.chdir(tmp_path)

    def made(name):
        path = tmp_path / "hostile.h5"
        for copy in (path, tmp_path / "other.h5"):
            shutil.copy(good, copy)
        CORPUS[name](path)
        return path

    return made


def told(capsys):
    """What the program wrote, free of control characters."""
    out, err = capsys.readouterr()
    assert not re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202e]", out + err)
    return out, err


def refused(words, capsys):
    """The one line with which a command ends with 2."""
    assert command([str(word) for word in words]) == 2
    _, err = told(capsys)
    assert err.count("\n") == 1
    assert len(err) < 700
    return err


def test_corpus_has_its_size():
    assert len(CORPUS) > 250
    assert len(VALUES) > 10
    assert {*DRAWN, *STARTED, *WITH_FIELDS, *BOUNDED} <= set(CORPUS)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # of numbers beyond all bounds
@pytest.mark.sampled(25)
@pytest.mark.parametrize("name", CORPUS)
def test_hostile_result_is_refused_in_a_sentence_or_read_as_it_is(name, hostile, capsys):
    path = hostile(name)
    if READ.fullmatch(name):
        assert command(["summary", str(path)]) == 0
        assert command(["summary", "--json", str(path)]) == 0
        told(capsys)
    else:
        assert refused(["summary", path], capsys).startswith(f"{path}: ")


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::RuntimeWarning", "ignore::UserWarning")
@pytest.mark.parametrize("name", DRAWN)
def test_pictures_of_any_numbers_can_be_drawn(name, hostile, tmp_path):
    from flexbearing.report.output import pictures

    assert len(list(pictures(flexbearing.read(hostile(name)), tmp_path / "pictures"))) >= 3


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("name", STARTED)
def test_start_from_any_numbers_ends_with_an_answer_or_is_refused(name, hostile, capsys, tmp_path):
    settings = [word for setting in RING for word in ("--set", setting)]
    path, out = hostile(name), tmp_path / "out.h5"
    code = command(["run", str(PAPER), "--quiet", "-o", str(out), *settings, "--start", str(path)])
    _, err = told(capsys)
    numbers_alone = name in ("content: numbers: huge", "content: unknowns: huge", "content: unknowns: zero")
    assert code == (0 if numbers_alone else 2)
    assert err.count("\n") == (not numbers_alone)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", WITH_FIELDS)
def test_fields_of_another_case_than_that_of_the_arrays_are_refused(name, hostile, capsys, tmp_path):
    path = hostile(name)
    assert str(path) in refused(["export", path, "--to", "vtu", "-o", tmp_path / "fields"], capsys)


REFUSE = ["summary", "plot", "diff", "run --start"]


@pytest.mark.parametrize(
    "name", ["link: external group", "array: load of text", "file: pipe", "group: no rigid"]
)
@pytest.mark.parametrize("way", REFUSE)
def test_every_command_refuses_what_the_reader_refuses(way, name, hostile, capsys, tmp_path):
    path = hostile(name)
    words = (
        ["run", PAPER, "-o", tmp_path / "out.h5", "--start", path]
        if way == "run --start"
        else [way, path, *([path] if way == "diff" else [])]
    )
    if way == "run --start":
        words += [word for setting in RING for word in ("--set", setting)]
    assert str(path) in refused(words, capsys)


MEASURED = """
import sys
from pathlib import Path
from flexbearing.__main__ import command
code = command(["summary", sys.argv[1]])
status = Path("/proc/self/status").read_text()  # getrusage would tell what the parent had, too
print(code, int(status.partition("VmHWM:")[2].split()[0]) // 1000)
"""


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the system tells no peak of memory")
@pytest.mark.sampled(5)
@pytest.mark.parametrize("name", BOUNDED)
def test_no_file_takes_more_memory_than_it_has_bytes(name, hostile):
    """Two times 90 MB of notes are in the largest; the program itself takes about 100 MB."""
    path = hostile(name)
    done = subprocess.run(
        [sys.executable, "-c", MEASURED, path], capture_output=True, text=True, timeout=300, cwd=ROOT
    )
    code, megabytes = map(int, done.stdout.split()[-2:])
    assert (code, done.stderr.count("\n")) == (2, 1)
    assert megabytes < (600 if "notes" in name else 250)


def test_numbers_of_a_file_beside_are_not_followed(hostile):
    """What the links point at is there and good; only the way to it is refused."""
    for name in ("link: external array", "link: external group", "link: virtual of another result"):
        path = hostile(name)
        with pytest.raises(BadResult, match=r"elsewhere|another file"):
            flexbearing.read(path)
    assert json.loads(json.dumps(flexbearing.read(path.with_name("other.h5")).summary()))
