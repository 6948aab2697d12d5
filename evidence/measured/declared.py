"""What the page of a measurement declares, what is registered for it, and what is printed."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from numpy.typing import NDArray

if TYPE_CHECKING:
    from evidence.measured.draws import Draws


@dataclass(frozen=True, kw_only=True)
class Input:
    """An input that the source does not give: a range in which every value is as likely."""

    name: str  # key of the case file, or a name of its own
    low: float
    high: float
    unit: str = ""
    logarithmic: bool = False  # whether its logarithm is as likely
    reason: str

    def at(self, share: NDArray) -> NDArray:
        """Values (...) below which the input lies with some probabilities (...)."""
        if self.logarithmic:
            return self.low * (self.high / self.low) ** share
        return self.low + (self.high - self.low) * share


@dataclass(frozen=True, kw_only=True)
class Experiment:
    """One measurement of others, and how it is predicted."""

    name: str  # of the page
    title: str
    source: str
    given: str  # what the source has of bearing and conditions, in words
    quantity: str  # that is predicted
    unit: str = "-"
    run: str  # what is computed, in words
    case_file: str = ""
    settings: dict[str, object]  # of every bearing that is drawn
    inputs: tuple[Input, ...]
    count: int  # base points of the Sobol indices, a power of 2
    predict: Callable[["Draws"], NDArray]  # (rows) the quantity of every row that is drawn
    refuted: str  # what would refute the prediction
    missing: str = ""  # what the program leaves out
    needed: str = ""  # of the source, where it has no value to compare
    moves: float = 0.05  # share of the width of the band by which its ends may move


@dataclass(frozen=True, kw_only=True)
class Prediction:
    """A registered band, and which inputs make it wide."""

    digest: str  # of case, settings, inputs and number of rows
    version: str  # of the program
    date: str
    blind: bool  # whether no printed value was stored when it was registered
    rows: int  # that are drawn independently
    unsolved: int
    low: float  # 5 %
    median: float
    high: float  # 95 %
    shares: dict[str, float]  # total Sobol index of each input

    @property
    def width(self) -> float:
        """From 5 to 95 %."""
        return self.high - self.low

    @property
    def wide(self) -> bool:
        """Whether the ends are apart by more than a factor of two."""
        return self.high > 2 * self.low if self.low > 0 else self.low > 2 * self.high or self.high > 0


@dataclass(frozen=True, kw_only=True)
class Printed:
    """What a source prints: a number, or a statement that a number lies on one side."""

    text: str
    where: str
    low: float  # infinite of a statement without a lower end
    high: float

    @property
    def is_number(self) -> bool:
        """Whether it is one number, not a side."""
        return self.low == self.high
