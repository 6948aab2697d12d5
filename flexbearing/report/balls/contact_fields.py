"""Cells of the contacts of balls, as a result holds them for pictures."""

from __future__ import annotations

from collections.abc import Mapping
from math import floor, log10
from typing import Any, NamedTuple

import numpy as np

from flexbearing.results import BadResult, Result

MODELS = {  # friction.model, for people
    "full_sliding": "full sliding",
    "fastsim": "FASTSIM (springs)",
    "kalker": "Kalker (half-spaces)",
}
SPINS = {"centre": "spin of the centre", "local": "local spin"}
_CELLS = ("field_across", "field_along", "field_pressure", "field_stick")
_VECTORS = ("shear_across", "shear_along", "slip_across", "slip_along")


class DrawnContact(NamedTuple):
    """One loaded contact: arrays over its cells, vectors as across and along the rolling direction."""

    caption: str  # load, angle, largest pressure
    semi_axes: tuple[float, float]  # [m] of Hertz' ellipse, across and along
    places: np.ndarray  # (2, n, m) [m] centres of the cells
    pressure: np.ndarray  # (n, m) [Pa]
    shear: np.ndarray  # (2, n, m) [Pa] on the ball
    slip: np.ndarray  # (2, n, m) [m/s] ball minus race
    stick: np.ndarray  # (n, m) 1 where the surfaces stick, else 0

    @property
    def touching(self) -> np.ndarray:
        """Cells in contact (n, m)."""
        return self.pressure > 0


Place = tuple[str, str]  # "diagonal 1" or nothing, "inner race" or "outer race"


class DrawnBall(NamedTuple):
    """A ball whose cells are stored."""

    number: int
    torque: str  # with what it is of, its error and its unit
    contacts: dict[Place, DrawnContact]  # those that carry load

    @property
    def cells(self) -> str:
        """Cells of each contact."""
        shapes = {contact.pressure.shape for contact in self.contacts.values()}
        return "".join(f"{across} cells across, {along} along" for across, along in shapes)


def drawn_contact(
    values: Mapping[str, Any], contact: tuple[int, ...], field: tuple[int, ...]
) -> DrawnContact:
    """Take a contact from the arrays of a result."""
    across, along, pressure, stick = (values[name][field] for name in _CELLS)
    shear_across, shear_along, slip_across, slip_along = (values[name][field] for name in _VECTORS)
    angle = np.degrees(values["contact_angle"][contact])
    return DrawnContact(
        f"{values['contact_load'][contact]:,.0f} N, {angle:.2f}°, "
        f"{1e-6 * values['peak_pressure'][contact]:,.0f} MPa",
        (float(values["semi_axis_across"][contact]), float(values["semi_axis_along"][contact])),
        np.array([across, along]),
        pressure,
        np.array([shear_across, shear_along]),
        np.array([slip_across, slip_along]),
        stick,
    )


def friction_of(result: Result) -> str:
    """Friction model of a result, and what makes slip across in it."""
    friction = result.attributes["case_si"]["friction"]
    return f"{MODELS[friction['model']]}, {SPINS[friction['spin']]}"


def torque_words(what: str, torque: float, error: float | None) -> str:
    """A torque [N m], with its error by the cells as far as that is reported where there is one."""
    if not error:
        return f"{what} {torque:.4g} N m"
    digits = max(0, 1 - floor(log10(error)))
    return f"{what} {torque:.{digits}f} ± {error:.{digits}f} N m"


def require_cells(result: Result, values: Mapping[str, Any]) -> None:
    """Raise where a result has no cells of contacts.

    Raises `BadResult` naming the file, and what is not stored.
    """
    missing = [name for name in ("field_ball", *_CELLS, *_VECTORS) if name not in values]
    if missing:
        raise BadResult(
            f"{result.place}: it holds no cells of contacts ({missing[0]} is not stored): there is nothing "
            "to draw of them."
        )
