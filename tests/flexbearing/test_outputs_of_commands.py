"""Outputs of plot, export, map and pareto: settled before anything is computed, complete or not there."""

import errno
import os
import re
import shutil
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import pytest

import flexbearing
from flexbearing.files import NotStored, parts_of
from flexbearing.runs import fields, stored_fields
from flexbearing.studies import pareto
from flexbearing.studies.maps import branch
from flexbearing.studies.pareto_levels import Level
from tests.places import CONFIGS

PAPER, PLAIN = CONFIGS / "mao2016.toml", CONFIGS / "nu209.toml"
BEAM = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "accuracy.slices=8"]
RANGE = "operation.radial_load=5 kN..6 kN"


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    return flexbearing.run(PAPER, BEAM, output=tmp_path_factory.mktemp("run") / "r.h5").path


@pytest.fixture
def result(finished, tmp_path):
    return Path(shutil.copy(finished, tmp_path / "ring.h5"))


@pytest.fixture
def nothing_computed(monkeypatch):
    """Fails where computing begins."""

    def never(*_, **__):
        raise AssertionError("computed before the output was settled")

    for module, name in ((fields, "fields"), (branch, "completed"), (pareto, "Processes")):
        monkeypatch.setattr(module, name, never)


def full_disk(monkeypatch, place=1):
    """Let the file that is written in this place, and those behind it, meet a full disk."""
    calls = count(1)

    def meet(_):
        if next(calls) >= place:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", meet)


@pytest.mark.slow
def test_pictures_of_two_results_stand_side_by_side(command, result, tmp_path):
    other = Path(shutil.copy(result, tmp_path / "other.h5"))
    for one in (result, other):
        assert command("plot", one, "-o", tmp_path / "pictures")[0] == 0
    names = "roller_loads", "convergence", "raceway_deviation"
    names += ("pressure_map", "pressure_along", "outer_deformed")
    expected = {f"{stem}_{name}.png" for stem in ("ring", "other") for name in names}
    assert {path.name for path in (tmp_path / "pictures").iterdir()} == expected


