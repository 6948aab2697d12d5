"""Drawings of a case: its values as dimensions, to scale, readable, the same on every run."""

import subprocess
import sys
import warnings
from functools import cache
from itertools import combinations
from xml.etree import ElementTree

import numpy as np
import pytest

from flexbearing import api
from flexbearing.__main__ import command
from flexbearing.case import BadCase
from flexbearing.case.declarations import by_path
from flexbearing.families import FAMILIES
from flexbearing.report.drawing import of_case
from flexbearing.report.picture import picture_bytes
from flexbearing.units import unit
from tests.places import CONFIGS

SHIPPED = [*sorted(CONFIGS.glob("*.toml")), *sorted((CONFIGS / "catalogue").glob("*.toml"))]
RING = [
    "outer.kind=ring", "outer.support=housing", "outer.housing_thickness=6 mm",
    "outer.housing_width=14 mm", "materials.housing=grey cast iron",
]  # fmt: skip
SPRINGS = ["outer.kind=ring", "outer.support=foundation", "outer.foundation_radial=300 N/mm^3"]
LINES = ["outer.kind=ring", "outer.support=lines", 'outer.line_azimuths=["0 deg", "120 deg", "240 deg"]']
PLANET = [
    "outer.kind=ring", "outer.support=planet", 'outer.tooth_azimuths=["90 deg", "270 deg"]',
    'outer.tooth_radial=["-2 kN", "-2 kN"]', 'outer.tooth_tangential=["5 kN", "-5 kN"]',
    "outer.tooth_radius=45 mm",
]  # fmt: skip
MATRIX = ["outer.kind=matrix", "outer.matrix=springs.mtx", "outer.nodes=springs.inp"]
COLLARS = [
    "outer.bar_ends=both", "outer.collar_length=2 mm", "outer.collar_thickness=6 mm", "outer.fillet=0.3 mm",
    "outer.raceway_offset=-1 mm",
]  # fmt: skip
TANGENT = [
    "bearing.roller.profile=tangent_crowned", "bearing.roller.drop=", "bearing.roller.straight_length=5 mm",
    "bearing.roller.crown_radius=600 mm",
]  # fmt: skip
FUJIWARA = [
    "bearing.roller.profile=fujiwara_kawase", "bearing.roller.drop=", "bearing.roller.design_load=4 kN",
    "bearing.roller.load_factor=1.5", "bearing.roller.crowned_share=0.6", "bearing.roller.end_drop=20 um",
]  # fmt: skip
RACEWAYS = [
    "bearing.inner_raceway.profile=crowned", "bearing.inner_raceway.straight_length=6 mm",
    "bearing.inner_raceway.crown_radius=2 m", "bearing.outer_raceway.profile=points",
    'bearing.outer_raceway.point_positions=["-4.8005 mm", "0 mm", "3 mm", "4.8005 mm"]',
    'bearing.outer_raceway.point_drops=["1 um", "0 um", "1.5 um", "12 um"]',
]  # fmt: skip
CAGE = [
    "bearing.cage.guidance=inner", "bearing.cage.land_diameter=62 mm", "bearing.cage.land_width=4 mm",
    "bearing.cage.land_clearance=0.3 mm", "bearing.cage.pocket_clearance=0.1 mm", "bearing.cage.centre=free",
    "bearing.cage.unbalance=20 um", "bearing.cage.unbalance_azimuth=30 deg", "operation.outer_speed=-500 rpm",
    "operation.misalignment=2 arcmin",
]  # fmt: skip
CLAMPED = [
    "inner.kind=ring_on_shaft", "inner.bore=45 mm", "inner.thickness=6.5 mm", "inner.width=19 mm",
    "inner.track_width=10 mm", "inner.shaft_length=42 mm", "materials.shaft=structural steel",
    "inner.fit=friction", "inner.shoulder_diameter=52 mm", "inner.clamping=5 kN", "operation.tilt=free",
]  # fmt: skip
SHOULDERS = ["bearing.inner.shoulder=2 mm", "bearing.outer.shoulder=1.5 mm", "bearing.fits.shaft_bore=20 mm"]
BALLS_ON_SHAFT = [
    "inner.kind=ring_on_shaft", "inner.bore=45 mm", "inner.width=19 mm", "inner.shaft_length=45 mm",
    "bearing.inner.shoulder=2 mm", "materials.shaft=structural steel",
]  # fmt: skip
HOLLOW = ["inner.shaft_thickness=8 mm"]
BALL_RING = [
    "outer.kind=ring", "outer.thickness=3.65 mm", "outer.width=19 mm", "bearing.outer.shoulder=2.2 mm",
]  # fmt: skip
BALL_HOUSING = [
    "outer.support=housing", "outer.housing_thickness=8 mm", "outer.housing_width=24 mm",
    "materials.housing=grey cast iron",
]  # fmt: skip
BALL_SPRINGS = [
    "outer.support=foundation", "outer.foundation_radial=300 N/mm^3", "outer.foundation_axial=50 N/mm^3",
]  # fmt: skip
KINDS = {
    "squirrel cage": ("mao2016.toml", []),
    "collars": ("mao2016.toml", COLLARS),
    "housing": ("mao2016.toml", RING),
    "foundation": ("mao2016.toml", SPRINGS),
    "lines": ("mao2016.toml", LINES),
    "planet rim": ("mao2016.toml", PLANET),
    "matrix": ("mao2016.toml", MATRIX),
    "rigid rings": ("nu209.toml", []),
    "fits": ("nu209_fits.toml", []),
    "STEP file": ("step_ring.toml", []),
    "catalogue": ("catalogue/nj2210.toml", []),
    "tangent crowned": ("nu209.toml", TANGENT),
    "three parameters": ("nu209.toml", FUJIWARA),
    "profiled raceways": ("nu209.toml", RACEWAYS),
    "clamped": ("nu209.toml", CLAMPED),
    "free cage": ("nu209.toml", CAGE),
    "angular contact": ("catalogue/7208.toml", SHOULDERS),
    "deep groove": ("6209.toml", []),
    "cam": ("strain_wave.toml", []),
    "tapered": ("32207.toml", []),
    "tapered, angle of the cone": ("32207.toml", ["bearing.cone_angle=10 deg"]),
    "crossed": ("crossed_roller.toml", []),
    "thrust": ("81110.toml", []),
    "spherical": ("22210.toml", []),
    "four points": ("joshi2015_qj309.toml", []),
    "one ball": ("heras2017_a1.toml", []),
    "bolted": ("slewing_bolted.toml", []),
    "balls on a cage": ("harris218_cage.toml", ["outer.groove_offset=2 mm"]),
    "balls on two cages": ("harris218_cage.toml", ["outer.bar_ends=both"]),
    "balls in a housing": ("6209.toml", BALL_RING + BALL_HOUSING),
    "balls on springs": ("6209.toml", BALL_RING + BALL_SPRINGS),
    "balls in a seat on a shaft": (
        "6209.toml",
        [*BALL_RING, "outer.support=seat", *BALLS_ON_SHAFT, *HOLLOW],
    ),
    "balls held at the side on a solid shaft": ("6209.toml", BALL_RING + BALLS_ON_SHAFT),
}
QUICK = (
    "squirrel cage", "planet rim", "profiled raceways", "angular contact", "bolted",
)  # fmt: skip
EACH_KIND = [pytest.param(kind, marks=[pytest.mark.slow] * (kind not in QUICK)) for kind in KINDS]
SIGNS = ("Ø ", "R ", "r ", "2 sides, sum ", "diametral ")


