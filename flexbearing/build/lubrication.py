"""How the contacts of a case are lubricated: oil, laws, roughness against the film."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

import quasidynamic as qd
from quasidynamic.contact.film import ELLIPTIC_FORMULAS, composite_roughness
from quasidynamic.contact.lubrication import BallLubrication
from quasidynamic.contact.traction import BALL_ROLLING_LAWS, ROLLING_LAWS, TractionLaw, in_any_contact
from quasidynamic.parts.oil_properties import two_point_oil

if TYPE_CHECKING:  # checking rollers loads no balls, and the other way round
    from flexbearing.case.balls.angular_contact import FastCase
    from flexbearing.case.roller import Case
    from flexbearing.case.tapered import TaperedCase

    Lubricated = Case | FastCase | TaperedCase


def lubrication(case: "Case | TaperedCase") -> qd.Lubrication:
    """Oil of a case with rollers and the laws it follows."""
    assert case.lubricant  # checked on reading
    return qd.Lubrication(film=qd.FORMULAS[case.lubricant.film], **_laws(case))


def ball_lubrication(case: "FastCase") -> BallLubrication | None:
    """Oil of a case whose balls it moves, and the laws it follows; None where it does not."""
    if case.operation.control != "oil":
        return None
    assert case.lubricant  # checked on reading
    laws: dict[str, Any] = _laws(case) | {"rolling": BALL_ROLLING_LAWS[case.lubricant.rolling]}
    return BallLubrication(film=ELLIPTIC_FORMULAS[case.lubricant.film], **laws)


def _laws(case: "Lubricated") -> dict[str, Any]:
    """Oil and laws, but for that of the film."""
    lubricant: Any = case.lubricant
    traction = _FLUIDS[lubricant.traction](case)
    if lubricant.mixed is not None:
        from flexbearing.build.rough_surfaces import mixed

        rough = roughness(case)
        assert rough is not None  # checked on reading
        traction = mixed(lubricant.mixed, rough, traction)
    return {
        "oil": oil(case),
        "oil_fraction": lubricant.oil_fraction,
        "traction": traction,
        "rolling": ROLLING_LAWS[lubricant.rolling],
        "inlet_heating": lubricant.inlet_heating,
        "inlet_length": lubricant.inlet_length,
        "drag_coefficient": lubricant.drag_coefficient,
        "churning_gap": lubricant.churning_gap,
    }


def oil(case: "Lubricated") -> qd.Lubricant:
    """The oil at the inlet temperature, with its notes."""
    # Which values are there depends on how the oil is described, checked on reading.
    lubricant: Any = case.lubricant
    if lubricant.oil is not None:
        return qd.oil_at(lubricant.oil, lubricant.inlet_temperature)
    if lubricant.data_sheet is not None:
        return qd.oil_at(_data_sheet_oil(lubricant.data_sheet), lubricant.inlet_temperature)
    return qd.Lubricant(
        temperature=lubricant.inlet_temperature,
        viscosity=lubricant.viscosity,
        pressure_viscosity=lubricant.pressure_viscosity,
        temperature_viscosity=lubricant.temperature_viscosity,
        conductivity=lubricant.conductivity,
        density=lubricant.density,
    )


def roughness(case: "Lubricated") -> NDArray | None:
    """Composite roughness (2) of inner and outer contact [m]; None when the case does not give it."""
    surfaces: Any = case.bearing.roughness
    if surfaces is None:
        return None
    element = surfaces.roller if hasattr(surfaces, "roller") else surfaces.ball
    return composite_roughness(element, [surfaces.inner_raceway, surfaces.outer_raceway])


def oil_name(case: "Lubricated") -> str:
    """What the oil is called in notes."""
    lubricant: Any = case.lubricant
    return lubricant.oil or (lubricant.data_sheet.name if lubricant.data_sheet else "the given oil")


def _data_sheet_oil(sheet):
    alphas = [(sheet.cold_temperature, sheet.cold_pressure_viscosity)]
    if sheet.hot_pressure_viscosity is not None:
        alphas.append((sheet.hot_temperature, sheet.hot_pressure_viscosity))
    return two_point_oil(
        sheet.name,
        viscosities=(
            (sheet.cold_temperature, sheet.cold_viscosity),
            (sheet.hot_temperature, sheet.hot_viscosity),
        ),
        density=sheet.density,
        pressure_viscosities=tuple(alphas),
        conductivity=sheet.conductivity,
        source="data sheet of the case",
    )


def _eyring(case: "Lubricated") -> Callable[..., TractionLaw]:
    lubricant: Any = case.lubricant
    stress = lubricant.eyring_stress or 2 * lubricant.limiting_ratio / oil(case).pressure_viscosity
    return partial(
        qd.Eyring,
        limiting_ratio=lubricant.limiting_ratio,
        eyring_stress=stress,
        film_heating=lubricant.film_heating,
    )


def _bair_winer(case: "Lubricated") -> Callable[..., TractionLaw]:
    lubricant: Any = case.lubricant
    return partial(qd.BairWiner, limiting_ratio=lubricant.limiting_ratio, film_heating=lubricant.film_heating)


def _adore(case: "Lubricated") -> Callable[..., TractionLaw]:
    from quasidynamic.contact.traction.adore import ADORE_OILS

    lubricant: Any = case.lubricant
    return partial(
        qd.AdoreType, rheology=ADORE_OILS[lubricant.adore_oil], limiting_ratio=lubricant.limiting_ratio
    )


def _four_point(case: "Lubricated") -> Callable[..., TractionLaw]:
    lubricant: Any = case.lubricant
    points = lubricant.traction_curve
    curve = qd.FourPointCurve.through(
        at_rest=points.at_rest, peak=points.peak, peak_slip=points.peak_slip, far=points.far
    )
    return partial(in_any_contact, curve)


_FLUIDS: dict[str, Callable[[Any], Callable[..., TractionLaw]]] = {
    "4109": lambda case: qd.Regression4109,
    "eyring": _eyring,
    "bair-winer": _bair_winer,
    "adore": _adore,
    "four-point": _four_point,
}
