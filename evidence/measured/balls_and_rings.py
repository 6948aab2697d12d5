"""Measurements on slow four-point bearings, squirrel cages and rings."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from evidence.measured.declared import Experiment, Input
from evidence.measured.draws import Draws
from fem import Elastic, MeshSize
from tests.fem.condensed import by_harmonics
from tests.literature.test_rings_by_harmonics import PINCHED, ring

NO_LOAD = {
    "operation.load.axial": "1 N",
    "operation.load.radial_y": "0 N",
    "operation.load.radial_z": "0 N",
    "operation.load.moment_y": "0 N m",
    "operation.load.moment_z": "0 N m",
}
AXIAL = ("200 kN", "400 kN", "1000 kN")
FOUR_POINT_INPUTS = (
    Input(
        name="bearing.clearance",
        low=-45,
        high=-5,
        unit="um",
        reason="pitch bearings are preloaded; classes of balls are 5 to 10 µm apart",
    ),
    Input(name="friction.coefficient", low=0.06, high=0.15, reason="grease, boundary friction"),
    Input(name="bearing.inner.conformity", low=0.52, high=0.54, reason="usual grooves of slewing bearings"),
)


def unloaded(draws: Draws) -> NDArray:
    """Torque without load [N m]."""
    return draws.study(["torque.inner [N m]"], NO_LOAD)[0]


def dip(draws: Draws) -> NDArray:
    """Least torque over the axial load, over that without load."""
    loaded = [
        draws.study(["torque.inner [N m]"], {**NO_LOAD, "operation.load.axial": load})[0] for load in AXIAL
    ]
    return np.min(loaded, axis=0) / unloaded(draws)


MENCK = "Menck et al., measured friction torque of pitch bearings, windsystemsmag.com (summary)."


def stiffer(draws: Draws) -> NDArray:
    """Stiffness of bearing and squirrel cage in series at the high load over that at the low one."""
    flexible = []
    for name in ("low load", "high load"):
        loads = draws.texts(name)
        (bearing,) = draws.study(
            ["stiffness_zz [N/m]"], keys={"operation.load.axial": loads, "operation.load.radial_z": loads}
        )
        flexible.append(1 / (1e6 * draws.values["squirrel cage"]) + 1 / bearing)
    return flexible[0] / flexible[1]


MESH = MeshSize(order=4, size=4e-3, raceway_size=2.5e-3)
MIDDLE = np.array([1, 0, -1 / 2, 0, 3 / 8])  # Legendre polynomials at mid-width
MEAN_RADIUS = 1.855 * 25.4e-3 / 2  # [m]


def pinched_ring(draws: Draws) -> NDArray:
    """Change of the diameter along two opposite forces over that of a thin ring in bending."""
    steel = Elastic(youngs_modulus=207e9, poisson_ratio=0.3)
    found = []
    for thickness, width in zip(1e-3 * draws.values["thickness"], 1e-3 * draws.values["width"], strict=True):
        part = ring(PINCHED, width, MEAN_RADIUS - thickness / 2, thickness, steel)
        rim = by_harmonics(part, part.width, MIDDLE.size, MESH)
        along = -2 * float(rim.at([0.0]).initial_deviation[0] @ MIDDLE)
        inertia = width * thickness**3 / 12
        thin = MEAN_RADIUS**3 / (steel.youngs_modulus * inertia) * (np.pi / 4 - 2 / np.pi)
        found.append(along / thin)
    return np.array(found)


PITCH_DIAMETER = 1900.0  # [mm]
GAUGE = {
    "azimuths": ["0 deg"],
    "parts": ["inner"],
    "surfaces": ["inside"],
}  # along the circumference, at a ball


def ring_strain(draws: Draws) -> NDArray:
    """Hoop strain on the bore of the inner ring, in the plane of the balls, in parts of a million."""
    sides = 20 * np.round(draws.values["section"] / 20)  # [mm] computed at 60, 80 and 100 mm
    sized = {
        "rings.inner.bore": PITCH_DIAMETER - 2 * sides,
        "rings.outer.outside_diameter": PITCH_DIAMETER + 2 * sides,
        **{f"rings.{ring}.width": sides for ring in ("inner", "outer")},
        **{f"rings.{ring}.face_distance": 0.5625 * sides for ring in ("inner", "outer")},
    }
    keys = {
        "operation.load.axial": draws.texts("load"),
        **{key: [f"{length!r} mm" for length in lengths.tolist()] for key, lengths in sized.items()},
    }
    settings = {key: value for key, value in NO_LOAD.items() if key != "operation.load.axial"}
    settings |= {f"outputs.probes.{name}": values for name, values in GAUGE.items()}
    (strain,) = draws.study(["probe_gauge_strain.1 [um/m]"], settings, keys)
    return np.abs(strain)


TORQUE_DIP = Experiment(
    name="torque-dip",
    title="Torque of a pitch bearing where four contacts become two",
    source=MENCK,
    given="Double-row four-point bearings of 0.7 to 5 m; grooves, preload, friction and loads are not in what could be read.",
    quantity="least torque under axial load, over that without load",
    run=f"One row of 1.9 m between rigid rings, axial loads {', '.join(AXIAL)}.",
    case_file="configs/joshi2015_fourpoint.toml",
    settings={},
    inputs=FOUR_POINT_INPUTS,
    count=8,
    predict=dip,
    refuted="A torque that rises with load from the first.",
    missing="Second row, rings that deflect, grease and seals, whose torque hides part of the dip.",
)
EXPERIMENTS = (
    Experiment(
        name="slewing-strain",
        title="Strain of the rings of a four-point slewing bearing",
        source="Liu, Wang, Pang, Gao and Zong, Experimental Techniques (2018), doi 10.1007/s40799-018-0237-2, abstract.",
        given="Single row, static rig, gauges on the inside of the inner ring; dimensions, loads and strains are not in what could be read.",
        quantity="hoop strain on the bore of the inner ring at a ball, without its sign",
        unit="µm/m",
        run="The bolted bearing of 1.9 m under axial load; sections nearest to 60, 80 and 100 mm.",
        case_file="configs/slewing_bolted.toml",
        settings={},
        inputs=(
            Input(
                name="section", low=50, high=110, unit="mm", reason="sides of ring sections at this diameter"
            ),
            Input(
                name="load",
                low=20,
                high=400,
                unit="kN",
                logarithmic=True,
                reason="up to a third of the axial load at 3 GPa (assumed)",
            ),
            Input(name="bearing.clearance", low=-30, high=0, unit="um", reason="new bearings are preloaded"),
        ),
        count=8,
        predict=ring_strain,
        refuted="Strains above the band at these loads, on faces as stiff.",
        missing="Where the gauges are, and along what: axial strain on the bore is four to thirteen times as large, and falls with the section; soft faces; bolt by bolt, the faces open.",
        needed="the table of strains over load, with the section of the rings",
    ),
    TORQUE_DIP,
    replace(
        TORQUE_DIP,
        name="unloaded-torque",
        title="Torque of pitch bearings without load, from one to the next",
        given="Torque without load differs much between equal bearings; no number.",
        quantity="torque without load",
        unit="N m",
        run="One row of 1.9 m between rigid rings without load.",
        predict=unloaded,
        refuted="Equal bearings of this size that differ by less than a factor of two.",
        missing="Grease, seals, spacers.",
        needed="the smallest and the largest torque of bearings of one design",
    ),
    Experiment(
        name="squirrel-cage-and-bearing",
        title="Stiffness of a squirrel cage with its bearing over load",
        source="Machines 14 (2026) 131, squirrel cage, film damper and four-point bearing, abstract.",
        given="Nothing of bearing, cage and loads is in what could be read.",
        quantity="support stiffness at the high load over that at the low one",
        run="A QJ309 under equal axial and radial load, between rigid rings, in series with the cage.",
        case_file="configs/joshi2015_qj309.toml",
        settings={},
        inputs=(
            Input(
                name="low load",
                low=50,
                high=500,
                unit="N",
                logarithmic=True,
                reason="weight of a small rotor",
            ),
            Input(
                name="high load",
                low=2,
                high=20,
                unit="kN",
                logarithmic=True,
                reason="up to the rating of a QJ309",
            ),
            Input(
                name="squirrel cage",
                low=5,
                high=500,
                unit="N/um",
                logarithmic=True,
                reason="soft cages of aero engines to short bars",
            ),
        ),
        count=32,
        predict=stiffer,
        refuted="A rise above the band, or none where the cage is stiffer than the bearing.",
        missing="The film damper; speed.",
    ),
    Experiment(
        name="ring-in-bending",
        title="Deflection of a ring of 1.855 in mean diameter",
        source="Rabinowitz, thesis, Rochester Institute of Technology (1970), abstract.",
        given="Mean diameter 1.855 in; section and loads are not in what could be read. Theory is taken as a thin ring in bending.",
        quantity="deflection over that of the theory",
        run="The solid ring by harmonics under two opposite forces.",
        settings={},
        inputs=(
            Input(name="thickness", low=1, high=6, unit="mm", reason="bearing rings of this diameter"),
            Input(name="width", low=5, high=15, unit="mm", reason="the same"),
        ),
        count=8,
        predict=pinched_ring,
        refuted="A deflection outside the band, of a ring whose section is in these ranges.",
        missing="Supports and fixture of the rig.",
    ),
)
