"""Studies in parts: job arrays of queues compute them, the study without a part gathers them."""

import subprocess

import pytest

from flexbearing import __main__ as program
from flexbearing.case import BadCase
from flexbearing.studies.placement import sbatch
from flexbearing.studies.plan import Part
from tests.flexbearing.test_studies import computed, counting
from tests.flexbearing.toy_studies import CASE, toy

FORTY = '"operation.radial_load" = "2 kN .. 41 kN, 40"'


@pytest.mark.parametrize("of", [1, 3, 8, 40, 50])
def test_every_variant_belongs_to_one_part(tmp_path, of):
    prepared = toy(tmp_path, FORTY)
    parts = [prepared.of_part(Part(number, of)).plan.variants for number in range(1, of + 1)]
    identities = [variant.identity for part in parts for variant in part]
    assert sorted(identities) == sorted(variant.identity for variant in prepared.plan.variants)
    assert max(map(len, parts)) <= max(5, -(-40 // of) + 5)


def test_parts_are_gathered_into_the_table_of_the_whole(tmp_path):
    prepared = toy(tmp_path, FORTY)
    for number in (3, 1, 2):
        table = computed(prepared.of_part(Part(number, 3)), tmp_path)
        assert len(table) in (10, 15)
    assert not (tmp_path / "toy.csv").exists()
    work, loads = counting()
    gathered = computed(prepared, tmp_path, work)
    assert loads == []
    assert str(gathered.rows) == str(computed(prepared, tmp_path / "whole").rows)


def test_a_part_without_variants_ends_like_the_others(tmp_path):
    assert computed(toy(tmp_path, FORTY).of_part(Part(1, 50)), tmp_path).rows == []


def test_what_a_lost_part_lacks_is_computed_when_all_are_gathered(tmp_path):
    prepared = toy(tmp_path, FORTY)
    computed(prepared.of_part(Part(1, 2)), tmp_path)
    work, loads = counting()
    computed(prepared, tmp_path, work)
    assert sorted(loads) == [float(load) for load in range(22, 42)]


def test_an_answer_of_one_part_counts_more_than_a_failure_of_another_run(tmp_path):
    def failing(task, texts):
        raise ValueError("no")

    prepared = toy(tmp_path, FORTY)
    computed(prepared, tmp_path, failing)
    assert computed(prepared.of_part(Part(2, 2)), tmp_path, retry_failed=True).failed == 0
    assert computed(prepared, tmp_path).failed == 20


@pytest.mark.parametrize("text", ["0/3", "4/3", "1", "a/b", "1/2/3", "-1/2", "1/1000000"])
def test_a_part_that_there_is_not_is_refused(text):
    with pytest.raises(BadCase, match="a part is k/N with k from 1 to N"):
        Part.parsed(text)


def test_the_script_of_a_job_array_computes_every_part(tmp_path):
    prepared = toy(tmp_path, FORTY, name="a b")
    script = sbatch(prepared, tmp_path / "out put", 4)
    assert "#SBATCH --array=1-4\n" in script
    assert "#SBATCH --job-name='a b'\n" in script
    last = script.splitlines()[-1]
    assert last.endswith('--part "$SLURM_ARRAY_TASK_ID/4"')
    echoed = last.replace("exec ", "printf '%s\\n' ")
    words = subprocess.run(
        ["bash", "-c", echoed], capture_output=True, text=True, check=True, env={"SLURM_ARRAY_TASK_ID": "2"}
    ).stdout.splitlines()
    assert words[3:] == [
        "study", str(tmp_path / "a b.toml"), "-o", str(tmp_path / "out put"), "--jobs", "1", "--part", "2/4"
    ]  # fmt: skip
    subprocess.run(["bash", "-n"], input=script, text=True, check=True)


def test_the_command_computes_a_part_and_gathers(tmp_path, capsys):
    file = tmp_path / "loads.toml"
    file.write_text(f'case = "{CASE}"\n[over]\n"operation.radial_load" = ["2 kN", "4 kN"]\n')
    words = ["study", str(file), "-o", str(tmp_path), "--jobs", "1"]
    for number in (1, 2, 3):  # one of them has no variant
        assert program.command([*words, "--part", f"{number}/3"]) == 0
        assert f"part {number} of 3 is kept in" in capsys.readouterr().out
    assert program.command(["study", str(file), "-o", str(tmp_path), "--status"]) == 0
    assert "2 variants, 2 finished" in capsys.readouterr().out
    assert program.command(words) == 0
    assert (tmp_path / "loads.csv").exists()
    capsys.readouterr()
    assert program.command([*words[:2], "--emit", "sbatch"]) == 0
    assert capsys.readouterr().out.startswith("#!/bin/bash\n# 2 variants in 2 jobs.")
    assert program.command([*words[:2], "--emit", "pbs"]) == 2
    assert '--emit pbs: it must be "sbatch"' in capsys.readouterr().err
