"""What a ball bearing's case file may not say, and how it is told."""

import subprocess
import sys

import pytest
from pytest import approx

from flexbearing import explain
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import AngularCase
from flexbearing.case.balls.deep_groove import DeepGrooveCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.roller import Case
from flexbearing.families import FAMILIES
from flexbearing.progress import Logged
from flexbearing.studies.maps.map import MapRequest, map_case
from tests.places import CONFIGS

FOUR_POINT, ONE_BALL, ANGULAR, DEEP_GROOVE = (
    CONFIGS / f"{name}.toml" for name in ("joshi2015_fourpoint", "heras2017_a3", "rivera2021_7008", "6209")
)


def refusal(file, *settings):
    with pytest.raises(BadCase) as problem:
        read_case(file, settings)
    return str(problem.value)


def test_kind_decides_what_a_case_is():
    assert type(read_case(CONFIGS / "mao2016.toml")) is Case
    assert type(read_case(FOUR_POINT)) is FourPointCase
    assert type(read_case(ANGULAR)) is AngularCase
    assert type(read_case(DEEP_GROOVE)) is DeepGrooveCase
    files = (
        CONFIGS / "mao2016.toml",
        FOUR_POINT,
        ANGULAR,
        DEEP_GROOVE,
        CONFIGS / "32207.toml",
        CONFIGS / "81110.toml",
        CONFIGS / "22210.toml",
    )
    assert {read_case(file).kind for file in files} == set(FAMILIES)


