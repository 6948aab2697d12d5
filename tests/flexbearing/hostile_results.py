"""Hostile result files, each made from a good one by a function that changes it in its place."""

import json
import os
from collections.abc import Callable

import h5py
import numpy as np

from flexbearing.quantities.attributes import FORMAT
from flexbearing.results.hdf5_write import LENGTH_ALONE
from tests.flexbearing.resealed import resealed

LOAD, LIFE = "rigid/inner_load", "rigid/life_L10"
GROUPS = "rigid", "flexible", "iterations"
COORDINATES = {"roller": "roller_azimuth", "slice": "slice_position", "bar": "bar_azimuth"}
END_OF_FILE = slice(28, 36)  # of the superblock: where the file says that it ends
TEXT = h5py.string_dtype()
Change = Callable  # of a path

DTYPES = {
    "fixed text": "S8", "text": TEXT, "small float": "<f2", "single": "<f4",
    "long double": np.longdouble, "complex": "<c16", "integer": "<i8", "byte": "u1", "flag": "?",
    "big-endian": ">f8", "compound": [("a", "<f8"), ("b", "<i4")], "opaque": "V8",
    "reference": h5py.ref_dtype, "region": h5py.regionref_dtype, "ragged": h5py.vlen_dtype(np.dtype("<f8")),
    "array": np.dtype(("<f8", (3,))), "enumeration": h5py.enum_dtype({"a": 0, "b": 1}, basetype="i4"),
}  # fmt: skip
VALUES = {  # of an attribute of the root
    "whole number": 41, "number": 2.5, "text": "x", "empty text": "", "texts": ["a", "b"],
    "no texts": np.array([], dtype=TEXT), "numbers": [1, 2], "flag": True, "bytes": np.bytes_(b"abc"),
    "nothing": h5py.Empty("S1"), "record": np.zeros((), dtype=[("a", "<f8")]),
    "table of texts": np.array([["a", "b"]], dtype=TEXT), "unsigned": np.uint64(2**64 - 1),
}  # fmt: skip
SEALABLE = "whole number", "number", "text", "empty text", "texts", "no texts"


def sealed(change) -> Change:
    """Change a file with h5py; its digest is right again."""
    return lambda path: resealed(path, change)


def unsealed(change) -> Change:
    """Change a file with h5py; its digest stays, where no digest could be right."""

    def changed(path):
        with h5py.File(path, "a") as file:
            change(file)

    return changed


def binary(change) -> Change:
    return lambda path: path.write_bytes(change(path.read_bytes()))


def instead(make) -> Change:
    def changed(path):
        path.unlink()
        make(path)

    return changed


# -- what a file holds ---------------------------------------------------------------------------


def put(file, name, value):
    """Another attribute of the root."""
    if name in file.attrs:
        del file.attrs[name]
    file.attrs[name] = value


def put_on(dataset, name, value):
    """Another attribute of an array."""
    if name in dataset.attrs:
        del dataset.attrs[name]
    dataset.attrs[name] = value


def shortened_scale(file):
    """An axis with a place fewer than its arrays."""
    places = file["roller"][:-1]
    del file["roller"]
    file.create_dataset("roller", data=places).make_scale("roller")
    file["roller"].attrs["units"] = "rad"
    for group in GROUPS:
        for dataset in file[group].values():
            for axis in dataset.dims:
                if not len(axis):
                    axis.attach_scale(file["roller"])


def attribute(name, value):
    return sealed(lambda file: put(file, name, value))


def noted(words):
    return {"grade": "danger", "code": words[:20], "text": words}


def override(*settings):
    return sealed(lambda file: put(file, "case_overrides", [*file.attrs["case_overrides"], *settings]))


def text_of_case(change):
    return sealed(lambda file: put(file, "case_text", change(str(file.attrs["case_text"]))))


def array(place, **form):
    """Another array, with the unit and the axes of the good one."""

    def change(file):
        units, scales = file[place].attrs["units"], [axis[0] for axis in file[place].dims]
        del file[place]
        made = file.create_dataset(place, **form)
        made.attrs["units"] = units
        for axis, scale in zip(made.dims, scales, strict=False):
            axis.attach_scale(scale)

    return change


def load(**form):
    return array(LOAD, **form)


def in_place(name, value):
    """Something else under a name."""

    def change(file):
        if name in file:
            del file[name]
        file[name] = value(file) if callable(value) else value

    return unsealed(change)


