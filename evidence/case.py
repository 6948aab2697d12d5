"""What one case of evidence declares, and what it finds."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

from matplotlib.figure import Figure


@dataclass(frozen=True, kw_only=True)
class Number:
    """A known number beside ours."""

    name: str
    known: float
    ours: float
    unit: str = ""
    allowed: float = 0.0  # digits and scatter of the source, error of our grid
    scale: float = 0.0  # misfits are shares of it; without it of the known number

    @property
    def misfit(self) -> float:
        """Ours less the known one, over the scale [-]."""
        return (self.ours - self.known) / (self.scale or abs(self.known))

    @property
    def within(self) -> bool:
        """Whether they are no further apart than allowed."""
        return abs(self.ours - self.known) <= self.allowed * (1 + 1e-12)


@dataclass(frozen=True, kw_only=True)
class Trend:
    """A known statement on several numbers of ours, without numbers of the source."""

    statement: str  # as the source has it
    places: tuple[str, ...]  # where ours were computed
    ours: tuple[float, ...]
    holds: bool
    unit: str = ""


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """An error of ours, estimated."""

    name: str
    value: float
    unit: str = ""


@dataclass(frozen=True, kw_only=True)
class Findings:
    """What a case computed."""

    numbers: tuple[Number, ...] = ()
    trends: tuple[Trend, ...] = ()
    errors: tuple[Estimate, ...] = ()


@dataclass(frozen=True, kw_only=True)
class Case:
    """One page of evidence."""

    name: str  # of the page
    title: str
    subject: str  # heading in the index
    source: str  # of what is known
    known: str  # what it is, in words
    run: str  # what was computed, in words
    numbers_from: str  # the file that holds the printed numbers
    compute: Callable[[], Findings]
    error: str  # how the error of ours is known
    case_files: tuple[str, ...] = ()
    reason: str = ""  # why ours differ, as far as it is known
    chosen: str = ""  # by us, of what the source does not give and the statements hang on: no test then
    moves: float = 1e-3  # share of a number by which it may move before the check fails
    draw: Callable[[Findings], Figure] | None = None
    caption: str = ""
    slow: bool = False  # above half a second to compute: `make test-slow` does; none takes ten seconds
    remarks: str = ""

    @property
    def module(self) -> str:
        """File that computes it."""
        return self.compute.__module__.replace(".", "/") + ".py"


def number(
    name: str, known: float, ours: float, unit: str = "", *, digit: float = 0.0, share: float = 0.0
) -> Number:
    """A number that may be off by `digit`, or by a share of it, whichever is more."""
    allowed = max(digit, share * abs(float(known)))
    return Number(name=name, known=float(known), ours=float(ours), unit=unit, allowed=allowed)


def numbers(
    names: Iterable[str],
    known: Iterable[float],
    ours: Iterable[float],
    unit: str = "",
    *,
    digit: float = 0.0,
    share: float = 0.0,
) -> tuple[Number, ...]:
    """Several numbers of one source."""
    return tuple(number(*row, unit, digit=digit, share=share) for row in zip(names, known, ours, strict=True))


def over(scale: float, rows: Iterable[Number]) -> tuple[Number, ...]:
    """Numbers whose misfits are shares of one scale."""
    return tuple(replace(row, scale=float(scale)) for row in rows)


def trend(
    statement: str, places: Iterable[object], ours: Iterable[float], holds: object, unit: str = ""
) -> Trend:
    """A statement of a source, and ours at some places."""
    values = tuple(float(value) for value in ours)
    return Trend(
        statement=statement, places=tuple(map(str, places)), ours=values, holds=bool(holds), unit=unit
    )


def rounding(name: str, left: float, scale: float, unit: str, allowed: float = 1e-9) -> Number:
    """Something that must vanish, but for a share of a scale that rounding and the solver leave."""
    return Number(
        name=name, known=0.0, ours=float(left), unit=unit, allowed=allowed * float(scale), scale=float(scale)
    )


def estimate(name: str, value: float, unit: str = "") -> Estimate:
    """An error of ours."""
    return Estimate(name=name, value=float(value), unit=unit)
