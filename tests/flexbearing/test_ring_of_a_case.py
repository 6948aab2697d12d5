"""What the inner ring of a case may do: tilt freely under a moment, and move with its supports."""

import re

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.build.ring_parts import inner_part
from flexbearing.build.roller_bearing import bearing
from flexbearing.case import BadCase
from flexbearing.case.read import understood
from flexbearing.families import FAMILIES
from flexbearing.report.output import text
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
RIGID = ["inner.kind=rigid", "outer.kind=rigid", "accuracy.slices=8", "accuracy.axial_shapes=2"]
BEAM = ["inner.kind=rigid", "accuracy.structure=beam", "accuracy.slices=8", "accuracy.axial_shapes=2"]


@pytest.mark.parametrize(
    ("settings", "free"),
    [
        (["operation.moment=30 N m"], True),
        (["operation.tilt=free"], True),
        (["operation.tilt=fixed"], False),
        (["operation.tilt=fixed", "operation.misalignment=2 arcmin"], False),
    ],
    ids=["moment", "free", "fixed", "misaligned"],
)
def test_ring_tilts_freely_where_the_case_says_so(settings, free):
    assert bearing(read_case(PAPER, settings)).operation.free_tilt is free


@pytest.mark.sampled(2)
@pytest.mark.parametrize("direction", [0.0, 30.0], ids=["along z", "aside"])
def test_a_moment_tilts_the_ring_until_the_rollers_hold_it(direction):
    """The ring moment of the result is the applied one, in the plane of the load."""
    settings = ["operation.moment=30 N m", f"operation.load_direction={direction} deg"]
    rigid = flexbearing.run(PAPER, [*RIGID, *settings]).rigid
    plane = np.radians(direction)
    in_plane = np.array([np.cos(plane), np.sin(plane)])
    assert rigid["ring_moment"] == approx(30.0 * in_plane, rel=0, abs=1e-6)
    assert in_plane @ rigid["ring_tilt"] > 1e-4


def test_total_stiffness_is_the_slope_of_load_over_displacement_from_base_to_shaft():
    """Supports deflect with the raceways: their translation adds to the displacement between the raceways."""

    def run(load):
        settings = [*BEAM, f"operation.radial_load={load} N", "coupling.tolerance=1e-10"]
        block = flexbearing.run(PAPER, settings).flexible
        inner, outer = block["support_translation"]
        direction = np.array([np.sin(block["load_direction"]), np.cos(block["load_direction"])])
        return block, direction @ (block["ring_displacement"] + outer - inner)

    load = read_case(PAPER).operation.radial_load
    block, _ = run(load)
    (below, low), (above, high) = run(0.999 * load), run(1.001 * load)
    assert block["total_stiffness"] == approx(0.002 * load / (high - low), rel=1e-4)
    between = (above["ring_displacement"] - below["ring_displacement"])[1]
    assert block["stiffness"] == approx(0.002 * load / between, rel=1e-4)
    assert block["total_stiffness"] < 0.9 * block["stiffness"]


FLEXIBLE = [*BEAM, "operation.radial_load=8 kN"]
HELD = [*FLEXIBLE, "operation.tilt=fixed"]


@pytest.mark.slow
@pytest.mark.parametrize("method", ["newton", pytest.param("iqn-ils", marks=pytest.mark.slow)])
def test_the_other_way_to_hold_the_ring_is_shown_and_told_where_it_matters(method):
    """What a run says of the other choice is what a run with that choice computes."""
    runs = {
        settings[-1].rpartition("=")[2]: flexbearing.run(PAPER, [*settings, f"coupling.method={method}"])
        for settings in ([*FLEXIBLE, "operation.tilt=free"], HELD)
    }
    for choice, other in (("free", "fixed"), ("fixed", "free")):
        said, computed = runs[choice].attributes["tilt"], runs[other]
        assert (said["inner_ring"], said["otherwise"]["inner_ring"]) == (choice, other)
        load, life = computed.flexible["inner_load"].max(), computed.flexible["life_L10"] / 1e6
        assert said["otherwise"]["max_roller_load_N"] == approx(load, rel=2e-3)
        assert said["otherwise"]["life_L10_Mrev"] == approx(life, rel=5e-3)
        for place, axis in enumerate("yz"):
            for which, matrix in (("", "radial_stiffness"), ("total_", "total_radial_stiffness")):
                known, key = computed.flexible.get(matrix), f"{which}stiffness_{axis}_N_per_m"
                assert (key in said["otherwise"]) == (known is not None)
                if known is not None:
                    assert said["otherwise"][key] == approx(known[place, place], rel=5e-3)
        summary = computed.summary()["flexible"]
        for name, value in (("peak_pressure_MPa", max(summary["peak_pressure_MPa"].values())),
                            ("nominal_bar_stress_MPa", summary["nominal_bar_stress_MPa"])):  # fmt: skip
            assert value is None or said["otherwise"][name] == approx(value, rel=5e-3)
        (note,) = [note for note in runs[choice].attributes["notes"] if note["code"] == "tilt"]
        assert note["keys"] == {"operation.tilt": other}
        page = text(runs[choice])
        assert f'(operation.tilt = "{choice}")' in page
        assert f" {said['otherwise']['max_roller_load_N']:,.0f} " in page
    moment = np.hypot(*runs["fixed"].flexible["ring_moment"])
    assert runs["free"].attributes["tilt"]["otherwise"]["ring_moment_Nm"] == approx(moment, rel=1e-2)


