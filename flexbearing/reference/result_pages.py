"""Pages of the result file, from the tables that write it."""

from collections.abc import Iterable, Sequence

from flexbearing.case.family import Families, Family
from flexbearing.outputs import Output, outputs
from flexbearing.quantities import Quantity
from flexbearing.quantities.attributes import COMMON, Attribute
from flexbearing.quantities.layout import Layout
from flexbearing.reference.tables import folded, table

_BEGINNING = """\
# The result file

One HDF5 file contains one run, in SI units, also when the run did not converge (`status`).

| page | `kind` of the file |
|---|---|
{kinds}

[What attributes stored as JSON hold](result/json.md)

```python
import flexbearing

result = flexbearing.read("OUT.h5")
result["max_roller_load [kN]"]  # any unit of the same kind; without brackets that of the table
result["rigid.life_L10 [h]"]  # between rigid raceways; hours at the speed of the block
```

Without `rigid.` or `flexible.` a name means the flexible block where there is one, else the rigid one.

| group | contains |
|---|---|
| `iterations` | iterations of the coupling, a row each along the first axis; absent without flexible parts |
| `rigid` | the solution with rigid raceways |
| `flexible` | the end state with flexible raceways; of rollers equal to `rigid` when no part is flexible; \
of four-point ball bearings with elastic `[rings]` |

## Other programs

Every dataset carries `units` and HDF5 dimension scales along its axes; the root attribute
`meanings` explains these.

```python
import h5py

with h5py.File("OUT.h5") as file:
    load = file["flexible/inner_load"]
    print(load[:], load.attrs["units"], load.dims[0][0].name)
```

`xarray.open_datatree("OUT.h5", engine="h5netcdf")` gives the same with named dimensions.
The file needs HDF5 1.10. Iterations of a run that ended as `not finite` may hold NaN.

While a run is at work its file is `OUT.h5.HOST-PROCESS-NUMBER.part`, at most a second old and always whole;
`flexbearing summary` reads it. An interrupted run leaves it; the next complete result removes it.
`OUT.h5.lock` names host, process and start of the run that is writing.

<details><summary>Checksums and digest</summary>

Every dataset with an axis carries the HDF5 checksum fletcher32. The root attribute `digest` is a SHA-256
over everything else in the file: of a JSON text (keys sorted, no spaces, ASCII alone) that holds
`attributes` (floats as hexadecimal texts), and of all datasets by path `shapes`, `units` (an empty text for
a scale that is a length alone) and `axes` (names of their scales; left out for a scale), followed by the
datasets in the order of their paths, each as little-endian 64-bit floats. A file whose content is another,
that links to other files, or that does not follow these tables is refused.

</details>

## Root attributes
"""
_KINDS = {
    "cylindrical_roller": ("roller", "Results of cylindrical roller bearings"),
    "tapered_roller": ("tapered", "Results of tapered roller bearings"),
    "thrust_roller": ("thrust", "Results of roller thrust bearings"),
    "spherical_roller": ("spherical", "Results of spherical roller bearings"),
    "four_point_ball": ("four-point", "Results of four-point ball bearings"),
    "angular_contact_ball": ("ball", "Results of angular-contact and deep groove ball bearings"),
}
_PLACES = {
    "state": "In iterations and blocks",
    "iteration": "In iterations alone",
    "block": "In blocks",
}
_ABSENT = "; absent "
_DIRECTIONS = ("_yy", "_yz", "_zy", "_zz")  # of outputs, entries of one matrix
_ALONG = {"race": "inner, outer", "transverse": "y, z", "bar_end": "ring, flange"}
_FEW = 2  # rows that share a condition and yet stand with it, not under it


def result_pages(families: Families) -> dict[str, str]:
    """Pages that document every dataset and root attribute, by path."""
    shown = [(family, *_KINDS[kind]) for kind, family in families.items() if kind in _KINDS]
    links = "\n".join(f"| [{title}](result/{name}.md) | `{family.kind}` |" for family, name, title in shown)
    layouts = [family.layout() for family, _, _ in shown]
    common = _common(layouts)
    first = [_BEGINNING.format(kinds=links), *_attribute_table(COMMON)]
    first += ["## Datasets of every kind", "", "[Symbols](../theory/symbols.md).", ""]
    pages = [f"result/{name}" for name in (*(name for _, name, _ in shown), "json")]
    first += [*_datasets(common, "In blocks"), "```{toctree}", ":hidden:", "", *pages, "```", ""]
    return {
        "results.md": "\n".join(first),
        **{f"result/{name}.md": _page(family, title, common) for family, name, title in shown},
        "result/json.md": _forms(layouts),
    }


def _common(layouts: Sequence[Layout]) -> list[Quantity]:
    """Quantities that every kind of bearing has alike."""
    first, *others = ({_seen(entry): entry for entry in layout.quantities} for layout in layouts)
    return [entry for seen, entry in first.items() if all(seen in other for other in others)]


def _seen(entry: Quantity) -> tuple[str, ...]:
    """What a page shows of a quantity."""
    return entry.name, entry.symbol, entry.axes, entry.unit, entry.place, entry.meaning


