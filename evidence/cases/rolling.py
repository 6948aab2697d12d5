"""Rolling contact with stick and slip against closed solutions, Kalker's table and CONTACT."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from evidence.case import Case, Findings, Number, estimate, number, numbers, over
from evidence.drawing import legend_beside, one
from quasidynamic.contact.rolling.kalker import creep_coefficients
from tests.literature import test_contact_program as program
from tests.literature.test_interface_compliance import EACH, TORQUES, rolled
from tests.literature.test_rolling_contact import (
    CARTER,
    CATTANEO,
    ROWS,
    carter,
    cattaneo,
    small_creep,
)

SUBJECT = "Rolling contact with stick and slip"
KALKER = "Kalker (1990), Three-Dimensional Elastic Bodies in Rolling Contact, appendix E."
COEFFICIENTS = "C11", "C22", "C23"
PAGE = "tests/literature/test_rolling_contact.py"


def _named(poisson: float, ratio: float) -> list[str]:
    return [f"{name}, ν = {poisson:g}, a/b = {ratio:g}" for name in COEFFICIENTS]


def _last_digit(known: float) -> float:
    """Half of the last of three printed digits."""
    return 0.5 * 10 ** (np.floor(np.log10(known)) - 2)


def kalker_table() -> Findings:
    """Coefficients of the program over Poisson's ratio and the axes."""
    rows: list[Number] = []
    for poisson, ratio, *known in ROWS:
        ours = creep_coefficients(ratio, poisson)
        rows += [
            number(name, one_known, our, digit=_last_digit(one_known))
            for name, one_known, our in zip(_named(poisson, ratio), known, ours, strict=True)
        ]
    return Findings(numbers=tuple(rows))


def kalker_solved() -> Findings:
    """Coefficients found by the half-space, all sticking, at ν = 0.25."""
    rows: list[Number] = []
    apart = 0.0
    for poisson, ratio, *known in ROWS:
        if poisson != 0.25:
            continue
        coarse, fine = (small_creep(poisson, ratio, cells) for cells in (30, 60))
        apart = max(apart, *(abs(a / b - 1) for a, b in zip(coarse, fine, strict=True)))
        rows += [
            number(name, one_known, our, digit=_last_digit(one_known))
            for name, one_known, our in zip(_named(poisson, ratio), known, fine, strict=True)
        ]
    return Findings(
        numbers=tuple(rows), errors=(estimate("largest change from 30 x 30 to 60 x 60 cells", apart),)
    )


def draw_kalker(findings: Findings) -> Figure:
    """Coefficients over the axes at ν = 0.25."""
    figure, axes = one("a/b", "coefficient")
    ratios = np.geomspace(0.1, 1, 40)
    fitted = np.array([creep_coefficients(ratio, 0.25) for ratio in ratios])
    places = [row[1] for row in ROWS if row[0] == 0.25]
    for k, name in enumerate(COEFFICIENTS):
        rows = findings.numbers[k::3]
        (line,) = axes.plot(ratios, fitted[:, k], label=f"{name}, program's table")
        axes.plot(
            places, [row.known for row in rows], "o", ms=4, color=line.get_color(), label=f"{name}, Kalker"
        )
        axes.plot(places, [row.ours for row in rows], "k+", ms=7, label="solved on cells" if k == 0 else None)
    legend_beside(axes)
    return figure


def carter_cylinders() -> Findings:
    """Force and sticking length of cylinders under Carter's creep."""
    rows: list[Number] = []
    for share in CARTER:
        force, sticking, _ = carter(share)
        rows.append(number(f"force over its limit, creep of {share:g}", share, force, share=5e-3))
        rows.append(
            number(f"length that sticks over 2a, {share:g}", np.sqrt(1 - share), sticking, digit=5e-3)
        )
    apart = max(abs(carter(share, 100)[0] / carter(share, 200)[0] - 1) for share in CARTER)
    return Findings(
        numbers=tuple(rows), errors=(estimate("largest change of the force from 100 to 200 cells", apart),)
    )


