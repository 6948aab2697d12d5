"""What must hold of every result that claims to have converged, whatever bearing it is about."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from flexbearing.results.checks import NotInLayout, require_finite
from tests.balances import largest_imbalance

LOST = 1e-6  # of the largest force or power: far above the tolerances of the solvers
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
    losses = {name[5:]: float(block[name]) for name in block if name.startswith("loss_")}
    transport = losses.pop("transport", 0.0)  # no loss
    size = max(sum(map(abs, losses.values())), 1e-9)
    for cause, power in losses.items():
        if power < -lost * size:
            yield f"loss_{cause} is {power:.3g} W of {size:.3g} W; a loss is not negative"
    together = sum(losses.values()) + transport
    if abs(together - block["driving_power"]) > lost * size:
        yield f"losses of {together:.6g} W, driving power {float(block['driving_power']):.6g} W"


def _balance(result: Any, block: Any, lost: float) -> Iterator[str]:
    """Every balance of rollers, ring and cage closes; balls and cones carry what the ring bears."""
    if "inner_load" in block and _case(result)["kind"] == "thrust_roller":
        yield from _between_washers(result, block, lost)
    elif "inner_load" in block and _case(result)["kind"] == "spherical_roller":
        yield from in_sphere(result, block, lost)
    elif "inner_load" in block and _case(result)["kind"] == "tapered_roller":
        yield from _inclined(result, block, lost)
    elif "inner_load" in block and "roller_azimuth" in block:
        wrong = largest_imbalance(block, _case(result)["bearing"]["cage"]["guidance"])
        if not wrong <= lost:
            yield f"balances are open by {wrong:.2g} of the largest force"
        case = _case(result)["operation"]
        wanted = case["radial_load"] * np.array(
            [np.sin(case["load_direction"]), np.cos(case["load_direction"])]
        )
        if np.abs(block["applied_load"] - wanted).max() > 1e-9 * case["radial_load"]:
            yield f"applied_load is {block['applied_load']} N, the case asks for {wanted} N"
    if "contact_load" in block and block["contact_load"].ndim == 2:
        yield from _angular(result, block, lost)


SIDES = {"back_to_back": (1, -1), "face_to_face": (-1, 1), "tandem": (1, 1)}  # of both rows


def _inclined(result: Any, block: Any, lost: float) -> Iterator[str]:
    """Tapered rollers are in balance along and across the axis, and carry what the ring is loaded with."""
    inner, outer = block["inner_load"], block["outer_load"]
    bearing, azimuth = _case(result)["bearing"], block["roller_azimuth"]
    cone, cup = float(block["cone_angle"]), bearing["cup_angle"]
    rib, against = block["centrifugal_force"] * np.sin(cup), cup  # along the axes of cylinders without a rib
    if bearing["rib"]:
        rib, against = block["rib_load"], bearing["rib"]["angle"]
    out = inner * np.cos(cone) - rib * np.sin(against)
    sides = np.ones(len(outer))
    if "roller_row" in block:
        sides = np.array(SIDES[bearing["pair"]["arrangement"]])[block["roller_row"].astype(int)]
    left = {
        "axially": inner * np.sin(cone) + rib * np.cos(against) - outer * np.sin(cup),
        "outwards": out + block["centrifugal_force"] - outer * np.cos(cup),
        "on the ring": np.array(
            [(sides * outer * np.sin(cup)).sum(), out @ np.sin(azimuth), out @ np.cos(azimuth)]
        )
        - block["ring_load"][:3],
    }
    size = max(outer.max(), 1e-12)
    for name, forces in left.items():
        if np.abs(forces).max() > lost * size:
            yield f"forces {name} leave {np.abs(forces).max():.3g} N of {size:.6g} N"
    yield from _loaded_as_given(result, block, lost * size)


def _between_washers(result: Any, block: Any, lost: float) -> Iterator[str]:
    """Both washers have the same loads and what the ring is loaded with."""
    inner, outer = block["inner_load"], block["outer_load"]
    size = max(outer.max(), 1e-12)
    if np.abs(inner - outer).max() > lost * size or abs(inner.sum() - block["ring_load"][0]) > lost * size:
        yield f"washers carry {inner.sum():.6g} and {outer.sum():.6g} N, or rollers unlike loads"
    yield from _loaded_as_given(result, block, lost * size)


def in_sphere(result: Any, block: Any, lost: float) -> Iterator[str]:
    """Barrels are in balance, forces and moments; outer loads carry that of the ring."""
    bearing, places = _case(result)["bearing"], block["slice_position"]
    angle, diameter, length = (
        bearing["contact_angle"],
        bearing["roller"]["diameter"],
        bearing["roller"]["length"],
    )
    sphere = (bearing["pitch_diameter"] / np.cos(angle) + diameter) / 2
    groove = bearing["outer_osculation"] * sphere / bearing["inner_osculation"]
    inner, outer = (block[f"{race}_slice_load"] * length / len(places) for race in ("inner", "outer"))
    sides = 2 * block["roller_row"] - 1
    axial = sides * (outer.sum(1) * np.sin(angle) - outer @ places / sphere * np.cos(angle))
    radial = outer.sum(1) * np.cos(angle) + outer @ places / sphere * np.sin(angle)
    azimuth, inertia = block["roller_azimuth"], block["centrifugal_force"] * np.cos(angle)
    on_ring = np.array([axial.sum(), radial @ np.sin(azimuth), radial @ np.cos(azimuth)])
    left = {
        "across rollers": outer.sum(1) - inner.sum(1) - inertia,
        "along rollers": outer @ places / sphere + inner @ places / groove,
        "of moments": (
            (outer @ places * (1 - diameter / 2 / sphere) - inner @ places * (1 - diameter / 2 / groove))
            - block["gyroscopic_moment"]
        )
        / length,
        "on the ring": on_ring - block["ring_load"][:3],
    }
    size = max(block["outer_load"].max(), 1e-12)
    for name, forces in left.items():
        if np.abs(forces).max() > lost * size:
            yield f"forces {name} leave {np.abs(forces).max():.3g} N of {size:.6g} N"
    yield from _loaded_as_given(result, block, lost * size)


def _angular(result: Any, block: Any, lost: float) -> Iterator[str]:
    """Fast balls are in balance, and carry on the inner ring what the ring is loaded with."""
    size = max(np.abs(block["contact_load"]).max(initial=0.0), 1e-12)
    left = forces_left_by_balls(block)
    if not left <= lost * size:
        yield f"forces of balls and inner ring leave {left:.3g} N of {size:.6g} N"
    yield from _loaded_as_given(result, block, lost * size)


def forces_left_by_balls(block: Any) -> float:
    """Largest force left on a fast ball, or on the inner ring along x, y and z [N]."""
    across = np.exp(
        -1j * np.nan_to_num(block["contact_angle"])
    )  # axial + i radial, of loads those are turned by 90 deg
    sideways = block["traction"] + block.get("shoulder_force", 0.0)
    inner, outer = (1j * block["contact_load"] + sideways) * across
    azimuth = block["ball_azimuth"]
    carried = [inner.real.sum(), inner.imag @ np.sin(azimuth), inner.imag @ np.cos(azimuth)]
    on_balls = np.abs(inner - outer + 1j * block["centrifugal_force"]).max()
    return float(max(on_balls, np.abs(carried - block["ring_load"][:3]).max()))


def _loaded_as_given(result: Any, block: Any, allowed: float) -> Iterator[str]:
    """The ring bears the forces of the case [N] where its place is not held."""
    held = _case(result)["operation"].get("displacement") or {}
    given = _case(result)["operation"].get("load") or {}
    for number, name in enumerate(("axial", "radial_y", "radial_z")):
        wanted = given.get(name, 0.0)
        if held.get(name) is None and abs(block["ring_load"][number] - wanted) > max(
            allowed, LOST * abs(wanted)
        ):
            yield f"ring_load {name} is {block['ring_load'][number]:.9g} N, the case asks for {wanted:.9g} N"


def _case(result: Any) -> Any:
    return result.attributes["case_si"]
