"""Studies, duty cycles, variants in tables, optimisations, maps and profiles of clusters."""

from copy import deepcopy
from random import Random
from typing import Any

from benchmarks.changed.bases import COLLECT, OVER, Bases
from benchmarks.changed.changes import Place, cells, damaged, table, word
from benchmarks.changed.files import Bundle, Change, ChangedFiles
from benchmarks.changed.texts import ABSURD

Raw = dict[str, Any]
LOAD, SPEED, CLEARANCE = "operation.radial_load", "operation.inner_speed", "bearing.clearance"
CSV = [[f"{LOAD} [kN]", "operation.tilt", CLEARANCE], ["1", "fixed", "20 um"], ["2", "free", ""]]
SPECTRUM = [["time [%]", f"{LOAD} [kN]", f"{SPEED} [rpm]"], ["30", "1", "2000"], ["70", "3", "1000"]]
DUTY = {"time": ["30 %", "70 %"], LOAD: ["1 kN", "3 kN"], SPEED: "1000 rpm"}
DRAWN = {
    "count": 4, "method": "latin_hypercube", "seed": 1,
    CLEARANCE: "truncated normal 40 um, 4 um, 20 um, 60 um", LOAD: "uniform 1 kN, 3 kN",
    "lubricant.inlet_temperature": "normal 70 degC, 3 K", "lubricant.oil_fraction": "lognormal 0.02, 1.2",
    "bearing.form_error.roller_diameters": "14 x normal 0 um, 0.3 um",
}  # fmt: skip
MARK = {"y": "life", "value": "100 h .. 2000 h", "x": "3 kN", "label": "printed", "source": "a book"}
PLOT = {"x": LOAD, "lines": SPEED, "y": ["life", "cage_slip [%]"], "rigid": False, "marks": [MARK]}
STUDIES: dict[str, Raw] = {
    "crossed": {"over": OVER, "collect": COLLECT, "plot": PLOT},
    "paired": {"over": {"zip": True, LOAD: ["1 kN", "2 kN"], CLEARANCE: "10 um .. 20 um, 2"}},
    "a table": {"over": {"file": "variants.csv", SPEED: ["1000 rpm"]}, "collect": COLLECT},
    "drawn": {"sample": DRAWN, "collect": COLLECT},
    "drawn, sobol": {"sample": {**DRAWN, "method": "sobol"}, "collect": {"life": "life_L10 [h]"}},
    "indices": {
        "sample": {"count": 2, "method": "sobol_indices", LOAD: "uniform 1 kN, 3 kN",
        CLEARANCE: "normal 40 um, 2 um"}, "collect": {"ratio": "flexible.life_L10 / rigid.life_L10",
        "life": "life_L10 [h]"},
    },
    "duty": {"duty": {**DUTY, "life": "life_L10"}, "collect": COLLECT},
    "duty of a table": {"over": {CLEARANCE: ["20 um", "40 um"]}, "duty": {"file": "spectrum.csv"}},
    "arrays": {"over": {LOAD: ["1 kN", "2 kN"]}, "collect": {"load": "inner_load [N]",
    "azimuth": "roller_azimuth [deg]"},
               "plot": {"x": "azimuth", "y": ["load"]}},
    "result files": {"results": "final", "name": "n", "search_equilibria": False, "over": {LOAD: ["1 kN"]},
                     "collect": COLLECT},
}  # fmt: skip
DISTRIBUTIONS = (
    "uniform 3 kN, 1 kN", "uniform 1 kN", "uniform 1 kN, 1e308 N", "normal 1 kN, -1 N", "normal 1 kN, 0 N",
    "lognormal 0, 1", "lognormal 1 kN, 1e300", "lognormal -1, 2", "truncated normal 1 kN, 1 N, 5 kN, 6 kN",
    "truncated normal 1 kN, 1 N, 2 kN, 1 kN", "9999999 x normal 0 um, 1 um", "0 x normal 0 um, 1 um",
    "14 x 14 x normal 0 um, 1 um", "normal", "cauchy 1, 2", "uniform nan N, inf N", "normal 70 degC, 3 degC",
    "99999999999999999999 x uniform 0 um, 1 um", "1 x uniform 1 kN, 2 kN", "normal 1e300 N, 1e300 N",
)  # fmt: skip
OUTPUTS = (
    "life_L10 [h]", "life_L10", "life_L10 [mm]", "rigid.life_L10 [Mrev]", "flexible.flexible.life_L10", "x",
    "", "life_L10 [h] / cage_slip", "life_L10 / life_L10 / life_L10", "life_L10 / 0", "inner_load [N]",
    "inner_load", "status", "message", "converged", "life_L10 [", "life_L10 [h] [h]", "[h]",
    "cage_slip [1e400 %]", "slip", "life", "duty_life [h]", "outer_mass [g]", "nominal_bar_stress",
    "stiffness_zz [N/um]", "peak_pressure.inner [MPa]",
)  # fmt: skip
SHARES = ("-1 %", "0 %", "1e308 h", "inf", "nan", "30 %", "1", "0", "1 mm", "1e-320", "[]", "30 % 70 %")
BOUNDS = (
    "<= 5 %", ">= nan", "< 5", "<= ", "== 5 %", "5 % .. 4 %", "1 .. 2 .. 3", "<= 1e400 %", ">= 5 mm",
    "<=<= 5 %", "..", "<= -1 %", ">= 1e308 %", "0 % .. 0 %",
)  # fmt: skip
SPANS = (
    "1 kN .. 1 kN", "2 kN .. 1 kN", "log 0 N .. 1 kN", "log -1 N .. 1 kN", "1 N .. 1e308 N", "nan N .. inf N",
    "1 kN .. 2 kN, 3", "1 kN ..", ".. 1 kN", "1 kN", "log log 1 N .. 2 N", "0.5 um .. 20 um",
    "0 um .. 1e-12 um",
)  # fmt: skip


