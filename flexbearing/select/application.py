"""What a bearing is selected for: loads and speeds with their shares, and the life that they must leave."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.declarations import Declaration, find
from flexbearing.catalogue.entries import ENTRIES
from flexbearing.families import FAMILIES
from flexbearing.studies.file.schema import Duty
from flexbearing.studies.file.spectrum import Spectrum, spectrum
from flexbearing.studies.file.values import BadValues
from quasidynamic import OutOfRange
from quasidynamic.outcome.life_factors import reliability_factor
from quasidynamic.outcome.load_spectrum import mean_speed, revolution_shares, time_shares

KEYS = {  # that a spectrum may have, those of both kinds of cases, by the entry of a page that they are
    "operation.radial_load": "load",
    "operation.load.radial_z": "load",
    "operation.load.axial": "axial",
    "operation.inner_speed": "speed",
    "operation.outer_speed": "outer_speed",
}
UNITS = {"load": "N", "axial": "N", "speed": "rad/s", "outer_speed": "rad/s"}


@dataclass(frozen=True)
class Application:
    """Rows (N) of loads and speeds; a single one where nothing varies."""

    rows: Mapping[str, NDArray]  # (N) by entry of a page, in SI units; what none has is missing
    spectrum: Spectrum  # shares of the rows, required life, application factor
    reliability: float | None = None  # of that life, 0.9 where not given

    def of(self, entry: str) -> NDArray:
        """Values of an entry in all rows, zero where it is missing."""
        return self.rows.get(entry, np.zeros(len(self.spectrum.shares)))

    def text(self, entry: str, row: int) -> str:
        """An entry of a row as a page has it; empty where it is missing."""
        return f"{float(self.rows[entry][row])!r} {UNITS[entry]}" if entry in self.rows else ""

    @property
    def speed(self) -> NDArray:
        """Speed of the inner ring against the outer one (N) [rad/s]."""
        return self.of("speed") - self.of("outer_speed")

    @property
    def loaded(self) -> NDArray:
        """Rows (N) with a load."""
        return (self.of("load") != 0) | (self.of("axial") != 0)

    @property
    def forces(self) -> Iterator[tuple[float, float]]:
        """Radial and axial load of each row [N], without their signs."""
        yield from zip(*(abs(self.of(name)).tolist() for name in ("load", "axial")), strict=True)

    @cached_property
    def heaviest(self) -> list[int]:
        """Rows of which no other one has both a larger radial and a larger axial load."""
        found, axial = list[int](), -1.0
        rows = list(self.forces)
        for row in sorted(range(len(rows)), key=rows.__getitem__, reverse=True):
            if rows[row][1] > axial:
                found, axial = [*found, row], rows[row][1]
        return found

    @cached_property
    def revolutions(self) -> NDArray:
        """Share of the revolutions of each row (N)."""
        shares = np.array(self.spectrum.shares)
        return shares if self.spectrum.measure == "revolutions" else revolution_shares(shares, self.speed)

    @property
    def mean_speed(self) -> float:
        """Revolutions over the time of all rows, as an angle [rad/s]."""
        by_time = self.spectrum.measure == "time"
        shares = np.array(self.spectrum.shares)
        return float(mean_speed(shares if by_time else time_shares(shares, self.speed), self.speed))

    @property
    def life_factor(self) -> float:
        """Life over the basic one, a_1 of the reliability [-]."""
        return 1.0 if self.reliability is None else float(reliability_factor(self.reliability).value)


def read(
    options: Mapping[str, str],
    file: Path | None,
    required_life: str,
    application_factor: float,
    reliability: float | None,
) -> Application:
    """Read what an application gives: entries of a page, and rows of a table where there are some.

    Raises `BadCase` for what cannot be read, rows that never turn, and reliabilities beyond ISO 281.
    """
    keys = {entry: key for key, entry in reversed(KEYS.items())}
    duty = Duty.model_validate(
        {
            **({"time": (1.0,)} if file is None else {"file": file.name}),
            "required_life": required_life,
            "application_factor": application_factor,
            **{keys[entry]: text for entry, text in options.items()},
        }
    )
    try:
        axis, shares = spectrum(duty, file.parent if file else Path(), _found)
        columns = zip(axis.keys, zip(*axis.rows, strict=True), strict=True)
        rows = _by_entry({key: np.array([_si(key, text) for text in column]) for key, column in columns})
    except BadValues as problem:
        raise BadCase(f"{file or 'select'}: {problem}") from problem
    found = Application(rows, shares, reliability)
    if not (found.loaded & (found.speed != 0)).any():
        needed = ", ".join(ENTRIES[entry].option for entry in ("load", "axial", "speed"))
        raise BadCase(f"no row has a load while one ring turns against the other; give {needed}.")
    try:
        assert found.life_factor
    except OutOfRange as problem:
        raise BadCase(f"--reliability: {problem}.") from None
    return found


def _found(key: str) -> Declaration:
    """The declaration of a key that a spectrum may have."""
    if key not in KEYS:
        raise BadValues(f"{key} is not read by select; it reads {', '.join(KEYS)}")
    each = (find(key, family.case()) for family in FAMILIES.values())
    return next(declaration for declaration in each if declaration)


def _si(key: str, text: object) -> float:
    kind = _found(key).kind
    assert kind is not None
    try:
        return kind.to_si(text)
    except ValueError as problem:
        raise BadValues(f"{key} = {text!r:.40} {problem}") from None


def _by_entry(columns: Mapping[str, NDArray]) -> dict[str, NDArray]:
    """Columns by entry of a page, of which none may be there by two keys."""
    found = dict[str, NDArray]()
    for key, column in columns.items():
        if KEYS[key] in found:
            raise BadValues(f"{key} is given twice, also by its other name")
        found[KEYS[key]] = column
    return found
