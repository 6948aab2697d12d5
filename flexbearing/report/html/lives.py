"""Every life of a bearing: the most detailed one of its case, and what the others are."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import inf, isclose

from flexbearing.quantities.life_records import BY_LOADS, ROLLER_BODY, Stage
from flexbearing.quantities.reductions import RACES
from flexbearing.report.html import ratings
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.reader import Reader, once

_FORMULA, _NOT_KNOWN, _NO_GRID = "none: a formula", "not estimated", "none: no slices"
_LUNDBERG, _REFERENCE, _RATING = "basic", "reference", "rating"  # what the life of a case is made of
_ORDER = ("modified", "reference", "basic", "catalogue", "catalogue modified")
AUTHORS = "Lundberg and Palmgren"
_NAMES = {  # of lives by loads with their source, by whose capacities
    True: ("basic", "Basic life L10", AUTHORS),
    False: ("reference", "Reference life L10r", "ISO/TS 16281"),
}
_MODIFIED = {
    _REFERENCE: ("Modified reference life", "ISO/TS 16281"), _LUNDBERG: ("Modified life", ""),
    _RATING: ("Modified life of the catalogue", "ISO 281"),
}  # fmt: skip
_AS_CATALOGUE = "Life L10 of the catalogue", "ISO 281"  # without factors


@dataclass(frozen=True)
class Life:
    """A life of the last end state, or of a catalogue."""

    key: str  # "basic", "reference", "modified", "catalogue", "catalogue modified"
    kind: str  # in words
    source: str
    turns: Number  # [10^6 revolutions]
    hours: Cell  # empty where nothing turns
    error: Cell  # numerical, in percent of the life, or why there is none
    chosen: bool = False  # the most detailed one of the case
    output: str = ""  # its name among the outputs; empty of a catalogue

    @property
    def name(self) -> str:
        """What it is, with its source."""
        return ", ".join(filter(None, (self.kind, self.source)))


@once
def lives(reader: Reader) -> tuple[Life, ...]:
    """All lives that a result and its ratings know, the most detailed one of the case first."""
    found = [*_of_case(reader), *_of_catalogue(reader)]
    known = {life.key for life in found}
    wanted = next((key for key in ("modified", "reference", "basic") if key in known), "")
    kept = [replace(life, chosen=life.key == wanted) for life in found]
    return tuple(sorted(kept, key=lambda life: (not life.chosen, _ORDER.index(life.key))))


def why_none(reader: Reader) -> str:
    """Why there is no life; empty where there is one."""
    rated = ratings.found(reader)
    return rated if isinstance(rated, str) and not lives(reader) else ""


def table(reader: Reader) -> Table | None:
    """All of them, and those of each raceway; the first page has the hours of the life of the case."""
    known = lives(reader)
    if not known:
        return None
    rows: list[tuple[Cell, ...]] = [
        (life.name, life.turns, "[first page](#first)" if life.chosen and life.hours else life.hours,
         life.error)
        for life in known
    ]  # fmt: skip
    if "raceway_life" in reader.blocks.get(reader.last, {}):
        rows += [(f"  of the {race} raceway alone", *_of_output(reader, f"raceway_life.{race}"), "")
                 for race in RACES]  # fmt: skip
    return Table(("life", "10⁶ revolutions", "hours", "numerical error [%]"), tuple(rows))


def factors(reader: Reader, block: str) -> Table | None:
    """From the life by loads to the modified one of an end state; None where it has no factors."""
    life = reader.lives.get(block)
    if life is None or life.modified_Mrev is None or block not in reader.blocks:
        return None
    path, reached = f"life/{block}", life.basic_Mrev
    reference = float(reader.blocks[block].get("reference_life", inf)) / 1e6
    rows: list[tuple[Cell, ...]] = []
    for place, factor in enumerate(life.factors):
        value = reader.of_attribute(f"{path}/factors/{place}/value", "", "", ".4g")
        reached *= factor.value
        after = "gives the reference life; " if isclose(reached, reference, rel_tol=1e-9) else ""
        rows.append((factor.name, value, after + factor.note))
    return Table(("factor", "value", "note"), tuple(rows)) if rows else None


def stages(reader: Reader) -> Table | None:
    """Every life from the catalogue's to that of the case; None where the run did not compute them."""
    found = reader.attributes.get("catalogue_life")
    if not found:
        return None
    rows: list[tuple[Cell, ...]] = []
    for place, stage in enumerate(Stage(**each) for each in found["stages"]):
        path = f"catalogue_life/stages/{place}"
        factor: Cell = "" if stage.factor is None else reader.of_attribute(f"{path}/factor", "", "", ".4g")
        both = (reader.of_attribute(f"{path}/life_{unit}", unit, unit, ",.4g") for unit in ("Mrev", "h"))
        rows.append((stage.name, factor, *both))
    return Table(("influence", "factor", "10⁶ revolutions", "hours"), tuple(rows))


