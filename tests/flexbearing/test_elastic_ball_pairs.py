"""Two rows of angular-contact balls between elastic rings: limits, balances, one ring of both, refusals."""

import numpy as np
import pytest
from pytest import approx

from flexbearing.api import read_case, run
from flexbearing.build.groove_parts import groove_part, why_no_solid
from flexbearing.case import BadCase
from flexbearing.progress import Logged
from flexbearing.rings.grooves import elastic_grooves
from flexbearing.runs.angular_contact import bearing
from tests.flexbearing.test_ball_pairs import CASE, PRESSED, TANDEM

RING = {
    "accuracy.element_order": "3", "bearing.outer.shoulder": "1.8 mm", "outer.kind": "ring",
    "outer.thickness": "3.4 mm", "outer.width": "15 mm",
}  # fmt: skip
SPRINGS = RING | {
    "outer.support": "foundation", "outer.foundation_radial": "200 N/mm^3",
    "outer.foundation_axial": "100 N/mm^3", "outer.foundation_tangential": "100 N/mm^3",
}  # fmt: skip
ONE_RING = SPRINGS | {"outer.common": "true", "outer.width": "36 mm"}
SHAFT = {
    "accuracy.element_order": "3", "bearing.inner.shoulder": "1.8 mm", "inner.kind": "ring_on_shaft",
    "inner.bore": "40 mm", "inner.width": "30 mm", "inner.shaft_length": "50 mm",
    "materials.shaft": "structural steel",
}  # fmt: skip
HELD = {
    "side": RING | {"outer.support": "side"},
    "seat": RING | {"outer.support": "seat"},
    "springs": SPRINGS,
    "housing": RING | {"outer.support": "housing", "outer.housing_thickness": "8 mm",
                       "outer.housing_width": "15 mm", "materials.housing": "grey cast iron"},
    "one ring": ONE_RING,
    "shaft": SHAFT,
    "all": ONE_RING | SHAFT,
}  # fmt: skip
CROSSED = PRESSED | {"bearing.pair.arrangement": "face_to_face"}
LOAD = {
    "operation.load.axial": "300 N", "operation.load.radial_y": "-100 N", "operation.load.radial_z": "400 N",
}  # fmt: skip
FREE = {"operation.displacement.tilt_y": "", "operation.displacement.tilt_z": ""}
STIFF = {"youngs_modulus": "206e6 GPa", "poisson_ratio": "0.3", "density": "7800 kg/m^3"}


def written(settings):
    """As on the command line, of all settings the last one of a key."""
    return [f"{key}={value}" for key, value in dict(each for one in settings for each in one.items()).items()]


def case(*settings):
    return read_case(CASE, written(settings))


def solved(*settings):
    return run(CASE, written(settings))


def stiffened(settings):
    """The same with rings, shafts, housings and springs a million times as stiff, the balls as they are."""
    parts = {
        "outer_ring": STIFF,
        "inner_ring": STIFF,
    }
    parts |= {name: STIFF for name in ("housing", "shaft") if f"materials.{name}" in settings}
    kept = {key: value for key, value in settings.items() if not key.startswith("materials.")}
    springs = {key: value.replace(" N", "e6 N") for key, value in kept.items() if "N/mm^3" in value}
    return kept | springs | {
        f"materials.{part}.{name}": value for part, own in parts.items() for name, value in own.items()
    }  # fmt: skip


def forces(block, pair, model):
    """Loads and moments of the inner ring from the forces of balls in a result file (5) [N, N m]."""
    angle, load, traction = (block[name][0] for name in ("contact_angle", "contact_load", "traction"))
    around, along = block["ball_azimuth"], np.ones(len(block["ball_azimuth"]))
    first = pair["bearing.pair.arrangement"] == "face_to_face"
    along[block["ball_row"] == (0 if first else 1)] = -1.0
    if pair is TANDEM:
        along[:] = 1.0
    axial = along * (load * np.sin(angle) + traction * np.cos(angle))
    radial = load * np.cos(angle) - traction * np.sin(angle)
    reach = model.inner_reach * np.array([np.sin(model.contact_angle), np.cos(model.contact_angle)])
    place = (block["ball_row"] - 0.5) * 15e-3 + along * reach[0]  # of the inner groove centres
    touch = model.inner.conformity * model.ball.diameter  # from them to the contacts, where tractions are
    lever = model.pitch_diameter / 2 + reach[1]
    couple = along * touch * traction  # of the tractions about the groove centres
    sine, cosine = np.sin(around), np.cos(around)
    about = lever * axial - place * radial - couple
    return np.array([axial, radial * sine, radial * cosine, about * cosine, -about * sine]).sum(1)


