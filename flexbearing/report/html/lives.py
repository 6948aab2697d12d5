"""Every life of a bearing: the most detailed one of its case, and what the others are."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from flexbearing.findings import NOT_MET
from flexbearing.findings.codes import PRESSED_ENDS
from flexbearing.findings.strength import HEAVY_LOAD
from flexbearing.quantities.effects import CHOICE, INPUT
from flexbearing.report.html import assumed_effects, assumptions, finding_checks, ratings
from flexbearing.report.html.document import Block, Cell, Items, Number, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import units_in_words

COMPARED = "the most detailed life of this case"
_NAMED = (
    " Compare with a requirement the life that it names; where it says no more than L10h or rating life, "
    "that is the catalogue's life of ISO 281."
)
_FORMULA, _NOT_KNOWN = "none: a formula", "not estimated"
_NO_GRID = "none: balls have no slices"
_LUNDBERG, _REFERENCE, _RATING = "basic", "reference", "rating"  # what the life of a case is made of


_ORDER = ("modified", "reference", "basic", "catalogue", "catalogue modified")
_OF_BASIC = ("tilt", "roller-position")  # of these, those that tell the basic life L10
_BASIC = " (of the basic life L10{power})"
_POWER = "; a_ISO follows the load, so the modified life changes as its power of {:.3g}"
_BY_KEY = {"tilt": "operation.tilt", "fit-tolerances": "bearing.fits.at"}  # reported by effects of these keys
_MOVED = ("tilt", "roller-position", "fit-tolerances")  # codes of notes that tell other lives


@dataclass(frozen=True)
class Life:
    """A life of the last end state, or of a catalogue."""

    key: str  # "basic", "reference", "modified", "catalogue", "catalogue modified"
    name: str
    turns: Number  # [10^6 revolutions]
    hours: Cell  # empty where nothing turns
    error: Cell  # numerical, in percent of the life, or why there is none
    meaning: str
    chosen: bool = False  # the most detailed one of the case
    output: str = ""  # its name among the outputs; empty of a catalogue


def lives(reader: Reader) -> tuple[Life, ...]:
    """All lives that a result and its ratings know, the most detailed one of the case first."""
    found = [*_of_case(reader), *_of_catalogue(reader)]
    known = {life.key for life in found}
    wanted = next((key for key in ("modified", "reference", "basic") if key in known), "")
    kept = [replace(life, chosen=life.key == wanted) for life in found]
    return tuple(sorted(kept, key=lambda life: (not life.chosen, _ORDER.index(life.key))))


def blocks(reader: Reader) -> Iterator[Block]:
    """Which life to use and why, then all of them; a sentence where the case has none."""
    found = lives(reader)
    if not found or not found[0].chosen:
        why = ratings.found(reader)
        reason = why if isinstance(why, str) else "The run computed none."
        yield Words((f"No life of this case. {reason}",))
        return
    yield Words((f"Life of this case: {found[0].name}. {_why(reader, found)}{_NAMED}",))
    rows: list[tuple[Cell, ...]] = [
        (life.name, life.turns, life.hours, life.error, (COMPARED + ": ") * life.chosen + life.meaning)
        for life in found
    ]
    head = ("life", "10⁶ revolutions", "hours", "numerical error [%]", "what it is for")
    yield Table(f"Which life to use, {reader.state}", head, tuple(rows))
    if moved := tuple(_moved(reader)):
        yield Items("What moves this life more than its numerical error", moved)
    yield from _unmoved(reader)


def _unmoved(reader: Reader) -> Iterator[Words]:
    """That no input moves this life much, where effects are known; those that do are listed."""
    if reader.attributes.get("assumed_effects") and not assumed_effects.moving(reader):
        yield Words((f"No assumed input changes this life {assumptions.WORTH:g} times or more.",))


def _moved(reader: Reader) -> Iterator[str]:
    """What of the case is not known or not counted, as far as its effect on the life is known."""
    case = reader.attributes["case_si"]
    if finding_checks.verdict(reader, HEAVY_LOAD.code) == NOT_MET:
        yield f"load: {HEAVY_LOAD.meaning}"
    solved = {key for role in (INPUT, CHOICE) for key in assumed_effects.keys(reader, role)}
    left_out = case["life"].get("edge_stress") is False and "life.edge_stress" not in solved
    if reader.codes & PRESSED_ENDS and left_out:
        yield "edge stress: left out of the life (life.edge_stress = false), though roller ends are pressed"
    modified = next(life.key == "modified" for life in lives(reader) if life.chosen)
    for note in reader.attributes["notes"]:
        if note["code"] in _MOVED and _BY_KEY.get(note["code"]) not in solved:
            basic = _BASIC.format(power=_power(reader)) if modified and note["code"] in _OF_BASIC else ""
            yield units_in_words(note["text"]) + basic
    if reader.attributes.get("assumed_effects"):
        yield from assumed_effects.moving(reader)


def _power(reader: Reader) -> str:
    """With which power of the basic life the modified one changes; empty where its factors do not tell."""
    exponents = _exponents(reader)
    return "" if None in exponents else _POWER.format(1 + sum(filter(None, exponents)))


def _exponents(reader: Reader) -> list[float | None]:
    """Powers of the basic life that the factors of the modified one change with; None where not known."""
    factors = reader.attributes["life"][reader.last]["factors"]
    return [factor.get("life_exponent", 0.0 if factor["effect"] == "load" else None) for factor in factors]


def _why(reader: Reader, found: tuple[Life, ...]) -> str:
    """Why this life is the one, and which is compared with a requirement of another kind."""
    life, keys = reader.attributes["case_si"]["life"], {each.key for each in found}
    if _kind(reader) == _RATING:
        return (
            'The case has the rule of the catalogue (life.loads = "rating"): one load P; clearance, '
            "tilt, profile and flexible rings do not count in it."
        )
    words = [
        "It rests on the loads of all rolling elements of this case, which the catalogue's life does not."
    ]
    if _kind(reader) == _LUNDBERG:
        words.append(
            "It has the capacities of Lundberg and Palmgren: a requirement by ISO/TS 16281 needs "
            'life.capacity = "iso281" in the case.'
        )
    if found[0].key == "modified":
        basic = "reference" if "reference" in keys else "basic"
        words.append(
            f"It also counts {_counted(life)}; a requirement by ISO/TS 16281 without "
            f"these is compared with the {basic} life instead."
        )
    elif life.get("lubrication") is None:
        words.append(
            'Oil and cleanliness do not count in it: life.lubrication = "a_ISO" adds them, as ISO 281 does.'
        )
    return " ".join(words)


def _counted(life: dict[str, Any]) -> str:
    """What the factors of [life] count, in words."""
    words = {
        "lubrication": "oil and cleanliness" if life.get("lubrication") == "a_ISO" else "the oil film",
        "steel": "the steel",
        "reliability": f"a survival probability of {100 * (life.get('reliability') or 0.9):g} %",
        "roller_body": "rollers that fail",
    }
    counted = [text for key, text in words.items() if life.get(key)]
    return " and ".join(filter(None, [", ".join(counted[:-1]), *counted[-1:]])) or "the edge stress"


def _kind(reader: Reader) -> str:
    """What the life of a case is made of."""
    life = reader.attributes["case_si"]["life"]
    if life.get("loads") == "rating":
        return _RATING
    return _REFERENCE if reader.of_balls or life.get("capacity") == "iso281" else _LUNDBERG


def _of_case(reader: Reader) -> Iterator[Life]:
    """Lives of the last end state."""
    block, bearing = reader.blocks.get(reader.last, {}), reader.bearing
    if "life_L10" not in block:
        return
    if "roller" in bearing:
        whole = "; the most loaded roller on half-spaces" if bearing.get("contact") == "half_space" else ""
        meaning = (
            f"capacities of Lundberg and Palmgren, loads of all slices of all rollers{whole}; 90 % survive"
        )
        yield _output(reader, "life_L10", "basic", "Basic life L10, Lundberg and Palmgren", meaning)
    else:
        meaning = "C_r with the loads of all balls on both raceways; 90 % survive, ordinary oil"
        yield _output(reader, "life_L10", "reference", "Reference life L10r, ISO/TS 16281", meaning)
    if "reference_life" in block:
        meaning = "C_r with the loads of all slices of all rollers; 90 % survive, ordinary oil"
        yield _output(reader, "reference_life", "reference", "Reference life L10r, ISO/TS 16281", meaning)
    if "modified_life" in block:
        yield from _modified(reader)


def _modified(reader: Reader) -> Iterator[Life]:
    """Life after every factor, where it has more of them than the reference life."""
    factors = reader.attributes["life"][reader.last]["factors"]
    of, share = _kind(reader), 100 * (reader.attributes["case_si"]["life"].get("reliability") or 0.9)
    names = [each["name"] for each in factors if each["effect"] != "load" or each["name"] == "roller body"]
    if of == _REFERENCE and not names:
        return
    before = {_REFERENCE: "reference life", _LUNDBERG: "basic life", _RATING: "(C_r/P)^p of ISO 281"}[of]
    name = {
        _REFERENCE: "Modified reference life, ISO/TS 16281", _LUNDBERG: "Modified life",
        _RATING: "Modified life of the catalogue, ISO 281" if names else "Life L10 of the catalogue, ISO 281",
    }[of]  # fmt: skip
    if of == _LUNDBERG:
        names = [each["name"] for each in factors]
    meaning = f"{before} times {', '.join(names)}" if names else before
    yield _output(reader, "modified_life", "modified", name, f"{meaning}; {share:g} % survive")


def _output(reader: Reader, name: str, key: str, label: str, meaning: str) -> Life:
    turning = reader.blocks[reader.last].get("relative_speed")
    hours: Cell = reader.output(name, "h", ",.4g") if turning else ""
    turns = reader.output(name, "Mrev", ",.4g")
    return Life(key, label, turns, hours, error(reader, name), meaning, output=name)


def error(reader: Reader, name: str) -> Cell:
    """Estimated numerical error of a life in percent, or in words why there is none.

    That of the basic life is carried on by the factors: those that follow the life grow with it, those of
    loads and steel do not change it.
    """
    if not reader.of_rollers:
        return _NO_GRID
    if name == "modified_life" and _kind(reader) == _RATING:
        return _FORMULA
    found = of_basic(reader)
    if found is None:
        return _NOT_KNOWN
    value, path = found
    if name != "modified_life":
        return reader.units.number(value, "1", "%", ".2g", f"life_error:{path}")
    exponents = _exponents(reader)
    if None in exponents:
        factors = reader.attributes["life"][reader.last]["factors"]
        return "not estimated: film" if any(each["name"] == "film" for each in factors) else _NOT_KNOWN
    carried = value * (1 + sum(filter(None, exponents)))
    return reader.units.number(carried, "1", "%", ".2g", f"life_error:{path}:{reader.last}")


def of_basic(reader: Reader) -> tuple[float, str] | None:
    """Estimated error over the basic life, with its place: of the target or of finer slices."""
    ordered = (reader.attributes.get("error_estimate") or {}).get("life")
    if ordered is not None:
        return ordered, "attributes/error_estimate/life"
    block = reader.blocks.get(reader.last, {})
    return (float(block["life_error"]), f"{reader.last}/life_error") if "life_error" in block else None


def _of_catalogue(reader: Reader) -> Iterator[Life]:
    """Lives by one load P."""
    found = ratings.found(reader)
    if isinstance(found, str) or _kind(reader) == _RATING:
        return
    rated, at = found
    exponent = "(10/3)" if reader.of_rollers else "3"

    def life(key: str, label: str, name: str, meaning: str) -> Life:
        turns, hours = (
            reader.units.number(rated[f"{name}_{unit}"], unit, unit, ",.4g", f"{at}/{name}_{unit}")
            for unit in ("Mrev", "h")
        )
        turning = reader.blocks[reader.last].get("relative_speed")
        return Life(key, label, turns, hours if turning else "", _FORMULA, meaning)

    meaning = f"(C_r/P)^{exponent}: to compare bearings of catalogues; not this clearance, profile or rings"
    if rated["load_N"] > rated["ratings_N"]["C_r"] / 2:
        meaning += "; P is above C_r/2, where ISO 281 leaves it to the maker"
    yield life("catalogue", "Catalogue's life L10, ISO 281", "life", f"{meaning}; 90 % survive")
    if "a_ISO" in rated:
        meaning = "the catalogue's life times a_ISO at P; 90 % survive"
        yield life("catalogue modified", "Catalogue's modified life L10m, ISO 281", "modified", meaning)