@cache
def drawn(kind):
    file, settings = KINDS[kind]
    case = api.read_case(CONFIGS / file, settings)
    return case, {drawing.name: drawing for drawing in api.drawings(case)}


def texts(svg):
    root = ElementTree.fromstring(svg)
    return ["".join(each.itertext()).strip() for each in root.iter() if each.tag.endswith("text")]


def dimensions(svg):
    """Key to what is written of it, without signs and marks."""
    found = {}
    for text in texts(svg):
        key, separator, value = text.partition(" = ")
        if separator and " " not in key:
            for sign in SIGNS:
                value = value.removeprefix(sign)
            found[key] = value.removesuffix(" *").removesuffix(" †")
    return found


def at(case, key):
    value = case
    for name in key.split("."):
        value = getattr(value, name)
    return value


def in_si(text):
    number, _, name = text.replace("°", " deg").replace("µm", "um").replace("mm³", "mm^3").partition(" ")
    return np.radians(float(number)) if name == "deg" else unit(name).to_si(float(number))


@pytest.mark.parametrize("kind", EACH_KIND)
def test_dimensions_are_the_values_of_the_case(kind):
    case, sheets = drawn(kind)
    declared = by_path(type(case))
    for sheet in sheets.values():
        written = dimensions(sheet.svg)
        assert written
        for key, text in written.items():
            value, quantity = at(case, key), declared[key].kind
            if quantity is None or quantity.unit == "1":
                assert text.strip('"') == (value if isinstance(value, str) else f"{value:.6g}"), key
                continue
            values = value if isinstance(value, tuple) else (value,)
            assert [in_si(each) for each in text.split("; ")] == pytest.approx(values, rel=1e-5, abs=1e-12), (
                key
            )