HINTS: dict[str, tuple[str, ...]] = {  # by the name of a table
    "sample": DISTRIBUTIONS, "collect": OUTPUTS, "constrain": BOUNDS, "vary": SPANS, "maximise": OUTPUTS,
    "time": SHARES, "y": OUTPUTS, "x": OUTPUTS, "marks": ABSURD,
}  # fmt: skip


def study(rng: Random, bases: Bases) -> ChangedFiles:
    """A study that is computed, checked, counted or emitted."""
    name = rng.choice([*STUDIES])
    raw = {"case": "case.toml", **deepcopy(STUDIES[name])}
    words = rng.choices((
        ("--jobs", "1"), ("--check",), ("--status",), ("--emit", "sbatch"), ("--part", "1/2", "--jobs", "1"),
    ), weights=(12, 8, 1, 1, 1))[0]  # fmt: skip
    bundle = Bundle(
        ("study", "study.toml", "-o", "out", *words),
        {"case.toml": bases.case, "study.toml": raw, "variants.csv": CSV, "spectrum.csv": SPECTRUM},
    )
    changes = _changes(rng, "study.toml", raw)
    if rng.random() < 0.15:
        changes = (word(rng, rng.randrange(4, len(bundle.words)), WORDS), *changes[1:])
    return ChangedFiles("study", name, bundle, changes)


WORDS = (
    "0",
    "-1",
    "1.5",
    "nan",
    "1/0",
    "0/1",
    "2/1",
    "1/1",
    "1/1000000000",
    "-1/2",
    "1/2/3",
    "/",
    "sbatch",
    "",
    *ABSURD,
)


def tables_of_variants(rng: Random, bases: Bases) -> ChangedFiles:
    """CSV files of variants and duty cycles."""
    name = rng.choice(("a table", "duty of a table"))
    file, rows = ("variants.csv", CSV) if name == "a table" else ("spectrum.csv", SPECTRUM)
    files = {"case.toml": bases.case, "study.toml": {"case": "case.toml", **STUDIES[name]}, file: rows}
    words = rng.choice((("--check",), ("--jobs", "1")))
    changes = tuple(
        damaged(rng, file) if rng.random() < 0.3 else cells(rng, file, rows)
        for _ in range(rng.choice((1, 1, 2, 3)))
    )
    if any("3000" in change.what for change in changes):  # rows that are good take their time
        words = ("--check",)
    return ChangedFiles("CSV", name, Bundle(("study", "study.toml", "-o", "out", *words), files), changes)


VARY = {CLEARANCE: "0 um .. 60 um"}
SEARCH = {"starts": 1, "iterations": 2, "method": "slsqp", "seed": 0, "tolerance": 0.01, "verified": False}
OPTIMA: dict[str, Raw] = {
    "plain": {"vary": VARY, "maximise": {"output": "life_L10 [h]"}, "search": SEARCH},
    "worst": {
        "set": {"accuracy.slices": 8}, "vary": {**VARY, "bearing.roller.drop": "log 1 um .. 20 um"},
        "minimise": {"output": "peak_pressure.inner [MPa]", "over": "worst", "scale": "linear"},
        "over": {LOAD: ["1 kN", "2 kN"]}, "constrain": {"cage_slip": "<= 50 %"}, "search": SEARCH,
        "verify": [{"accuracy.slices": 12}],
    },
    "duty": {
        "vary": VARY, "maximise": {"output": "duty_life [h]"}, "duty": DUTY, "search": SEARCH,
        "constrain": {"cage_slip": "0 % .. 60 %"},
    },
    "surrogate": {
        "vary": VARY, "maximise": {"output": "life_L10 [h]"}, "surrogate": {"accuracy.slices": 6},
        "search": {**SEARCH, "verified": True}, "verify": [{"accuracy.slices": 10}],
    },
    "cobyqa": {"vary": VARY, "maximise": {"output": "life_L10 [h]"}, "search": {**SEARCH,
    "method": "cobyqa"}},
}  # fmt: skip