def numbers(change, *names):
    """Other numbers in all arrays, or in those of some names."""

    def changed(file):
        for place in [f"{group}/{name}" for group in GROUPS for name in file[group]]:
            if not names or place.partition("/")[2] in names:
                array(place, data=np.asarray(change(file[place][()]), dtype="<f8"))(file)
        renew_scales(file)

    return changed


def renew_scales(file):
    """Places along the axes as the arrays have them now."""
    everything = [dataset for group in GROUPS for dataset in file[group].values() if dataset.ndim]
    axes = [[axis[0].name[1:] for axis in dataset.dims] for dataset in everything]
    lengths = {}
    for dataset, names in zip(everything, axes, strict=True):
        lengths.update(zip(names, dataset.shape, strict=True))
    for name, length in lengths.items():
        units = file[name].attrs.get("units")
        del file[name]
        place = f"rigid/{COORDINATES.get(name)}"
        alone = np.arange(1.0, length + 1) if name == "iteration" else np.zeros(length)
        made = file.create_dataset(name, data=file[place][()] if place in file else alone)
        made.make_scale(name if units else LENGTH_ALONE % length)
        if units:
            made.attrs["units"] = units
    for dataset, names in zip(everything, axes, strict=True):
        del dataset.attrs["DIMENSION_LIST"]
        for axis, name in zip(dataset.dims, names, strict=True):
            axis.attach_scale(file[name])


def filled(value, *names):
    return sealed(numbers(lambda values: np.full(values.shape, value), *names))


def diverged(value):
    def change(file):
        put(file, "status", "diverging")
        numbers(lambda values: np.full(values.shape, value))(file)

    return sealed(change)


def shortened(length, by):
    """All axes of a length by some shorter: fewer rollers, or slices."""

    def change(values):
        return values[tuple(slice(0, size - by if size == length else size) for size in values.shape)]

    return sealed(numbers(change))


def without(*places):
    def change(file):
        for place in places:
            del file[place]

    return change


def emptied(group):
    def change(file):
        del file[group]
        file.create_group(group)

    return sealed(change)


def virtual(source, name):
    def change(file):
        shape = file[LOAD].shape
        del file[LOAD]
        layout = h5py.VirtualLayout(shape=shape, dtype="<f8")
        layout[...] = h5py.VirtualSource(source, name, shape=shape)
        file.create_virtual_dataset(LOAD, layout)

    return unsealed(change)


def linked_in_a_ring(file):
    del file["rigid"], file["flexible"]
    file["rigid"], file["flexible"] = h5py.SoftLink("/flexible"), h5py.SoftLink("/rigid")


def many(count, make):
    def change(file):
        for number in range(count):
            make(file, f"more{number}")

    return unsealed(change)


def cut(share):
    return binary(lambda data: data[: int(share * len(data))])


def sparse(path):
    size = 10**12
    data = bytearray(path.read_bytes())
    data[END_OF_FILE] = size.to_bytes(8, "little")
    path.write_bytes(data)
    os.truncate(path, size)


def endless_zeros(path):
    path.touch()
    os.truncate(path, 10**13)


def zeros_behind(path):
    os.truncate(path, 3 * 10**9)


# -- the corpus ----------------------------------------------------------------------------------


