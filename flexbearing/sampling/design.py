"""Points at which random inputs are drawn."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from flexbearing.sampling.points import LatinHypercube, Points, SobolPoints

Method = Literal["latin_hypercube", "sobol", "sobol_indices"]
POWERS_OF_2 = ("sobol", "sobol_indices")  # methods whose points are even for these counts only


@dataclass(frozen=True)
class Design:
    """How many points there are and how they are spread."""

    method: Method
    count: int  # of points; of base points for sobol_indices
    seed: int

    def rows(self, keys: int) -> int:
        """How many points there are of K inputs."""
        return self.count * (keys + 2) if self.method == "sobol_indices" else self.count

    def points(self, widths: Sequence[int]) -> Points:
        """Points of the unit cube.

        Source
        ------
        Saltelli et al., Computer Physics Communications 181 (2010) 259-270, sec. 5: A and B are the two
        halves of the coordinates of one Sobol sequence.
        """
        dimensions = sum(widths)
        if self.method == "latin_hypercube":
            return LatinHypercube(self.count, dimensions, self.seed)
        twice = 2 if self.method == "sobol_indices" else 1
        found = SobolPoints.of(self.count, twice * dimensions, self.seed)
        if twice == 1:
            return found
        first, second = found.codes[:, :dimensions], found.codes[:, dimensions:]
        mixed = [
            np.where(own, second, first) for own in np.repeat(np.eye(len(widths), dtype=bool), widths, 1)
        ]
        return SobolPoints(np.stack([first, second, *mixed], axis=1).reshape(-1, dimensions))

    def independent(self, rows: int) -> NDArray:
        """Which rows are drawn independently of each other, so that their outputs have the distribution."""
        places = np.arange(rows)
        return places if self.method != "sobol_indices" else places[places % (rows // self.count) < 2]
