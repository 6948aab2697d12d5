"""What a catalogue says of each candidate under the loads of an application, and which one is chosen."""

from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from math import pi
from typing import Any

import numpy as np

from flexbearing.case import BadCase
from flexbearing.catalogue.entries import LIKES
from flexbearing.families import FAMILIES
from flexbearing.findings import Record, evaluate, records
from flexbearing.findings.declared import of_code, of_selection
from flexbearing.findings.words import text as sentence
from flexbearing.life.rated_bearing import LETTERS
from flexbearing.select.application import Application
from flexbearing.select.candidates import Candidate
from flexbearing.studies.table.duty import Catalogued, rated
from quasidynamic import ImpossiblePart, OutOfRange
from quasidynamic.outcome.rating_life import static_safety

HOUR, KN, RPM = 3600.0, 1e3, pi / 30
LIGHT = "light-load"  # code of the finding that the smallest load decides


@dataclass(frozen=True, kw_only=True)
class Rated:
    """A candidate by the formulas of a catalogue."""

    dynamic_rating: float  # C [N]
    static_rating: float  # C_0 [N]
    by_maker: tuple[str, ...]  # letters of those that its table gives; others are of ISO 281 and ISO 76
    mean_load: float  # P_m of all rows [N]
    least_load: float  # of the rows that turn under load [N]
    required_rating: float  # C for the required life [N]
    life: float  # basic life times a_1, at the loads times the application factor [s]
    static_safety: float  # C_0/P_0 of the row with the largest load times the application factor [-]
    row: int  # that does most damage, from 0
    findings: tuple[Record, ...]

    @property
    def broken(self) -> tuple[Record, ...]:
        """What it does not keep."""
        return tuple(each for each in self.findings if each.broken)


@dataclass(frozen=True)
class Card:
    """A candidate, and what a catalogue says of it."""

    candidate: Candidate
    rated: Rated | None = None  # None where it cannot be rated
    why_not: str = ""  # then why

    @property
    def fits(self) -> bool:
        """Whether it keeps every limit."""
        return self.rated is not None and not self.rated.broken

    @property
    def verdict(self) -> str:
        """Why it is no choice, in few words; empty where it is one."""
        if self.rated is None:
            return self.why_not
        return ", ".join(dict.fromkeys(each.code for each in self.rated.broken))


@dataclass(frozen=True)
class Selection:
    """All candidates for an application, the lightest first."""

    application: Application
    cards: tuple[Card, ...]

    @cached_property
    def chosen(self) -> Card | None:
        """The lightest one that keeps every limit."""
        return next((card for card in self.cards if card.fits), None)


def selection(application: Application, candidates: Iterable[Candidate]) -> Selection:
    """Rate all candidates."""
    cards = (_card(each, application) for each in candidates)
    return Selection(application, tuple(sorted(cards, key=lambda card: card.candidate.mass)))


def _card(candidate: Candidate, application: Application) -> Card:
    try:
        return Card(candidate, _rated(candidate, application))
    except (BadCase, ImpossiblePart, OutOfRange) as problem:
        return Card(candidate, why_not=" ".join(str(problem).split()).removesuffix("."))


