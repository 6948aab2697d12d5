"""Compute some rows of one prediction again: `python -m evidence.measured NAME FILE`, for `python -m evidence`."""

import json
import sys
import time
from pathlib import Path

from evidence.measured.draws import computed
from evidence.measured.experiments import EXPERIMENTS
from evidence.measured.stored import EVERY, moved_rows
from evidence.sources import loaded


def main(name: str, file: Path) -> None:
    """Write which rows moved, of which modules, and the time of the processor [s]."""
    lines = moved_rows(EXPERIMENTS[name], computed(EXPERIMENTS[name], EVERY))
    file.write_text(json.dumps({"lines": lines, "files": loaded(), "seconds": time.process_time()}))


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
