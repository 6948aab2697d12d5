"""Cells twice as long judge where they leave no doubt, and the usual ones where they do."""

from dataclasses import replace

import numpy as np
from pytest import approx

from quasidynamic.contact.line import peak_pressure
from quasidynamic.outcome.pressed_ends import LineContacts, line_loads

LENGTH, RADIUS, MODULUS, FORCE, CELLS = 10e-3, 4e-3, 227e9, 4e3, 64
DROPS = np.array([0.0, 1e-6, 2e-6, 4e-6, 8e-6, 16e-6, 32e-6])  # [m] of circular crowns at the ends


def crowned() -> LineContacts:
    """From a straight roller, which presses its ends, to one whose contact ends far from them."""
    count = len(DROPS)
    places = (np.arange(CELLS) + 0.5) / CELLS - 0.5
    return LineContacts(
        force=np.full(count, FORCE),
        shape=-DROPS[:, None] * (2 * places) ** 2,
        moment=np.full(count, np.nan),
        length=np.full(count, LENGTH),
        radius=np.full(count, RADIUS),
        modulus=np.full(count, MODULUS),
        sliced=np.full((count, CELLS), FORCE / LENGTH),
    )


def peaks(contacts: LineContacts) -> np.ndarray:
    """Largest pressures by the usual cells."""
    return peak_pressure(line_loads(contacts, contacts.sliced), RADIUS, MODULUS).max(axis=1)


def test_peaks_without_an_error_are_found_and_pressed_ends_miss_all():
    """Whether slices agree with the usual cells or with those twice as long."""
    contacts = crowned()
    for claimed in (peaks(contacts), peaks(contacts.coarse)):
        errors = contacts.peak_error(claimed)
        assert (errors[:4] == 1.0).all()
        assert (errors[-3:] < 0.03).all()


def test_doubtful_errors_are_those_of_the_usual_cells():
    contacts, claimed = crowned(), 1.3 * peaks(crowned())
    inside = [k for k, error in enumerate(contacts.peak_error(peaks(contacts))) if error < 0.03]
    loads = line_loads(contacts, np.repeat(line_loads(contacts.coarse, contacts.coarse.sliced), 2, axis=1))
    expected = claimed / peak_pressure(loads, RADIUS, MODULUS).max(axis=1) - 1
    assert len(inside) > 2
    assert contacts.peak_error(claimed)[inside] == approx(expected[inside], rel=1e-12)


def test_a_contact_is_judged_alone_as_beside_others():
    contacts = crowned()
    claimed = peaks(contacts) * np.linspace(0.9, 1.1, len(DROPS))
    each = [contacts.take(slice(k, k + 1)).peak_error(claimed[k : k + 1])[0] for k in range(len(DROPS))]
    assert contacts.peak_error(claimed) == approx(np.array(each), rel=1e-9)
    forced = replace(contacts, force=2 * contacts.force, sliced=2 * contacts.sliced)
    assert forced.peak_error(peaks(forced))[0] == 1.0


def test_a_moment_beyond_all_cells_presses_the_last_one_alone():
    """One cell bears a force and no moment; the system with both was singular."""
    contacts = replace(crowned(), moment=np.full(len(DROPS), 1e3 * FORCE * LENGTH))
    loads = line_loads(contacts, contacts.sliced)
    assert np.isfinite(loads).all()
    assert (loads >= 0).all()
