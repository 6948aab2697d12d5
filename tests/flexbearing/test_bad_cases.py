"""Every broken case gets a message that names file, key, value found and what is allowed."""

import pytest

from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from tests.places import CONFIGS

GOOD = (CONFIGS / "mao2016.toml").read_text()

# What is replaced in the good case, by what, and what the message must hold.
BROKEN = {
    "unknown key": (
        'clearance = "75.5 um"', 'clearence = "75.5 um"',
        ["broken.toml", "[bearing] clearence", '"75.5 um"', "not a key", "Did you mean clearance?"],
    ),
    "unknown section": (
        "[coupling]", "[cuopling]",
        ["broken.toml", "cuopling", "not a key", "Did you mean coupling?"],
    ),
    "missing key": (
        "rollers = 30 ", "# ",
        ["broken.toml", "[bearing] rollers is missing", "a whole number, at least 3 and at most 1000"],
    ),
    "missing key that a choice needs": (
        "bars = 24", "",
        ["broken.toml", "[outer] bars is missing", "squirrel_cage", "a whole number"],
    ),
    "no unit": (
        'diameter = "5 mm" ', "diameter = 5 ",
        ["broken.toml", "[bearing.roller] diameter = 5 has no unit", '"5 mm"'],
    ),
    "unit of another quantity": (
        'radial_load = "19621.1 N"', 'radial_load = "19621.1 kg"',
        ["broken.toml", "[operation] radial_load", '"19621.1 kg" is not a force', '"20 kN"'],
    ),
    "unknown unit": (
        'inner_speed = "38000 rpm"', 'inner_speed = "38000 upm"',
        ["broken.toml", "[operation] inner_speed", "unknown unit, upm", '"38000 rpm"'],
    ),
    "out of range": (
        "poisson_ratio = 0.3\n", "poisson_ratio = 0.6\n",
        ["broken.toml", "[materials.roller] poisson_ratio = 0.6", "below 0.5"],
    ),
    "not a choice": (
        'contact_law = "palmgren"', 'contact_law = "hertz"',
        ["broken.toml", "[bearing] contact_law", '"hertz"', '"palmgren" or "iso16281"'],
    ),
    "text for a number": (
        "rollers = 30 ", 'rollers = "thirty" ',
        ["broken.toml", "[bearing] rollers", '"thirty"', "a whole number"],
    ),
    "too many rollers": (
        "rollers = 30 ", "rollers = 50 ",
        ["broken.toml", "[bearing] rollers = 50", "at most 43"],
    ),
    "bars that touch": (
        'bar_width = "4 mm"', 'bar_width = "9.8 mm"',
        ["broken.toml", "[outer] bar_width", '"9.8 mm"', "at most 9.622 mm", "24 slots"],
    ),
    "bars thicker than the ring": (
        'bar_thickness = "2.6 mm"', 'bar_thickness = "3.6 mm"',
        ["broken.toml", "[outer] bar_thickness", "at most 3.4 mm", "3.6 mm of outer.thickness"],
    ),
    "bore outside the raceway": (
        'bore = "59.6 mm"', 'bore = "66 mm"',
        ["broken.toml", "[inner] bore", '"66 mm"', "64.92 mm"],
    ),
    "nothing rolls": (
        'outer_speed = "0 rpm"', 'outer_speed = "38000 rpm"',
        ["broken.toml", "[operation] inner_speed", "nothing rolls"],
    ),
    "moment on a ring that may not tilt": (
        'moment = "0 N m"\ntilt = "free"', 'moment = "20 N m"\ntilt = "fixed"',
        ["broken.toml", "[operation] moment", '"20 N m"', "fixed"],
    ),
    "assumed key that is none": (
        '"lubricant.oil", ', '"lubricant.oyl", ',
        ["broken.toml", "assumed", "lubricant.oyl", "Did you mean oil?"],
    ),
    "oil by name and by data": (
        "oil_fraction = 0.3324", 'oil_fraction = 0.3324\ndensity = "900 kg/m^3"',
        ["broken.toml", "[lubricant] density", "not both"],
    ),
    "not TOML": ("[bearing]", "[bearing", ["broken.toml", "not valid TOML", "line"]),
}  # fmt: skip


@pytest.mark.parametrize(("old", "new", "expected"), BROKEN.values(), ids=BROKEN.keys())
def test_message_of_a_broken_case(old, new, expected, tmp_path):
    assert old in GOOD
    file = tmp_path / "broken.toml"
    file.write_text(GOOD.replace(old, new, 1))
    with pytest.raises(BadCase) as problem:
        read_case(file)
    for part in expected:
        assert part in str(problem.value)


def test_every_problem_has_a_line_of_its_own(tmp_path):
    file = tmp_path / "broken.toml"
    file.write_text(GOOD.replace("rollers = 30 ", "rollers = 1 ").replace("slices = 20", "slices = 0"))
    with pytest.raises(BadCase) as problem:
        read_case(file)
    assert len(str(problem.value).splitlines()) == 2


def test_file_that_is_not_there():
    with pytest.raises(BadCase, match=r"nowhere\.toml: there is no such file"):
        read_case("nowhere.toml")


def test_good_case_is_good(tmp_path):
    """Or the tests above would pass for another reason."""
    file = tmp_path / "good.toml"
    file.write_text(GOOD)
    assert read_case(file).bearing.rollers == 30


MISPLACED = {  # a key that another table has
    "[bearing] bore = ": "Did you mean [bearing.fits] bore or [bearing.ribs] bore or [inner] bore?",
    "[bearing] diameter = ": "Did you mean [bearing.fits.housing] diameter or [bearing.roller] diameter?",
    "[operation] misalignmentt = ": "Did you mean misalignment?",
    "[outer] land_diameter = ": "Did you mean [bearing.cage] land_diameter?",
}


@pytest.mark.parametrize(("place", "hint"), MISPLACED.items(), ids=MISPLACED.keys())
def test_misplaced_key_is_told_its_table(place, hint, tmp_path):
    table, name = place.removesuffix(" = ").split()
    file = tmp_path / "case.toml"
    file.write_text(GOOD.replace(f"\n{table}\n", f'\n{table}\n{name} = "5 mm"\n', 1))
    with pytest.raises(BadCase) as problem:
        check(file)
    assert f'{place}"5 mm" is not a key here. {hint}' in str(problem.value)


@pytest.mark.parametrize("name", ["harris218", "slewing_bolted"])
def test_clearance_classes_of_balls_are_refused_with_a_sentence(name):
    with pytest.raises(BadCase, match='offered for kind = "cylindrical_roller" and "deep_groove_ball"'):
        check(CONFIGS / f"{name}.toml", {"bearing.clearance_class": "C3"})


PARTS = ("roller", "inner_ring", "outer_ring")


def test_expansion_is_asked_for_only_with_temperatures():
    without = [f"materials.{part}.expansion=" for part in PARTS]
    cold = read_case(CONFIGS / "nu209.toml", without)
    assert cold.materials.roller.expansion is None
    assert check(CONFIGS / "nu209.toml", without)
    with pytest.raises(BadCase) as found:
        check(CONFIGS / "mao2016.toml", without)
    for part in PARTS:
        assert f"[materials.{part}] expansion is missing: [operation.temperatures] needs it" in str(
            found.value
        )