ON_BARS = ["balls on a cage", "balls on two cages", "squirrel cage", "collars"]  # with a drawing of the bars
ELASTIC = [
    *ON_BARS,
    "clamped",
    *(kind for kind in KINDS if kind.startswith("balls ") and kind not in ON_BARS),
]


@pytest.mark.parametrize("kind", ELASTIC)
def test_every_length_of_an_elastic_ring_is_a_dimension(kind):
    if kind in ON_BARS:
        case, sheets = drawn(kind)
    else:
        case = api.read_case(CONFIGS / KINDS[kind][0], KINDS[kind][1])
        sheets = {"section": next(of_case.drawings(FAMILIES[case.kind], case))}
    written = {key for sheet in sheets.values() for key in dimensions(sheet.svg)}
    given = {
        key
        for key, item in by_path(type(case)).items()
        if (table := key.partition(".")[0]) in ("outer", "inner") and item.kind and item.kind.unit == "m"
        if key.rpartition(".")[2] in getattr(case, table).model_fields_set
    }
    assert given
    assert given <= written


def test_ring_and_bars_of_balls_are_to_scale():
    case, sheets = drawn("balls on a cage")
    svg, outer, shoulder = sheets["section"].svg, case.outer, case.bearing.outer.shoulder
    scale = np.ptp(path(svg, "section-ball")[:, 0]) / case.bearing.ball.diameter
    ring, bar = path(svg, "section-outer-ring"), path(svg, "section-bar")
    assert np.ptp(ring, axis=0) / scale == pytest.approx([outer.width, outer.thickness + shoulder], rel=1e-3)
    assert np.ptp(bar, axis=0) / scale == pytest.approx([outer.bar_length, outer.bar_thickness], rel=1e-3)
    ring_middle, bar_middle = (np.add(*(each.min(axis=0), each.max(axis=0))) / 2 for each in (ring, bar))
    assert bar_middle[1] == pytest.approx(ring_middle[1], abs=1e-3 * scale * shoulder)
    land, top = ring[:, 1].min(), ring[:, 1].max()
    groove = ring[(ring[:, 1] > land + 0.1 * scale * shoulder) & (ring[:, 1] < top)]
    assert (groove[:, 0].mean() - ring_middle[0]) / scale == pytest.approx(outer.groove_offset, rel=0.01)


def test_marks_tell_what_is_assumed_and_calibrated():
    _, sheets = drawn("squirrel cage")
    written = texts(sheets["section"].svg)
    assert "outer.width = 10 mm *" in written
    assert "bearing.clearance = 75.5 µm †" in written
    assert "outer.thickness = 3.6 mm" in written


def path(svg, name):
    """Corners of a named line [mm of paper, upwards]."""
    root = ElementTree.fromstring(svg)
    element = next(each for each in root.iter() if each.get("id") == name)
    words = (
        next(each.get("d") for each in element.iter() if each.get("d")).replace("M", " ").replace("L", " ")
    )
    numbers = [float(word) for word in words.replace("z", " ").split()]
    return np.reshape(numbers, (-1, 2)) * 25.4 / 72 * [1, -1]


