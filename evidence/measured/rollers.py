"""Measurements on roller bearings: slip of cage and rollers, misalignment, planets."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from evidence.measured.declared import Experiment, Input
from evidence.measured.draws import Draws
from evidence.stored import ROOT
from flexbearing.api import check
from flexbearing.progress import Logged
from flexbearing.studies.maps.axes import axes
from flexbearing.studies.maps.solution import solved_map
from tests.literature.test_skidding import GEARBOX_OIL

NU209 = "configs/nu209.toml"
CLEARANCE = Input(
    name="bearing.clearance",
    low=10,
    high=60,
    unit="um",
    reason="from a tight CN on its fits to C3 (assumed)",
)
OIL_SHARE = Input(
    name="lubricant.oil_fraction",
    low=0.01,
    high=0.2,
    logarithmic=True,
    reason="splash to flooded; no rule leads from an oil flow to it",
)


def dotted(settings: Mapping[str, object]) -> dict[str, object]:
    """Settings with the names of keys."""
    return {key.replace("__", "."): value for key, value in settings.items()}


GEARBOX = "Guo and Keller, Validation of combined analytical methods to predict slip in cylindrical roller bearings, Tribology International (2020), abstract."
GEARBOX_INPUTS = (
    Input(
        name="operation.radial_load",
        low=50,
        high=1000,
        unit="N",
        logarithmic=True,
        reason="0.1 to 2 % of the dynamic rating of a 209: low wind, load not printed",
    ),
    Input(
        name="operation.inner_speed",
        low=1000,
        high=1800,
        unit="rpm",
        reason="high-speed shaft between cut-in and rated speed (assumed)",
    ),
    CLEARANCE,
    OIL_SHARE,
)
COLD = ("20 degC", "40 degC")


def slips(draws: Draws) -> NDArray:
    """Slip [%] (2, rows) of the cage and of the roller that slips most, the largest over temperatures."""
    found = [
        draws.study(["cage_slip [%]", "roller_slip [%]"], {"lubricant.inlet_temperature": celsius})
        for celsius in COLD
    ]
    return np.max([(cage, rollers.max(axis=1)) for cage, rollers in found], axis=0)


def cage(draws: Draws) -> NDArray:
    """Slip of the cage."""
    return slips(draws)[0]


def unloaded(draws: Draws) -> NDArray:
    """Slip of the roller that slips most."""
    return slips(draws)[1]


GEARBOX_RUN = (
    "The 209 bearing in gear oil of ISO VG 320, between rigid rings; of 20 and 40 °C the larger slip."
)
OF_A_209 = "Bearing, oil, load and temperature of the gearbox: the 209 stands for a larger bearing."

SOURCE_1974 = "The effects of elastohydrodynamic traction behavior on cage slip in roller bearings, J. Lubrication Technology (ASME) 96 (1974) 370, abstract."
RIG_INPUTS = (
    Input(
        name="lubricant.viscosity",
        low=2,
        high=20,
        unit="mPa s",
        logarithmic=True,
        reason="these oils between 40 and 150 °C; the temperature is not printed",
    ),
    CLEARANCE,
    OIL_SHARE,
)
RIG_LOADS = "operation.radial_load=log 30 N..2 kN,14"
RIG_RUN = "All stable equilibria of a 209 bearing at 10 000 rpm between rigid rings at 14 loads from 30 N to 2 kN: the largest number at one load."
RIG_MISSING = "The rig. Films are isothermal but for the shear at the inlet."


def most_states(draws: Draws) -> NDArray:
    """Largest number of stable equilibria at one load."""
    experiment = draws.experiment
    columns = {each.name: draws.texts(each.name) for each in experiment.inputs}
    counts = []
    for row in range(len(draws)):
        drawn = {key: column[row] for key, column in columns.items()}
        case = check(ROOT / experiment.case_file, {**experiment.settings, **drawn})
        found = solved_map(case, axes([RIG_LOADS], type(case)), ("cage_slip [%]",), Logged())
        counts.append(float(found.solved.stable_count.max()))
    return np.array(counts)


def misaligned(draws: Draws) -> NDArray:
    """Largest roller load on the outer ring with a misaligned inner ring over that without."""
    (straight,) = draws.study(["max_roller_load [N]"])
    (tilted,) = draws.study(
        ["max_roller_load [N]"], keys={"operation.misalignment": draws.texts("misalignment")}
    )
    return tilted / straight


PLANET_SOURCE = "Keller, Guo, Zhang and Lucas, Wind Energy Science 3 (2018) 947, abstract; gear data of the gearbox from a public repository (gfsReboucas/Drivetrain)."
PIN, TILTING = 358.6e3, 9.29e3  # [N] load of a pin, [N m] moment of both axial tooth forces at rated torque


def helical_couple(draws: Draws) -> NDArray:
    """Load of a row over half of the load of its pin, by the couple of the axial tooth forces alone."""
    across = TILTING / (1e-3 * draws.values["row distance"])
    return np.hypot(PIN / 2, across) / (PIN / 2)


def thin_rim(draws: Draws) -> NDArray:
    """Largest roller load in the elastic rim over that in a rigid one."""
    elastic, rigid = draws.study(["flexible.max_roller_load [N]", "rigid.max_roller_load [N]"])
    return elastic / rigid


SLIP_OF_CAGE = Experiment(
    name="slip-of-cage",
    title="Cage slip in a wind turbine gearbox",
    source=GEARBOX,
    given="Low wind and low oil temperature; bearing, load and oil are not in what could be read.",
    quantity="cage slip at low wind and cold oil",
    unit="%",
    run=GEARBOX_RUN,
    case_file=NU209,
    settings=dotted(GEARBOX_OIL),
    inputs=GEARBOX_INPUTS,
    count=16,
    predict=cage,
    refuted="A largest slip below the band, at a load and clearance that are known.",
    missing=OF_A_209,
)
ESTER = Experiment(
    name="cage-states-ester",
    title="States of a cage in an ester oil",
    source=SOURCE_1974,
    given="Ester oils; bearing, load and speed are not in what could be read.",
    quantity="stable states at one load",
    run=RIG_RUN,
    case_file=NU209,
    settings={
        "operation.inner_speed": "10000 rpm",
        "lubricant.traction": "adore",
        "lubricant.adore_oil": "MIL-L-23699",
    },
    inputs=RIG_INPUTS,
    count=8,
    predict=most_states,
    refuted="A jump of the cage speed over load with an ester oil.",
    missing=RIG_MISSING,
)
PLANET_RIM = Experiment(
    name="planet-rim-load",
    title="Largest roller load in the thin rim of a planet",
    source="none measured was found.",
    given="nothing.",
    quantity="largest roller load, elastic over rigid rim",
    run="The shipped planet, its rim in the plane; rollers carry no axial tooth force.",
    case_file="configs/planet.toml",
    settings={},
    inputs=(
        Input(name="outer.thickness", low=6, high=10, unit="mm", reason="what fits below the pitch circle"),
        CLEARANCE,
    ),
    count=8,
    predict=thin_rim,
    refuted="A largest load in a thin rim that is not below that in a thick one by what the band says.",
    missing="Helical teeth, which also bend the rim out of its plane: a page of its own.",
    needed="strains or loads of single rollers in a planet with a rim of known thickness",
)
EXPERIMENTS = (
    SLIP_OF_CAGE,
    replace(
        SLIP_OF_CAGE,
        name="slip-of-unloaded-rollers",
        title="Slip of unloaded rollers in a wind turbine gearbox",
        given="The same; rollers outside the loaded zone.",
        quantity="slip of the roller that slips most",
        predict=unloaded,
        refuted="Unloaded rollers that spin faster than the band allows.",
        missing=f"{OF_A_209} Unloaded rollers turn backwards here: at 1 kN, 1500 rpm and 20 °C they carry 0.8 N, the drag of the film's inlet is 0.14 N, the traction 0.04 N. Without its limit they still do (118 %).",
    ),
    ESTER,
    replace(
        ESTER,
        name="cage-states-traction-fluid",
        title="States of a cage in a fluid with a peak of traction",
        given="Fluids whose traction has a peak over slip; bearing, load, speed and curve are not in what could be read.",
        run=RIG_RUN.replace("All", "Traction of Santotrac 50 as fitted by ADORE. All"),
        settings={**ESTER.settings, "lubricant.adore_oil": "Santotrac 50"},
        refuted="A cage that jumps over load in this fluid.",
        missing=f"{RIG_MISSING} The four-point law with a sharp peak has several states ([map](../howto/map.md)): the fitted traction of this fluid falls too little.",
    ),
    Experiment(
        name="misalignment",
        title="Misalignment and the loads on the outer ring",
        source="Guo and Keller, Investigation of high-speed shaft bearing loads in wind turbine gearboxes through dynamometer testing, Wind Energy (2017), abstract.",
        given="Loads on the outer rings of high-speed shaft bearings; bearing and misalignment are not in what could be read.",
        quantity="largest roller load with misalignment, over that without",
        run="The 209 bearing between rigid rings, the inner ring held at a slope.",
        case_file=NU209,
        settings={},
        inputs=(
            Input(
                name="misalignment",
                low=0.5,
                high=4,
                unit="arcmin",
                reason="up to the usual limit of cylindrical rollers",
            ),
            Input(
                name="operation.radial_load",
                low=2,
                high=20,
                unit="kN",
                logarithmic=True,
                reason="4 to 40 % of the dynamic rating",
            ),
            Input(name="bearing.roller.drop", low=2, high=6, unit="um", reason="crowning is not printed"),
            CLEARANCE,
        ),
        count=16,
        predict=misaligned,
        refuted="A largest load that changes by more than the band.",
        missing="Shaft and housing, through which misalignment of a coupling may load the bearing.",
    ),
    Experiment(
        name="planet-helical-couple",
        title="Two rows of a planet bearing under helical teeth",
        source=PLANET_SOURCE,
        given="750 kW, three planets, normal module 10 mm, helix 7.5°, teeth 21/39/99: 358.6 kN on a pin, 9.29 kN m of the axial tooth forces.",
        quantity="load of a row over half of the load of the pin",
        run="Closed form: the couple is perpendicular to the load and turns the loads of both rows.",
        settings={},
        inputs=(Input(name="row distance", low=60, high=160, unit="mm", reason="bearings are not printed"),),
        count=16,
        predict=helical_couple,
        refuted="A row that carries more in pure torque, with nothing but the couple acting.",
        missing="Gravity with clearance of the carrier bearings, twist of the carrier, bending of the pin, misalignment of the mesh: they load one row more than the other, which the couple cannot.",
    ),
    PLANET_RIM,
    replace(
        PLANET_RIM,
        name="planet-rim-out-of-plane",
        title="Largest roller load in the rim of a helical planet",
        run="The planet of a 750 kW wind turbine gearbox: two rows, axial tooth forces that tilt the rim and bend it out of its plane.",
        case_file="configs/planet_helical.toml",
        inputs=(
            Input(
                name="outer.thickness",
                low=35,
                high=65,
                unit="mm",
                reason="3.5 to 6.5 modules below the teeth: the bearings are not printed",
            ),
            Input(
                name="bearing.second_row.distance",
                low=80,
                high=140,
                unit="mm",
                reason="rows within the face width (assumed)",
            ),
            replace(CLEARANCE, low=80, high=160, reason="CN to C3 of bearings of this size (assumed)"),
        ),
        refuted="A largest load under helical teeth, over that in a stiff rim, outside the band.",
        missing="Bending of the pin, twist of the carrier, teeth that stiffen the rim.",
        needed="loads of single rollers of both rows in a helical planet",
    ),
)