def draw_carter(_: Findings) -> Figure:
    """Force over creep."""
    figure, axes = one("creep over that of full sliding", "force over its limit")
    creep = np.linspace(0, 1, 100)
    axes.plot(creep, 1 - (1 - creep) ** 2, label="Carter")
    shares = np.linspace(0.05, 0.99, 12)
    axes.plot(
        1 - np.sqrt(1 - shares), [carter(share)[0] for share in shares], "o", ms=4, label="ours, 200 cells"
    )
    legend_beside(axes)
    return figure


def cattaneo_spheres() -> Findings:
    """Force and sticking radius of spheres under the shift of Cattaneo and Mindlin."""
    rows: list[Number] = []
    for share in CATTANEO:
        force, radius = cattaneo(share)
        rows.append(number(f"force over its limit, shift of {share:g}", share, force, share=2e-3))
        rows.append(
            number(f"radius that sticks over a, {share:g}", (1 - share) ** (1 / 3), radius, digit=2 / 64)
        )
    apart = max(abs(cattaneo(share, 32)[0] / cattaneo(share, 64)[0] - 1) for share in CATTANEO)
    return Findings(
        numbers=tuple(rows), errors=(estimate("largest change of the force from 32 to 64 cells", apart),)
    )


def against_contact() -> Findings:
    """Steady, transient and conforming contacts as in the program CONTACT."""
    rows: list[Number] = []
    apart = 0.0
    for name, ellipse in {**program.STEADY, "44 x 44 cells": program.FINE}.items():
        share = program.ALLOWED if ellipse is program.FINE else program.TABLE_ALLOWED
        limit, known = ellipse.limit, (*ellipse.force, ellipse.moment)
        names = (f"{name}: {what}" for what in ("force along", "force across", "spin moment"))
        scales = (limit, limit, limit * ellipse.length)
        found = ellipse.solved()
        rows += [
            *(
                Number(name=row, known=value, ours=float(ours), unit=unit, allowed=share * scale, scale=scale)
                for row, value, ours, scale, unit in zip(
                    names, known, found, scales, ("N", "N", "N m"), strict=True
                )
                if value
            )
        ]
        if ellipse is program.FINE:
            fine = ellipse.solved(finer=2)
            apart = max(abs(a - b) / size for a, b, size in zip(found, fine, scales, strict=True))
    for step, creep in program.onset_of_rolling().items():
        name = f"onset of rolling, {step} cells: creep" if step else "onset of rolling: shift"
        rows.append(number(name, program.ONSET[step], creep, "-" if step else "mm", share=2e-3))
    for (distance, creep), known in program.CONFORMAL.items():
        force, along, across, moment = program.conformal(distance, creep)
        limit, name = 0.3 * known[0], f"wheel on rail, distance {distance}, creep {creep}"
        rows += [
            number(f"{name}: normal force", known[0], force, "N", share=2e-3),
            *over(
                1.0,
                numbers(
                    (f"{name}: force {way} over μN" for way in ("along", "across")),
                    known[1:3],
                    (along / limit, across / limit),
                    "-",
                    digit=2e-3,
                ),
            ),
            number(f"{name}: spin moment", known[3], moment, "N m", share=2e-3),
        ]
    return Findings(
        numbers=tuple(rows),
        errors=(estimate("44 against 88 cells each way, over μN", apart),),
    )


def interface() -> Findings:
    """Torque of a ball over an interface that shears."""
    rows: list[Number] = []
    for name, slip in EACH:
        ball = rolled(name, 1e-6 * slip)
        rows.append(
            number(
                f"{name}, {slip} µm at the limit of friction",
                TORQUES[name][slip],
                ball.extrapolated_torque,
                "N m",
                share=0.02,
            )
        )
    return Findings(numbers=tuple(rows))


