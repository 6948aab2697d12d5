"""Deviations, resultant fits and clearances, number by number as catalogues print them.

SKF: Rolling bearings (2018), section B.6, tables 11 to 21 "Shaft tolerances and resultant fits" and "Housing
tolerances and resultant fits" (F7 to H6: the same table of the catalogue of 2016). A line is over, up to and
including [mm], then two deviations [um] for each class; the line below it has the theoretical interference
(negative) and clearance (positive) with a bearing of Normal tolerances.
"""

from itertools import pairwise
from typing import get_args

import pytest
from hypothesis import given, strategies as st
from pytest import approx

from flexbearing.case.tolerances import (
    ClearanceClass,
    HousingClass,
    ShaftClass,
    Untabulated,
    deviations,
    housing_interference,
    initial_clearance,
    shaft_interference,
)

SHAFTS = {
    "f5 f6 g5 g6 h5": """
6 10 -13 -19 -13 -22 -5 -11 -5 -14 0 -6
+5 +19 +5 +22 -3 +11 -3 +14 -8 +6
10 18 -16 -24 -16 -27 -6 -14 -6 -17 0 -8
+8 +24 +8 +27 -2 +14 -2 +17 -8 +8
18 30 -20 -29 -20 -33 -7 -16 -7 -20 0 -9
+10 +29 +10 +33 -3 +16 -3 +20 -10 +9
30 50 -25 -36 -25 -41 -9 -20 -9 -25 0 -11
+13 +36 +13 +41 -3 +20 -3 +25 -12 +11
50 80 -30 -43 -30 -49 -10 -23 -10 -29 0 -13
+15 +43 +15 +49 -5 +23 -5 +29 -15 +13
80 120 -36 -51 -36 -58 -12 -27 -12 -34 0 -15
+16 +51 +16 +58 -8 +27 -8 +34 -20 +15
120 180 -43 -61 -43 -68 -14 -32 -14 -39 0 -18
+18 +61 +18 +68 -11 +32 -11 +39 -25 +18
180 250 -50 -70 -50 -79 -15 -35 -15 -44 0 -20
+20 +70 +20 +79 -15 +35 -15 +44 -30 +20
""",
}
FURTHER_SHAFTS = {  # whose fits follow from the same tolerances of the bearing
    "h6 j5 j6": """
6 10 0 -9 +4 -2 +7 -2
10 18 0 -11 +5 -3 +8 -3
18 30 0 -13 +5 -4 +9 -4
30 50 0 -16 +6 -5 +11 -5
50 80 0 -19 +6 -7 +12 -7
80 120 0 -22 +6 -9 +13 -9
120 180 0 -25 +7 -11 +14 -11
180 250 0 -29 +7 -13 +16 -13
""",
    "js5 js6 js7": """
6 10 +3 -3 +4.5 -4.5 +7.5 -7.5
10 18 +4 -4 +5.5 -5.5 +9 -9
18 30 +4.5 -4.5 +6.5 -6.5 +10.5 -10.5
30 50 +5.5 -5.5 +8 -8 +12.5 -12.5
50 80 +6.5 -6.5 +9.5 -9.5 +15 -15
80 120 +7.5 -7.5 +11 -11 +17.5 -17.5
120 180 +9 -9 +12.5 -12.5 +20 -20
""",
    "k5 k6 m5 m6 n5": """
6 10 +7 +1 +10 +1 +12 +6 +15 +6 +16 +10
10 18 +9 +1 +12 +1 +15 +7 +18 +7 +20 +12
18 30 +11 +2 +15 +2 +17 +8 +21 +8 +24 +15
30 50 +13 +2 +18 +2 +20 +9 +25 +9 +28 +17
50 80 +15 +2 +21 +2 +24 +11 +30 +11 +33 +20
80 120 +18 +3 +25 +3 +28 +13 +35 +13 +38 +23
120 180 +21 +3 +28 +3 +33 +15 +40 +15 +45 +27
180 250 +24 +4 +33 +4 +37 +17 +46 +17 +51 +31
""",
    "n6 p6 p7": """
50 80 +39 +20 +51 +32 +62 +32
80 120 +45 +23 +59 +37 +72 +37
120 180 +52 +27 +68 +43 +83 +43
180 250 +60 +31 +79 +50 +96 +50
""",
    "r6 r7": """
80 100 +73 +51 +86 +51
100 120 +76 +54 +89 +54
120 140 +88 +63 +103 +63
140 160 +90 +65 +105 +65
160 180 +93 +68 +108 +68
180 200 +106 +77 +123 +77
200 225 +109 +80 +126 +80
225 250 +113 +84 +130 +84
""",
}
# JIS B 0401 (1999), as Sumitomo prints it: the classes of small shafts that the catalogue leaves out.
SMALL_SHAFTS = {
    "n6 p6 r6": """
6 10 +19 +10 +24 +15 +28 +19
10 18 +23 +12 +29 +18 +34 +23
18 30 +28 +15 +35 +22 +41 +28
30 50 +33 +17 +42 +26 +50 +34
50 65 +39 +20 +51 +32 +60 +41
65 80 +39 +20 +51 +32 +62 +43
""",
    "js5 js6 js7": "180 250 +10 -10 +14.5 -14.5 +23 -23",
}
HOUSINGS = {
    "H7 H8 J6": """
6 10 0 +15 0 +22 -4 +5
0 +23 0 +30 -4 +13
10 18 0 +18 0 +27 -5 +6
0 +26 0 +35 -5 +14
18 30 0 +21 0 +33 -5 +8
0 +30 0 +42 -5 +17
30 50 0 +25 0 +39 -6 +10
0 +36 0 +50 -6 +21
50 80 0 +30 0 +46 -6 +13
0 +43 0 +59 -6 +26
80 120 0 +35 0 +54 -6 +16
0 +50 0 +69 -6 +31
120 150 0 +40 0 +63 -7 +18
0 +58 0 +81 -7 +36
150 180 0 +40 0 +63 -7 +18
0 +65 0 +88 -7 +43
180 250 0 +46 0 +72 -7 +22
0 +76 0 +102 -7 +52
250 315 0 +52 0 +81 -7 +25
0 +87 0 +116 -7 +60
""",
}
FURTHER_HOUSINGS = {  # whose fits follow from the same tolerances of the bearing
    "F7 G6 G7 H6": """
6 10 +13 +28 +5 +14 +5 +20 0 +9
10 18 +16 +34 +6 +17 +6 +24 0 +11
18 30 +20 +41 +7 +20 +7 +28 0 +13
30 50 +25 +50 +9 +25 +9 +34 0 +16
50 80 +30 +60 +10 +29 +10 +40 0 +19
80 120 +36 +71 +12 +34 +12 +47 0 +22
120 150 +43 +83 +14 +39 +14 +54 0 +25
150 180 +43 +83 +14 +39 +14 +54 0 +25
180 250 +50 +96 +15 +44 +15 +61 0 +29
""",
    "J7 JS6 JS7": """
6 10 -7 +8 -4.5 +4.5 -7.5 +7.5
10 18 -8 +10 -5.5 +5.5 -9 +9
18 30 -9 +12 -6.5 +6.5 -10.5 +10.5
30 50 -11 +14 -8 +8 -12.5 +12.5
50 80 -12 +18 -9.5 +9.5 -15 +15
80 120 -13 +22 -11 +11 -17.5 +17.5
120 150 -14 +26 -12.5 +12.5 -20 +20
150 180 -14 +26 -12.5 +12.5 -20 +20
180 250 -16 +30 -14.5 +14.5 -23 +23
""",
    "K6 K7 M6 M7": """
6 10 -7 +2 -10 +5 -12 -3 -15 0
10 18 -9 +2 -12 +6 -15 -4 -18 0
18 30 -11 +2 -15 +6 -17 -4 -21 0
30 50 -13 +3 -18 +7 -20 -4 -25 0
50 80 -15 +4 -21 +9 -24 -5 -30 0
80 120 -18 +4 -25 +10 -28 -6 -35 0
120 150 -21 +4 -28 +12 -33 -8 -40 0
150 180 -21 +4 -28 +12 -33 -8 -40 0
180 250 -24 +5 -33 +13 -37 -8 -46 0
""",
    "N6 N7 P6 P7": """
6 10 -16 -7 -19 -4 -21 -12 -24 -9
10 18 -20 -9 -23 -5 -26 -15 -29 -11
18 30 -24 -11 -28 -7 -31 -18 -35 -14
30 50 -28 -12 -33 -8 -37 -21 -42 -17
50 80 -33 -14 -39 -9 -45 -26 -51 -21
80 120 -38 -16 -45 -10 -52 -30 -59 -24
120 150 -45 -20 -52 -12 -61 -36 -68 -28
150 180 -45 -20 -52 -12 -61 -36 -68 -28
180 250 -51 -22 -60 -14 -70 -41 -79 -33
250 315 -57 -25 -66 -14 -79 -47 -88 -36
""",
}
# isofits 1.0 (PyPI, MIT licence), ISO 286-2: the steps over 250 mm that the excerpts of the catalogue lack.
LARGE_HOUSINGS = {
    "F7 G6 G7 H6 H7 H8": """
250 315 +56 +108 +17 +49 +17 +69 0 +32 0 +52 0 +81
315 400 +62 +119 +18 +54 +18 +75 0 +36 0 +57 0 +89
""",
    "J6 J7 JS6 JS7 K6 K7": """
250 315 -7 +25 -16 +36 -16 +16 -26 +26 -27 +5 -36 +16
315 400 -7 +29 -18 +39 -18 +18 -28.5 +28.5 -29 +7 -40 +17
""",
    "M6 M7 N6 N7 P6 P7": """
250 315 -41 -9 -52 0 -57 -25 -66 -14 -79 -47 -88 -36
315 400 -46 -10 -57 0 -62 -26 -73 -16 -87 -51 -98 -41
""",
}
# SKF, "Radial internal clearance of cylindrical roller bearings with a cylindrical bore"; AHR International
# prints the same. Over, up to and including [mm], then least and greatest [um] of C2, Normal, C3 and C4.
CLEARANCES = """
0 24 0 25 20 45 35 60 50 75
24 30 0 25 20 45 35 60 50 75
30 40 5 30 25 50 45 70 60 85
40 50 5 35 30 60 50 80 70 100
50 65 10 40 40 70 60 90 80 110
65 80 10 45 40 75 65 100 90 125
80 100 15 50 50 85 75 110 105 140
100 120 15 55 50 90 85 125 125 165
120 140 15 60 60 105 100 145 145 190
140 160 20 70 70 120 115 165 165 215
160 180 25 75 75 125 120 170 170 220
180 200 35 90 90 145 140 195 195 250
200 225 45 105 105 165 160 220 220 280
225 250 45 110 110 175 170 235 235 300
"""
LINE = 1e-9  # [m] beyond the border of a step


