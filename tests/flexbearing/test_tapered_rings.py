"""Elastic rings of tapered roller bearings as cases: limits, balances, rows, derivatives, refusals."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from flexbearing import BadCase, api
from flexbearing.build.tapered_bearing import bearing, build
from flexbearing.derivatives.tapered import sensitivities
from flexbearing.families import FAMILIES
from flexbearing.progress import Logged
from flexbearing.rings import cones
from flexbearing.runs.validate import require_possible
from quasidynamic import tapered_loads
from quasidynamic.balance.rollers.inclined import InclinedRollers
from quasidynamic.contact.line.slices import Slices
from tests.flexbearing.test_tapered_cases import CASE, read, require_balance
from tests.quasidynamic.test_tapered_raceways import readings

CUP = ["outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm"]
SPRINGS = [*CUP, "outer.support=foundation", "outer.foundation_radial=200 N/mm^3",
           "outer.foundation_axial=100 N/mm^3", "outer.foundation_tangential=100 N/mm^3"]  # fmt: skip
CONE = ["inner.kind=ring_on_shaft", "inner.bore=35 mm", "inner.width=17 mm", "inner.shaft_length=40 mm",
        "materials.shaft=structural steel"]  # fmt: skip
BOTH = [*SPRINGS, *CONE]
PAIR = ["bearing.pair.arrangement=back_to_back", "bearing.pair.distance=40 mm", "bearing.pair.preload=2 kN"]
CLOSE = [*PAIR[:1], "bearing.pair.distance=18 mm", "bearing.pair.offset=5 um"]
ONE_CUP = [*CLOSE, *SPRINGS, "outer.width=37 mm", "outer.common=true"]
ONE_SHAFT = [*CLOSE, *CONE, "inner.width=35 mm", "inner.shaft_length=60 mm"]
HELD = {
    "side": [*CUP, "outer.support=side"],
    "seat": [*CUP, "outer.support=seat"],
    "housing": [*CUP, "outer.support=housing", "outer.housing_thickness=8 mm", "outer.housing_width=25 mm",
                "materials.housing=grey cast iron"],
    "both": BOTH,
    "cup of two rows": ONE_CUP,
    "shaft of two rows": ONE_SHAFT,
}  # fmt: skip


@pytest.fixture(scope="module")
def both():
    return api.run(CASE, BOTH)


def compliances(case):
    return cones.raceways(case, bearing(case).azimuths, Logged())


def require_shapes(values, case):
    """Raceways have the shape that the stored loads of slices and ribs make."""
    count, model = case.accuracy.axial_shapes, bearing(case)
    places = values["slice_position"] / (case.bearing.roller.length / 2)
    modes = np.polynomial.legendre.legvander(places, count - 1)
    width = case.bearing.roller.length / case.accuracy.slices
    rib = InclinedRollers.of(
        model, Slices(case.accuracy.slices, model.roller.length), np.zeros(3)
    ).rib_readings(count)
    for race, compliance in zip(("inner", "outer"), compliances(case), strict=True):
        if compliance is None:
            continue
        forces = values[f"{race}_slice_load"] @ modes * width
        if race == "inner":
            forces = np.column_stack([forces, 0 * forces[:, 0]]) + np.outer(values["rib_load"], rib)
        shape = np.einsum("jmkn,kn->jm", compliance, forces)[:, :count] @ modes.T
        deflection = values[f"{race}_deflection"]
        assert deflection == approx(shape, rel=0, abs=1e-9 * np.abs(deflection).max())


@pytest.mark.parametrize("settings", HELD.values(), ids=HELD)
def test_nearly_rigid_rings_are_rigid(settings):
    """Young's modulus and springs times a million, the contacts as they were."""
    stiff = {"youngs_modulus": "210e6 GPa", "poisson_ratio": "0.3", "density": "7810 kg/m^3"}
    parts = [f"materials.{ring}.{name}={value}" for ring in ("inner_ring", "outer_ring")
             for name, value in stiff.items()]  # fmt: skip
    parts += [each.replace(" N/mm^3", "e6 N/mm^3") for each in settings if "N/mm^3" in each]
    for part in ("housing", "shaft"):
        if any(each.startswith(f"materials.{part}=") for each in settings):
            parts += [
                f"materials.{part}.{name}={stiff[name]}" for name in ("youngs_modulus", "poisson_ratio")
            ]
    kept = [each for each in settings if not each.startswith("materials.")]
    pair = [each for each in settings if each.startswith("bearing.pair.")]
    model, operation = build(read(pair))
    rigid = tapered_loads(model, operation)
    found = tapered_loads(model, operation, raceways=compliances(read([*kept, *parts])))
    assert found.loads == approx(rigid.loads, rel=0, abs=1e-6 * rigid.loads.max())
    elastic = tapered_loads(model, operation, raceways=compliances(read(settings)))
    assert np.abs(elastic.loads - rigid.loads).max() > 1e-4 * rigid.loads.max()


