"""Derivatives of fast balls by keys: against cases that are solved again, identities, refusals."""

import numpy as np
import pytest
from pytest import approx

import flexbearing as fb
from flexbearing import api
from flexbearing.case import BadCase
from flexbearing.derivatives import near_grooves
from flexbearing.derivatives.balls import sensitivities
from tests.places import CONFIGS

RADIAL, HARRIS, CAGE = (CONFIGS / f"{name}.toml" for name in ("6209", "harris218", "harris218_cage"))
RING = [
    "outer.kind=ring", "outer.thickness=3.65 mm", "outer.width=19 mm", "bearing.outer.shoulder=2.2 mm",
]  # fmt: skip
COARSE = ["accuracy.element_order=3", "accuracy.stations=3"]
PRELOADED = ["operation.load.axial=0 N", "operation.preload.force=2 kN"]
OUTPUTS = ["life_L10", "contact_load_range.inner.largest", "peak_pressure.outer", "stiffness_zz"]
KEYS = {
    "bearing.ball.diameter": "mm",
    "bearing.inner.radius": "mm",
    "bearing.outer.radius": "mm",
    "bearing.pitch_diameter": "mm",
    "materials.ball.youngs_modulus": "GPa",
    "materials.ball.density": "kg/m^3",
    "operation.inner_speed": "rpm",
}
OWN = {  # keys of either case
    RADIAL: {"bearing.clearance": "um", "operation.load.radial_z": "kN"},
    HARRIS: {"bearing.contact_angle": "deg", "operation.load.axial": "kN"},
}
STEP = 2e-6  # of a value
LONGER = 1e-4  # of a value: runs between elastic rings balance to 1e-9 of the largest force
CENTRAL = {-1: -0.5, 1: 0.5}  # weights of differences by place, of second and of fourth order
AROUND = {-2: 1 / 12, -1: -2 / 3, 1: 2 / 3, 2: -1 / 12}


def solved_again(path, key, value, unit, settings=(), step=STEP, weights=CENTRAL, outputs=OUTPUTS):
    """Differences of runs by a key, per its unit."""
    total = 0.0
    for place, weight in weights.items():
        end = fb.run(path, [*settings, f"{key}={float(value * (1 + place * step))!r} {unit}"])
        total = total + weight * np.array([end[name].number for name in outputs])
    return total / (step * value)


def errors_over_runs(found, path, settings, step, **choices):
    """Errors of derivatives by all keys over what runs give."""
    errors, outputs = [], [output.name for output in found.outputs]
    for key in found.keys:
        again = solved_again(path, key.path, key.stated, key.unit, settings, step, outputs=outputs, **choices)
        slopes = np.array([found[name, key.path].slope for name in outputs])
        # elasticities below 0.1 to 0.1 of the allowance: derivatives and runs are rounded
        floor = 0.1 * np.array([abs(output.value) for output in found.outputs]) / abs(key.stated)
        errors.append(np.abs(slopes - again) / np.maximum(np.abs(again), floor))
    return np.array(errors)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("path", OWN, ids=lambda path: path.stem)
def test_derivatives_are_those_of_cases_solved_again(path):
    keys = KEYS | OWN[path]
    found = sensitivities(api.read_case(path), OUTPUTS, list(keys))
    assert [key.unit for key in found.keys] == list(keys.values())
    assert errors_over_runs(found, path, (), STEP) == approx(0.0, abs=1e-5)


ELASTIC = [  # keys that change no ring
    (CAGE, [], ["operation.load.axial", "operation.inner_speed", "bearing.inner.radius"]),
    (CAGE, PRELOADED, ["operation.preload.force", "operation.load.radial_z"]),
    (RADIAL, [*RING, "outer.support=side"], ["operation.load.radial_z", "bearing.clearance"]),
    (RADIAL, [*RING, "outer.support=seat"], ["operation.load.radial_z", "bearing.inner.radius"]),
]  # fmt: skip


@pytest.mark.parametrize(("path", "settings", "keys"), ELASTIC, ids=["cage", "preloaded", "side", "seat"])
def test_elastic_grooves_move_with_ring_and_balls(path, settings, keys):
    settings = [*settings, *COARSE]
    found = sensitivities(api.read_case(path, settings), OUTPUTS, keys)
    assert found.raceways == "flexible rings"
    assert errors_over_runs(found, path, settings, LONGER) == approx(
        0.0, abs=2e-4
    )  # stiffness to 1e-13, over the step


MOVED = ["stiffness_zz", "groove_displacement.outer", "contact_load_range.outer.largest"]


def test_modulus_of_an_elastic_ring_moves_balls():
    """It leaves the mesh as it is, so that runs differ by nothing else."""
    settings, key = [*RING, *COARSE, "outer.support=side"], "materials.ball.youngs_modulus"
    found = sensitivities(api.read_case(RADIAL, settings), MOVED, [key])
    assert errors_over_runs(found, RADIAL, settings, 2e-3) == approx(0.0, abs=1e-4)


