"""Mixed lubrication: limits of thick and thin films, bounds, slopes."""

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from pytest import approx

from quasidynamic.contact.line import SMALLEST_LOAD, half_width
from quasidynamic.contact.traction.asperity_friction import Carter, RoundedCoulomb
from quasidynamic.contact.traction.mixed import FILM_SHARE_1_8, ZHOU_HOEPRICH, ErrorFunctionShare, Mixed
from quasidynamic.contact.traction.rheology import BairWiner
from quasidynamic.errors import ImpossiblePart
from quasidynamic.parts.oil_properties import Lubricant

OIL = Lubricant(
    temperature=493.15, viscosity=1.137e-3, pressure_viscosity=8.751e-9, temperature_viscosity=0.00726,
    conductivity=0.1205, density=835,
)  # fmt: skip
FLUID = BairWiner(
    radius=2.32e-3, modulus=2.2487e11, length=5e-3, oil=OIL, limiting_ratio=0.05, film_heating=True
)
ROUNDED = RoundedCoulomb(coefficient=0.1, sign_speed=1e-3)
CARTER = Carter(radius=2.32e-3, modulus=2.2487e11, coefficient=0.1)
ROUGH: dict[str, Any] = {"fluid": FLUID, "asperities": ROUNDED, "roughness": 0.1e-6}
SHARES = {"stretched": ZHOU_HOEPRICH, "film share": FILM_SHARE_1_8, "error function": ErrorFunctionShare()}
every_friction = pytest.mark.parametrize("asperities", [ROUNDED, CARTER], ids=["rounded", "carter"])
every_share = pytest.mark.parametrize("share", SHARES.values(), ids=list(SHARES))

loads = st.floats(0.0, 2e6)
slides = st.tuples(st.sampled_from([-1.0, 1.0]), st.floats(-7, np.log10(60))).map(lambda v: v[0] * 10 ** v[1])
speeds = st.floats(-4, np.log10(200)).map(lambda n: 10.0**n)
films = st.floats(np.log10(5e-9), np.log10(2e-6)).map(lambda n: 10.0**n)


@every_share
def test_asperities_carry_all_without_film_and_nothing_with_much(share):
    ratio = np.geomspace(1e-9, 20.0, 200)
    part, slope = share(ratio)
    assert part[0] == approx(1.0, abs=1e-7)
    assert part[-1] == approx(0.0, abs=1e-12)
    assert np.all(np.diff(part) <= 0)
    assert np.all(slope <= 0)


@pytest.mark.parametrize(
    ("share", "at_one"),
    [(ZHOU_HOEPRICH, 0.0982736), (FILM_SHARE_1_8, 0.1652989), (ErrorFunctionShare(), 0.1572992)],
    ids=list(SHARES),
)
def test_share_at_a_film_of_one_roughness(share, at_one):
    """exp(-2.32), exp(-1.8) and 1 - erf(1) of the tables."""
    assert share(np.array(1.0))[0] == approx(at_one, rel=1e-6)


def test_thick_film_is_the_fluid_and_no_film_is_boundary_friction():
    law = Mixed(**ROUGH, share=ZHOU_HOEPRICH)
    point = np.array(1e5), np.array(2.0), np.array(60.0)
    thick, thin = np.array(5e-6), np.array(1e-14)
    for mixed, fluid in zip(law(*point, thick), FLUID(*point, thick), strict=True):
        assert mixed == approx(fluid, rel=1e-12)
    assert law(*point, thin).force == approx(0.1 * 1e5, rel=1e-6)


@pytest.mark.sampled(2)
@every_friction
@every_share
@given(load=loads, slide=slides, speed=speeds, film=films)
def test_mixed_traction_is_odd(share, asperities, load, slide, speed, film):
    law = Mixed(**{**ROUGH, "asperities": asperities}, share=share)
    forward, backward = (law(*map(np.array, (load, u, speed, film))).force for u in (slide, -slide))
    assert forward == approx(-backward, rel=1e-12, abs=0)


@every_share
@given(load=loads, slide=slides, speed=speeds, film=films)
def test_mixed_traction_is_between_its_parts(share, load, slide, speed, film):
    forward = Mixed(**ROUGH, share=share)(*map(np.array, (load, slide, speed, film))).force
    fluid = abs(FLUID(*map(np.array, (load, slide, speed, film))).force)
    boundary = 0.1 * load * abs(slide) / np.hypot(slide, 1e-3)
    assert min(fluid, boundary) * (1 - 1e-12) <= abs(forward) <= max(fluid, boundary) * (1 + 1e-12)


def away_from_full_slip(load, slide, speed, share):
    """Whether differences stay on one side of the kink of Carter's law."""
    width = half_width(np.hypot(load, SMALLEST_LOAD * 2.2487e11 * 2.32e-3), 2.32e-3, 2.2487e11)
    full_slip = 0.1 * share * width / 2.32e-3
    return abs(abs(slide) / speed - full_slip) > 0.05 * full_slip


@pytest.mark.sampled(2)
@every_friction
@every_share
@given(load=loads, slide=slides, speed=speeds, film=films)
def test_every_derivative_is_the_slope_of_the_force(share, asperities, load, slide, speed, film):
    law = Mixed(**{**ROUGH, "asperities": asperities}, share=share)
    point = np.array([load, slide, speed, film])
    assume(load == 0.0 or load > 1e-3)
    assume(asperities is ROUNDED or away_from_full_slip(load, slide, speed, share(film / 0.1e-6)[0]))
    sizes = point + np.array([200.0, 0.0, 0.0, 0.0])
    here = law(*map(np.array, point))
    for index, size in enumerate(sizes):
        step = 1e-4 * size
        f = [law(*map(np.array, point + n * step * np.eye(4)[index])).force for n in (-2, -1, 1, 2)]
        slope = (f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * step)
        floor = 1e-8 * max(0.1 * load, 1e-6) / abs(size)
        assert here[1 + index] == approx(slope, rel=1e-6, abs=floor)


@every_friction
@every_share
def test_everything_stays_finite_at_the_corners(share, asperities):
    corners = np.meshgrid([0.0, 1e-3, 8e6], [-60.0, 0.0, 60.0], [1e-6, 200.0], [5e-9, 2e-6])
    for value in Mixed(**{**ROUGH, "asperities": asperities}, share=share)(*corners):
        assert value.shape == corners[0].shape
        assert np.all(np.isfinite(value))


def test_impossible_surfaces_are_refused():
    with pytest.raises(ImpossiblePart, match="roughness"):
        Mixed(**{**ROUGH, "roughness": 0.0}, share=ZHOU_HOEPRICH)
    with pytest.raises(ImpossiblePart, match="sign_speed"):
        RoundedCoulomb(coefficient=0.1, sign_speed=-1.0)
    for law, values in ((RoundedCoulomb, {"sign_speed": 1e-3}), (Carter, {"radius": 1e-3, "modulus": 2e11})):
        with pytest.raises(ImpossiblePart, match="coefficient"):
            law(coefficient=-0.1, **values)
