"""Bearings of books and catalogues, and those that `flexbearing select` takes.

`python -m benchmarks.selections`. The problems are those of `tests/literature`, with their sources. C is the
required one, by us and as printed.
"""

from pathlib import Path
from tempfile import TemporaryDirectory

from tests.literature import (
    test_bearing_lectures,
    test_koyo_catalogue,
    test_mott,
    test_nsk_catalogue,
    test_ntn_catalogue,
    test_shigley,
)

BOOKS = {
    "NSK": test_nsk_catalogue, "NTN": test_ntn_catalogue, "Koyo": test_koyo_catalogue, "Mott": test_mott,
    "Shigley": test_shigley, "lecture": test_bearing_lectures,
}  # fmt: skip


def main() -> None:
    print(
        f"{'source':8} {'problem':22} {'book':8} {'ours':8} {'C [kN]':>8} {'printed':>8} {'life [h]':>9}"
        "  next lighter"
    )
    for book, module in BOOKS.items():
        for choice in module.CHOICES:
            with TemporaryDirectory() as folder:
                found = choice.check(Path(folder))
            ours, printed = found.chosen, choice.required
            lighter = found.cards[: found.cards.index(ours)]
            why = (
                f"{lighter[-1].candidate.designation}: {lighter[-1].verdict}"
                if lighter
                else "none in the table"
            )
            print(
                f"{book:8} {choice.name:22} {choice.book or choice.chosen:8} {ours.candidate.designation:8} "
                f"{ours.rated.required_rating / 1e3:8.2f} {f'{printed[0]:8.2f}' if printed else '':>8} "
                f"{ours.rated.life / 3600:9.0f}  {why}"
            )


if __name__ == "__main__":
    main()
