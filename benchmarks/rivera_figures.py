"""Draw Figures 11 to 17 of Rivera, Tong and Hong (2021): pure rolling lines of a 7008 bearing.

Run from the project directory: python -m benchmarks.rivera_figures
"""

import argparse
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from flexbearing.api import read_case
from flexbearing.report.figure import BLUE, ORANGE
from flexbearing.runs.angular_contact import bearing, operation
from quasidynamic import AngularContactState

CASE = "configs/rivera2021_7008.toml"
RACES = ("inner", "outer")
SPEEDS = np.linspace(500, 15000, 30)  # [rpm]
GREEN = "#009E73"
COLORS = (BLUE, ORANGE, GREEN)
FRICTION = 0.1


@dataclass(frozen=True)
class Curve:
    """One setting of a figure, followed over the speed."""

    name: str
    settings: dict[str, str]


ALONE = Curve("with inertia", {})
INERTIA = [Curve("without inertia", {"materials.ball.density": "1e-6 kg/m^3"}), ALONE]
AXIAL = [Curve(f"Fa = {load} N", {"operation.load.axial": f"{load} N"}) for load in (300, 500, 1000)]
ANGLES = [Curve(f"{angle}°", {"bearing.contact_angle": f"{angle} deg"}) for angle in (15, 25, 40)]
RADIAL = [Curve(f"Fr = {load} N", {"operation.load.radial_z": f"{load} N"}) for load in (100, 500, 1000)]
BOTH = [Curve(curve.name, {**curve.settings, "operation.load.radial_z": "1000 N"}) for curve in ANGLES]


def solved(curve: Curve, speeds) -> list[AngularContactState]:
    """States of the bearing at some speeds [rpm]."""
    case = read_case(CASE, curve.settings)
    base = operation(case)
    asked = [
        type(base)(load=base.load, displacement=base.displacement, inner_speed=speed * np.pi / 30)
        for speed in speeds
    ]
    found = bearing(case).solve_many(asked)
    assert all(isinstance(state, AngularContactState) for state in found), found
    return found


def lines(states, spin="contact angle"):
    return [state.rolling_contact(spin=spin) for state in states]


def draw_torque(axes) -> None:
    """Fig. 11: spin torque of the bearing by the integral and by the lines."""
    states = solved(ALONE, SPEEDS)
    for spin, color, name in (
        ("contact angle", BLUE, "Eq. (15)"),
        ("slip field", ORANGE, "whole slip field"),
    ):
        for method, style in (("integral", "-"), ("lines", "--")):
            torque = [
                1e3 * (np.sin(state.contact_angles) * contact.spin_torques(FRICTION, method)).sum()
                for state, contact in zip(states, lines(states, spin), strict=True)
            ]
            axes.plot(SPEEDS, torque, style, color=color, label=f"{name}, by {method}")
    axes.set(title="Fig. 11", xlabel="speed [rpm]", ylabel="spin torque [mN m]", ylim=(0, None))
    axes.legend(frameon=False, fontsize=8)


def draw_slip(panels) -> None:
    """Fig. 12: slip across the contacts at 1000 N."""
    position, speeds = np.linspace(-1, 1, 201), (5000, 10000, 15000)
    for speed, color, contact in zip(speeds, COLORS, lines(solved(AXIAL[-1], speeds)), strict=True):
        slip = contact.slip_velocity(position)[:, 0]
        for race, axes in enumerate(panels):
            axes.plot(position, slip[race], color=color, label=f"{speed} rpm")
            for place, mark in ((contact.lines.first, "s"), (contact.lines.second, "o")):
                axes.plot(place[race, 0], 0, mark, color=color, markerfacecolor="white")
    for axes, race in zip(panels, RACES, strict=True):
        axes.axhline(0, color="0.5", linewidth=0.8)
        axes.set(title=f"Fig. 12, {race} race, Fa = 1000 N", xlabel="x/a", ylabel="slip [m/s]")
    panels[0].legend(frameon=False, fontsize=8)


def draw_over_speed(panels, number: int, curves: list[Curve]) -> None:
    """Figs. 13 to 15: lines of one ball over the speed."""
    for curve, color in zip(curves, COLORS, strict=False):
        found = lines(solved(curve, SPEEDS))
        first = np.array([contact.lines.first[:, 0] for contact in found])
        second = np.array([contact.lines.second[:, 0] for contact in found])
        for race, axes in enumerate(panels):
            axes.plot(SPEEDS, _inside(first)[:, race], color=color, label=curve.name)
            axes.plot(SPEEDS, second[:, race], "--", color=color)
    _finish(panels, number, "speed [rpm]")


def draw_around(panels, number: int, curves: list[Curve]) -> None:
    """Figs. 16 and 17: lines of every ball at 15 000 rpm."""
    for curve, color in zip(curves, COLORS, strict=True):
        (state,) = solved(curve, [15000])
        (contact,) = lines([state])
        azimuth = np.degrees(state.bearing.azimuths)
        places = np.full((2, 2, len(azimuth)), np.nan)  # balls that leave the inner race stay empty
        places[:, :, contact.balls] = _inside(contact.lines.first), contact.lines.second
        for race, axes in enumerate(panels):
            axes.plot(azimuth, places[0, race], "s-", color=color, markersize=4, label=curve.name)
            axes.plot(azimuth, places[1, race], "o--", color=color, markersize=4, markerfacecolor="white")
    _finish(panels, number, "azimuth [deg]")


def _inside(first):
    """First lines that lie inside the contact; the others are not drawn, as in the paper."""
    return np.where(first > -1, first, np.nan)


def _finish(panels, number: int, label: str) -> None:
    for axes, race in zip(panels, RACES, strict=True):
        axes.set(title=f"Fig. {number}, {race} race", xlabel=label, ylabel="c1 (solid), c2 (dashed)")
        axes.set_ylim(-1.05, 0.5)
        axes.locator_params(axis="x", nbins=5)
    panels[0].legend(frameon=False, fontsize=8)


def write(directory: Path) -> list[Path]:
    """Draw both sheets."""
    figure, grid = plt.subplots(1, 3, figsize=(12, 3.8), layout="constrained")
    draw_torque(grid[0])
    draw_slip(grid[1:])
    paths = [directory / "rivera2021_slip.png", directory / "rivera2021_lines.png"]
    figure.savefig(paths[0], dpi=110)
    figure, grid = plt.subplots(5, 2, figsize=(9, 14), layout="constrained")
    for row, (number, curves) in enumerate(((13, INERTIA), (14, AXIAL), (15, ANGLES))):
        draw_over_speed(grid[row], number, curves)
    draw_around(grid[3], 16, RADIAL)
    draw_around(grid[4], 17, BOTH)
    figure.savefig(paths[1], dpi=110)
    return paths


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--output", type=Path, default=Path("docs/images"))
    for path in write(arguments.parse_args().output):
        print(path)
