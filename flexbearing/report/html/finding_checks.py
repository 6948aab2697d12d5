"""The findings of a result as checks, and limits that have no finding."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from flexbearing.findings import DANGER, NOT_CHECKED, NOT_MET, gravest, of_code
from flexbearing.findings.codes import PEAK_AT_ENDS
from flexbearing.findings.running import CLEARANCE
from flexbearing.findings.strength import BARS
from flexbearing.report.html import ratings
from flexbearing.report.html.check import BROKEN, Check, text_of, unchecked
from flexbearing.report.html.reader import Reader

_ANALYST = "stress analyst, with yield and fatigue strength of the material"
_NO_YIELD = "yield_stress of the part is not given in [materials], and a case has no fatigue limit"
_GIVE_YIELD = "give yield_stress of [materials] for the parts whose stress has no limit here"
_OF_BARS = (
    "N/A + M/W of a bar where it meets ring and flange, without the stress concentration there; the von "
    "Mises stress of the bars leaves out these places, so it may be lower"
)
_ENDS = 'set bearing.contact = "half_space" for the peak pressure at the ends of the rollers'
_GIVE_OIL = "give the oil in [lubricant] for the viscosity ratio and a life with oil and cleanliness"
_COUNT_OIL = 'set life.lubrication = "a_ISO" for a life that counts oil and cleanliness'


def checks(reader: Reader) -> Iterator[Check]:
    """A check for every finding; of one code and place, of that to act on first."""
    groups: dict[tuple[str, str], list[dict[str, Any]]] = {}
    for number, record in enumerate(reader.attributes.get("findings") or ()):
        numbered = {**record, "at": f"findings/{number}"}
        if of_code(record["code"], record["grade"]).of_model and record["verdict"] != NOT_MET:
            continue
        groups.setdefault((record["code"], record["place"]), []).append(numbered)
    for records in groups.values():
        yield _explained(reader, records[0]["code"], _check(reader, records))
    yield from _without(reader, {code for code, _ in groups})


def verdict(reader: Reader, code: str) -> str:
    """Whether the limit of a code is kept; empty where nothing was judged by it."""
    found = [record for record in reader.attributes.get("findings") or () if record["code"] == code]
    return str(gravest(found)["verdict"]) if found else ""


def _check(reader: Reader, records: list[dict[str, Any]]) -> Check:
    """The finding to act on first, among those of one code at one place."""
    record = gravest(records)
    finding, at = of_code(record["code"], record["grade"]), record["at"]
    what = ", ".join(filter(None, (finding.label[0].upper() + finding.label[1:], record["place"])))
    value = reader.of_attribute(f"{at}/value", finding.unit, finding.shown, ",.4g")
    if record["verdict"] == NOT_CHECKED:
        return Check(what, value, place=record["place"])
    limit = reader.of_attribute(f"{at}/limit", finding.unit, finding.shown, ",.4g")
    broken, used = record["verdict"] == NOT_MET, record["share"] or 0.0
    return Check(
        what,
        value,
        f"{record['side']} {text_of(limit)} ({record['source']})",
        "" if record["share"] is None else reader.of_attribute(f"{at}/share", "", "%", ",.0f"),
        used,
        BROKEN[record["grade"], record["side"]] if broken else record["verdict"],
        record["grade"],
        record["side"],
        record["place"],
        do=finding.action.format(share=used) if broken else "",
        damaging=next((each["share"] or 0.0 for each in records if each["grade"] == DANGER), 0.0),
    )


def _explained(reader: Reader, code: str, check: Check) -> Check:
    """A check with what its verdict leaves open."""
    if code == "contact-pressure" and not check.broken and PEAK_AT_ENDS & reader.codes:
        return replace(check, verdict="met by slices, not checked at the ends", do=_ENDS)
    if code == "yield-stress":
        of_bars = check.place == BARS
        words = f"; {_OF_BARS}" * of_bars
        if not check.unchecked:
            return replace(check, verdict=f"{check.verdict}{words}")
        why = f"{NOT_CHECKED}: {_NO_YIELD}{words}"
        who = _ANALYST + ", times the stress concentration factor of the fillet" * of_bars
        return replace(check, verdict=why, who=who, do=_GIVE_YIELD, urgent=True)
    if code == CLEARANCE.code and check.broken:  # may be intended
        return replace(check, verdict="preload: see Clearance", do="")
    if code == "film-ratio":
        regime = _regimes(reader).get(check.place.partition(" ")[0], "")
        return replace(check, verdict=": ".join(filter(None, (check.verdict, regime))))
    counted = (reader.attributes["case_si"].get("life") or {}).get("lubrication")
    if code == "viscosity-ratio" and not (check.broken or counted):
        return replace(check, do=_COUNT_OIL)
    return check


def _regimes(reader: Reader) -> dict[str, str]:
    return (reader.attributes.get("regimes") or {}).get(reader.last, {})


def _without(reader: Reader, codes: set[str]) -> Iterator[Check]:
    """What was not judged, and what it needs."""
    known = ratings.found(reader)
    if isinstance(known, str):
        who = "designer, with the maker's ratings of this bearing"
        yield unchecked("Equivalent load and minimum load", known.rstrip("."), who)
    elif "viscosity-ratio" not in codes:
        who = "oil supplier: viscosity at the temperature of the inlets"
        do = "" if reader.attributes["case_si"].get("lubricant") else _GIVE_OIL
        yield unchecked("Viscosity ratio κ", "the case gives no oil, or nothing turns", who, do=do)
    if "film-ratio" not in codes:
        films = "minimum_film_um" in reader.summary[reader.last]
        why = "no roughness given (bearing.roughness)" if films else "no film is computed for this kind"
        do = "give bearing.roughness for the film ratio" * films
        who = "bearing maker: roughness of raceways and rolling elements"
        yield unchecked("Smallest film ratio Λ", why, who, do=do)
    if "flexible" in reader.blocks and not reader.attributes.get("stresses"):
        yield _not_stressed(reader)


def _not_stressed(reader: Reader) -> Check:
    """That no stress of the rings was computed, and what computes it."""
    what, how = "Stress of the flexible rings", "outputs.stresses = true"
    if "stresses" not in {each.name for each in reader.layout.further_attributes}:
        return unchecked(what, "not computed for this kind", _ANALYST)
    do = f"set {how} for the stress of the flexible rings"
    return unchecked(what, f"{how} computes it", _ANALYST, do=do)
