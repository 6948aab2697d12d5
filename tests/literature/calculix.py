"""What CalculiX 2.20 (`ccx`) finds for the ring of `python -m benchmarks.calculix` and the balls below.

75/82.2 x 10 mm, E 203 GPa, nu 0.28, one side face clamped, unit radial load spread over a line of the
raceway; mean radial displacement of the lines at 12, 24, 36 and 48 degrees [nm/N]. Quadratic hexahedra
(C3D20), graded towards the clamp, by their numbers along the radius, along the axis and around.
"""

from typing import NamedTuple

NEIGHBOURS = {
    (4, 8, 120): (1.36005, 0.141366, -0.0905633, -0.0648546),
    (4, 12, 180): (1.36025, 0.141182, -0.0907592, -0.0649291),
}


class Balls(NamedTuple):
    """What `python -m benchmarks.calculix_balls` prints; balls of one half, the first below the load."""

    elements: int  # quadratic hexahedra (C3D20)
    carried: tuple[float, ...]  # load on the inner ring at its place: Fx, Fy, Fz, My, Mz [N, N m]
    loads: tuple[float, ...]  # [N]
    angles: tuple[float, ...]  # [deg] contact angles


AT_REST = (0.0,) * 5
# fmt: off
BALLS = {
    "radial": (
        Balls(648, (0, 0, 8019.971, 0, 0), (3477.0, 2791.5, 766.1, 0, 0), AT_REST),
        Balls(1728, (0, 0, 7994.572, 0, 0), (3465.1, 2783.0, 765.1, 0, 0), AT_REST),
        Balls(3150, (0, 0, 7986.743, 0, 0), (3461.9, 2780.2, 764.0, 0, 0), AT_REST),
    ),
    "radial, small displacements": (
        Balls(648, (0, 0, 8055.319, 0, 0), (3500.8, 2799.7, 763.4, 0, 0), AT_REST),
        Balls(1728, (0, 0, 8029.765, 0, 0), (3488.7, 2791.1, 762.5, 0, 0), AT_REST),
        Balls(3150, (0, 0, 8021.893, 0, 0), (3485.5, 2788.4, 761.4, 0, 0), AT_REST),
    ),
    "combined": (
        Balls(648, (3058.204, 0, 5002.341, -0.629, 0), (2722.9, 2277.1, 1365.4, 743.8, 601.7),
              (5.746, 8.675, 16.520, 26.284, 33.460)),
        Balls(1728, (3017.610, 0, 4991.175, -0.415, 0), (2708.9, 2264.4, 1354.2, 733.6, 591.2),
              (5.689, 8.647, 16.479, 26.238, 33.422)),
        Balls(3150, (3015.121, 0, 4986.187, -0.416, 0), (2706.2, 2262.2, 1352.8, 732.8, 590.6),
              (5.679, 8.651, 16.496, 26.241, 33.416)),
    ),
}
# fmt: on
PLACE = 0.110682  # [mm] along z, to which the inner ring was moved under the radial load
# `python -m benchmarks.calculix_bearing --ring ...`: load on the inner ring [N], loads of the rollers of both
# rows from below it on [N]; 55 692 and 38 052 unknowns
TWO_ROWS = {
    "two rows": (9338.4, (898.1, 804.0, 423.6, 0, 0, 0, 0, 0), (2404.0, 1872.6, 549.5, 0, 0, 0, 0, 0)),
    "rim": (
        38905.9,
        (4651.1, 4670.8, 4687.4, 3522.6, 1086.5, 0, 0, 0),
        (4350.7, 4373.9, 4406.1, 3275.3, 610.3, 0, 0, 0),
    ),
}
