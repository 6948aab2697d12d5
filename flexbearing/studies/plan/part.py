"""A part of a study, for queues that run the same command many times with a number."""

import re
from dataclasses import dataclass

from flexbearing.case import BadCase
from flexbearing.printable import excerpt
from flexbearing.studies.plan.task import Task, Variant

MOST = 100_000  # parts
_TEXT = re.compile(r"([0-9]{1,6})/([0-9]{1,6})")


@dataclass(frozen=True)
class Part:
    """One of several parts, counted from 1."""

    number: int
    of: int

    @classmethod
    def parsed(cls, text: str) -> "Part":
        """Read "3/8".

        Raises
        ------
        BadCase
            for another text, or a part that there is not
        """
        found = _TEXT.fullmatch(text)
        number, of = map(int, found.groups()) if found else (0, 0)
        if not 1 <= number <= of <= MOST:
            raise BadCase(f"--part {excerpt(text)}: a part is k/N with k from 1 to N <= {MOST}, such as 3/8")
        return cls(number, of)

    def __str__(self) -> str:
        return f"part-{self.number}-of-{self.of}"

    def variants(self, tasks: tuple[Task, ...]) -> tuple[Variant, ...]:
        """Variants of this part: neighbouring tasks, so that most rings belong to one part."""
        first, last = ((number * len(tasks)) // self.of for number in (self.number - 1, self.number))
        return tuple(variant for task in tasks[first:last] for variant in task.variants)
