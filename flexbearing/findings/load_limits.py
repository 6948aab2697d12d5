"""Limits of loads, pressures and stresses."""

from dataclasses import replace

from flexbearing.findings.finding import DANGER, OUTSIDE, USUAL, Finding

BARS = "squirrel-cage bars (nominal)"  # place of their stress

CONTACT_PRESSURE = Finding(
    code="contact-pressure", label="peak contact pressure", quantity="contact_pressure",
    at_most=1.0, times="static_pressure", grade=DANGER, source="ISO 76", unit="Pa", shown="MPa",
    meaning="dents raceways of bearing steel, and elastic contact laws end there",
    action="take a larger bearing, more rolling elements, less tilt or a lower peak load",
)  # fmt: skip
STATIC_SAFETY = Finding(
    code="static-safety", label="static safety C_0/P_0", quantity="static_safety",
    at_least=1.0, grade=DANGER, source="ISO 76",
    meaning="the load is above the static rating, which dents raceways",
    action="take a larger bearing, more rolling elements or a lower peak load",
)  # fmt: skip
USUAL_STATIC_SAFETY = Finding(
    code="static-safety", label="static safety C_0/P_0", quantity="static_safety",
    at_least=1.5, grade=USUAL, source="SKF, Rolling bearings (2018), normal running; ISO 76 requires 1",
    meaning="less than is usual in normal running; twice as much where it must run quietly or has shocks",
    action="take a larger bearing, or a reason for a lower static safety",
)  # fmt: skip
YIELD_STRESS = Finding(
    code="yield-stress", label="largest stress", quantity="stress",
    at_most=1.0, times="yield_stress", grade=DANGER, source="yield stress", unit="Pa", shown="MPa",
    meaning="the part is deformed plastically",
    action="take a thicker part, stronger material or a lower load",
)  # fmt: skip
HEAVY_LOAD = Finding(
    code="heavy-load", label="equivalent load P", quantity="load",
    at_most=0.5, times="dynamic_rating", grade=OUTSIDE, source="half of C_r, ISO 281 (2007)",
    unit="N", shown="kN",
    meaning="life formulas hold up to there, ISO 281 leaves loads beyond to the maker",
    action="take a bearing with a rating {share:.3g} times as large, or a load as much lower",
)  # fmt: skip
LOAD_ABOVE_STATIC_RATING = replace(
    HEAVY_LOAD, at_most=1.0, times="static_rating", source="C_0, ISO 281 (2007)"
)

RATING_ABOVE_FORMULA = Finding(
    code="rating-above-formula", label="given rating over that of the formula", quantity="rating_ratio",
    at_most=1.15, grade=USUAL, source="usual between makers and ISO 281, ISO 76; assumed",
    meaning="one of both may be of another bearing or of two rows, or the rolling elements not the maker's",
    action="check the rating, and the number and size of the rolling elements",
    of_model=True,
)  # fmt: skip
RATING_BELOW_FORMULA = replace(
    RATING_ABOVE_FORMULA,
    code="rating-below-formula",
    label="share of a given rating in that of the formula",
    at_most=None,
    at_least=1 / 1.15,
)
CHANGED_RATING = Finding(
    code="changed-rating", label="how many times larger or smaller a given rating became",
    quantity="rating_change", at_most=2.0, grade=OUTSIDE, source="limit of this program, assumed",
    meaning="the case is far from the bearing that the maker rated",
    action="give the rating of such a bearing",
    of_model=True,
)  # fmt: skip
RATINGS = (RATING_ABOVE_FORMULA, RATING_BELOW_FORMULA, CHANGED_RATING)


_SKF = "rule of thumb of SKF, Rolling bearings (2018)"
LIGHT_LOAD_OF_ROLLERS = Finding(
    code="light-load", label="minimum load", quantity="load", at_least=0.02, times="dynamic_rating",
    grade=USUAL, source=f"0.02 C_r, {_SKF}",
    unit="N", shown="kN", meaning="rolling elements may skid; which slip does damage is not computed",
    action="preload the bearing, take a smaller one, or see that it carries load before it turns fast",
)  # fmt: skip
LIGHT_LOAD_OF_BALLS = replace(LIGHT_LOAD_OF_ROLLERS, at_least=0.01, source=f"0.01 C_r, {_SKF}")

_SKF_RIBS = "SKF, web catalogue, single row cylindrical roller bearings"
AXIAL_SHARE = Finding(
    code="axial-load", label="axial load beside the radial load", quantity="axial_load", at_most=0.5,
    times="radial_load", grade=DANGER, unit="N", shown="kN",
    source=f"half of the radial load, rule of a maker: {_SKF_RIBS}",
    meaning="too few rollers are pressed enough to hold the couple of their ribs; the others tilt and skew",
    action="lower the axial load, or take a bearing with inclined raceways to locate the shaft",
)  # fmt: skip
RIB_STRENGTH = Finding(
    code="rib-strength", label="axial load, strength of the ribs", quantity="axial_load", at_most=1.0,
    times="rib_strength", grade=DANGER, unit="N", shown="kN",
    source=f"0.0023 D^1.7 in kN and mm, rule of a maker: {_SKF_RIBS}",
    meaning="a load that acts all the time may damage ribs",
    action="take a larger bearing or a lower axial load",
)  # fmt: skip
RIB_STRENGTH_OF_SERIES_2 = replace(
    RIB_STRENGTH,
    times="rib_strength_of_series_2",
    grade=USUAL,
    source=f"0.0045 D^1.5 in kN and mm for series 2, rule of a maker: {_SKF_RIBS}",
)
RIB_HEAT = Finding(
    code="rib-heat", label="axial load, heat of the ribs", quantity="axial_load", at_most=1.0,
    times="warm_rib_load", grade=USUAL, unit="N", shown="kN",
    source=f"k_1 C_0 10^4/(n (d + D)) - k_2 F_r with oil, rule of a maker: {_SKF_RIBS}",
    meaning="friction of the ribs heats the bearing beyond 60 K above its surroundings unless oil cools it",
    action="cool the bearing by circulating oil, or lower axial load or speed",
)  # fmt: skip
RIBS = (AXIAL_SHARE, RIB_STRENGTH, RIB_STRENGTH_OF_SERIES_2, RIB_HEAT)
