"""A whole roller on a raceway: middle, ends, tilt, and how fast grids converge."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic.contact.ellipse.point_contact import Curvatures, point_contact
from quasidynamic.contact.half_space import ElasticPair
from quasidynamic.contact.line import half_width, peak_pressure
from quasidynamic.contact.pressure.roller import RollerOnRaceway
from quasidynamic.errors import OutOfRange
from quasidynamic.parts.profile import Crowned, Logarithmic, Profile, Straight

STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)
MODULUS = 2 / STEEL.plane_compliance  # E' [Pa]
RADIUS, LENGTH, FORCE = 2.6e-3, 5e-3, 800.0
ARCMIN = np.pi / 180 / 60
PROFILES = {
    "straight": Straight(),
    "crowned": Crowned(straight_length=3e-3, crown_radius=50e-3),
    "logarithmic": Logarithmic(amplitude=1.75e-6),
}


def roller(profile: str | Profile = "straight", *, length=LENGTH, cells=(16, 128)):
    shape = PROFILES[profile] if isinstance(profile, str) else profile
    return RollerOnRaceway(
        pair=STEEL, radius=RADIUS, length=length, drop=lambda y: shape.drop(y, length), cells=cells
    )


def test_middle_of_a_long_roller_is_a_line_contact():
    pressed = roller(length=40e-3, cells=(64, 128)).tilted(FORCE * 8, 0.0)
    middle = slice(56, 72)
    load = pressed.line_load[middle].mean()
    assert pressed.largest_along[middle] == approx(peak_pressure(load, RADIUS, MODULUS), rel=2e-3)
    x = pressed.contact.grid.centres[0][pressed.contact.touching[:, 64]]
    cell = pressed.contact.grid.spacing[0]
    assert np.abs(x).max() == approx(half_width(load, RADIUS, MODULUS), abs=cell)


def test_crowned_all_along_is_an_ellipse_of_hertz():
    pressed = roller(Crowned(straight_length=0.0, crown_radius=0.5), cells=(64, 256)).tilted(50.0, 0.0)
    hertz = point_contact(Curvatures(np.array(1 / 0.5), np.array(1 / RADIUS)), MODULUS)
    assert hertz.semi_axes(50.0)[0] < LENGTH / 2
    assert pressed.peak_pressure == approx(hertz.peak_pressure(50.0), rel=1e-3)
    assert pressed.approach == approx(hertz.approach(50.0), rel=5e-4)
    assert pressed.at_ends == (False, False)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("profile", "tilt", "order"),
    [("straight", 0, 1), ("straight", 4, 1), ("crowned", 0, 2), ("crowned", 4, 2), ("logarithmic", 4, 2)],
)
def test_load_along_the_roller_converges(profile, tilt, order):
    """Of first order where a sharp end makes it unbounded, like 1/sqrt(distance); otherwise of second."""

    def slices(cells):
        return roller(profile, cells=(16, cells)).tilted(FORCE, tilt * ARCMIN).slice_loads(32)

    finest, cells = slices(1024), np.array([32, 64, 128, 256])
    errors = [np.abs(slices(int(n)) - finest).sum() / finest.sum() for n in cells]
    rate = -np.polyfit(np.log(cells), np.log(errors), 1)[0]
    assert rate == approx(order, abs=0.3)
    assert errors[-1] < (4e-3 if order == 1 else 5e-4)


def test_pressure_at_a_sharp_end_grows_with_the_root_of_the_cells():
    coarse, fine = (roller(cells=(16, n)).tilted(FORCE, 0.0) for n in (256, 1024))
    assert fine.at_ends == (True, True)
    assert fine.peak_pressure / coarse.peak_pressure == approx(2.0, rel=0.1)


def test_logarithmic_profile_keeps_pressure_from_the_ends():
    assert roller("logarithmic").tilted(FORCE, 2 * ARCMIN).at_ends == (False, False)


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("tilt", [0, 2, 6])
def test_force_with_the_moment_of_a_tilt_gives_that_tilt(profile, tilt):
    tilted = roller(profile, cells=(16, 64)).tilted(FORCE, tilt * ARCMIN)
    again = roller(profile, cells=(16, 64)).under(FORCE, tilted.moment)
    assert again.tilt == approx(tilt * ARCMIN, abs=1e-5 * ARCMIN)
    assert again.approach == approx(tilted.approach, rel=1e-6)
    assert again.contact.force == approx(FORCE, rel=1e-6)
    assert again.moment == approx(tilted.moment, abs=1e-6 * FORCE * LENGTH)
    assert np.sum(again.slice_loads(20)) * LENGTH / 20 == approx(FORCE, rel=1e-6)


def test_end_faces_free_of_shear_take_load_from_the_ends():
    """The softer end carries less; far from it, and on a profile that stays away from it, little changes."""
    change = {}
    for profile in ("straight", "logarithmic"):
        half_space = roller(profile).tilted(FORCE, 0.0)
        free = replace(roller(profile), free_ends=0.5).tilted(FORCE, 0.0)
        assert free.contact.force == approx(FORCE, rel=1e-6)
        change[profile] = (free.slice_loads(32) - half_space.slice_loads(32)) / (FORCE / LENGTH)
    assert change["straight"][[0, -1]] == approx(change["straight"][0], rel=1e-6)
    assert -0.6 < change["straight"][0] < -0.2
    assert np.abs(change["logarithmic"][4:-4]).max() < 0.03


def test_turned_tilt_mirrors_the_pressure():
    right, left = (roller("crowned").tilted(FORCE, sign * 3 * ARCMIN) for sign in (1, -1))
    assert right.line_load == approx(left.line_load[::-1], rel=1e-5, abs=1e-5 * right.line_load.max())
    assert right.moment > 0


def test_force_near_an_end_is_carried_there():
    pressed = roller().under(FORCE, 0.9 * FORCE * LENGTH / 2)
    assert pressed.line_load[:64].sum() == 0
    assert pressed.moment == approx(0.45 * FORCE * LENGTH, rel=1e-6)


def test_force_outside_the_roller_is_refused():
    with pytest.raises(OutOfRange, match="outside its length"):
        roller().under(FORCE, FORCE * LENGTH / 2)
    with pytest.raises(OutOfRange, match="above zero"):
        roller().tilted(0.0, 0.0)


def test_slices_share_cells_where_counts_do_not_divide():
    pressed = roller("crowned").tilted(FORCE, 4 * ARCMIN)
    loads = pressed.slice_loads(30)
    assert loads.sum() * LENGTH / 30 == approx(FORCE, rel=1e-6)
    centres = (np.arange(30) + 0.5) / 30 - 0.5
    assert np.interp(0.2 * LENGTH, centres * LENGTH, loads) == approx(
        np.interp(0.2 * LENGTH, pressed.positions, pressed.line_load), rel=0.01
    )


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(30))
def test_random_rollers_are_solved(seed):
    rng = np.random.default_rng(seed)
    length = 10 ** rng.uniform(-2.3, -1.3)
    radius = length * 10 ** rng.uniform(-1, 1) / 4
    force = radius * MODULUS / 2 * 10 ** rng.uniform(-5, -3.3) * length
    profile = [
        Straight(),
        Logarithmic(amplitude=10 ** rng.uniform(-7, -5)),
        Crowned(straight_length=0.6 * length, crown_radius=length * 10 ** rng.uniform(0.5, 3)),
    ][seed % 3]
    whole = RollerOnRaceway(
        pair=STEEL, radius=radius, length=length, drop=lambda y: profile.drop(y, length), cells=(16, 64)
    )
    moment = rng.uniform(-0.9, 0.9) * force * length / 2
    pressed = whole.under(force, moment)
    assert pressed.contact.force == approx(force, rel=1e-6)
    assert pressed.moment == approx(moment, abs=1e-6 * force * length)
    assert whole.tilted(force, pressed.tilt).moment == approx(moment, abs=1e-5 * force * length)
