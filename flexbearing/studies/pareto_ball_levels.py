"""Levels of cost of a ball bearing: how its contacts slide or stick, and on how many cells.

Loads, life and stiffness are solved to rounding errors on every level; the friction torque is what changes.
"""

from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.studies.pareto_levels import Level

BallCase = FastCase | FourPointCase
CELLS = ((12, 24), (20, 40), (40, 80))
FINEST = 80, 160
CONTROLS = {"coulomb": "race control by friction", "outer": "outer race control"}


def ladder(case: BallCase) -> tuple[Level, ...]:
    """All levels but the richest, in an order of growing cost by kind."""
    rolling = [_rolling(model, cells) for model in ("fastsim", "kalker") for cells in CELLS]
    return (
        Level("full sliding", ("friction.model=full_sliding", *_no_cells(case)), physics=True),
        *rolling,
        *_controls(case),
    )


def _rolling(model: str, cells: tuple[int, int]) -> Level:
    along, across = cells
    return Level(
        f"{model} {along}x{across}", (f"friction.model={model}", f"friction.cells=[{along}, {across}]")
    )


def _no_cells(case: BallCase) -> tuple[str, ...]:
    """Settings that take out what full sliding does not have."""
    return tuple(
        f"friction.{key}="
        for key in ("cells", "interface_compliance", "contact_pressure")
        if key in case.friction.model_fields_set
    )


def _controls(case: BallCase) -> list[Level]:
    """The other condition for the motion of fast balls, with contacts as in the reference but fewer cells."""
    if not isinstance(case, FastCase):
        return []
    other = "outer" if case.operation.control == "coulomb" else "coulomb"
    settings = (f"operation.control={other}", *_rolling("kalker", CELLS[1]).settings)
    return [Level(CONTROLS[other], settings, physics=True)]


REFERENCE = _rolling("kalker", FINEST)._replace(name="reference")
