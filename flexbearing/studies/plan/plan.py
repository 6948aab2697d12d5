"""The plan of a study, a frozen value: every variant with its identity, and what is wrong with it."""

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import islice
from typing import Any

from flexbearing.case import BadCase
from flexbearing.case.declarations import toml
from flexbearing.case.problems import MOST
from flexbearing.printable import excerpt
from flexbearing.studies.file import Axis, Study
from flexbearing.studies.file.columns import Crossed
from flexbearing.studies.plan.checked import CheckedVariants
from flexbearing.studies.plan.corners import share_levels
from flexbearing.studies.plan.task import Base, Corners, Ring, Task, Values, Variant

LARGEST, LARGEST_ELASTIC = 128, 256  # variants of a task: up to 1 s of work
FEWEST = 8  # tasks into which a small study is cut, so that several workers have some
# Side by side between elastic rings most variants of a task start from solved neighbours in it; the first
# ones have none. Otherwise a task of more than ENOUGH is at most this part of a worker's share.
ENOUGH, OF_LARGE = 16, 8
LONGEST = 300  # characters of the settings of a variant in a message
CHECKED_AT_ONCE = 256  # variants, a tenth of a second of work
MADE_ONCE = 50_000  # variants of a plan, some 50 MB; more are made anew whenever they are read
MOST_PROBLEMS = 200  # after which the other variants are not checked: a refused one takes ten times as long


@dataclass(frozen=True)
class Impossible:
    """The message about values that make no case, or one that cannot be computed."""

    why: str  # one line


@dataclass(frozen=True, slots=True)
class Problem:
    """A variant that cannot be computed as it stands."""

    number: int  # of the variant, from 0
    message: str


