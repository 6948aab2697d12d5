"""The reference page of the result file, from the tables that write it."""

from flexbearing.case.family import Families, Family
from flexbearing.results.attributes import ATTRIBUTES, Attribute
from flexbearing.results.layout import Dataset, Layout, Place

_BEGINNING = """\
# The result file

One HDF5 file holds one run. It is written as `OUT.h5.part` and renamed when complete: a name without `.part`
promises a complete file, also when the run did not converge; `status` tells. Everything is in SI units, and
every dataset carries its `unit`, its `axes` and its `meaning` as attributes.

```python
import h5py

with h5py.File("OUT.h5") as file:
    print(file.attrs["status"])
    load = file["flexible/inner_load"]
    print(load[:], load.attrs["unit"], load.attrs["meaning"])
    print(file["iterations/load_change"][:])
```

| group | holds |
|---|---|
| `iterations` | iterations of the coupling, a row each along the first axis; absent without flexible parts |
| `rigid` | the solution with rigid raceways |
| `flexible` | the end state with flexible raceways; for rollers, equal to `rigid` when no part \
is flexible; for four-point ball bearings with `[rings]` that yield |

The root attribute `kind` says which of the tables below a file follows. Iterations of a run that ended as
`not finite` may hold NaN; a block of a converged run never does, unless the meaning of a dataset says where.
A block that was never solved is absent, and so is a dataset whose meaning says when.
"""

_PLACES: dict[Place, str] = {
    "state": "Datasets of iterations and blocks",
    "iteration": "Datasets of iterations only",
    "block": "Datasets of blocks only",
}


def reference_page(families: Families) -> str:
    """Page that documents every dataset and root attribute.

    Parameters
    ----------
    families : mapping
        kind to family

    Returns
    -------
    str
        Markdown
    """
    return "\n".join([_BEGINNING, *(_family(family) for family in families.values()), _attributes()])


def _family(family: Family) -> str:
    layout: Layout = family.layout()
    sections = [_section(layout, place) for place in _PLACES]
    return "\n".join([f'## kind = "{family.kind}"\n', layout.axes, *filter(None, sections)])


def _section(layout: Layout, place: Place) -> str:
    rows = [_row(entry) for entry in layout.table if entry.place == place]
    head = [f"### {_PLACES[place]}\n", "| name | axes | unit | meaning |", "|---|---|---|---|"]
    return "\n".join([*head, *rows, ""]) if rows else ""


def _row(entry: Dataset) -> str:
    return f"| `{entry.name}` | {' × '.join(entry.shape) or 'scalar'} | {entry.unit} | {entry.meaning} |"


def _attributes() -> str:
    rows = [f"| `{entry.name}` | {entry.kind} | {entry.meaning}{_whose(entry)} |" for entry in ATTRIBUTES]
    return "\n".join(["## Root attributes\n", "| name | stored as | meaning |", "|---|---|---|", *rows, ""])


def _whose(entry: Attribute) -> str:
    return "; of rollers only" if entry.rollers else ""
