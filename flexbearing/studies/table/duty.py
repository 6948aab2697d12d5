"""The cumulated life of a duty cycle, and the share of each row in its damage."""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import nan, pi, prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.family import Family
from flexbearing.findings import RowFinding
from flexbearing.findings.row import information
from flexbearing.studies.file.spectrum import Spectrum
from flexbearing.studies.plan import Plan, Row, Variant
from flexbearing.studies.plan.task import CONVERGED, NO_DAMAGE, NOT_COMPUTED
from flexbearing.studies.table.collected import of_error
from flexbearing.studies.table.table import Column, ends
from quasidynamic import OutOfRange
from quasidynamic.outcome.load_spectrum import (
    cumulated_life,
    cumulated_life_error,
    damage,
    mean_load,
    mean_speed,
    revolution_shares,
    time_shares,
)
from quasidynamic.outcome.rating_life import rating_life, required_rating

NONE = -1  # of a row that needs no bound, or has none


@dataclass(frozen=True)
class Conditions:
    """What decides whether a row of a cycle bounds another one."""

    loads: NDArray  # (N, L) every load that varies, without its sign
    others: NDArray  # (N) rows with the same number differ in loads alone

    def bounds(self, lives: NDArray) -> NDArray:
        """For each row (C, N) without a life the row whose life is its bound; `NONE` for all others."""
        found = np.full(lives.shape, NONE)
        for cycle, of_rows in enumerate(lives):
            lacking, solved = np.flatnonzero(np.isnan(of_rows)), np.flatnonzero(np.isfinite(of_rows))
            for group in np.unique(self.others[lacking]):
                alike = solved[self.others[solved] == group]
                for row in lacking[self.others[lacking] == group]:
                    found[cycle, row] = self._above(row, alike)
        return found

    def _above(self, row: int, solved: NDArray) -> int:
        """The row with the next higher load among some rows; `NONE` where there is none."""
        more = solved[np.all(self.loads[solved] >= self.loads[row], axis=1)]
        return int(more[np.argmin(np.linalg.norm(self.loads[more], axis=1))]) if more.size else NONE


RPM, HOUR, MREV = pi / 30, 3600.0, 1e6
BASIC, MODIFIED = "life_L10 [Mrev]", "modified_life [Mrev]"
RACEWAYS = {"inner": "raceway_life.inner [Mrev]", "outer": "raceway_life.outer [Mrev]"}
KINDS = {"life_L10": "basic L10", "modified_life": "modified"}
SHOWN = 10  # rows in a message
BOUNDED, LEFT_OUT = "bounded", "rows left out"  # status of a cycle
INCOMPLETE = "no row solved"


@dataclass(frozen=True)
class Catalogued:
    """What a catalogue says of the cycles."""

    loads: NDArray  # (C, N) equivalent load of each row [N]; NaN where it is not known
    exponent: NDArray  # (C) of the loads in the life [-]
    factors: NDArray  # (C, N) life over (C_r/P)^p: a_1 of the reliability, with C_r of the life [-]
    ratings: NDArray  # (C, N) dynamic rating C_r [N]
    life: float | None = None  # that is required [s]
    application_factor: float = 1.0  # on the loads, for the required rating

    def columns(self, revolutions: NDArray, speed: NDArray) -> Iterator[Column]:
        """Mean equivalent load and the life (C/P)^p; where one is required, that life and C for it."""
        yield _column("mean_load", "N", mean_load(revolutions, self.loads, self.exponent))
        yield _column("rating_life", "h", self._rating_life(revolutions) * 2 * pi / speed / HOUR)
        if self.life is not None:
            of_basic_life = (
                self.application_factor * self.loads / self.factors ** (1 / self.exponent[:, None])
            )
            mean = mean_load(revolutions, of_basic_life, self.exponent)
            turns = self.life * speed / (2 * pi) / MREV
            yield _column("required_rating", "N", required_rating(mean, turns, self.exponent))
            yield _column("required_life", "h", np.full(mean.shape, self.life / HOUR))

    def _rating_life(self, revolutions: NDArray) -> NDArray:
        """Life (C) of (C_r/P)^p alone [rev]; NaN where a load is not known."""
        return cumulated_life(
            revolutions, rating_life(self.ratings, self.loads, self.exponent[:, None]) * MREV
        )


