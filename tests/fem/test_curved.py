"""Curved elements are the right way round."""

from dataclasses import replace

import ngsolve as ngs
import pytest
from netgen import occ
from pytest import approx

from fem import ImpossiblePart, MeshSize
from fem.errors import NotSolved
from fem.mesh.curved import curved
from fem.mesh.half_pitch import half_pitch
from fem.mesh.solid import MILLIMETRES
from tests.fem.test_parts import CAGE

COARSE = MeshSize(order=3, size=10e-3, raceway_size=10e-3)


def plate(sizes):
    """A hole of 10 mm in 14 mm square; an element across a quarter of it is thinner than the arc is high."""
    body = occ.Box(occ.Pnt(-7, -7, 0), occ.Pnt(7, 7, 6)) - occ.Cylinder(occ.Pnt(0, 0, -1), occ.Z, 5, 9)
    return ngs.Mesh(
        occ.OCCGeometry(body).GenerateMesh(
            maxh=sizes.size * MILLIMETRES, curvaturesafety=0.4, grading=0.9, parallel_meshing=False
        )
    )


def smallest_volume(mesh):
    points = mesh.MapToAllElements(ngs.IntegrationRule(ngs.TET, 6), ngs.VOL)
    return ngs.Det(ngs.specialcf.JacobianMatrix(3))(points).min()


def test_elements_that_would_fold_become_finer():
    folded = plate(COARSE)
    folded.Curve(3)
    assert smallest_volume(folded) < 0
    mesh = curved(plate, COARSE)
    assert smallest_volume(mesh) > 0
    quarters = approx(6 * (14**2 - 25 * 3.14159265), rel=5e-3)  # each of them one cubic edge
    assert ngs.Integrate(ngs.CF(1), mesh) == quarters


def test_elements_that_fold_at_any_size_are_refused():
    with pytest.raises(NotSolved, match=r"raceway of 10 mm, .* inside out"):
        curved(lambda sizes: plate(COARSE), COARSE)


def test_few_elements_fold_beside_fillets():
    rounded = replace(CAGE, fillet=0.3e-3)
    mesh = half_pitch(rounded, 5e-3, MeshSize(order=3, size=3e-3, raceway_size=2e-3))
    plain = half_pitch(CAGE, 5e-3, MeshSize(order=3, size=3e-3, raceway_size=2e-3))
    more = ngs.Integrate(ngs.CF(1), mesh) - ngs.Integrate(ngs.CF(1), plain)
    around = 2 * (4 + 2.6)  # both ends of half a bar, along its edges; (1 - pi/4) r^2 is the section
    assert more == approx((1 - 3.14159265 / 4) * 0.3**2 * around, rel=0.1)


def test_fillet_that_loses_the_bar_is_named():
    """The geometry kernel was seen to return nothing at 0.44 mm, and a bar at 0.42 and 0.45 mm."""
    with pytest.raises(ImpossiblePart, match="fillet"):
        half_pitch(replace(CAGE, fillet=0.44e-3), 5e-3, MeshSize(order=2, size=3e-3, raceway_size=2e-3))
