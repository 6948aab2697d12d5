"""A law that is left is told; inside all of them nothing is."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from quasidynamic import AdoreType, Material
from quasidynamic.contact.traction import in_any_contact
from quasidynamic.contact.traction.adore import ADORE_OILS
from quasidynamic.contact.traction.asperity_friction import Carter, RoundedCoulomb
from quasidynamic.contact.traction.mixed import ZHOU_HOEPRICH, RoughContacts
from quasidynamic.outcome.validity import LOADED, validity
from quasidynamic.parts.oil_properties import oil_at
from tests.bearings import RPM, eyring, paper_bearing

OIL = oil_at("ISO VG 32", 330.0)
THIN = oil_at("MIL-PRF-23699", 493.15)
QUIET = {  # inside every law
    "oil": OIL,
    "traction": lambda **contact: eyring(OIL, film_heating=True)(**contact),
    "load": 2000.0,
    "speed": 3000 * RPM,
    "oil_fraction": 0.5,
    "cage": {"guidance": "rollers"},
}


def adore(**contact):
    return AdoreType(**contact, rheology=ADORE_OILS["MIL-L-23699"], limiting_ratio=0.05)


ISOTHERMAL = {"traction": lambda **contact: eyring(OIL)(**contact)}
BEYOND = {
    "isothermal film": (ISOTHERMAL | {"load": 300.0, "speed": 10_000 * RPM}, "slide-to-roll"),
    "slow heat source": ({"speed": 20 * RPM}, "peclet-number"),
    "slow and heavy": ({"speed": 1 * RPM, "load": 20_000.0}, "film-regime"),
    "little oil": ({"oil_fraction": 0.02}, "flooding"),
    "starved": ({"inlet_length": 1.0}, "flooding"),
    "vortices in the land": ({"cage": {}, "speed": 38_000 * RPM, "oil": THIN}, "land-flow"),
    "skidding": (
        {"load": 30.0, "speed": 20_000 * RPM, "clearance": 20e-6, "oil_fraction": 1.0},
        "slide-to-roll",
    ),
    "fitted oil": ({"traction": adore, "oil": THIN}, "traction-data"),
    "gap for churning": ({"churning_gap": 1e-3}, "churning-gap"),
}


def rough(asperities, size=0.3e-6):
    """Surfaces that touch where the bearing is slow."""
    return RoughContacts(
        fluid=QUIET["traction"], share=ZHOU_HOEPRICH, asperities=asperities,
        inner_roughness=size, outer_roughness=size,
    )  # fmt: skip


ROUNDED = partial(in_any_contact, RoundedCoulomb(coefficient=0.1, sign_speed=1e-3))
CREEPING = partial(Carter, coefficient=0.1)


def codes(**changes):
    state = paper_bearing(**QUIET | changes).solve()
    return {note.code: note for note in validity(state)}


def test_inside_every_law_there_is_nothing_to_tell():
    assert codes() == {}


@pytest.mark.parametrize(("changes", "code"), BEYOND.values(), ids=BEYOND.keys())
def test_a_law_that_is_left_is_told(changes, code):
    found = codes(**changes)
    assert code in found
    assert {note.grade for note in found.values()} == {"outside validity"}


@pytest.mark.slow
def test_rounded_friction_of_slow_rough_rollers_is_told():
    slow = {"speed": 20 * RPM}
    assert "sign-speed" in codes(**slow, traction=rough(ROUNDED))
    assert "sign-speed" not in codes(**slow, traction=rough(CREEPING))
    assert "sign-speed" not in codes(traction=rough(ROUNDED))
    assert "sign-speed" not in codes(**slow, traction=rough(ROUNDED, size=1e-9))  # nothing touches


@pytest.mark.slow
def test_slices_below_the_width_of_their_contact_are_told_where_they_creep():
    thin = {"speed": 20 * RPM, "slices": 100}
    assert "slice-creep" in codes(**thin, traction=rough(CREEPING))
    assert "slice-creep" not in codes(**thin, traction=rough(ROUNDED))
    assert "slice-creep" not in codes(speed=20 * RPM, traction=rough(CREEPING))


def with_roller(**changes):
    """The quiet bearing with another roller."""
    bearing = paper_bearing(**QUIET)
    roller = replace(bearing.bearing.roller, **changes)
    return replace(bearing, bearing=replace(bearing.bearing, roller=roller))


def test_other_materials_and_proportions_are_told():
    ceramic = Material(youngs_modulus=310e9, poisson_ratio=0.26, density=3200)
    (note,) = validity(with_roller(material=ceramic).solve())
    assert note.code == "material"
    assert "rollers 310 GPa" in note.text
    (note,) = validity(with_roller(length=20e-3).solve())
    assert note.code == "roller-length"
    assert "4 times as long as thick" in note.text


def test_contact_as_wide_as_its_radius_is_told():
    soft = Material(youngs_modulus=2e9, poisson_ratio=0.3, density=1200)
    found = {note.code for note in validity(with_roller(material=soft).solve())}
    assert {"contact-size", "material"} <= found


def test_only_loaded_contacts_count():
    """Rollers beside the loaded zone slide as they like."""
    state = paper_bearing(**QUIET | {"clearance": 100e-6}).solve()
    ratio = np.abs(state.sliding) / state.entrainment
    loaded = state.loads[0] > LOADED * state.loads.max()
    assert ratio.max() > 0.5
    assert ratio[:, loaded].max() < 0.01
    assert "slide-to-roll" not in {note.code for note in validity(state)}
