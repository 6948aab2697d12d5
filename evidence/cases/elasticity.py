"""Rings, bars and fits with known answers: closed forms, convergence, other programs."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from benchmarks.calculix import OURS, REFERENCE, ours as of_clamped_ring
from benchmarks.calculix_balls import under
from evidence.case import Case, Findings, Number, estimate, number, numbers, over, rounding, trend
from evidence.drawing import legend_beside, one
from fem import LineForce, MeshSize, PlanetGear
from quasidynamic.clearance import operating_clearance, seat
from quasidynamic.clearance.annulus import heat_displacement, pressure_displacement, rotation_displacement
from quasidynamic.clearance.press_fit import outside_displacement, running_interference
from tests.fem.condensed import by_harmonics
from tests.literature import (
    calculix,
    test_cage_support as cages,
    test_curved_beams as beams,
    test_lines_on_rings as lines,
    test_ring_convergence as convergence,
    test_rings as rings,
    test_rings_by_harmonics as harmonics,
    test_rotating_rings as turning,
)
from tests.reference import test_plain_ring_on_supports as planet
from tests.reference.plain_ring_on_supports import PlainRing

SUBJECT = "Elasticity of rings and cages"
CODES = "two independent codes (quadratic hexahedra to 153 200 equations, curved tetrahedra of third order to 101 121 unknowns)"
COARSE = MeshSize(order=4, size=5e-3, raceway_size=2.5e-3)
PLACES = "u_r inside", "u_r outside", "u_t inside", "u_t outside"


def rates() -> Findings:
    """Rates of convergence and errors of finite elements of orders 1 to 4."""
    rows, errors = [], []
    for order in convergence.SIZES:
        found = convergence.errors_of(order)
        falls = [float(np.log2(coarse / fine)) for coarse, fine in pairwise(found)]
        statement = f"order {order}: error falls at least like h^{order + 1}"
        rows.append(
            trend(statement, ("first halving", "second"), falls, min(falls) > order + 1 - convergence.LAW)
        )
        errors.append(estimate(f"order {order}: relative error on the finest mesh", found[-1]))
    return Findings(trends=tuple(rows), errors=tuple(errors))


def draw_rates(_: Findings) -> Figure:
    """Error over the size of elements."""
    figure, axes = one("size of the elements [mm]", "relative error of u", xscale="log", yscale="log")
    for order, size in convergence.SIZES.items():
        found = convergence.errors_of(order)
        sizes = size / 2.0 ** np.arange(3)
        axes.plot(sizes, found, "o-", label=f"order {order}")
        axes.plot(sizes, found[-1] * (sizes / sizes[-1]) ** (order + 1), "k:", lw=1)
    axes.plot([], [], "k:", lw=1, label="order of theory")
    axes.xaxis.set_minor_formatter(NullFormatter())
    legend_beside(axes)
    return figure


def michell() -> Findings:
    """A plane ring under cosine pressures."""
    rows: list[Number] = []
    apart = 0.0
    for n, exact in rings.MICHELL.items():
        found, coarse = rings.under_cosine_pressure(n), rings.under_cosine_pressure(n, order=3)
        apart = max(apart, *(abs(a / b - 1) for a, b in zip(coarse, found, strict=True)))
        rows += numbers((f"cos {n}φ: {place}" for place in PLACES), exact, found, "µm", share=1e-4)
    return Findings(numbers=tuple(rows), errors=(estimate("largest change from order 3 to 4", apart),))


def patches() -> Findings:
    """A plane ring pinched by two patches."""
    found, coarse = rings.pinched_by_patches(), rings.pinched_by_patches(order=4)
    names = "diameter along the load", "diameter across it"
    return Findings(
        numbers=numbers(names, rings.PATCHES, found, "mm", share=1e-4),
        errors=(
            estimate(
                "largest change from order 4 to 5",
                max(abs(a / b - 1) for a, b in zip(coarse, found, strict=True)),
            ),
        ),
    )


def pinched() -> Findings:
    """A ring in space pinched by two lines, and slender ones."""
    found, coarse = lines.pinched(), lines.pinched(COARSE)
    rows = list(
        numbers(
            ("82.2/75 x 10 mm: along the loads", "across them"), lines.PINCHED, found, "mm/kN", share=1e-4
        )
    )
    slender = harmonics.slender()
    for source, known in harmonics.SLENDER.items():
        for place, value, ours in zip(("along", "across"), known, slender, strict=True):
            if value is not None:
                rows.append(
                    number(f"R 100, 5 x 10 mm, {place}: {source}", 1e6 * value, 1e6 * ours, "µm", share=5e-3)
                )
    return Findings(
        numbers=tuple(rows),
        errors=(estimate("a coarser mesh of lower order, change", float(np.abs(coarse / found - 1).max())),),
    )


def neighbours() -> Findings:
    """Lines beside a loaded one on a ring with a clamped face."""
    found, coarse = lines.beside_a_line(), lines.beside_a_line(COARSE)
    rows: list[Number] = []
    for source, known in lines.NEIGHBOURS.items():
        share = 0.015 if source == "no layers" else 1e-3
        names = (f"{source}: {angle} deg" for angle in (12, 24, 36, 48))
        rows += numbers(names, 1e6 * np.array(known), 1e6 * found, "nm/N", share=share)
    apart = float(np.abs(coarse - found).max() / np.abs(found).max())
    return Findings(
        numbers=tuple(rows), errors=(estimate("a coarser mesh of lower order, over the largest", apart),)
    )


def balls_in_calculix() -> Findings:
    """A 6209 in a soft housing against whole models in CalculiX, each under the load that it finds."""
    rows: list[Number] = []
    errors = []
    for name in ("radial", "combined"):
        coarse, known = calculix.BALLS[name][-2:]
        changed = np.abs(np.subtract(known.loads, coarse.loads)).max() / max(known.loads)
        errors.append(estimate(f"CalculiX, {name}, 1728 to 3150 elements, over the largest load", changed))
        found, _ = under(name, known.carried)
        places = [f"{name}, ball {ball}" for ball, load in enumerate(known.loads) if load > 0]
        count, scale = len(places), max(known.loads)
        loads = numbers(places, known.loads[:count], found.loads[:count], "N", digit=0.015 * scale)
        rows += over(scale, loads)
        if name == "combined":
            angles = numbers(places, known.angles, np.degrees(found.angles), "deg", digit=0.1)
            rows += over(max(known.angles), angles)
    name = "radial, small displacements"
    further = [
        1e3 * (under(name, known.carried)[1][2] - 1e-3 * calculix.PLACE) for known in calculix.BALLS[name]
    ]
    return Findings(
        numbers=tuple(rows),
        trends=(
            trend(
                "small displacements, same radial load: our ring moves further by less the finer CalculiX's mesh is",
                (f"{known.elements} elements" for known in calculix.BALLS[name]),
                1e3 * np.array(further),
                all(0 < fine < coarse for coarse, fine in pairwise(further)),
                "µm",
            ),
        ),
        errors=tuple(errors),
    )


def against_calculix() -> Findings:
    """The same ring, mean over lines, against CalculiX."""
    found, exact = of_clamped_ring(*OURS[-1])[0][1:5], of_clamped_ring(*REFERENCE)[0][1:5]
    coarse, fine = (np.array(row) for row in calculix.NEIGHBOURS.values())
    scale = float(np.abs(fine).max())
    rows = numbers(
        (f"{angle} deg" for angle in (12, 24, 36, 48)),
        fine,
        1e9 * found,
        "nm/N",
        digit=5e-3 * scale,
    )
    return Findings(
        numbers=over(scale, rows),
        errors=(
            estimate(
                "ours, against order 8 and 200 harmonics, over the largest",
                float(np.abs(found - exact).max() / np.abs(exact).max()),
            ),
            estimate(
                "CalculiX, 34 560 to 109 000 unknowns, over the largest",
                float(np.abs(coarse - fine).max() / scale),
            ),
        ),
    )


def springs() -> Findings:
    """A ring on thirty springs."""
    forces = harmonics.on_thirty_springs()
    names = (f"spring at {12 * k} deg" for k in range(9))
    rows = numbers(names, harmonics.BEAM_ON_SPRINGS, forces[:9], "N", digit=7.0)
    asymmetry = float(np.abs(forces[:15:-1] - forces[1:15]).max())
    return Findings(numbers=(*over(1e3, rows), rounding("asymmetry of the forces", asymmetry, 1e3, "N")))


def out_of_plane() -> Findings:
    """A ring under four alternating axial forces."""
    solid = harmonics.under_alternating_forces()
    n = np.arange(2, 20_000, 4)
    beam = (
        1e3 * 4 * 100.0 / np.pi * beams.answer(beams.ring(0.1, 10e-3, 10e-3, beams.PLAIN), n, beams.U).sum()
    )
    tetrahedra, beam_theory = harmonics.ALTERNATING.values()
    return Findings(
        numbers=(
            number("sections by harmonics, tetrahedra", tetrahedra, solid, "mm", share=1e-3),
            number("curved beam, tetrahedra", tetrahedra, beam, "mm", share=2e-3),
            number("curved beam, beam theory with shear", beam_theory, beam, "mm", share=2e-3),
        )
    )


def curved_beams() -> Findings:
    """Curved beams against handbook, plane elasticity and solids."""
    along, across = beams.diameters(beams.ring(0.1, 5e-3, 10e-3, beams.PLAIN), 10.0)
    wide = beams.diameters(beams.ring(39.3e-3, 3.6e-3, 10e-3, beams.STEEL), 1e3)
    rows = [
        number("Roark, R 100, 5 x 10 mm: along", -71.7074, 1e6 * along, "µm", share=1e-3),
        number("Roark, R 100, 5 x 10 mm: across", 65.656, 1e6 * across, "µm", share=1e-3),
        *numbers(
            ("two codes, 82.2/75 x 10 mm: along", "across"),
            [-v for v in lines.PINCHED],
            [1e3 * w for w in wide],
            "mm",
            share=0.01,
        ),
    ]
    beam = beams.ring(39.3e-3, 3.6e-3, 1.0, beams.STEEL)
    for n, exact in rings.MICHELL.items():
        found = -0.1e6 * beam.outside * beam.width * beams.answer(beam, [n], beams.W)[0]
        rows.append(
            number(
                f"Michell, cos {n}φ: mean radial motion", sum(exact[:2]) / 2, 1e6 * found, "µm", share=0.01
            )
        )
    rows.append(
        number(
            "torsion constant of a square over h⁴",
            0.140577,
            beams.twist_constant(2e-3, 2e-3) / 2e-3**4,
            share=1e-5,
        )
    )
    return Findings(numbers=tuple(rows))


def bars_under_rigid_ring() -> Findings:
    """Squirrel cages whose ring is rigid."""
    rows: list[Number] = []
    for name, cage in cages.RIGID.items():
        found = cages.under_rigid_ring(cage, 3, 1)
        b, h, L = cage.width, cage.height, cage.length
        formula = cage.bars * cage.modulus * b * h * (b**2 + h**2) / (2 * L**3)
        rows.append(
            number(f"{name}: solids, ring 1000 times stiffer", cage.printed, found, "N/mm", share=2e-3)
        )
        rows.append(
            number(f"{name}: solids of order 5, rigid ring", cage.converged, found, "N/mm", share=1e-3)
        )
        rows.append(number(f"{name}: handbook formula of clamped bars", formula, found, "N/mm", share=0.02))
    return Findings(numbers=tuple(rows))


def lame() -> Findings:
    """Growth by speed, pressure and heat; a hot press fit; clearance."""
    um = 1e6
    rows = [
        number(
            "ring bore at 38 000 rpm",
            18.72190,
            um * rotation_displacement(turning.RING, 29.8e-3, turning.SPEED),
            "µm",
            share=1e-5,
        ),
        number(
            "raceway at 38 000 rpm",
            18.27572,
            um * rotation_displacement(turning.RING, 32.5e-3, turning.SPEED),
            "µm",
            share=1e-5,
        ),
        number(
            "shaft at 38 000 rpm",
            15.3279,
            um * rotation_displacement(turning.SHAFT, 29.8e-3, turning.SPEED),
            "µm",
            share=1e-5,
        ),
        number(
            "ring bore under 100 MPa",
            173.7899,
            um * pressure_displacement(turning.RING, 29.8e-3, 1e8, 0.0),
            "µm",
            share=1e-5,
        ),
        number(
            "raceway under 100 MPa in the bore",
            169.0433,
            um * pressure_displacement(turning.RING, 32.5e-3, 1e8, 0.0),
            "µm",
            share=1e-5,
        ),
        number(
            "inner raceway, 200 K warmer",
            72.8,
            um * heat_displacement(turning.RING, 32.5e-3, 200.0),
            "µm",
            share=1e-5,
        ),
        number(
            "outer raceway, 198 K warmer",
            83.160,
            um * heat_displacement(turning.OUTER, 37.5e-3, 198.0),
            "µm",
            share=1e-5,
        ),
    ]
    for name, state, known in (
        ("standing", turning.HOT, (19.6084, 6.8701, 84.4135)),
        ("turning", turning.HOT_TURNING, (16.2144, 5.6810, 100.6791)),
    ):
        found = (
            um * running_interference(turning.FIT, state),
            1e-6 * seat(turning.FIT, state).pressure,
            um * outside_displacement(turning.FIT, state, 32.5e-3),
        )
        for what, one_known, our, unit in zip(
            ("interference", "pressure", "growth"), known, found, ("µm", "MPa", "µm"), strict=True
        ):
            rows.append(number(f"hot fit, {name}: {what}", one_known, our, unit, share=1e-5))
    for name, running, known in (
        ("heat", turning.STANDING, -27.021),
        ("heat and speed", turning.RUNNING, -59.552),
    ):
        rows.append(
            number(
                f"change of clearance, {name}",
                known,
                um * operating_clearance(turning.MOUNTING, running).clearance,
                "µm",
                digit=5e-4,
            )
        )
    return Findings(numbers=tuple(rows))


def thin_rim(psi: np.ndarray, force: float, others: np.ndarray) -> np.ndarray:
    r"""Radial motion [m] of an inextensional thin rim at rollers with outward loads Q, under tooth forces T.

    .. math:: w = \frac{R^3}{\pi E I} \sum_{m \ge 2} \frac{\sum_j Q_j \cos m(\psi - \psi_j)
              + \sum_t T_t \sin m(\psi - \psi_t)/m}{(m^2 - 1)^2}
    """
    radius = planet.INSIDE + planet.THICKNESS / 2
    bending = planet.STEEL.youngs_modulus * planet.WIDTH * planet.THICKNESS**3 / 12
    moved = np.zeros_like(psi)
    for m in range(2, 400):
        radial = others @ np.cos(m * (psi[None] - psi[:, None]))
        teeth = (np.pi / 2, -force), (3 * np.pi / 2, force)
        tangential = sum(pull * np.sin(m * (psi - at)) / m for at, pull in teeth)
        moved += radius**3 / (np.pi * bending) / (m * m - 1) ** 2 * (radial + tangential)
    return moved


FORCE = 400.0  # [N] of each of two opposite teeth
AGAINST = -2 * FORCE * np.cos(planet.ROLLERS) / 6  # [N] of the rollers


def rim_of_sections(radius: float | None) -> np.ndarray:
    """Radial motion [um] at the rollers, teeth acting at a radius, or outside."""
    teeth = tuple(
        LineForce(azimuth=psi, radial=0.0, tangential=pull)
        for psi, pull in ((np.pi / 2, -FORCE), (3 * np.pi / 2, FORCE))
    )
    part = planet.ring(PlanetGear(forces=teeth, radius=radius))
    found = by_harmonics(part, planet.WIDTH, 1, planet.FAIR).at(planet.ROLLERS)
    return 1e6 * (found.initial_deviation[:, 0] + found.absolute[:, 0, :, 0] @ AGAINST)


def rim_of_beams(radius: float) -> np.ndarray:
    """The same by a polygon of beams."""
    steel, middle = planet.STEEL, planet.INSIDE + planet.THICKNESS / 2
    plain = PlainRing(middle, planet.THICKNESS, planet.WIDTH, steel.youngs_modulus, steel.poisson_ratio)
    teeth = [(np.pi / 2, radius, -FORCE), (3 * np.pi / 2, radius, FORCE)]
    return 1e6 * plain.under_teeth(teeth, planet.ROLLERS, AGAINST)


def planet_rim() -> Findings:
    """A planet's rim under tooth forces and roller loads, with the pitch circle outside or at mid-wall."""
    rows: list[Number] = []
    middle = planet.INSIDE + planet.THICKNESS / 2
    closed = 1e6 * thin_rim(planet.ROLLERS, FORCE, AGAINST)
    quarter = slice(0, 3)  # the others follow by symmetry
    names = [f"{np.degrees(psi):g} deg" for psi in planet.ROLLERS[quarter]]
    for what, known, radius in (
        ("polygon of beams, teeth outside", rim_of_beams(planet.INSIDE + planet.THICKNESS), None),
        ("polygon of beams, teeth at 46 mm", rim_of_beams(46e-3), 46e-3),
        ("polygon of beams, teeth at 55 mm", rim_of_beams(55e-3), 55e-3),
        ("thin rim in closed form, teeth at mid-wall", closed, middle),
    ):
        size = float(np.abs(known).max())
        ours = rim_of_sections(radius)[quarter]
        rows += over(
            size, numbers((f"{what}: {n}" for n in names), known[quarter], ours, "µm", digit=0.02 * size)
        )
    return Findings(numbers=tuple(rows))