def test_paper_is_as_large_as_the_drawing_says():
    svg = drawn("squirrel cage")[1]["section"].svg
    root = ElementTree.fromstring(svg)
    assert root.get("viewBox").split()[2] == root.get("width").removesuffix("pt")


def test_raceways_are_apart_to_scale():
    case, sheets = drawn("squirrel cage")
    svg = sheets["section"].svg
    assert any(text.startswith("scale 2 : 1") for text in texts(svg))
    outer, inner = (path(svg, f"section-{race}-raceway") for race in ("outer", "inner"))
    apart = case.bearing.roller.diameter + case.bearing.clearance / 2
    assert outer[0, 1] - inner[0, 1] == pytest.approx(2e3 * apart, abs=1e-3)
    assert np.ptp(outer[:, 0]) == pytest.approx(2e3 * case.outer.width, abs=1e-3)
    assert np.ptp(inner[:, 0]) == pytest.approx(2e3 * case.inner.track_width, abs=1e-3)


def test_cage_that_overlaps_the_ribs_is_told():
    case, sheets = drawn("squirrel cage")
    cage = case.bearing.cage
    inside = cage.land_diameter - cage.land_clearance - 2 * cage.thickness
    ribs = case.inner.bore + 2 * case.inner.thickness
    told = f"Dimensions overlap: cage inside Ø {1e3 * inside:.6g} mm, inner ribs Ø {1e3 * ribs:.6g} mm."
    assert inside < ribs
    assert told in texts(sheets["section"].svg)
    free = api.read_case(CONFIGS / "mao2016.toml", ("bearing.cage.thickness=2 mm",))
    assert "Dimensions overlap" not in next(of_case.drawings(FAMILIES[free.kind], free)).svg


def test_rollers_stand_at_their_azimuths():
    case, sheets = drawn("squirrel cage")
    circles = [path(sheets["along-axis"].svg, f"along-axis-element-{number}")[:-1] for number in (1, 8, 16)]
    first, eighth, opposite = ((circle.max(axis=0) + circle.min(axis=0)) / 2 for circle in circles)
    centre, pitch = (first + opposite) / 2, 70.0
    assert opposite[1] - first[1] == pytest.approx(pitch, abs=0.01)  # scale 1 : 1, azimuth 0 below
    angle = 2 * np.pi * 7 / case.bearing.rollers
    assert eighth - centre == pytest.approx(pitch / 2 * np.array([np.sin(angle), -np.cos(angle)]), abs=0.01)


def test_a_profile_drops_by_its_formula_times_what_the_sheet_says():
    case, sheets = drawn("squirrel cage")
    svg, roller = sheets["profile"].svg, case.bearing.roller
    assert {"scale 15 : 1; * assumed", "bearing.roller.drop = 1.75 µm *"} <= set(texts(svg))
    assert any(text.endswith("magnified 200 times.") for text in texts(svg))
    line = path(svg, "profile-bearing-roller")
    x, drop = (line[:, 0] - line[:, 0].mean()) / 15e3, (line[:, 1].max() - line[:, 1]) / 15e3 / 200
    assert np.ptp(x) == pytest.approx(0.99 * roller.length, rel=5e-3)
    formula = -roller.drop * np.log1p(-((2 * x / roller.length) ** 2))
    assert drop == pytest.approx(formula, rel=2e-3, abs=2e-9)


def test_profiles_that_are_not_straight_are_drawn_each():
    _, sheets = drawn("profiled raceways")
    svg = sheets["profile"].svg
    halves = []
    for table in ("roller", "inner_raceway", "outer_raceway"):
        line = path(svg, f"profile-bearing-{table}")
        halves.append([line[:, 1].max() - line[end, 1] for end in (0, -1)])
    assert [halves[0][0], halves[1][0]] == pytest.approx(
        [halves[0][1], halves[1][1]], rel=1e-6
    )  # halves alike
    assert halves[2][1] == pytest.approx(12 * halves[2][0], rel=1e-3)  # 1 and 12 um, the latter at +x
    straight = api.read_case(
        CONFIGS / "nu209.toml", ["bearing.roller.profile=straight", "bearing.roller.drop="]
    )
    assert not FAMILIES[straight.kind].profiles()(straight)
    assert "profile" not in drawn("deep groove")[1]


