"""Notes on limits that are not kept, and values that bearings of all families are judged by."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexbearing import findings
from flexbearing.findings import DANGER, OUTSIDE, USUAL, Judged
from quasidynamic.note import Grade, Note

ROUNDING = 1e-9  # of the largest stiffness: what rounding leaves of nothing
RACES = ("inner raceway", "outer raceway")  # places
_GRADES: dict[str, Grade] = {DANGER: "danger", OUTSIDE: "outside validity", USUAL: "information"}


def notes(judged: Iterable[Judged], case: int = 0) -> tuple[Note, ...]:
    """A note for each code whose limit a case does not keep, in the order of the findings."""
    broken = [each for each in judged if each.finding.noted and each.broken[case]]
    return tuple(
        Note(_GRADES[worst.grade], worst.code, _text(worst, places), _keys(worst))
        for worst, places in findings.by_code(findings.records(broken, case))
    )


def _keys(record: findings.Record) -> tuple[tuple[str, str], ...]:
    return findings.of_code(record.code, record.grade).keys


def _text(record: findings.Record, places: Sequence[str]) -> str:
    assert record.limit is not None  # it is not kept
    finding = findings.of_code(record.code, record.grade)
    return findings.text(finding, [record.value], record.limit, places, record.source)


def pressures(largest: Iterable[Any], limit: float) -> dict[str, Any]:
    """Contact pressure of both raceways [Pa], and that of the static rating."""
    return {"contact_pressure": dict(zip(RACES, largest, strict=True)), "static_pressure": limit}


def seconds(life: ArrayLike, speed: ArrayLike) -> Any:
    """Time [s] that a life [10^6 revolutions] lasts at a speed of one ring against the other [rad/s]."""
    with np.errstate(divide="ignore"):
        return 1e6 * 2 * np.pi * np.asarray(life) / np.abs(speed)


def lives(life: ArrayLike, speed: ArrayLike, required: Iterable[float | None]) -> dict[str, Any]:
    """The most detailed life [10^6 revolutions] as time [s], and that of cases which require one."""
    lasting, wanted = seconds(life, speed), np.array(list(required), dtype=float)  # None is NaN
    return {
        "life": lasting,
        "life_to_reach": np.where(np.isnan(wanted), np.nan, lasting),
        "required_life": wanted,
    }


def least_stiffness(matrices: NDArray) -> NDArray:
    """Smallest radial stiffness (C) [N/m] in any direction, of matrices (C, 2, 2) along y and z."""
    each = np.linalg.eigvalsh((matrices + matrices.swapaxes(1, 2)) / 2)
    return np.where(np.abs(each[:, 0]) <= ROUNDING * np.abs(each[:, 1]), 0.0, each[:, 0])


def clearances(record: Mapping[str, Any]) -> dict[str, float]:
    """Diametral clearance as computed, and at the tight end of the tolerances [m]."""
    ends = record.get("tolerances", {}).get("ends")
    tight = {"tight end of the tolerances": ends["tightest_m"]} if ends else {}
    return {"as computed": record["operating_m"], **tight}