def optimisation(rng: Random, bases: Bases) -> ChangedFiles:
    """A search of few designs."""
    name = rng.choice([*OPTIMA])
    raw = {"case": "case.toml", **deepcopy(OPTIMA[name])}
    files = {"case.toml": bases.case, "best.toml": raw, "spectrum.csv": SPECTRUM}
    bundle = Bundle(("optimise", "best.toml", "-o", "out", "--jobs", "1"), files)
    return ChangedFiles("optimise", name, bundle, _changes(rng, "best.toml", raw))


MAPPED = {  # key to usual ends and unit
    LOAD: (("500", "1000", "20000", "5"), "N"), SPEED: (("0", "10", "1000", "3000"), "rpm"),
    CLEARANCE: (("-20", "0", "20", "60"), "um"), "bearing.rollers": (("14", "12", "10", "16"), ""),
    "operation.misalignment": (("0", "1", "4", "-4"), "arcmin"), "operation.inner_speed": (("1", "3000",
    "9e4"), "rpm"), "lubricant.inlet_temperature": (("-20", "20", "70", "200"), "degC"),
    "bearing.roller.drop": (("1", "9", "40"), "um"), "operation.load_direction": (("0", "90", "360"), "deg"),
    "lubricant.oil_fraction": (("0", "0.02", "1"), ""),
}  # fmt: skip
ENDS = ("0", "1", "5", "-1", "1e308", "1e-320", "nan", "inf", "1e400", "1e6", "", "٣")
COUNTS = (
    "1",
    "0",
    "-1",
    "1.5",
    "2.0",
    "1e1",
    "nan",
    "",
    "9999999",
    "99999999999",
    "3,3",
    "٣",
    " ",
    "3 ",
    "0x3",
)


def mapped(rng: Random, bases: Bases) -> ChangedFiles:
    """A map of few points, or a branch that is followed."""
    absurd = rng.random() < 0.5
    axes = [
        part
        for _ in range(rng.choices((1, 2, 3, 4), weights=(8, 4, 1, 1))[0])
        for part in ("--over", _axis(rng, absurd))
    ]
    of = ",".join(rng.choice(OUTPUTS if absurd else GOOD) for _ in range(rng.choice((1, 1, 2))))
    form = rng.choices(("svg", "png", "pdf", rng.choice(ABSURD)), weights=(6, 1, 1, absurd))[0]
    settings = (
        "--set",
        rng.choice(("accuracy.slices=8", "operation.tilt=free", "lubricant.viscosity=2 Pa s")),
    )
    words = ("map", "case.toml", *axes, "--of", of, "-o", "m.csv", "--format", form, *settings)
    changes = tuple(
        word(rng, rng.randrange(2, len(words)), ABSURD) for _ in range(absurd and rng.choice((0, 1)))
    )
    return ChangedFiles(
        "map", " ".join(each[:60] for each in words), Bundle(words, {"case.toml": bases.case}), changes
    )


GOOD = (
    "life_L10 [h]",
    "cage_slip [%]",
    "max_roller_load [N]",
    "stiffness_zz",
    "rigid.life_L10 [Mrev]",
    "loaded_rollers",
)


def _axis(rng: Random, absurd: bool) -> str:
    key = rng.choice([*MAPPED])
    usual, unit = MAPPED[key]
    first, last = rng.sample(usual, 2)
    count = rng.choice((",2", ",2", ",3", ",4", ""))
    if absurd:
        first, count = rng.choice((first, *ENDS)), rng.choice((",2", *(f",{each}" for each in COUNTS)))
        unit = rng.choice((unit, unit, unit, "mm", ""))
    return f"{key}={rng.choice(('', '', 'log '))}{first} {unit}..{last} {unit}{count}"


PROFILE = {
    "jobs": 2, "cores": 1, "memory": "4 GB", "walltime": "01:00:00", "queue": "short", "account": "bearings",
    "interface": "lo", "prologue": ["true"], "directives": ["--constraint=x"], "logs": "logs",
}  # fmt: skip


def profile(rng: Random, bases: Bases) -> ChangedFiles:
    """A profile of a cluster; there is no SLURM, which is to be said in a line."""
    files = {
        "case.toml": bases.case,
        "study.toml": {"case": "case.toml", **STUDIES["crossed"]},
        "site.toml": PROFILE,
    }
    bundle = Bundle(("study", "study.toml", "-o", "out", "--slurm", "site.toml"), files)
    return ChangedFiles("SLURM", "profile", bundle, _changes(rng, "site.toml", PROFILE))


def _changes(rng: Random, file: str, raw: Raw) -> tuple[Change, ...]:
    count = rng.choices((1, 2, 3), weights=(6, 2, 1))[0]
    changes = [table(rng, file, raw, _hints(raw)) for _ in range(count)]
    if rng.random() < 0.12:
        changes[-1] = damaged(rng, file)
    return tuple(changes)


def _hints(raw: Raw) -> dict[Place, tuple[str, ...]]:
    """Texts that nearly mean something, by the places of the values."""
    found = dict[Place, tuple[str, ...]]()
    for name, value in raw.items():
        for key in value if isinstance(value, dict) else ():
            hints = HINTS.get(key, HINTS.get(name, ()))
            if hints and not isinstance(value[key], int):
                found[(name, key)] = hints
    return found
