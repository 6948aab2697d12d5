"""Drawings of a case: its values as dimensions, to scale, readable, the same on every run."""

import subprocess
import sys
import warnings
from functools import cache
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from flexbearing import api
from flexbearing.__main__ import command
from flexbearing.case.declarations import by_path
from flexbearing.units import unit

CONFIGS = Path(__file__).parents[2] / "configs"
SHIPPED = sorted(CONFIGS.glob("*.toml")) + sorted((CONFIGS / "catalogue").glob("*.toml"))
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
SHOULDERS = ["bearing.inner.shoulder=2 mm", "bearing.outer.shoulder=1.5 mm", "bearing.fits.shaft_bore=20 mm"]
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
    "angular contact": ("catalogue/7208.toml", SHOULDERS),
    "deep groove": ("6209.toml", []),
    "four points": ("joshi2015_qj309.toml", []),
    "one ball": ("heras2017_a1.toml", []),
    "bolted": ("slewing_bolted.toml", []),
}
SIGNS = ("Ø ", "R ", "r ", "2 sides, sum ")


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
        if separator:
            for sign in SIGNS:
                value = value.removeprefix(sign)
            found[key] = value.removesuffix(" *").removesuffix(" †")
    return found


def at(case, key):
    value = case
    for name in key.split("."):
        value = getattr(value, name)
    return value


@pytest.mark.parametrize("kind", KINDS)
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
            number, _, name = (
                text.replace("°", " deg").replace("µm", "um").replace("mm³", "mm^3").partition(" ")
            )
            si = np.radians(float(number)) if name == "deg" else unit(name).to_si(float(number))
            assert si == pytest.approx(value, rel=1e-5, abs=1e-12), key


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
    assert "Dimensions overlap" not in next(iter(api.drawings(free))).svg


def test_rollers_stand_at_their_azimuths():
    case, sheets = drawn("squirrel cage")
    circles = [path(sheets["along-axis"].svg, f"along-axis-element-{number}")[:-1] for number in (1, 8, 16)]
    first, eighth, opposite = ((circle.max(axis=0) + circle.min(axis=0)) / 2 for circle in circles)
    centre, pitch = (first + opposite) / 2, 70.0
    assert opposite[1] - first[1] == pytest.approx(pitch, abs=0.01)  # scale 1 : 1, azimuth 0 below
    angle = 2 * np.pi * 7 / case.bearing.rollers
    assert eighth - centre == pytest.approx(pitch / 2 * np.array([np.sin(angle), -np.cos(angle)]), abs=0.01)


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


@pytest.mark.parametrize("kind", KINDS)
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
@pytest.mark.parametrize("case", SHIPPED, ids=lambda path: path.stem)
def test_every_shipped_case_is_drawn_without_a_warning(case):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        sheets = api.drawings(api.read_case(case))
    assert sheets[0].name == "section"
    assert all(sheet.caption and sheet.alternative for sheet in sheets)


def test_drawings_are_the_same_on_every_run():
    case, sheets = drawn("bolted")
    assert [sheet.svg for sheet in api.drawings(case)] == [sheet.svg for sheet in sheets.values()]
    assert "date" not in sheets["section"].svg


def test_drawings_load_neither_finite_elements_nor_the_bearing_model():
    program = (
        "import sys; from flexbearing import api\n"
        f"[sheet.svg for sheet in api.drawings(api.read_case({str(CONFIGS / 'nu209.toml')!r}))]\n"
        "print([name for name in ('ngsolve', 'netgen', 'quasidynamic', 'fem') if name in sys.modules])"
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert ended.stdout.strip() == "[]"


@pytest.mark.parametrize(("form", "beginning"), [("svg", b"<svg"), ("png", b"\x89PNG"), ("pdf", b"%PDF")])
def test_command_writes_files(tmp_path, capsys, form, beginning):
    assert command(["draw", str(CONFIGS / "6209.toml"), "-o", str(tmp_path), "--format", form]) == 0
    files = sorted(tmp_path.iterdir())
    assert [file.name for file in files] == [f"6209_along-axis.{form}", f"6209_section.{form}"]
    assert all(file.read_bytes().startswith(beginning) for file in files)
    assert "6209_section" in capsys.readouterr().out


def test_other_formats_are_refused(tmp_path, capsys):
    assert command(["draw", str(CONFIGS / "6209.toml"), "-o", str(tmp_path), "--format", "gif"]) == 2
    assert "svg, png, pdf" in capsys.readouterr().err
