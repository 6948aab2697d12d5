"""What was computed, where, when and with which versions."""

from collections.abc import Iterator

from flexbearing.case import BadCase
from flexbearing.case.declarations import by_path
from flexbearing.report.drawing.of_case import drawings
from flexbearing.report.html.document import Block, Drawing, Table, Verbatim, Words
from flexbearing.report.html.inputs import origin, row_of_key
from flexbearing.report.html.reader import Reader, flat
from flexbearing.report.html.units import METRIC
from flexbearing.results.content import digest
from flexbearing.results.write import content_of

_MACHINE = {"system": "operating system", "revision": "revision of the program's source (git commit)"}
_KEPT = (
    "The case below, its settings and all numbers are in the result file; keep that file, this page is made "
    "from it again by `flexbearing report`. To repeat the run: `{command}`, then `flexbearing diff` of both "
    "files."
)
_AGREE = (
    " With the same versions the numbers agree within the tolerance of the iteration ({tolerance:g} of the "
    "largest load); another processor or other versions of the libraries change digits of that size."
)
_DIRTY = (
    " The revision ends in -dirty: the source had changes that no commit holds, so the revision alone does "
    "not give this program back."
)
_NO_REVISION = " The revision of the source is not known: the version alone names the program."
_OWN_UNITS = "Drawings, notes and texts of the case keep their own units: mm, µm, N, MPa, °C."


def line(reader: Reader) -> str:
    """A line below the title: kind, time, program, file."""
    about = reader.attributes
    version = about["versions"].get("flexbearing", "")
    changed = about.get("machine", {}).get("revision", "").endswith("-dirty")
    of = ", its source changed since its last commit (see Origin)" if changed else ""
    return f"{kind(reader)} bearing, computed {about['created']} by flexbearing {version}{of}"


def kind(reader: Reader) -> str:
    """Kind of the bearing in words."""
    return reader.attributes["kind"].replace("_", " ")


def computed(reader: Reader) -> Iterator[Block]:
    """What was solved for, in words."""
    parts = ", ".join(reader.attributes.get("structure") or {})
    elastic = (
        f"with flexible parts: {parts}" if parts else "between elastic rings and, to compare, rigid ones"
    )
    rings = elastic if len(reader.blocks) > 1 else "between rigid rings"
    yield Words((f"Kind of bearing: {kind(reader)}, {rings}. {reader.layout.conventions.strip()}",))
    if reader.units is not METRIC:
        yield Words((_OWN_UNITS,))
    yield from _drawings(reader)
    yield from _conditions(reader)


def _drawings(reader: Reader) -> Iterator[Block]:
    """Drawings to scale of the case, its keys as dimensions; where it cannot be read again, why."""
    try:
        sheets = tuple(drawings(reader.result.family, reader.case, resized=True))
    except BadCase as problem:
        yield Words((f"Not drawn: {str(problem).splitlines()[0]}",))
        return
    for drawing in sheets:
        yield Drawing(drawing.caption, drawing.svg)


def _conditions(reader: Reader) -> Iterator[Table]:
    """Loads, speeds, temperatures and oil that the case gives."""
    keys = by_path(reader.result.family.case())
    given = reader.written
    rows = [
        (*row_of_key(reader, keys.get(path), path, value)[:3], origin(reader, path))
        for path, value in flat(reader.attributes["case_si"])
        if path in given and path.startswith(("operation.", "lubricant.oil", "lubricant.inlet"))
    ]
    if rows:
        yield Table("Operating conditions", ("key", "value", "unit", "origin"), tuple(rows))


def _repeated(reader: Reader) -> str:
    """How to repeat the run, how well it will agree, and whether its program can be had again."""
    about = reader.attributes
    settings = "".join(f" --set '{each}'" for each in about["case_overrides"])
    words = _KEPT.format(command=f"flexbearing run {reader.case_name}{settings} -o AGAIN.h5")
    tolerance = (about["case_si"].get("coupling") or {}).get("tolerance")
    words += _AGREE.format(tolerance=tolerance) if tolerance else ""
    revision = about.get("machine", {}).get("revision", "")
    return words + (_DIRTY if revision.endswith("-dirty") else "" if revision else _NO_REVISION)


def blocks(reader: Reader) -> Iterator[Block]:
    """Versions, times, digest, then the case letter by letter."""
    about = reader.attributes
    rows = [
        ("result file", str(reader.result.path or "none")),
        ("digest of its content (SHA-256)", digest(content_of(reader.result))),
        ("case file", about.get("case_file", "none")),
        ("computed", about["created"]),
        ("time it took", f"{about['wall_time_s']:.1f} s"),
        *(
            (_MACHINE.get(name, f"{name} of the computation"), str(value))
            for name, value in about.get("machine", {}).items()
        ),
        *((f"version of {name}", text) for name, text in about["versions"].items()),
    ]
    yield Table("Origin of the numbers", ("what", "value"), tuple(rows), _repeated(reader))
    if about["case_overrides"]:
        yield Verbatim("Settings on top of the case", "\n".join(about["case_overrides"]))
    yield Verbatim("The case", about["case_text"])
