"""Edge pressures of rollers by the program and by a one-page solution that shares nothing with it."""

from functools import cache

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Crowned, Logarithmic, Straight, TangentCrowned
from quasidynamic.contact.half_space import ElasticPair
from quasidynamic.contact.line import LoadLaw, fujiwara_kawase, johns_gohar, peak_pressure
from quasidynamic.contact.pressure.roller import RollerOnRaceway
from quasidynamic.outcome.sliced_peak import CELLS, CLAIMED, SlicedPeak
from quasidynamic.outcome.whole_roller import whole_roller
from tests.bearings import paper_bearing
from tests.reference.plain_roller_pressure import plain_pressure

LENGTH, RADIUS, SLICES = 10e-3, 4.23e-3, 30
STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)
MODULUS = 2 / STEEL.plane_compliance  # E' [Pa]
ARCMIN = np.pi / 180 / 60
DESIGN = 2 * np.pi * RADIUS * 2e9**2 / MODULUS * LENGTH  # [N] for 2 GPa
PROFILES = {
    "straight": Straight(),
    "rounded": TangentCrowned(straight_length=8.4e-3, crown_radius=40e-3),
    "crowned": Crowned(straight_length=0.0, crown_radius=0.8),
    "logarithmic": Logarithmic(amplitude=3.5e-6),
    "johns_gohar": johns_gohar(DESIGN, LENGTH, MODULUS, RADIUS),
    "fujiwara_kawase": fujiwara_kawase(
        DESIGN, LENGTH, MODULUS, load_factor=1.5, crowned_share=0.8, end_drop=30e-6
    ),
}


def force_of(pressure):
    return 2 * np.pi * RADIUS * (pressure * 1e9) ** 2 / MODULUS * LENGTH


@cache
def plain(profile, pressure, tilt, cells=(12, 72)):
    return plain_pressure(
        force=force_of(pressure), tilt=tilt * ARCMIN, radius=RADIUS, length=LENGTH, modulus=MODULUS / 2,
        drop=lambda y: PROFILES[profile].drop(y, LENGTH), cells=cells,
    )  # fmt: skip


def whole(profile, pressure, tilt, cells):
    roller = RollerOnRaceway(
        pair=STEEL,
        radius=RADIUS,
        length=LENGTH,
        drop=lambda y: PROFILES[profile].drop(y, LENGTH),
        cells=cells,
    )
    return roller.tilted(force_of(pressure), tilt * ARCMIN)


def sliced(profile, pressure, tilt):
    """Peak pressure of slices by Palmgren's law [Pa]."""
    places = ((np.arange(SLICES) + 0.5) / SLICES - 0.5) * LENGTH
    law = LoadLaw((LENGTH**0.8 / 3.81) ** (10 / 9) * np.pi / STEEL.plane_compliance / LENGTH, 1e-12)
    shape, low, high = tilt * ARCMIN * places - PROFILES[profile].drop(places, LENGTH), -1e-3, 1e-3
    for _ in range(60):
        middle = (low + high) / 2
        missing = law(middle + shape)[0].mean() * LENGTH < force_of(pressure)
        low, high = (middle, high) if missing else (low, middle)
    return float(peak_pressure(law(low + shape)[0].max(), RADIUS, MODULUS))


def test_the_plain_solution_has_the_ellipse_of_hertz():
    """A circular crown; semi-axes ratio and pressure in closed form (Johnson 1985, sec. 4.2)."""
    from scipy.optimize import brentq
    from scipy.special import ellipe, ellipk

    crown, force = 0.8, 60.0

    def mismatch(e2):  # R''/R' of an ellipse of eccentricity e
        k, e = ellipk(e2), ellipe(e2)
        return (e / (1 - e2) - k) / (k - e) - crown / RADIUS

    e2 = brentq(mismatch, 0.5, 1 - 1e-9)
    k, e = ellipk(e2), ellipe(e2)
    # p0 from a^3: 1/(2 R'') = p0 b/(E* a^2 e^2) (K - E), with R'' along the roller and F = 2/3 p0 pi a b
    along = (3 * force * crown * (k - e) / (np.pi * MODULUS / 2 * e2)) ** (1 / 3)
    across = along * np.sqrt(1 - e2)
    found = plain_pressure(
        force=force, tilt=0.0, radius=RADIUS, length=LENGTH, modulus=MODULUS / 2,
        drop=lambda y: y**2 / (2 * crown), cells=(12, 80),
    )  # fmt: skip
    assert along < 0.9 * LENGTH / 2
    assert found.peak == approx(3 * force / (2 * np.pi * along * across), rel=0.01)


def test_the_plain_solution_has_the_line_contact_of_hertz_in_the_middle():
    long = plain_pressure(
        force=1e5, tilt=0.0, radius=RADIUS, length=8 * LENGTH, modulus=MODULUS / 2, drop=np.zeros_like
    )
    middle = np.argmin(np.abs(long.y))
    hertz = peak_pressure(long.line_load[middle], RADIUS, MODULUS)
    assert long.pressure[0, middle] == approx(float(hertz), rel=5e-3)


FEW = [
    ("rounded", 1.0, 4), ("crowned", 1.0, 4), ("logarithmic", 1.5, 0), ("logarithmic", 2.5, 4),
    ("johns_gohar", 1.0, 2), ("fujiwara_kawase", 1.5, 4),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("profile", "pressure", "tilt"), FEW)
