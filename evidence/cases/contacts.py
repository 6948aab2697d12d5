"""Line contacts: Hertz, films, stresses below the surface, slices against half-spaces."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from matplotlib.figure import Figure

import flexbearing
from evidence.case import Case, Findings, Number, estimate, number, numbers
from evidence.drawing import legend_beside, one
from quasidynamic.contact.ellipse.point_contact import Curvatures, point_contact
from quasidynamic.contact.ellipse.subsurface import ellipse_stress, orthogonal_shear
from quasidynamic.contact.line import LoadLaw, half_width, palmgren, peak_pressure
from quasidynamic.contact.line.slices import line_contact_stress
from quasidynamic.contact.pressure.roller import RollerOnRaceway
from quasidynamic.contact.traction.adore import ADORE_OILS
from quasidynamic.outcome.subsurface import largest_von_mises
from quasidynamic.parts.material import Material
from quasidynamic.parts.profile import Crowned, Straight
from tests.literature import test_subsurface_stress as below
from tests.literature.test_adore_oils import PRINTED as ADORE
from tests.literature.test_film_formulas import WORKED, film
from tests.literature.test_line_contact import PROBLEMS, STORED, beside_the_middle, films
from tests.quasidynamic.test_whole_roller import ARCMIN, FORCE, LENGTH, MODULUS, RADIUS, STEEL, roller
from tests.reference.test_resolved_contact import RINGS, contact_law, resolved, structure

SUBJECT = "Contacts, films, stresses below the surface"
SLICES = (20, 40, 80, 160, 320, 640)


def line_contacts() -> Findings:
    """Hertz and films of two textbook problems."""
    rows: list[Number] = []
    for name, problem in PROBLEMS.items():
        strip = 1e6 * half_width(problem.line_load, problem.radii, problem.elastic)
        peak = 1e-9 * peak_pressure(problem.line_load, problem.radii, problem.elastic)
        for what, known, ours, unit, share in (
            ("half-width", problem.half_width, strip, "µm", 4e-5),
            ("peak pressure", problem.pressure, peak, "GPa", 5e-5),
            ("film, Dowson", problem.dowson, 1e6 * films(problem, "dowson"), "µm", 2e-5),
            ("film, Pan and Hamrock", problem.pan_hamrock, 1e6 * films(problem, "pan_hamrock"), "µm", 2e-5),
        ):
            rows += numbers(
                (f"{name}: {what}, {side}" for side in ("inner", "outer")), known, ours, unit, share=share
            )
    stored = (f"DTU: stored pressure at {1e6 * place:g} µm" for place, _ in STORED)
    rows += numbers(stored, (p for _, p in STORED), beside_the_middle(), "GPa", share=2e-6)
    return Findings(numbers=tuple(rows))


def film_formulas() -> Findings:
    """Worked films of five formulas."""
    places = "inner 3537 N", "inner 1000 N", "outer 3537 N", "outer 92 N"
    rows = [
        numbers((f"{name}, {place}" for place in places), known, 1e6 * film(name), "µm", digit=0.6e-4)
        for name, known in WORKED.items()
    ]
    return Findings(numbers=sum(rows, ()))


def adore_oils() -> Findings:
    """Viscosity and its temperature coefficient of six oils."""
    rows: list[Number] = []
    for name, (_, viscosity, (at_313, power)) in ADORE.items():
        oil = ADORE_OILS[name]
        for kelvin in (313.0, 373.0, 420.0):
            where = f"{name}, {kelvin:g} K"
            slope = at_313 * (kelvin / 313) ** power
            rows.append(
                number(f"{where}: viscosity", viscosity(kelvin), oil.viscosity(kelvin), "Pa s", share=1e-9)
            )
            rows.append(
                number(f"{where}: -d ln η/dT", slope, oil.temperature_viscosity(kelvin), "1/K", share=1e-9)
            )
    return Findings(numbers=tuple(rows))


def stresses_below() -> Findings:
    """Largest stresses over the peak pressure and their depths."""
    line = partial(line_contact_stress, poisson_ratio=0.3)
    circle = partial(ellipse_stress, axis_ratio=1.0, poisson_ratio=0.3)
    found = {
        "shear stress": (
            below.SHEAR,
            below.largest_on_the_axis(line(0.0, below.DEPTH)),
            below.largest_on_the_axis(circle(0.0, below.DEPTH)),
        ),
        "von Mises stress": (below.VON_MISES, largest_von_mises(line), largest_von_mises(circle)),
        "orthogonal shear stress": (
            below.ORTHOGONAL,
            orthogonal_shear(1.0, 1.0, 0.0),
            orthogonal_shear(1.0, 1.0, 1.0),
        ),
    }
    rows: list[Number] = []
    for what, (known, *ours) in found.items():
        for shape, values in zip(known, ours, strict=True):
            rows += numbers(
                (f"{shape}: {what} over p0", f"{shape}: its depth"), known[shape], values, digit=1e-3
            )
    return Findings(numbers=tuple(rows))


def draw_below(_: Findings) -> Figure:
    """Principal shear stress below line and circle."""
    depth = np.linspace(0.01, 2.5, 300)
    figure, axes = one("depth over half-width or radius", "largest shear stress over p0")
    axes.plot(depth, line_contact_stress(0.0, depth, 0.3).principal_shear, label="line, ours")
    axes.plot(depth, ellipse_stress(0.0, depth, 1.0, 0.3).principal_shear, label="circle, ours")
    for shape, (value, place) in below.SHEAR.items():
        axes.plot(place, value, "o", ms=5, label=f"{shape}, Johnson")
    legend_beside(axes)
    return figure


def whole_rollers() -> Findings:
    """A long roller in its middle, and one that is crowned all along."""
    pressed = roller(length=40e-3, cells=(64, 128)).tilted(FORCE * 8, 0.0)
    middle = slice(56, 72)
    hertz = float(peak_pressure(pressed.line_load[middle].mean(), RADIUS, MODULUS))
    along = float(pressed.largest_along[middle].mean())
    rows = [number("long roller: peak pressure in its middle", 1e-6 * hertz, 1e-6 * along, "MPa", share=2e-3)]
    ellipse = point_contact(Curvatures(np.array(1 / 0.5), np.array(1 / RADIUS)), MODULUS)
    peak, approach = float(ellipse.peak_pressure(50.0)), float(ellipse.approach(50.0))
    shape = Crowned(straight_length=0.0, crown_radius=0.5)
    coarse, fine = (roller(shape, cells=(n, 4 * n)).tilted(50.0, 0.0) for n in (32, 64))
    rows.append(
        number("crowned roller: peak pressure", 1e-6 * peak, 1e-6 * fine.peak_pressure, "MPa", share=1e-3)
    )
    rows.append(number("crowned roller: approach", 1e6 * approach, 1e6 * fine.approach, "µm", share=5e-4))
    return Findings(
        numbers=tuple(rows),
        errors=(
            estimate(
                "peak pressure, half as many cells each way",
                abs(coarse.peak_pressure / fine.peak_pressure - 1),
            ),
            estimate("approach, half as many cells each way", abs(coarse.approach / fine.approach - 1)),
        ),
    )


RATIOS = (0.5, 1.0, 2.5)  # length over diameter
MATERIAL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0)


def on_half_space(ratio: float, cells: int) -> tuple[float, float]:
    """Translation and tilt stiffness of a straight roller on half-spaces [N/m], [N m/rad]."""
    length, force, tilt = ratio * 2 * RADIUS, FORCE * ratio * 2 * RADIUS / LENGTH, 0.05 * ARCMIN
    body = RollerOnRaceway(
        pair=STEEL, radius=RADIUS, length=length, drop=lambda y: Straight().drop(y, length), cells=(32, cells)
    )
    low, high = (body.tilted(force * share, 0.0).approach for share in (0.99, 1.01))
    return 0.02 * force / (high - low), body.tilted(force, tilt).moment / tilt


def by_slices(ratio: float) -> tuple[float, float]:
    """The same of slices by Palmgren's law, in closed form."""
    length, force = ratio * 2 * RADIUS, FORCE * ratio * 2 * RADIUS / LENGTH
    law = LoadLaw(palmgren(MATERIAL, MATERIAL, length), 1e-12)
    deep = (force / length / law.coefficient) ** 0.9
    slope = float(law(np.array(deep))[1])  # of the load per length [Pa]
    return slope * length, slope * length**3 / 12


