"""What the life of a ball bearing has that a catalogue leaves out."""

from dataclasses import replace

from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.deep_groove import DeepGrooveBearing
from flexbearing.life import ball_lives
from flexbearing.life.against_catalogue import (
    LUBRICATION,
    RELIABILITY,
    Catalogue,
    Influence,
    require_known_forces,
)

WEIGHTLESS = "0.001 kg/m^3"  # of balls without inertia

RATING = (
    Influence(
        "ISO 281: (C_r/P)^3, P = X F_r + Y F_a",
        {"life.loads": "rating"},
        "One load P replaces radial and axial load; nothing else of the case counts.",
    ),
    Influence(
        "loads of all balls, without inertia, tilt or clearance",
        {},
        "The loads of all balls at their own contact angles instead of one load P: X and Y are the larger "
        "step away from them the more balls the axial load presses.",
    ),
)
MOUNTING = {
    "bearing.fits": "",
    "operation.temperatures": "",
    **{f"materials.{ring}.density": "" for ring in ("inner_ring", "outer_ring")},
    **{f"materials.{part}.expansion": "" for part in ("ball", "inner_ring", "outer_ring")},
}
FITS = Influence(
    "fits and heat, which change the contact angle",
    {},
    "Fits and heat change the clearance, and with it the angle at which the balls carry.",
)
CLEARANCE = Influence(
    "operating clearance",
    {"bearing.clearance": "0 um", "bearing.clearance_class": ""},
    "Clearance leaves fewer balls to carry a radial load, and gives an axial load a steeper contact angle.",
)
ELASTIC_RINGS = Influence(
    "elastic rings",
    {"outer": "", "outer.kind": "rigid", "inner": "", "inner.kind": "rigid", "accuracy": ""},
    "Elastic rings change how many balls carry the load, and at which contact angles.",
)
TILT = Influence(
    "tilt of the inner ring",
    {
        "operation.load.moment_y": "0 N m",
        "operation.load.moment_z": "0 N m",
        "operation.displacement.tilt_y": "0 deg",
        "operation.displacement.tilt_z": "0 deg",
    },
    "A moment, or a ring that is held askew or straight, loads the balls unevenly.",
)
NOT_ROUND = Influence(
    "form errors of the raceways",
    {"bearing.form_error": ""},
    "Raceways that are not round change which balls carry the load.",
)
AT_SPEED = (
    Influence(
        "inertia of the balls at speed",
        {"materials.ball.density": WEIGHTLESS},
        "Centrifugal forces press the balls to the outer race and part the contact angles.",
    ),
    Influence(
        "friction that decides how the balls turn",
        {
            "operation.control": "outer",
            "friction.model": "full_sliding",
            "friction.cells": "",
            "friction.interface_compliance": "",
        },
        "Which race controls how the balls turn decides who bears their gyroscopic moment.",
    ),
    LUBRICATION,
    RELIABILITY,
)


def influences(case: FastCase) -> tuple[Influence, ...]:
    """What may act, in the order in which it enters: clearance, tilt and preload, then what speed does."""
    clearance, elastic = _with_materials(case)
    preload, first = case.operation.preload, (clearance, TILT, NOT_ROUND)
    if preload is None:
        return (*first, *elastic, *AT_SPEED)
    of_spring = {"operation.preload": "", "operation.load.axial": f"{preload.force!r} N"}
    preloaded = Influence(
        "rigid preload instead of that of a spring",
        of_spring,
        "A rigid preload changes with the load, one by a spring does not.",
    )
    return (*first, preloaded, *elastic, *AT_SPEED)


def _with_materials(case: FastCase) -> tuple[Influence, tuple[Influence, ...]]:
    """Clearance or fits, and elastic rings; materials of shaft and housing go with what needs them."""
    fits, first = case.bearing.fits, CLEARANCE if isinstance(case.bearing, DeepGrooveBearing) else FITS
    by_fits = {"shaft": fits is not None, "housing": fits is not None and bool(fits.housing)}
    by_rings = {"shaft": case.inner.kind != "rigid", "housing": case.outer.support == "housing"}

    def without(of_fits: bool, of_rings: bool) -> dict[str, str]:
        needed = (of_fits, of_rings)
        return {f"materials.{name}": "" for name in by_fits if (by_fits[name], by_rings[name]) == needed}

    mounting = {} if fits is None else MOUNTING
    first = replace(
        first, out={**first.out, **mounting, **without(True, False)}, also_out=without(True, True)
    )
    rings = replace(ELASTIC_RINGS, out={**ELASTIC_RINGS.out, **without(False, True)})
    return first, () if case.rigid else (rings,)


def require_load(case: FastCase) -> None:
    """Require forces that are known before the case is solved, and a ring that turns.

    Raises `BadCase` where one of them is missing.
    """
    require_known_forces(case)
    if not any(case.operation.forces):
        raise BadCase("[operation.load]: without a force a catalogue knows no life.")


CATALOGUE = Catalogue(RATING, influences, require_load, ball_lives.rated)
