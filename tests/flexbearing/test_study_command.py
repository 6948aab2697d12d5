"""The command `study`: what it prints, its exit codes, rows that are those of single runs."""

import csv
from dataclasses import replace

import pytest

import flexbearing
from flexbearing import __main__ as program
from flexbearing.results import BadResult, store
from quasidynamic import OutOfRange
from tests.flexbearing.toy_studies import CASE
from tests.places import ROOT

pytestmark = pytest.mark.usefixtures("two_cores")

LOADS = (
    '[over]\n"operation.radial_load" = ["2 kN", "4 kN"]\n"operation.inner_speed" = ["3000 rpm", "5000 rpm"]\n'
)


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "loads.toml"
    path.write_text(f'case = "{CASE}"\n{LOADS}')
    return path


def command(*words):
    return program.command(["study", *map(str, words)])


def table(folder, name="loads"):
    with (folder / f"{name}.csv").open(newline="") as opened:
        return list(csv.DictReader(opened))


def test_a_row_equals_the_single_run(file, tmp_path, capsys):
    assert command(file, "-o", tmp_path) == 0
    rows = table(tmp_path)
    for row in rows:
        settings = {
            "operation.radial_load": f"{row['operation.radial_load [N]']} N",
            "operation.inner_speed": f"{row['operation.inner_speed [rpm]']} rpm",
        }
        summary = flexbearing.run(CASE, settings).summary()["flexible"]
        assert float(row["max_roller_load [N]"]) == pytest.approx(summary["max_roller_load_N"], rel=1e-9)
        assert float(row["cage_slip [%]"]) == pytest.approx(summary["cage_slip_percent"], rel=1e-9, abs=1e-12)
        assert row["status"] == "converged"
    assert "loads: 4 variants: 4 converged" in capsys.readouterr().out


def test_a_check_lists_variants_and_computes_nothing(file, tmp_path, capsys):
    assert command(file, "--check", "-o", tmp_path / "out") == 0
    out = capsys.readouterr().out
    assert "3: operation.radial_load = 4 kN, operation.inner_speed = 3000 rpm" in out
    assert "4 variants, all of them can be computed" in out
    assert not (tmp_path / "out").exists()


def test_a_check_of_bad_variants_tells_them_and_is_no_success(file, tmp_path, capsys):
    file.write_text(f'case = "{CASE}"\n[over]\n"operation.radial_load" = "-10 N .. 100 N, 111"')
    assert command(file, "--check") == 2
    out = capsys.readouterr().out
    assert "... and 91 more" in out
    assert "loads: variant 1 (operation.radial_load = -10.0 N): nu209.toml: [operation] radial_load" in out
    assert "10 of 111 variants cannot be computed" in out


def test_bad_variants_are_bad_input_and_nothing_is_computed(file, tmp_path, capsys):
    file.write_text(f'case = "{CASE}"\n[over]\n"operation.radial_load" = ["5 kN", "-5 kN"]')
    assert command(file, "-o", tmp_path / "out") == 2
    assert "loads: 1 of 2 variants cannot be computed; none was." in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_an_unknown_output_is_bad_input_with_the_nearest_name(file, capsys):
    file.write_text(f'case = "{CASE}"\n{LOADS}[collect]\nlife = "life_L01 [h]"')
    assert command(file) == 2
    assert "loads.toml: [collect] life: 'life_L01 [h]': no output has this name. Did you mean life_L10?" in (
        capsys.readouterr().err
    )


def test_a_study_that_leaves_a_row_without_an_answer_ends_with_1(file, tmp_path):
    """Two iterations are too few between these rings."""
    file.write_text(
        f'case = "{ROOT / "configs" / "mao2016.toml"}"\n[over]\n"coupling.max_iterations" = [1, 300]\n'
        '"coupling.fallback" = false\n"inner.kind" = "rigid"\n"outer.kind" = "ring"\n'
        '"accuracy.structure" = "beam"\n'
        '[collect]\nload = "max_roller_load [kN]"\nrigid = "rigid.max_roller_load [kN]"'
    )
    assert command(file, "-o", tmp_path) == 1
    failed, solved = table(tmp_path)
    assert (failed["status"], failed["load [kN]"]) == ("iteration limit", "")
    assert solved["status"] == "converged"
    assert failed["rigid [kN]"] == solved["rigid [kN]"] != ""