@pytest.mark.parametrize("arrangement", [None, "back_to_back", "face_to_face"])
def test_nearly_rigid_rings_on_soft_supports_move_as_a_whole(arrangement):
    """Raceways, and what is along the inner one for the rib, read the motions of rigid rings."""
    pair = [] if arrangement is None else [*ONE_CUP, *ONE_SHAFT, f"bearing.pair.arrangement={arrangement}"]
    steel = "youngs_modulus=210e6 GPa", "poisson_ratio=0.3", "density=7810 kg/m^3"
    stiff = [f"materials.{part}.{each}" for part in ("inner_ring", "outer_ring") for each in steel]
    shaft = [f"materials.shaft.{each}" for each in ("youngs_modulus=1 GPa", "poisson_ratio=0.3")]
    plain = [each for each in (*BOTH, *pair) if not each.startswith("materials.")]
    case = read([*plain, *stiff, *shaft])
    shapes = case.accuracy.axial_shapes
    for race, compliance in zip(("inner", "outer"), compliances(case), strict=True):
        along = race == "inner"
        motions = readings(bearing(case), shapes, race)[:, : shapes + along].reshape(-1, 5)
        whole = compliance.reshape(len(motions), -1)
        left = whole - motions @ np.linalg.lstsq(motions, whole, rcond=None)[0]
        assert np.abs(left).max() < 1e-4 * np.abs(whole).max()


def test_angles_that_vanish_leave_the_ring_of_cylindrical_rollers():
    """The cup of a cone of hardly an angle is condensed to what rollers without one find."""
    case = read([*CUP, "outer.support=seat"])
    part, discretisation, resolution = cones.parts(case)[1]
    own = {angle: cones.condensed_part("outer", (replace(part, taper=angle), discretisation,
           replace(resolution, length=case.bearing.roller.length)), Logged()).at(bearing(case).azimuths)
           for angle in (-1e-10, 0.0)}  # fmt: skip
    difference = np.abs(own[-1e-10].absolute - own[0.0].absolute).max()
    assert 0 < difference < 1e-9 * np.abs(own[0.0].absolute).max()


def test_balances_hold_for_the_stored_loads(both):
    require_balance(both.flexible, bearing(read()))


def test_rings_have_the_shape_that_the_stored_loads_make(both):
    require_shapes(both.flexible, read(BOTH))
    assert both.flexible["outer_deflection"].max() > 10e-6


def test_rigid_rings_have_no_deflection(both):
    assert "outer_deflection" not in both.rigid
    assert both.rigid["outer_load"] == approx(api.run(CASE).rigid["outer_load"], rel=1e-12)


def test_contacts_on_a_stiff_seat_stay_stable():
    """No eigenvalue of 1 + K C is near zero under a thin cup, at 3.7 GPa, though C has negative ones.

    K are the slopes of all slices with rollers and rings held, an upper bound.
    """
    case = read([*HELD["seat"], "outer.thickness=3 mm", "outer.width=16 mm", "operation.load.axial=40 kN",
                 "operation.load.radial_z=80 kN"])  # fmt: skip
    _, cup = compliances(case)
    found = tapered_loads(*build(case), raceways=(None, cup))
    count = case.accuracy.axial_shapes
    slopes = found.solution.state.slice_slope[1] @ found.slices.with_axial_modes(count).products
    slopes = slopes.reshape(-1, count, count)
    whole = np.einsum("jmp,jpkn->jmkn", slopes, cup).reshape((slopes.shape[0] * count,) * 2)
    lowest = 1 + np.linalg.eigvals(whole).real.min()
    assert found.pressures.max() > 3.5e9
    assert 0.7 < lowest < 0.98


def test_more_shapes_and_finer_elements_change_little(both):
    finer = api.run(CASE, [*BOTH, "accuracy.axial_shapes=6", "accuracy.raceway_mesh_size=2 mm"])
    largest = both.flexible["outer_load"].max()
    assert finer.flexible["outer_load"] == approx(both.flexible["outer_load"], rel=0, abs=1e-3 * largest)
    assert float(finer["life_L10"]) == approx(float(both["life_L10"]), rel=5e-3)


def test_rows_of_a_table_are_those_of_runs(both):
    texts = ["max_rib_load", "life_L10", "rigid.stiffness_zz", "stiffness_zz", "max_outer_deflection"]
    (answer,) = FAMILIES["tapered_roller"].rows()([read(BOTH)], texts)
    for name, number in answer.numbers.items():
        assert number == approx(float(both[name]), rel=1e-9), name
    assert answer.status == "converged"