def lines(text: str) -> list[list[float]]:
    return [[float(number) for number in line.split()] for line in text.strip().splitlines()]


def printed(
    tables: dict[str, str], *, fits: bool = False
) -> list[tuple[str, float, float, list[float], list[float]]]:
    """Class, over, up to [mm], its two deviations and, with fits, the two limits of the fit [um]."""
    rows = []
    for names, text in tables.items():
        numbers = lines(text)
        pairs = zip(numbers[::2], numbers[1::2], strict=True) if fits else ((line, []) for line in numbers)
        for (over, upto, *limits), fit in pairs:
            for place, name in enumerate(names.split()):
                here = slice(2 * place, 2 * place + 2)
                rows.append((name, over, upto, limits[here], fit[here]))
    return rows


SHAFT_ROWS = printed(SHAFTS, fits=True) + printed(FURTHER_SHAFTS) + printed(SMALL_SHAFTS)
HOUSING_ROWS = printed(HOUSINGS, fits=True) + printed(FURTHER_HOUSINGS) + printed(LARGE_HOUSINGS)


def diameters(over: float, upto: float) -> list[float]:
    """Just over the lower limit of a step, within it, and its upper limit, which belongs to it [m]."""
    return [over * 1e-3 + LINE, (over + upto) / 2 * 1e-3, upto * 1e-3]


