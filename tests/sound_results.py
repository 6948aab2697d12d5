"""What must hold of every result that claims to have converged, whatever bearing it is about."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from flexbearing.build import roller_bearing
from flexbearing.case import understood
from flexbearing.results.checks import NotInLayout, require_finite

LOST = 1e-6  # of the largest force or power: far above the tolerances of the solvers
LOSSES = ("sliding", "rolling", "drag", "pocket", "land", "churning")
FROM_ZERO = (
    "inner_load", "outer_load", "contact_load", "inner_slice_load", "outer_slice_load", "inner_film",
    "outer_film",
    "peak_pressure", "minimum_film", "life_L10", "modified_life", "semi_axis_across", "semi_axis_along",
    "power_loss",
    "friction_heat", "hysteresis_torque", "flange_force", "flange_power", "skew_power",
)  # fmt: skip


def faults(result: Any) -> list[str]:
    """What is wrong with a converged result; empty for one that is sound or did not converge."""
    if result.attributes["status"] != "converged":
        return []
    layout = result.family.layout()
    known = layout.datasets("block")
    found: list[str] = []
    lost = max(LOST, (_case(result).get("coupling") or {}).get("tolerance", 0.0))  # as loose as was asked for
    for name in ("rigid", "flexible"):
        block = getattr(result, name)
        for key, array in block.items():
            try:
                require_finite(known[key], array, name)
            except NotInLayout as problem:
                found.append(str(problem))
        found += [
            f"{name}: {problem}"
            for problem in (*_signs(block), *_losses(block, lost), *_balance(result, block, lost))
        ]
    if not result.rigid and not result.flexible:
        found.append("converged without a block")
    return found


def _signs(block: Any) -> Iterator[str]:
    for key in FROM_ZERO:
        if key in block and np.nanmin(block[key], initial=0.0) < 0:
            yield f"{key} reaches {np.nanmin(block[key]):.3g}; it is never negative"


def _losses(block: Any, lost: float) -> Iterator[str]:
    """Losses are not negative, and together the power that the rings put in."""
    if "driving_power" not in block:
        return
    losses = {cause: float(block[f"loss_{cause}"]) for cause in LOSSES}
    size = max(sum(map(abs, losses.values())), 1e-9)
    for cause, power in losses.items():
        if power < -lost * size:
            yield f"loss_{cause} is {power:.3g} W of {size:.3g} W; a loss is not negative"
    together = sum(losses.values()) + float(block["loss_transport"])
    if abs(together - block["driving_power"]) > lost * size:
        yield f"losses of {together:.6g} W, driving power {float(block['driving_power']):.6g} W"


def _balance(result: Any, block: Any, lost: float) -> Iterator[str]:
    """Contact loads carry the load of the case, as far as friction leaves it to them."""
    if "inner_load" in block and "roller_azimuth" in block:
        load = _case(result)["operation"]["radial_load"]
        carried = _radial(block)
        size = max(load, block["inner_load"].max(initial=0.0))
        direction = float(block["load_direction"])
        wanted = load * np.array([np.sin(direction), np.cos(direction)])
        if size and np.abs(carried - wanted).max() > lost * size + 2 * _shear(block, result):
            yield f"rollers carry {carried} N of a load {wanted} N, largest roller load {size:.6g} N"
    if "contact_load" in block and block["contact_load"].ndim == 2:
        yield from _angular(result, block, lost)


def _radial(block: Any) -> np.ndarray:
    """Force of the inner ring on the rollers (y, z), normal and tangential."""
    azimuth, load, traction = block["roller_azimuth"], block["inner_load"], block["inner_traction"]
    sin, cos = np.sin(azimuth), np.cos(azimuth)
    return np.array([load @ sin + traction @ cos, load @ cos - traction @ sin])


def _shear(block: Any, result: Any) -> float:
    """Bound of the shear of the inlets, which the result does not hold contact by contact.

    That of both raceways may cancel in the loss: what the bearing has between rigid raceways comes on top.
    """
    surface = max(
        np.abs(block["roller_speed"]).max() * _case(result)["bearing"]["roller"]["diameter"] / 2, 1e-6
    )
    attributes = result.attributes
    case = understood(
        attributes["case_text"], Path("case.toml"), attributes["case_overrides"], {result.kind: result.family}
    )
    between_rigid = roller_bearing.bearing(case).solve().rolling_shear
    return float(block["loss_rolling"]) / surface + float(np.abs(between_rigid).sum())


def _angular(result: Any, block: Any, lost: float) -> Iterator[str]:
    """Balls carry on the inner ring what the ring is loaded with."""
    load, angle, traction = block["contact_load"][0], block["contact_angle"][0], block["traction"][0]
    size = max(np.abs(load).max(initial=0.0), 1e-12)
    axial = (load * np.sin(angle)).sum()
    slack = np.abs(traction).sum() + lost * size
    if abs(axial - block["ring_load"][0]) > slack:
        yield f"balls carry {axial:.6g} N along x, the ring {block['ring_load'][0]:.6g} N"
    held = _case(result)["operation"].get("displacement") or {}
    given = _case(result)["operation"].get("load") or {}
    for number, name in enumerate(("axial", "radial_y", "radial_z")):
        wanted = given.get(name, 0.0)
        if held.get(name) is None and abs(block["ring_load"][number] - wanted) > lost * max(
            size, abs(wanted)
        ):
            yield f"ring_load {name} is {block['ring_load'][number]:.9g} N, the case asks for {wanted:.9g} N"


def _case(result: Any) -> Any:
    return result.attributes["case_si"]