@pytest.mark.sampled(5)
@pytest.mark.parametrize("settings", HELD.values(), ids=HELD)
@pytest.mark.parametrize("pair", [PRESSED, CROSSED], ids=["O", "X"])
def test_nearly_rigid_rings_are_rigid(settings, pair):
    soft, stiff = solved(settings, pair, LOAD), solved(stiffened(settings), pair, LOAD)
    rigid = soft.rigid["contact_load"]
    assert stiff.flexible["contact_load"] == approx(
        stiff.rigid["contact_load"], rel=0, abs=1e-6 * rigid.max()
    )
    assert np.abs(soft.flexible["contact_load"] - rigid).max() > 1e-4 * rigid.max()


@pytest.mark.parametrize("settings", [SPRINGS, ONE_RING, ONE_RING | SHAFT], ids=["two", "one", "shaft"])
@pytest.mark.parametrize("pair", [PRESSED, CROSSED], ids=["O", "X"])
def test_stored_forces_carry_the_load(settings, pair):
    couple = {"operation.load.moment_y": "3 N m"}
    block, model = solved(settings, pair, LOAD, FREE, couple).flexible, bearing(case(pair)).bearing
    carried = forces(block, pair, model)
    assert carried == approx([300.0, -100.0, 400.0, 3.0, 0.0], abs=1e-9 * block["contact_load"].max())
    assert block["row_load"].sum(0) == approx(carried[:3], abs=1e-9 * 400)
    assert "unloading_force" not in block


def test_two_rings_share_a_radial_load():
    block = solved(SPRINGS, PRESSED, LOAD, {"operation.load.axial": "0 N"}).flexible
    assert block["row_load"][0, 1:] == approx(block["row_load"][1, 1:], abs=1e-9 * 400)
    assert block["row_load"][0, 0] == approx(-block["row_load"][1, 0], rel=1e-9)
    tandem = solved(SPRINGS, TANDEM, LOAD).flexible["contact_load"].reshape(2, 2, -1)
    assert tandem[:, 0] == approx(tandem[:, 1], rel=1e-9)


def test_beside_an_idle_row_a_row_is_a_bearing():
    """Play keeps the other one away from the inner ring; its balls lie on a ring of their own."""
    play = 50e-6
    idle = PRESSED | {"bearing.pair.preload": "", "bearing.pair.offset": f"{-1e6 * play} um"}
    load = LOAD | {"operation.load.axial": "900 N"}
    one, two = (solved(SPRINGS, *more, load).flexible for more in ((), (idle,)))
    balls = len(one["ball_azimuth"])
    assert not two["contact_load"][0, balls:].any()
    assert two["contact_load"][:, :balls] == approx(one["contact_load"], rel=1e-9)
    assert two["ring_displacement"][0] == approx(one["ring_displacement"][0] + play, rel=1e-9)


def test_rows_far_apart_in_one_ring_have_two():
    """On a seat rows do not reach each other through the ring, nor the ends of theirs."""
    far = {"bearing.pair.distance": "60 mm", "outer.support": "seat"}
    two, one = (
        solved(RING, PRESSED, LOAD, far, more).flexible["contact_load"]
        for more in ({"outer.width": "50 mm"}, {"outer.width": "110 mm", "outer.common": "true"})
    )
    assert one == approx(two, rel=0, abs=1e-6 * two.max())


@pytest.mark.parametrize("pair", [PRESSED, CROSSED], ids=["O", "X"])
def test_a_rigid_ring_of_both_rows_moves_on_its_springs(pair):
    """What stations in the middle of both grooves answer is that of a ring on springs in closed form."""
    hard = stiffened(RING) | {key: value for key, value in ONE_RING.items() if key not in RING}
    own = case(hard, pair, {"outer.width": "36 mm", "outer.groove_offset": "2 mm"})
    model, part = bearing(own).bearing, groove_part(own, "outer")
    found, phi = elastic_grooves(own, model.azimuths, Logged()).outer, model.azimuths
    radius, width = part.raceway_diameter / 2 + part.thickness, part.width
    area, middle = 2 * np.pi * radius * width, -2e-3
    normal, along = 200e9 * area, 100e9 * area  # the tangential springs are as stiff as the axial ones
    across, shift = (normal + along) / 2, np.array([[0.0, 1.0], [-1.0, 0.0]]) * middle
    turning = along * radius**2 / 2 + across * width**2 / 12
    held = np.diag([along, across, across, 0.0, 0.0])
    move = np.eye(5)
    move[1:3, 3:] = shift  # y = x tz, z = -x ty at the middle of the ring
    held = move.T @ held @ move + np.diag([0.0, 0.0, 0.0, turning, turning])
    angles, side = found.angles[2:5], model.along_x
    place, centre = side * part.groove.place, part.groove.centre_radius
    sine, cosine, no = np.sin(phi), np.cos(phi), np.zeros(len(phi))
    axial = np.array([no + 1, no, no, centre * cosine, -centre * sine])
    radial = np.array([no, sine, cosine, -place * cosine, place * sine])
    read = np.array([np.sin(at) * side * axial + np.cos(at) * radial for at in angles])  # (K, 5, Z)
    read = read.transpose(2, 0, 1).reshape(-1, 5)
    wanted = read @ np.linalg.solve(held, read.T)
    answer = found.compliance[:, 2:5][..., 2:5].reshape(wanted.shape)
    assert answer == approx(wanted, rel=0, abs=1e-4 * np.abs(wanted).max())


