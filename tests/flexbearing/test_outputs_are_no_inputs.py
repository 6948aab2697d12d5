"""No command writes over a file that it reads; the table of commands is complete."""

import re
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
import typer.main

import flexbearing
from flexbearing import __main__ as program
from flexbearing.cli import application
from flexbearing.studies.plan.task import file_name
from flexbearing.studies.prepare import prepare_source
from tests.flexbearing.test_bearing_for_ross import table
from tests.flexbearing.test_contact_pictures import B1, FEW
from tests.places import CONFIGS

BEAM = {"inner.kind": "rigid", "outer.kind": "ring", "accuracy.structure": "beam", "accuracy.slices": 8}
TEXTS = {
    **dict.fromkeys(("p.csv", "q.csv"), "position [mm],drop [um]\n0,0\n1.5,0.3\n2.5,2\n"),
    "loads.csv": "operation.radial_load [kN]\n4\n5\n",
    "bearings.csv": "designation,like,bore,outside,width\n6210,deep_groove_ball,50 mm,90 mm,20 mm\n",
    "cycle.csv": "time [%],operation.radial_load [kN]\n20,4\n80,5\n",
    "slurm.toml": 'jobs = 2\nmemory = "1 GB"\n',
    "study.toml": 'case = "drawn.toml"\nresults = "full"\n[over]\nfile = "loads.csv"\n'
    '"outer.file" = "other.step"\n[plot]\nx = "operation.radial_load"\ny = ["life"]\n'
    '[collect]\nlife = "life_L10 [Mrev]"\n',
    "sampled.toml": 'case = "paper.toml"\n[sample]\ncount = 2\n"bearing.clearance" = "normal 30 um, 2 um"\n'
    '[duty]\nfile = "cycle.csv"\n',
    "best.toml": 'case = "paper.toml"\n[set]\n"bearing.roller.points_file" = "q.csv"\n'
    '[vary]\n"bearing.clearance" = "0 um .. 60 um"\n'
    '[maximise]\noutput = "life_L10 [Mrev]"\n',
    **{f"table{part}.csv": "load\n1\n" for part in ("", "_duty", "_percentiles", "_shares", "_histogram")},
}
MODEL = Path(__file__).parent / "rexs" / "rexs_schema_1.7_bearings.xml"  # refused only when it is read


@dataclass(frozen=True)
class Use:
    """A way to use a command: its words, what it then writes, what it then reads."""

    words: str  # with OUT in place of the folder of its outputs
    outputs: str
    inputs: str


