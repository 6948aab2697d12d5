"""What a command loads: only what its case needs. Modules are looked at, not a clock."""

import json
import subprocess
import sys

import pytest

from tests.places import ROOT

CODE = """
import json, sys
from flexbearing.__main__ import main
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
sys.stderr.write(json.dumps(sorted(sys.modules)))
"""
HEAVY = ("ngsolve", "netgen", "matplotlib", "pint", "scipy.special", "scipy.sparse")
BALLS = ("flexbearing.case.balls", "flexbearing.runs.ball", "flexbearing.runs.four_point",
         "flexbearing.runs.angular_contact", "flexbearing.report.ball_look", "quasidynamic.balance.balls",
         "quasidynamic.solve.balls", "quasidynamic.four_point", "quasidynamic.angular_contact")  # fmt: skip
ROLLERS = ("flexbearing.case.roller", "flexbearing.runs.roller", "flexbearing.report.family_report",
           "flexbearing.coupled", "quasidynamic.balance.rollers", "quasidynamic.roller")  # fmt: skip

SOLVING = ("quasidynamic.balance", "quasidynamic.solve", "quasidynamic.outcome", "quasidynamic.roller",
           "quasidynamic.contact.raceways")  # fmt: skip
NOT_OF_THIS_CASE = ("quasidynamic.clearance", "quasidynamic.contact.traction.mixed",
                    "quasidynamic.contact.traction.adore", "quasidynamic.contact.traction.rheology",
                    "quasidynamic.contact.flange", "fem.parts.step_solid", "fem.parts.bolted_ring",
                    "flexbearing.case.explain")  # fmt: skip


def loaded(*words):
    command = [sys.executable, "-c", CODE, *map(str, words)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=True)
    return json.loads(done.stderr)


def among(modules, names):
    return [
        module for module in modules if any(module == name or module.startswith(f"{name}.") for name in names)
    ]


@pytest.mark.parametrize("words", [["--help"], ["run", "--help"], ["--version"]], ids=" ".join)
def test_help_loads_no_physics_and_no_model_of_a_case(words):
    assert among(loaded(*words), (*HEAVY, "quasidynamic", "fem", "scipy", "h5py", "rich.console",
                                  "flexbearing.case", "flexbearing.results")) == []  # fmt: skip


def test_checking_rollers_loads_no_balls_no_solver_and_no_files():
    modules = loaded("check", "configs/mao2016.toml")
    assert among(modules, (*HEAVY, *BALLS, *SOLVING, "h5py", "scipy", "rich", "flexbearing.results")) == []
    assert among(modules, NOT_OF_THIS_CASE) == []


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["harris218", "joshi2015_fourpoint"])
def test_checking_balls_loads_no_rollers_and_no_files(name):
    modules = loaded("check", f"configs/{name}.toml")
    heavy = [module for module in HEAVY if not module.startswith("scipy")]  # ellipses take elliptic integrals
    assert among(modules, (*heavy, *ROLLERS, "h5py", "rich", "flexbearing.results")) == []


def test_rigid_run_loads_no_finite_elements_and_no_balls(tmp_path):
    rigid = ["--set", "outer.kind=rigid", "--set", "inner.kind=rigid"]
    modules = loaded("run", "configs/mao2016.toml", *rigid, "-o", tmp_path / "r.h5", "--quiet")
    assert among(modules, (*HEAVY, *BALLS, "scipy", "flexbearing.accuracy", "flexbearing.case.explain")) == []


def test_run_with_condensed_rings_loads_no_finite_elements(tmp_path, monkeypatch):
    monkeypatch.setenv("FLEXBEARING_CACHE", str(tmp_path / "rings"))
    coarse = ["--set", "accuracy.slices=6", "--set", "accuracy.element_order=2"]
    words = ["run", "configs/mao2016.toml", *coarse, "-o", tmp_path / "r.h5", "--quiet"]
    loaded(*words)
    assert among(loaded(*words), ("ngsolve", "netgen", "scipy", "quasidynamic.solve.start.on_ribs")) == []


def test_outer_ring_begins_before_anything_that_solves_is_loaded():
    code = "import flexbearing.rings.raceways, json, sys; sys.stderr.write(json.dumps(sorted(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=True)
    wanted = (*HEAVY, *SOLVING, "flexbearing.coupling", "flexbearing.coupled", "flexbearing.results", "scipy")
    assert among(json.loads(done.stderr), wanted) == []


def command(*words):
    program = [sys.executable, "-m", "flexbearing"]
    return subprocess.run([*program, *words], capture_output=True, text=True, cwd=ROOT)


def test_version_is_told_and_nothing_else():
    done = command("--version")
    assert (done.returncode, done.stdout.split()[0], done.stderr) == (0, "flexbearing", "")


@pytest.mark.sampled(2)
@pytest.mark.parametrize("words", [["--debug", "check", "none.toml"], ["check", "none.toml", "--debug"]])
def test_debug_shows_the_traceback_and_keeps_message_and_exit_code(words):
    plain, done = command("check", "none.toml"), command(*words)
    assert plain.returncode == done.returncode == 2
    assert plain.stderr == "none.toml: there is no such file\n"
    assert "Traceback" in done.stderr
    assert done.stderr.endswith(plain.stderr)


def test_shell_completion_can_be_installed():
    assert "--install-completion" in command("--help").stdout
