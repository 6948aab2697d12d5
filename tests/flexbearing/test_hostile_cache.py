"""Files in the cache that somebody else put there: nothing is executed, followed or read without end."""

import json
import os
import resource
import time
from dataclasses import fields, replace
from hashlib import sha256
from importlib import import_module
from io import BytesIO, FileIO
from pathlib import Path
from shutil import copytree

import numpy as np
import pytest

import flexbearing
from fem.condense import condense
from flexbearing.cache import Cache, configured, key, listing, store
from flexbearing.cache.archive import DTYPES, Damaged, packed, unpacked
from flexbearing.cache.forms import RECORDS, WrongForm
from tests.flexbearing.test_bolted_rings import SLEWING, SMALL
from tests.flexbearing.test_cache import PARTS, RACEWAY, Counted, harmonics, raceway, same
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
RING = ("inner.kind=rigid", "outer.kind=ring", "outer.thickness=3.6 mm", "accuracy.slices=4")
CAGE = ("inner.kind=rigid", "accuracy.slices=4", "accuracy.structure=smeared")
SOLID = (
    *RING, "bearing.rollers=12", "accuracy.structure=solid", "accuracy.element_order=2",
    "accuracy.mesh_size=12 mm", "accuracy.raceway_mesh_size=4 mm", "accuracy.patch_width=1.5 mm",
    "accuracy.axial_shapes=2", "accuracy.threads=1",
)  # fmt: skip
SHAFT = ["outer.kind=rigid", "accuracy.element_order=2", "accuracy.slices=8"]
SEAT = [*RING, "operation.temperatures.outer_seat=168 degC"]
RUNS = {
    "ring": (PAPER, RING), "cage": (PAPER, CAGE), "solid": (PAPER, SOLID), "groove": (SLEWING, SMALL),
    "shaft": (PAPER, SHAFT), "seat": (PAPER, SEAT),
    "springs": (PAPER, [*RING, "outer.support=foundation", "outer.foundation_radial=300 N/mm^3"]),
}  # fmt: skip
NAME = key.digest(PARTS)


@pytest.fixture
def cache(tmp_path):
    return Cache(tmp_path / "rings", limit=10**6)


@pytest.fixture
def entry(cache):
    """Path of the entry of PARTS, which is not there yet."""
    cache.folder.mkdir()
    return cache.folder / f"{NAME}{store.SUFFIX}"


def sealed(header, arrays=b"", name=NAME):
    """A file with a right digest."""
    text = header if isinstance(header, bytes) else json.dumps(header).encode()
    content = len(text).to_bytes(8, "little") + text
    content += bytes(-len(content) % 64) + arrays
    return sha256(name.encode() + b"\0" + content).digest() + content


def taken_apart(data):
    """Header and arrays of a good file."""
    length = int.from_bytes(data[32:40], "little")
    return json.loads(data[40 : 40 + length]), data[32 + 8 + length + -(8 + length) % 64 :]


def good():
    return taken_apart(packed(NAME, RACEWAY, raceway()))


def with_field(name, value):
    header, arrays = good()
    header["fields"][name] = value
    return sealed(header, arrays)


def with_array(name, **changes):
    header, arrays = good()
    header["fields"][name] |= changes
    return sealed(header, arrays)


def with_number(value):
    """A good header, but the first number of the first array is another one."""
    header, arrays = good()
    return sealed(header, np.float64(value).tobytes() + arrays[8:])


def older(command):
    """The layout before: a digest and an npz archive, whose tree names what to call."""
    tree = {"class": ["os", "system"], "fields": {"command": command}}
    file = BytesIO()
    np.savez(file, tree=np.frombuffer(json.dumps(tree).encode(), dtype=np.uint8))
    return sha256(file.getvalue()).digest() + file.getvalue()


