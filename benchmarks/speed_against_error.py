"""Time against error of every model choice on five bearings: `python -m benchmarks.speed_against_error`.

Runs `flexbearing pareto` on each, one thread, with tables and pictures in docs/images, and fills the tables
of `docs/howto/speed-against-error.md`. With names only these are run. `--page` computes nothing: page and
pictures are made from the stored tables.
"""

import argparse
import csv
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.machine import describe
from benchmarks.page import DOCS, fill
from flexbearing.report.studies.pareto_table import (
    OUTPUTS,
    TARGETS,
    TIMES,
    TOLD,
    Measured,
    Study,
    cheapest,
    head,
    percent,
    picked_row,
    row,
)

IMAGES, PAGE = DOCS / "images", DOCS / "howto" / "speed-against-error.md"
THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "FLEXBEARING_THREADS": "1"}


@dataclass(frozen=True)
class Bearing:
    """One of the five."""

    title: str
    case: str
    settings: tuple[str, ...] = ()
    solid: bool = False  # whether its parts are full solids as well

    def command(self, name: str) -> str:
        """As typed."""
        quoted = (f"'{setting}'" if '"' in setting else f'"{setting}"' for setting in self.settings)
        return " ".join(
            (
                f"flexbearing pareto {self.case} -o docs/images --name {name}",
                *(f"--set {setting}" for setting in quoted),
                *["--solid"] * self.solid,
            )
        )


RIM = (
    "outer.kind=ring", "outer.thickness=8 mm", "outer.width=19 mm", "outer.support=planet",
    'outer.tooth_azimuths=["90 deg", "270 deg"]', 'outer.tooth_radial=["-1 kN", "-1 kN"]',
    'outer.tooth_tangential=["2 kN", "-2 kN"]', "title=NU 209 in the rim of a planet gear, 8 mm",
)  # fmt: skip
BEARINGS = {
    "mao2016": Bearing("squirrel cage", "configs/mao2016.toml", solid=True),
    "nu209_fits": Bearing("NU 209 with fits", "configs/nu209_fits.toml"),
    "nu210": Bearing("catalogue NU 210", "configs/catalogue/nu210.toml"),
    "planet": Bearing("planet", "configs/nu209.toml", RIM),
    "b7208": Bearing("ball 7208", "configs/catalogue/7208.toml"),
}


def stored(path: Path, title: str = "") -> Study:
    """A study from its CSV."""
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    levels = {kind: [_level(one) for one in rows if one["kind"] == kind] for kind in ("reference", "physics")}
    (reference,) = levels["reference"]
    all_levels = tuple(_level(one) for one in rows if one["kind"] != "reference")
    return Study(title=title, reference=reference, levels=all_levels, left_out=())


def _level(cells: dict[str, str]) -> Measured:
    def numbers(begin: str, names: Iterator[str]) -> dict[str, float]:
        return {name: float(cells[begin.format(name)]) for name in names if cells.get(begin.format(name))}

    return Measured(
        name=cells["level"],
        settings=(),
        times=numbers("{}_s", iter(TIMES)),
        errors=numbers("error_{}", iter(OUTPUTS)),
        estimated=numbers("told_{}", iter(TOLD)),
        message=cells["message"],
        physics=cells["kind"] == "physics",
        picked=cells["picked"],
    )


def page_tables(folder: Path = IMAGES) -> dict[str, str]:
    """Every table of the page by its name."""
    studies = {name: stored(folder / f"pareto_{name}.csv") for name in BEARINGS}
    return {"cheapest": _cheapest(studies), "targets": _targets(studies)}


def _cheapest(studies: dict[str, Study]) -> str:
    lines = ["| bearing | rings | " + " | ".join(f"within {percent(target)}" for target in TARGETS) + " |"]
    lines.append("|---" * (2 + len(TARGETS)) + "|")
    for name, study in studies.items():
        for when in TIMES:
            best = (cheapest(study, when, target, study.outputs) for target in TARGETS)
            cells = (f"{level.name}, {level.times[when]:.2g} s" if level else "none" for level in best)
            lines.append(f"| {BEARINGS[name].title} | {when} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _targets(studies: dict[str, Study]) -> str:
    lines = [
        "| bearing | target | cold [s] | cached [s] | estimated, true error of loads [%] | of life [%] |"
    ]
    lines.append("|---|---|---:|---:|---|---|")
    for name, study in studies.items():
        for level in study.numerical:
            if level.picked:
                target, _, *cells = picked_row(level).strip("| ").split(" | ")
                times = [f"{level.times[when]:.2g}" for when in TIMES]
                lines.append("| " + " | ".join([BEARINGS[name].title, target, *times, *cells]) + " |")
    return "\n".join(lines)


def _levels(study: Study) -> str:
    outputs = study.outputs
    lines = [head("numerical choice", outputs)]
    lines += [row(level, outputs) for level in (*study.numerical, study.reference)]
    if study.other_physics:
        lines += ["", head("other physics: difference instead of error", outputs)]
        lines += [row(level, outputs) for level in study.other_physics]
    failed = [f"- {level.name}: {level.message}" for level in study.levels if not level.errors]
    return "\n".join(lines + (["", "Not computed:", "", *failed] if failed else []))


def main() -> None:
    from flexbearing.report.picture import picture_bytes
    from flexbearing.report.studies.pareto_table import draw_pareto
    from flexbearing.studies.pareto import pareto
    from flexbearing.studies.pareto_files import destinations, store

    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", choices=[*BEARINGS, []])
    parser.add_argument("--page", action="store_true", help="from the stored tables")
    asked = parser.parse_args()
    os.environ.update(THREAD)  # of the workers
    print(f"{describe()}, one thread, nice {os.nice(0)}")
    for name in () if asked.page else asked.names or BEARINGS:
        bearing = BEARINGS[name]
        csv_path, picture = destinations(IMAGES, name, ())
        print(f"\n{bearing.command(name)}", flush=True)
        study = pareto(bearing.case, bearing.settings, solid=bearing.solid, tell=_tell)
        store(study, csv_path, picture)
        print(_levels(stored(csv_path)), flush=True)
    for name in BEARINGS if asked.page else ():
        csv_path, picture = destinations(IMAGES, name, ())
        picture.write_bytes(picture_bytes(draw_pareto(stored(csv_path, BEARINGS[name].title)), dpi=130))
    if all((IMAGES / f"pareto_{name}.csv").exists() for name in BEARINGS):
        fill(PAGE, page_tables())


def _tell(level: Measured) -> None:
    sys.stderr.write(f"{level.name}: {level.message or level.times}\n")


if __name__ == "__main__":
    main()
