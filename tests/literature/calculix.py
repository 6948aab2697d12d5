"""What CalculiX 2.20 (`ccx`) finds for the ring of `python -m benchmarks.calculix`.

75/82.2 x 10 mm, E 203 GPa, nu 0.28, one side face clamped, unit radial load spread over a line of the
raceway; mean radial displacement of the lines at 12, 24, 36 and 48 degrees [nm/N]. Quadratic hexahedra
(C3D20), graded towards the clamp, by their numbers along the radius, along the axis and around.
"""

NEIGHBOURS = {
    (4, 8, 120): (1.36005, 0.141366, -0.0905633, -0.0648546),
    (4, 12, 180): (1.36025, 0.141182, -0.0907592, -0.0649291),
}
