"""States of the bearing as the arrays of a result file."""

from dataclasses import asdict, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexbearing.coupled.initial_state import flat
from flexbearing.coupling import Iteration
from flexbearing.rings.raceways import CondensedRings
from quasidynamic import Equilibrium
from quasidynamic.balance.rollers.unknowns import Unknowns

MREV = 1e6  # revolutions
UNLOADED = 1e-3  # [N] below it no film is reported


def state(found: Equilibrium) -> dict[str, ArrayLike]:
    """Datasets of any state."""
    inner, outer = found.forces[..., 0]
    films = np.where(found.forces[..., 0] > UNLOADED, found.film, 0.0)
    deviation = found.deviation_along_rollers
    return {
        "inner_load": inner,
        "outer_load": outer,
        "inner_slice_load": found.slice_loads[0],
        "outer_slice_load": found.slice_loads[1],
        "inner_deviation": deviation[0],
        "outer_deviation": deviation[1],
        "roller_tilt": found.roller_tilt,
        "roller_speed": found.roller_speed,
        "inner_film": films[0],
        "outer_film": films[1],
        "inner_sliding": found.sliding[0],
        "outer_sliding": found.sliding[1],
        "inner_traction": found.traction[0],
        "outer_traction": found.traction[1],
        "cage_force": found.cage_force,
        "cage_speed": found.cage_speed,
        "cage_slip": found.cage_slip,
        "ring_displacement": found.ring_displacement,
        "ring_tilt": found.ring_tilt,
    }


def iteration(step: Iteration[Equilibrium], seconds: float) -> dict[str, ArrayLike]:
    """Datasets of an iteration of the coupling."""
    return state(step.state) | {
        "load_change": step.load_change,
        "mismatch": step.mismatch,
        "residual": step.state.residual,
        "seconds": seconds,
    }


def block(
    found: Equilibrium, rings: CondensedRings, roughness: NDArray | None = None
) -> dict[str, ArrayLike]:
    """Datasets of an end state; film ratios where the composite roughness (2) [m] is known."""
    bearing, whole = found.balance.roller.bearing, supported(found, rings).tangent
    return (
        state(found)
        | {
            "roller_azimuth": bearing.azimuths,
            "slice_position": found.slice_positions,
            "life_L10": found.life * MREV,
            "load_direction": _load_direction(found),
            "stiffness": between_raceways(found, rings).tangent.radial_stiffness,
            "stiffness_matrix": whole.stiffness,
            "compliance_matrix": whole.compliance,
            "total_stiffness": whole.radial_stiffness,
            "support_translation": rings.translation(found.forces),
            "driving_torque": found.driving_torque,
            "driving_power": found.driving_power,
            "ring_moment": found.ring_moment,
            "peak_pressure": found.peak_pressure,
            "minimum_film": smallest_film(found),
            "unknowns": flat(found),
        }
        | _cage(found)
        | {f"loss_{cause}": power for cause, power in asdict(found.losses).items()}
        | ({} if roughness is None else _film_ratios(found, roughness))
    )


def _cage(found: Equilibrium) -> dict[str, ArrayLike]:
    """Place of a cage that floats, and of the rollers in pockets of known clearance."""
    places: dict[str, ArrayLike] = {}
    if found.floating is not None:
        places["cage_offset"] = found.floating.offset[0]
    if found.pocket_displacement is not None:
        places["pocket_displacement"] = found.pocket_displacement
    return places


def supported(found: Equilibrium, rings: CondensedRings) -> Equilibrium:
    """The same state, its ring displacement counted from shaft ends to base: supports yield with the rest.

    Between raceways freed of their translation, answers and loads are not of one kind, and the tangent
    is not symmetric; from base to shaft ends it is.
    """
    if rings.rigid:
        return found
    balance, unknowns = found.balance, found.unknowns
    moved = rings.translation(found.forces)  # (inner and outer raceway, y and z)
    direction = np.array([np.sin(balance.roller.bearing.azimuths), np.cos(balance.roller.bearing.azimuths)])
    deviation, ring = unknowns.deviation.copy(), unknowns.ring.copy()
    deviation[:, 0, 0] += moved @ direction
    ring[:2, 0, 0] += moved[1] - moved[0]
    compliance = [None if raceway is None else raceway.absolute for raceway in rings.raceways]
    return _yielding(found, compliance, unknowns._replace(ring=ring, deviation=deviation))


def between_raceways(found: Equilibrium, rings: CondensedRings) -> Equilibrium:
    """The same state between raceways that yield, also where it was found between those of a given shape."""
    if rings.rigid or found.balance.layout.elastic_raceways:
        return found
    compliance = [None if raceway is None else raceway.relative for raceway in rings.raceways]
    return _yielding(found, compliance, found.unknowns)


def _yielding(found: Equilibrium, compliance: list[NDArray | None], unknowns: Unknowns) -> Equilibrium:
    """A state with other unknowns in equations that know how raceways (Z, M, Z, M) yield."""
    balance = found.balance
    size = balance.layout.rollers * balance.roller.axial_modes
    square = [None if matrix is None else matrix.reshape(size, size) for matrix in compliance]
    whole = replace(balance, compliance=(square[0], square[1]))
    return replace(found, balance=whole, scaled=whole.pack(unknowns)[0])


def smallest_film(found: Equilibrium) -> NDArray:
    """Smallest film (2) of the loaded contacts of each raceway [m]; 0 where none is loaded."""
    loaded = found.forces[..., 0] > UNLOADED
    smallest = np.where(loaded, found.film, np.inf).min(axis=1)
    return np.where(np.isfinite(smallest), smallest, 0.0)


def _film_ratios(found: Equilibrium, roughness: NDArray) -> dict[str, ArrayLike]:
    films = np.where(found.forces[..., 0] > UNLOADED, found.film, 0.0)
    inner, outer = films / roughness[:, None]
    return {"inner_film_ratio": inner, "outer_film_ratio": outer}


def _load_direction(found: Equilibrium) -> float:
    """Azimuth of the radial load, 0 when there is none [rad]."""
    points = found.balance.points
    return float(np.arctan2(points.load_y[0, 0], points.load_z[0, 0]))