def test_points_that_cannot_be_read_are_told():
    settings = [
        "bearing.roller.profile=points", "bearing.roller.drop=", "bearing.roller.points_file=nowhere.csv",
    ]  # fmt: skip
    with pytest.raises(BadCase, match=r'"nowhere\.csv": there is no such file'):
        api.drawings(api.read_case(CONFIGS / "nu209.toml", settings))


def test_rings_turn_towards_growing_azimuth_where_their_speed_is_positive():
    _, sheets = drawn("free cage")
    svg = sheets["along-axis"].svg
    first, opposite = ((c.max(axis=0) + c.min(axis=0)) / 2 for c in (path(svg, f"along-axis-element-{n}")[:-1]
                                                                     for n in (1, 8)))  # fmt: skip
    for speed, sense in (("inner_speed", 1), ("outer_speed", -1)):
        line = path(svg, f"along-axis-{speed}") - (first + opposite) / 2
        azimuth = np.arctan2(line[:, 0], -line[:, 1])
        assert (np.sign(np.diff(azimuth)) == sense).all(), speed


def test_clearances_of_the_cage_are_magnified_and_said_to_be():
    case, sheets = drawn("free cage")
    svg = sheets["cage"].svg
    roller, wall = path(svg, "cage-roller"), path(svg, "cage-bar-ahead")
    gap = wall[:, 0].min() - roller[:, 0].max()
    assert gap > 3 * np.ptp(roller[:, 0]) * case.bearing.cage.pocket_clearance / case.bearing.roller.diameter
    written = texts(svg)
    assert any(text.startswith("not to scale") for text in written)
    assert not any(text.startswith("scale ") for text in written)
    assert "bearing.cage.land_clearance = diametral 0.3 mm" in written


@pytest.mark.sampled(2)
@pytest.mark.parametrize("kind", ["squirrel cage", "bolted", "planet rim", "fits"])
def test_leaders_do_not_cross(kind):
    for sheet in drawn(kind)[1].values():
        lines = [line.get_xydata() for line in sheet.figure.axes[0].lines if len(line.get_xydata()) == 3]
        assert lines
        for one, other in combinations([line[:2] for line in lines], 2):
            apart = [np.linalg.det([one[1] - one[0], point - one[0]]) for point in other]
            across = [np.linalg.det([other[1] - other[0], point - other[0]]) for point in one]
            crossing = max(apart) > 1e-9 > -1e-9 > min(apart) and max(across) > 1e-9 > -1e-9 > min(across)
            assert not crossing, (kind, sheet.name)


def test_keys_stand_without_values_on_wish():
    case, sheets = drawn("angular contact")
    keys = by_path(type(case))
    for sheet in api.drawings(case, values=False):
        written = texts(sheet.svg)
        assert not dimensions(sheet.svg)
        labels = {text.rpartition(" ")[2] for text in written} & {key for key in keys if "." in key}
        assert labels == set(dimensions(sheets[sheet.name].svg))


def test_ball_touches_its_grooves_at_the_contact_angle():
    case, sheets = drawn("angular contact")
    svg = sheets["section"].svg
    ball, (low, high) = path(svg, "section-ball"), path(svg, "section-contact-line")[:2]
    centre, scale = (ball.max(axis=0) + ball.min(axis=0)) / 2, np.ptp(ball[:, 0]) / case.bearing.ball.diameter
    along = (high - low) / np.hypot(*(high - low))
    assert np.arctan2(*along) == pytest.approx(case.bearing.contact_angle, abs=1e-4)
    for side in ("outer", "inner"):
        away = np.hypot(*(path(svg, f"section-{side}-groove") - centre).T)
        nearest = path(svg, f"section-{side}-groove")[away.argmin()]
        assert away.min() == pytest.approx(scale * case.bearing.ball.diameter / 2, abs=2e-3)
        assert abs(np.linalg.det([along, nearest - centre])) < 0.3  # [mm] aside of the line