def arrays(rollers):
    one = np.ones(rollers)
    shapes = {
        "scalar": (), "one": (1,), "row": (1, rollers), "column": (rollers, 1), "longer": (rollers + 1,),
        "shorter": (rollers - 1,), "square": (rollers, rollers), "none": (0,), "17 axes": (1,) * 17,
    }  # fmt: skip
    yield from (
        (f"load of {name}", unsealed(load(shape=(rollers,), dtype=kind))) for name, kind in DTYPES.items()
    )
    yield from (
        (f"life of {name}", unsealed(array(LIFE, shape=(), dtype=kind))) for name, kind in DTYPES.items()
    )
    yield from ((f"load as {name}", sealed(load(data=np.ones(shape)))) for name, shape in shapes.items())
    huge, pieces = {"shape": (10**12,), "dtype": "<f8"}, {"chunks": (10**6,)}
    yield from {
        "life with an axis": sealed(array(LIFE, data=np.ones(1))),
        "no space": unsealed(load(data=h5py.Empty("<f8"))),
        "10^12 numbers in pieces": unsealed(load(**huge, **pieces, fillvalue=1.0)),
        "10^12 numbers never written": unsealed(load(**huge)),
        "10^18 numbers": unsealed(load(shape=(10**9, 10**9), dtype="<f8", chunks=(10, 10))),
        "2^62 numbers": unsealed(load(shape=(2**31, 2**31), dtype="<f8", chunks=(1, 1))),
        "without limit": sealed(load(data=one, maxshape=(None,), chunks=(rollers,))),
        "pieces": sealed(load(data=one, chunks=(2,))),
        "piece beyond": unsealed(load(shape=(rollers,), maxshape=(None,), dtype="<f8", **pieces)),
        "compressed": sealed(load(data=one, compression="gzip")),
        "compressed by another": sealed(load(data=one, compression="lzf")),
        "bomb": unsealed(load(data=np.zeros(10**7), chunks=(10**7,), compression="gzip")),
        "shuffled": sealed(load(data=one, shuffle=True)),
        "scaled": sealed(load(data=one, scaleoffset=3)),
        "never written": sealed(load(shape=(rollers,), dtype="<f8")),
        "filled with NaN": sealed(load(shape=(rollers,), dtype="<f8", fillvalue=np.nan)),
        "array under two names": in_place(LOAD, lambda file: file["rigid/outer_load"]),
        "type as an array": in_place(LOAD, np.dtype("<f8")),
        "group as an array": unsealed(lambda file: (without(LOAD)(file), file.create_group(LOAD))),
        "array more": in_place("rigid/more", 1.0),
        "group in a group": unsealed(lambda file: file.create_group("rigid/more/a/b/c")),
        "3000 arrays": many(3000, lambda file, name: file["rigid"].__setitem__(name, 1.0)),
        "name of 60000 letters": in_place("rigid/" + "x" * 60_000, 1.0),
        "name of control": sealed(lambda file: file.__setitem__("rigid/\x1b[31mred\n", 1.0)),
        "name that is no text": unsealed(lambda file: h5py.h5g.create(file["rigid"].id, b"\xff\xfe")),
        "axis gone": sealed(lambda file: file[LOAD].attrs.__delitem__("DIMENSION_LIST")),
        "axis of text": unsealed(lambda file: put_on(file[LOAD], "DIMENSION_LIST", "roller")),
        "axis nowhere": unsealed(lambda file: without("roller")(file)),
        "axis of another array": unsealed(lambda file: file[LOAD].dims[0].attach_scale(file["slice"])),
        "axis of other length": sealed(shortened_scale),
        "axis without end": unsealed(lambda file: file.create_dataset("more", (10**12,), "<f8")),
        "axis that is none": sealed(lambda file: file["roller"].attrs.__delitem__("CLASS")),
        "axis of another name": sealed(lambda file: put_on(file["roller"], "NAME", np.bytes_("slice"))),
        "axis more": sealed(lambda file: file.create_dataset("more", data=np.ones(3)).make_scale("more")),
        "unit gone": sealed(lambda file: file[LOAD].attrs.__delitem__("units")),
        "unit more": sealed(lambda file: file[LOAD].attrs.__setitem__("more", "x")),
        "unit a number": unsealed(lambda file: file[LOAD].attrs.__setitem__("units", 1)),
        "unit huge": sealed(lambda file: file[LOAD].attrs.__setitem__("units", "x" * 60_000)),
        "unit nothing": unsealed(lambda file: file[LOAD].attrs.__setitem__("units", h5py.Empty("S1"))),
    }.items()
    for name in ("inner_load", "unknowns", "roller_azimuth", "stiffness_matrix", "slice_position"):
        yield f"no {name}", sealed(without(f"rigid/{name}", f"flexible/{name}"))


def links(rollers):
    stored = {"shape": (rollers,), "dtype": "<f8"}
    yield from {
        "external storage": unsealed(load(**stored, external=[("/etc/passwd", 0, 8 * rollers)])),
        "endless storage": unsealed(load(**stored, external=[("/dev/zero", 0, h5py.h5f.UNLIMITED)])),
        "virtual": virtual("/etc/passwd", "x"),
        "virtual of another result": virtual("other.h5", LOAD),
        "virtual of itself": virtual(".", LOAD),
        "external array": in_place(LOAD, h5py.ExternalLink("other.h5", LOAD)),
        "external system file": in_place(LOAD, h5py.ExternalLink("/etc/passwd", "/")),
        "external device": in_place("rigid", h5py.ExternalLink("/dev/zero", "/")),
        "external group": in_place("rigid", h5py.ExternalLink("other.h5", "rigid")),
        "external group beside": in_place("more", h5py.ExternalLink("other.h5", "rigid")),
        "soft link": in_place(LOAD, h5py.SoftLink("/rigid/outer_load")),
        "soft link to itself": in_place(LOAD, h5py.SoftLink(f"/{LOAD}")),
        "soft link to nowhere": in_place(LOAD, h5py.SoftLink("/nowhere")),
        "soft links in a ring": unsealed(linked_in_a_ring),
        "group in itself": in_place("rigid/loop", lambda file: file["rigid"]),
        "root in a group": in_place("rigid/loop", lambda file: file["/"]),
        "root as a group": in_place("rigid", lambda file: file["/"]),
        "group under another name": in_place("flexible", lambda file: file["rigid"]),
        "group as iterations": in_place("iterations", lambda file: file["rigid"]),
    }.items()