AS_RESULT = " ".join(f"--set {key}={value}" for key, value in BEAM.items())
RANGE = "--over operation.radial_load=4kN..5kN"
DRAWN, PAPER, OF_RESULT = "drawn.toml step_ring.step", "paper.toml p.csv", "result.h5 paper.toml p.csv"
RESULT_FILE = "study/IDENTITY"  # of the first variant of study.toml
USES = {
    "new": (
        Use("new OUT/out.toml --from-rexs model.rexs --force", "out.toml", "model.rexs"),
        Use("new OUT/out.toml --from-rexs model.rexs --run", "results/out.h5", "model.rexs"),
    ),
    "run": (
        Use("run drawn.toml -o OUT/out.h5", "out.h5", DRAWN),
        Use(f"run paper.toml -o OUT/out.h5 --start result.h5 {AS_RESULT}", "out.h5", f"{PAPER} result.h5"),
    ),
    "plot": (
        Use("plot result.h5 -o OUT", "result_convergence.png", OF_RESULT),
        Use(
            "plot balls.h5 --against others.h5 -o OUT",
            "balls_against_others_ball_0.png",
            "others.h5 four.toml",
        ),
    ),
    "report": (
        Use(
            "report result.h5 -o OUT/out.html --pdf --against other.h5",
            "out.html out.pdf",
            f"{OF_RESULT} other.h5",
        ),
        Use("report table.csv -o OUT/out.html", "out.html", "table.csv table_duty.csv table_shares.csv"),
    ),
    "export": (
        Use(
            "export result.h5 --to csv -o OUT",
            "result_rigid_roller.csv result_flexible_scalars.csv",
            OF_RESULT,
        ),
        Use("export result.h5 --to vtu -o OUT", "result_outer_flexible.vtu", OF_RESULT),
        Use("export result.h5 --to netcdf -o OUT", "result.nc", OF_RESULT),
        Use("export result.h5 --to rexs -o OUT", "result.rexs", OF_RESULT),
        Use("export speeds.csv --to ross -o OUT", "speeds_ross2.toml speeds_ross3.toml", "speeds.csv"),
    ),
    "draw": (Use("draw drawn.toml -o OUT", "drawn_section.svg drawn_along-axis.svg", DRAWN),),
    "map": (
        Use(
            f"map paper.toml {RANGE},3 -o OUT/out.csv",
            "out.csv out.png out.html out.nc out_folds.csv",
            PAPER,
        ),
        Use(f"map paper.toml {RANGE} -o OUT/out.csv", "out.csv out.png", PAPER),
    ),
    "pareto": (Use("pareto drawn.toml -o OUT --name few", "pareto_few.csv pareto_few.png", DRAWN),),
    "select": (
        Use(
            "select bearings.csv --required-life 9h --speed 9rpm --spectrum cycle.csv -o OUT/out.csv",
            "out.csv",
            "bearings.csv cycle.csv",
        ),
    ),
    "limits": (Use("limits four.toml -o OUT/out.png", "out.png out.csv", "four.toml"),),
    "sensitivity": (Use("sensitivity drawn.toml -o OUT/out.png", "out.png out.csv", DRAWN),),
    "study": (
        Use(
            "study study.toml -o OUT --slurm slurm.toml",
            f"study.csv study.parquet study.nc study.png study.journal.jsonl {RESULT_FILE}",
            f"study.toml slurm.toml loads.csv other.step {DRAWN}",
        ),
        Use(
            "study sampled.toml -o OUT",
            "sampled.csv sampled_duty.csv sampled_percentiles.csv sampled_shares.nc "
            "sampled_histogram.parquet sampled_scatter.png",
            f"sampled.toml cycle.csv {PAPER}",
        ),
        Use("study study.toml -o OUT --part 1/2", "study.part-1-of-2.journal.jsonl", f"study.toml {DRAWN}"),
    ),
    "optimise": (
        Use(
            "optimise best.toml -o OUT",
            "best.csv best_optimum.toml best.journal.jsonl",
            f"best.toml q.csv {PAPER}",
        ),
    ),
    **dict.fromkeys(("check", "life", "goal", "summary", "diff", "explain"), ()),  # write nothing
    **dict.fromkeys(("cache list", "cache clear", "cache path"), ()),
}
LINKS = {"symbolic link": Path.symlink_to, "hard link": Path.hardlink_to}


def commands(group, above="") -> Iterator[tuple[str, typer.main.TyperCommand]]:
    for name, each in group.commands.items():
        if hasattr(each, "commands"):
            yield from commands(each, f"{name} ")
        else:
            yield above + name, each


