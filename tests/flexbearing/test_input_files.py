"""Files that are read: plain ones alone, whatever reads them; a case knows its files."""

import os
from pathlib import Path
from time import process_time

import numpy as np
import pytest

from flexbearing.__main__ import command
from flexbearing.api import read_case
from flexbearing.case.declarations import declared
from flexbearing.families import FAMILIES
from flexbearing.inputs import Unreadable
from flexbearing.report.html.parquet import sealed
from flexbearing.report.html.table import table_text
from flexbearing.studies.file.rows import rows

CONFIGS, SEAT = Path(__file__).parents[2] / "configs", Path(__file__).parent / "seat"
PLAIN, MATRIX = CONFIGS / "nu209.toml", CONFIGS / "mao2016.toml"
SEATED = {
    "outer.kind": "matrix", "outer.width": "12 mm", "outer.thickness": "5 mm", "outer.centre_x": "3 mm",
    "outer.matrix": SEAT / "springs.mtx", "outer.nodes": SEAT / "springs.inp", "inner.kind": "rigid",
}  # fmt: skip
NO_FILES = ("pipe", "device", "folder")
AT_ONCE = 3.0  # [s] of processor time, with what is loaded; what reads a pipe or a device never ends


@pytest.mark.parametrize("name", ["mao2016", "joshi2015_qj309", "rivera2021_7008"])
def test_the_case_file_is_an_input(name):
    file = CONFIGS / f"{name}.toml"
    assert read_case(file).input_files == (file,)


def test_the_drawing_is_an_input_as_long_as_it_is_used():
    file = CONFIGS / "step_ring.toml"
    assert read_case(file).input_files == (file, CONFIGS / "step_ring.step")
    assert read_case(file, ["outer.kind=rigid"]).input_files == (file,)


@pytest.mark.parametrize("family", FAMILIES.values(), ids=FAMILIES)
def test_keys_that_name_files_are_known(family):
    model = family.case()
    stated = {each.path for each in declared(model) if "to the case file" in each.meaning}
    assert stated == {*model.file_keys}


def test_the_unknowns_of_a_matrix_of_calculix_are_an_input():
    case = read_case(MATRIX, {**SEATED, "operation.tilt": "fixed", "outer.matrix": "k.sti"})
    assert CONFIGS / "k.dof" in case.named_files


def settings(keys):
    return [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]


def check(case, **keys):
    return lambda place: ["check", str(case), *settings({key.replace("__", "."): place for key in keys})]


def seated(**changed):
    return lambda place: ["check", str(MATRIX), *settings(SEATED | {f"outer.{k}": place for k in changed})]


def written(name, text):
    """The file of a name in the working folder with a text, in which PLACE stands for the input."""

    def words(place):
        Path(name).write_text(text.replace("PLACE", str(place)).replace("CASE", str(PLAIN)))
        return ["study", name]

    return words


def unknowns(place):
    """A matrix of CalculiX whose second file is the input."""
    matrix = place.with_suffix(".sti")
    matrix.write_text("1 1 1.0\n")
    return seated(matrix=matrix)(matrix)


def study(*words):
    """A study of one variant."""
    Path("s.toml").write_text(f'case = "{PLAIN}"\n[over]\n"operation.radial_load" = ["1 kN"]\n')
    return ["study", "s.toml", "-o", ".", *words]


def journal(place):
    """A study with a part whose journal is the input."""
    place.rename("s.part-1-of-2.journal.jsonl")
    return study()


OVER, DUTY = (f'case = "CASE"\n[{name}]\nfile = "PLACE"\n' for name in ("over", "duty"))
READERS = {
    "case": (".toml", lambda place: ["check", str(place)]),
    "case to run": (".toml", lambda place: ["run", str(place)]),
    "case to draw": (".toml", lambda place: ["draw", str(place)]),
    "case to map": (".toml", lambda place: ["map", str(place), "--over", "operation.radial_load=1 N..9 N,3"]),
    "case for its life": (".toml", lambda place: ["life", str(place)]),
    "case for sensitivities": (".toml", lambda place: ["sensitivity", str(place)]),
    "case for pareto": (".toml", lambda place: ["pareto", str(place)]),
    "study": (".toml", lambda place: ["study", str(place)]),
    "optimisation": (".toml", lambda place: ["optimise", str(place)]),
    "variants": (".csv", written("s.toml", OVER)),
    "duty cycle": (".csv", written("s.toml", DUTY)),
    "case of a study": (".toml", written("s.toml", OVER.replace("CASE", "PLACE"))),
    "journal": (".jsonl", journal),
    "profile of jobs": (".toml", lambda place: study("--slurm", str(place))),
    "points": (
        ".csv",
        lambda place: [
            "check", str(PLAIN),
            *settings({"bearing.roller.profile": "points", "bearing.roller.points_file": place}),
        ],
    ),
    "drawing": (".step", check(CONFIGS / "step_ring.toml", outer__file=1)),
    "matrix of Abaqus": (".mtx", seated(matrix=1)),
    "matrix of Nastran": (".pch", seated(matrix=1)),
    "matrix of CalculiX": (".sti", seated(matrix=1)),
    "unknowns of CalculiX": (".dof", unknowns),
    "mesh": (".inp", seated(nodes=1)),
    "REXS": (".rexs", lambda place: ["new", "c.toml", "--from-rexs", str(place)]),
    "result to sum up": (".h5", lambda place: ["summary", str(place)]),
    "result to report": (".h5", lambda place: ["report", str(place)]),
    "result to plot": (".h5", lambda place: ["plot", str(place)]),
    "result to export": (".h5", lambda place: ["export", str(place), "--to", "csv"]),
    "result to compare": (".h5", lambda place: ["diff", str(place), str(place)]),
    "result to start from": (".h5", lambda place: ["run", str(PLAIN), "-o", "r.h5", "--start", str(place)]),
    "table": (".csv", lambda place: ["report", str(place)]),
    "table in Parquet": (".parquet", lambda place: ["report", str(place)]),
    "table for ROSS": (".csv", lambda place: ["export", str(place), "--to", "ross"]),
}  # fmt: skip


