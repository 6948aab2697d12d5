"""A bearing family is one record: a toy, registered in one line, is read, checked, run and shown."""

import json
from typing import Literal

import numpy as np
import pytest

import flexbearing
from flexbearing import api
from flexbearing.__main__ import command
from flexbearing.case import BadCase
from flexbearing.case.family import Family
from flexbearing.case.head import KIND, Head
from flexbearing.case.quantity import Force, Length, Section, key
from flexbearing.families import FAMILIES
from flexbearing.quantities import Quantity, SummaryValue
from flexbearing.quantities.layout import Layout
from flexbearing.quantities.units import MPA
from flexbearing.report.card import of_result as card_of
from flexbearing.report.family_report import FamilyReport
from flexbearing.report.html import html, of_result
from flexbearing.report.output import text, write_figures
from quasidynamic import ImpossiblePart


class Bushing(Section):
    """The bushing."""

    diameter: Length = key("bore", gt=0)
    width: Length = key("axial width", gt=0)


class ToyCase(Head):
    """A plain bushing under a load."""

    kind: Literal["bushing"] = key(KIND)
    bushing: Bushing = key("the bushing")
    load: Force = key("radial load", ge=0)


def build(case):
    if case.bushing.width > 10 * case.bushing.diameter:
        raise ImpossiblePart("a bushing this long is a pipe")


def solve(case, file, report):
    report.stage("the bushing", None)
    file.block("rigid", {"pressure": case.load / (case.bushing.diameter * case.bushing.width)})
    return {
        "status": "converged",
        "ending": "converged",
        "message": "one division",
        "iterations": 0,
        "notes": [],
    }


PRESSURE = Quantity(
    "pressure",
    "p",
    "",
    "Pa",
    "block",
    "load over projected area",
    people=MPA,
    summary=(SummaryValue("pressure_MPa", label="pressure", digits=".1f"),),
)


TOY = Family(
    kind="bushing",
    case=lambda: ToyCase,
    build=lambda: build,
    opening=lambda: lambda case: {},
    solve=lambda: solve,
    layout=lambda: Layout(
        conventions="No axes.\n",
        quantities=(PRESSURE,),
        blocks=("rigid",),
    ),
    report=lambda: FamilyReport(lambda: lambda result: {}, lambda: lambda words: iter(())),
    card=lambda: card_of,
)
FILE = """
kind = "bushing"
title = "a toy"
load = "2 kN"

[bushing]
diameter = "20 mm"
width = "10 mm"
"""


@pytest.fixture
def file(tmp_path, monkeypatch):
    monkeypatch.setitem(FAMILIES, TOY.kind, TOY)  # the registry line
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "toy.toml"
    path.write_text(FILE)
    return path


def test_new_family_is_read_checked_run_and_shown(file):
    assert api.read_case(file, ["load=3 kN"]).load == 3000.0
    assert flexbearing.api.check(file).bushing.width == 0.01
    result = flexbearing.run(file, output="toy.h5")
    assert result.attributes["status"] == "converged"
    assert flexbearing.read(result.path).rigid["pressure"] == pytest.approx(1e7, rel=1e-15)
    assert result.summary()["rigid"] == {"pressure_MPa": pytest.approx(10.0, rel=1e-12)}
    assert "a toy" in html(of_result(result))
    assert "pressure 10.0 MPa" in " ".join(text(result).split())
    assert write_figures(result, file.parent) == []


def test_new_family_is_explained_and_named_where_keys_are_refused(file):
    assert "bore" in flexbearing.explain("bushing.diameter")
    assert '"bushing"' in flexbearing.explain("kind")
    with pytest.raises(BadCase, match=r"Did you mean width"):
        flexbearing.api.read_case(file, ["bushing.widthh=1 mm"])
    with pytest.raises(BadCase, match='belongs to kind = "cylindrical_roller"'):
        flexbearing.api.read_case(file, ["bearing.rollers=5"])
    with pytest.raises(BadCase, match="is a pipe"):
        flexbearing.api.check(file, ["bushing.width=1 m"])
    with pytest.raises(BadCase, match="starts from no other result"):
        flexbearing.run(file, start=flexbearing.run(file))


def test_command_line_knows_a_new_family(file, capsys):
    for words in (["check", file], ["run", file, "-o", "out.h5"]):
        assert command([str(word) for word in words]) == 0
    assert "a toy\nusable     Yes, as far as checked\n" in capsys.readouterr().out
    assert command(["summary", "--json", "out.h5"]) == 0
    block = json.loads(capsys.readouterr().out)["rigid"]
    assert block["pressure_MPa"] == pytest.approx(np.float64(10.0), rel=1e-12)
