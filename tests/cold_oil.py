"""The bearing of Mao, Wang and Zhang (2016) with cold ISO VG 100, which has several equilibria."""

import re
from pathlib import Path

from flexbearing.api import read_case
from flexbearing.build import roller_bearing

PAPER = Path(__file__).parents[1] / "configs" / "mao2016.toml"
RIGID = ("outer.kind=rigid", "inner.kind=rigid")


def cold_case(folder, name="cold.toml"):
    """A case file of the bearing without temperatures, so that its clearance and sizes are as given."""
    text = re.sub(r"\[operation\.temperatures\].*?(?=\n\[)", "", PAPER.read_text(), flags=re.DOTALL)
    text = text.replace('"operation.temperatures.reference",', "")
    path = Path(folder) / name
    path.write_text(text)
    return path


def settings(temperature):
    """At an inlet temperature [degC]: 2 kN, 3000 rpm, 3 % of oil."""
    return (
        "lubricant.oil=ISO VG 100",
        f"lubricant.inlet_temperature={temperature} degC",
        "operation.radial_load=2 kN",
        "operation.inner_speed=3000 rpm",
        "lubricant.oil_fraction=0.03",
    )


def cold_bearing(temperature, folder):
    """The same bearing between rigid raceways, without a result file."""
    return roller_bearing.bearing(read_case(cold_case(folder), [*RIGID, *settings(temperature)]))
