"""Condensing a whole solid prints nothing: threads are settled before NGSolve is at work."""

from math import pi

import numpy as np
import pytest

from fem import ClampedFace, Elastic, MeshSize, OuterRing, Patches
from fem.solid.condensation import condensed
from fem.solid.factored_solid import factored

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
RING = OuterRing(raceway_diameter=75e-3, thickness=8e-3, width=10e-3, elastic=STEEL, support=ClampedFace())
PATCHES = Patches(azimuths=tuple(2 * pi * np.arange(6) / 6), length=5e-3, axial_modes=2, width=4e-3)


@pytest.mark.slow
def test_library_says_nothing_of_threads(capfd):
    solid = factored(RING, PATCHES, MeshSize(order=2, size=8e-3, raceway_size=8e-3), 2)
    assert condensed(solid).support_error < 0.5
    assert "TaskManager" not in "".join(capfd.readouterr())
