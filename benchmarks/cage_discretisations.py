"""One squirrel cage by three discretisations: `python -m benchmarks.cage_discretisations`.

A small cage on three bars, its edges sharp and with fillets: half a pitch with harmonics, the whole solid
with layers of elements along the sharp edges, and the whole solid with plain elements. All press with the
same Gaussian of 0.4 mm along the arc, which harmonics take up as a factor; the last one leaves 0.1 % of it.
The Gaussian of a solid keeps its direction, that of harmonics stays radial: (width / radius)^2 = 0.2 %.
Differences are the largest of all entries of the compliance over the largest one, against half a pitch.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

import fem
from benchmarks.alone import measured
from benchmarks.machine import describe
from fem.condense import HARMONICS, SOLID, condense_in_process
from tests.fem.edge_layers import LAYERS, refined

LENGTH, SHAPES, WIDTH = 5e-3, 3, 0.4e-3  # [m], [-], [m]
AZIMUTHS = 2 * np.pi * np.arange(10) / 10
STEEL = fem.Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
SHARP = fem.SquirrelCage(
    raceway_diameter=20e-3, thickness=3e-3, width=6e-3, bars=3, bar_width=5e-3, bar_thickness=2e-3,
    bar_length=4e-3, flange_length=3e-3, elastic=STEEL,
)  # fmt: skip
ROUND = replace(SHARP, fillet=0.4e-3)
HALF_PITCH = fem.MeshSize(order=4, size=2e-3, raceway_size=0.35e-3)
WHOLE = fem.MeshSize(order=4, size=2e-3, raceway_size=0.65e-3)


def by_half_a_pitch(cage: fem.SquirrelCage, mesh: fem.MeshSize) -> tuple[NDArray, float, int]:
    """Compliance (Z, M, Z, M), support stiffness, unknowns."""
    from fem.half_space.load_patch import half_space
    from fem.mesh import half_pitch

    half_pitch.LAYERS = LAYERS
    with threadpool_limits(limits=1, user_api="blas"):
        raceway = condense_in_process(cage, HARMONICS, resolution(mesh))
        support = raceway.at(AZIMUTHS).support_stiffness
    n = raceway.harmonics
    wave = np.exp(1j * np.outer(AZIMUTHS, n) - (n * WIDTH / raceway.radius) ** 2 / 2)
    full = np.einsum("ik,kmlp,jl->imjp", wave, raceway.response, wave.conj(), optimize=True).real
    own = np.arange(AZIMUTHS.size)
    full[own, :, own] -= half_space(patches(), STEEL)
    return full, support, raceway.unknowns


def by_the_whole(cage: fem.SquirrelCage, mesh: fem.MeshSize, layered: bool) -> tuple[NDArray, float, int]:
    """The same from a solid without any symmetry but that of rollers and bars."""
    from fem.solid import condensation

    if layered:
        condensation.meshed = refined
    with threadpool_limits(limits=1, user_api="blas"):
        raceway = condense_in_process(cage, SOLID, resolution(mesh))
    return raceway.absolute, raceway.support_stiffness, raceway.unknowns


def resolution(mesh: fem.MeshSize) -> fem.Resolution:
    return fem.Resolution(
        length=LENGTH, axial_modes=SHAPES, mesh_size=mesh, azimuths=tuple(AZIMUTHS), patch_width=WIDTH,
        threads=1,
    )  # fmt: skip


def patches() -> fem.Patches:
    return fem.Patches(azimuths=tuple(AZIMUTHS), length=LENGTH, axial_modes=SHAPES, width=WIDTH)


def main() -> None:
    print(describe())
    jobs = {
        "sharp, half a pitch, order 4": (by_half_a_pitch, SHARP, HALF_PITCH),
        "sharp, whole with layers, order 4": (by_the_whole, SHARP, WHOLE, True),
        "sharp, whole without, order 4": (by_the_whole, SHARP, WHOLE, False),
        "fillets, half a pitch, order 4": (by_half_a_pitch, ROUND, HALF_PITCH),
        "fillets, whole, order 3": (by_the_whole, ROUND, replace(WHOLE, order=3), False),
        "fillets, whole, order 4": (by_the_whole, ROUND, WHOLE, False),
    }
    first = np.zeros(0), 0.0
    for name, job in jobs.items():
        (full, support, unknowns), cost = measured(*job, memory_limit=10.0)
        if job[0] is by_half_a_pitch:
            first = full, support
        away = np.abs(full - first[0]).max() / first[0].max()
        print(
            f"{name:36s} {unknowns:7d} unknowns, compliance {100 * away:6.3f} % away, support "
            f"{support / 1e6:8.3f} kN/mm, {100 * (support / first[1] - 1):+.3f} %, "
            f"{cost.processor_seconds:.1f} s, {cost.memory:.0f} MiB",
            flush=True,
        )


if __name__ == "__main__":
    main()
