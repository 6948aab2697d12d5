"""Loads, contact pressures and stresses against their limits."""

from collections.abc import Iterator
from dataclasses import replace

from flexbearing.report.html import ratings
from flexbearing.report.html.check import AIM, LEAST, MOST, VALIDITY, Check, Limit, against, unchecked
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

DENTING, DENTING_OF_BALLS = 4000.0, 4200.0  # [MPa] static limits of roller and ball bearings by ISO 76
USUAL_OF_ROLLERS = 1.5  # static safety in normal running, SKF
LEAST_OF_ROLLERS, LEAST_OF_BALLS = 0.02, 0.01  # P/C_r in SKF's rule of thumb against smearing
ENDS = {"pressed-end", "sharp-roller-end", "sliced-peak"}  # notes by which slices do not have the peak
BARS = "Nominal stress of the bars"
_MAKER = "life not assured, ISO 281 leaves to the maker whether its formula holds"
_YIELD = "yield_stress of the part is not given in [materials], and a case has no fatigue limit"
_OF_BARS = (
    "N/A + M/W of a bar where it meets ring and flange, without the stress concentration there; the von "
    "Mises stress of the bars leaves out these places, so it may be lower"
)
_ANALYST = "stress analyst, with yield and fatigue strength of the material"
_ANALYST_OF_BARS = f"{_ANALYST}, times the stress concentration factor of the fillet"
_ENDS = 'set bearing.contact = "half_space" for the peak pressure at the ends of the rollers'
_GIVE_YIELD = "give yield_stress of [materials] for the parts whose stress has no limit here"


def checks(reader: Reader) -> Iterator[Check]:
    """Pressures, static safeties, loads, stresses."""
    yield from _pressures(reader)
    yield from _static(reader)
    yield from _load(reader)
    yield from _stresses(reader)


def _pressures(reader: Reader) -> Iterator[Check]:
    limit = DENTING_OF_BALLS if reader.attributes["kind"].endswith("ball") else DENTING
    text = reader.units.number(limit, "MPa", "MPa", ",.0f", "").text
    ends = ENDS & {note["code"] for note in reader.attributes["notes"]}
    for race, number in (reader.summary[reader.last].get("peak_pressure_MPa") or {}).items():
        path = f"summary/{reader.last}/peak_pressure_MPa/{race}"
        value = reader.units.number(number, "MPa", "MPa", ",.0f", path)
        what = f"Peak contact pressure, {race} raceway"
        check = against(reader, what, value, number, Limit(limit, MOST, f"at most {text} (ISO 76)"))
        if ends and check.verdict == "met":
            words = "met by slices, not checked at the ends"
            check = replace(check, verdict=words, do=_ENDS)
        yield check


def _static(reader: Reader) -> Iterator[Check]:
    """Static safety, where the bearing has one."""
    number = reader.summary[reader.last].get("static_safety")
    if number is not None:
        path = f"summary/{reader.last}/static_safety"
        value = reader.units.number(number, "", "", ",.2f", path)
        usual = reader.of_rollers and number >= 1  # which is an aim
        aim = f"at least {USUAL_OF_ROLLERS:g} (usual, SKF; the limit of ISO 76 is 1)"
        limit = (
            Limit(USUAL_OF_ROLLERS, LEAST, aim, AIM) if usual else Limit(1.0, LEAST, "at least 1 (ISO 76)")
        )
        check = against(reader, "Static safety C_0/P_0", value, number, limit)
        yield replace(check, damaging=1 / number) if usual else check
    known = reader.summary[reader.last].get("pressure_safety") or {}
    found = {race: each for race, each in known.items() if each is not None}
    if found:
        race = min(found, key=found.__getitem__)
        path = f"summary/{reader.last}/pressure_safety/{race}"
        value = reader.units.number(found[race], "", "", ",.2f", path)
        what = f"Static safety by pressure, {race} raceway"
        yield against(reader, what, value, found[race], Limit(1.0, LEAST, "at least 1 (ISO 76)"))