def _rated(candidate: Candidate, application: Application) -> Rated:
    """Ratings and lives of a candidate.

    Raises `BadCase`, `ImpossiblePart` or `OutOfRange` where it has none.
    """
    offered = FAMILIES[LIKES[candidate.like].kind].catalogue
    if offered is None:
        raise BadCase("no ratings in ISO 281")
    case, catalogue = candidate.case(application), offered()
    page = catalogue.rated(case)
    _, of_life, exponent, dynamic = rated(catalogue, case)
    counts = application.loaded & (application.speed != 0)
    rows = [catalogue.rated(_under(case, *each)) for each in application.forces]
    each = zip(rows, counts, strict=True)
    loads = np.array([under.load().value if counted else 0.0 for under, counted in each])
    at_rest = max(rows[row].static_load().value for row in application.heaviest)
    wanted, factor = application.spectrum.required, application.spectrum.application_factor
    assert wanted is not None
    alike = np.ones((1, loads.size))  # cycles of one bearing
    cycle = Catalogued(loads[None], np.array([exponent]), of_life * alike, dynamic * alike, wanted, factor)
    columns = {
        column.name: float(column.values[0])
        for column in cycle.columns(application.revolutions[None], np.array([application.mean_speed]))
    }
    required, static = columns["required_rating"], page.static
    life = wanted * (dynamic / required) ** exponent
    safety = float(static_safety(static, factor * at_rest))
    values = {
        "life_to_reach": life, "required_life": wanted, "static_safety": safety,
        "dynamic_rating": dynamic, "static_rating": static, "load": factor * loads.max(),
        "speed": float(abs(application.speed).max()),
        "limiting_speed": candidate.limiting_speed, "reference_speed": candidate.reference_speed,
    }  # fmt: skip
    least = float(loads[counts].min())
    judged = of_selection(candidate.rollers)
    found = [
        *evaluate((each for each in judged if each.code != LIGHT), values),
        *evaluate((each for each in judged if each.code == LIGHT), values | {"load": least}),
    ]
    return Rated(
        dynamic_rating=dynamic,
        static_rating=static,
        by_maker=tuple(LETTERS[name] for name in page.given),
        mean_load=columns["mean_load"],
        least_load=least,
        required_rating=required,
        life=life,
        static_safety=safety,
        row=int(np.argmax(application.revolutions * loads**exponent)),
        findings=tuple(records(found)),
    )


def _under(case: Any, radial: float, axial: float) -> Any:
    """The case under other forces [N]."""
    operation = case.operation
    if case.kind == "cylindrical_roller":
        changed = {"radial_load": abs(radial)}
    else:
        load = operation.load.model_copy(update={"radial_z": radial, "axial": axial})
        changed = {"load": load}
    return case.model_copy(update={"operation": operation.model_copy(update=changed)})


def sentences(card: Card) -> list[str]:
    """Each limit that a candidate does not keep, with its numbers."""
    broken = card.rated.broken if card.rated else ()
    finding = [of_code(each.code, each.grade) for each in broken]
    return [
        sentence(of, [each.value], each.limit or 0.0, (), each.source)
        for of, each in zip(finding, broken, strict=True)
    ]


COLUMNS = (
    "designation", "like", "bore [mm]", "outside [mm]", "width [mm]", "mass [kg]", "mass is", "C [kN]",
    "C_0 [kN]", "ratings of the maker", "P_m [kN]", "least P [kN]", "required C [kN]", "life [h]",
    "static safety", "fits", "why not", "source",
)  # fmt: skip


def row(card: Card) -> tuple[Any, ...]:
    """A card as a row of a table."""
    of, rated = card.candidate, card.rated
    numbers: Sequence[Any] = (None,) * 8
    if rated:
        numbers = (
            rated.dynamic_rating / KN, rated.static_rating / KN, " ".join(rated.by_maker),
            rated.mean_load / KN, rated.least_load / KN, rated.required_rating / KN, rated.life / HOUR,
            rated.static_safety,
        )  # fmt: skip
    mass = "estimated" if of.given_mass is None else "given"
    sizes = (1e3 * size for size in of.sizes)
    return (
        of.designation,
        of.like,
        *sizes,
        of.mass,
        mass,
        *numbers,
        "yes" if card.fits else "no",
        card.verdict,
        of.source,
    )


def as_json(found: Selection) -> dict[str, Any]:
    """All cards for other programs, in SI units."""
    chosen = found.chosen
    return {
        "chosen": chosen.candidate.designation if chosen else None,
        "required_life": found.application.spectrum.required,
        "application_factor": found.application.spectrum.application_factor,
        "reliability": found.application.reliability or 0.9,
        "candidates": [
            {
                **asdict(card.candidate),
                "mass": card.candidate.mass,
                "mass_estimated": card.candidate.given_mass is None,
                "fits": card.fits,
                "why_not": card.why_not or "; ".join(sentences(card)),
                "rated": asdict(card.rated) if card.rated else None,
            }
            for card in found.cards
        ],
    }
