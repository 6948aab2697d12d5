"""Bolted rings of a case, meshed and condensed, or taken from the cache."""

from math import inf
from typing import Literal

import numpy as np
from numpy.typing import NDArray

import fem
from fem.condense import HARMONICS, condense
from fem.parts.bolted_ring import BoltedGrooveRing
from flexbearing.cache import configured
from flexbearing.case import BadCase
from flexbearing.case.balls.bolted_rings import BoltedRing
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.progress import Report

LINE = 0.2  # of a ball diameter: near the length of a heavily loaded contact
USUAL = 5, 0.5, 0.5  # order; elements over the ball diameter; elements on the lines over these


def compliance(case: FourPointCase, report: Report) -> NDArray:
    """How both rings together let the groove centres of the diagonals come closer."""
    total = np.zeros((case.balls, 2, 2, 2, 2))
    sides: tuple[tuple[Literal["outer", "inner"], slice], ...] = (
        ("outer", slice(None)),
        ("inner", slice(None, None, -1)),
    )
    for name, arches in sides:
        part = ring(case, name)
        if part is not None:
            # the first diagonal presses on the outer arch at +x and on the inner one at -x
            total += _row(case, name, part, report)[:, arches, :, arches]
    return total


def ring(case: FourPointCase, name: Literal["inner", "outer"]) -> BoltedGrooveRing | None:
    """Part of a case, "outer" or "inner"; None when it is rigid.

    Raises
    ------
    BadCase
        when no such ring can exist
    """
    bearing, ring_case = case.bearing, getattr(case.rings, name)
    if ring_case.kind == "rigid":
        return None
    material = case.materials.ring(name)
    try:
        return BoltedGrooveRing(
            race="outer" if name == "outer" else "inner",
            pitch_diameter=bearing.pitch_diameter,
            ball_diameter=bearing.ball.diameter,
            groove_radius=getattr(bearing, name).over(bearing.ball.diameter) * bearing.ball.diameter,
            contact_angle=bearing.contact_angle,
            elastic=fem.Elastic(youngs_modulus=material.youngs_modulus, poisson_ratio=material.poisson_ratio),
            **_section(ring_case),
        )
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {name} ring: {problem}") from problem


def _section(ring_case: BoltedRing) -> dict:
    return {
        "groove_end": ring_case.groove_end,
        "far_diameter": getattr(ring_case, ring_case.far),
        "width": ring_case.width,
        "face_distance": ring_case.face_distance,
        "face_side": 1 if ring_case.face == "+x" else -1,
        "normal_stiffness": ring_case.face_stiffness or inf,
        "shear_stiffness": ring_case.face_shear_stiffness or inf,
    }


def _row(case: FourPointCase, name: str, part: BoltedGrooveRing, report: Report) -> NDArray:
    """Compliance of one ring by arches and components (outward, +x) [m/N]."""
    from fem.raceway.harmonics import FEWEST  # its modules are not needed between rigid rings

    rings, ball = case.rings, case.bearing.ball.diameter
    line = rings.line or LINE * ball
    order, size, on_line = USUAL
    mesh = fem.MeshSize(
        order=rings.element_order or order,
        size=rings.mesh_size or size * ball,
        raceway_size=on_line * line,
    )
    arguments = part, HARMONICS, fem.Resolution(length=line, mesh_size=mesh, harmonics=rings.harmonics)
    report.stage(f"{name} ring", None)
    try:
        compliance = configured().cached(
            "ArchCompliance",
            arguments,
            lambda: condense(*arguments),
            lambda note: report.stage(f"{name} ring: {note}", None),
            lambda kept: (kept.ring, kept.length) == (part, line) and kept.harmonics >= FEWEST,
        )
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {name} ring: {problem}") from problem
    return compliance.at(case.balls)