@dataclass(frozen=True)
class Cycles:
    """The same duty cycle of several bearings: C cycles of N rows each."""

    spectrum: Spectrum
    speed: NDArray  # (C, N) of the inner ring against the outer one [rad/s]
    rows: Sequence[Sequence[Row]]  # C of N
    errors: Collection[str] = ()  # estimates that rows have, by the texts that name them
    conditions: Conditions | None = None  # of the rows; None: no row bounds another one
    thin: NDArray | None = None  # (C, N) whether a row counts with the least a_ISO
    catalogued: Catalogued | None = None
    kinds: Sequence[str] = ()  # (C) of the lives, in words

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

    @cached_property
    def _without_damage(self) -> NDArray:
        """Rows (C, N) that are idle, or take no time."""
        idle = np.array([[row.status == NO_DAMAGE for row in cycle] for cycle in self.rows])
        return idle | (np.array(self.spectrum.shares) == 0)

    @cached_property
    def _lives(self) -> Mapping[str, "_Lives"]:
        """Lives of all rows, by the words of their columns."""
        return {words: self._counted(text) for words, text in self.texts.items()}

    def _counted(self, text: str) -> "_Lives":
        own = np.where(self._without_damage, np.inf, self._numbers(text) * MREV)
        bounds = np.full(own.shape, NONE) if self.conditions is None else self.conditions.bounds(own)
        taken = np.take_along_axis(own, np.maximum(bounds, 0), axis=1)
        return _Lives(np.where(bounds == NONE, own, taken), bounds)

    @property
    def _bounded(self) -> NDArray:
        """Rows (C, N) whose damage is a bound."""
        by_others = self._lives[""].bounds != NONE
        return by_others if self.thin is None else by_others | (self.thin & ~self._without_damage)

    def of_rows(self) -> Iterator[Column]:
        """Columns of the table of variants, C N long: shares of time, revolutions and damage."""
        yield _column("time_share", "%", 100 * self.shares_of_time)
        yield _column("revolution_share", "%", 100 * self.shares_of_revolutions)
        for words, lives in self._lives.items():
            each = damage(self.shares_of_revolutions, lives.counted)
            with np.errstate(invalid="ignore"):  # no load, no damage
                yield _column(f"{words}damage_share", "%", 100 * each / each.sum(axis=1, keepdims=True))

    def findings(self) -> Iterator[tuple[RowFinding, ...]]:
        """What a row without a life counts as, C N of them."""
        lives, to_come = self._lives[""], np.repeat(self._to_come, self.speed.shape[1])
        for waits, left_out, bound in zip(to_come, lives.left_out.ravel(), lives.bounds.ravel(), strict=True):
            if left_out and not waits:
                yield (information("left-out", "left out of the life of the cycle"),)
            elif bound != NONE and not waits:
                yield (information("bounded", f"counted with the life of row {bound + 1} of the cycle"),)
            else:
                yield ()

    def of_cycles(self) -> Iterator[Column]:
        """Columns of the table of cycles, C long: lives in revolutions and hours, what they lack, ends."""
        speed = mean_speed(self.shares_of_time, self.speed)
        for words, lives in self._lives.items():
            life = self._life(lives)
            with np.errstate(divide="ignore"):  # a cycle at rest
                yield _column(f"{words}life", "h", life * 2 * pi / speed / HOUR)
            yield _column(f"{words}revolutions", "Mrev", life / MREV)
            if (error := of_error(self.texts[words])) in self.errors:
                of_rows = self._numbers(error)
                known = cumulated_life_error(self.shares_of_revolutions, lives.counted, of_rows)
                yield _column(f"{words}life error", "%", np.where(np.isnan(life), np.nan, known))
        yield from self._shares_of("bounded", self._bounded)
        yield from self._shares_of("left_out", self._lives[""].left_out)
        if self.spectrum.measured:
            yield from self._of_bins()
        yield _column("mean_speed", "rpm", speed / RPM)
        if self.catalogued:
            yield from self.catalogued.columns(self.shares_of_revolutions, speed)
        yield Column("kind", "", tuple(self.kinds or (KINDS[self.spectrum.life],) * len(self.rows)))
        yield from ends([self._end(cycle) for cycle in range(len(self.rows))])

    def _of_bins(self) -> Iterator[Column]:
        """Rows of the time series, and by how much its bins may change the damage, in percent of it."""
        yield Column("series_rows", "", (self.spectrum.measured,) * len(self.rows))
        errors = 100 * np.broadcast_to(self.spectrum.bin_errors, self.speed.shape)
        lives = self._lives[""].counted
        yield _column("binning_error", "%", cumulated_life_error(self.shares_of_revolutions, lives, errors))

    def _life(self, lives: "_Lives") -> NDArray:
        """Life (C) [rev] of all rows; NaN where none has one, or more is left out than of `life`."""
        none = lives.left_out.any(axis=1) & np.isinf(lives.counted).all(axis=1)
        others = np.any(lives.left_out & ~self._lives[""].left_out, axis=1)
        return np.where(
            none | others | self._to_come, np.nan, cumulated_life(self.shares_of_revolutions, lives.counted)
        )

    @cached_property
    def _to_come(self) -> NDArray:
        """Whether rows of a cycle (C) are still to be computed."""
        return np.array([any(row.status == NOT_COMPUTED for row in cycle) for cycle in self.rows])

    def _shares_of(self, words: str, which: NDArray) -> Iterator[Column]:
        for name, shares in (("time", self.shares_of_time), ("revolution", self.shares_of_revolutions)):
            yield _column(f"{words}_{name}_share", "%", 100 * (shares * which).sum(axis=1))

    def _end(self, cycle: int) -> Row:
        """How a cycle ended, as a row."""
        seconds = sum(row.seconds for row in self.rows[cycle])
        if self._to_come[cycle]:
            return Row("", NOT_COMPUTED, "rows are not computed yet", seconds)
        return Row("", self._status(cycle), "", seconds, findings=tuple(self._lacking(cycle)))

    def _status(self, cycle: int) -> str:
        lives = self._lives[""]
        life = self._life(lives)[cycle]
        if np.isnan(life):
            return INCOMPLETE
        if np.isinf(life):
            return NO_DAMAGE
        if lives.left_out[cycle].any():
            return LEFT_OUT
        return BOUNDED if self._bounded[cycle].any() else CONVERGED

    def _lacking(self, cycle: int) -> Iterator[RowFinding]:
        """Rows of a cycle that are left out or bounded."""
        left_out, bounded = self._lives[""].left_out[cycle], self._bounded[cycle]
        shares = 100 * self.shares_of_time[cycle]
        for code, what, rows in (("left-out", "left out", left_out), ("bounded", "damage bounded", bounded)):
            if rows.any():
                those = f"row{'s' * int(rows.sum() > 1)} {_listed(rows)}"
                yield information(code, f"{what}: {those}, {shares[rows].sum():.3g} % of the time")


