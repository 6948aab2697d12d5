"""Points of the unit cube in four bytes a number: floats are made of them where they are read."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

BITS = 30  # of a number of SciPy's Sobol points


class Points(Protocol):
    """Points (N, D), of which some are read at a time."""

    def __len__(self) -> int:
        """N."""
        ...

    def __getitem__(self, some: slice) -> NDArray:
        """Points (n, D) side by side."""
        ...


class LatinHypercube:
    """One point in each of N layers of every dimension; those of `scipy.stats.qmc.LatinHypercube`."""

    def __init__(self, count: int, dimensions: int, seed: int):
        self._seed = seed
        self._ranks = np.empty((count, dimensions), np.uint32)  # of layers, from 1
        generator = self._generator(count)  # places within layers are drawn first, and again when read
        for column in self._ranks.T:
            layers = np.arange(1, count + 1)
            generator.shuffle(layers)
            column[:] = layers

    def _generator(self, points: int) -> np.random.Generator:
        """The generator after the places of some points within their layers."""
        bits = np.random.PCG64(self._seed)
        bits.advance(points * self._ranks.shape[1])
        return np.random.Generator(bits)

    def __len__(self) -> int:
        return len(self._ranks)

    def __getitem__(self, some: slice) -> NDArray:
        first, *_ = some.indices(len(self))
        ranks = self._ranks[some]
        return (ranks - self._generator(first).random(ranks.shape)) / len(self)


@dataclass(frozen=True, eq=False)
class SobolPoints:
    """Points of a scrambled Sobol sequence, or mixed of them."""

    codes: NDArray  # (N, D) in units of 2^-BITS

    @classmethod
    def of(cls, count: int, dimensions: int, seed: int) -> "SobolPoints":
        """The first points of a sequence."""
        from scipy.stats import qmc  # since SciPy 1.15 seed is called rng, too

        points = qmc.Sobol(dimensions, bits=BITS, seed=seed).random(count)  # pyright: ignore[reportCallIssue]
        return cls((points * 2.0**BITS).astype(np.uint32))

    def __len__(self) -> int:
        return len(self.codes)

    def __getitem__(self, some: slice) -> NDArray:
        return self.codes[some] * 2.0**-BITS


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