ON_SPRINGS = [
    *RING, "outer.support=foundation", "outer.foundation_radial=1000 N/mm^3",
    "outer.foundation_axial=1000 N/mm^3", "outer.foundation_tangential=1000 N/mm^3",
]  # fmt: skip
CHANGING = [  # the ring, with the step of runs
    (CAGE, COARSE[1:], "outer.thickness", 5e-3),  # which scatters on a coarser mesh
    (CAGE, COARSE, "outer.bar_length", 5e-3),
    (CAGE, COARSE, "bearing.outer.radius", 5e-3),
    (CAGE, COARSE, "bearing.ball.diameter", 1e-3),
    (CAGE, COARSE, "bearing.contact_angle", 1e-3),
    (RADIAL, [*RING, *COARSE[1:], "outer.support=side"], "outer.thickness", 1e-3),
    (RADIAL, [*RING, *COARSE, "outer.support=seat"], "bearing.pitch_diameter", 1e-3),
    (RADIAL, [*ON_SPRINGS, *COARSE], "outer.foundation_radial", 5e-3),
]


@pytest.mark.slow
@pytest.mark.parametrize(("path", "settings", "key", "step"), CHANGING)
def test_keys_that_change_an_elastic_ring(path, settings, key, step):
    """Grooves that are meshed anew scatter by 1e-6, differences of both sides by some 1e-4."""
    found = sensitivities(api.read_case(path, settings), MOVED, [key])
    assert errors_over_runs(found, path, settings, step, weights=AROUND) == approx(0.0, abs=1e-3)


def test_changes_of_the_same_direction_condense_a_ring_once(monkeypatch):
    """Contact angle and pitch diameter move a groove as it is."""
    shapes, condensed = [], near_grooves.groove_of_shape

    def counted(case, shape, **others):
        shapes.append(shape)
        return condensed(case, shape, **others)

    monkeypatch.setattr(near_grooves, "groove_of_shape", counted)
    keys = ["bearing.contact_angle", "bearing.pitch_diameter"]
    sensitivities(api.read_case(CAGE, COARSE), MOVED, keys)
    assert len(shapes) == 2


def test_outputs_of_rigid_rings_are_refused_where_rings_are_elastic():
    with pytest.raises(BadCase, match=r"rigid.stiffness_zz: derivatives are those .* between elastic rings"):
        sensitivities(api.read_case(CAGE, COARSE), ["rigid.stiffness_zz"], ["operation.load.axial"])


def test_held_ring_moves_with_the_key_that_holds_it():
    settings = ["operation.displacement.axial=10 um", "operation.load.axial="]
    case = api.read_case(HARRIS, settings)
    key = "operation.displacement.axial"
    found = sensitivities(case, OUTPUTS, [key])
    again = solved_again(HARRIS, key, 10.0, "um", settings[1:])
    slopes = [found[name, key].slope for name in OUTPUTS]
    assert slopes == approx(again, rel=1e-5, abs=0.0)


def test_displacement_by_load_is_the_compliance():
    case = api.read_case(HARRIS)
    found = sensitivities(case, ["ring_displacement.x [m]"], ["operation.load.axial"])
    slope = found["ring_displacement.x", "operation.load.axial"].slope * 1e-3  # [m/N]
    stiffness = fb.run(HARRIS).rigid["stiffness_matrix"]
    assert slope == approx(np.linalg.inv(stiffness)[0, 0], rel=1e-6)


def test_largest_load_of_balls_alike_has_a_corner_where_the_ring_tilts():
    found = sensitivities(api.read_case(HARRIS), OUTPUTS[1:2], ["operation.displacement.tilt_y"])
    slope = found[OUTPUTS[1], "operation.displacement.tilt_y"]
    assert slope.one_sided
    assert slope.below == approx(-slope.above, rel=1e-3)
    assert slope.above > 0


def test_class_boundary_is_a_jump_without_warnings():
    case = api.read_case(CONFIGS / "catalogue" / "6208.toml")
    found = sensitivities(case, ["life_L10"], ["bearing.fits.bore"])  # 40 mm, the end of a class
    assert found.left_out == (("bearing.fits.bore", "there is a jump of life_L10"),)


@pytest.mark.parametrize(
    ("setting", "words"),
    [
        ("operation.control=coulomb", "operation.control is found by separate iterations"),
        ("friction.model=fastsim", "friction.model is found by separate iterations"),
    ],
)
def test_friction_that_is_iterated_is_refused(setting, words):
    with pytest.raises(BadCase, match=words):
        sensitivities(api.read_case(HARRIS, [setting]), ["life"], ["operation.load.axial"])