def groups():
    yield from {
        "type as a group": in_place("rigid", np.dtype("<f8")),
        "type beside": in_place("more", np.dtype("<f8")),
        "array as a group": in_place("rigid", 1.0),
        "array beside": in_place("more", 1.0),
        "group beside": unsealed(lambda file: file.create_group("more")),
        "300 groups": many(300, lambda file, name: file.create_group(name)),
        "name of a group that is no text": unsealed(lambda file: h5py.h5g.create(file.id, b"\xff\xfe")),
        "no groups": sealed(without(*GROUPS)),
    }.items()
    for group in GROUPS:
        yield f"no {group}", sealed(without(group))
        yield f"{group} empty", emptied(group)
        yield f"{group} renamed", sealed(lambda file, group=group: file.move(group, f"{group}x"))


def attributes(names):
    """Every attribute with every third value, so that each value is of many attributes."""
    for number, name in enumerate(names):
        yield f"no {name}", sealed(lambda file, name=name: file.attrs.__delitem__(name))
        for kind, value in list(VALUES.items())[number % 3 :: 3]:
            seal = sealed if kind in SEALABLE else unsealed
            yield f"{name} as {kind}", seal(lambda file, name=name, value=value: put(file, name, value))
    yield from {
        "reference": unsealed(lambda file: put(file, "title", file["rigid"].ref)),
        "10^5 notes": unsealed(lambda file: put(file, "notes", np.array(["x"] * 10**5, dtype=TEXT))),
        "note of 10 MB": attribute("notes", json.dumps([noted("x" * 10**7)])),
        "9000 long notes": sealed(lambda file: put(file, "notes", json.dumps([noted("x" * 10_000)] * 9000))),
        "title of a megabyte": attribute("title", "x " * 500_000),
        "3000 attributes": many(3000, lambda file, name: file.attrs.__setitem__(name, 1)),
        "attribute more": attribute("more", 1),
        "attribute that is no text": unsealed(nameless),
        "bad UTF-8": unsealed(lambda file: file.attrs.create("title", b"\xff\xfe", dtype=TEXT)),
        "digest of another file": unsealed(lambda file: put(file, "digest", "0" * 64)),
        "no digest": unsealed(lambda file: file.attrs.__delitem__("digest")),
        "format as a number": attribute("format", float(FORMAT)),
        "format of tomorrow": attribute("format", FORMAT + 1),
        "iterations below zero": attribute("iterations", -1),
        "iterations beyond": attribute("iterations", 2**62),
        "kind of balls": attribute("kind", "four_point_ball"),
        "status fine": attribute("status", "fine"),
        "status not solved": attribute("status", "not solved"),
        "status unfinished": attribute("status", "unfinished"),
        "time not a number": attribute("wall_time_s", float("nan")),
        "time infinite": attribute("wall_time_s", float("-inf")),
        "time huge": attribute("wall_time_s", 1e308),
        "title of control": attribute("title", "\x1b]0;owned\x07\x1b[2J\r\u202e"),
        "title of mathematics": attribute("title", r"$\frac{ $$ \undefined _^{"),
        "title of lines": attribute("title", "\n" * 500),
        "notes of control": (
            attribute("notes", json.dumps([noted(x) for x in ("\x1b[2J", "[bold]markup[/nothing]", "[/]")]))
        ),
        "method of mathematics": attribute("method", "$_^$[/bold]"),
        "calibrated of control": attribute("calibrated", '{"\\u001b[2J": 1}'),
    }.items()


def nameless(file):
    space = h5py.h5s.create(h5py.h5s.SCALAR)
    h5py.h5a.create(file.id, b"\xff", h5py.h5t.NATIVE_INT64, space)