@pytest.mark.sampled(4)
@pytest.mark.parametrize("no_file", NO_FILES)
@pytest.mark.parametrize(("suffix", "words"), READERS.values(), ids=READERS)
def test_what_is_no_plain_file_is_refused_at_once(suffix, words, no_file, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    place = tmp_path / f"{no_file}{suffix}"
    {"pipe": os.mkfifo, "device": lambda path: path.symlink_to("/dev/zero"), "folder": Path.mkdir}[no_file](
        place
    )
    given, began = words(place), process_time()
    assert command(given) == 2
    assert process_time() - began < AT_ONCE
    message = capsys.readouterr().err
    assert 10 < len(message) < 500
    assert len(message.splitlines()) == 1


def parquet(place, **columns):
    pyarrow = pytest.importorskip("pyarrow")
    place.write_bytes(sealed(pyarrow.table(columns)))
    return place


def test_a_column_of_times_is_no_part_of_a_table(tmp_path):
    times = np.full(2, 2**60).astype("datetime64[ms]")  # far beyond those of Python
    place = parquet(tmp_path / "times.parquet", **{"life [h]": times})
    with pytest.raises(Unreadable, match=r"life \[h\]: a column of timestamp\[\w+\], which no study writes"):
        table_text(place)


@pytest.mark.slow
def test_a_packed_table_is_refused_before_it_is_unpacked(tmp_path):
    zeros = np.zeros(5_000_000)
    with pytest.raises(Unreadable, match=r"has 5000000 rows, .* at most 1000000 rows"):
        table_text(parquet(tmp_path / "long.parquet", status=zeros))
    with pytest.raises(Unreadable, match=r"has 1000000 rows, 30000000 cells, .* at most .* 20000000 cells"):
        table_text(parquet(tmp_path / "wide.parquet", **{f"c{k}": zeros[:1_000_000] for k in range(30)}))
    with pytest.raises(Unreadable, match="a text of more than 10000 bytes"):
        table_text(parquet(tmp_path / "text.parquet", status=["c" * 1_000_000] * 1000))
    (tmp_path / "none.parquet").write_bytes(b"PAR1" * 100)
    with pytest.raises(Unreadable, match="has no digest"):
        table_text(tmp_path / "none.parquet")


def packed(place):
    from pyarrow import csv

    place.write_bytes(sealed(csv.read_csv(place.with_suffix(".csv"))))


TABLES = {
    "variants": "operation.radial_load [N],operation.radial_load [kN]\n",
    "duty cycle": "time [%],operation.radial_load [N],time [%]\n",
    "table": "life [h],status,message,findings,seconds,life [h]\n",
    "table in Parquet": "life [h],status,message,findings,seconds,life [h]\n",
    "table for ROSS": "operation.inner_speed [rpm],status,status\n",
    "scatter": "output,unit,output\n",
}


@pytest.mark.parametrize("kind", TABLES)
def test_a_column_twice_is_refused_before_its_cells_are_read(kind, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    row = ",".join(["=nothing that any column can hold"] * (TABLES[kind].count(",") + 1))
    (tmp_path / "t.csv").write_text(f"{TABLES[kind]}{row}\n")
    if kind == "scatter":
        for part in ("percentiles", "shares", "histogram"):
            (tmp_path / f"t_{part}.csv").write_text(f"{TABLES[kind]}{row}\n")
        (tmp_path / "t.csv").write_text("status,message,findings,seconds\nconverged,,,1\n")
    suffix, words = READERS[kind if kind != "scatter" else "table"]
    place = tmp_path / f"t{suffix}"
    if suffix == ".parquet":
        packed(place)
    assert command(words(place)) == 2
    assert "several columns '" in capsys.readouterr().err


def test_text_with_control_characters_is_no_table(tmp_path):
    (tmp_path / "v.csv").write_bytes(b"operation.radial_load [N]\n1\x1b[31m\n")
    with pytest.raises(ValueError, match=r"v.csv\": is no text: it has a control character, '.x1b' at 27"):
        rows(tmp_path / "v.csv", bool)
