"""Fit of the energy of elliptic contacts that a shoulder cuts off, and its errors.

`python -m benchmarks.truncated_contacts [--cells 64]`: coefficients of `energy_share`, by half-spaces whose
grid ends at the cut, and its largest errors there.
"""

import argparse

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from quasidynamic.contact.ellipse.point_contact import Curvatures, PointContact, point_contact
from quasidynamic.contact.ellipse.truncated import FIT, energy_share
from quasidynamic.contact.half_space import ElasticPair, grid_over
from quasidynamic.contact.pressure import NormalCompliance, RigidMotions, contact_pressure

STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)
FORCE, ALONG = 2000.0, 100.0  # [N] of whole contacts, [1/m] curvature along the rolling direction
RATIOS = (1.02, 1.25, 1.6, 2.2, 3.2, 4.5, 6.5, 9.0, 13.0, 19.0, 28.0, 40.0, 60.0)
PARTS = (0.04, 0.08, 0.12, 0.17, *np.arange(0.22, 0.95, 0.06), 0.98)  # u, from no contact to a whole one


def whole_contact(curvature: float) -> PointContact:
    """Contact of a curvature across [1/m]."""
    return point_contact(Curvatures(np.array(curvature), np.array(ALONG)), 2 / STEEL.plane_compliance)


def curvature_of(ratio: float) -> float:
    """Curvature across [1/m] of ellipses of a ratio a/b."""

    def off(curvature: float) -> float:
        contact = whole_contact(curvature)
        return float(contact.across / contact.along) - ratio

    return float(brentq(off, 1e-4, 1.5 * ALONG))  # type: ignore[arg-type]


def at_cut(ratio: float, part: float, cells: int) -> tuple[float, float, float, float]:
    """Cut c, shares of load and energy, and derivative of the latter."""
    curvature = curvature_of(ratio)
    contact = whole_contact(curvature)
    approach, (across, along) = float(contact.approach(FORCE)), map(float, contact.semi_axes(FORCE))
    overlap = np.sqrt(2 * approach / curvature)
    cut = part - (1 - part) * overlap / across
    low, high = (-1.02 * overlap if cut < 0 else -1.25 * across), cut * across
    deepest = approach - (curvature * high**2 / 2 if cut < 0 else 0.0)
    wide = 1.02 * min(np.sqrt(2 * deepest / ALONG), 1.75 * along)
    grid = grid_over((wide, (high - low) / 2), (cells, 2 * cells))
    x, y = grid.centres
    place = y + (low + high) / 2
    gap = (curvature * place**2 + ALONG * x**2) / 2 - approach
    held = RigidMotions(np.zeros((0, *grid.shape)), np.zeros(0))
    force = contact_pressure(NormalCompliance.of(STEEL, grid), gap, held).pressure * grid.cell_area
    energy = 0.4 * FORCE * approach
    moment = curvature * across * float((force * place).sum())
    return cut, float(force.sum()) / FORCE, float((force * -gap).sum()) / 2 / energy, -moment / energy


def fitted(ratio: NDArray, part: NDArray, found: NDArray) -> NDArray:
    """Coefficients like `FIT` by least squares in load, energy and a third of its derivative."""
    cut, load, energy, slope = found.T
    sides = [(load, 1.0), (energy, 1.0), (slope, 1 / 3)]

    def values(fit: NDArray) -> NDArray:
        FIT[:] = fit
        share = energy_share(cut, ratio)
        return np.concatenate([share.load(cut), share.value, share.slope / 3])

    none = values(np.zeros_like(FIT))
    columns = [values(each.reshape(FIT.shape)) - none for each in np.eye(FIT.size)]
    asked = np.concatenate([value * weight for value, weight in sides])
    return np.linalg.lstsq(np.array(columns).T, asked - none, rcond=None)[0].reshape(FIT.shape)


def main() -> None:
    """Print coefficients and errors."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--cells", type=int, default=64)
    cells = parser.parse_args().cells
    ratio, part = (axis.ravel() for axis in np.meshgrid(RATIOS, PARTS))
    found = np.array([at_cut(*each, cells) for each in zip(ratio, part, strict=True)])
    used, cut = FIT.copy(), found[:, 0]
    print("coefficients:", fitted(ratio, part, found).round(3).tolist(), "in use:", used.tolist())
    FIT[:] = used
    share = energy_share(cut, ratio)
    for name, own, there in (
        ("load", share.load(cut), found[:, 1]),
        ("energy", share.value, found[:, 2]),
        ("its derivative", share.slope, found[:, 3]),
        ("load, energy and derivative of the half-spaces against each other",
         found[:, 2] - cut * found[:, 3] / 5, found[:, 1]),
    ):  # fmt: skip
        print(f"{name}: within {np.abs(own - there).max():.4f} on {cells} x {2 * cells} cells")


if __name__ == "__main__":
    main()
