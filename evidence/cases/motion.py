"""Balances of whole bearings, cage slip, skidding, motion in time."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import flexbearing
from evidence.case import Case, Findings, Number, number, rounding, trend
from evidence.drawing import legend_beside, one
from tests.balances import largest_imbalance
from tests.bearings import RPM, paper_bearing
from tests.literature import test_cage_slip as closed
from tests.literature.test_skidding import FIELD_SLIP, GEARBOX_OIL
from tests.quasidynamic.test_identities import CASES as BEARINGS, FILM_FREE, torque_on_rollers_and_cage
from tests.reference.test_time_domain import moving
from tests.reference.time_domain import settled

SUBJECT = "Balances, cage slip, skidding"
RIGID = {"outer.kind": "rigid", "inner.kind": "rigid"}
PAPER = "configs/mao2016.toml"


def balances() -> Findings:
    """Every balance of shipped cases, summed again from their stored forces."""
    rows: list[Number] = []
    for case, settings in ((PAPER, {}), (PAPER, {"operation.tilt": "fixed"}), ("configs/nu209.toml", {})):
        result = flexbearing.run(case, settings)
        guidance = result.attributes["case_si"]["bearing"]["cage"]["guidance"]
        for rings in ("rigid", "flexible"):
            if block := getattr(result, rings):
                name = f"{Path(case).stem}{', tilt held' if settings else ''}, {rings}: worst balance over the largest force"
                rows.append(rounding(name, largest_imbalance(block, guidance), 1.0, "-", 1e-7))
    return Findings(numbers=tuple(rows))


def power() -> Findings:
    """Power put in against losses, angular momentum of rollers and cage."""
    rows: list[Number] = []
    for name, changes in BEARINGS.items():
        state = paper_bearing(**changes, spin_inertia=False).solve()
        left, size = torque_on_rollers_and_cage(state)
        rows.append(
            number(f"{name}: losses, power put in", state.driving_power, state.losses.total, "W", share=1e-10)
        )
        rows.append(rounding(f"{name}: torque left on rollers and cage", left, size, "N m", 1e-12))
    return Findings(numbers=tuple(rows))


def symmetry() -> Findings:
    """Turned, mirrored and slowed bearings."""
    here = paper_bearing().solve()
    largest = float(here.loads[0].max())
    turned = paper_bearing(azimuth=2 * np.pi / 30).solve().loads[0] - np.roll(here.loads[0], -1)
    back = paper_bearing(speed=-38000 * RPM).solve()
    mirrored = back.loads[0, 1:] - here.loads[0, :0:-1]
    slow = [paper_bearing(speed=n * RPM).solve().loads[0].max() for n in (100.0, 10.0, 1.0)]
    rows = [
        rounding("turned by one pitch: largest change of a load", np.abs(turned).max(), largest, "N"),
        rounding(
            "turning the other way: largest change of a mirrored load", np.abs(mirrored).max(), largest, "N"
        ),
        rounding(
            "turning the other way: sum of cage speeds",
            back.cage_speed + here.cage_speed,
            here.cage_speed,
            "rad/s",
        ),
        number("largest load at 1 rpm, without film and inertia", FILM_FREE, slow[2], "N", share=1e-4),
    ]
    return Findings(
        numbers=tuple(rows),
        trends=(
            trend(
                "slower bearings tend to the static one",
                ("100 rpm", "10 rpm", "1 rpm"),
                slow,
                abs(slow[2] - slow[1]) < abs(slow[1] - slow[0]),
                "N",
            ),
        ),
    )


def cage_slip() -> Findings:
    """Slip, speeds and centrifugal force of three constructed bearings."""
    rows: list[Number] = []
    for name, (case, printed) in closed.CASES.items():
        state = case.solved(printed.cage)
        lag = max(printed.digits * printed.slip, 1e-8)
        rows += [
            number(f"{name}: slip", printed.slip, state.cage_slip, share=printed.digits),
            number(f"{name}: slip to first order", printed.first_order, state.cage_slip, share=4e-3),
            number(f"{name}: cage speed", printed.cage, state.cage_speed / RPM, "rpm", share=lag),
            number(f"{name}: roller spin", printed.spin, np.mean(state.roller_speed) / RPM, "rpm", share=lag),
            number(
                f"{name}: centrifugal force",
                printed.centrifugal,
                np.mean(state.loads[1] - state.loads[0]),
                "N",
                digit=2e-4,
            ),
        ]
    free = closed.CASES["a"][0]
    state = closed.replace(free, torque=0.0).model(0.0).solve()
    rows.append(rounding("nothing brakes: slip", state.cage_slip, 1.0, "-", 1e-12))
    epicyclic = free.speed / 2 * (1 - free.ratio)
    rows.append(
        number(
            "nothing brakes: cage speed, n/2 (1 - γ)", epicyclic, state.cage_speed / RPM, "rpm", share=1e-12
        )
    )
    return Findings(numbers=tuple(rows))


def slip_of(case: str, **settings: object) -> float:
    """Cage slip between rigid rings [%]."""
    keys = [f"{key.replace('__', '.')}={value}" for key, value in settings.items()]
    rigid = [f"{key}={value}" for key, value in RIGID.items()]
    return float(flexbearing.run(case, [*rigid, *keys]).summary()["rigid"]["cage_slip_percent"])


def rising(values: Sequence[float]) -> bool:
    """Whether every value is above the one before."""
    return bool(np.all(np.diff(values) > 0))


OIL = (0.05, 0.1, 0.2, 0.33, 0.5)
SPEEDS = ("10000 rpm", "20000 rpm", "30000 rpm", "38000 rpm")
LOADS = ("500 N", "2 kN", "8 kN", "19.6 kN")
CLEARANCES = ("75.5 um", "0 um", "-20 um", "-40 um")


def skidding() -> Findings:
    """Slip over oil, speed, load and preload."""
    oil = [slip_of(PAPER, lubricant__oil_fraction=share) for share in OIL]
    light = {"operation__radial_load": "500 N"}
    speed = [slip_of(PAPER, operation__inner_speed=n, **light) for n in SPEEDS]
    load = [slip_of(PAPER, operation__radial_load=force) for force in LOADS]
    preload = [slip_of(PAPER, bearing__clearance=gap, **light) for gap in CLEARANCES]
    return Findings(
        trends=(
            trend(
                "slip grows with the oil flow",
                [f"oil fraction {share:g}" for share in OIL],
                oil,
                rising(oil),
                "%",
            ),
            trend(
                "slip grows with speed at too little load",
                [f"{n}, 500 N" for n in SPEEDS],
                speed,
                rising(speed),
                "%",
            ),
            trend("slip falls with load", LOADS, load, rising(load[::-1]), "%"),
            trend(
                "preload ends skidding",
                [f"clearance {gap}, 500 N" for gap in CLEARANCES],
                preload,
                preload[-1] < 0.05 * preload[0] and rising(preload[::-1]),
                "%",
            ),
        )
    )


def draw_skidding(findings: Findings) -> Figure:
    """Slip over oil and speed."""
    figure, axes = one("share of the range", "cage slip [%]")
    for found in findings.trends:
        axes.plot(
            np.linspace(0, 1, len(found.ours)),
            found.ours,
            "o-",
            label=f"{found.statement}:\n{found.places[0]} to {found.places[-1]}",
        )
    legend_beside(axes)
    return figure


def guidance() -> Findings:
    """Slip by the guidance of the cage."""
    inner = {"bearing__cage__land_diameter": "65.4 mm"}
    slips = [
        slip_of(PAPER, bearing__cage__guidance=kind, **(inner if kind == "inner" else {}))
        for kind in ("rollers", "inner", "outer")
    ]
    least = slips[0] <= min(slips)
    return Findings(
        trends=(
            trend(
                "a cage guided by the rollers slips least",
                ("rollers", "inner ring", "outer ring"),
                slips,
                least,
                "%",
            ),
            trend(
                "a cage guided by the outer ring slips more than one guided by the rollers",
                ("rollers", "outer ring"),
                (slips[0], slips[2]),
                slips[2] > slips[0],
                "%",
            ),
        )
    )


CELSIUS = (20, 40, 60)
WIND = ("50 N", "200 N", "1 kN")


def gearbox() -> Findings:
    """Slip of a lightly loaded bearing in gear oil, over temperature and load."""
    found = {
        load: [
            slip_of(
                "configs/nu209.toml",
                **GEARBOX_OIL,
                lubricant__inlet_temperature=f"{t} degC",
                operation__radial_load=load,
                operation__inner_speed="1800 rpm",
            )
            for t in CELSIUS
        ]
        for load in WIND
    }
    places = [f"{t} °C" for t in CELSIUS]
    by_load = [slips[0] for slips in found.values()]
    return Findings(
        trends=(
            *(
                trend(f"slip falls as the oil warms, at {load}", places, slips, rising(slips[::-1]), "%")
                for load, slips in found.items()
            ),
            trend("slip falls as wind and load grow, at 20 °C", WIND, by_load, rising(by_load[::-1]), "%"),
            trend(
                f"slip reaches about {FIELD_SLIP:g} % at low wind and cold oil",
                ("20 °C, 50 N",),
                by_load[:1],
                by_load[0] > FIELD_SLIP / 2,
                "%",
            ),
        )
    )


def draw_gearbox(findings: Findings) -> Figure:
    """Slip over the temperature at three loads."""
    figure, axes = one("oil temperature [°C]", "cage slip [%]")
    for load, found in zip(WIND, findings.trends, strict=False):
        axes.plot(CELSIUS, found.ours, "o-", label=load)
    axes.axhline(FIELD_SLIP, color="k", ls="--", lw=1, label="largest in the field")
    legend_beside(axes)
    return figure


def in_time() -> Findings:
    """Loads, spins and slip that rollers free in their pockets settle to."""
    snapshot = paper_bearing().solve()
    model = moving(gap=0.02e-3)
    cage, state = settled(model)
    kinematic = model.kinematic_start()[-1]
    angle, _, spin, *_ = model.parts(state)
    load = model.forces(state).load
    largest = float(snapshot.forces[0, :, 0].max())
    left = [
        np.abs(np.interp(model.seat, angle, load[race], period=2 * np.pi) - snapshot.forces[race, :, 0]).max()
        for race in (0, 1)
    ]
    spins = np.interp(model.seat, angle, spin, period=2 * np.pi) / snapshot.roller_speed - 1
    return Findings(
        numbers=(
            rounding("inner raceway: largest difference of a load", left[0], largest, "N", 5e-3),
            rounding("outer raceway: largest difference of a load", left[1], largest, "N", 5e-3),
            rounding("largest difference of a spin, over the spin", np.abs(spins).max(), 1.0, "-", 1e-2),
            number("cage slip", 100 * (1 - cage / kinematic), 100 * snapshot.cage_slip, "%", share=0.02),
        )
    )


CASES: Sequence[Case] = (
    Case(
        name="balances",
        title="Every balance of a result",
        subject=SUBJECT,
        source="equilibrium of rollers, ring and cage, forces and moments (statics and d'Alembert).",
        known="Nothing is left of any balance, summed again from nothing but the stored forces by an independent few lines.",
        run="Three runs, rigid and flexible rings: radial, along the motion, spin, tilt, ring, ring moment, cage, torques.",
        case_files=(PAPER, "configs/nu209.toml"),
        numbers_from="tests/balances.py",
        compute=balances,
        error="The tolerance of the solver: 1e-7 of the largest force.",
        slow=True,
    ),
    Case(
        name="power",
        title="Power in is power lost; angular momentum is kept",
        subject=SUBJECT,
        source="conservation of energy and of angular momentum.",
        known="Driving power equals the sum of all losses; inner forces cancel in the torque on rollers and cage about the axis.",
        run="Thirteen variants of the bearing of Mao et al.: traction laws, preload, tilt, crowning, light load, both rings turning, guidance.",
        numbers_from="tests/quasidynamic/test_identities.py",
        compute=power,
        error="Rounding.",
    ),
    Case(
        name="symmetry",
        title="Turned, mirrored and slow bearings",
        subject=SUBJECT,
        source="symmetry of the equations; the static load distribution without film, computed independently.",
        known="A bearing turned by a pitch has its loads turned, one that turns the other way has them mirrored; slow bearings are static.",
        run="The bearing of Mao et al. between rigid rings.",
        numbers_from="tests/quasidynamic/test_identities.py",
        compute=symmetry,
        error="Rounding; at 1 rpm what the film still is.",
    ),
    Case(
        name="cage-slip",
        title="Cage slip in closed form",
        subject=SUBJECT,
        source="constructed: equal roller loads, traction proportional to slip, a constant torque on the cage; digits computed independently from "
        "these equations.",
        known="Slip, cage speed, roller spin and centrifugal force of three bearings; epicyclic speeds where nothing brakes.",
        run="Bearings preloaded by a negative clearance, with a laminar land that brakes the cage by the torque.",
        numbers_from="tests/literature/test_cage_slip.py",
        compute=cage_slip,
        error="The weight of a roller, which the source leaves out, is 1e-5 to 1e-3 of the slip.",
    ),
    Case(
        name="skidding",
        chosen="bearing, loads, speeds and oil; the oil fraction stands for the flow.",
        title="Published trends of skidding: oil, speed, load, preload",
        subject=SUBJECT,
        source="Smith, Proc. Instn Mech. Engrs 176 (1962) 566, high speed and light load (abstract read); Boness, J. Lubr. Technol. 92 (1970) 39, oil flow "
        "(recalled); Harris and Aaronson, ASLE Trans. 10 (1967), preload by an out-of-round ring (recalled).",
        known="In high-speed cylindrical roller bearings slip grows with the oil flow, and with speed where there is too little load; load and preload "
        "end it.",
        run="The bearing of Mao et al. between rigid rings; oil flow is represented by the fraction of oil in the mixture, preload as a negative clearance.",
        case_files=(PAPER,),
        numbers_from="tests/literature/test_skidding.py",
        compute=skidding,
        error="Directions only, as the abstract of one publication and memory of two have them: no measured number is compared. Bearings, oils and flows of the "
        "measurements are others, and no rule leads from a flow to an oil fraction. The oil fraction of the case was fitted to 6.28 %.",
        moves=1e-2,
        draw=draw_skidding,
        caption="Cage slip over each range, from its first to its last place.",
        slow=True,
    ),
    Case(
        name="skidding-guidance",
        chosen="bearing, load, speed and oil.",
        title="A published trend of skidding: guidance of the cage",
        subject=SUBJECT,
        source="Anderson, Macks and Nemeth, NACA Report 1177 (1954), cages of 75 mm roller bearings at high speed (its statement on guidance is "
        "recalled, not read).",
        known="A cage guided by the rollers slips least.",
        run="The bearing of Mao et al. between rigid rings with its cage guided by rollers, inner and outer ring.",
        case_files=(PAPER,),
        numbers_from="tests/literature/test_skidding.py",
        compute=guidance,
        error="Directions only. All three differ by less than 0.3 % of the slip: oil drag on the rollers outweighs the land in this bearing.",
        remarks="Here an inner land drives the cage, because the inner ring turns faster, so that it slips less than one guided by rollers; an outer "
        "land brakes it. Lands are laminar and centred (Petroff); oil that is flung out of an inner land is not in the model. "
        "Which of these makes the difference is not known.",
        moves=1e-2,
    ),
    Case(
        name="gearbox-slip",
        chosen="bearing, loads, oil, and a range of temperature that begins where the trend reverses. [As a band](slip-of-cage.md).",
        title="Slip in a wind turbine gearbox, as a trend from 20 to 60 °C",
        subject=SUBJECT,
        source="Guo and Keller, Validation of combined analytical methods to predict slip in cylindrical roller bearings, Tribology International (2020), "
        "abstract of the preprint.",
        known="At low wind and low oil temperature cage and rollers slip up to 60 %; slip falls as temperature and wind grow.",
        run="The 209 bearing at 1800 rpm in a gear oil of ISO VG 320, loads standing for wind: the bearings of the gearbox are larger and their loads "
        "are not printed in what was read. 50 N, 200 N and 1 kN are round numbers, chosen before. Temperatures begin at 20 °C, as the trend reverses below "
        "(remarks).",
        case_files=("configs/nu209.toml",),
        numbers_from="tests/literature/test_skidding.py",
        compute=gearbox,
        error="A trend of another bearing.",
        remarks="At 0 °C and 50 N films of this oil are so thick that unloaded rollers are squeezed between the raceways: slip falls to 20 %. "
        "At 0 °C and 1 kN there are two equilibria, of 8 and 38 % slip.",
        moves=1e-2,
        draw=draw_gearbox,
        caption="Cage slip over the temperature of the oil.",
        slow=True,
    ),
    Case(
        name="time-domain",
        title="Motion in time converges to the steady state",
        subject=SUBJECT,
        source="an independent model in the time domain, `tests/reference/time_domain.py`: rollers run, spin and hit their pockets.",
        known="Loads, spins and cage slip after the motion has settled, with pockets of 20 µm.",
        run="The quasi-dynamic snapshot of the bearing of Mao et al., rollers in their seats.",
        numbers_from="tests/reference/test_time_domain.py",
        compute=in_time,
        error="A roller drives the cage only after it has crossed its gap: slip of the snapshot is lower by 0.5 % at 20 µm, 5 % at 100 µm and "
        "18 % at 300 µm.",
        moves=1e-2,
        slow=True,
    ),
)
