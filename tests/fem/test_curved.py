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


def test_bars_thinner_than_arcs_are_high_get_finer_elements():
    """Bars of 0.16 mm on a ring of 0.51 mm: edges on the raceway, 5 mm long, are 0.2 mm away from the arc."""
    thin = replace(
        CAGE, raceway_diameter=38.2e-3, thickness=0.514e-3, width=22.5e-3, bars=11, bar_width=5.63e-3,
        bar_thickness=0.157e-3, bar_length=16.9e-3, flange_length=1.9e-3,
    )  # fmt: skip
    mesh = half_pitch(thin, 20.5e-3, MeshSize(order=3, size=12.3e-3, raceway_size=8.2e-3))
    ring = 3.14159265 * ((19.1 + 0.514) ** 2 - 19.1**2) * 22.5 / 22
    assert ngs.Integrate(ngs.CF(1), mesh, definedon=mesh.Materials("ring")) == approx(ring, rel=1e-4)
    assert mesh.ne < 3000


def test_finer_elements_are_not_tried_where_they_would_be_far_too_many(monkeypatch):
    tried = []

    def many(sizes):
        tried.append(sizes.size / COARSE.size)
        return plate(COARSE)

    monkeypatch.setattr("fem.mesh.curved.MOST", 10)
    with pytest.raises(NotSolved, match=r"also on elements 0.7 times as large"):
        curved(many, COARSE)
    assert tried == approx([1.0, 0.85, 0.7])


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
