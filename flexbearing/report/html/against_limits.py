"""What limits a bearing: numbers with their limits, the nearest to its limit first."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import pi
from typing import Any

import numpy as np

from flexbearing.quantities.attributes import GRADES
from flexbearing.report.html import combined, ratings
from flexbearing.report.html.assumptions import WORTH, named
from flexbearing.report.html.document import Block, Cell, Items, Number, Table, Words
from flexbearing.report.html.lives import lives
from flexbearing.report.html.raceway_tilt import between_raceways
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

DENTING, DENTING_OF_BALLS = 4000.0, 4200.0  # [MPa] static limits of roller and ball bearings by ISO 76
USUAL_OF_ROLLERS = 1.5  # static safety in normal running, SKF
USUAL_TILT = 4 / 60 * pi / 180  # [rad] range of the edge stress of ISO/TS 16281
LEAST_OF_ROLLERS, LEAST_OF_BALLS = 0.02, 0.01  # P/C_r in SKF's rule of thumb against smearing
FULL_FILM = 3  # film ratio
DEEP_GROOVE = "deep_groove_ball"
ENDS = {"pressed-end", "sharp-roller-end", "sliced-peak"}  # notes by which slices do not have the peak
NOT_CHECKED = "not checked"
MOST, LEAST = "most", "least"  # a limit from above, from below
_BROKEN = {MOST: "EXCEEDED", LEAST: "NOT MET"}
_NOTE = (
    "Share: value over limit, or limit over value where a value must not be lower. The largest share limits "
    "first; usual aims come after limits. A contact pressure grows slower than its load: with the square "
    "root of the load of a roller, the cube root of that of a ball. The limits of ISO 76 are those of a "
    "lasting dent of 1e-4 of the diameter of a rolling element."
)
_TWO = (
    "There are two static safeties. C_0/P_0 compares the load on the whole bearing with its static rating, "
    "which supposes the usual share of the most loaded rolling element. The static safety by pressure "
    "is that of the most pressed contact as computed here, with clearance, tilt, profile and, where they "
    "are flexible, the rings: its load at the pressure limit over its load. Each has its own "
    "limit, and both count."
)
_MAKER = "ISO 281 leaves to the maker whether its life formula holds"
_SLIP = (
    "no standard limits it; a minimum load is the usual rule against smearing. It is how far the cage lags "
    "behind pure rolling: drag of the oil-air mixture and friction slow the rollers, traction drives them"
)
_YIELD = "yield_stress of the part is not given in [materials], and a case has no fatigue limit"
_FEET = (
    "N/A + M/W of a bar where it meets ring and flange; for fatigue multiply it by the stress concentration "
    "factor of the fillet. The von Mises stress of the bars leaves their sharp feet out, so it may be lower"
)
_TILT = "no standard limits it; makers give the tilt that a bearing may have"
_USUAL_TILT = "4 arcmin, rule of thumb: the edge stress of ISO/TS 16281 holds below; the maker's limit counts"
_TILT_OF_ROLLERS = {
    "ring_tilt": "this is the slope of its axis, dz/dx (dy/dx where that is larger), against the unloaded "
    "axis; an outer ring on an elastic support leans along: see the slope between the raceways",
    "roller_tilt": "no standard limits it, positive: +x end further out; it presses the ends of the roller, "
    "see the notes on peak pressure and the figure of the pressure",
}
_FITTED = "lubricant.oil_fraction was fitted to a cage slip, so this is no prediction"
_ROLLING = (
    "zero to the printed digit: the traction of the oil film is far above the drag of the mixture and the "
    "friction of the cage, so that the loaded rollers roll"
)
_ENDS = 'set bearing.contact = "half_space" for the peak pressure at the ends of the rollers'
_GIVE_YIELD = "give yield_stress of [materials] for the parts whose stress has no limit here"
_COUNT_OIL = 'set life.lubrication = "a_ISO" for a life that counts oil and cleanliness'
_THICKER = (
    "take an oil {:.2g} times as viscous at its temperature, or cool it, for a viscosity ratio of 1; else "
    "oil with additives"
)
_HEAT = "the case has no limits of steel, cage and lubricant"


@dataclass(frozen=True)
class Limit:
    """A limit from above or from below."""

    value: float  # in the unit of the place of what it limits
    side: str  # MOST or LEAST
    words: str
    aim: bool = False


@dataclass(frozen=True)
class Check:
    """A number against its limit."""

    what: str
    value: Cell = ""
    limit: str = ""
    share: Cell = ""
    used: float = 0.0  # share as a number [-], zero where there is none
    verdict: str = NOT_CHECKED
    aim: bool = False  # a usual aim, which a design may miss for a reason
    urgent: bool = False  # has no limit here, and must be compared with one before the bearing is used
    do: str = ""  # what keeps a limit that is exceeded, or checks one that was not

    @property
    def rank(self) -> tuple[bool, int, float]:
        """Limits that are not kept first, then missed aims, then the others; last what was not checked."""
        broken = self.verdict.startswith(tuple(_BROKEN.values()))
        return self.verdict.startswith(NOT_CHECKED), (1 if self.aim else 0) if broken else 2, -self.used


def summary(reader: Reader) -> Iterator[Words]:
    """In a sentence whether limits are kept, and which is the nearest."""
    checks, life = ranked(reader), _lived(reader)
    limits, aims = _broken(checks)
    nearest = next((check for check in checks if check.used), None)
    left = sum(check.verdict.startswith(NOT_CHECKED) for check in checks)
    without = f" {left} more could not be checked, each for the reason in its line." if left else ""
    if limits or reader.notes(GRADES[0]):
        words = "As computed here, the bearing must not be used."
        words += f" Limits that are not kept: {_named(limits)}." if limits else " See the dangers below."
        also = f" Below what is usually aimed at: {_named(aims)}." if aims else ""
        yield Words((words + also + life + without,), "danger")
    elif aims:
        words = f"Usable only with a reason for what is below the usual aim: {_named(aims)}."
        yield Words((f"{words} Every other limit that was checked is met.{life}{without}",), "danger")
    elif nearest:
        words = f"Usable as far as checked: every limit that was checked is met; nearest: {_one(nearest)}."
        yield Words((words + life + without,), "good")
    yield from _urgent(checks)


def _broken(checks: list[Check]) -> tuple[list[Check], list[Check]]:
    """Limits that are not kept, and usual aims that are missed."""
    broken = [check for check in checks if check.verdict.startswith(tuple(_BROKEN.values()))]
    return [check for check in broken if not check.aim], [check for check in broken if check.aim]


def judged(reader: Reader) -> str:
    """Whether the bearing can be used, in a few words."""
    limits, aims = _broken(ranked(reader))
    if limits or reader.notes(GRADES[0]):
        return "No."
    return "Only with a reason for what misses a usual aim." if aims else "Yes, as far as checked."


def _urgent(checks: list[Check]) -> Iterator[Words]:
    """Values that must be compared with a limit which the case does not give."""
    reasons: dict[str, list[str]] = {}
    for check in checks:
        if check.urgent and isinstance(check.value, Number):
            value = f"{check.what}: {check.value.text} {printed(check.value.unit)}"
            reasons.setdefault(check.verdict.partition(": ")[2], []).append(value)
    for why, values in reasons.items():
        words = f"Compare with limits of your own before use: {'; '.join(values)}. Reason: {why}."
        yield Words((words,), "danger")


def _lived(reader: Reader) -> str:
    """The life of the case, in a sentence, and that of the catalogue; empty where there is none."""
    first = next(iter(lives(reader)), None)
    if first is None or not first.chosen:
        return ""
    number, unit = (
        (first.hours, "h") if isinstance(first.hours, Number) else (first.turns, "million revolutions")
    )
    words = f" {first.name} of this case: {rounded(number)} {unit}{_oil(reader)}"
    if (span := combined.of(reader, combined.LIFE)) is not None:
        low, high = (rounded(number, times) for times in span.squares)
        by = "by what is assumed, fitted, toleranced or chosen (see Main results)"
        words += f", {low} to {high} {unit} {by}"
    rated = next((life.hours for life in lives(reader) if life.key == "catalogue"), None)
    if isinstance(rated, Number):
        words += (
            f". Catalogue's life L10h of ISO 281, for requirements that name no other: {rounded(rated)} h"
        )
    return f"{words}."


def _oil(reader: Reader) -> str:
    """That a life leaves out an oil that is too thin; empty where it counts it, or the oil is sufficient."""
    found, life = ratings.viscosity_ratio(reader), reader.attributes["case_si"].get("life") or {}
    if life.get("lubrication") or found is None or found[0] >= 1:
        return ""
    return f', which leaves out the thin oil (κ {found[0]:.3g}; life.lubrication = "a_ISO" counts it)'


def rounded(number: Number, times: float = 1.0) -> str:
    """A number of a table, or a multiple of it, with three digits for a sentence: 489,719 is 490,000."""
    value = times * float(number.text.replace(",", ""))
    return f"{float(f'{value:.3g}'):,.10g}"


def _named(checks: list[Check]) -> str:
    return "; ".join(map(_one, checks))


def _one(check: Check) -> str:
    """A limit with its value, or that it is not met."""
    if isinstance(check.value, str):
        return f"{check.what} (required: {check.limit})"
    value = f"{check.value.text} {printed(check.value.unit)}".strip()
    return f"{check.what}: {value}, {check.limit}"


def blocks(reader: Reader) -> Iterator[Block]:
    """Every limit, those that are not kept first."""
    checks = ranked(reader)
    rows = tuple(
        (check.what, check.value, _unit(check.value), check.limit, check.share, check.verdict)
        for check in checks
    )
    head = ("checked", "value", "unit", "limit", "share of the limit [%]", "verdict")
    yield Table("What limits most", head, rows, _NOTE, name="limits-most")
    if "static_safety" in reader.blocks[reader.last]:
        yield Words((_TWO,))


def ranked(reader: Reader) -> list[Check]:
    """Every check, the nearest to its limit first; what was not checked last, with the reason."""
    found = (
        *_pressures(reader), *_static(reader), *_load(reader), *_stresses(reader), *_films(reader),
        *_spin(reader), *_clearance(reader), *_noted(reader), *_life(reader),
        *_tilts(reader), *_slip(reader), *_heat(reader), *_never(reader),
    )  # fmt: skip
    return sorted(found, key=lambda check: check.rank)


def to_do(reader: Reader) -> Iterator[Items]:
    """What to do next."""
    if told := steps(reader):
        yield Items("What to do next", told, name="to-do")


def steps(reader: Reader) -> tuple[str, ...]:
    """Keep limits, find out what moves results most, check what was not checked."""
    checks = ranked(reader)
    broken = [check.do for check in checks if check.verdict.startswith(tuple(_BROKEN.values()))]
    others = [check.do for check in checks if check.do not in broken]
    moved: dict[str, list[str]] = {}
    for word in (combined.LIFE, *dict(reader.layout.weighed).values()):
        span = combined.of(reader, word)
        if span is not None and max(span.squares[1], 1 / span.squares[0]) > WORTH:
            moved.setdefault(span.most, []).append(word)
    measure = [
        f"find out and specify {named(key)}: moves {', '.join(words)} most" for key, words in moved.items()
    ]
    return tuple(dict.fromkeys(filter(None, (*broken, *measure, *others))))


def _unit(value: Cell) -> str:
    return "" if isinstance(value, str) else printed(value.unit)


def _against(reader: Reader, what: str, value: Number, number: float | None, limit: Limit) -> Check:
    """A number against a limit in the unit of its place in the file."""
    if number is None:
        return Check(what, value, limit.words, verdict=f"{NOT_CHECKED}: no number")
    met = number <= limit.value if limit.side == MOST else number >= limit.value
    used = number / limit.value if limit.side == MOST else limit.value / number if number else 0.0
    of = f"share/{limit.side}/{float(limit.value)!r}/{value.of}"
    share = reader.units.number(100 * used, "%", "%", ",.0f", of)
    return Check(what, value, limit.words, share, used, "met" if met else _BROKEN[limit.side], limit.aim)


def _pressures(reader: Reader) -> Iterator[Check]:
    limit = DENTING_OF_BALLS if reader.attributes["kind"].endswith("ball") else DENTING
    text = reader.units.number(limit, "MPa", "MPa", ",.0f", "").text
    ends = ENDS & {note["code"] for note in reader.attributes["notes"]}
    for race, number in (reader.summary[reader.last].get("peak_pressure_MPa") or {}).items():
        path = f"summary/{reader.last}/peak_pressure_MPa/{race}"
        value = reader.units.number(number, "MPa", "MPa", ",.0f", path)
        what = f"Peak contact pressure, {race} raceway"
        check = _against(reader, what, value, number, Limit(limit, MOST, f"at most {text} (ISO 76)"))
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
        words = aim if usual else "at least 1 (ISO 76)"
        limit = Limit(USUAL_OF_ROLLERS if usual else 1.0, LEAST, words, usual)
        yield _against(reader, "Static safety C_0/P_0", value, number, limit)
    known = reader.summary[reader.last].get("pressure_safety") or {}
    found = {race: each for race, each in known.items() if each is not None}
    if found:
        race = min(found, key=found.__getitem__)
        path = f"summary/{reader.last}/pressure_safety/{race}"
        value = reader.units.number(found[race], "", "", ",.2f", path)
        what = f"Static safety by pressure, {race} raceway"
        yield _against(reader, what, value, found[race], Limit(1.0, LEAST, "at least 1 (ISO 76)"))


def _load(reader: Reader) -> Iterator[Check]:
    """Equivalent load against what ISO 281 holds for, and against the least."""
    found = ratings.found(reader)
    if isinstance(found, str):
        yield Check("Equivalent load and minimum load", verdict=f"{NOT_CHECKED}: {found.rstrip('.')}")
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
        check = _against(reader, what, value, load, Limit(limit, MOST, words))
        told, do = check.verdict, ""
        if told == "EXCEEDED":
            unit = printed(value.unit)
            told += f": {_MAKER}"
            if name == "C_r/2":
                needed, most = (f"{kilonewtons(force)} {unit}" for force in (2 * load, limit))
                do = f"take a bearing with C_r of at least {needed}, or a load P of at most {most}"
        yield replace(check, verdict=told, do=do)
    share = LEAST_OF_BALLS if balls else LEAST_OF_ROLLERS
    words = f"at least {kilonewtons(share * rating)} ({share:g} C_r, rule of thumb of SKF)"
    what = "Minimum load, against slip and smearing"
    yield _against(reader, what, value, load, Limit(share * rating, LEAST, words, True))


def _stresses(reader: Reader) -> Iterator[Check]:
    parts = reader.attributes.get("stresses") or {}
    for part, found in parts.items():
        for body, most in found["bodies"].items():
            path = f"attributes/stresses/{part}/bodies/{body}/von_mises_MPa"
            limit = yield_stress(reader, part, body)
            yield _against_yield(
                reader, f"Von Mises stress, {part}: {body}", most["von_mises_MPa"], limit, path
            )
    nominal = reader.summary[reader.last].get("nominal_bar_stress_MPa")
    if nominal is not None:
        path = f"summary/{reader.last}/nominal_bar_stress_MPa"
        limit = yield_stress(reader, "outer", "bars")
        check = _against_yield(reader, "Nominal stress of the bars", nominal, limit, path)
        yield replace(check, verdict=f"{check.verdict}; {_FEET}")
    if not parts and "flexible" in reader.blocks:
        if "stresses" not in {each.name for each in reader.layout.further_attributes}:
            yield Check("Stress of the flexible rings", verdict=f"{NOT_CHECKED}: not computed for this kind")
            return
        how = "outputs.stresses = true"
        yield Check(
            "Stress of the flexible rings", verdict=f"{NOT_CHECKED}: {how} computes it",
            do=f"set {how} for the stress of the flexible rings",
        )  # fmt: skip


def _against_yield(reader: Reader, what: str, stress: float, limit: float | None, path: str) -> Check:
    """A stress [MPa] against the yield stress of a material [Pa]; where none is given, that is said."""
    value = reader.units.number(stress, "MPa", "MPa", ",.0f", path)
    if limit is None:
        return Check(what, value, verdict=f"{NOT_CHECKED}: {_YIELD}", urgent=True, do=_GIVE_YIELD)
    words = f"at most {reader.units.number(limit, 'Pa', 'MPa', ',.0f', '').text} (yield)"
    return _against(reader, what, value, stress, Limit(limit / 1e6, MOST, words))


def yield_stress(reader: Reader, part: str, body: str) -> float | None:
    """Yield stress [Pa] of a body by its name, else of the ring of its part; None where it is not given."""
    materials = reader.attributes["case_si"].get("materials", {})
    named = "shaft" if "shaft" in body else "housing" if "housing" in body else f"{part}_ring"
    return (materials.get(named) or {}).get("yield_stress")


def _films(reader: Reader) -> Iterator[Check]:
    yield from _film_ratio(reader)
    found = ratings.viscosity_ratio(reader)
    what, words = "Viscosity ratio κ", "at least 1 (usual aim; ISO 281 rates from 0.1)"
    if found is not None:
        value = reader.units.number(found[0], "", "", ".3g", found[1])
        check = _against(reader, what, value, found[0], Limit(1.0, LEAST, words, True))
        counted = (reader.attributes["case_si"].get("life") or {}).get("lubrication")
        yield replace(
            check,
            do=("" if counted else _COUNT_OIL) if check.verdict == "met" else _THICKER.format(1 / found[0]),
        )
    elif not isinstance(ratings.found(reader), str):
        how = 'life.lubrication = "a_ISO"'
        do = f"set {how} for the viscosity ratio and a life with oil and cleanliness"
        yield Check(what, "", words, verdict=f"{NOT_CHECKED}: {how} computes it", do=do)


def _film_ratio(reader: Reader) -> Iterator[Check]:
    found = reader.summary[reader.last].get("minimum_lambda")
    regimes = (reader.attributes.get("regimes") or {}).get(reader.last, {})
    words = f"at least 1, full film from {FULL_FILM}"
    for race in ("inner", "outer") if found else ():
        path = f"summary/{reader.last}/minimum_lambda/{race}"
        value = reader.units.number(found[race], "", "", ".2f", path)
        what = f"Smallest film ratio Λ, {race} raceway"
        check = _against(reader, what, value, found[race], Limit(1.0, LEAST, words, True))
        told = f"{check.verdict}: {regimes[race]}" if race in regimes else check.verdict
        yield replace(check, verdict=told)
    if not found:
        films = "minimum_film_um" in reader.summary[reader.last]
        why = (
            "no roughness given (bearing.roughness)"
            if films
            else "no film is computed for this kind of bearing"
        )
        do = "give bearing.roughness for the film ratio" if films else ""
        yield Check("Smallest film ratio Λ", "", words, verdict=f"{NOT_CHECKED}: {why}", do=do)


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
    yield _against(reader, what, value, needed[race], Limit(limit, MOST, words))


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
        verdict = f"met as computed, preload: {words}" if preload else f"met, {words}"
    if found["operating_m"] < 0:
        verdict = "preload: see Clearance"
    value = reader.of_attribute("clearance/operating_m", "m", "um", ".3g")
    yield Check(f"Diametral {reader.clearance_words}", value, "at least 0", verdict=verdict)


_CORRECT = {"overlapping-dimensions": "correct the dimensions of the cage or of the ribs, which overlap"}
_NEVER = {
    "Strength of the cage": "no stress of the cage is computed; pocket forces stand under Rollers or Balls",
    "Heat balance": "temperatures are given, not computed: heat and oil flow must agree with them",
    "Creep of the rings in their seats": "compare the fits with the maker's for a load that turns or stands",
    "Hoop stress of the rings by fit and speed": "not among these numbers; the stress of a flexible ring, if "
    "computed, has its own line",
}
_NOTED = {  # what, by the code of a note: limit, verdict
    "overlapping-dimensions": (
        "Dimensions of the cage", "no overlap",
        "remark: they overlap; loads and life do not depend on it, drag and friction of the cage do",
    ),
    "truncated-contact": ("Contacts on the shoulders of races", "not cut off", "EXCEEDED: see the danger"),
    "shoulder-not-given": (
        "Contacts on the shoulders of races", "not cut off",
        f"{NOT_CHECKED}: the height of the shoulders is not given, usual ones would cut contacts off",
    ),
}  # fmt: skip


def _noted(reader: Reader) -> Iterator[Check]:
    """Limits that the run itself compared, by the codes of its notes."""
    for code in dict.fromkeys(note["code"] for note in reader.attributes["notes"]):
        if code in _NOTED:
            what, limit, verdict = _NOTED[code]
            yield Check(what, "", limit, verdict=verdict, do=_CORRECT.get(code, ""))


def _never(reader: Reader) -> Iterator[Check]:
    """What no run computes."""
    for what, why in _NEVER.items():
        yield Check(what, verdict=f"{NOT_CHECKED}: {why}")


def _life(reader: Reader) -> Iterator[Check]:
    """The life has a limit that only the reader knows."""
    first = next(iter(lives(reader)), None)
    if first is not None and first.chosen:
        why = f"{NOT_CHECKED}: the case states no required life; compare with yours"
        life = first.hours or first.turns
        do = "compare the life with the required one"
        yield Check(f"Life: {first.name}", life, "the required life", verdict=why, do=do)


def _slip(reader: Reader) -> Iterator[Check]:
    for entry in (entry for entry in reader.layout.summary if entry.label == "cage slip"):
        value = reader.declared(entry, reader.last)
        if value.text.strip("0.") == "":
            yield Check("Cage slip", value, verdict=f"{NOT_CHECKED}: {_ROLLING}")
            continue
        fitted = f"; {_FITTED}" * ("lubricant.oil_fraction" in reader.attributes["calibrated"])
        yield Check("Cage slip", value, verdict=f"{NOT_CHECKED}: {_SLIP}{fitted}")


def _tilts(reader: Reader) -> Iterator[Check]:
    """Slope between the raceways of rollers, largest slopes of inner ring and rollers."""
    block = reader.blocks[reader.last]
    found = between_raceways(reader)
    if found and np.any(block["ring_tilt"]):
        what, limit = "Slope between the raceways at the most loaded roller", 1e3 * USUAL_TILT
        words = f"at most {limit:.3g} ({_USUAL_TILT})"
        value, size = found
        yield _against(reader, what, value, size, Limit(USUAL_TILT, MOST, words, True))
    for name, what in (("ring_tilt", "Tilt of the inner ring"), ("roller_tilt", "Largest tilt of a roller")):
        if name in block and np.any(sizes := np.abs(np.ravel(block[name]))):
            value = reader.element(reader.last, name, int(np.argmax(sizes)), digits=".3g")
            told = _TILT_OF_ROLLERS[name] if reader.of_rollers else _TILT
            yield Check(what, value, verdict=f"{NOT_CHECKED}: {told}")


def _heat(reader: Reader) -> Iterator[Check]:
    """Temperatures and speeds, whose limits no case has."""
    known = reader.attributes["case_si"].get("operation", {}).get("temperatures") or {}
    parts = {name: value for name, value in known.items() if name != "reference" and isinstance(value, float)}
    if parts:
        part = max(parts, key=parts.__getitem__)
        value: Any = reader.units.number(
            parts[part], "K", "degC", ",.4g", f"case/operation.temperatures.{part}"
        )
        yield Check(
            f"Highest temperature given, {part.replace('_', ' ')}", value, verdict=f"{NOT_CHECKED}: {_HEAT}"
        )
    else:
        why = "the case gives no temperatures of parts"
        steps = (reader.attributes.get("clearance") or {}).get("steps")
        do = "give [operation.temperatures]: a warmer inner ring takes clearance" if steps else ""
        yield Check("Temperature", verdict=f"{NOT_CHECKED}: {why}", do=do)
    yield Check("Speed", verdict=f"{NOT_CHECKED}: the case has no limiting speed of the maker")