def _load(reader: Reader) -> Iterator[Check]:
    """Equivalent load against what ISO 281 holds for, and against the least."""
    found = ratings.found(reader)
    if isinstance(found, str):
        who = "designer, with the maker's ratings of this bearing"
        yield unchecked("Equivalent load and minimum load", found.rstrip("."), who)
        return
    rated, at = found
    load, rating, path = rated["load_N"], rated["ratings_N"]["C_r"], f"{at}/load_N"
    balls = "equivalent_load" in rated
    limits = {"C_r/2": rating / 2} | ({"C_0": rated["ratings_N"]["C_0r"]} if balls else {})
    value = reader.units.number(load, "N", "kN", ",.4g", path)

    def kilonewtons(force: float) -> str:
        return reader.units.number(force, "N", "kN", ",.4g", "").text

    for name, limit in limits.items():
        what, words = f"Equivalent load P against {name}", f"at most {kilonewtons(limit)} (ISO 281)"
        check = against(reader, what, value, load, Limit(limit, MOST, words, VALIDITY))
        told, do = check.verdict, ""
        if check.broken:
            unit = printed(value.unit)
            told += f": {_MAKER}"
            if name == "C_r/2":
                needed, most = (f"{kilonewtons(force)} {unit}" for force in (2 * load, limit))
                do = f"take a bearing with C_r of at least {needed}, or a load P of at most {most}"
        yield replace(check, verdict=told, do=do)
    share = LEAST_OF_BALLS if balls else LEAST_OF_ROLLERS
    words = f"at least {kilonewtons(share * rating)} ({share:g} C_r, rule of thumb of SKF)"
    what = "Minimum load, against slip and smearing"
    yield against(reader, what, value, load, Limit(share * rating, LEAST, words, AIM))


def _stresses(reader: Reader) -> Iterator[Check]:
    parts = reader.attributes.get("stresses") or {}
    for part, found in parts.items():
        for body, most in found["bodies"].items():
            path = f"attributes/stresses/{part}/bodies/{body}/von_mises_MPa"
            limit, what = yield_stress(reader, part, body), f"Von Mises stress, {part}: {body}"
            yield _against_yield(reader, what, most["von_mises_MPa"], limit, path)
    nominal = reader.summary[reader.last].get("nominal_bar_stress_MPa")
    if nominal is not None:
        path = f"summary/{reader.last}/nominal_bar_stress_MPa"
        limit = yield_stress(reader, "outer", "bars")
        check = _against_yield(reader, BARS, nominal, limit, path)
        who = _ANALYST_OF_BARS if check.unchecked else ""
        yield replace(check, verdict=f"{check.verdict}; {_OF_BARS}", who=who)
    if not parts and "flexible" in reader.blocks:
        yield _not_stressed(reader)


def _not_stressed(reader: Reader) -> Check:
    """That no stress of the rings was computed, and what computes it."""
    what, how = "Stress of the flexible rings", "outputs.stresses = true"
    if "stresses" not in {each.name for each in reader.layout.further_attributes}:
        return unchecked(what, "not computed for this kind", _ANALYST)
    do = f"set {how} for the stress of the flexible rings"
    return unchecked(what, f"{how} computes it", _ANALYST, do=do)


def _against_yield(reader: Reader, what: str, stress: float, limit: float | None, path: str) -> Check:
    """A stress [MPa] against the yield stress of a material [Pa]; where none is given, that is said."""
    value = reader.units.number(stress, "MPa", "MPa", ",.0f", path)
    if limit is None:
        return replace(unchecked(what, _YIELD, _ANALYST, value, _GIVE_YIELD), urgent=True)
    words = f"at most {reader.units.number(limit, 'Pa', 'MPa', ',.0f', '').text} (yield)"
    return against(reader, what, value, stress, Limit(limit / 1e6, MOST, words))


def yield_stress(reader: Reader, part: str, body: str) -> float | None:
    """Yield stress [Pa] of a body by its name, else of the ring of its part; None where it is not given."""
    materials = reader.attributes["case_si"].get("materials", {})
    named = "shaft" if "shaft" in body else "housing" if "housing" in body else f"{part}_ring"
    return (materials.get(named) or {}).get("yield_stress")
