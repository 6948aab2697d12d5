"""How rollers and balls share a load: integrals, constants and bearings of the textbooks."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from evidence.case import Case, Findings, Number, estimate, number, numbers
from evidence.drawing import legend_beside, one
from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.contact.ellipse.point_contact import in_series
from quasidynamic.contact.line import EXPONENT, iso16281
from quasidynamic.static import static_loads
from tests.deep_groove import LEVEL, deep_groove, solved
from tests.literature.steel_bearings import PALMGREN_STEEL, steel_bearing
from tests.literature.test_friswell import GAP, LENGTH, LOAD as FRISWELL_LOAD, PRINTED, friswell
from tests.literature.test_harris209 import (
    CLEARANCE,
    LOAD,
    PER_CONTACT,
    RE_SOLVED_LARGEST,
    ROWS,
    TEXTBOOK_LARGEST,
    harris,
)
from tests.literature.test_sjovall import FULL_ROW, MANY, STRIBECK, TABLE, meant, radial_integral

SUBJECT = "How rolling elements share a load"
TABLE_SOURCE = (
    "table of Sjövall's integral in Harris, Rolling Bearing Analysis, and in makers' catalogues; the same integral by "
    "quadrature with n = 10/9."
)


def roller_integral(eps: float, rollers: int) -> float:
    """J_r of a row of rollers whose deepest is pressed by 10 um, the clearance being that of eps."""
    deepest, length = 10e-6, 10e-3
    shift = deepest / (2 * eps)
    bearing = steel_bearing(rollers, clearance=2 * shift * (1 - 2 * eps), contact_law="iso16281")
    largest = iso16281(length) * (deepest / 2) ** EXPONENT * length
    load = radial_integral(eps, EXPONENT) * rollers * largest
    return load / rollers / static_loads(bearing, load).loads.max()


def ball_integral(eps: float, balls: int) -> float:
    """J_r of a row of balls, the same way."""
    deepest = 5e-6
    shift = deepest / (2 * eps)
    bearing = deep_groove(2 * shift * (1 - 2 * eps), balls=balls, ball=5e-3, pitch=1.0, groove=2.6e-3)
    load = radial_integral(eps, 1.5) * balls * in_series(*race_contacts(bearing)) * deepest**1.5
    return load / balls / solved(bearing, (0.0, 0.0, load, 0.0, 0.0), LEVEL).loads.max()


def _names(kind: str) -> list[str]:
    return [f"{kind} at ε = {eps:g}" for eps in TABLE]


def sjovall_rollers() -> Findings:
    """Rows of many rollers at the load zones of the table, and fewer for the error."""
    ours = [roller_integral(meant(eps), MANY) for eps in TABLE]
    few = [roller_integral(meant(eps), MANY // 2) for eps in TABLE]
    again = {
        eps: (row[2], our) for (eps, row), our in zip(TABLE.items(), ours, strict=True) if eps == meant(eps)
    }
    by_table = numbers(_names("J_r, table,"), [row[0] for row in TABLE.values()], ours, digit=1e-4)
    by_quadrature = [
        number(f"J_r, n = 10/9, at ε = {eps:g}", known, our, digit=0.6e-5)
        for eps, (known, our) in again.items()
    ]
    apart = max(abs(a / b - 1) for a, b in zip(few, ours, strict=True))
    return Findings(
        numbers=(*by_table, *by_quadrature),
        errors=(estimate(f"largest change from {MANY // 2} to {MANY} rollers", apart),),
    )


def sjovall_balls() -> Findings:
    """Rows of many balls at the load zones of the table."""
    ours = [ball_integral(meant(eps), 600) for eps in TABLE]
    few = [ball_integral(meant(eps), 300) for eps in TABLE]
    rows = numbers(_names("J_r"), [row[1] for row in TABLE.values()], ours, digit=1e-4)
    apart = max(abs(a / b - 1) for a, b in zip(few, ours, strict=True))
    return Findings(numbers=rows, errors=(estimate("largest change from 300 to 600 balls", apart),))


def draw_sjovall(findings: Findings) -> Figure:
    """Table and integral over the load zone."""
    eps = np.linspace(0.08, 5, 300)
    figure, axes = one("load zone parameter ε", "J_r", xscale="log")
    for column, exponent, name in ((0, 1.1, "line"), (1, 1.5, "point")):
        integral = [radial_integral(e, exponent) for e in eps]
        axes.plot(eps, integral, label=f"integral, {name}, n = {exponent}")
        axes.plot(list(TABLE), [row[column] for row in TABLE.values()], "o", ms=4, label=f"table, {name}")
    ours = [row.ours for row in findings.numbers[: len(TABLE)]]
    axes.plot(list(TABLE), ours, "k+", ms=7, label="rollers here, n = 10/9")
    legend_beside(axes)
    return figure


def stribeck() -> Findings:
    """Largest roller load over the mean, a roller or a gap on the load line."""
    rows: list[Number] = []
    load, balance = 2e4, 0.0
    for rollers, known in STRIBECK.items():
        azimuth = 2 * np.pi * np.arange(rollers) / rollers
        for place, turn, value in zip(("roller", "gap"), (0, np.pi / rollers), known, strict=True):
            loads = static_loads(steel_bearing(rollers), load, turn).loads
            balance = max(balance, abs(loads @ np.cos(azimuth + turn) / load - 1))
            name = f"{rollers} rollers, {place} on the load line"
            rows.append(number(name, value, loads.max() * rollers / load, digit=1e-4))
    full = static_loads(steel_bearing(MANY), 1e6).loads.max() * MANY / 1e6
    of_ten_ninths, of_table = FULL_ROW
    rows.append(number("full row, n = 10/9", of_ten_ninths, full, digit=1e-4))
    rows.append(number("full row, line contact of the table", of_table, full, digit=1e-4))
    return Findings(
        numbers=tuple(rows),
        errors=(estimate("load less the sum of the roller loads, over the load", balance),),
    )


def harris_209() -> Findings:
    """Loads of the 209 bearing by three contact laws, and by the integral."""
    rows: list[Number] = []
    for law, (contact, shift, _, angle, loads) in ROWS.items():
        found = static_loads(harris(**contact), LOAD)
        along = found.ring_displacement[1]
        zone = np.degrees(np.arccos(CLEARANCE / (2 * along)))
        rows.append(number(f"{law}: shift of the ring", shift, 1e3 * along, "mm", digit=6e-6))
        rows.append(number(f"{law}: half of the load zone", angle, zone, "deg", digit=0.011))
        rows.append(number(f"{law}: load at 0 deg", loads[0], found.loads[0], "N", digit=0.06))
        rows.append(number(f"{law}: load at 25.7 deg", loads[1], found.loads[1], "N", digit=0.06))
    integral = static_loads(harris(rollers=1400, material=PER_CONTACT), 100 * LOAD).loads.max()
    rows.append(number("largest load, integral, re-solved", RE_SOLVED_LARGEST, integral, "N", digit=0.1))
    rows.append(number("largest load, textbook", TEXTBOOK_LARGEST, integral, "N", digit=5.0))
    return Findings(numbers=tuple(rows))


def draw_harris(_: Findings) -> Figure:
    """Roller loads by three contact laws."""
    figure, axes = one("azimuth from the load [deg]", "roller load [N]")
    degrees = np.arange(-3, 4) * 360 / 14
    for k, (law, (contact, *_)) in enumerate(ROWS.items()):
        loads = static_loads(harris(**contact), LOAD).loads
        axes.bar(degrees + 5 * (k - 1), loads[np.arange(-3, 4)], width=4.5, label=law)
    axes.axhline(TEXTBOOK_LARGEST, color="k", ls="--", lw=1, label="textbook's largest")
    legend_beside(axes)
    return figure


def friswell_stiffness() -> Findings:
    """Tangents along and across the load beside formula and independent sums."""
    rows: list[Number] = []
    for rollers, (tangent, across, by_formula) in PRINTED.items():
        bearing = steel_bearing(rollers, GAP, length=LENGTH, material=PALMGREN_STEEL)
        (k_across, _), (_, k) = static_loads(bearing, FRISWELL_LOAD).stiffness
        rows += [
            number(f"{rollers} rollers: k, independent sum", tangent, k, "N/m", share=5e-4),
            number(f"{rollers} rollers: k, formula", friswell(rollers), k, "N/m", share=0.05),
            number(f"{rollers} rollers: k across over k, independent sum", across, k_across / k, share=0.02),
            number(f"{rollers} rollers: k across over k, formula", by_formula, k_across / k, share=0.05),
        ]
    return Findings(numbers=tuple(rows))


CASES: Sequence[Case] = (
    Case(
        name="sjovall-rollers",
        title="Sjövall's integral, rollers",
        subject=SUBJECT,
        source=TABLE_SOURCE,
        known="J_r(ε) = (1/2π) ∫ [1 - (1 - cos ψ)/(2ε)]^n cos ψ dψ, with F = Z Q_max J_r, printed for line contact to four digits.",
        run=f"{MANY} rollers approximate the integral; the load of the integral with n = 10/9 on a static bearing with the clearance of ε.",
        numbers_from="tests/literature/test_sjovall.py",
        compute=sjovall_rollers,
        error="Half as many rollers.",
        reason="The printed table is that of n = 1.1 to one unit of its last digit; the load laws here have n = 10/9, as "
        "Palmgren's and that of ISO/TS 16281 do. The table's 1.67 is read as 5/3.",
        draw=draw_sjovall,
        caption="Table, integral and rows of rollers.",
    ),
    Case(
        name="sjovall-balls",
        title="Sjövall's integral, balls",
        subject=SUBJECT,
        source=TABLE_SOURCE,
        known="The same integral, printed for point contact (n = 1.5).",
        run="600 balls in a deep groove bearing at rest under the load of the integral; the largest ball load gives J_r back. "
        "The table's 1.67 is read as 5/3.",
        numbers_from="tests/literature/test_sjovall.py",
        compute=sjovall_balls,
        error="Half as many balls.",
    ),
    Case(
        name="stribeck",
        title="Stribeck's constants of rows without clearance",
        subject=SUBJECT,
        source="Q_max Z/F of rows of 9 to 30 rollers summed roller by roller with n = 10/9, computed independently; 4.0766 follows "
        "from the printed table (ε = 0.5), Harris, Rolling Bearing Analysis.",
        known="Largest roller load over the mean load, with a roller on the load line or the load between two.",
        run="Static bearings without clearance, Palmgren's law.",
        numbers_from="tests/literature/test_sjovall.py",
        compute=stribeck,
        error="Balance of the roller loads with the load.",
        reason="Only the last row: 4.0766 has the exponent 1.1 of the table, ours is 10/9.",
    ),
    Case(
        name="harris-209",
        title="Cylindrical roller bearing 209 of Harris",
        subject=SUBJECT,
        source="inputs of Harris, Rolling Bearing Analysis (bearing 209, 4450 N); outputs of independent solutions of the same equations; "
        "1915 N is the textbook's largest load, recalled.",
        known="Shift of the ring, load zone and roller loads by three contact laws, roller by roller and by Sjövall's integral.",
        run="Static bearings of 14 rollers, 41 µm of clearance; 1400 rollers under 100 times the load approximate the integral.",
        numbers_from="tests/literature/test_harris209.py",
        compute=harris_209,
        error="Loads balance to rounding; what is left is the printed digits. Between the three contact laws the largest load differs "
        "by 0.4 %, between rollers one by one and the integral by 2 %.",
        draw=draw_harris,
        caption="Roller loads by three contact laws; the textbook's value belongs to the integral.",
    ),
    Case(
        name="friswell",
        title="Stiffness formula of Friswell et al.",
        subject=SUBJECT,
        source="Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), pp. 182-185, as documented by ROSS "
        "(RollerBearingElement); tangents of Palmgren's law computed independently.",
        known="k = 1e9 n^0.9 l^0.8 f^0.1 along the load, 0.49, 0.66 and 0.74 of it across for 8, 12 and 16 rollers. The formula is an "
        "empirical fit: 5 %.",
        run="Tangent stiffness of static bearings, l = 30 mm, f = 500 N, a clearance of 20 nm.",
        numbers_from="tests/literature/test_friswell.py",
        compute=friswell_stiffness,
        error="Tangents are exact derivatives of the load law. Independent ratios across the load contain rollers that just touch "
        "(2 %, a rounding error there); they are kept from touching here.",
    ),
)