def slice_tilt() -> Findings:
    """Tilt stiffness over translation stiffness, over that of independent slices."""
    rows, errors = [], []
    for ratio in RATIOS:
        (k, k_tilt), (coarse, coarse_tilt) = (on_half_space(ratio, cells) for cells in (512, 256))
        s, s_tilt = by_slices(ratio)
        name = f"l/D {ratio:g}: tilt over translation stiffness, over l²/12"
        unit = (ratio * 2 * RADIUS) ** 2 / 12
        rows.append(number(name, k_tilt / k / unit, s_tilt / s / unit, share=2e-3))
        errors.append(
            estimate(f"l/D {ratio:g}, half as many cells", abs(coarse_tilt / coarse / (k_tilt / k) - 1))
        )
    return Findings(numbers=tuple(rows), errors=tuple(errors))


def life_of_slices() -> Findings:
    """Life of the sliced bearing, 20 slices against 640."""
    lives = {
        count: flexbearing.run("configs/mao2016.toml", {"accuracy.slices": count}).summary()
        for count in (20, 320, 640)
    }
    rows, errors = [], []
    for rings in ("rigid", "flexible"):
        few, many, most = (lives[count][rings]["life_L10_Mrev"] for count in lives)
        rows.append(
            number(
                f"life between {rings} rings, 640 slices and 20",
                most,
                few,
                "10^6",
                share=abs(many / most - 1),
            )
        )
        errors.append(estimate(f"life between {rings} rings, 320 slices against 640", abs(many / most - 1)))
    return Findings(numbers=tuple(rows), errors=tuple(errors))