@pytest.mark.slow
def test_a_result_file_of_every_variant_comes_where_it_is_asked_for(file, tmp_path):
    file.write_text(f'case = "{CASE}"\nresults = "full"\n{LOADS}')
    assert command(file, "-o", tmp_path) == 0
    rows = table(tmp_path)
    assert len({row["result"] for row in rows}) == 4
    for row in rows:
        result = flexbearing.read(tmp_path / row["result"])
        assert result.attributes["status"] == "converged"
        assert result.flexible["inner_load"].max() == float(row["max_roller_load [N]"])
    (tmp_path / rows[2]["result"]).unlink()
    assert command(file, "-o", tmp_path) == 0
    assert (tmp_path / rows[2]["result"]).exists()
    assert [row["seconds"] for row in table(tmp_path)[:2]] == [row["seconds"] for row in rows[:2]]


def test_a_fault_of_the_program_side_by_side_is_not_hidden_by_runs_one_by_one(file, tmp_path, monkeypatch):
    def broken(*arguments, **options):
        raise FloatingPointError("one of them")

    monkeypatch.setattr("flexbearing.runs.side_by_side.solve_many", broken)
    assert command(file, "-o", tmp_path) == 1
    rows = table(tmp_path)
    assert {row["status"] for row in rows} == {"error"}
    assert all("FloatingPointError" in row["message"] for row in rows)


def test_a_table_says_which_rows_were_not_solved_beside_others_and_why(file, tmp_path, monkeypatch):
    def no_answer(*arguments, **options):
        raise OutOfRange("speed of one of them")

    assert command(file, "-o", tmp_path / "beside") == 0
    assert "own_run" not in table(tmp_path / "beside")[0]
    monkeypatch.setattr("flexbearing.runs.side_by_side.solve_many", no_answer)
    assert command(file, "-o", tmp_path / "apart") == 0
    rows = table(tmp_path / "apart")
    assert {(row["status"], row["own_run"]) for row in rows} == {("converged", "speed of one of them")}


def test_the_status_touches_nothing(file, tmp_path, capsys):
    assert command(file, "--status", "-o", tmp_path / "out") == 0
    assert "loads: 4 variants, 0 finished, 0 of them failed, 4 not computed" in capsys.readouterr().out
    assert not (tmp_path / "out").exists()
    command(file, "-o", tmp_path / "out")
    capsys.readouterr()
    before = {path: path.read_bytes() for path in (tmp_path / "out").iterdir()}
    assert command(file, "--status", "-o", tmp_path / "out") == 0
    assert "4 finished" in capsys.readouterr().out
    assert before == {path: path.read_bytes() for path in (tmp_path / "out").iterdir()}


def test_keys_of_a_study_file_are_explained(capsys):
    assert program.command(["explain", "study"]) == 0
    listed = capsys.readouterr().out
    assert program.command(["explain", "study.sample.method"]) == 0
    explained = capsys.readouterr().out
    assert '"latin_hypercube" or "sobol"' in explained
    assert "how points are spread" in explained
    assert "how points are spread" in listed
    assert program.command(["explain", "study.none"]) == 2
    assert "none is not a key of such a file; there are case, name" in capsys.readouterr().err


@pytest.mark.slow
def test_final_result_files_hold_the_end_states_alone(file, tmp_path):
    """And one kind of files is not taken for the other."""
    elastic = (
        f'case = "{CASE}"\nresults = "%s"\n[over]\n"outer.kind" = "ring"\n"outer.thickness" = "4 mm"\n'
        '"outer.width" = "10 mm"\n"accuracy.structure" = "beam"\n"outer.support" = "foundation"\n'
        '"outer.foundation_radial" = "100 N/mm^3"\n'
    )
    kept = {}
    for kind in ("final", "full"):
        file.write_text(elastic % kind)
        assert command(file, "-o", tmp_path) == 0
        (row,) = table(tmp_path)
        kept[kind] = flexbearing.read(tmp_path / row["result"])
    final, full = kept["final"], kept["full"]
    assert full.attributes["iterations"] == final.attributes["iterations"] == len(full.iterations) > 0
    assert (final.iterations, final.attributes["left_out"]) == ((), "iterations")
    assert "left_out" not in full.attributes
    for block in ("rigid", "flexible"):
        one, other = getattr(final, block), getattr(full, block)
        assert {name: one[name].tolist() for name in one} == {name: other[name].tolist() for name in other}
    assert program.command(["plot", str(final.path), "-o", str(tmp_path)]) == 0


def test_iterations_that_are_missing_or_too_many_are_refused(file, tmp_path):
    result = flexbearing.run(CASE, {"outer.kind": "ring", "outer.thickness": "4 mm", "outer.width": "10 mm",
                                    "accuracy.structure": "beam", "outer.support": "foundation",
                                    "outer.foundation_radial": "100 N/mm^3"})  # fmt: skip
    missing = replace(result, iterations=())
    too_many = replace(result.end_states, iterations=result.iterations)
    for wrong in (missing, too_many):
        store(wrong, tmp_path / "r.h5")
        with pytest.raises(BadResult, match="were written"):
            flexbearing.read(tmp_path / "r.h5")
