"""A drawing is a regular file of bounded size; damaged ones are refused, whatever the kernel does."""

import os
import subprocess
import sys

import pytest

from fem.condense import require_drawing
from fem.errors import NotSolved
from fem.parts import step_solid
from fem.parts.material import ImpossiblePart
from fem.parts.quoted import MOST
from flexbearing.api import check, read_case
from flexbearing.build.ring_parts import outer_part
from flexbearing.case import BadCase
from flexbearing.inputs.file import DRAWING
from flexbearing.printable import printable
from tests.flexbearing.hostile_cases import CONFIGS

DRAWN = (CONFIGS / "step_ring.step").read_bytes()
TEXT = (CONFIGS / "step_ring.toml").read_text()


def refusal(folder, file="step_ring.step", clamps="foot"):
    case = folder / "case.toml"
    case.write_text(TEXT.replace('"step_ring.step"', f'"{file}"').replace('"foot"', f'"{clamps}"'))
    with pytest.raises(BadCase) as problem:
        check(case)
    message = str(problem.value)
    assert printable(message) == message
    assert len(message.splitlines()) == 1
    return message.removeprefix(f"{case}: ")


def test_a_drawing_has_a_largest_size(tmp_path):
    with (tmp_path / "large.step").open("wb") as file:
        file.write(DRAWN)
        file.truncate(DRAWING + 1)
    assert "large.step: is larger than 64 MiB" in refusal(tmp_path, "large.step")


@pytest.mark.parametrize("name", ["step\\u0000.step", "s" * 5000, "s/" * 3000], ids=["NUL", "long", "deep"])
def test_a_name_that_no_drawing_can_have_is_refused(name, tmp_path):
    assert len(refusal(tmp_path, name)) < 400


@pytest.mark.parametrize(
    "content", [b"", b"\0" * 1000, b"PK\3\4", DRAWN[1:]], ids=["empty", "NUL", "zip", "cut"]
)
def test_what_does_not_begin_as_step_is_refused_before_meshing(content, tmp_path):
    (tmp_path / "step_ring.step").write_bytes(content)
    assert (
        refusal(tmp_path) == '[outer] step_ring.step is no STEP file: it does not begin with "ISO-10303-21"'
    )


def drawn(content, clamps=("foot",)):
    """The example's ring from another drawing."""
    case = read_case(CONFIGS / "step_ring.toml", {"outer.clamps": list(clamps)})
    part = outer_part(case)
    assert isinstance(part, step_solid.StepSolid)
    return type(part)(**{**vars(part), "drawing": content})


def opened(part):
    """What is said of a drawing that is opened here."""
    from fem.mesh.step_import import solid

    with pytest.raises(ImpossiblePart) as problem:
        solid(part, 9.601e-3)
    message = str(problem.value)
    assert printable(message) == message
    assert len(message.splitlines()) == 1
    return message


@pytest.mark.parametrize("number", ["NAN", "-nan", "inf", "1.E300", "1.E+999"])
def test_numbers_that_are_none_never_reach_the_kernel(number):
    place = DRAWN.index(b"CARTESIAN_POINT('',(") + len("CARTESIAN_POINT('',(")
    content = DRAWN[:place] + number.encode() + DRAWN[DRAWN.index(b",", place) :]
    assert "holds numbers that are not finite" in opened(drawn(content))


def test_large_numbers_that_programs_write_for_no_end_are_read():
    from fem.mesh.step_import import solid

    content = DRAWN.replace(b"DATA;", b"DATA;\n#99999 = CARTESIAN_POINT('',(2.E+100,-1.E-308,0.));", 1)
    assert solid(drawn(content), 9.601e-3).mass > 0


def test_names_in_a_drawing_are_quoted_short_and_printable():
    assert DRAWN.count(b"'foot'") > 0
    for name in (b"red\x1b[31m", b"f" * 5000):
        message = opened(drawn(DRAWN.replace(b"'foot'", b"'" + name + b"'")))
        assert "has no face named" in message
        assert len(message) < 500


def test_only_the_first_names_of_a_drawing_are_offered():
    from fem.parts.quoted import enumerated

    told = enumerated(f'"face {number:03d}"' for number in range(300))
    assert told.count("face") == MOST
    assert told.endswith('"face 019" and 280 more')


def test_a_clamp_is_quoted_short_and_printable():
    message = opened(drawn(DRAWN, ["\x1b[31m" + "f" * 5000]))
    assert 'has no face named "\\u001b[31mfff' in message
    assert len(message) < 500


def test_what_the_kernel_raises_is_said_of_the_drawing(monkeypatch):
    from fem.mesh import step_import

    def void(_):
        raise RuntimeError("Standard_ConstructionError: Bnd_Box is void")

    monkeypatch.setattr(step_import, "_read", void)
    assert opened(drawn(DRAWN)) == (
        "step_ring.step cannot be worked with: Standard_ConstructionError: Bnd_Box is void; repair it and "
        "export it again"
    )


BROKEN = DRAWN.replace(b"ADVANCED_FACE", b"EDGE_CURVE", 1)  # a segmentation fault where it is opened


def test_a_drawing_that_ends_the_kernel_ends_a_process_of_its_own():
    with pytest.raises((NotSolved, ImpossiblePart)):
        require_drawing(drawn(BROKEN), 9.601e-3)


@pytest.mark.parametrize(
    "settings",
    [(), ("--set", "coupling.structure=full", "--set", "coupling.method=iqn-ils")],
    ids=["condensed", "in full"],
)
@pytest.mark.slow
def test_a_run_survives_a_damaged_drawing(settings, tmp_path):
    (tmp_path / "step_ring.step").write_bytes(BROKEN)
    (tmp_path / "case.toml").write_text(TEXT)
    ended = subprocess.run(
        [sys.executable, "-m", "flexbearing", "run", "case.toml", "-o", "out.h5", "--quiet", *settings],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(CONFIGS.parent), "FLEXBEARING_CACHE": "off"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert ended.returncode in (1, 2), ended.stderr
    assert "Traceback" not in ended.stderr
    assert "drawing" in ended.stderr


@pytest.mark.slow
def test_a_drawing_that_the_kernel_never_finishes_is_given_up(tmp_path):
    """A word in place of the length of a vector keeps it at work without an end."""
    line = b"#593 = VECTOR('',#594,"
    assert line in DRAWN
    (tmp_path / "step_ring.step").write_bytes(DRAWN.replace(line + b"1.)", line + b"FOOT)"))
    assert "CPU time" in refusal(tmp_path)


def test_check_opens_the_drawing(tmp_path):
    (tmp_path / "step_ring.step").write_bytes(BROKEN)
    assert "drawing" in refusal(tmp_path)
