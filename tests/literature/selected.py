"""A printed choice of a bearing, and the one that `flexbearing select` makes of a table."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from flexbearing.select.application import read
from flexbearing.select.candidates import candidates
from flexbearing.select.selection import selection

HEADS = ("designation", "like", "bore", "outside", "width", "dynamic_rating", "static_rating")
BALLS, ROLLERS = "deep_groove_ball", "cylindrical_roller"
# Boundary dimensions [mm] of ISO 15, C and C_0 [kN] as a public lecture on machine elements prints them
# (FRA232, KMUTT); its 6208 is that of NTN and NSK, 29.1 kN.
SERIES_62 = {
    "6200": (10, 30, 9, 5.1, 2.39), "6201": (12, 32, 10, 6.8, 3.05), "6202": (15, 35, 11, 7.8, 3.75),
    "6203": (17, 40, 12, 9.55, 4.8), "6204": (20, 47, 14, 12.8, 6.65), "6205": (25, 52, 15, 14.0, 7.8),
    "6206": (30, 62, 16, 19.5, 11.2), "6207": (35, 72, 17, 25.5, 15.3), "6208": (40, 80, 18, 29.1, 17.8),
    "6209": (45, 85, 19, 32.5, 20.4), "6210": (50, 90, 20, 35.0, 23.2), "6211": (55, 100, 21, 43.6, 29.0),
    "6212": (60, 110, 22, 52.0, 36.0),
}  # fmt: skip
OF_SIZES = {  # of ISO 15, without ratings: those of ISO 281 and ISO 76
    "6306": (30, 72, 19), "6307": (35, 80, 21), "6308": (40, 90, 23), "6309": (45, 100, 25),
    "6310": (50, 110, 27), "6311": (55, 120, 29),
}  # fmt: skip


def row(name, like, sizes):
    """A row of a table, from d, D, B [mm] and, where they are known, C and C_0 [kN]."""
    units = ("mm", "mm", "mm", "kN", "kN")
    cells = [f"{size} {unit}" if size else "" for size, unit in zip(sizes, units, strict=False)]
    return ",".join([name, like, *cells, *[""] * (5 - len(sizes))])


@dataclass(frozen=True)
class Choice:
    """What a book is given, and what it chooses."""

    name: str
    life: str
    chosen: str  # by us: the bearing of the book, or a lighter one
    book: str = ""  # of the book, where it is a heavier one
    options: Mapping[str, str] = field(default_factory=dict)
    bearings: Mapping[str, tuple] = field(default_factory=lambda: SERIES_62)
    like: str = BALLS
    bore: float = 0.0  # [mm] of the shaft, where it is given
    factor: float = 1.0
    reliability: float | None = None
    spectrum: str = ""
    required: tuple[float, float] | None = None  # printed C [kN], and by how much its digits may be off

    def selection(self, folder):
        """The selection of all bearings of its table."""
        table, rows = folder / "bearings.csv", folder / "rows.csv"
        lines = [
            row(name, self.like, sizes)
            for name, sizes in self.bearings.items()
            if self.bore in (0.0, sizes[0])
        ]
        table.write_text("\n".join([",".join(HEADS), *lines]))
        rows.write_text(self.spectrum)
        file = rows if self.spectrum else None
        application = read(self.options, file, self.life, self.factor, self.reliability)
        return selection(application, candidates([table]))

    def check(self, folder):
        """Our choice is the stated one, not heavier than that of the book; what is lighter breaks a limit."""
        found = self.selection(folder)
        mass = {card.candidate.designation: card.candidate.mass for card in found.cards}
        assert found.chosen is not None
        assert found.chosen.candidate.designation == self.chosen
        assert mass[self.chosen] <= mass[self.book or self.chosen]
        for card in found.cards[: found.cards.index(found.chosen)]:
            assert card.verdict
        if self.required is not None:
            printed, share = self.required
            assert abs(found.chosen.rated.required_rating / (1e3 * printed) - 1) < share
        return found