@pytest.mark.parametrize("kind", EACH_KIND)
def test_labels_do_not_overlap_and_stay_on_the_page(kind):
    for sheet in drawn(kind)[1].values():
        figure = sheet.figure
        figure.draw_without_rendering()
        boxes = {
            text: text.get_window_extent().padded(-0.5) for text in figure.axes[0].texts if text.get_text()
        }
        overlapping = [
            (a.get_text(), b.get_text()) for a, b in combinations(boxes, 2) if boxes[a].overlaps(boxes[b])
        ]
        assert overlapping == [], sheet.name
        page = figure.bbox
        assert all(page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1
                   for box in boxes.values()), sheet.name  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    "case",
    [path for path in SHIPPED if (str(path.relative_to(CONFIGS)), []) not in KINDS.values()],
    ids=lambda path: path.stem,
)
def test_every_shipped_case_is_drawn_without_a_warning(case):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        wanted = api.read_case(case)
        sheets = api.drawings(wanted)
    undrawn = wanted.kind == "tapered_roller"
    assert [sheet.name for sheet in sheets[:1]] == ([] if undrawn else ["section"])
    assert all(sheet.caption and sheet.alternative for sheet in sheets)


def test_a_name_that_no_font_draws_is_no_warning():
    """An escape and Chinese glyphs."""
    name = "\x1b[31m\u5916\u5708.step"
    case = api.read_case(CONFIGS / "step_ring.toml")
    case = case.model_copy(update={"outer": case.outer.model_copy(update={"file": name})})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        section = next(of_case.drawings(FAMILIES[case.kind], case)).figure
        picture_bytes(section)
    texts = [text.get_text() for text in section.axes[0].texts]
    assert any(name.removeprefix("\x1b") in text for text in texts)
    assert not any("\x1b" in text for text in texts)


def test_no_extension_line_crosses_the_text_of_a_length():
    figure = drawn("squirrel cage")[1]["section"].figure
    axes = figure.axes[0]
    part = min(patch.get_path().vertices[:, 0].min() for patch in axes.patches if patch.get_gid())
    texts = [text for text in axes.texts if text.get_text().startswith(("inner.width", "outer.bar_length"))]
    assert len(texts) == 2
    assert all(text.get_ha() == "right" and text.get_position()[0] < part for text in texts)


def test_drawings_are_the_same_on_every_run():
    case, sheets = drawn("angular contact")
    assert [sheet.svg for sheet in api.drawings(case)] == [sheet.svg for sheet in sheets.values()]
    assert "date" not in sheets["section"].svg


def test_drawings_load_no_finite_elements_and_the_bearing_model_for_profiles_alone():
    program = "import sys; from flexbearing import api\n" + "".join(
        f"api.drawings(api.read_case({str(CONFIGS / case)!r}))\n"
        "print([name for name in ('ngsolve', 'netgen', 'quasidynamic', 'fem') if name in sys.modules])\n"
        for case in ("6209.toml", "nu209.toml")
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert ended.stdout.splitlines() == ["[]", "['quasidynamic']"]


@pytest.mark.parametrize(("form", "beginning"), [("png", b"\x89PNG"), ("pdf", b"%PDF")])
def test_command_writes_files(tmp_path, capsys, form, beginning, monkeypatch):
    shared = list(drawn("deep groove")[1].values())
    monkeypatch.setattr(api, "drawings", lambda case, values: shared)
    assert command(["draw", str(CONFIGS / "6209.toml"), "-o", str(tmp_path), "--format", form]) == 0
    files = sorted(tmp_path.iterdir())
    assert [file.name for file in files] == [f"6209_along-axis.{form}", f"6209_section.{form}"]
    assert all(file.read_bytes().startswith(beginning) for file in files)
    assert "6209_section" in capsys.readouterr().out


def test_command_writes_keys_alone(tmp_path):
    assert command(["draw", str(CONFIGS / "6209.toml"), "-o", str(tmp_path), "--keys"]) == 0
    written = texts((tmp_path / "6209_section.svg").read_text("utf-8"))
    assert "Ø bearing.ball.diameter" in written
    assert not any(" = " in text for text in written)


def test_other_formats_are_refused(tmp_path, capsys):
    assert command(["draw", str(CONFIGS / "6209.toml"), "-o", str(tmp_path), "--format", "gif"]) == 2
    assert "svg, png, pdf" in capsys.readouterr().err