def _page(family: Family, title: str, common: Sequence[Quantity]) -> str:
    layout: Layout = family.layout()
    elsewhere = set(map(_seen, common))
    lines = [
        f"# {title}",
        "",
        "[The result file](../results.md)",
        "",
        layout.conventions,
        "",
        "## Outputs by name",
        "",
    ]
    lines += table(("name", "unit", "what it is"), _outputs(outputs(layout)))
    lines += [
        "## Datasets",
        "",
        "[Datasets of every kind](../results.md#datasets-of-every-kind) are not repeated.",
        "",
    ]
    lines += folded("Axes", table(("symbol", "dimension", "entries", "coordinate"), _axes(layout)))
    for place, words in _PLACES.items():
        own = [entry for entry in layout.quantities if entry.place == place and _seen(entry) not in elsewhere]
        lines += _datasets(own, words)
    if layout.further_attributes:
        lines += ["## Root attributes", "", *_attribute_table(layout.further_attributes)]
    return "\n".join(lines).rstrip() + "\n"


def _outputs(found: Iterable[Output]) -> list[tuple[str, str, str]]:
    """Rows of outputs, parts such as inner and outer in one row."""
    parts: dict[str, list[str]] = {}
    first: dict[str, Output] = {}
    for output in found:
        name, _, part = output.name.partition(".")
        if output.name.startswith(("power_loss.", "skew.")):
            name, part = output.name, ""
        elif name.endswith(_DIRECTIONS):
            name, part = f"{name[:-3]}, entries", name
        parts.setdefault(name, []).append(part)
        first.setdefault(name, output)
    return [(_named(name, rest), first[name].unit, _label(first[name])) for name, rest in parts.items()]


def _named(name: str, parts: Sequence[str]) -> str:
    if parts[0].endswith(_DIRECTIONS):
        return ", ".join(f"`{part}`" for part in parts)
    rest = [f"`.{part}`" for part in parts if part]
    return " ".join([f"`{name}`", ", ".join(rest)]).strip()


def _label(output: Output) -> str:
    """Few words; those of the dataset where there are none."""
    words = output.declared.label.strip() or f"dataset `{output.declared.of[0]}`"
    return "" if words == output.name.partition(".")[0].replace("_", " ") else words


def _axes(layout: Layout) -> list[tuple[str, ...]]:
    used = {symbol for entry in layout.quantities for symbol in entry.shape}
    return [
        (axis.symbol, f"`{axis.name}`", ", ".join(axis.entries), axis.coordinate)
        for axis in layout.axis.values()
        if axis.symbol in used
    ]


def _datasets(entries: Sequence[Quantity], title: str) -> list[str]:
    """Datasets that every case has, then those of a condition that several share, folded."""
    groups: dict[str, list[Quantity]] = {"": []}
    for entry in entries:
        groups.setdefault(entry.meaning.partition(_ABSENT)[2], []).append(entry)
    alone = [
        entry for condition, those in groups.items() if len(those) <= _FEW or not condition for entry in those
    ]
    lines = folded(title, _dataset_table(sorted(alone, key=entries.index)))
    for condition, those in groups.items():
        if condition and len(those) > _FEW:
            lines += folded(f"{title}, absent {condition}", _dataset_table(those, short=True))
    return lines


def _dataset_table(entries: Sequence[Quantity], *, short: bool = False) -> list[str]:
    rows: dict[tuple[str, ...], list[Quantity]] = {}  # that differ by inner and outer alone
    for entry in entries:
        meaning = entry.meaning.partition(_ABSENT)[0] if short else entry.meaning
        pair = meaning.replace("the outer", "the inner"), entry.name.replace("outer", "inner")
        rows.setdefault((*pair, entry.unit, entry.axes), []).append(entry)
    return table(
        ("name", "symbol", "axes", "unit", "meaning"),
        [
            (
                ", ".join(f"`{each.name}`" for each in those),
                ", ".join(filter(None, (each.symbol for each in those))),
                " × ".join(those[0].shape),
                unit,
                _meaning(those[0], short=short),
            )
            for (_, _, unit, _), those in rows.items()
        ],
    )


def _meaning(entry: Quantity, *, short: bool) -> str:
    """What a dataset is, without the names along an axis that the table of axes has."""
    meaning = entry.meaning.partition(_ABSENT)[0] if short else entry.meaning
    for axis, names in _ALONG.items():
        meaning = meaning.replace(f" ({names})", "") if axis in entry.shape else meaning
    return meaning


def _attribute_table(attributes: tuple[Attribute, ...]) -> list[str]:
    rows = [(f"`{entry.name}`", entry.kind, entry.meaning) for entry in attributes]
    return table(("name", "stored as", "meaning"), rows)


def _forms(layouts: Iterable[Layout]) -> str:
    """Page of what attributes hold that are stored as JSON."""
    entries = [*COMMON, *(entry for layout in layouts for entry in layout.further_attributes)]
    forms = {
        f"- `{entry.name}`: `{entry.form.words}`" for entry in entries if entry.kind in ("json", "records")
    }
    return "\n".join(["# Attributes stored as JSON", "", "`?`: may be absent.", "", *sorted(forms), ""])