IMPOSSIBLE = {
    "interference by its name": (
        FOUR_POINT, ["bearing.interference=5 um"], "is not a key", "a negative bearing.clearance",
    ),
    "preload in the bearing": (
        FOUR_POINT, ["bearing.preload=5 um"], "is not a key", "a negative bearing.clearance",
    ),
    "radial clearance in the wrong unit": (
        DEEP_GROOVE, ["bearing.clearance=15 mm"], '[bearing] clearance = "15 mm"', "of a size below 1000 um"),
    "too many balls": (FOUR_POINT, ["bearing.balls=200"], "[bearing] balls = 200", "at most 170"),
    "clearance in the wrong unit": (
        FOUR_POINT, ["bearing.clearance=18 mm"], "[bearing] clearance", "is the unit right?",
    ),
    "interference deeper than the grooves": (
        FOUR_POINT, ["bearing.clearance=-2 mm"], "[bearing] clearance", "between -1750 um and 1750 um",
    ),
    "conformity from the ball radius": (
        FOUR_POINT, ["bearing.inner.conformity=0.5"], "[bearing.inner] conformity = 0.5", "at least 0.5001",
    ),
    "groove twice": (
        FOUR_POINT, ["bearing.inner.radius=20 mm"], "[bearing.inner] radius", "give one of the two",
    ),
    "ring load without balls": (
        ONE_BALL, ["operation.mode=ring_load"], "[bearing] balls is missing", 'mode = "ring_load" needs it',
    ),
    "cells without quarters": (
        ONE_BALL, ["friction.model=kalker", "friction.cells=[40, 30]"],
        "[friction] cells", "two multiples of four",
    ),
    "an interface without stick": (
        ONE_BALL, ["friction.interface_compliance=2 um"], "[friction] interface_compliance", "kalker",
    ),
    "cells without stick": (
        ONE_BALL, ["friction.cells=[20, 40]"], "[friction] cells", "kalker",
    ),
    "computed pressure without stick": (
        ONE_BALL, ["friction.contact_pressure=offset"], "[friction] contact_pressure", "kalker",
    ),
    "cells of fast balls without quarters": (
        ANGULAR, ["friction.model=kalker", "friction.cells=[40, 30]"],
        "[friction] cells", "two multiples of four",
    ),
    "points beside cells": (
        ONE_BALL, ["friction.model=fastsim", "fields.points=31"], "[fields] points", "full_sliding",
    ),
    "three diagonals": (
        ONE_BALL, ['operation.contact_loads=["1 N", "1 N", "1 N"]'],
        "[operation] contact_loads", "one or two",
    ),
    "nothing pressed": (
        ONE_BALL, ['operation.contact_loads=["0 N", "0 N"]'], "[operation] contact_loads", "above zero",
    ),
    "load without unit": (
        ONE_BALL, ["operation.contact_loads=[5, 0]"],
        "[operation] contact_loads = [5, 0] has no unit", "26 kN",
    ),
    "contact loads that are not there": (
        FOUR_POINT, ["operation.mode=contact_loads"], "[operation] contact_loads is missing", "needs it",
    ),
    "two frictions": (
        ONE_BALL, ['friction.pressures=["1 GPa"]', "friction.coefficients=[0.1]"],
        "[friction] coefficient = 0.09", "give one of the two",
    ),
    "field of a ball that is not there": (
        FOUR_POINT, ["fields.balls=[156]"], "[fields] balls = [156]", "from 0 to 155",
    ),
    "load and place at once": (
        ANGULAR, ["operation.displacement.axial=5 um"],
        "[operation.displacement] axial", "left out beside operation.load.axial",
    ),
    "ball as large as the pitch circle": (
        ANGULAR, ["bearing.ball.diameter=60 mm"], "[bearing.ball] diameter",
        "below 54 mm, bearing.pitch_diameter",
    ),
    "control by nothing": (
        ANGULAR, ["operation.control=none"], "[operation] control", '"outer" or "inner" or "equal"',
    ),
    "friction of the motion as it was named": (
        ANGULAR, ["operation.friction=0.06"], "operation.friction is now friction.coefficient",
        "one for every use",
    ),
    "friction of the lines as it was named": (
        ANGULAR, ["rolling_lines.coefficient=0.06"], "rolling_lines.coefficient is now friction.coefficient",
        "one for every use",
    ),
    "friction of nothing": (
        ANGULAR, ["operation.control=coulomb", "friction.coefficient=0"], "[friction] coefficient",
        "at least",
    ),
    "shoulder above the groove": (
        ANGULAR, ["bearing.outer.shoulder=4.2 mm"],
        "[bearing.outer] shoulder", "at most the groove radius, 4.128 mm",
    ),
    "shoulder of no height": (
        ANGULAR, ["bearing.inner.shoulder=0 mm"], "[bearing.inner] shoulder", "above 0 m",
    ),
    "shoulder above the arches": (
        FOUR_POINT, ["bearing.inner.shoulder=18.4 mm"],
        "[bearing.inner] shoulder", "at most the depth of the arches, 18.36 mm",
    ),
    "shoulder of a bolted ring": (
        CONFIGS / "slewing_bolted.toml", ["bearing.outer.shoulder=4 mm"],
        "[bearing.outer] shoulder", "left out beside rings.outer.groove_end",
    ),
    "key of a roller bearing": (
        ANGULAR, ["bearing.rollers=5"], "[bearing] rollers is not a key of this case",
        'It belongs to kind = "cylindrical_roller"',
    ),
    "load in the axes of older files": (
        FOUR_POINT, ["operation.load.radial_x=1 kN"], "[operation.load] radial_x is not a key of this case",
        "operation.load.radial_x is now operation.load.radial_z; axes changed: x axial",
    ),
    "moment in the axes of older files": (
        FOUR_POINT, ["operation.load.moment_x=1 N m"], "[operation.load] moment_x is not a key of this case",
        "is now operation.load.moment_z, with the opposite sign; axes changed",
    ),
    "displacement in the axes of older files": (
        ANGULAR, ["operation.displacement.radial_x=1 um"], "[operation.displacement] radial_x",
        "is now operation.displacement.radial_z; axes changed",
    ),
    "tilt in the axes of older files": (
        ANGULAR, ["operation.displacement.tilt_x=0 deg"], "[operation.displacement] tilt_x",
        "is now operation.displacement.tilt_z, with the opposite sign; axes changed",
    ),
    "unknown kind": (ANGULAR, ["kind=ball"], 'kind = "ball" is not allowed', '"four_point_ball"'),
}  # fmt: skip


