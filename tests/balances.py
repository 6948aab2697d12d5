"""Balances of a roller bearing summed up again from nothing but the stored forces of a result."""

from collections.abc import Mapping
from typing import Any

import numpy as np

FORCES = (
    "inner_load", "outer_load", "inner_traction", "outer_traction", "inner_inlet_shear", "outer_inlet_shear",
    "inner_inlet_pressure", "outer_inlet_pressure", "roller_drag", "centrifugal_force", "roller_weight",
    "cage_force", "pocket_friction", "applied_load",
)  # fmt: skip
UNITS = dict.fromkeys(
    ("radial", "along the motion", "axial", "thrust", "ring", "cage, force"), "N"
)  # else N m


def balances(block: Mapping[str, Any], guidance: str) -> dict[str, np.ndarray]:
    """What is left of every balance [N] or [N m]: zero but for rounding and the tolerance of the solver."""
    one = {name: np.asarray(values) for name, values in block.items()}
    r_i, r_m, r_o = one["balance_radii"]
    r_w, azimuth = (r_o - r_i) / 2, one["roller_azimuth"]
    outward, along = (
        np.array([np.sin(azimuth), np.cos(azimuth)]),
        np.array([np.cos(azimuth), -np.sin(azimuth)]),
    )
    lift, brake = one["pocket_friction"]
    weight_out, weight_along = one["roller_weight"]
    by_inner = one["inner_traction"] + one["inner_inlet_shear"] + one["inner_inlet_pressure"]
    by_outer = one["outer_traction"] + one["outer_inlet_shear"] + one["outer_inlet_pressure"]
    turning = (
        one["inner_traction"] + one["inner_inlet_shear"] - one["outer_traction"] - one["outer_inlet_shear"]
    )
    on_ring = one["applied_load"] - outward @ one["inner_load"] - along @ by_inner
    pushed = -along @ one["cage_force"] - outward @ lift  # by the rollers on the cage
    land = float(one["land_torque"])
    station = one.get("roller_station", np.zeros_like(azimuth))
    by_rows = (outward @ (station * one["inner_load"]) + along @ (station * by_inner))[::-1]
    left = {
        "radial": one["inner_load"] - one["outer_load"] + one["centrifugal_force"] + weight_out + lift,
        "along the motion": by_inner + by_outer + one["roller_drag"] + weight_along + one["cage_force"],
        "spin": r_w * (turning - brake) - one["churning_torque"] - one["transport_torque"],
        "tilt": one["outer_load_moment"] - one["inner_load_moment"],
        "ring": on_ring,
        "ring, moment": one["ring_moment"]
        - np.array([np.cos(azimuth), np.sin(azimuth)]) @ one["inner_load_moment"]
        - by_rows,
        "cage, moment": land
        - r_m * one["cage_force"].sum()
        - r_w * brake.sum()
        - one["churning_torque"].sum(),
        "inner torque": one["driving_torque"]
        - r_i * (one["inner_traction"] - one["inner_inlet_shear"]).sum()
        - land * (guidance == "inner"),
        "outer torque": one["outer_torque"]
        - r_o * (one["outer_traction"] - one["outer_inlet_shear"]).sum()
        - land * (guidance == "outer"),
        "whole": one["driving_torque"] + one["outer_torque"] + r_m * one["roller_drag"].sum(),
    }
    if "rib_thrust" in one:
        for name, added in _by_ribs(one).items():
            left[name] = left.get(name, 0.0) + added
    if "land_force" in one:
        left["cage, force"] = pushed + one["land_force"] + one["cage_body_force"]
        if guidance == "inner":
            left["ring"] = left["ring"] - one["land_force"]
    if "flange_force" in one:
        low, high = one["flange_force"]
        left["axial"] = one["roller_thrust"] + low - high
    return {name: np.atleast_1d(values) for name, values in left.items()}


def _by_ribs(one: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """What thrust on ribs and their friction add to the balances."""
    thrust, friction, radii = one["rib_thrust"], one["rib_friction"], one["rib_radii"]
    outward = np.array([np.cos(one["roller_azimuth"]), np.sin(one["roller_azimuth"])])
    turning = radii * friction.sum(axis=1)
    return {
        "thrust": one["axial_load"] - thrust.sum(),
        "tilt": -(radii[1] - radii[0]) * thrust,
        "along the motion": friction.sum(axis=0),
        "spin": -(radii - one["balance_radii"][1]) @ friction,
        "ring": -np.array([[1.0], [-1.0]]) * outward @ friction[0],
        "ring, moment": radii[0] * outward @ thrust,
        "inner torque": -turning[0],
        "outer torque": -turning[1],
    }


def largest_imbalance(block: Mapping[str, Any], guidance: str) -> float:
    """The worst of all balances over the largest force, or over that force with its lever [-]."""
    size = max(float(np.abs(block[name]).max()) for name in FORCES)
    lever = float(block["balance_radii"][-1])
    return max(
        float(np.abs(values).max()) / (size * (1.0 if name in UNITS else lever))
        for name, values in balances(block, guidance).items()
    )
