"""Lubrication in one place: viscosity ratio, film, film ratio, and how they differ."""

from collections.abc import Iterator

from flexbearing.findings.running import FULL_FILM, VISCOSITY_RATIO
from flexbearing.report.html import oil, ratings
from flexbearing.report.html.document import Block, Cell, Number, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

_DIFFER = (
    "κ and the film are two measures. κ is the viscosity of the oil at the inlet temperature over that which "
    "a bearing of this size and speed needs by ISO 281: load, roughness and lack of oil do not count in it. "
    "The film is computed in each contact, with its load, speeds and heated inlet. The film ratio Λ is "
    "the film over the combined roughness of both surfaces. So κ may be sufficient, and rough surfaces touch "
    "all the same. The life by ISO 281 uses κ."
)
_EXTRAPOLATED = "The oil is used outside the temperatures of its data: both κ and films are extrapolated."
_MEANINGS = {
    "kappa": f"{VISCOSITY_RATIO.limit:g} or more is usual",
    "largest": "with the cleanest oil, e_C = 1, at the load that has the life of this case by C_r; ISO 281",
    "film": "in the thinnest contact with load; the film ratio Λ is 1 with a combined roughness of this size",
    "ratio": f"from 1 on surfaces seldom touch, from {FULL_FILM:g} on the film is full",
    "full": "a smoother pair has a full film",
}


def blocks(reader: Reader) -> Iterator[Block]:
    """Viscosity ratio, smallest films, and film ratios or the roughness that they would need."""
    rows: list[tuple[Cell, ...]] = []
    for label, value, meaning in (
        ("viscosity ν of the oil at its inlet temperature", oil.viscosity(reader), "kinematic"),
        ("needed viscosity ν₁", oil.reference_viscosity(reader), "ISO 281, by speed and pitch diameter"),
        ("viscosity ratio κ = ν/ν₁", viscosity_ratio(reader), _MEANINGS["kappa"]),
        ("largest a_ISO at this κ", oil.largest_a_iso(reader), _MEANINGS["largest"]),
    ):
        if value is not None:
            rows.append((label, value, printed(value.unit), meaning))
    for race, film in films(reader).items():
        rows.append((f"smallest film, {race} raceway", film, printed(film.unit), _MEANINGS["film"]))
        if (ratio := film_ratio(reader, race)) is not None:
            rows.append((f"smallest film ratio Λ, {race} raceway", ratio, "", _MEANINGS["ratio"]))
            continue
        value = needed_roughness(reader, race)
        label = f"combined roughness for Λ = {FULL_FILM:g}, {race} raceway"
        rows.append((label, value, printed(value.unit), _MEANINGS["full"]))
    if not rows:
        return
    yield Table("Lubrication", ("quantity", "value", "unit", "meaning"), tuple(rows))
    extrapolated = "oil-temperature" in reader.codes
    if films(reader):
        yield Words((_DIFFER, *([_EXTRAPOLATED] if extrapolated else [])))


def flooded(reader: Reader) -> str:
    """What little oil makes of the films, computed with flooded inlets; empty where they have the oil."""
    text = next((note["text"] for note in reader.attributes["notes"] if note["code"] == "flooding"), "")
    return f"{text[0].upper()}{text[1:]}." if text else ""


def viscosity_ratio(reader: Reader) -> Number | None:
    """Viscosity ratio of ISO 281; None without an oil, or at rest."""
    found = ratings.viscosity_ratio(reader)
    return None if found is None else reader.units.number(found[0], "", "", ".3g", found[1])


def films(reader: Reader) -> dict[str, Number]:
    """Smallest film of each raceway that has one."""
    known = reader.summary.get(reader.last, {}).get("minimum_film_um") or {}
    path = f"summary/{reader.last}/minimum_film_um"
    return {
        race: reader.units.number(film, "um", "um", ".3f", f"{path}/{race}")
        for race, film in known.items() if film
    }  # fmt: skip


def film_ratio(reader: Reader, race: str) -> Number | None:
    """Smallest film ratio of a raceway; None without roughness."""
    found = reader.summary[reader.last].get("minimum_lambda") or {}
    if found.get(race) is None:
        return None
    return reader.units.number(found[race], "", "", ".2f", f"summary/{reader.last}/minimum_lambda/{race}")


def needed_roughness(reader: Reader, race: str) -> Number:
    """Combined roughness with which the smallest film of a raceway is full."""
    film = reader.summary[reader.last]["minimum_film_um"][race]
    path = f"part/{FULL_FILM!r}/summary/{reader.last}/minimum_film_um/{race}"
    return reader.units.number(film / FULL_FILM, "um", "um", ".3f", path)
