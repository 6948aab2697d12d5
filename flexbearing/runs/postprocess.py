"""What follows from the end states of a run: datasets, lives, regimes, notes."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from numpy.typing import ArrayLike

from flexbearing.build import clearance
from flexbearing.build.lubrication import roughness
from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.results import ResultFile
from flexbearing.rings.raceways import CondensedRings
from flexbearing.runs import fields, life, notes, skew
from quasidynamic import Equilibrium
from quasidynamic.contact.film import lambda_ratio, regime


@dataclass(frozen=True)
class Outcome:
    """Writes end states into a result file and keeps what its root attributes will say of them."""

    case: Case
    file: ResultFile
    lives: dict[str, Any] = field(default_factory=dict)  # by block
    regimes: dict[str, Any] = field(default_factory=dict)  # by block
    notes: list[str] = field(default_factory=list)
    stresses: dict[str, Any] = field(default_factory=dict)  # by part

    def store(
        self,
        name: Literal["rigid", "flexible"],
        found: Equilibrium,
        rings: CondensedRings,
        *,
        converged: bool = True,
    ) -> None:
        """Write a block; lives, regimes and notes are those of solutions only."""
        sigma = roughness(self.case)
        arrays = states.block(found, rings, sigma)
        if converged:
            smallest = states.smallest_film(found)
            if lived := life.modified(self.case, found, smallest):
                self.lives[name] = lived
                arrays["modified_life"] = lived["modified_Mrev"] * states.MREV
            if sigma is not None:
                words = (str(word) for word in regime(lambda_ratio(smallest, sigma)))
                self.regimes[name] = dict(zip(("inner", "outer"), words, strict=True))
            self.notes.extend(notes.of_state(self.case, found))
            if skewed := skew.at(self.case, found):
                arrays.update(skew.arrays(skewed))
                self.notes.extend(skew.notes(skewed, found, smallest))
            if name == "flexible" and self.case.outputs.stresses:
                self._add_stresses(arrays)
        self.file.block(name, arrays, converged=converged)

    def _add_stresses(self, arrays: Mapping[str, ArrayLike]) -> None:
        """Stresses come on top of a solution: what keeps them away is a note, and the solution stays."""
        for race in fields.parts(self.case):
            try:
                found = fields.fields(self.case, race, "flexible", arrays)
            except fields.NoFields as problem:
                self.notes.append(f"no stresses: {problem}")
            else:
                self.stresses[race] = found.record()

    def attributes(self) -> dict[str, Any]:
        """Root attributes that the end states decide."""
        known = [*notes.of_case(self.case), *self.notes]
        asked = {"stresses": self.stresses} if self.case.outputs.stresses else {}
        return asked | {
            "clearance": clearance.record(self.case),
            "life": self.lives,
            "regimes": self.regimes,
            "notes": list(dict.fromkeys(known)),
        }