def test_no_stresses_of_two_rows():
    own = case(SPRINGS, PRESSED)
    assert "bearing.pair" in why_no_solid(own, "outer")


@pytest.mark.parametrize(
    ("settings", "named"),
    [
        ([RING, PRESSED, {
            "outer.kind": "squirrel_cage", "outer.bars": "20", "outer.bar_width": "4 mm",
            "outer.bar_ends": "one", "outer.bar_thickness": "2 mm", "outer.bar_length": "20 mm",
            "outer.flange_length": "5 mm"}], "outer.kind"),
        ([SPRINGS, PRESSED, {"inner.kind": "cam", "inner.cam_amplitude": "0.1 mm"}], "inner.kind"),
        ([RING, PRESSED, {"outer.support": "lines",
                          "outer.line_azimuths": '["0 deg", "120 deg", "240 deg"]'}], "outer.support"),
        ([SPRINGS, PRESSED, {"outer.bilateral": "false"}], "outer.bilateral"),
        ([SPRINGS, PRESSED, {"outer.foundation_axial": "0 N/mm^3"}], "outer.foundation_axial"),
        ([ONE_RING, TANDEM], "bearing.pair.arrangement"),
        ([SHAFT, TANDEM], "bearing.pair.arrangement"),
        ([ONE_RING, PRESSED, {
            "bearing.pair.distance": "8 mm", "bearing.outer.shoulder": "3.6 mm", "outer.thickness": "5 mm"}],
         "bearing.pair.distance"),
        ([ONE_RING, PRESSED, {"outer.width": "20 mm"}], "outer.width"),
        ([SPRINGS, PRESSED, {"outer.width": "16 mm"}], "outer.width"),
        ([HELD["housing"], PRESSED, {"outer.housing_width": "20 mm"}], "outer.housing_width"),
        ([HELD["housing"], PRESSED, {"outer.housing_clearance": "10 um"}], "outer.housing_clearance"),
        ([SPRINGS, {"outer.common": "true"}], "outer.common"),
    ],
)  # fmt: skip
def test_impossible_rings_of_pairs(settings, named):
    section, _, key = named.rpartition(".")
    with pytest.raises(BadCase, match=rf"\[{section}\] {key}\b"):
        case(*settings)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_random_pairs_carry_their_load(seed):
    """Loads over three decades, preloads over one and a half, up to 25 000 rpm, thin and thick rings."""
    draw = np.random.default_rng(seed)
    pair = PRESSED | {
        "bearing.pair.arrangement": draw.choice(["back_to_back", "face_to_face"]),
        "bearing.pair.preload": f"{10 ** draw.uniform(1.5, 3)} N",
        "operation.inner_speed": f"{draw.uniform(0, 25e3)} rpm",
    }
    rings = dict(HELD[draw.choice(list(HELD))])
    if "outer.thickness" in rings:
        rings["outer.thickness"] = f"{draw.uniform(2.4, 6)} mm"
    size, load = 10 ** draw.uniform(1.3, 4), draw.normal(size=3)
    load *= size / np.linalg.norm(load)
    given = {f"operation.load.{key}": f"{force} N" for key, force in zip(
        ("axial", "radial_y", "radial_z"), load, strict=True)}  # fmt: skip
    if draw.random() < 0.5:
        given |= FREE | {"operation.load.moment_y": f"{draw.normal() * size * 2e-3} N m"}
    result = solved(rings, pair, given)
    assert result.attributes["attempts"]["newton"]["status"] == "converged"
    carried = forces(result.flexible, pair, bearing(case(pair)).bearing)[:3]
    assert carried == approx(load, rel=0, abs=1e-9 * result.flexible["contact_load"].max())
