"""Four-point bearings between bolted rings, from case file to summary and pictures."""

import json

import numpy as np
import pytest
from pytest import approx

import flexbearing
from fem.errors import NotSolved
from flexbearing.families import FAMILIES
from flexbearing.report.output import text
from flexbearing.results import NotInLayout, ResultFile
from flexbearing.rings import stored
from tests.flexbearing.noted import texts
from tests.places import CONFIGS

SLEWING = CONFIGS / "slewing_bolted.toml"
SMALL = (
    "bearing.balls=24", "bearing.pitch_diameter=300 mm", "bearing.ball.diameter=25 mm",
    "operation.load.axial=60 kN", "operation.load.radial_z=20 kN", "operation.load.radial_y=0 N",
    "operation.load.moment_z=0 N m", "operation.load.moment_y=-2 kN m", "fields.points=5",
    "rings.outer.outside_diameter=400 mm", "rings.outer.width=50 mm", "rings.outer.face_distance=27 mm",
    "rings.inner.bore=200 mm", "rings.inner.width=50 mm", "rings.inner.face_distance=27 mm",
    "rings.element_order=3", "rings.mesh_size=20 mm", "rings.patch_width=2 mm", "rings.stations=3",
)  # fmt: skip
STIFF = ("materials.outer_ring.youngs_modulus=1e9 GPa", "materials.outer_ring.poisson_ratio=0.3")


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Results by settings, each computed once."""
    place, known = tmp_path_factory.mktemp("bolted"), {}

    def computed(*settings):
        if settings not in known:
            rigid = tuple(key.removesuffix("kind=rigid") for key in settings if key.endswith(".kind=rigid"))
            numerics = SMALL[-4:] if len(rigid) == 2 else ()
            used = [key for key in SMALL if not key.startswith((*rigid, *numerics, "-"))]
            known[settings] = flexbearing.run(SLEWING, (*used, *settings), output=place / f"{len(known)}.h5")
        return known[settings]

    return computed


@pytest.mark.slow
def test_both_blocks_carry_the_load(run):
    result = run()
    assert result.attributes["status"] == "converged"
    for block in (result.rigid, result.flexible):
        load, angle, azimuth = block["contact_load"], block["contact_angle"], block["ball_azimuth"]
        outward, along = load * np.cos(angle), load * np.sin(angle) * np.array([1, -1])[:, None]
        assert along[..., 0].sum() == approx(60e3, rel=1e-9)
        assert outward[..., 0].sum(1) @ np.cos(azimuth) == approx(20e3, rel=1e-9)
        assert 0.15 * along[..., 0].sum(1) @ np.cos(azimuth) == approx(-2e3, rel=1e-9)
    assert set(result.flexible) - set(result.rigid) == {"ring_yield"}
    assert set(result.flexible) <= set(result.family.layout().datasets("block"))


def test_bolted_rings_soften_the_bearing_and_lower_its_largest_load(run):
    rigid, flexible = run().rigid, run().flexible
    # not each entry, as loads move from ball to ball; but along x, with the load
    assert flexible["stiffness_matrix"][0, 0] < 0.99 * rigid["stiffness_matrix"][0, 0]
    assert flexible["ring_displacement"][0] > rigid["ring_displacement"][0]
    assert flexible["contact_load"].max() != approx(rigid["contact_load"].max(), rel=1e-3)


def test_rigid_block_is_that_of_rigid_rings(run):
    alone = run("rings.outer.kind=rigid", "rings.inner.kind=rigid")
    assert alone.flexible == {}
    assert alone.rigid["contact_load"] == approx(run().rigid["contact_load"], rel=1e-12)
    assert alone.summary()["flexible"] is None


def test_each_ring_yields_for_itself(run):
    """Two rings deflect about as much as both of them, as far as the loads stay the same."""
    both, outer, inner = (
        run(*settings).flexible["ring_displacement"][0]
        for settings in ((), ("rings.inner.kind=rigid",), ("rings.outer.kind=rigid",))
    )
    rigid = run().rigid["ring_displacement"][0]
    assert (outer - rigid) + (inner - rigid) == approx(both - rigid, rel=0.05)
    assert outer > rigid
    assert inner > rigid


def test_arch_far_from_the_bolted_face_yields_more(run):
    """The first diagonal, which carries an axial load, presses on the inner ring at -x."""
    near, far = (
        run("rings.outer.kind=rigid", *face).flexible["ring_yield"] for face in (("rings.inner.face=-x",), ())
    )
    assert np.hypot(*far[:, 0].T).mean() > 1.5 * np.hypot(*near[:, 0].T).mean()


@pytest.mark.slow
def test_ring_of_endless_stiffness_is_rigid(run):
    # the ring alone: its contact is stiffer, too
    settings = ("rings.inner.kind=rigid", *STIFF)
    values = run(*settings)
    assert values.flexible["contact_load"] == approx(values.rigid["contact_load"], rel=1e-4, abs=0.1)
    assert np.abs(values.flexible["ring_yield"]).max() < 1e-10


@pytest.mark.slow
def test_bearing_turned_over_swaps_its_diagonals(run):
    """Faces and axial loads mirrored at the plane of the balls."""
    turned = run(
        "rings.outer.face=+x", "rings.inner.face=-x",
        "operation.load.axial=-60 kN", "operation.load.moment_y=2 kN m",
    )  # fmt: skip
    load = run().flexible["contact_load"]
    assert turned.flexible["contact_load"][:, ::-1] == approx(load, rel=1e-4, abs=1e-4 * load.max())


@pytest.mark.slow
def test_springs_under_the_face_soften_further(run):
    """By at least what the ring sinks in as one, F / (k A)."""
    springs = ("rings.outer.face_stiffness=200 N/mm^3", "rings.outer.face_shear_stiffness=80 N/mm^3")
    softer, usual = (run(*settings).flexible["ring_displacement"][0] for settings in (springs, ()))
    assert softer - usual > 60e3 / (200e9 * np.pi / 4 * (0.4**2 - 0.306**2))


def test_summary_and_page_show_both(run):
    numbers = run().summary()
    assert json.loads(json.dumps(numbers, allow_nan=False)) == numbers
    page = text(run())
    for block in ("rigid", "flexible"):
        assert f"{numbers[block]['max_contact_load_N']:,.0f}" in page
        assert f"{numbers[block]['torque_Nm']['inner']:.5g}" in page
    assert numbers["rigid"]["largest_ring_yield_um"] is None


@pytest.mark.slow
def test_pictures_put_rigid_beside_elastic_rings(run, tmp_path):
    from flexbearing.report.roller.deformed import pictures

    drawn = FAMILIES["four_point_ball"].report().pictures()(run())
    assert "rigid_and_elastic_rings" in drawn
    upper = drawn["rigid_and_elastic_rings"].axes[0]
    heights = {line.get_label(): max(line.get_ydata()) for line in upper.lines if len(line.get_xdata()) > 2}
    assert len(heights) == 4
    assert max(heights.values()) == approx(
        max(run().rigid["contact_load"][..., 0].max(), run().flexible["contact_load"][..., 0].max()), rel=6e-6
    )
    assert list(pictures(run(), tmp_path)) == []  # inside the rings nothing is known


@pytest.mark.slow
@pytest.mark.parametrize("other", ["rings.patch_width=1.5 mm", "rings.stations=5"])
def test_patches_hardly_matter(run, other):
    """A width of 1.5 mm changes the deflection of the rings, 6 um, by 2 %."""
    usual, changed, rigid = run().flexible, run(other).flexible, run().rigid["ring_displacement"][0]
    assert changed["contact_load"].max() == approx(usual["contact_load"].max(), rel=1e-3)
    assert changed["ring_displacement"][0] - rigid == approx(usual["ring_displacement"][0] - rigid, rel=0.03)


@pytest.mark.slow
def test_contacts_that_reach_over_the_shoulders_are_told(run):
    cut = run("rings.outer.groove_end=58 deg")
    assert any("contacts of the outer ring are cut off on its shoulders" in note for note in texts(cut))
    assert not any("shoulders" in note for note in texts(run()))


def test_finite_elements_without_answer_leave_the_rigid_block(tmp_path, monkeypatch):
    def refuse(*_):
        raise NotSolved("relative residual 1")

    monkeypatch.setattr(stored, "condense", refuse)
    monkeypatch.setenv("FLEXBEARING_CACHE", str(tmp_path / "rings"))
    result = flexbearing.run(SLEWING, SMALL, output=tmp_path / "r.h5")
    assert result.attributes["status"] == result.attributes["ending"] == "not solved"
    assert result.rigid
    assert not result.flexible


def test_block_that_no_case_of_a_kind_has_is_refused(tmp_path):
    with (
        ResultFile(tmp_path / "r.h5", {}, FAMILIES["angular_contact_ball"]) as file,
        pytest.raises(NotInLayout, match="one of: rigid, flexible"),
    ):
        file.block("elastic", {})


def test_balls_under_a_load_that_is_far_too_high_have_no_answer():
    """It is no fault of the case, which `check` accepts."""
    rigid = {"rings.outer": {"kind": "rigid"}, "rings.inner": {"kind": "rigid"}}
    result = flexbearing.run(SLEWING, rigid | {"operation.load.radial_y": "2e9 N"})
    assert result.attributes["status"] == "not solved"
    assert "the load is far too high" in result.attributes["message"]


WEAK = (  # a random bearing with rings half a millimetre thick, its inner face on soft springs
    "bearing.ball.diameter=4.6602 mm", "bearing.pitch_diameter=42.8699 mm", "bearing.balls=18",
    "bearing.inner.radius=", "bearing.inner.conformity=0.5054", "bearing.outer.radius=",
    "bearing.outer.conformity=0.5345", "bearing.contact_angle=40.32 deg", "bearing.clearance=1.361 um",
    "operation.load.axial=4177.6 N", "operation.load.radial_y=0 N", "operation.load.radial_z=2222.9 N",
    "operation.load.moment_y=33.412 N m", "operation.load.moment_z=0 N m", "rings.outer.kind=bolted",
    "rings.outer.face=-x", "rings.outer.outside_diameter=48.6314 mm", "rings.outer.width=11.2524 mm",
    "rings.outer.face_distance=4.3927 mm", "rings.outer.face_stiffness=3980 N/mm^3",
    "rings.outer.face_shear_stiffness=74.79 N/mm^3", "rings.inner.kind=bolted", "rings.inner.face=+x",
    "rings.inner.bore=37.1871 mm", "rings.inner.width=9.6962 mm", "rings.inner.face_distance=4.4103 mm",
    "rings.inner.face_stiffness=41.74 N/mm^3", "rings.inner.face_shear_stiffness=2187 N/mm^3",
)  # fmt: skip


@pytest.mark.slow
def test_balance_of_soft_rings_is_that_which_stiffer_ones_lead_to():
    """Newton's method from rigid rings found one in which a ball carries three times as much, at 74 deg."""
    largest, place = [], SLEWING.with_name("joshi2015_fourpoint.toml")
    for modulus in (4200, 21000):
        steel = [
            f"materials.{ring}.{value}"
            for ring in ("inner_ring", "outer_ring")
            for value in (f"youngs_modulus={modulus} GPa", "poisson_ratio=0.3")
        ]
        found = flexbearing.run(place, (*WEAK, *steel)).flexible
        largest.append(found["contact_load"].max())
        assert np.degrees(found["contact_angle"].max()) < 50
    assert largest == approx([661.0, 673.8], abs=0.1)
    ended = flexbearing.run(place, WEAK).attributes
    assert ended["status"] != "converged"
    assert "lose their balance" in ended["message"]
