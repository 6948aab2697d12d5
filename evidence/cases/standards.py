"""Tables of ISO 281, ISO 76, ISO/TS 16281 and of fits."""

from collections.abc import Iterable, Sequence
from typing import get_args

import numpy as np
from matplotlib.figure import Figure

from evidence.case import Case, Findings, Number, number, numbers, rounding
from evidence.cases.worked import findings
from evidence.drawing import legend_beside, one
from flexbearing.case.tolerances import (
    ClearanceClass,
    deviations,
    housing_interference,
    initial_clearance,
    shaft_interference,
)
from quasidynamic.contact.line import fujiwara_kawase, lundberg
from quasidynamic.outcome.ball_capacity import ball_geometry_factor
from quasidynamic.outcome.ball_equivalent_load import ball_dynamic_load, ball_static_load
from quasidynamic.outcome.capacity import geometry_factor
from quasidynamic.outcome.life import edge_stress_factor
from quasidynamic.outcome.life_factors import (
    BALLS,
    CLEANLINESS,
    ROLLERS,
    contamination_factor,
    modification_factor,
    reliability_factor,
)
from tests.literature import test_iso76 as iso76, test_iso281 as iso281, test_masta_iso16281 as masta
from tests.literature.test_fits_and_clearances import HOUSING_ROWS, PRINTED, SHAFT_ROWS, diameters
from tests.literature.test_life import (
    CONTAMINATION,
    EDGE_FACTORS,
    RATINGS,
    REFERENCE_LIVES,
    life_of_sliced,
    rigid_loads,
)
from tests.literature.test_mesys_crowning import MODULUS, RELIEF, STRESS

Interval = tuple[float, float]  # two limits [m]
SUBJECT = "Ratings and lives of the standards"
DIGITS = "Formulas of the standard; rounding only. The source is good to half of its last printed digit."


def gammas(count: int, first: int = 1) -> list[str]:
    """Names of the rows of a table over gamma."""
    return [f"γ = {k / 100:.2f}" for k in range(first, first + count)]


def balls_281() -> Findings:
    """f_c of balls."""
    ours = [ball_geometry_factor(iso281.row(k / 100)) for k in range(1, 41)]
    return Findings(numbers=numbers(gammas(40), iso281.OF_BALLS, ours, digit=iso281.DIGIT))


def rollers_281() -> Findings:
    """f_c of rollers."""
    ours = [geometry_factor(k / 100) for k in range(1, 31)]
    return Findings(numbers=numbers(gammas(30), iso281.OF_ROLLERS, ours, digit=iso281.DIGIT))


def static_76() -> Findings:
    """f_0 of balls."""
    ours = [iso76.static_factor(iso76.row(max(k, 1e-6) / 100)) for k in range(41)]
    return Findings(numbers=numbers(gammas(41, 0), iso76.F_0, ours, digit=iso281.DIGIT))


def draw_factor(findings: Findings, name: str) -> Figure:
    """A table over gamma, and ours."""
    gamma = [float(row.name.split("= ")[1]) for row in findings.numbers]
    figure, axes = one("γ = D cos α / D_pw", name)
    axes.plot(gamma, [row.known for row in findings.numbers], "o", ms=4, label="table")
    axes.plot(gamma, [row.ours for row in findings.numbers], label="ours")
    legend_beside(axes)
    return figure


def draw_f_c(findings: Findings) -> Figure:
    """f_c."""
    return draw_factor(findings, "f_c")


def draw_f_0(findings: Findings) -> Figure:
    """f_0."""
    return draw_factor(findings, "f_0")


def load_factors() -> Findings:
    """X, Y, e of ISO 281 and X_0, Y_0 of ISO 76."""
    rows: list[Number] = []
    for angle, relative, x, y, e in iso281.TABLE_3:
        load = ball_dynamic_load(1.0, 2 * e, np.radians(angle), relative)
        ours = load.radial_factor, load.axial_factor, load.limit
        names = (f"{name} at {angle}°, f_0 F_a/C_0 = {relative:g}" for name in ("X", "Y", "e"))
        rows += numbers(names, (x, y, e), ours, digit=1e-9)
    for angle, x, y in iso76.TABLE_2:
        load = ball_static_load(1.0, 5.0, np.radians(angle))
        rows.append(number(f"X_0 at {angle}°", x, load.radial_factor, digit=1e-9))
        rows.append(number(f"Y_0 at {angle}°", y, load.axial_factor, digit=1e-9))
    return Findings(numbers=tuple(rows))