def by_diameter(rows):
    """The rows of a table, each at three diameters."""
    for name, over, upto, limits, fit in rows:
        yield from ((name, diameter, limits, fit) for diameter in diameters(over, upto))


def test_shafts_and_their_fits_are_those_printed():
    for name, diameter, limits, fit in by_diameter(SHAFT_ROWS):
        band = deviations(name, diameter)
        assert [band.greatest * 1e6, band.least * 1e6] == approx(limits, rel=0, abs=1e-9), (name, diameter)
        if fit:
            tight = shaft_interference(name, diameter)
            assert [-tight.greatest * 1e6, -tight.least * 1e6] == approx(fit, rel=0, abs=1e-9), (
                name,
                diameter,
            )


def test_housings_and_their_fits_are_those_printed():
    for name, diameter, limits, fit in by_diameter(HOUSING_ROWS):
        band = deviations(name, diameter)
        assert [band.least * 1e6, band.greatest * 1e6] == approx(limits, rel=0, abs=1e-9), (name, diameter)
        if fit:
            tight = housing_interference(name, diameter)
            assert [-tight.greatest * 1e6, -tight.least * 1e6] == approx(fit, rel=0, abs=1e-9), (
                name,
                diameter,
            )


BALL_CLEARANCES = """
6 10 0 7 2 13 8 23 14 29
10 18 0 9 3 18 11 25 18 33
18 24 0 10 5 20 13 28 20 36
24 30 1 11 5 20 13 28 23 41
30 40 1 11 6 20 15 33 28 46
40 50 1 11 6 23 18 36 30 51
50 65 1 15 8 28 23 43 38 61
65 80 1 15 10 30 25 51 46 71
80 100 1 18 12 36 30 58 53 84
100 120 2 20 15 41 36 66 61 97
120 140 2 23 18 48 41 81 71 114
140 160 2 23 18 53 46 91 81 130
160 180 2 25 20 61 53 102 91 147
180 200 2 30 25 71 63 117 107 163
200 225 2 35 25 85 75 140 125 195
225 250 2 40 30 95 85 160 145 225
"""  # deep groove ball bearings: NTN, Ball and Roller Bearings, pages
PRINTED = [
    (of, over, upto, row)
    for of, table in (("cylindrical rollers", CLEARANCES), ("deep groove balls", BALL_CLEARANCES))
    for over, upto, *row in lines(table)
]


