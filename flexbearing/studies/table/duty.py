"""The cumulated life of a duty cycle, and the share of each row in its damage."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from flexbearing.studies.file.spectrum import Spectrum
from flexbearing.studies.plan import Row
from flexbearing.studies.plan.task import CONVERGED
from flexbearing.studies.table.collected import of_error
from flexbearing.studies.table.column import Column
from quasidynamic.outcome.load_spectrum import (
    cumulated_life,
    cumulated_life_error,
    damage,
    mean_speed,
    revolution_shares,
    time_shares,
)

RPM, HOUR, MREV = pi / 30, 3600.0, 1e6
RACEWAYS = {"inner": "raceway_life.inner [Mrev]", "outer": "raceway_life.outer [Mrev]"}
INCOMPLETE = "rows not solved"  # status of a cycle


@dataclass(frozen=True)
class Cycles:
    """The same duty cycle of several bearings: C cycles of N rows each."""

    spectrum: Spectrum
    speed: NDArray  # (C, N) of the inner ring against the outer one [rad/s]
    rows: Sequence[Sequence[Row]]  # C of N
    errors: Collection[str] = ()  # estimates that rows have, by the texts that name them

    @property
    def texts(self) -> Mapping[str, str]:
        """Outputs that are cumulated, by the words of their columns."""
        return texts(self.spectrum)

    @property
    def shares_of_time(self) -> NDArray:
        """Of each row (C, N); the sum is 1."""
        shares = np.broadcast_to(self.spectrum.shares, self.speed.shape)
        return shares if self.spectrum.measure == "time" else time_shares(shares, self.speed)

    @property
    def shares_of_revolutions(self) -> NDArray:
        """Of each row (C, N); the sum is 1."""
        shares = np.broadcast_to(self.spectrum.shares, self.speed.shape)
        return shares if self.spectrum.measure == "revolutions" else revolution_shares(shares, self.speed)

    def _numbers(self, text: str) -> NDArray:
        """Numbers (C, N) of the rows; NaN where one has none."""
        return np.array([[row.values.get(text, np.nan) for row in cycle] for cycle in self.rows], dtype=float)

    @property
    def complete(self) -> NDArray:
        """Whether all rows (C) of a cycle that take time have an answer."""
        counts = np.array(self.spectrum.shares) > 0
        solved = np.array([[row.status == CONVERGED for row in cycle] for cycle in self.rows])
        return np.all(solved | ~counts, axis=1)

    def of_rows(self) -> Iterator[Column]:
        """Columns of the table of variants, C N long: shares of time, revolutions and damage."""
        yield _column("time_share", "%", 100 * self.shares_of_time)
        yield _column("revolution_share", "%", 100 * self.shares_of_revolutions)
        for words, text in self.texts.items():
            each = self._damage(text)
            with np.errstate(invalid="ignore"):  # no load, no damage
                yield _column(f"{words}damage_share", "%", 100 * each / each.sum(axis=1, keepdims=True))

    def of_cycles(self) -> Iterator[Column]:
        """Columns of the table of cycles, C long: lives in revolutions and hours, mean speed, ends."""
        speed, complete = mean_speed(self.shares_of_time, self.speed), self.complete
        for words, text in self.texts.items():
            life = np.where(complete, cumulated_life(self.shares_of_revolutions, self._counted(text)), np.nan)
            yield _column(f"{words}life", "h", life * 2 * pi / speed / HOUR)
            yield _column(f"{words}revolutions", "Mrev", life / MREV)
            if of_error(text) in self.errors:
                yield _column(f"{words}life error", "%", np.where(complete, self._error(text), np.nan))
        yield _column("mean_speed", "rpm", speed / RPM)
        yield Column("status", "", tuple(CONVERGED if each else INCOMPLETE for each in complete))
        yield Column("message", "", tuple(map(self._message, range(len(self.rows)))))
        yield Column("seconds", "", tuple(sum(row.seconds for row in cycle) for cycle in self.rows))

    def _damage(self, text: str) -> NDArray:
        return damage(self.shares_of_revolutions, self._counted(text))

    def _counted(self, text: str) -> NDArray:
        """Lives (C, N) [rev] of the rows that take time; the others do no damage."""
        return np.where(np.array(self.spectrum.shares) > 0, self._numbers(text) * MREV, np.inf)

    def _error(self, text: str) -> NDArray:
        """Estimated error (C) of the cumulated life, in percent of it."""
        return cumulated_life_error(
            self.shares_of_revolutions, self._counted(text), self._numbers(of_error(text))
        )

    def _message(self, cycle: int) -> str:
        counts = zip(self.rows[cycle], self.spectrum.shares, strict=True)
        failed = [number for number, (row, share) in enumerate(counts, 1) if share and not row.converged]
        return f"not solved: row {', '.join(map(str, failed))}" if failed else ""


def texts(spectrum: Spectrum) -> dict[str, str]:
    """Outputs that are cumulated, by the words of their columns: the bearing, and each raceway."""
    return {"": f"{spectrum.life} [Mrev]"} | {f"{race}_": text for race, text in RACEWAYS.items()}


def _column(name: str, unit: str, values: NDArray) -> Column:
    return Column(name, unit, tuple(values.ravel().tolist()))