def _kind(reader: Reader) -> str:
    """What the life of a case is made of."""
    life = reader.attributes["case_si"]["life"]
    if life.get("loads") == "rating":
        return _RATING
    return _LUNDBERG if reader.by_authors and life["capacity"] != "iso281" else _REFERENCE


def _of_case(reader: Reader) -> Iterator[Life]:
    """Lives of the last end state."""
    block = reader.blocks.get(reader.last, {})
    if "life_L10" not in block:
        return
    yield _life(reader, "life_L10", *_NAMES[reader.by_authors])
    if "reference_life" in block:
        yield _life(reader, "reference_life", *_NAMES[False])
    if "modified_life" in block:
        of, counted = _kind(reader), reader.lives[reader.last].factors
        extra = any(each.effect != BY_LOADS or each.name == ROLLER_BODY for each in counted)
        if of != _REFERENCE or extra:
            name = _MODIFIED[of] if extra or of != _RATING else _AS_CATALOGUE
            yield _life(reader, "modified_life", "modified", *name)


def _life(reader: Reader, name: str, key: str, kind: str, source: str) -> Life:
    return Life(key, kind, source, *_of_output(reader, name), error(reader, name), output=name)


def _of_output(reader: Reader, name: str) -> tuple[Number, Cell]:
    """A life in revolutions and in hours, where it turns."""
    turning = reader.blocks[reader.last].get("relative_speed")
    hours: Cell = reader.output(name, "h", ",.4g") if turning else ""
    return reader.output(name, "Mrev", ",.4g"), hours


def error(reader: Reader, name: str) -> Cell:
    """Estimated numerical error of a life in percent, or in words why there is none.

    That of the basic life is carried on by the factors: those that follow the life grow with it, those of
    loads and steel do not change it.
    """
    if "slice_position" not in reader.blocks[reader.last]:
        return _NO_GRID
    if name == "modified_life" and _kind(reader) == _RATING:
        return _FORMULA
    found = _of_basic(reader)
    if found is None:
        return _NOT_KNOWN
    value, path = found
    if name != "modified_life":
        return reader.units.number(value, "1", "%", ".2g", f"life_error:{path}")
    exponents = [factor.growth for factor in reader.lives[reader.last].factors]
    if None in exponents:
        return _NOT_KNOWN
    carried = value * (1 + sum(filter(None, exponents)))
    return reader.units.number(carried, "1", "%", ".2g", f"life_error:{path}:{reader.last}")


def _of_basic(reader: Reader) -> tuple[float, str] | None:
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
    turning = reader.blocks[reader.last].get("relative_speed")
    names = {"catalogue": ("Catalogue's life L10", "life")}
    if rated.a_ISO is not None:
        names["catalogue modified"] = ("Catalogue's modified life L10m", "modified")
    for key, (kind, name) in names.items():
        turns, hours = (
            reader.units.number(getattr(rated, f"{name}_{unit}"), unit, unit, ",.4g", f"{at}/{name}_{unit}")
            for unit in ("Mrev", "h")
        )
        yield Life(key, kind, "ISO 281", turns, hours if turning else "", _FORMULA)


def rounded(number: Number, times: float = 1.0) -> Number:
    """A life, or a multiple of it, with three digits: 489,719 h are 490,000 h."""
    value = times * number.size
    return replace(number, text=f"{float(f'{value:.3g}'):,.10g}") if number.text[-1:].isdigit() else number
