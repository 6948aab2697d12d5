"""Lives of a case with other settings, as distances from the wanted one."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import nan

from flexbearing.case import BadCase, Head
from flexbearing.case.family import Family
from flexbearing.goal.approach import Track, look, reach
from flexbearing.goal.levers import Move
from flexbearing.goal.target import Target
from flexbearing.progress import Report
from flexbearing.runs.run_case import answers, reader

Settings = tuple[str, ...]
USUAL = 12  # trials of a move


@dataclass(frozen=True)
class Followed:
    """A move that was followed towards the wanted life."""

    move: Move
    track: Track

    @property
    def reaches(self) -> bool:
        """Whether it gets there."""
        return self.track.root is not None

    @property
    def place(self) -> float:
        """Its steps to the wanted life, else to the best one."""
        return self.track.best if self.track.root is None else self.track.root

    @property
    def gain(self) -> float:
        """Mean change of the logarithm of the life towards the wanted one, by a step."""
        return (self.track.values[self.place] - self.track.values[0.0]) / self.place if self.place else 0.0


@dataclass
class Trials:
    """Solves a case with other settings, many side by side."""

    case: Head
    family: Family
    target: Target
    report: Report
    problems: dict[Settings, str] = field(default_factory=dict)  # why there is no life

    @property
    def start(self) -> float:
        """Distance of the case as it is."""
        return self.target.distance(self.target.before)

    def distances(self, settings: Sequence[Settings]) -> list[float]:
        """Distance of each changed case; NaN where it has no life."""
        read, cases = reader(self.case, self.family), dict[int, Head]()
        for place, each in enumerate(settings):
            try:
                cases[place] = read(each)
            except BadCase as problem:
                self.problems[each] = str(problem).splitlines()[0]
        found = [nan] * len(settings)
        solved = answers(list(cases.values()), [self.target.text], self.family)
        for place, answer in zip(cases, solved, strict=True):
            life = answer.numbers.get(self.target.text)
            if life is None:
                self.problems[settings[place]] = answer.why
            else:
                found[place] = self.target.distance(life)
        return found

    def followed(
        self, moves: Sequence[Move], first: Sequence[float], starts: Sequence[float]
    ) -> list[Followed]:
        """Follow moves from their distances at the start; `first` is where each is expected to get there.

        Without it they are only looked at in a few places.
        """
        tracks = [Track({0.0: start}, move.end()) for move, start in zip(moves, starts, strict=True)]

        def batch(numbers: Sequence[int], steps: Sequence[float]) -> list[float]:
            share = sum(len(track.values) - 1 for track in tracks) / (USUAL * len(tracks))
            self.report.stage(f"{len(moves)} changes towards the life", min(share, 1.0))
            both = zip(numbers, steps, strict=True)
            return self.distances([moves[number].settings(step) for number, step in both])

        reach(tracks, first, batch) if first else look(tracks, batch)
        return [Followed(move, track) for move, track in zip(moves, tracks, strict=True)]
