"""Compute cases of evidence and write their pages: `python -m evidence [NAME ...] [--check] [--pages]`."""

import argparse
import sys
import time
from collections.abc import Sequence

import matplotlib as mpl
import matplotlib.pyplot as plt

from evidence.case import Case
from evidence.cases import CASES
from evidence.drawing import LOOK
from evidence.page import index, page
from evidence.stored import DOCS, file_of, moved, read, write
from evidence.verdict import verdict


def computed(case: Case) -> None:
    """Compute a case; keep its numbers and its figure."""
    began = time.process_time()
    findings = case.compute()
    write(case, findings)
    if case.draw:
        with mpl.rc_context(LOOK):
            figure = case.draw(findings)
            (DOCS / "figures").mkdir(exist_ok=True)
            figure.savefig(
                DOCS / "figures" / f"{case.name}.png", bbox_inches="tight", metadata={"Software": None}
            )
            plt.close(figure)
    print(
        f"{case.name}: {verdict(case, findings)}, {time.process_time() - began:.1f} s of the processor",
        flush=True,
    )


def write_pages() -> None:
    """All pages and the index, from the numbers that are kept."""
    kept = {case.name: read(case) for case in CASES.values() if file_of(case).exists()}
    known = [case for case in CASES.values() if case.name in kept]
    for case in known:
        (DOCS / f"{case.name}.md").write_text(page(case, kept[case.name]))
    (DOCS / "index.md").write_text(index(known, kept))


def checked(cases: Sequence[Case]) -> int:
    """Say which numbers moved; how many."""
    lines = []
    for case in cases:
        began = time.process_time()
        new = moved(case, read(case), case.compute())
        print(
            "\n".join(new) or f"{case.name}: as before, {time.process_time() - began:.1f} s of the processor",
            flush=True,
        )
        lines += new
    return len(lines)


def main() -> int:
    """Exit code 1 where a number moved."""
    parser = argparse.ArgumentParser(prog="python -m evidence", description=__doc__)
    parser.add_argument("name", nargs="*", choices=[[], *CASES], help="cases; all without a name")
    parser.add_argument("--check", action="store_true", help="compute again and fail where a number moved")
    parser.add_argument("--pages", action="store_true", help="write pages from the numbers that are kept")
    options = parser.parse_args()
    cases = [CASES[name] for name in options.name] or list(CASES.values())
    if options.check:
        return 1 if checked(cases) else 0
    if not options.pages:
        for case in cases:
            computed(case)
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