@dataclass(frozen=True)
class Plan:
    """What a study computes."""

    name: str
    base: Base
    axes: tuple[Axis, ...]
    variants: Sequence[Variant]  # row by row
    problems: tuple[Problem, ...]
    corners: tuple[Corners, ...] = ()  # where levels are chosen that variants share
    fewest: int = FEWEST  # tasks into which a small study is cut
    side_by_side: bool = False  # whether the variants of a task are solved together
    in_cells: bool = False  # whether contacts of a variant are divided into cells, which takes far longer
    unchecked: int = 0  # variants, after so many that cannot be computed that the study is refused anyway

    def tasks(self, wanted: Callable[[Variant], bool]) -> tuple[Task, ...]:
        """Bundle variants, each identity once, those between the same rings together.

        Tasks do not depend on what is still wanted: numbers of variants solved side by side depend on their
        neighbours in the last digits, so that a task is computed whole or not at all.
        """
        groups: dict[tuple[tuple[str, ...], str], dict[str, Variant]] = {}
        for variant in self.computed:
            groups.setdefault((variant.rings, variant.levels), {})[variant.identity] = variant
        total = sum(map(len, groups.values()))
        bundles = (
            bundle
            for (rings, _), group in groups.items()
            for bundle in _bundles([*group.values()], self._size(total, elastic=bool(rings)))
        )
        chosen = ((bundle, tuple(filter(wanted, bundle))) for bundle in bundles)
        whole = self.side_by_side
        return tuple(Task(self.base, bundle if whole else some) for bundle, some in chosen if some)

    def _size(self, total: int, *, elastic: bool) -> int:
        """Most variants of a task, so that little is lost when one of them ends a worker."""
        share = -(-total // self.fewest)
        if not elastic:
            return min(LARGEST, share)
        if self.side_by_side:
            return min(LARGEST_ELASTIC, max(LARGEST, share // OF_LARGE))
        return min(LARGEST_ELASTIC, max(ENOUGH, share // OF_LARGE), share)

    @property
    def computed(self) -> Iterator[Variant]:
        """Variants that are not idle."""
        return (variant for variant in self.variants if variant.idle is None)

    @property
    def sizes(self) -> list[tuple[bool, int, int]]:
        """Whether rings are elastic, how many variants and how many tasks, for all with the same rings."""
        groups = Counter((each.rings, each.levels) for each in self.computed)
        return [
            (bool(rings), count, -(-count // self._size(groups.total(), elastic=bool(rings))))
            for (rings, _), count in groups.items()
        ]

    def rings(self, wanted: Callable[[Variant], bool] = lambda variant: True) -> tuple[Ring, ...]:
        """Elastic rings of variants that are still wanted, each once."""
        found: dict[str, Ring] = {}
        for variant in filter(wanted, self.variants):
            for name in variant.rings:
                found.setdefault(name, Ring(self.base, variant, name))
        return tuple(found.values())

    def choices(self, wanted: Callable[[Variant], bool]) -> tuple[Corners, ...]:
        """Where the levels of variants that are still wanted are chosen."""
        names = {variant.levels for variant in filter(wanted, self.variants)}
        return tuple(corners for corners in self.corners if corners.name in names)

    def settings(self, number: int) -> str:
        """Values of a variant in words, for messages."""
        values = zip(self.base.keys, self.variants[number].values, strict=True)
        return ", ".join(f"{key} = {excerpt(_in_words(value))}" for key, value in values if value is not None)

    def require_sound(self) -> None:
        """Refuse a study with variants that cannot be computed.

        Raises `BadCase`, a line for each of the first ones that differ, and how many there are.
        """
        if not self.problems:
            return
        alike: dict[str, list[Problem]] = {}
        for problem in self.problems:
            alike.setdefault(problem.message, []).append(problem)
        lines = [self.message_of(first, others=len(rest)) for first, *rest in islice(alike.values(), MOST)]
        raise BadCase("\n".join([*lines, f"{self.name}: {self.count_of_problems}; none was."]))

    @property
    def count_of_problems(self) -> str:
        """How many variants cannot be computed, and of how many; empty where all can."""
        if not self.problems:
            return ""
        count = f"{len(self.problems)} of {len(self.variants)} variants cannot be computed"
        return f"{count}, {self.unchecked} more were not checked" if self.unchecked else count

    def message_of(self, problem: Problem, *, others: int = 0) -> str:
        """Line about a variant that cannot be computed, and how many others have the same message."""
        settings = excerpt(self.settings(problem.number), LONGEST)
        more = f" and {others} others" if others else ""
        return f"{self.name}: variant {problem.number + 1} ({settings}){more}: {problem.message}"


def plan(
    study: Study,
    checked: Callable[[Base, Sequence[Values]], Iterable[Variant | Impossible]],
    mapped: Callable[..., Iterable[Any]] = map,
    tell: Callable[[int, int], None] = lambda done, total: None,
) -> Plan:
    """Settle what a study computes."""
    base, rows = (
        Base(study.case.resolve(), study.text, study.keys, study.settings),
        Crossed(tuple(axis.rows for axis in study.axes)),
    )
    variants, problems = CheckedVariants(rows), list[Problem]()
    for found in mapped(partial(checked, base), _cut(rows)):
        for each in found:
            if isinstance(each, Impossible):
                problems.append(Problem(len(variants), each.why))
            variants.append(None if isinstance(each, Impossible) else each)
        tell(len(variants), len(rows))
        if len(problems) >= MOST_PROBLEMS:
            break
    unchecked = len(rows) - len(variants)
    corners = () if unchecked else share_levels(base, variants)
    few = tuple(variants) if len(rows) <= MADE_ONCE else variants
    return Plan(study.name, base, study.axes, few, tuple(problems), corners, unchecked=unchecked)


def _cut(rows: Iterable[Values]) -> Iterator[list[Values]]:
    left = iter(rows)
    while some := list(islice(left, CHECKED_AT_ONCE)):
        yield some


def _bundles(group: list[Variant], size: int) -> Iterator[tuple[Variant, ...]]:
    for first in range(0, len(group), size):
        yield tuple(group[first : first + size])


def _in_words(value: Any) -> str:
    return value if isinstance(value, str) else toml(value)


MOST_PARTS = 100_000  # parts
_TEXT = re.compile(r"([0-9]{1,6})/([0-9]{1,6})")


@dataclass(frozen=True)
class Part:
    """One of several parts, counted from 1."""

    number: int
    of: int

    @classmethod
    def parsed(cls, text: str) -> "Part":
        """Read "3/8".

        Raises `BadCase` for another text, or a part that there is not.
        """
        found = _TEXT.fullmatch(text)
        number, of = map(int, found.groups()) if found else (0, 0)
        if not 1 <= number <= of <= MOST_PARTS:
            raise BadCase(
                f"--part {excerpt(text)}: a part is k/N with k from 1 to N <= {MOST_PARTS}, such as 3/8"
            )
        return cls(number, of)

    def __str__(self) -> str:
        return f"part-{self.number}-of-{self.of}"

    def variants(self, tasks: tuple[Task, ...]) -> tuple[Variant, ...]:
        """Variants of this part: neighbouring tasks, so that most rings belong to one part."""
        first, last = ((number * len(tasks)) // self.of for number in (self.number - 1, self.number))
        return tuple(variant for task in tasks[first:last] for variant in task.variants)