def modification() -> Findings:
    """a_ISO by equations entered twice, e_C by constants entered twice."""
    rows: list[Number] = []
    for kappa, share in iso281.CONDITIONS:
        for kind, body, known in zip(
            ("balls", "rollers"), (BALLS, ROLLERS), iso281.modification(kappa, share), strict=True
        ):
            name = f"a_ISO of {kind}, κ = {kappa:g}, e_C C_u/P = {share:g}"
            rows.append(number(name, known, modification_factor(kappa, share, body).value, share=1e-12))
    for name, (rise, loss) in CONTAMINATION.items():
        known = min(rise * 100**0.55, 1.0) * (1 - loss / 100 ** (1 / 3))
        rows.append(
            number(
                f"e_C, κ = 1, 100 mm, {name}",
                known,
                contamination_factor(1.0, 0.1, CLEANLINESS[name]),
                share=1e-12,
            )
        )
    return Findings(numbers=tuple(rows))


def reliability() -> Findings:
    """a_1."""
    ours = [reliability_factor(share).value for share in iso281.RELIABILITY]
    return Findings(
        numbers=tuple(
            number(f"a_1 at {100 * share:g} %", known, our, digit=5e-3 if share < 0.999 else 5e-4)
            for (share, known), our in zip(iso281.RELIABILITY.items(), ours, strict=True)
        )
    )


def draw_reliability(findings: Findings) -> Figure:
    """a_1 over the probability of failure."""
    figure, axes = one("probability of failure", "a_1", xscale="log")
    failing = 1 - np.array(list(iso281.RELIABILITY))
    axes.plot(failing, [row.known for row in findings.numbers], "o", ms=4, label="table 12")
    axes.plot(failing, [row.ours for row in findings.numbers], label="Weibull curve, ours")
    legend_beside(axes)
    return figure


def ball_lives() -> Findings:
    """Lives and displacements of ISO/TS 16281."""
    rows: list[Number] = []
    for name, (loads, known) in masta.LIVES.items():
        state = masta.solved(**loads)
        rows.append(number(f"{name}: life", known, masta.life(state), "10^6", share=1e-4))
        for place, component, moved in zip(
            ("axial", "radial"), (0, 2), masta.DISPLACEMENTS.get(name, (None, None)), strict=True
        ):
            if moved is not None:
                ours = 1e6 * state.ring_displacement[component]
                rows.append(number(f"{name}: {place} displacement", moved, ours, "µm", share=1e-4))
    ours = masta.life(masta.solved(moment=masta.WIDER))
    rows.append(number("1 N m: life", masta.UNDER_A_MOMENT, ours, "10^6", share=1e-4))
    return Findings(numbers=tuple(rows))


def roller_lives() -> Findings:
    """Ratings and reference lives of the bearing of Mao et al."""
    rows = list(findings(RATINGS).numbers)
    for clearance, (_, largest, life, at_edges) in REFERENCE_LIVES.items():
        where = f"clearance {1e3 * clearance:g} µm"
        if largest:
            ours = rigid_loads(clearance)[0].max()
            rows.append(number(f"{where}: largest load", largest, ours, "N", share=2e-3))
        rows.append(number(f"{where}: reference life", life, life_of_sliced(clearance), "10^6", share=5e-3))
        if at_edges:
            ours = life_of_sliced(clearance, edge_stress=True)
            rows.append(number(f"{where}: life with edge stress", at_edges, ours, "10^6", share=5e-3))
    factor = edge_stress_factor(30)
    rows += [
        number(f"edge stress factor, slice {k + 1} of 30", f, factor[k], digit=5e-4)
        for k, f in EDGE_FACTORS.items()
    ]
    return Findings(numbers=tuple(rows))


def profiles() -> Findings:
    """Relief of ISO/TS 16281 as that of Lundberg, and as a profile of three parameters."""
    rows: list[Number] = []
    for diameter in (5e-3, 20e-3):
        for slenderness in (1.0, 1.7):
            length = slenderness * diameter
            load = np.pi * diameter * STRESS**2 / MODULUS * length
            ours = lundberg(load, length, MODULUS).amplitude / diameter
            rows.append(
                number(
                    f"Lundberg at 3000 MPa over D, D {1e3 * diameter:g} mm, l/D {slenderness:g}",
                    RELIEF,
                    ours,
                    digit=5e-6,
                )
            )
    diameter, length = 10e-3, 12e-3
    load = np.pi * diameter * STRESS**2 / MODULUS * length
    deep = fujiwara_kawase(load, length, MODULUS, load_factor=1.0, crowned_share=1.0, end_drop=1e-3)
    for place in (0.5, 0.8, 0.95):
        known = RELIEF * diameter * np.log(1 / (1 - place**2))
        ours = float(deep.drop(np.array([place * length / 2]), length)[0])
        rows.append(
            number(f"drop at {place:g} l/2, three parameters", 1e6 * known, 1e6 * ours, "µm", share=5e-3)
        )
    return Findings(numbers=tuple(rows))