@pytest.mark.parametrize(("file", "settings", "place", "allowed"), IMPOSSIBLE.values(), ids=IMPOSSIBLE.keys())
def test_impossible_case_is_refused(file, settings, place, allowed):
    message = refusal(file, *settings)
    assert file.name in message or message.startswith("setting ")
    assert place in message
    assert allowed in message
    assert len(message.splitlines()) == 1


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('kind = "four_point_ball"\n', "", 'balls = 156 is not a key here. It belongs to kind = "four'),
        ('kind = "four_point_ball"\n', "kind = 3\n", "kind = 3 is not allowed"),
        ("balls = 156", "bals = 156", "[bearing] bals = 156 is not a key here. Did you mean balls?"),
        ("coefficient = 0.12", 'pressures = ["2 GPa", "1 GPa"]\ncoefficients = [0.1, 0.1]', "growing"),
        ("coefficient = 0.12", 'pressures = ["1 GPa", "2 GPa"]\ncoefficients = [0.1]', "2 numbers, at least"),
        ("coefficient = 0.12", "coefficients = [0.1]", "[friction] pressures is missing"),
        ("coefficient = 0.12", "", "[friction] coefficient is missing"),
        ("conformity = 0.525 ", "# ", "[bearing.inner] conformity is missing: a groove without radius"),
        ('"friction.coefficient",', '"friction.coefficien",', "Did you mean coefficient?"),
        ("moment_z = ", "moment_x = ", 'moment_x = "328601 N m" is not a key here. operation.'),
        ('"friction.coefficient",', '"operation.load.radial_x",', "is now operation.load.radial_z; axes"),
    ],
    ids=[
        "kind forgotten", "kind is a number", "misspelt", "pressures fall", "one coefficient short",
        "no pressures", "no friction", "no groove", "assumed key that is none",
        "moment of older axes", "assumed key of older axes",
    ],
)  # fmt: skip
def test_broken_file_is_refused(tmp_path, old, new, told):
    text = FOUR_POINT.read_text()
    assert old in text
    file = tmp_path / "broken.toml"
    file.write_text(text.replace(old, new, 1))
    assert told in refusal(file)


def test_shoulder_may_be_as_high_as_the_groove_radius():
    case = read_case(ANGULAR, ["bearing.inner.shoulder=4.12776 mm"])
    assert isinstance(case, AngularCase)
    groove = case.bearing.inner
    assert groove.shoulder == approx(groove.over(7.938e-3) * 7.938e-3, rel=1e-12)


def test_kind_inside_the_bearing_is_shown_its_place(tmp_path):
    file = tmp_path / "inside.toml"
    text = FOUR_POINT.read_text().replace('kind = "four_point_ball"\n', "")
    file.write_text(text.replace("[bearing]", '[bearing]\nkind = "four_point_ball"'))
    assert "write it first in the file" in refusal(file)


def test_key_of_several_kinds_is_explained_for_each():
    found = explain("bearing.clearance")
    assert found.count("key      bearing.clearance") == 4
    assert "kind     four_point_ball" in found
    assert "along a diagonal" in found
    assert "diametral clearance, warm and running" in found
    assert "kind     four_point_ball, angular_contact_ball, deep_groove_ball" in explain(
        "bearing.ball.diameter"
    )
    assert "kind     " not in explain("title")


@pytest.mark.parametrize(
    "over", ["operation.inner_speed=100 rpm..200 rpm", "operation.inner_speed=1 rpm..2 rpm,3"]
)
def test_ball_bearing_has_no_map(over):
    with pytest.raises(BadCase, match='only roller bearings have maps; this case has kind = "angular_'):
        map_case(MapRequest(ANGULAR, (over,)), Logged())


def test_check_loads_nothing_heavy():
    code = (
        "import sys\n"
        "from flexbearing.__main__ import main\n"
        f"for file in {[str(FOUR_POINT), str(ANGULAR)]}:\n"
        "    sys.argv = ['flexbearing', 'check', file]\n"
        "    try: main()\n"
        "    except SystemExit as end: assert not end.code\n"
        "print([m for m in ('ngsolve', 'netgen', 'h5py', 'matplotlib') if m in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    *checked, heavy = found.stdout.splitlines()
    assert len(checked) == 2
    assert all("no errors found" in line for line in checked)
    assert heavy == "[]"