CASES: Sequence[Case] = (
    Case(
        name="kalker-table",
        title="Kalker's creep coefficients, table of the program",
        subject=SUBJECT,
        source=KALKER,
        known="C11, C22, C23 for three values of ν and several a/b, to three digits.",
        run="The coefficients that FASTSIM takes, interpolated from solutions of the half-space.",
        numbers_from=PAGE,
        compute=kalker_table,
        error="Printed to three digits. Solutions on 80 x 80 cells that stick are within 0.6 % (C11, C22) and 1.5 % (C23) of the table.",
    ),
    Case(
        name="kalker-solved",
        title="Kalker's creep coefficients, solved on cells",
        subject=SUBJECT,
        source=KALKER,
        known="The same at ν = 0.25.",
        run="Half-spaces on 60 x 60 cells with so much friction that all sticks; small longitudinal and lateral creep and spin.",
        numbers_from=PAGE,
        compute=kalker_solved,
        error="Half as many cells each way; the table itself was computed on far fewer elements.",
        draw=draw_kalker,
        caption="Coefficients over the ratio of the axes, ν = 0.25.",
        slow=True,
    ),
    Case(
        name="carter",
        title="Carter: cylinders that roll under a tangential force",
        subject=SUBJECT,
        source="Carter (1926); Johnson, Contact Mechanics (1985), sec. 8.3.",
        known="Force and length that sticks over the creep: a closed solution.",
        run="200 cells along the contact, so wide that it is a line.",
        numbers_from=PAGE,
        compute=carter_cylinders,
        error="Half as many cells; one cell is 0.5 % of the length.",
        draw=draw_carter,
        caption="Force over creep.",
    ),
    Case(
        name="cattaneo-mindlin",
        title="Cattaneo and Mindlin: spheres under a side force",
        subject=SUBJECT,
        source="Cattaneo (1938), Mindlin (1949); Johnson, Contact Mechanics (1985), Eqs (7.41) and (7.42).",
        known="Force over the shift, and the radius of the part that sticks: a closed solution that leaves out the slip across the force.",
        run="64 x 64 cells, without rolling.",
        numbers_from=PAGE,
        compute=cattaneo_spheres,
        error="Half as many cells; one cell is 3 % of the radius.",
    ),
    Case(
        name="contact-program",
        title="Steady, transient and conforming contacts as in the program CONTACT",
        subject=SUBJECT,
        source="CONTACT (Vollebregt), open source version, revision 2707 of 2025-07-23, reference outputs of its examples.",
        known="Forces and moments of five ellipses in 20 steady states with creep along, across and spin, drawn from 3220, and one on finer cells; creep in the onset of rolling after a shift; a wheel's fillet of 10.2 mm on a rail of 10 mm.",
        run="Its cells, gaps, loads and creeps. Forces are over μN, moments over μN sqrt(ab). Rolling from a shift by `tests/reference/rolling_steps.py`, whose steady end the program solves at once.",
        numbers_from="tests/literature/test_contact_program.py",
        compute=against_contact,
        error="On the same cells all six printed decimals of the 20 agree; the others are printed to four digits. Of conforming contacts only those with the influence numbers of half-spaces are compared; the program has no others.",
        slow=True,
    ),
    Case(
        name="interface-compliance",
        title="An interface that shears: the penalty of finite elements",
        subject=SUBJECT,
        source="an independent solution of the same equations for cases of Heras et al. (2017) with the pressure of the true profiles.",
        known="Torque of two cases over the elastic slip at the limit of friction.",
        run="`friction.interface_compliance` on half-spaces, 20 x 40 cells and the grid extrapolated.",
        numbers_from="tests/literature/test_interface_compliance.py",
        compute=interface,
        error="Each torque is extrapolated from three grids; the pressure is that of Hertz here (2 %).",
        slow=True,
    ),
)