def test_derivatives_are_those_between_elastic_rings():
    found = sensitivities(read(BOTH), ["max_rib_load"], ["operation.load.axial"])
    ends = [
        float(api.run(CASE, [*BOTH, f"operation.load.axial={4000 + change} N"])["max_rib_load"])
        for change in (20, -20)
    ]
    assert float(found.slopes[0, 0]) == approx((ends[0] - ends[1]) / 0.04, rel=2e-3)  # N/kN
    with pytest.raises(BadCase, match=r"set outer\.kind and inner\.kind to rigid"):
        sensitivities(read(BOTH), ["rigid.max_rib_load"], ["operation.load.axial"])


def test_rows_of_a_pair_have_rings_of_their_own():
    """A thrust on two rows in tandem loads each ring as half of it loads the ring of one row."""
    tandem = ["bearing.pair.arrangement=tandem", "bearing.pair.distance=40 mm", "operation.load.radial_z=0 N"]
    both = api.run(CASE, [*SPRINGS, *tandem, "operation.load.axial=8 kN"]).flexible
    alone = api.run(CASE, [*SPRINGS, tandem[-1]]).flexible
    assert both["outer_load"].reshape(2, -1) == approx(np.array([alone["outer_load"]] * 2), rel=1e-8)
    assert both["outer_deflection"][17:] == approx(alone["outer_deflection"], rel=1e-8)
    opposed = api.run(CASE, [*SPRINGS, *PAIR, "operation.load.axial=0 N"])
    rows = opposed.flexible["row_load"]
    assert rows[:, 2] == approx([4000.0, 4000.0], rel=1e-8)
    assert rows[0, 0] == approx(-rows[1, 0], rel=1e-8)
    assert rows[0, 0] < 0.8 * opposed.rigid["row_load"][0, 0]  # softer rings lose preload


@pytest.mark.parametrize("arrangement", ["back_to_back", "face_to_face"])
def test_rows_in_one_body_share_a_symmetric_load(arrangement):
    """Their meshes are not symmetric; forces and shapes are summed up again from the stored slices."""
    settings = [*ONE_CUP, *ONE_SHAFT, f"bearing.pair.arrangement={arrangement}"]
    found = api.run(CASE, [*settings, "operation.load.axial=0 N"])
    values, case = found.flexible, read(settings)
    assert values["row_load"][:, 2] == approx([4000.0, 4000.0], rel=1e-5)
    assert values["row_load"][:, 0].sum() == approx(0.0, abs=1e-6)
    assert abs(values["row_load"][0, 0] / found.rigid["row_load"][0, 0] - 1) > 1e-3
    outer, azimuths = values["outer_load"], values["roller_azimuth"]
    assert outer @ np.cos(azimuths) * np.cos(case.bearing.cup_angle) == approx(8000.0, rel=1e-9)
    require_shapes(values, case)


REFUSED = {
    "one cup of one row": ([*CUP, "outer.common=true"], "this case has no bearing.pair"),
    "one cup in tandem": (
        [each for each in ONE_CUP if "offset" not in each] + ["bearing.pair.arrangement=tandem"],
        "two rows in one elastic ring",
    ),
    "rows beside the cup": ([*ONE_CUP, "outer.width=30 mm"], "what the rollers touch of it"),
    "rows on each other": ([*ONE_CUP, "bearing.pair.distance=16 mm"], "rows touch each other"),
    "cones on each other": (
        [*ONE_SHAFT, "bearing.pair.distance=16 mm", "bearing.pair.arrangement=face_to_face"],
        "rows touch each other",
    ),
    "rows beside the cone": ([*CONE, *PAIR], "what the rollers touch of it"),
    "cup without a wall": ([*CUP, "outer.thickness=2 mm"], "wide end of the raceway has no wall"),
    "rollers beside the cup": ([*CUP, "outer.width=12 mm"], "what the rollers touch of it"),
    "rollers that leave the cup": ([*CUP, "outer.raceway_offset=3 mm"], "or rollers leave the ring"),
    "springs without thrust": ([*SPRINGS, "outer.foundation_axial=0 N/mm^3"], "against the thrust"),
    "cone without a wall": ([*CONE, "inner.bore=42 mm"], "narrow end of the raceway has no wall"),
    "shaft without material": (CONE[:-1], "shaft is missing"),
    "shapes without rings": (["accuracy.axial_shapes=5"], "it belongs to"),
}


@pytest.mark.parametrize(("settings", "why"), REFUSED.values(), ids=REFUSED)
def test_impossible_rings_are_refused(settings, why):
    with pytest.raises(BadCase, match=why):
        require_possible(read(settings), FAMILIES["tapered_roller"])
