"""Limiting-load curves of four-point bearings: lines against direct solutions, and the ratio of the axes.

`python -m benchmarks.limiting_curves`. Two hundred places on the lines between the points of a curve, evenly
spaced by their angle, are solved directly. Makers print the limit of ball slewing bearings as a line,
F_a + 4.37 M/D + 3.44 F_r <= C_0 (liyuandrive.com, Luoyang Aidusu: "C_p = F_a + 4370 M/D + 3.44 F_r").
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing.api import read_case
from flexbearing.limits.curves import LimitedBearing
from flexbearing.progress import Logged
from quasidynamic.outcome.limiting_load import StaticLimits

CONFIGS = Path(__file__).parents[1] / "configs"
CASES = {  # and radial loads [N]
    "joshi2015_fourpoint": (0.0, 200e3),
    "joshi2015_qj309": (0.0, 5e3),
}
PLACES = 200
MOMENT, RADIAL = 4.37, 3.44  # printed factors


def on_lines(points: NDArray, count: int) -> NDArray:
    """Places (count, 2) on the lines between points (n, 2), evenly spaced by their angle over the axes."""
    angles = np.arctan2(points[:, 1], points[:, 0])
    wanted = np.linspace(angles[0], angles[-1], count + 2)[1:-1]
    before = np.clip(np.searchsorted(angles, wanted) - 1, 0, len(points) - 2)
    near, far = points[before], points[before + 1]
    along = np.stack([np.cos(wanted), np.sin(wanted)], axis=-1)
    matrix = np.stack([along, near - far], axis=-1)
    return along * np.linalg.solve(matrix, near[..., None])[:, 0]


def main() -> None:
    for name, radial_loads in CASES.items():
        bearing = LimitedBearing.of(read_case(CONFIGS / f"{name}.toml", ()), StaticLimits(), Logged())
        diameter = bearing.bearing.pitch_diameter
        for radial in radial_loads:
            points = [*bearing.curve(radial, 5, refined=True)]
            axes = np.array([points[0].axial, points[-1].moment])
            places = on_lines(np.array([[each.axial, each.moment] for each in points]) / axes, PLACES)
            scales = [bearing.point(radial, (axes[0] * one, axes[1] * two))[0] for one, two in places]
            off = np.abs(np.array(scales) - 1)
            print(
                f"{name}, radial load {radial / 1e3:g} kN: {len(points)} points, {PLACES} direct solutions "
                f"off by at most {100 * off.max():.3f} %, {100 * off.mean():.3f} % in the mean; "
                f"axes {axes[0] / 1e3:.4g} kN, {axes[1] / 1e3:.4g} kN m",
                flush=True,
            )
            if not radial:
                printed, ratio = 1 / MOMENT, axes[1] / (axes[0] * diameter)
                print(
                    f"  M/(F_a D) = {ratio:.4f}, printed {printed:.4f}: {100 * (ratio / printed - 1):+.1f} %"
                )


if __name__ == "__main__":
    main()
