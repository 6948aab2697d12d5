"""Which race controls the balls of Harris' 218 bearing: assumptions beside Coulomb friction, over the speed.

Run from the project directory: python -m benchmarks.ball_control
"""

import argparse
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy.special import ellipe

from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.case.balls.angular_contact import AngularCase
from flexbearing.report.figure import BLUE, ORANGE
from flexbearing.runs.angular_contact import bearing, operation
from quasidynamic import AngularContactState
from quasidynamic.motion.ball_speeds import ball_attitude

CASE = "configs/harris218.toml"
RPM = np.pi / 30
TURNING = np.linspace(1500, 2750, 26)  # [rpm] where control passes from one race to the other
SPEEDS = np.union1d(np.linspace(500, 15000, 59), TURNING)  # [rpm]
PRINTED = (1000, 2000, 2100, 3000, 6000, 8000, 10000, 12000, 15000)  # [rpm]


@dataclass(frozen=True)
class Curve:
    """One assumption, followed over the speed."""

    name: str
    settings: dict[str, object]
    color: str


UNDER_RACE_CONTROL = 0.1  # [-] coefficient of friction, where a race controls the balls
FRICTIONS = ((0.03, "#E5A5C4"), (0.06, "#CC79A7"), (0.1, "#6F2E53"))
CURVES = [
    *(
        Curve(name, {"operation.control": control, "friction.coefficient": UNDER_RACE_CONTROL}, color)
        for name, control, color in (
            ("outer control", "outer", BLUE),
            ("inner control", "inner", ORANGE),
            ("equal", "equal", "0.45"),
        )
    ),
    *(
        Curve(
            f"Coulomb, µ = {friction}",
            {"operation.control": "coulomb", "friction.coefficient": friction},
            color,
        )
        for friction, color in FRICTIONS
    ),
]


@dataclass(frozen=True)
class Found:
    """What one curve says; N speeds, inner race before the outer one."""

    angles: NDArray  # (N, 2) [deg]
    share: NDArray  # (N) [-] attitude of the axis, from 0, outer control, to 1, inner control
    tractions: NDArray  # (N, 2) [N]
    needed: NDArray  # (N, 2) [-] traction over load
    torque: NDArray  # (N) [N m] of friction
    ratio: NDArray  # (N) [-] above 1 by Harris' rule the outer race controls
    upright: NDArray  # (N) bool, friction holds the axis


def found(curve: Curve) -> Found:
    """Curve over `SPEEDS`; thrust alone makes all balls alike, so the first one is taken."""
    case = read_case(CASE, curve.settings)
    assert isinstance(case, AngularCase)
    base = operation(case)
    asked = [
        type(base)(load=base.load, displacement=base.displacement, inner_speed=speed * RPM)
        for speed in SPEEDS
    ]
    states = bearing(case).solve_many(asked)
    solved = [state for state in states if isinstance(state, AngularContactState)]
    assert len(solved) == len(states), states
    assert all(state.guided.all() for state in solved)
    return Found(
        angles=np.degrees([state.contact_angles[:, 0] for state in solved]),
        share=np.array([share_of_inner(state) for state in solved]),
        tractions=np.array([state.tractions[:, 0] for state in solved]),
        needed=np.array([state.needed_friction[:, 0] for state in solved]),
        torque=np.array([state.friction_torque for state in solved], dtype=float),
        ratio=np.array([control_ratio(state) for state in solved]),
        upright=np.array([state.upright[0] for state in solved]),
    )


def share_of_inner(state: AngularContactState) -> float:
    """(beta - beta_o) / (beta_i - beta_o), with the attitudes of both controls at the same contact angles."""
    ratio, angles = state.bearing.diameter_ratio, state.contact_angles[:, 0]
    outer, inner = (float(ball_attitude(angles, ratio, control).value) for control in ("outer", "inner"))
    return (float(state.attitude[0]) - outer) / (inner - outer)