def test_edge_peak_of_half_spaces_is_that_of_the_plain_solution(profile, pressure, tilt):
    known, found = plain(profile, pressure, tilt), whole(profile, pressure, tilt, (32, 512))
    assert not known.at_end
    assert found.at_ends == (False, False)
    assert found.peak_pressure == approx(known.peak, rel=0.01)
    assert found.moment == approx(known.moment, rel=5e-3, abs=1e-3 * force_of(pressure) * LENGTH / 2)
    place = found.positions[found.largest_along.argmax()]
    assert abs(place) == approx(abs(known.place), abs=0.06 * LENGTH / 2)
    carried = np.cumsum(known.line_load * known.widths)  # from the left end to the border of each cell
    cell = LENGTH / len(found.positions)
    sums = np.interp(
        known.y + known.widths / 2, found.positions + cell / 2, np.cumsum(found.line_load) * cell
    )
    assert sums == approx(carried, rel=0, abs=3e-3 * force_of(pressure))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("tilt", [0, 4])
def test_a_sharp_end_has_no_peak_in_either_solution(tilt):
    coarse, fine = (plain("straight", 1.5, tilt, cells=(12, n)) for n in (48, 96))
    assert coarse.at_end
    assert fine.peak > 1.3 * coarse.peak
    found = whole("straight", 1.5, tilt, (32, 256))
    assert found.peak_at_ends
    places = np.array([0.5, 0.9, 0.95, 0.98]) * LENGTH / 2  # pressure converges, also near the end
    known = np.interp(places, fine.y, fine.pressure[0])
    assert np.interp(places, found.positions, found.largest_along) == approx(known, rel=0.03)
    last, cell = fine.y > 0.49 * LENGTH, LENGTH / len(found.positions)
    carried = fine.line_load[last] @ fine.widths[last]
    border = fine.y[last][0] - fine.widths[last][0] / 2
    summed = np.interp(border, found.positions + cell / 2, np.cumsum(found.line_load) * cell)
    assert force_of(1.5) - summed == approx(carried, rel=0.05)  # on the last hundredth


def verdict(profile, pressure, tilt):
    return SlicedPeak(0, 0, sliced(profile, pressure, tilt), whole(profile, pressure, tilt, CELLS))


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("profile", "pressure", "tilt", "holds"),
    [
        ("logarithmic", 1.5, 0, True), ("logarithmic", 1.5, 4, True), ("logarithmic", 2.5, 4, False),
        ("crowned", 1.0, 2, True), ("rounded", 1.0, 2, False), ("fujiwara_kawase", 1.0, 0, True),
        ("fujiwara_kawase", 1.5, 4, False),
    ],
)  # fmt: skip
def test_slices_claim_the_peak_only_where_they_have_it(profile, pressure, tilt, holds):
    judged = verdict(profile, pressure, tilt)
    assert judged.holds == holds
    assert not judged.at_end
    known = plain(profile, pressure, tilt)
    assert judged.error == approx(judged.pressure / known.peak - 1, abs=0.01)


@pytest.mark.parametrize(("profile", "pressure", "tilt"), [("straight", 1.0, 0), ("crowned", 1.5, 5)])
def test_slices_claim_no_peak_of_a_contact_that_reaches_an_end(profile, pressure, tilt):
    judged = verdict(profile, pressure, tilt)
    assert judged.at_end
    assert not judged.holds
    assert (abs(judged.error) < CLAIMED) == (profile == "crowned")  # whose cells do not show the end yet


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize(
    "pressure",
    [
        *(pytest.param(p, marks=pytest.mark.slow) for p in (1.2, 2.5)),
        *(pytest.param(p, marks=pytest.mark.long) for p in (0.8, 1.8, 3.2)),
    ],
)
def test_no_claimed_peak_is_off_by_more_than_five_percent(profile, pressure):
    for tilt in (0, 1, 2, 3, 4, 6):
        known = plain(profile, pressure, tilt, cells=(14, 88))
        judged = verdict(profile, pressure, tilt)
        if judged.holds:
            assert judged.pressure == approx(known.peak, rel=CLAIMED)
        fine, coarse = (whole(profile, pressure, tilt, cells) for cells in ((32, 512), (16, 256)))
        if not any(fine.at_ends) and fine.peak_pressure == approx(coarse.peak_pressure, rel=0.02):
            assert fine.peak_pressure == approx(known.peak, rel=CLAIMED)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    "profile", [Logarithmic(amplitude=1.75e-6), Crowned(straight_length=0.0, crown_radius=0.25)]
)
def test_edge_peak_of_a_misaligned_bearing_is_that_of_its_roller(profile):
    """At the load and tilt of the slices; materials, radii and profile from the bearing's data alone."""
    slope = 6e-4
    state = paper_bearing(load=4e3, speed=100.0, profile=profile, misalignment=slope).solve()
    found = whole_roller(state)
    compliance = (1 - 0.3**2) / 209e9 + (1 - 0.28**2) / 203e9
    for race, raceway in enumerate((1 / 32.5e-3, -1 / 37.5e-3)):
        known = plain_pressure(
            force=float(state.loads[race, found.number]), tilt=slope / 2, radius=1 / (1 / 2.5e-3 + raceway),
            length=5e-3, modulus=1 / compliance, drop=lambda y: profile.drop(y, 5e-3),
        )  # fmt: skip
        assert abs(found.tilt[race]) == approx(slope / 2, rel=0.02)
        assert found.peak_pressure[race] == approx(known.peak, rel=0.01)
