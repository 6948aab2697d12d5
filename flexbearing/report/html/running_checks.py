"""Films, clearance, slopes and dimensions against their limits."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from flexbearing.report.html import clearance, oil, ratings
from flexbearing.report.html.check import (
    AIM,
    BUILD,
    CANNOT_BE_BUILT,
    DAMAGE,
    LEAST,
    MOST,
    Check,
    Limit,
    against,
    unchecked,
)
from flexbearing.report.html.raceway_tilt import USUAL_TILT, between_raceways
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

FULL_FILM = 3  # film ratio
DEEP_GROOVE = "deep_groove_ball"
_USUAL_TILT = "4 arcmin, rule of thumb: the edge stress of ISO/TS 16281 holds below; the maker's limit counts"
_COUNT_OIL = 'set life.lubrication = "a_ISO" for a life that counts oil and cleanliness'
_THICKER = (
    "take an oil {:.2g} times as viscous at its temperature for a viscosity ratio of 1, or cool it as far as "
    "the table of oil temperatures says{}; else use EP/AW additives"
)
_CAGE_SIZES = ("land_diameter", "thickness")  # keys of the cage that may let it overlap
_NOTED = {  # what, by the code of a note: limit, verdict, grade, what to do, who checks it
    "overlapping-dimensions": (
        "Dimensions of the cage", "no overlap",
        f"{CANNOT_BE_BUILT}: {{}}; loads and life do not depend on it, drag and friction of the cage do",
        BUILD, "correct the dimensions of the cage or of the ribs, which overlap", "",
    ),
    "truncated-contact": (
        "Contacts on the shoulders of races", "not cut off", "EXCEEDED: see the danger", DAMAGE, "", "",
    ),
    "shoulder-not-given": (
        "Contacts on the shoulders of races", "not cut off",
        "not checked: the height of the shoulders is not given, usual ones would cut contacts off",
        DAMAGE, "", "designer, with the height of the shoulders",
    ),
}  # fmt: skip


def checks(reader: Reader) -> Iterator[Check]:
    """Viscosity ratio, films, spin, clearance, slopes, what the run itself compared."""
    yield from _film_ratio(reader)
    yield from _viscosity_ratio(reader)
    yield from _spin(reader)
    yield from _clearance(reader)
    yield from _noted(reader)
    yield from _slope(reader)


def _viscosity_ratio(reader: Reader) -> Iterator[Check]:
    found = ratings.viscosity_ratio(reader)
    what, words = "Viscosity ratio κ", "at least 1 (usual; ISO 281 rates from 0.1)"
    if found is not None:
        value = reader.units.number(found[0], "", "", ".3g", found[1])
        check = against(reader, what, value, found[0], Limit(1.0, LEAST, words, AIM))
        counted = (reader.attributes["case_si"].get("life") or {}).get("lubrication")
        do = "" if counted else _COUNT_OIL
        if check.broken:
            enough, _ = oil.sufficient_at(reader)
            do = _THICKER.format(1 / found[0], "" if enough is None else oil.heated(reader, enough))
        yield replace(check, do=do)
    elif not isinstance(ratings.found(reader), str):
        how = 'life.lubrication = "a_ISO"'
        do = f"set {how} for the viscosity ratio and a life with oil and cleanliness"
        who = "oil supplier: viscosity at the temperature of the inlets"
        yield unchecked(what, f"{how} computes it", who, do=do)


def _film_ratio(reader: Reader) -> Iterator[Check]:
    found = reader.summary[reader.last].get("minimum_lambda")
    regimes = (reader.attributes.get("regimes") or {}).get(reader.last, {})
    words = f"at least 1, full film from {FULL_FILM}"
    for race in ("inner", "outer") if found else ():
        path = f"summary/{reader.last}/minimum_lambda/{race}"
        value = reader.units.number(found[race], "", "", ".2f", path)
        what = f"Smallest film ratio Λ, {race} raceway"
        check = against(reader, what, value, found[race], Limit(1.0, LEAST, words, AIM))
        told = f"{check.verdict}: {regimes[race]}" if race in regimes else check.verdict
        yield replace(check, verdict=told)
    if not found:
        films = "minimum_film_um" in reader.summary[reader.last]
        why = "no roughness given (bearing.roughness)" if films else "no film is computed for this kind"
        do = "give bearing.roughness for the film ratio" if films else ""
        who = "bearing maker: roughness of raceways and rolling elements"
        yield unchecked("Smallest film ratio Λ", why, who, do=do)


def _spin(reader: Reader) -> Iterator[Check]:
    """Friction that holds the gyroscopic moments of fast balls."""
    case, needed = reader.attributes["case_si"], reader.summary[reader.last].get("needed_friction")
    if not needed or not any(needed.values()) or case["operation"].get("control") == "coulomb":
        return
    limit, race = case["friction"]["coefficient"], max(needed, key=lambda race: needed[race] or 0.0)
    path = f"summary/{reader.last}/needed_friction/{race}"
    value = reader.units.number(needed[race], "", "", ".3g", path)
    words = f"at most {limit:g} (friction.coefficient)"
    what = "Friction needed to hold the gyroscopic moments"
    yield against(reader, what, value, needed[race], Limit(limit, MOST, words))


def _clearance(reader: Reader) -> Iterator[Check]:
    """Clearance of bearings that are not adjusted axially, with the tight end of its tolerances."""
    found = reader.attributes.get("clearance") or {}
    radial = reader.of_rollers or reader.attributes["kind"] == DEEP_GROOVE
    if not radial or found.get("operating_m") is None:
        return
    verdict = "met"
    if "ends" in (found.get("tolerances") or {}):
        least = reader.of_attribute("clearance/tolerances/ends/tightest_m", "m", "um", ".1f")
        words = f"{least.text} {printed(least.unit)} at the tight end of the tolerances"
        preload = found["tolerances"]["ends"]["tightest_m"] < 0
        warmer = clearance.warmth(reader, clearance.TIGHT)
        taken = "" if warmer is None else f", which an inner ring {warmer} K warmer takes"
        verdict = f"met as computed, preload: {words}" if preload else f"met, {words}{taken}"
    if found["operating_m"] < 0:
        verdict = "preload: see Clearance"
    value = reader.of_attribute("clearance/operating_m", "m", "um", ".3g")
    yield Check(f"Diametral {reader.clearance_words}", value, "at least 0", verdict=verdict)


def _noted(reader: Reader) -> Iterator[Check]:
    """Limits that the run itself compared, by the codes of its notes."""
    for code in dict.fromkeys(note["code"] for note in reader.attributes["notes"]):
        if code in _NOTED:
            what, limit, verdict, grade, do, who = _NOTED[code]
            told = verdict.format(overlap(reader))
            yield Check(what, "", limit, verdict=told, grade=grade, do=do, who=who)


def overlap(reader: Reader) -> str:
    """Which dimensions overlap, and those of the cage that are assumed; empty where none do."""
    told = [note["text"] for note in reader.attributes["notes"] if note["code"] == "overlapping-dimensions"]
    if not told:
        return ""
    sizes = told[0].partition(": ")[2].partition(": ")[0]
    keys = [f"bearing.cage.{name}" for name in _CAGE_SIZES]
    assumed = [key for key in keys if key in reader.attributes["assumed"]]
    return sizes + (f"; assumed: {', '.join(assumed)}" if assumed else "")


def _slope(reader: Reader) -> Iterator[Check]:
    """Slope between the raceways of rollers."""
    found = between_raceways(reader)
    if found and np.any(reader.blocks[reader.last]["ring_tilt"]):
        what, limit = "Slope between the raceways at the most loaded roller", 1e3 * USUAL_TILT
        words = f"at most {limit:.3g} ({_USUAL_TILT})"
        yield against(reader, what, *found, Limit(USUAL_TILT, MOST, words, AIM))