def cases(rollers):
    yield from {
        "case: nothing": attribute("case_text", ""),
        "case: no TOML": attribute("case_text", "= = ["),
        "case: nested": attribute("case_text", "a = " + "[" * 5000),
        "case: huge": attribute("case_text", "# " + "x" * 10**7),
        "case: of balls": attribute("case_text", 'kind = "four_point_ball"\n'),
        "case: misspelt": text_of_case(lambda text: text.replace("rollers", "rollers_")),
        "case: overrides": attribute("case_overrides", ["x"]),
        "case: other rollers": override(f"bearing.rollers={rollers + 1}"),
        "case: rigid": attribute("case_overrides", ["inner.kind=rigid", "outer.kind=rigid"]),
        "case: drawing": override("outer.kind=step", "outer.file=/dev/zero"),
        "case: elsewhere": attribute("case_file", "/dev/zero"),
        "case: in a folder": attribute("case_file", "/etc"),
        "case: control": attribute("case_file", "\x1b[31m\n"),
        "case: long name": attribute("case_file", "x" * 10_000),
    }.items()


def contents(rollers, slices):
    yield from {
        "NaN load": sealed(lambda file: file["flexible/inner_load"].__setitem__(0, np.nan)),
        "infinite load": sealed(lambda file: file["flexible/inner_load"].__setitem__(0, np.inf)),
        "NaN life": sealed(lambda file: file["flexible/life_L10"].__setitem__((), np.nan)),
        "numbers: NaN": filled(np.nan),
        "one roller fewer": shortened(rollers, 1),
        "one roller left": shortened(rollers, rollers - 1),
        "no rollers": shortened(rollers, rollers),
        "one slice fewer": shortened(slices, 1),
        "no slices": shortened(slices, slices),
        "one unknown fewer": sealed(numbers(lambda values: values[:-1], "unknowns")),
        "no unknowns": sealed(numbers(lambda values: values[:0], "unknowns")),
    }.items()
    sizes = {"zero": 0.0, "one": 1.0, "minus one": -1.0, "tiny": 5e-324, "huge": 1e300, "minus huge": -1e300}
    yield from ((f"numbers: {word}", filled(value)) for word, value in sizes.items())
    odd = {"zero": 0.0, "NaN": np.nan, "infinite": np.inf, "huge": 1e300}
    yield from ((f"diverged: {word}", diverged(value)) for word, value in odd.items())
    for name in (
        "roller_azimuth",
        "slice_position",
        "inner_load",
        "stiffness_matrix",
        "unknowns",
        "residual",
    ):
        yield f"{name}: zero", filled(0.0, name)
        yield f"{name}: huge", filled(1e300, name)


def files():
    yield from {
        "empty": binary(lambda data: b""),
        "one byte": binary(lambda data: data[:1]),
        "signature alone": binary(lambda data: data[:8]),
        "superblock alone": binary(lambda data: data[:48]),
        "zeros": binary(lambda data: bytes(len(data))),
        "text": binary(lambda data: b"case"),
        "rest behind": binary(lambda data: data + b"rest" * 1000),
        "block before": binary(lambda data: bytes(512) + data),
        "noise": binary(lambda data: data[:8] + np.random.default_rng(1).bytes(5000)),
        "half of zeros": binary(lambda data: data[: len(data) // 2].ljust(len(data), b"\0")),
        "NUL in a name": binary(lambda data: data.replace(b"inner_load", b"inner\0load")),
        "another name": binary(lambda data: data.replace(b"inner_load", b"inner_lord")),
        "10^12 bytes": sparse,
        "10^13 zeros": instead(endless_zeros),
        "3 GB of zeros behind": zeros_behind,
        "3 GB of zeros": instead(lambda path: (path.touch(), zeros_behind(path))),
        "pipe": instead(os.mkfifo),
        "folder": instead(lambda path: path.mkdir()),
        "endless device": instead(lambda path: path.symlink_to("/dev/zero")),
        "empty device": instead(lambda path: path.symlink_to("/dev/null")),
        "link to itself": instead(lambda path: path.symlink_to(path)),
        "missing": instead(lambda path: None),
    }.items()
    yield from ((f"cut at {share}", cut(share)) for share in (0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99))


def corpus(names, rollers, slices):
    """Every change by its name; `names` are the attributes that the good file has."""
    sources = {
        "array": arrays(rollers), "link": links(rollers), "group": groups(), "attribute": attributes(names),
        "case": cases(rollers), "content": contents(rollers, slices), "file": files(),
    }  # fmt: skip
    return {
        f"{kind}: {name.removeprefix('case: ')}": change
        for kind, made in sources.items()
        for name, change in made
    }
