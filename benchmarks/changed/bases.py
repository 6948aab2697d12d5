"""Good files that commands made: a finished study, results, a model, and the case that they began with."""

import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.mutated_cases import CONFIGS, based_on, written

RIGID = ("accuracy.slices=8",)
OVER = {"operation.radial_load": ["1 kN", "5 kN"], "operation.inner_speed": "1000 rpm .. 3000 rpm, 2"}
COLLECT = {"life": "life_L10 [h]", "load": "max_roller_load [N]", "slip": "cage_slip [%]"}
STUDY = {"case": "case.toml", "over": OVER, "collect": COLLECT}
DRAWN = {
    "case": "case.toml", "collect": COLLECT,
    "sample": {"count": 4, "method": "latin_hypercube", "operation.radial_load": "uniform 1 kN, 3 kN",
               "bearing.clearance": "normal 40 um, 2 um"},
    "duty": {"time": ["30 %", "70 %"], "operation.inner_speed": ["1000 rpm", "2000 rpm"]},
}  # fmt: skip


@dataclass(frozen=True)
class Bases:
    """Files by their names, and the cases of rollers and of balls as tables."""

    files: dict[str, bytes]
    case: dict[str, Any]
    ball: dict[str, Any]


def made(folder: Path) -> Bases:
    """Make them in a folder."""
    case, ball = based_on("nu209", RIGID), tomllib.loads((CONFIGS / "harris218.toml").read_text())
    texts = {"case.toml": case, "ball.toml": ball, "study.toml": STUDY, "drawn.toml": DRAWN}
    for name, raw in texts.items():
        (folder / name).write_text(written(raw))
    for words in (
        ("study", "study.toml", "--jobs", "1"),
        ("study", "drawn.toml", "--jobs", "1"),
        ("run", "case.toml", "-o", "roller.h5"),
        ("run", "ball.toml", "-o", "ball.h5"),
    ):
        subprocess.run(
            [sys.executable, "-m", "flexbearing", *words], cwd=folder, check=True, capture_output=True
        )
    outputs = [*folder.glob("*.h5"), *(folder / "results").iterdir()]
    return Bases({path.name: path.read_bytes() for path in outputs}, case, ball)
