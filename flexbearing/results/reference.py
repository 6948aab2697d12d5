"""The reference page of the result file, from the tables that write it."""

import sys

from flexbearing.results.attributes import ATTRIBUTES
from flexbearing.results.layout import TABLE, Dataset, Place

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
    print([group["load_change"][()] for group in file["iterations"].values()])
```

| group | holds |
|---|---|
| `iterations/0001`, `iterations/0002`, ... | the iterations of the coupling; none when no part is flexible |
| `rigid` | the solution with rigid raceways |
| `flexible` | the end state with flexible raceways; equal to `rigid` when no part is flexible |

Axes: Z rollers, K slices along a roller. Directions: x axial, z along the load unless
`operation.load_direction` turns the load; azimuth from z towards y, which is the way a positive speed turns.
A pair is (inner, outer) or (y, z) as stated.
Iterations of a run that ended as `not finite` may hold NaN; a block of a converged run never does. A block
that was never solved is absent, and so is a dataset whose meaning says when.
"""

_SECTIONS: dict[Place, str] = {
    "state": "Datasets of iterations and blocks",
    "iteration": "Datasets of iterations only",
    "block": "Datasets of blocks only",
}


def reference_page() -> str:
    """Page that documents every dataset and root attribute.

    Returns
    -------
    str
        Markdown
    """
    return "\n".join([_BEGINNING, *(_section(place) for place in _SECTIONS), _attributes()])


def _section(place: Place) -> str:
    rows = [_row(entry) for entry in TABLE if entry.place == place]
    return "\n".join(
        [f"## {_SECTIONS[place]}\n", "| name | axes | unit | meaning |", "|---|---|---|---|", *rows, ""]
    )


def _row(entry: Dataset) -> str:
    return f"| `{entry.name}` | {' × '.join(entry.shape) or 'scalar'} | {entry.unit} | {entry.meaning} |"


def _attributes() -> str:
    rows = [f"| `{entry.name}` | {entry.kind} | {entry.meaning} |" for entry in ATTRIBUTES]
    return "\n".join(["## Root attributes\n", "| name | stored as | meaning |", "|---|---|---|", *rows, ""])


if __name__ == "__main__":
    sys.stdout.write(reference_page())