@pytest.mark.slow
def test_default_names_of_studies_carry_the_settings(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    few = (Level("5 slices", ("accuracy.slices=5",)),)
    monkeypatch.setattr(pareto, "ladder", lambda case, solid: few)
    for speed in ("1000 rpm", "1200 rpm"):
        words = ["--set", f"operation.inner_speed={speed}"]
        assert command("map", PLAIN, "--over", RANGE, *words)[0] == 0
        assert command("pareto", PLAIN, *words)[0] == 0
    names = sorted(re.sub("_[0-9a-f]{8}", "", path.name) for path in (tmp_path / "results").iterdir())
    stems = [f"nu209_operation.inner_speed={speed}rpm" for speed in (1000, 1200)]
    assert names == sorted(
        name
        for stem in stems
        for end in ("csv", "png")
        for name in (f"{stem}_map.{end}", f"pareto_{stem}.{end}")
    )


IMPOSSIBLE = {
    "a file where a folder should be": "ring.h5/sub",
    "a folder that cannot be made": "/proc/nowhere",
    "a name that is too long": "x" * 300 + "/sub",
    "a link to itself": "loop/sub",
}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("where", IMPOSSIBLE.values(), ids=IMPOSSIBLE.keys())
@pytest.mark.usefixtures("nothing_computed")
def test_impossible_folder_is_refused_before_anything_is_computed(command, result, tmp_path, where):
    (tmp_path / "loop").symlink_to("loop")
    study = tmp_path / "study.toml"
    study.write_text(f'case = "{PLAIN}"\n[over]\n"operation.radial_load" = ["1 kN"]')
    unused = tmp_path / where
    commands = (
        ("study", study, "-o", unused, "--jobs", "1"),
        ("plot", result, "-o", tmp_path / where),
        *(("export", result, "--to", form, "-o", tmp_path / where) for form in ("vtu", "csv", "netcdf")),
        ("map", PAPER, "--over", RANGE, "-o", tmp_path / where / "t.csv"),
        ("pareto", PLAIN, "-o", tmp_path / where),
    )
    for words in commands:
        code, said, complaint = command(*words)
        assert (code, said) == (2, "")
        assert any(words in complaint for words in ("no folder to write to", "too long", "Symlink loop"))
        assert complaint.count("\n") == 1


@pytest.mark.parametrize("name", ["loop", "x" * 300])
@pytest.mark.parametrize("how", [("--status",), ("--emit", "sbatch")], ids=" ".join)
def test_a_folder_that_no_study_can_have_is_refused_where_nothing_is_written(command, tmp_path, name, how):
    (tmp_path / "loop").symlink_to("loop")
    study = tmp_path / "study.toml"
    study.write_text(f'case = "{PLAIN}"\n[over]\n"operation.radial_load" = ["1 kN"]')
    code, said, complaint = command("study", study, "-o", tmp_path / name, *how)
    assert (code, said, "no folder to write to" in complaint) == (2, "", True)


@pytest.mark.parametrize("protected", ["t.csv", "t.png"])
@pytest.mark.usefixtures("nothing_computed")
def test_protected_table_or_picture_is_refused_before_anything_is_computed(command, tmp_path, protected):
    (tmp_path / protected).write_text("mine")
    (tmp_path / protected).chmod(0o444)
    code, _, complaint = command("map", PAPER, "--over", RANGE, "-o", tmp_path / "t.csv")
    assert (code, "write-protected" in complaint) == (2, True)
    assert (tmp_path / protected).read_text() == "mine"


@pytest.mark.parametrize("name", ["../x", "/x", "a/b", "", ".x", "..", "a\0b", "x" * 300, "a\nb"])
@pytest.mark.usefixtures("nothing_computed")
def test_name_of_a_study_is_a_plain_name(command, tmp_path, name):
    code, _, complaint = command("pareto", PLAIN, "-o", tmp_path / "there", f"--name={name}")
    assert code == 2
    assert "--name" in complaint or "too long" in complaint
    assert sorted(path.name for path in tmp_path.iterdir()) in ([], ["there"])


@pytest.mark.parametrize(
    ("words", "place", "left"),
    [
        (("plot", "ring.h5", "-o", "."), 1, set()),
        (("map", PAPER, "--over", RANGE, "-o", "t.csv"), 1, set()),
        (("map", PAPER, "--over", RANGE, "-o", "t.csv"), 2, {"t.csv"}),
    ],
)
@pytest.mark.usefixtures("result")
@pytest.mark.slow
def test_full_disk_ends_with_three_and_one_line_that_says_what_to_do(
    command, tmp_path, monkeypatch, words, place, left
):
    monkeypatch.chdir(tmp_path)
    full_disk(monkeypatch, place)
    code, _, complaint = command(*words)
    assert code == 3
    assert "not written: No space left on device" in complaint
    assert "free space there, or choose another place with -o" in complaint
    assert complaint.count("\n") == 1
    assert ("the table is complete: t.csv" in complaint) == bool(left)
    assert {path.name for path in tmp_path.iterdir()} == {"ring.h5", *left}


def test_fields_cut_short_by_a_full_disk_are_not_stored(monkeypatch, tmp_path):
    """They are made in memory and stored as a whole, or not at all."""
    path = tmp_path / "r_outer_flexible.vtu"
    part = SimpleNamespace(loaded=SimpleNamespace(displacement=None), part=SimpleNamespace(materials={}))
    monkeypatch.setattr("fem.solid.vtu.vtu", lambda displacement, materials: b"<VTKFile>")
    full_disk(monkeypatch)
    with pytest.raises(NotStored, match=r"r_outer_flexible\.vtu"):
        stored_fields.write(part, path)  # pyright: ignore[reportArgumentType]
    assert not path.exists()
    assert parts_of(path) == []


FAILURES = {
    "disk": (OSError(errno.ENOSPC, "No space left on device", "/tmp/x"), "/tmp/x: No space left.*TMPDIR"),
    "quota": (OSError(errno.EDQUOT, "Disk quota exceeded"), "Disk quota exceeded.*Free space"),
    "files": (OSError(errno.EMFILE, "Too many open files"), "Too many open files.*ulimit -n"),
    "memory": (MemoryError(), "out of memory: take larger elements"),
    "stored": (NotStored("r.h5: not written: why."), r"^r\.h5: not written: why$"),
}


@pytest.mark.parametrize(("problem", "words"), FAILURES.values(), ids=FAILURES.keys())
def test_what_the_machine_does_not_give_is_no_internal_error(command, monkeypatch, problem, words):
    def meet(*_, **__):
        problem.__notes__ = ["3 iterations kept in r.part"]
        raise problem

    monkeypatch.setattr("flexbearing.api.check", meet)
    code, _, complaint = command("check", PLAIN)
    told, _, note = complaint.rstrip("\n").partition("; 3 iterations")
    assert code == 3
    assert re.search(words, told)
    assert note == " kept in r.part"
    assert "internal" not in complaint


@pytest.mark.parametrize("problem", [RecursionError("deep"), OSError(errno.EXDEV, "no"), KeyError("x")])
def test_mistakes_of_the_program_stay_internal_errors(command, monkeypatch, problem):
    def meet(*_, **__):
        raise problem

    monkeypatch.setattr("flexbearing.api.check", meet)
    code, _, complaint = command("check", PLAIN)
    assert (code, complaint.startswith("internal error: ")) == (3, True)


@pytest.mark.slow
def test_pictures_and_page_of_an_unfinished_run(tmp_path, monkeypatch, command):
    def stop(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("flexbearing.progress.Logged.iteration", stop)
    with pytest.raises(KeyboardInterrupt):
        flexbearing.run(PAPER, BEAM, output=tmp_path / "u.h5")
    (part,) = tmp_path.iterdir()
    code, said, _ = command("summary", part)
    assert code == 0
    assert "(unfinished)" in said
    assert "iteration" in said
    code, said, _ = command("plot", part, "-o", tmp_path / "there")
    assert code == 0
    assert f"no picture {part.stem}_raceway_deviation: the flexible state was not solved\n" in said
    assert len(list((tmp_path / "there").glob(f"{part.stem}_*.png"))) == 4
    assert command("export", part, "--to", "vtu")[0] == 2