@pytest.mark.parametrize(("of", "over", "upto", "limits"), PRINTED)
def test_clearances_are_those_printed(of, over, upto, limits):
    for diameter in diameters(max(over, 6.0), upto):
        bands = [initial_clearance(name, diameter, of) for name in get_args(ClearanceClass)]
        found = [1e6 * limit for band in bands for limit in (band.least, band.greatest)]
        assert found == approx(limits, rel=0, abs=1e-9)


@pytest.mark.parametrize(
    ("classes", "rows", "largest"),
    [(get_args(ShaftClass), SHAFT_ROWS, 250), (get_args(HousingClass), HOUSING_ROWS, 400)],
    ids=["shafts", "housings"],
)
def test_every_class_is_printed_without_a_gap_up_to_its_largest_size(classes, rows, largest):
    assert {name for name, *_ in rows} == set(classes)
    for name in classes:
        steps = sorted({(over, upto) for each, over, upto, *_ in rows if each == name})
        assert all(upto >= over for (_, upto), (over, _) in pairwise(steps))
        assert steps[-1][1] == largest
        with pytest.raises(Untabulated):
            deviations(name, steps[0][0] * 1e-3)
        with pytest.raises(Untabulated):
            deviations(name, steps[-1][1] * 1e-3 + LINE)


SIZES = st.floats(6.001e-3, 250e-3)
ELEMENTS = st.sampled_from(["cylindrical rollers", "deep groove balls"])


@given(SIZES, st.sampled_from(get_args(ShaftClass)))
def test_mean_lies_between_the_limits_of_a_shaft(bore, name):
    if name in ("p7", "r7") and bore <= 81e-3:
        return
    band = shaft_interference(name, bore)
    assert band.least < band.mean < band.greatest
    assert (band.tight("loosest"), band.tight("tightest")) == (band.least, band.greatest)
    assert band.tight("mean") == band.mean


@given(SIZES, st.sampled_from(get_args(HousingClass)))
def test_mean_lies_between_the_limits_of_a_housing(outside, name):
    band = housing_interference(name, outside)
    assert band.least < band.mean < band.greatest


@given(SIZES, ELEMENTS)
def test_classes_of_clearance_are_ordered_and_the_loosest_is_the_widest(bore, of):
    bands = [initial_clearance(name, bore, of) for name in ("C2", "CN", "C3", "C4")]
    for smaller, larger in pairwise(bands):
        assert smaller.least < larger.least
        assert smaller.mean < larger.mean
        assert smaller.greatest < larger.greatest
        assert larger.least <= smaller.greatest  # neighbours overlap, or no bearing could be between
    assert bands[0].open("tightest") <= bands[0].open("mean") <= bands[0].open("loosest")


@given(SIZES, SIZES, st.sampled_from(get_args(ClearanceClass)), ELEMENTS)
def test_larger_bores_have_no_less_clearance(one, other, name, of):
    small, large = sorted((one, other))
    few, many = initial_clearance(name, small, of), initial_clearance(name, large, of)
    assert few.least <= many.least
    assert few.greatest <= many.greatest


def test_a_diameter_summed_with_rounding_belongs_to_its_step():
    rounded = 0.1 + 0.02 + 1e-17 + 2**-56
    assert rounded > 0.12  # in binary digits
    assert deviations("k5", rounded) == deviations("k5", 0.12)