HOSTILE = {
    "empty": lambda: b"",
    "digest alone": lambda: sealed(b"")[:32],
    "no header": lambda: sealed(b""),
    "header beyond the file": lambda: (
        sha256(NAME.encode() + b"\0" + b"\xff" * 8).digest() + b"\xff" * 8
    ),
    "header of zeros": lambda: sealed(bytes(2**16)),
    "header too long": lambda: sealed(b" " * 2**17),
    "not JSON": lambda: sealed(b"{"),
    "not UTF-8": lambda: sealed(b"\xff\xfe{"),
    "nested deeply": lambda: sealed(b"[" * 60_000),
    "digits without end": lambda: sealed(b'{"class": ' + b"9" * 60_000 + b"}"),
    "a list": lambda: sealed([]),
    "a number": lambda: sealed(1),
    "no class": lambda: sealed({"fields": {}}),
    "class is a list": lambda: sealed({"class": ["os", "system"], "fields": {"command": "true"}}),
    "class of the system": lambda: sealed({"class": "os.system", "fields": {"command": "true"}}),
    "another class": lambda: sealed(*taken_apart(packed(NAME, "HarmonicCompliance", harmonics()))),
    "part of a class": lambda: sealed({"class": "Elastic", "fields": {"youngs_modulus": 1}}),
    "no fields": lambda: sealed({"class": RACEWAY}),
    "fields missing": lambda: sealed({"class": RACEWAY, "fields": {}}),
    "fields a list": lambda: sealed({"class": RACEWAY, "fields": []}),
    "not a number": lambda: with_field("support_stiffness", float("nan")),
    "text for a number": lambda: with_field("support_stiffness", "1e8"),
    "flag for a number": lambda: with_field("support_stiffness", True),
    "huge number": lambda: with_field("support_stiffness", 10**4000),
    "count below zero": lambda: with_field("unknowns", -1),
    "count with a fraction": lambda: with_field("unknowns", 1.5),
    "list for a mapping": lambda: with_field("seconds", [1.0]),
    "text among numbers": lambda: with_field("seconds", {"mesh": "long"}),
    "number for an array": lambda: with_field("azimuths", 1.0),
    "list for an array": lambda: with_field("azimuths", [1.0]),
    "array without shape": lambda: with_field("azimuths", {"dtype": "<f8", "order": "C"}),
    "array with more": lambda: with_array("azimuths", offset=0),
    "objects": lambda: with_array("azimuths", dtype="|O"),
    "dates": lambda: with_array("azimuths", dtype="<M8[s]"),
    "records": lambda: with_array("azimuths", dtype=[["a", "<f8"]]),
    "whole numbers": lambda: with_array("azimuths", dtype="<i8"),
    "order": lambda: with_array("azimuths", order="A"),
    "10^12 numbers": lambda: with_array("azimuths", shape=[10**12]),
    "10^40 numbers": lambda: with_array("azimuths", shape=[10**10] * 4),
    "no numbers": lambda: with_array("azimuths", shape=[0]),
    "sizes below zero": lambda: with_array("azimuths", shape=[-1]),
    "sizes with fractions": lambda: with_array("azimuths", shape=[3.0]),
    "flags for sizes": lambda: with_array("azimuths", shape=[True]),
    "text for a shape": lambda: with_array("azimuths", shape="3"),
    "70 axes": lambda: with_array("azimuths", shape=[1] * 70),
    "fewer axes": lambda: with_array("absolute", shape=[36]),
    "fewer rollers": lambda: with_array("azimuths", shape=[2]),
    "rest": lambda: sealed(good()[0], good()[1] + b"rest"),
    "arrays too short": lambda: sealed(good()[0], good()[1][:-8]),
    "NaN among numbers": lambda: with_number(np.nan),
    "infinite among numbers": lambda: with_number(np.inf),
    "impossible among numbers": lambda: with_number(1e300),
    "for another part": lambda: packed(key.digest("another"), RACEWAY, raceway()),
    "older layout": lambda: older("true"),
}  # fmt: skip