def control_ratio(state: AngularContactState) -> float:
    """Q_o a_o E_o cos(alpha_i - alpha_o) / (Q_i a_i E_i); E is that of the contact ellipse, second kind."""
    across, along = (axes[:, 0] for axes in state.semi_axes)
    spin = state.loads[:, 0] * across * ellipe(1 - (along / across) ** 2)
    inner, outer = state.contact_angles[:, 0]
    return float(spin[1] * np.cos(inner - outer) / spin[0])


def crossing(ratio: NDArray) -> float:
    """Speed at which the growing ratio passes 1 [rpm]."""
    assert ratio[0] < 1 < ratio[-1]
    assert (np.diff(ratio) > 0).all()
    return float(np.interp(1.0, ratio, SPEEDS))


def report(curve: Curve, values: Found) -> None:
    print(f"\n{curve.name}: control ratio passes 1 at {crossing(values.ratio):.0f} rpm", end="")
    fallen = SPEEDS[~values.upright]
    print(f"; axes turn towards the shaft from {fallen[0]:.0f} rpm" if len(fallen) else "")
    print(
        "    rpm   alpha_i  alpha_o [deg]   share    T_i    T_o [N]   T_i/Q_i T_o/Q_o   torque [N m]  ratio"
    )
    for speed in PRINTED:
        (row,) = np.flatnonzero(np.isclose(SPEEDS, speed))
        (inner, outer), pulls, needed = values.angles[row], values.tractions[row], values.needed[row]
        print(
            f"{speed:7.0f} {inner:9.2f} {outer:8.2f} {values.share[row]:13.3f} {pulls[0]:7.1f} "
            f"{pulls[1]:6.1f} {needed[0]:12.4f} {needed[1]:7.4f} {values.torque[row]:12.3f} "
            f"{values.ratio[row]:8.3f}"
        )


def drawn(sheets: list[Found]) -> Figure:
    """Four panels over the speed."""
    figure, ((angles, share), (needed, torque)) = plt.subplots(2, 2, figsize=(11, 8.2), layout="constrained")
    for curve, values in zip(CURVES, sheets, strict=True):
        for race, style in enumerate(("-", "--")):
            angles.plot(SPEEDS, values.angles[:, race], style, color=curve.color)
            needed.plot(SPEEDS, values.needed[:, race], style, color=curve.color)
        share.plot(SPEEDS, values.share, color=curve.color, label=curve.name)
        torque.plot(SPEEDS, values.torque, color=curve.color)
    passed = crossing(sheets[0].ratio)
    share.axvline(passed, color="0.2", linewidth=0.9, linestyle=":")
    share.annotate(
        f"Harris' ratio passes 1,\n{passed:.0f} rpm: from here on\nouter control by his rule",
        (passed, 0.8), (passed + 450, 0.68), fontsize=9,
    )  # fmt: skip
    angles.set(title="contact angle: inner race (solid), outer race (dashed)", ylabel="[deg]")
    share.set(title="axis of the balls between outer (0) and inner (1) control", ylabel="share [-]")
    needed.set(title="traction over load: inner (solid), outer (dashed)", ylabel="T/Q [-]", ylim=(0, 0.15))
    needed.annotate("inner control,\n0.46 at 15 000 rpm", (8900, 0.125), ha="right", fontsize=9, color=ORANGE)
    torque.set(title=f"friction torque; race control with µ = {UNDER_RACE_CONTROL}", ylabel="[N m]")
    torque.set_ylim(0, None)
    for axes in (angles, share, needed, torque):
        axes.set(xlabel="speed [rpm]", xlim=(0, 15000))
        axes.spines[["top", "right"]].set_visible(False)
    figure.legend(loc="outside lower center", ncols=6, frameon=False)
    return figure


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("docs/images"))
    target = parser.parse_args().output / "harris218_control.png"
    print(describe())
    sheets = [found(curve) for curve in CURVES]
    for curve, values in zip(CURVES, sheets, strict=True):
        report(curve, values)
    drawn(sheets).savefig(target, dpi=110)
    print(f"\n{target}")


if __name__ == "__main__":
    main()
