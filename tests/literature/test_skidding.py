"""What measurements of skidding in cylindrical roller bearings say of its sign.

Smith (1962), Boness (1970), Harris and Aaronson (1967): slip grows with oil flow, and with speed at too
little load; preload ends it. Guo and Keller, Tribology International (2020), in a wind turbine gearbox: up to
60 % of the cage at low wind and cold oil, less as both grow. The numbers are of other bearings: signs only.
"""

from itertools import pairwise

import pytest

import flexbearing
from tests.places import CONFIGS

FIELD_SLIP = 60.0  # [%] of cage and rollers in the loaded zone
GEARBOX_OIL = {  # ISO VG 320 instead of the oil of the case, "__" for a dot
    **{f"lubricant__{key}": "" for key in (
        "viscosity", "pressure_viscosity", "temperature_viscosity", "density", "conductivity",
    )},
    "lubricant__data_sheet__cold_temperature": "40 degC",
    "lubricant__data_sheet__cold_viscosity": "320 mm^2/s",
    "lubricant__data_sheet__hot_temperature": "100 degC",
    "lubricant__data_sheet__hot_viscosity": "24 mm^2/s",
    "lubricant__data_sheet__cold_pressure_viscosity": "20 1/GPa",
    "lubricant__data_sheet__density": "890 kg/m^3",
    "lubricant__data_sheet__conductivity": "0.14 W/(m K)",
}  # fmt: skip


def slips(key, values, **others):
    """Cage slip [%] of the paper's bearing between rigid rings."""
    rigid = {"outer.kind": "rigid", "inner.kind": "rigid"}
    for value in values:
        result = flexbearing.run(CONFIGS / "mao2016.toml", {**rigid, **others, key: value})
        yield result.summary()["rigid"]["cage_slip_percent"]


LIGHT = {"operation.radial_load": "500 N"}


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("key", "values", "others"),
    [
        ("lubricant.oil_fraction", (0.1, 0.3), {}),
        ("operation.inner_speed", ("10000 rpm", "30000 rpm"), LIGHT),
        ("operation.radial_load", ("8 kN", "500 N"), {}),
        ("bearing.clearance", ("-20 um", "20 um"), LIGHT),
    ],
    ids=["oil", "speed", "load", "preload"],
)
def test_slip_grows(key, values, others):
    assert all(few < many for few, many in pairwise(slips(key, values, **others)))