def split_contact() -> Findings:
    """Approach of a roller to a flexible ring, resolved, and as contact law and structure."""
    rows = []
    for name in RINGS:
        whole = contact_law(5.0) + structure(name, 5.0)
        indentation = 1e3 * contact_law(5.0)
        known = 1e3 * float(resolved(name)[0])
        rows.append(number(f"{name}: approach", known, 1e3 * whole, "µm", digit=2e-3 * indentation))
    left = max(float(np.ptp(resolved(name))) for name in RINGS) / contact_law(5.0)
    return Findings(
        numbers=tuple(rows),
        errors=(estimate("gap that the pressure leaves in the contact, over the indentation", left),),
    )


CASES: Sequence[Case] = (
    Case(
        name="line-contact",
        title="Two textbook problems: Hertz's line contact and film",
        subject=SUBJECT,
        source="inputs of Hamrock, Fundamentals of Fluid Film Lubrication (recalled), and of the exercise of DTU course 41524 "
        "(github.com/VictorLier/Tribology) with its stored pressure profiles; outputs computed independently from the closed forms.",
        known="b = R √(8W/π), p0 = E' √(W/2π), and films of Dowson and of Pan and Hamrock at both raceways.",
        run="The contact and film laws of the bearing model with these inputs.",
        numbers_from="tests/literature/test_line_contact.py",
        compute=line_contacts,
        error="Closed forms; the source is good to its printed digits.",
    ),
    Case(
        name="film-formulas",
        title="Five film formulas",
        subject=SUBJECT,
        source="coefficients and exponents of Dowson and Higginson (1961, 1966), Dowson (1968), Dowson and Toyoda (1978), Pan and Hamrock "
        "(1989), as collected in the project's notes; films worked out there for the bearing of Mao et al. (2016) at 38 000 rpm.",
        known="h/R = c G^g U^s W^-w at four loads.",
        run="The film laws without inlet heating.",
        numbers_from="tests/literature/test_film_formulas.py",
        compute=film_formulas,
        error="Closed forms; the source is good to its printed digits.",
    ),
    Case(
        name="adore-oils",
        title="Oils of the ADORE line",
        subject=SUBJECT,
        source="viscosity and temperature coefficient as coded in a public program of that line, collected in the project's notes.",
        known="Viscosity and -d ln η/dT of six oils; the formulas were entered twice, in the program and in the test.",
        run="Each oil at 313, 373 and 420 K.",
        numbers_from="tests/literature/test_adore_oils.py",
        compute=adore_oils,
        error="Rounding.",
    ),
    Case(
        name="stresses-below-contacts",
        title="Stresses below Hertz's contacts",
        subject=SUBJECT,
        source="Johnson, Contact Mechanics (1985), sec. 3.4 and 4.2; Lundberg and Palmgren (1947) for the orthogonal shear stress; von Mises "
        "as textbooks of machine elements have it.",
        known="Largest shear, von Mises and orthogonal shear stress over p0 and their depths, line and circle, ν = 0.3.",
        run="Stress fields in closed form, sampled along the depth.",
        numbers_from="tests/literature/test_subsurface_stress.py",
        compute=stresses_below,
        error="Samples are 5e-5 of the half-width apart; stresses on the axis meet their closed forms to 1e-13. Printed digits: 0.001.",
        draw=draw_below,
        caption="Largest shear stress along the depth.",
    ),
    Case(
        name="whole-roller",
        title="A whole roller on half-spaces: line and ellipse of Hertz",
        subject=SUBJECT,
        source="Hertz's line contact and ellipse, Johnson, Contact Mechanics (1985), ch. 4.",
        known="In the middle of a long roller the contact is a line; a roller that is crowned all along has an elliptical contact.",
        run="Pressure on cells of elastic half-spaces, 16:1 roller on 64 x 128 cells, crowned roller on 64 x 256 cells.",
        numbers_from="tests/quasidynamic/test_whole_roller.py",
        compute=whole_rollers,
        error="Half as many cells in each direction. The source is closed; what is allowed is the error of the cells that the tests allow.",
    ),
    Case(
        name="tilt-of-slices",
        title="Tilt of a slice law against a half-space",
        subject=SUBJECT,
        source="elastic half-spaces (Boussinesq) under a straight roller, solved on cells; Johnson, Contact Mechanics (1985), ch. 3 and 4.",
        known="The tilt stiffness of a roller on half-spaces, over its translation stiffness and l²/12. Independent "
        "slices have 1 by construction.",
        run="A straight steel roller of 5.2 mm, l/D 0.5, 1 and 2.5, 160 N/mm, tilted by 0.05', against slices by Palmgren's law.",
        numbers_from="tests/quasidynamic/test_whole_roller.py",
        compute=slice_tilt,
        error="Half as many cells along the roller.",
        reason="Slices are independent of each other. On a half-space each slice also deflects its neighbours: under an even load these deflections add up, "
        "a moment's two halves lift each other. So the half-space is stiffer in tilt than in translation, and compared with it the slice law is "
        "softer in tilt than in translation, by a factor of 1.55 for a short roller, 1.45 for l/D 1, 1.34 for a long one (1/1.55 - 1 = -36 %). "
        '`bearing.contact = "half_space"` computes the most loaded roller without slices.',
        slow=True,
    ),
    Case(
        name="life-of-slices",
        title="Life over the number of slices",
        subject=SUBJECT,
        source="the same model with 640 slices, its own limit; slicing after ISO/TS 16281.",
        known="Life of the bearing of Mao et al. with 640 slices.",
        run="The case with 20 slices, as it is shipped, and with 640; tilt free, straight rollers.",
        case_files=("configs/mao2016.toml",),
        numbers_from="configs/mao2016.toml",
        compute=life_of_slices,
        error="320 slices against 640.",
        reason="Life is proportional to the power -4 of line loads, which slices average; at the loaded ends of tilted straight rollers the line load "
        "changes within one slice. Between rigid rings life falls by 1.3 % from 20 to 640 slices, more between flexible ones. Results state this error "
        "(`life_error_percent`), and `accuracy.target` chooses the slices.",
        slow=True,
    ),
    Case(
        name="half-space-split",
        title="Contact law and ring without its half-space, against a resolved contact",
        subject=SUBJECT,
        source="finite elements of NGSolve in plane strain with edges of a twelfth of the half-width in the contact, independent of the model; "
        "Johnson, Contact Mechanics (1985), eq. 5.57, for the contact law.",
        known="Approach of a roller to a ring of 75/82.2 mm under 700 N/mm, on a rigid seat and under 4 and 12 rollers.",
        run="Contact law of a piece 5 mm long, plus the deflection of the ring by harmonics with the half-space of that length removed.",
        numbers_from="tests/reference/test_resolved_contact.py",
        compute=split_contact,
        error="What the pressure of Hertz leaves of the gap in the resolved contact. Allowed: 0.2 % of the indentation.",
        slow=True,
    ),
)