def apart(found: Iterable[Interval], printed: Sequence[float]) -> float:
    """Largest difference of limits [m] from printed ones [um]."""
    limits = [1e6 * limit for pair in found for limit in pair]
    return float(np.abs(np.subtract(limits, printed)).max())


def of_a_shaft(name: str, diameter: float, fit: Sequence[float]) -> list[Interval]:
    """Deviations and, where printed, the resultant fit."""
    band, tight = deviations(name, diameter), shaft_interference(name, diameter) if fit else None
    return [(band.greatest, band.least), *([(-tight.greatest, -tight.least)] if tight else [])]


def of_a_housing(name: str, diameter: float, fit: Sequence[float]) -> list[Interval]:
    """Deviations and, where printed, the resultant fit."""
    band, tight = deviations(name, diameter), housing_interference(name, diameter) if fit else None
    return [(band.least, band.greatest), *([(-tight.greatest, -tight.least)] if tight else [])]


def of_a_bearing(of: str, diameter: float) -> list[Interval]:
    """Clearances of all classes."""
    bands = [initial_clearance(name, diameter, of) for name in get_args(ClearanceClass)]
    return [(band.least, band.greatest) for band in bands]


def fits() -> Findings:
    """Largest difference of every printed deviation, fit and clearance."""
    rows = []
    for what, table, limits_of in (
        ("shafts and their fits", SHAFT_ROWS, of_a_shaft),
        ("housings and their fits", HOUSING_ROWS, of_a_housing),
    ):
        left = max(
            apart(limits_of(name, diameter, fit), [*limits, *fit])
            for name, over, upto, limits, fit in table
            for diameter in diameters(over, upto)
        )
        rows.append((what, sum(len(limits) + len(fit) for *_, limits, fit in table), left))
    left = max(
        apart(of_a_bearing(of, diameter), limits)
        for of, over, upto, limits in PRINTED
        for diameter in diameters(max(over, 6.0), upto)
    )
    rows.append(("clearance classes", sum(len(limits) for *_, limits in PRINTED), left))
    return Findings(
        numbers=tuple(
            rounding(f"{what}, {count} printed numbers: largest difference", left, 1.0, "µm")
            for what, count, left in rows
        )
    )