def test_every_command_is_here_and_those_with_outputs_have_uses():
    registered = dict(commands(typer.main.get_command(application())))
    assert registered.keys() == USES.keys()
    for name, each in registered.items():
        if "output" in {option.name for option in each.params}:
            assert USES[name], name


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Every kind of file that is read; two results and two of balls are computed."""
    made = tmp_path_factory.mktemp("inputs")
    for name, text in TEXTS.items():
        (made / name).write_text(text)
    for source, name in (
        ("step_ring.toml", "drawn.toml"),
        ("step_ring.step", "step_ring.step"),
        ("step_ring.step", "other.step"),
        (f"{B1}.toml", "four.toml"),
    ):
        shutil.copy(CONFIGS / source, made / name)
    text = (CONFIGS / "mao2016.toml").read_text().replace('"bearing.roller.drop",', "")
    text = re.sub('profile = "logarithmic"|drop = "1.75 um"', 'points_file = "p.csv"', text, count=1)
    (made / "paper.toml").write_text(text.replace('drop = "1.75 um"', 'profile = "points"'))
    shutil.copy(MODEL, made / "model.rexs")
    table(made / "speeds.csv")
    flexbearing.run(made / "paper.toml", BEAM, output=made / "result.h5")
    flexbearing.run(made / "four.toml", [FEW], output=made / "balls.h5")
    for name, other in (("result", "other"), ("balls", "others")):
        shutil.copy(made / f"{name}.h5", made / f"{other}.h5")
    return made


def crossed(uses):
    """Every output with the first input, and the first output with every input."""
    for use in uses:
        outputs, inputs = use.outputs.split(), use.inputs.split()
        for output, given in dict.fromkeys(
            [(each, inputs[0]) for each in outputs] + [(outputs[0], each) for each in inputs]
        ):
            yield use.words, output, given


CROSSED = [each for uses in USES.values() for each in crossed(uses)]
BY_LINK = [(*each, LINKS["symbolic link"]) for each in CROSSED]
BY_LINK += [(*next(crossed(uses)), LINKS["hard link"]) for uses in USES.values() if uses]


def bytes_in(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


@pytest.fixture
def refused(monkeypatch, capsys):
    """Run a command that must end with 2 and a line that names both files, and change no input."""

    def run(folder, words, output, given):
        before = bytes_in(folder)
        code, complaint = program.command(words.split()), capsys.readouterr().err
        after = bytes_in(folder)
        for name in before:  # a failure here must be none of other tests
            if after.get(name) != before[name]:
                (folder / name).write_bytes(before[name])
        assert (code, complaint.count("\n")) == (2, 1)
        assert f"{Path(output).name}: is " in complaint
        assert f"{given} itself, which is read here" in complaint
        assert after == before

    monkeypatch.setattr("flexbearing.pages.make.chromium", lambda: "chromium")
    return run


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("words", "output", "given", "link"), BY_LINK)
def test_no_output_leads_to_an_input(folder, tmp_path, monkeypatch, refused, words, output, given, link):
    monkeypatch.chdir(folder)
    if "IDENTITY" in output:
        output = output.replace(
            "IDENTITY", file_name(prepare_source("study.toml").plan.variants[0], final=False)
        )
    place = (folder if output.startswith("results/") else tmp_path) / output
    place.parent.mkdir(exist_ok=True)
    link(place, folder / given)
    try:
        refused(folder, words.replace("OUT", str(tmp_path)), output, given)
    finally:
        place.unlink(missing_ok=True)


def may_have_its_name(words, output, given):
    """Whether an input may have the name of an output that does not follow from it."""
    texts = {**TEXTS, "drawn.toml": '"step_ring.step"', "paper.toml": '"p.csv"'}
    named = any(word == given or f'"{given}"' in texts.get(word, "") for word in words.split())
    return named and Path(given).stem not in output and "/" not in output


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("words", "output", "given"), [each for each in CROSSED if may_have_its_name(*each)])
def test_no_output_has_the_name_of_an_input(folder, tmp_path, monkeypatch, refused, words, output, given):
    here = shutil.copytree(folder, tmp_path / "here")
    monkeypatch.chdir(here)
    (here / given).rename(here / output)
    for file in here.glob("*.toml"):
        file.write_text(file.read_text("utf-8").replace(f'"{given}"', f'"{output}"'), "utf-8")
    renamed = [output if word == given else word for word in words.replace("OUT", ".").split()]
    refused(here, " ".join(renamed), output, output)


def test_two_outputs_are_not_one_file(folder, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    (tmp_path / "out.csv").symlink_to(tmp_path / "out.png")
    assert program.command(["sensitivity", "drawn.toml", "-o", str(tmp_path / "out.png")]) == 2
    assert "out.csv: is " in (complaint := capsys.readouterr().err)
    assert "out.png itself, which is written here, too" in complaint


@pytest.mark.parametrize("words", ["run drawn.toml -o paper.toml", "report result.h5 -o balls.h5"])
def test_a_file_of_another_kind_is_not_replaced(folder, monkeypatch, capsys, words):
    monkeypatch.chdir(folder)
    before = bytes_in(folder)
    assert program.command(words.split()) == 2
    assert "choose" in (complaint := capsys.readouterr().err)
    assert complaint.count("\n") == 1
    assert bytes_in(folder) == before
