"""What is handed to workers, and what they hand back."""

from collections.abc import Mapping, Set
from dataclasses import dataclass, field, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

from flexbearing.case import Head
from flexbearing.case.head import digests
from flexbearing.findings.row import RowFinding, words
from flexbearing.quantities.attributes import FORMAT

CONVERGED, BAD_INPUT, WORKER_DIED, ERROR = "converged", "bad input", "worker died", "error"
NOT_STORED = "not stored"  # the result file of a variant: that ends the study
NOT_COMPUTED = "not computed"  # status of a row whose variant is still to come
NO_DAMAGE = "no damage"  # a row of a duty cycle that is idle; it is not computed
RATED = "rated"  # a row of a duty cycle with a life by ratings, whose equilibrium was not found
ANSWERED = CONVERGED, NO_DAMAGE, RATED
Values = tuple[Any, ...]  # of the keys of a study, in the words of a case file


@dataclass(frozen=True)
class Base:
    """The case file that variants are made of."""

    path: Path
    text: str
    keys: tuple[str, ...]  # that vary
    settings: tuple[str, ...] = ()  # "key=value" of every variant


@dataclass(frozen=True, slots=True)
class Idle:
    """A row of a duty cycle that is time without damage."""

    why: str
    speed: float  # of the inner ring against the outer one [rad/s]


@dataclass(frozen=True, slots=True)
class Variant:
    """One row of the table."""

    values: Values
    identity: str
    rings: tuple[str, ...] = ()  # race and digest of its elastic rings, "outer 5f3a..."
    levels: str = ""  # names the levels that it shares with others; empty without accuracy.target
    in_si: tuple[Any, ...] = ()  # the values as its case has them; none where it cannot be read
    idle: Idle | None = None  # then there is nothing to compute
    thin: str = ""  # why its a_ISO is the least one, where the oil is too thin for ISO 281; else empty


def file_name(variant: Variant, *, final: bool) -> str:
    """Name of the result file of a variant, where there is one; another one for end states alone."""
    return f"{variant.identity[:12]}{'_final' if final else ''}.h5"


@dataclass(frozen=True, eq=False)
class Task:
    """Variants between the same rings, which one worker computes."""

    base: Base
    variants: tuple[Variant, ...]
    levels: Any = None  # that they share; None without accuracy.target

    @property
    def halves(self) -> tuple["Task", ...]:
        """The same variants in two tasks; one variant in one."""
        middle = (len(self.variants) + 1) // 2
        parts = self.variants[:middle], self.variants[middle:]
        return tuple(replace(self, variants=part) for part in parts if part)


@dataclass(frozen=True, eq=False)
class Ring:
    """An elastic ring, which one worker condenses for all."""

    base: Base
    variant: Variant  # one that has it
    name: str  # among its rings

    @property
    def race(self) -> str:
        """Which raceway it carries."""
        return self.name.partition(" ")[0]


@dataclass(frozen=True, eq=False)
class Corners:
    """Variants at which the levels are chosen that others share with them."""

    base: Base
    variants: tuple[Variant, ...]
    name: str  # of the levels


Call = Task | Ring | Corners  # the argument of a call


def names(call: Call) -> tuple[str, ...]:
    """Identities of variants that are computed, or the name of what is made for several."""
    return tuple(each.identity for each in call.variants) if isinstance(call, Task) else (call.name,)


def involves(call: Call, suspects: Set[str]) -> bool:
    """Whether a call computes something that has one of some names, or variants between such rings."""
    rings = [ring for each in call.variants for ring in each.rings] if isinstance(call, Task) else ()
    return not suspects.isdisjoint((*names(call), *rings))


@dataclass(frozen=True)
class Row:
    """How a variant ended."""

    identity: str
    status: str  # an end of a run, or `BAD_INPUT`, `WORKER_DIED`, `ERROR`, `NOT_STORED`
    message: str  # one line: why there is no result; empty where there is one
    seconds: float
    values: Mapping[str, float] = field(default_factory=dict)  # by names of outputs; absent: not known
    findings: tuple[RowFinding, ...] = ()  # what its numbers exceed or lack
    own_run: str = ""  # why it was not solved beside others; empty where it was, or nothing is
    complaints: tuple[str, ...] = ()  # of its worker, about the cache of rings; not kept in a journal

    @property
    def why(self) -> str:
        """Why it has no result, or lacks numbers: its message and its findings in words."""
        return "; ".join(filter(None, (self.message, words(self.findings))))

    @property
    def converged(self) -> bool:
        """Whether the variant has its numbers, or needs none."""
        return self.status in ANSWERED


@dataclass(frozen=True)
class Condensed:
    """What became of a ring, or of a choice of levels."""

    levels: Any = None  # that are chosen; None of a ring
    complaints: tuple[str, ...] = ()  # as of a row


NAMES = {"report"}  # names on a page, on which no number depends
LENGTH = 32  # characters that are kept, 128 bits


def identity(case: Head) -> str:
    """Digest of the format of results and of a complete case in SI units as JSON, keys in their order."""
    text = f"{FORMAT} {case.model_dump_json(exclude=NAMES)} {digests(case)}"
    return sha256(text.encode()).hexdigest()[:LENGTH]