CASES: Sequence[Case] = (
    Case(
        name="iso281-fc-balls",
        title="ISO 281, table 2: f_c of ball bearings",
        subject=SUBJECT,
        source="ISO 281 (2007), table 2, read in GOST 18855-2013.",
        known="f_c of radial and angular-contact ball bearings at 40 values of γ, to 0.1.",
        run="The formula that continues the table to any groove, with grooves of 0.52 and 0.53.",
        numbers_from="tests/literature/test_iso281.py",
        compute=balls_281,
        error=DIGITS,
        draw=draw_f_c,
        caption="Table and formula.",
    ),
    Case(
        name="iso281-fc-rollers",
        title="ISO 281, table 7: f_c of roller bearings",
        subject=SUBJECT,
        source="ISO 281 (2007), table 7, read in GOST 18855-2013.",
        known="f_c of radial roller bearings at 30 values of γ, to 0.1.",
        run="The formula of Lundberg and Palmgren behind the table.",
        numbers_from="tests/literature/test_iso281.py",
        compute=rollers_281,
        error=DIGITS,
        remarks="The formula meets the table to one unit of its last digit, not always to half of one.",
        draw=draw_f_c,
        caption="Table and formula.",
    ),
    Case(
        name="iso281-load-factors",
        title="ISO 281, table 3, and ISO 76, table 2: load factors",
        subject=SUBJECT,
        source="ISO 281 (2007), table 3, read in GOST 18855-2013; ISO 76 (2006), table 2, read in GOST 18854-2013.",
        known="X, Y, e and X_0, Y_0 over the contact angle.",
        run="Factors at printed angles and relative axial loads; the tables were entered twice, in the program and in the test.",
        numbers_from="tests/literature/test_iso281.py",
        compute=load_factors,
        error="None: the same table.",
    ),
    Case(
        name="iso281-modification",
        title="ISO 281, annex A and Eqs. 31 to 36: a_ISO and e_C",
        subject=SUBJECT,
        source="ISO 281 (2007), Eqs. 31 to 36 and annex A.4 to A.6.",
        known="Life modification factor over κ and e_C C_u/P; contamination factor of 14 degrees of cleanliness.",
        run="The equations were entered twice, in the program and in the test.",
        numbers_from="tests/literature/test_iso281.py",
        compute=modification,
        error="Rounding.",
    ),
    Case(
        name="iso281-reliability",
        title="ISO 281, table 12: reliability",
        subject=SUBJECT,
        source="ISO 281 (2007), table 12, read in GOST 18855-2013.",
        known="a_1 from 90 to 99.95 %, printed to one or two digits.",
        run="The Weibull curve of three parameters behind the table.",
        numbers_from="tests/literature/test_iso281.py",
        compute=reliability,
        error="Rounding. The table is good to half of its last digit: 0.01, and 0.001 from 99.9 % on.",
        draw=draw_reliability,
        caption="Table and curve.",
    ),
    Case(
        name="iso76-f0",
        title="ISO 76, table 1: f_0 of ball bearings",
        subject=SUBJECT,
        source="ISO 76 (2006), table 1, read in GOST 18854-2013.",
        known="f_0 of radial and angular-contact ball bearings at 41 values of γ, to 0.1.",
        run="Hertz's contact of 4200 MPa in grooves of 0.52 and 0.53, which is what the table stands for.",
        numbers_from="tests/literature/test_iso76.py",
        compute=static_76,
        error=DIGITS,
        remarks="All values but that at γ = 0.13 round to the printed one.",
        draw=draw_f_0,
        caption="Table and formula.",
    ),
    Case(
        name="iso16281-balls",
        title="ISO/TS 16281: deep groove ball bearing against MASTA",
        subject=SUBJECT,
        source="minzhun/ISO16281 on GitHub (Test_BallBearing.py), which by its variables prints numbers of MASTA.",
        known="Reference lives and displacements under radial and axial load and a moment, with and without clearance.",
        run="Seven balls of 11.5 mm on 43.5 mm at rest, lives by ISO/TS 16281.",
        numbers_from="tests/literature/test_masta_iso16281.py",
        compute=ball_lives,
        error="The balance is solved to 1e-9; differences come from E, ν and elliptic integrals (1e-4).",
        reason="Only the life under a moment: ISO/TS 16281 gives ball loads half the pitch diameter as lever, here it is the radius of the "
        "inner groove centres, 1.06 % more. The moment was made larger by as much; 0.6 % is left.",
    ),
    Case(
        name="iso16281-rollers",
        title="ISO/TS 16281: roller bearing against an independent program",
        subject=SUBJECT,
        source="an independent program of ISO 281 and ISO/TS 16281 for the bearing of Mao, Wang and Zhang (2016), Appl. Sci. 6, 415.",
        known="Ratings, reference lives of rigid rings at three clearances, edge stress factors.",
        run="The same formulas on loads from a static model of three lines; 30 slices.",
        numbers_from="tests/literature/test_life.py",
        compute=roller_lives,
        error="Loads of the three-line model meet the printed ones within 0.2 %; life is inversely proportional to their fourth power.",
    ),
    Case(
        name="iso16281-profile",
        title="ISO/TS 16281: the logarithmic profile",
        subject=SUBJECT,
        source="manual of the bearing software of MESYS, www.mesys.ag/manual/crowning.html, read in 2026.",
        known="The relief 0.00035 D of ISO/TS 16281 is that of Lundberg at a contact stress of 3000 MPa; the profile of Fujiwara et al. "
        "with that stress and no bound at the end is the same.",
        run="Both profiles with E = 206 GPa, ν = 0.3 on a flat raceway.",
        numbers_from="tests/literature/test_mesys_crowning.py",
        compute=profiles,
        error="Closed forms; the printed 0.00035 has two digits.",
    ),
    Case(
        name="fits-and-clearances",
        title="Fits and clearance classes of catalogues",
        subject="Catalogues",
        source="SKF, Rolling bearings (2018), section B.6, tables 11 to 21, and its table of radial clearance; JIS B 0401 as Sumitomo prints "
        "it; NTN, Ball and Roller Bearings, pages A-58 and A-59.",
        known="Deviations of shafts and housings, resultant fits, radial clearance of C2, Normal, C3 and C4.",
        run="Every class at three diameters of every step: just over its lower limit, within it, and its upper limit.",
        numbers_from="tests/literature/test_fits_and_clearances.py",
        compute=fits,
        error="Rounding.",
    ),
)
