"""Compute cases of evidence and write their pages: `python -m evidence [NAME ...] [--check]`."""

import argparse
import sys
import time
from collections.abc import Callable, Sequence

import matplotlib as mpl
import matplotlib.pyplot as plt

from evidence import trust
from evidence.case import Case
from evidence.cases import CASES
from evidence.drawing import LOOK
from evidence.measured import page as measured_page, stored as measured
from evidence.measured.declared import Experiment
from evidence.measured.draws import predicted
from evidence.measured.experiments import EXPERIMENTS
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


def register(experiments: Sequence[Experiment]) -> None:
    """Store predictions; where the printed value is stored already, they are not blind."""
    for experiment in experiments:
        began = time.process_time()
        blind = measured.printed(experiment) is None
        measured.register(experiment, predicted(experiment, blind=blind))
        print(
            f"{experiment.name}: registered, {time.process_time() - began:.1f} s of the processor", flush=True
        )


def write_pages() -> None:
    """All pages, the index and the table of trust, from the numbers that are kept."""
    kept = {case.name: read(case) for case in CASES.values() if file_of(case).exists()}
    known = [case for case in CASES.values() if case.name in kept]
    for case in known:
        (DOCS / f"{case.name}.md").write_text(page(case, kept[case.name]))
    registered = measured.all_registered(EXPERIMENTS.values())
    experiments = [EXPERIMENTS[name] for name in registered]
    for each in experiments:
        (DOCS / f"{each.name}.md").write_text(measured_page.page(each, *registered[each.name]))
    (DOCS / "index.md").write_text(index(known, kept, measured_page.listed(experiments, registered)))
    (DOCS / "trust.md").write_text(trust.page(kept, registered))


def check_of(name: str) -> Callable[[], list[str]]:
    """What computes a case or a prediction again, and says which of its numbers moved."""
    if name in CASES:
        case = CASES[name]
        return lambda: moved(case, read(case), case.compute())
    experiment = EXPERIMENTS[name]
    return lambda: measured.changed(
        experiment, measured.registered(experiment), predicted(experiment, blind=True)
    )


def checked(names: Sequence[str]) -> int:
    """Say which numbers moved; how many."""
    lines = []
    for name in names:
        began = time.process_time()
        new = check_of(name)()
        print(
            "\n".join(new) or f"{name}: as before, {time.process_time() - began:.1f} s of the processor",
            flush=True,
        )
        lines += new
    return len(lines)


def main() -> int:
    """Exit code 1 where a number moved."""
    parser = argparse.ArgumentParser(prog="python -m evidence", description=__doc__)
    parser.add_argument(
        "name", nargs="*", choices=[[], *CASES, *EXPERIMENTS], help="cases; all without a name"
    )
    parser.add_argument("--check", action="store_true", help="compute again and fail where a number moved")
    parser.add_argument("--pages", action="store_true", help="write pages from the numbers that are kept")
    parser.add_argument("--register", action="store_true", help="predict measurements and store the bands")
    options = parser.parse_args()
    names = options.name or [*CASES, *EXPERIMENTS]
    if options.check:
        return 1 if checked(names) else 0
    if options.register:
        register([EXPERIMENTS[name] for name in names if name in EXPERIMENTS])
    elif not options.pages:
        for name in names:
            if name in CASES:
                computed(CASES[name])
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