@pytest.mark.parametrize("kind", HOSTILE)
def test_what_is_no_entry_is_computed_again_and_replaced(cache, entry, kind):
    notes, compute = [], Counted()
    entry.write_bytes(HOSTILE[kind]())
    same(cache.cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    assert compute.calls == 1
    assert len(notes) == 1
    assert notes[0].startswith(f"{entry} was damaged (")
    same(cache.cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    assert (compute.calls, notes[1:]) == (1, ["taken from the cache"])


@pytest.mark.parametrize("form", ["older", "list", "text"])
def test_file_that_names_a_command_runs_none(cache, entry, tmp_path, form):
    proof = tmp_path / "executed"
    command = {"command": f"touch {proof}"}
    entry.write_bytes({
        "older": older(command["command"]),
        "list": sealed({"class": ["os", "system"], "fields": command}),
        "text": sealed({"class": "os.system", "fields": command}),
    }[form])  # fmt: skip
    cache.cached(RACEWAY, PARTS, Counted(), [].append)
    assert not proof.exists()


def test_module_that_a_file_names_is_not_imported(cache, entry, tmp_path, monkeypatch):
    (tmp_path / "fem_of_a_stranger.py").write_text("raise SystemExit('imported')")
    monkeypatch.syspath_prepend(tmp_path)
    entry.write_bytes(sealed({"class": ["fem_of_a_stranger", "Raceway"], "module": "fem_of_a_stranger"}))
    cache.cached(RACEWAY, PARTS, Counted(), [].append)


def test_entry_under_the_name_of_another_part_is_damaged(cache):
    cache.cached(RACEWAY, 1, Counted(raceway(1)), [].append)
    (one,) = cache.entries()
    one.path.rename(cache.folder / f"{key.digest(2)}{store.SUFFIX}")
    notes, compute = [], Counted(raceway(2))
    same(cache.cached(RACEWAY, 2, compute, notes.append), compute.value)
    assert "the digest does not fit" in notes[0]


def test_entry_that_says_it_is_of_another_part_is_computed_again(cache):
    cache.cached(RACEWAY, PARTS, Counted(raceway(1)), [].append)
    notes, compute = [], Counted(raceway(2))
    again = cache.cached(RACEWAY, PARTS, compute, notes.append, lambda kept: kept.azimuths[0] == 7)
    same(again, compute.value)
    assert "made from another part" in notes[0]


def link(target):
    return lambda entry: entry.symlink_to(target)


def sparse(entry):
    entry.touch()
    os.truncate(entry, 10**12)


def good_beside(entry):
    beside = entry.with_name("beside")
    beside.write_bytes(packed(NAME, RACEWAY, raceway()))
    entry.symlink_to(beside)


IN_ITS_PLACE = {
    "folder": Path.mkdir,
    "pipe": os.mkfifo,
    "endless device": link("/dev/zero"),
    "link to nowhere": link("nowhere"),
    "link to itself": lambda entry: entry.symlink_to(entry),
    "link to a good file": good_beside,
    "10^12 bytes": sparse,
}


@pytest.mark.parametrize("kind", IN_ITS_PLACE)
def test_what_is_no_file_is_neither_followed_nor_read(cache, entry, kind, monkeypatch):
    class Unread(FileIO):
        def read(self, *_):
            raise AssertionError("it was read")

    IN_ITS_PLACE[kind](entry)
    notes, compute = [], Counted()
    monkeypatch.setattr(os, "fdopen", Unread)
    same(cache.cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    assert compute.calls == 1
    assert notes[0].startswith((f"{entry} was damaged (", f"{entry} is damaged ("))
    if kind == "folder":  # it may hold something of somebody
        assert "cannot be removed (Is a directory)" in notes[0]
        assert notes[1] == f"the cache {cache.folder} cannot be written: Is a directory"
    else:
        assert entry.is_file()
        assert not entry.is_symlink()


def test_file_that_may_not_be_read_is_computed_again(cache, entry, monkeypatch):
    def forbidden(path, flags):
        raise PermissionError(13, "Permission denied")

    entry.write_bytes(packed(NAME, RACEWAY, raceway()))
    monkeypatch.setattr(store.os, "open", forbidden)  # the superuser may read what nobody may
    compute = Counted()
    notes = []
    same(cache.cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    assert compute.calls == 1
    assert notes[0].startswith(f"{entry} was damaged (Permission denied)")


def test_what_cannot_be_removed_is_noted(cache, entry, monkeypatch):
    def forbidden(path, missing_ok=False):
        raise PermissionError(13, "Permission denied")

    entry.write_bytes(b"damaged")
    monkeypatch.setattr(Path, "unlink", forbidden)
    notes, compute = [], Counted()
    same(cache.cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    assert notes[0] == (
        f"{entry} is damaged (the digest does not fit) and cannot be removed (Permission denied); "
        "the ring is computed again"
    )


@pytest.mark.parametrize("folder", ["x" * 300, "file", "file/below", "/proc/nothing"])
def test_folder_that_cannot_be_is_noted_and_not_fatal(tmp_path, folder):
    (tmp_path / "file").touch()
    notes, compute, bad = [], Counted(), Cache(tmp_path / folder)
    same(bad.cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    assert compute.calls == 1
    assert [" cannot be " in note for note in notes] == [True] * len(notes)
    assert notes
    assert (bad.entries(), bad.clear(), bad.size) == ([], 0, 0)
    assert listing(bad).startswith("0 rings")


def test_home_of_nobody_is_a_folder_of_this_name(monkeypatch):
    monkeypatch.setenv("FLEXBEARING_CACHE", "~no such user/rings")
    assert configured().folder == Path("~no such user/rings")


def test_value_that_cannot_be_kept_is_noted(cache):
    notes, odd = [], replace(raceway(), support_stiffness=float("nan"))
    assert cache.cached(RACEWAY, PARTS, Counted(odd), notes.append) is odd
    assert notes == ["not kept: RacewayCompliance.support_stiffness: nan is no number"]


def test_clearing_and_listing_touch_entries_only(cache, entry):
    cache.cached(RACEWAY, PARTS, Counted(), [].append)
    outside = cache.folder.parent / "outside"
    outside.write_text("mine")
    digit = iter("0123456789")
    strange = [cache.folder / name for name in ("mine.ring", "notes.txt", "thesis.part", "ring")]
    for path in strange:
        path.write_text("mine")
    folder, linked = (cache.folder / f"{next(digit) * 64}{store.SUFFIX}" for _ in range(2))
    folder.mkdir()
    linked.symlink_to(outside)
    long_ago = (time.time() - 1e6,) * 2
    for path in strange:
        os.utime(path, long_ago)
    assert listing(cache).splitlines()[0].startswith(NAME[:12])
    assert [one.path for one in cache.entries()] == [entry]
    assert cache.clear() == 1
    assert not entry.exists()
    assert [path.read_text() for path in strange] == ["mine"] * 4
    assert folder.is_dir()
    assert linked.is_symlink()
    assert outside.read_text() == "mine"


@pytest.mark.parametrize("date", [2.0**40, -1e9, 0])
def test_any_date_of_a_file_can_be_listed(cache, entry, date):
    cache.cached(RACEWAY, PARTS, Counted(), [].append)
    os.utime(entry, (date, date))
    assert NAME[:12] in listing(cache)


@pytest.mark.parametrize("name", RECORDS)
def test_table_has_the_fields_of_its_classes(name):
    kept = getattr(import_module(RECORDS[name].module), name)
    assert set(RECORDS[name].fields) == {field.name for field in fields(kept) if field.init}


@pytest.fixture(scope="module")
def first_runs(tmp_path_factory):
    """Result and cache of a first run of each kind of part, each computed once."""
    place, known = tmp_path_factory.mktemp("first"), {}

    def computed(run):
        if run not in known:
            with pytest.MonkeyPatch.context() as patch:
                patch.setenv("FLEXBEARING_CACHE", str(place / run))
                case, changes = RUNS[run]
                known[run] = flexbearing.run(case, changes, output=place / f"{run}.h5")
        return known[run], place / run

    return computed


@pytest.mark.slow
@pytest.mark.parametrize("run", RUNS)
def test_every_class_that_runs_keep_is_in_the_table(run, tmp_path, monkeypatch, first_runs):
    """Each kind of part is kept by a first run, and a second run is equal to the digit."""
    first, kept = first_runs(run)
    monkeypatch.setenv("FLEXBEARING_CACHE", str(kept))
    second = flexbearing.run(RUNS[run][0], RUNS[run][1], output=tmp_path / "second.h5")
    kinds = {json.loads(_header(entry.path))["class"] for entry in configured().entries()}
    assert kinds == {
        "ring": {"HarmonicCompliance"}, "shaft": {"HarmonicCompliance", "BondedGrowth"},
        "seat": {"HarmonicCompliance", "RacewayGrowth"}, "cage": {"HarmonicCompliance"},
        "solid": {"RacewayCompliance"}, "groove": {"GrooveCompliance"},
        "springs": {"RingOnFoundation"},
    }[run]  # fmt: skip
    for name, values in first.flexible.items():
        assert values.tobytes() == second.flexible[name].tobytes(), name


def _header(path):
    data = path.read_bytes()
    return data[40 : 40 + int.from_bytes(data[32:40], "little")]


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    "run", ["ring", *(pytest.param(run, marks=pytest.mark.slow) for run in ("solid", "groove", "springs"))]
)
@pytest.mark.parametrize("content", ["zero", "negative", "random", "large"])
def test_wrong_content_with_a_right_digest_ends_with_a_result(
    run, content, tmp_path, monkeypatch, first_runs
):
    """A file can always lie about numbers; what follows is an answer or a status, never an error."""
    copytree(first_runs(run)[1], tmp_path / "rings")
    monkeypatch.setenv("FLEXBEARING_CACHE", str(tmp_path / "rings"))
    for one in configured().entries():
        kind = json.loads(_header(one.path))["class"]
        value = unpacked(one.path.stem, kind, one.path.read_bytes())
        name = {RACEWAY: "absolute", "RingOnFoundation": "face"}.get(kind, "response")
        right = getattr(value, name)
        draw = np.random.default_rng(1).normal(size=right.shape)
        wrong = {
            "zero": 0 * draw,
            "negative": -right,
            "random": draw * abs(right).max(),
            "large": 0 * draw + 0.5,
        }
        one.path.write_bytes(packed(one.path.stem, kind, replace(value, **{name: wrong[content]})))
    result = flexbearing.run(RUNS[run][0], RUNS[run][1], output=tmp_path / "two.h5")
    assert result.attributes["status"] in (
        "converged",
        "not solved",
        "diverging",
        "iteration limit",
        "stagnating",
    )


def test_arrays_from_the_cache_are_aligned_and_cannot_be_written_to():
    kept = unpacked(NAME, "HarmonicCompliance", packed(NAME, "HarmonicCompliance", harmonics()))
    for array in (kept.harmonics, kept.response):
        assert array.flags.aligned
        assert not array.flags.writeable


def test_order_of_an_array_is_kept():
    value = raceway()
    turned = replace(value, translation=np.asfortranarray(value.translation))
    kept = unpacked(NAME, RACEWAY, packed(NAME, RACEWAY, turned))
    assert kept.translation.flags.f_contiguous
    assert np.array_equal(kept.translation, value.translation)


def test_dtypes_beyond_the_table_are_not_kept():
    with pytest.raises(WrongForm, match="kept are <f8"):
        packed(NAME, RACEWAY, replace(raceway(), azimuths=np.zeros(3, dtype=np.float32)))
    assert all(np.dtype(name).itemsize % 8 == 0 for name in DTYPES)


def test_reading_takes_no_more_memory_than_the_file(cache, entry):
    """10^12 elements are declared by a file of 300 bytes."""
    entry.write_bytes(with_array("azimuths", shape=[10**12]))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(Damaged, match="longer than the file"):
        unpacked(NAME, RACEWAY, entry.read_bytes())
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 50_000  # kB


def test_answers_of_condensing_are_kept_or_known_not_to_be():
    """A class that `condense` may return and nobody thought of would fail here."""
    not_kept = {"RingOnLines", "PlanetRim"}  # more than is kept
    names = set(condense.__annotations__["return"].split(" | "))
    assert names - not_kept == {
        "RingOnFoundation",
        *(name for name in RECORDS if name.endswith("Compliance")),
    }
