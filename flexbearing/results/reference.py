"""The reference page of the result file, from the tables that write it."""

from flexbearing.case.family import Families, Family
from flexbearing.outputs import outputs
from flexbearing.quantities import Quantity
from flexbearing.quantities.attributes import COMMON, Attribute
from flexbearing.quantities.layout import Layout
from flexbearing.quantities.quantity import Place

_BEGINNING = """\
# The result file

One HDF5 file contains one run. A name without `.part` promises a complete file, also when the run did not
converge (`status`). What a run has finished so far is in `OUT.h5.HOST-PROCESS-NUMBER.part` in the same
folder, at most a second old and always whole; `flexbearing summary` reads it, with the status `unfinished`. A
run that is interrupted leaves it, the next complete result of that name removes it. `OUT.h5.lock` names
host, process and start of the run that is writing. Everything is in SI units.
Every dataset carries its `units` as an attribute and HDF5 dimension scales along its axes; the root attribute
`meanings` says what each of them is.

```python
import h5py

with h5py.File("OUT.h5") as file:
    print(file.attrs["status"])
    load = file["flexible/inner_load"]
    print(load[:], load.attrs["units"], load.dims[0][0].name)
    print(file["iterations/load_change"][:])
```

`xarray.open_datatree("OUT.h5", engine="h5netcdf")` gives the same with named dimensions and coordinates, and
so does netCDF4.

| group | contains |
|---|---|
| `iterations` | iterations of the coupling, a row each along the first axis; absent without flexible parts |
| `rigid` | the solution with rigid raceways |
| `flexible` | the end state with flexible raceways; for rollers, equal to `rigid` when no part \
is flexible; for four-point ball bearings with elastic `[rings]` |

The root attribute `kind` says which of the tables below a file follows. Iterations of a run that ended as
`not finite` may hold NaN; a block of a converged run never does, unless the meaning of a dataset says where.
A block that was never solved is absent, and so is a dataset whose meaning says when.

Every dataset that has an axis carries the HDF5 checksum fletcher32, and the root attribute `digest` is a
SHA-256 over everything else in the file: of a JSON text (keys sorted, no spaces, ASCII alone) that holds
`attributes` (floats as hexadecimal texts), and of all datasets by path `shapes`, `units` (an empty text for a
scale that is a length alone) and `axes` (names of their scales; left out for a scale), followed by the
datasets in the order of their paths, each as little-endian 64-bit floats. flexbearing refuses a file whose
content is another, that links to other files, or that does not follow the tables below.
The file needs HDF5 1.10.

Scalars of a block also have names, as in `result["flexible.max_roller_load [kN]"]` in Python: the keys of the
summary with the unit apart. The brackets may contain any unit of the same kind; without them it is the unit
below. Without `rigid.` or `flexible.` a name means the flexible block where there is one, else the rigid one.
Lives also become hours, `[h]`, at the speed of the block.
"""

_PLACES: dict[Place, str] = {
    "state": "Datasets of iterations and blocks",
    "iteration": "Datasets of iterations only",
    "block": "Datasets of blocks only",
}


def reference_page(families: Families) -> str:
    """Page that documents every dataset and root attribute."""
    common = ["## Root attributes of every file\n", *_attribute_table(COMMON)]
    kinds: dict[int, list[Family]] = {}  # that have a layout in common
    for family in families.values():
        kinds.setdefault(id(family.layout()), []).append(family)
    return "\n".join([_BEGINNING, *map(_tables, kinds.values()), *common])


def _tables(families: list[Family]) -> str:
    """Tables of kinds with one layout."""
    layout: Layout = families[0].layout()
    kinds = " or ".join(f'"{family.kind}"' for family in families)
    sections = [f"## kind = {kinds}\n", layout.conventions, *_axes(layout)]
    for place, title in _PLACES.items():
        if rows := [_row(entry) for entry in layout.quantities if entry.place == place]:
            sections += [
                f"### {title}\n",
                "| name | symbol | axes | unit | meaning |",
                "|---|---|---|---|---|",
                *rows,
                "",
            ]
    sections += ["### Outputs by name\n", "| name | unit | meaning |", "|---|---|---|"]
    sections += [f"| `{entry.name}` | {entry.unit} | {entry.meaning} |" for entry in outputs(layout)]
    sections += [""]
    if layout.further_attributes:
        sections += ["### Further root attributes\n", *_attribute_table(layout.further_attributes)]
    return "\n".join(sections)


def _axes(layout: Layout) -> list[str]:
    """Table of the axes of a kind."""
    used = {symbol for entry in layout.quantities for symbol in entry.shape}
    rows = [
        f"| {axis.symbol} | `{axis.name}` | {', '.join(axis.entries)} | {axis.coordinate} |"
        for axis in layout.axis.values()
        if axis.symbol in used
    ]
    return ["### Axes\n", "| symbol | dimension | entries | coordinate |", "|---|---|---|---|", *rows, ""]


def _row(entry: Quantity) -> str:
    cells = (f"`{entry.name}`", entry.symbol, " × ".join(entry.shape) or "scalar", entry.unit, entry.meaning)
    return f"| {' | '.join(cells)} |"


def _attribute_table(attributes: tuple[Attribute, ...]) -> list[str]:
    rows = [f"| `{entry.name}` | {entry.kind} | {entry.meaning} |" for entry in attributes]
    return ["| name | stored as | meaning |", "|---|---|---|", *rows, "", *_forms(attributes)]


def _forms(attributes: tuple[Attribute, ...]) -> list[str]:
    with_form = (entry for entry in attributes if entry.kind in ("json", "records"))
    forms = [f"- `{entry.name}`: `{entry.form.words}`" for entry in with_form]
    return ["Those stored as JSON hold (`?`: may be absent):\n", *forms, ""] if forms else []
