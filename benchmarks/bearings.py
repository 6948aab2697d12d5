"""The bearing that benchmarks vary: 30 rollers of 5 mm under 19.6 kN at 38 000 rpm."""

from dataclasses import replace

import numpy as np

from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from quasidynamic import RollerBearing, Straight

RPM = 2 * np.pi / 60
CASE = "configs/mao2016.toml"


def paper_bearing() -> RollerBearing:
    """Bearing of the main case with straight rollers and a constant drag: the one of the hard cases.

    Oil fraction times drag coefficient times the part of a roller that the cage leaves free is 0.169.
    """
    model = roller_bearing.bearing(read_case(CASE))
    roller = replace(model.bearing.roller, profile=Straight())
    lubrication = replace(model.lubrication, oil_fraction=0.338, drag_coefficient=1.0)
    return replace(model, bearing=replace(model.bearing, roller=roller), lubrication=lubrication)


def changed(model: RollerBearing, **changes) -> RollerBearing:
    """The same bearing with other values of bearing, operation or lubrication, wherever a name belongs."""
    for part in ("bearing", "operation", "lubrication"):
        whole = getattr(model, part)
        own = {name: value for name, value in changes.items() if hasattr(whole, name)}
        model = replace(model, **{part: replace(whole, **own)})
    return model