@dataclass(frozen=True)
class _Lives:
    """Lives (C, N) of all rows of the cycles."""

    own_or_bound: NDArray  # [rev]; NaN of a row that is left out
    bounds: NDArray  # the row of the cycle whose life counts, NONE where it is its own

    @property
    def left_out(self) -> NDArray:
        """Rows whose damage is not known."""
        return np.isnan(self.own_or_bound)

    @property
    def counted(self) -> NDArray:
        """Lives, infinite of what is left out."""
        return np.where(self.left_out, np.inf, self.own_or_bound)


def texts(spectrum: Spectrum) -> dict[str, str]:
    """Outputs that are cumulated, by the words of their columns: the bearing, and each raceway."""
    life = {"": f"{spectrum.life} [Mrev]"}
    basic = {} if BASIC in life.values() else {"basic_": BASIC}
    return life | basic | {f"{race}_": text for race, text in RACEWAYS.items()}


def _column(name: str, unit: str, values: NDArray) -> Column:
    return Column(name, unit, tuple(values.ravel().tolist()))


def _listed(rows: NDArray) -> str:
    """Numbers of the first rows of some."""
    numbers = np.flatnonzero(rows) + 1
    return ", ".join(map(str, numbers[:SHOWN])) + (
        f" and {len(numbers) - SHOWN} more" * (len(numbers) > SHOWN)
    )


