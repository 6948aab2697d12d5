"""Table and picture of a study of speed against error, as files."""

import re
from collections.abc import Iterable
from pathlib import Path

from flexbearing.files import BadOutput, require_folder, require_outputs, write
from flexbearing.printable import excerpt
from flexbearing.program.commands import keeping
from flexbearing.report.studies.pareto_table import Study, table

_PLAIN = re.compile(r"[^./\\\x00-\x1f\x7f][^/\\\x00-\x1f\x7f]*")


def destinations(folder: Path, name: str, inputs: Iterable[Path]) -> tuple[Path, Path]:
    """Settle where table and picture go, before anything is computed.

    Raises `BadOutput` for a name with more in it than the name of a file, or files that cannot be written.
    """
    if not _PLAIN.fullmatch(name):
        raise BadOutput(
            f"--name {excerpt(name)!r}: becomes part of the names of two files, pareto_NAME.csv and "
            "pareto_NAME.png: not empty, no folders, no dot in front. The folder is named with -o."
        )
    csv, png = (require_folder(folder) / f"pareto_{name}{suffix}" for suffix in (".csv", ".png"))
    require_outputs((csv, png), inputs)
    return csv, png


def store(study: Study, csv: Path, png: Path) -> None:
    """Write table and picture.

    Raises `NotStored` if there is no room for them; a note says that the table is there when only the picture
    is missing.
    """
    from flexbearing.report.picture import picture_bytes
    from flexbearing.report.studies.pareto_table import draw_pareto

    write(csv.resolve(), table(study).encode())
    with keeping([csv], "the table is complete"):
        write(png.resolve(), picture_bytes(draw_pareto(study), dpi=130))