CASES: Sequence[Case] = (
    Case(
        name="ring-convergence",
        title="Order of convergence on a plane ring",
        subject=SUBJECT,
        source="Michell's solution of plane elasticity, entered independently and checked against printed digits; theory of finite elements.",
        known="The error of the displacement falls like h^(p + 1) on curved elements of order p, everywhere in the ring.",
        run="A quarter of a ring of 37.5/41.1 mm in plane stress under 0.1 MPa cos 2φ, three meshes for each order.",
        numbers_from="tests/literature/test_ring_convergence.py",
        compute=rates,
        error="A rate may be 0.25 below that of theory between two meshes. Numbers are the powers of h seen.",
        moves=2e-2,
        draw=draw_rates,
        caption="Relative error in the mean over the size of elements; dotted is the order of theory.",
        slow=True,
    ),
    Case(
        name="ring-michell",
        title="Plane ring under cosine pressures",
        subject=SUBJECT,
        source="Michell's solution of plane elasticity, computed independently (residual of strains and stresses below 1e-6).",
        known="Radial and tangential motion inside and outside for n = 2, 3, 4, in plane stress.",
        run="Finite elements of order 4, two through the wall.",
        numbers_from="tests/literature/test_rings.py",
        compute=michell,
        error="Order 3 on the same mesh.",
        slow=True,
    ),
    Case(
        name="ring-patches",
        title="Plane ring pinched by two patches",
        subject=SUBJECT,
        source="exact plane elasticity, 58 harmonics, computed independently.",
        known="Change of the inner diameters under 10 N/mm on arcs of ±0.05 rad.",
        run="Finite elements of order 5 on a quarter.",
        numbers_from="tests/literature/test_rings.py",
        compute=patches,
        error="Order 4 on the same mesh. The motion of a loaded point itself diverges and is not compared.",
        slow=True,
    ),
    Case(
        name="ring-pinched",
        title="Rings in space pinched by two lines; a slender ring",
        subject=SUBJECT,
        source=f"{CODES}; femorph-solver, solver-docs.pages.dev/verification/pinched_ring; Roark, table 9.2, case 1, with shear and extension.",
        known="Change of diameters along and across the loads.",
        run="Sections of a body of revolution by harmonics, as bearings have them.",
        numbers_from="tests/literature/test_lines_on_rings.py",
        compute=pinched,
        error="A coarser mesh of lower order. The beam program and Roark are good to 0.5 % for this ring. That page prints (4/π - π/4) for the diameter across, "
        "which should be (2/π - 1/2).",
        slow=True,
    ),
    Case(
        name="ring-clamped",
        title="Lines beside a loaded one on a ring with a clamped face",
        subject=SUBJECT,
        source=f"{CODES}; tetrahedra of order 5 with layers along the clamped edges, 543 513 unknowns.",
        known="Radial motion at mid-width, 12 to 48 degrees from the load.",
        run="Sections by harmonics, one face clamped, load on the raceway.",
        numbers_from="tests/literature/test_lines_on_rings.py",
        compute=neighbours,
        error="A coarser mesh of lower order. Elements without layers along the clamp are up to 1.4 % too stiff.",
        slow=True,
    ),
    Case(
        name="ring-calculix",
        title="The clamped ring in CalculiX",
        subject=SUBJECT,
        source="CalculiX 2.20 with 4 x 12 x 180 quadratic hexahedra, graded towards the clamp.",
        known="Mean radial motion of lines 12 to 48 degrees from a loaded one.",
        run="Sections of order 5, 80 harmonics. CalculiX's numbers are printed by `python -m benchmarks.calculix` for the same deck.",
        numbers_from="tests/literature/calculix.py",
        compute=against_calculix,
        error="Both programs on finer and coarser meshes. 0.5 % of the largest is allowed, which is what CalculiX's meshes leave open; misfits are shares of the largest.",
        slow=True,
    ),
    Case(
        name="balls-calculix",
        title="A deep groove bearing in a soft housing in CalculiX",
        subject=SUBJECT,
        source="CalculiX 2.20: half a ring of up to 3150 quadratic hexahedra with its groove and shoulders, nonlinear springs as balls between the groove centres, large displacements.",
        known="Loads and contact angles of a 6209 in a rubber-like layer, under a radial load on a ring that does not tilt and under a combined one on a ring that does, computed as one system.",
        run="The same loads, as harmonics with stations on the groove. CalculiX's numbers, its mean normal displacements of Gaussian patches of 1 mm and the half-space that is left out: `python -m benchmarks.calculix_balls`.",
        numbers_from="tests/literature/calculix.py",
        case_files=("configs/6209.toml",),
        compute=balls_in_calculix,
        error="Allowed are 1.5 % of the largest load and 0.1 deg. Radial loads stay 0.27 % apart on finer meshes: large displacements of the layer, which is compressed by about 1 %; with small ones in CalculiX, too, it is 0.06 %.",
        slow=True,
    ),
    Case(
        name="ring-on-springs",
        title="Ring on thirty springs",
        subject=SUBJECT,
        source="Timoshenko beams in harmonics and as a polygon of 1440, computed independently.",
        known="Forces of springs of 1.5e5 N/mm under 1 kN at one of them; bending alone would be 9 % wrong.",
        run="Sections by harmonics on line supports.",
        numbers_from="tests/literature/test_rings_by_harmonics.py",
        compute=springs,
        error="Beams have no indentation at supports, the solid ring has: 0.7 % of the load is allowed; misfits are shares of the load.",
        slow=True,
    ),
    Case(
        name="ring-out-of-plane",
        title="Ring under four alternating axial forces",
        subject=SUBJECT,
        source="tetrahedra of order 4 (98 388 unknowns) and beam theory with bending, torsion and shear, computed independently.",
        known="Motion of a ring of R 100 mm, 10 x 10 mm, under 100 N.",
        run="Sections by harmonics, and the curved beam.",
        numbers_from="tests/literature/test_rings_by_harmonics.py",
        compute=out_of_plane,
        error="Beams differ from solids by 0.015 %.",
        slow=True,
    ),
    Case(
        name="curved-beams",
        title="Rings as curved beams",
        subject=SUBJECT,
        source=f"Roark, table 9.2, case 1; {CODES}; Michell's solution; Timoshenko and Goodier, sec. 109.",
        known="Diameters of pinched rings, radial motion under cosine pressures, torsion constant of a square.",
        run='Curved beams in harmonics (`accuracy.structure = "beam"`).',
        numbers_from="tests/literature/test_curved_beams.py",
        compute=curved_beams,
        error="A beam is a model of its own: 1 % is allowed for walls of a tenth of the radius and waves of 17 walls.",
    ),
    Case(
        name="cage-rigid-ring",
        title="Bars of squirrel cages under a rigid ring",
        subject=SUBJECT,
        source="finite elements of NGSolve at order 4, computed independently; handbook formula n E b h (b² + h²)/(2 L³) of clamped bars.",
        known="Radial stiffness of three cages, two with slender bars and one with short ones.",
        run="A quarter of the bars at order 3, one layer along their edges, moved by a rigid ring that may tilt.",
        numbers_from="tests/literature/test_cage_support.py",
        compute=bars_under_rigid_ring,
        error='Order 5 with two layers is the row "solids of order 5".',
        reason="Only the formula for C: bars of 10.25 mm are as thick as a third of their length, so that shear and the ends count. The formula is 29 % "
        "too stiff there; it holds for slender bars only.",
        slow=True,
    ),
    Case(
        name="lame",
        title="Lamé: rotating rings, hot press fit, clearance",
        subject=SUBJECT,
        source="Lamé's thick rings in plane stress, computed independently; finite differences of the radial equation agree to 1e-8.",
        known="Growth by speed, pressure and heat, a hot press fit at rest and turning, change of the clearance.",
        run="Rings of an aero-engine main bearing, 38 000 rpm.",
        numbers_from="tests/literature/test_rotating_rings.py",
        compute=lame,
        error="Closed forms; the source has five to seven digits.",
    ),
    Case(
        name="planet-rim",
        title="Rim of a planet gear under tooth forces",
        subject=SUBJECT,
        source="an independent polygon of Timoshenko beams (`tests/reference/plain_ring_on_supports.py`); the thin rim in Fourier series as in Jones and "
        "Harris, J. Basic Eng. 85 (1963) 273, whose planet they analysed (the series written anew, the paper recalled).",
        known="Radial motion of the rim at three of twelve rollers (the others follow by symmetry) under two opposite tooth forces, acting outside, on two pitch circles, and at mid-wall.",
        run='Sections by harmonics with `outer.support = "planet"`: diameters 83 and 80 mm, 8 mm wide; tangential forces of -400 N at 90 deg and 400 N at 270 deg, against them 12 rollers with -800 cos(φ)/6 N.',
        numbers_from="tests/reference/test_plain_ring_on_supports.py",
        compute=planet_rim,
        error="Beams differ from the solid rim by 0.6 % at a wall of 4 % of the radius; the thin rim leaves out shear and extension. 2 % of the largest are allowed; misfits are shares of it.",
        slow=True,
    ),
)