LOADS = "operation.radial_load", "operation.moment", "operation.load."  # keys, and a table of balls
IDLE = 0.0, 1.0, 1.0, 1.0  # load, a_1, exponent, C_r of a row without damage; other exponents are larger


def is_load(key: str) -> bool:
    """Whether a key is a load of the bearing."""
    return key.startswith(LOADS)


def duty_cycles(
    plan: Plan,
    spectrum: Spectrum,
    rows: Sequence[Row],
    speeds: NDArray,
    errors: Collection[str],
    catalogue: Catalogued | None,
) -> Cycles:
    """The cycle of each bearing, from the rows and speeds of all variants of a plan."""
    length = len(plan.axes[-1].rows)
    return Cycles(
        spectrum,
        speeds.reshape(-1, length),
        [rows[first : first + length] for first in range(0, len(rows), length)],
        errors,
        conditions(plan.base.keys, plan.variants[:length]),
        np.array([bool(each.thin) for each in plan.variants]).reshape(-1, length),
        catalogue,
    )


def life_kinds(plan: Plan, spectrum: Spectrum, case_of: Callable[[Variant], Any]) -> Iterator[str]:
    """What life each cycle has: by the case of its first row that is computed."""
    length = len(plan.axes[-1].rows)
    for first in range(0, len(plan.variants), length):
        computed = [each for each in plan.variants[first : first + length] if not each.idle]
        life = case_of(computed[0]).life if computed else None
        if life is None or life.loads != "rating" or spectrum.life == "life_L10":
            yield KINDS[spectrum.life]
        else:
            yield "modified catalogue" if life.lubrication or life.reliability else "catalogue L10"


def catalogued(
    plan: Plan, family: Family, spectrum: Spectrum, case_of: Callable[[Variant], Any]
) -> Catalogued | None:
    """Loads and factors of the lives of all variants; None of kinds without, or where no load is known."""
    if family.catalogue is None:
        return None
    of = family.catalogue()
    each = [IDLE if variant.idle else rated(of, case_of(variant)) for variant in plan.variants]
    loads, factors, exponents, ratings = np.array(each).T.reshape(4, -1, len(plan.axes[-1].rows))
    if not np.any(loads > 0):
        return None
    exponent = exponents.max(axis=1)
    return Catalogued(loads, exponent, factors, ratings, spectrum.required, spectrum.application_factor)


def rated(catalogue: Any, case: Any) -> tuple[float, float, float, float]:
    """Equivalent load [N], NaN where not known beforehand, life over (C_r/P)^p, p, and C_r [N].

    That factor is a_1 of the reliability, with a C_r that leaves the stress reduction out.
    """
    from flexbearing.life.life_of_state import of_reliability

    rated, factors = catalogue.rated(case), of_reliability(case.life.reliability)
    factor = rated.rating_factor**rated.power * prod(float(each.value) for each in factors)
    return _known(lambda: rated.load().value), factor, rated.power, _known(lambda: rated.dynamic)


def _known(quantity: Callable[[], float]) -> float:
    """A quantity; NaN out of the range of its formula."""
    try:
        return quantity()
    except OutOfRange:
        return nan


def conditions(keys: Sequence[str], rows: Sequence[Variant]) -> Conditions:
    """Loads of the rows of a cycle, and which rows differ in nothing else."""
    loads = [number for number, key in enumerate(keys) if is_load(key)]
    others = [str([value for n, value in enumerate(row.in_si) if n not in loads]) for row in rows]
    values = np.array([[abs(row.in_si[number] or 0.0) for number in loads] for row in rows], dtype=float)
    return Conditions(values.reshape(len(rows), len(loads)), np.unique(others, return_inverse=True)[1])
