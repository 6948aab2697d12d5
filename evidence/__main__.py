"""Compute cases of evidence and write their pages: `python -m evidence [NAME ...] [--check]`."""

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib as mpl
import matplotlib.pyplot as plt

from evidence import sources, trust
from evidence.case import Case
from evidence.cases import CASES
from evidence.drawing import LOOK
from evidence.measured import page as measured_page, stored as measured
from evidence.measured.declared import Experiment
from evidence.measured.draws import computed as computed_rows, predicted
from evidence.measured.experiments import EXPERIMENTS
from evidence.measured.stored import EVERY
from evidence.page import index, page
from evidence.sources import Digests
from evidence.stored import DOCS, ROOT, file_of, moved, read, write
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
        found = computed_rows(experiment)
        measured.write_rows(experiment, found)
        measured.register(experiment, predicted(experiment, found, blind=blind))
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


def recomputed(name: str) -> tuple[list[str], Digests]:
    """Which rows of a prediction moved, and what it was computed from, by a process of its own."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / "found.json"
        subprocess.run([sys.executable, "-m", "evidence.measured", name, str(file)], cwd=ROOT, check=True)
        found = json.loads(file.read_text())
    experiment = EXPERIMENTS[name]
    band = predicted(experiment, measured.rows_of(experiment), blind=True)
    lines = [*measured.changed(experiment, measured.registered(experiment), band), *found["lines"]]
    print(said(name, lines, found["seconds"]), flush=True)
    return lines, found["files"]


def said(name: str, lines: Sequence[str], seconds: float) -> str:
    """What a page is reported with."""
    return "\n".join(lines) or f"{name}: as before, {seconds:.1f} s of the processor"


def checked(names: Sequence[str], jobs: int) -> int:
    """Report which numbers moved, of predictions in some rows; how many."""
    experiments = [name for name in reversed(EXPERIMENTS) if name in names]  # the longest ones first
    lines = []
    with ThreadPoolExecutor(jobs) as pool:
        waiting = {name: pool.submit(recomputed, name) for name in experiments}
        for case in (CASES[name] for name in names if name in CASES):
            began = time.process_time()
            new = moved(case, read(case), case.compute())
            print(said(case.name, new, time.process_time() - began), flush=True)
            lines += new
        found = {name: each.result() for name, each in waiting.items()}
    sources.write({name: files for name, (new, files) in found.items() if not new})
    return len([*lines, *(line for new, _ in found.values() for line in new)])


def main() -> int:
    """Exit code 1 where a number moved."""
    parser = argparse.ArgumentParser(prog="python -m evidence", description=__doc__)
    parser.add_argument(
        "name", nargs="*", choices=[[], *CASES, *EXPERIMENTS], help="cases; all without a name"
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help=f"compute again, of predictions every {EVERY}th row, and fail where a number moved",
    )
    parser.add_argument(
        "--touched", action="store_true", help="leave out predictions whose files did not change"
    )
    parser.add_argument("--jobs", type=int, default=2, help="processes of --check")
    parser.add_argument("--pages", action="store_true", help="write pages from the numbers that are kept")
    parser.add_argument("--register", action="store_true", help="predict measurements and store the bands")
    options = parser.parse_args()
    names = options.name or [*CASES, *EXPERIMENTS]
    if options.touched:
        names = [name for name in names if name in CASES] + sources.touched(
            n for n in names if n in EXPERIMENTS
        )
    if options.check:
        return 1 if checked(names, options.jobs) else 0
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