@pytest.mark.slow
def test_tilt_that_changes_nothing_is_not_told():
    """A ring held all around deflects alike at both roller ends."""
    seat = ["outer.kind=ring", "outer.support=foundation", "outer.foundation_radial=500 N/mm^3"]
    result = flexbearing.run(PAPER, [*FLEXIBLE, *seat])
    assert result.attributes["tilt"]["otherwise"]["inner_ring"] == "fixed"
    assert not [note for note in result.attributes["notes"] if note["code"] == "tilt"]


def test_rigid_rings_say_nothing_of_the_other_choice():
    result = flexbearing.run(PAPER, RIGID)
    assert result.attributes["tilt"] == {"inner_ring": "free"}


NU_RING = ["outer.kind=rigid", "inner.track_width=12 mm", "accuracy.element_order=3", "accuracy.slices=8"]


def test_inner_ring_without_ribs_and_solid_shaft_are_built_as_the_case_says():
    ring = inner_part(read_case(PAPER, [*NU_RING, "inner.shaft_thickness=29.8 mm"]))
    assert ring
    assert (ring.rib_diameter, ring.shaft_bore, ring.track_width) == (None, 0.0, ring.width)
    left_out = re.sub(r"\nshaft_thickness = .*|\nthickness = \"5 mm\".*", "", PAPER.read_text())
    assert inner_part(understood(left_out, PAPER, NU_RING, FAMILIES)) == ring


def test_thickness_over_ribs_is_needed_by_a_ring_with_ribs():
    left_out = re.sub(r"\nthickness = \"5 mm\".*", "", PAPER.read_text())
    with pytest.raises(BadCase, match=r"\[inner\] thickness is missing: a ring with ribs needs it"):
        understood(left_out, PAPER, (), FAMILIES)


@pytest.mark.slow
def test_nu_ring_on_a_solid_shaft_runs_and_says_that_its_thickness_is_not_used():
    """A bore that a mesh can hold makes hardly a difference; ribs made the ring stiffer."""
    solid = flexbearing.run(PAPER, [*NU_RING, "inner.shaft_thickness=29.8 mm"])
    hollow = flexbearing.run(PAPER, [*NU_RING, "inner.shaft_thickness=27 mm"])
    assert solid.attributes["status"] == hollow.attributes["status"] == "converged"
    assert solid.flexible["inner_load"] == approx(hollow.flexible["inner_load"], rel=0, abs=5.0)
    (note,) = [note for note in solid.attributes["notes"] if note["code"] == "inner-thickness"]
    assert note["text"].startswith("inner.thickness = 5 mm is not used")


def test_clearances_near_each_other_have_one_inner_ring():
    """Thirty micrometres of clearance are five rings, none more than half a step beside its clearance."""
    cases = [read_case(PAPER, [f"bearing.clearance={60 + 0.5 * number} um"]) for number in range(60)]
    diameters = np.array([inner_part(case).raceway_diameter for case in cases])
    step = 1e-4 * cases[0].bearing.outer_raceway_diameter
    assert len({*diameters}) in (4, 5)
    exact = diameters[0] - np.array([case.bearing.clearance - cases[0].bearing.clearance for case in cases])
    assert np.ptp(diameters - exact) <= step * (1 + 1e-9)
