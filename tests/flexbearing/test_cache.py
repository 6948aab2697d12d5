"""Condensed rings on disk: found again, never wrong, never in the way."""

import os
import re
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, make_dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import fem
from fem.parts.step_solid import Named, StepSolid
from fem.raceway.compliance import RacewayCompliance
from fem.raceway.harmonics import HarmonicCompliance
from flexbearing.cache import Cache, configured, key, listing, recent, store
from flexbearing.cache.archive import Damaged, packed, unpacked
from flexbearing.cache.forms import WrongForm

STEEL = fem.Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
CAGE = fem.SquirrelCage(
    raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, bars=24, bar_width=4e-3, bar_thickness=2.6e-3,
    bar_length=10.25e-3, flange_length=5e-3, elastic=STEEL,
)  # fmt: skip
PATCHES = fem.Patches(azimuths=(0.0, 0.5), length=9e-3, axial_modes=2, width=1e-3)
MESH = fem.MeshSize(order=3, size=3e-3, raceway_size=2e-3)
RACEWAY = "RacewayCompliance"
PARTS = ("condense", CAGE, PATCHES, MESH)
SOLID = StepSolid(
    drawing=b"ISO-10303-21;a",
    raceway_diameter=75e-3,
    clamps=(Named("foot"),),
    elastic=STEEL,
    source="one.step",
)


def raceway(seed=0):
    draw = np.random.default_rng(seed).normal
    return RacewayCompliance(
        azimuths=draw(size=3), absolute=1e-9 * draw(size=(3, 2, 3, 2)),
        translation=1e-9 * draw(size=(2, 3, 2)),
        support_stiffness=np.float64(1.5e8), unknowns=np.int64(7), elements=5, seconds={"mesh": 0.25},
    )  # fmt: skip


def harmonics():
    draw = np.random.default_rng(1).normal
    return HarmonicCompliance(
        harmonics=np.arange(-9, 10),
        response=1e-9 * draw(size=(19, 2, 19, 2)) + 1e-9j * draw(size=(19, 2, 19, 2)),
        radius=37.5e-3, length=9e-3, elastic=STEEL, bars=None, unknowns=7, elements=5, seconds={},
    )  # fmt: skip


def same(one, two):
    assert type(one) is type(two)
    for name, value in vars(one).items():
        other = getattr(two, name)
        if isinstance(value, np.ndarray):
            assert (other.dtype, other.shape, other.tobytes()) == (value.dtype, value.shape, value.tobytes())
        else:
            assert other == value


class Counted:
    """Computes a ring, and counts how often."""

    def __init__(self, value=None):
        self.value, self.calls = value or raceway(), 0

    def __call__(self):
        self.calls += 1
        return self.value


@pytest.fixture
def cache(tmp_path):
    return Cache(tmp_path / "rings", limit=10**6)


@pytest.fixture
def notes():
    return []


@pytest.mark.parametrize("value", [raceway(), harmonics()], ids=["raceway", "harmonics"])
def test_what_is_kept_comes_back_bit_by_bit(value):
    kind = type(value).__name__
    same(value, unpacked("one", kind, packed("one", kind, value)))


def test_second_time_nothing_is_computed(cache, notes):
    compute = Counted()
    first, second = (cache.cached(RACEWAY, PARTS, compute, notes.append) for _ in range(2))
    same(first, second)
    assert (compute.calls, notes) == (1, ["taken from the cache"])


OTHERS = {
    "part": ("condense", replace(CAGE, bars=23), PATCHES, MESH),
    "material": ("condense", replace(CAGE, elastic=replace(STEEL, poisson_ratio=0.3)), PATCHES, MESH),
    "last digit": ("condense", CAGE, replace(PATCHES, width=np.nextafter(1e-3, 1)), MESH),
    "azimuths": ("condense", CAGE, replace(PATCHES, azimuths=(0.0, -0.5)), MESH),
    "mesh": ("condense", CAGE, PATCHES, replace(MESH, order=2)),
    "method": ("sector", CAGE, PATCHES, MESH),
    "more": (*PARTS, None),
}


@pytest.mark.parametrize("change", OTHERS)
def test_other_data_have_another_name(change):
    assert key.digest(OTHERS[change]) != key.digest(PARTS)


def test_equal_data_have_the_same_name():
    assert key.digest(("condense", replace(CAGE), replace(PATCHES), replace(MESH))) == key.digest(PARTS)


def test_content_of_a_drawing_counts_and_not_what_it_is_called():
    assert key.digest(replace(SOLID, source="two.step")) == key.digest(SOLID)
    assert key.digest(replace(SOLID, drawing=b"ISO-10303-21;b")) != key.digest(SOLID)


def test_other_code_in_any_room_has_another_name(monkeypatch, tmp_path):
    source = tmp_path / "assembly" / "factorisation.py"
    source.parent.mkdir()
    monkeypatch.setattr(fem, "__path__", [str(tmp_path)])
    names = []
    try:
        for text in ("RESIDUAL = 1e-9", "RESIDUAL = 1e-8"):
            source.write_text(text)
            key.code.cache_clear()
            names.append(key.digest(PARTS))
    finally:
        key.code.cache_clear()
    assert names[0] != names[1]


LOOKALIKES = [
    1, 1.0, "1", b"1", (1,), None, True, "None", {"1": 1}, np.array(1.0), np.array([1]), np.array([[1]]),
    ((1, 2), 3), (1, (2, 3)), {"float": (1.0).hex()},
]  # fmt: skip


def test_lookalikes_have_different_names():
    assert len({key.digest(value) for value in LOOKALIKES}) == len(LOOKALIKES)


@pytest.mark.parametrize("value", [Path("a"), object(), np.array(["a"]), {1, 2}, lambda: 0])
def test_what_could_change_in_secret_has_no_name(value):
    with pytest.raises(TypeError, match="cannot name a condensed ring"):
        key.digest((PARTS, value))


def test_fields_alike_of_another_class_have_another_name():
    clamped, seated = make_dataclass("Clamped", ["width"]), make_dataclass("Seated", ["width"])
    assert key.digest(clamped(1e-2)) != key.digest(seated(1e-2))


@given(place=st.floats(0, 1, exclude_max=True), bit=st.integers(0, 7))
@settings(max_examples=60)
def test_every_damaged_bit_is_seen(place, bit):
    data = bytearray(packed("one", RACEWAY, raceway()))
    data[int(place * len(data))] ^= 1 << bit
    with pytest.raises(Damaged):
        unpacked("one", RACEWAY, bytes(data))


@pytest.mark.parametrize("keep", [0, 10, 32, 500, -1])
def test_shortened_file_is_computed_again(cache, notes, keep):
    compute = Counted()
    cache.cached(RACEWAY, PARTS, compute, notes.append)
    (entry,) = cache.entries()
    entry.path.write_bytes(entry.path.read_bytes()[:keep])
    same(cache.cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    cache.cached(RACEWAY, PARTS, compute, notes.append)
    assert compute.calls == 2
    assert [note.split("; ")[-1] for note in notes] == [
        "it is removed and the ring computed again", "taken from the cache",
    ]  # fmt: skip


@dataclass(frozen=True)
class Foreign:
    value: float = 1.0
    seconds: dict = field(default_factory=dict)


@pytest.mark.parametrize("value", [Foreign(), np.array([object()]), {1: 2.0}, [1.0]])
def test_only_rings_are_kept(value):
    with pytest.raises(WrongForm, match="is no RacewayCompliance"):
        packed("one", RACEWAY, value)


def test_ring_used_longest_ago_goes_first(cache, notes):
    size = len(packed("one", RACEWAY, raceway()))
    small = Cache(cache.folder, limit=int(2.5 * size))
    for number, age in ((0, 300), (1, 200)):
        small.cached(RACEWAY, number, Counted(), notes.append)
        newest = small.entries()[0].path
        os.utime(newest, (time.time() - age,) * 2)
    small.cached(RACEWAY, 0, Counted(), notes.append)  # used: now 1 is the oldest
    small.cached(RACEWAY, 2, Counted(), notes.append)
    kept = {entry.path.stem for entry in small.entries()}
    assert kept == {key.digest(0), key.digest(2)}
    assert small.size == 2 * size


def test_ring_above_the_limit_is_not_kept(cache, notes):
    Cache(cache.folder, limit=10).cached(RACEWAY, PARTS, Counted(), notes.append)
    assert not cache.entries()
    assert re.fullmatch(r"not kept: \d+ bytes are more than the whole cache may have, 10", notes[0])


def test_many_at_once_agree(cache, notes):
    """Writers, readers and one who clears the folder: every answer is the right one, and no rest is left."""
    values = [raceway(seed) for seed in range(3)]

    def work(number):
        if number % 10 == 9:
            cache.clear()
        same(cache.cached(RACEWAY, number % 3, Counted(values[number % 3]), notes.append), values[number % 3])

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(work, range(150)))
    assert {note for note in notes} <= {"taken from the cache"}
    assert all(path.suffix == store.SUFFIX for path in cache.folder.iterdir())


def test_folder_that_cannot_be_written_is_told(tmp_path, notes):
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    compute = Counted()
    same(Cache(blocked / "rings").cached(RACEWAY, PARTS, compute, notes.append), compute.value)
    assert compute.calls == 1
    assert [note.split(": ")[-1] for note in notes] == ["Not a directory"] * 2


def test_full_disk_leaves_nothing_behind(cache, notes, monkeypatch):
    def full(self, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    cache.cached(RACEWAY, PARTS, Counted(), notes.append)
    assert notes == [f"the cache {cache.folder} cannot be written: No space left on device"]
    assert not list(cache.folder.iterdir())


def test_what_finds_no_room_on_the_disk_is_computed_once_by_each_process(cache, notes, monkeypatch):
    def full(self, target):
        raise OSError(28, "No space left on device")

    compute = Counted()
    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", full)
        found = [cache.cached(RACEWAY, PARTS, compute, notes.append) for _ in range(3)]
    assert compute.calls == 1
    assert found[1] is found[2] is compute.value
    assert cache.cached(RACEWAY, PARTS, compute, notes.append) is compute.value
    recent._rings.clear()  # as in another process
    cache.cached(RACEWAY, PARTS, compute, notes.append)
    assert compute.calls == 2
    assert [entry.path.exists() for entry in cache.entries()] == [True]


def test_what_a_killed_process_left_is_removed_after_an_hour(cache, notes, monkeypatch):
    def killed(*_):
        raise OSError

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", killed)
        patch.setattr("flexbearing.files.atomic._remove", lambda part: None)
        for name in ("old", "new"):
            cache.cached(RACEWAY, name, Counted(), notes.append)
    old, new = cache.folder.iterdir()
    os.utime(old, (time.time() - 4000,) * 2)
    cache.cached(RACEWAY, PARTS, Counted(), notes.append)
    assert (old.exists(), new.exists()) == (False, True)


def test_user_places_the_cache_or_turns_it_off(monkeypatch, tmp_path, notes):
    monkeypatch.setenv("FLEXBEARING_CACHE", str(tmp_path / "mine"))
    assert configured().folder == tmp_path / "mine"
    assert configured(str(tmp_path / "case")).folder == tmp_path / "case"
    monkeypatch.setenv("FLEXBEARING_CACHE", "off")
    compute = Counted()
    for _ in range(2):
        configured().cached(RACEWAY, PARTS, compute, notes.append)
    assert (compute.calls, notes, listing(configured())) == (2, [], "the cache is off (FLEXBEARING_CACHE)\n")
    assert configured().clear() == configured().size == 0
    monkeypatch.delenv("FLEXBEARING_CACHE")
    assert configured().folder.parts[-2:] == ("flexbearing", "rings")


def test_listing_and_clearing(cache, notes):
    for number in range(2):
        cache.cached(RACEWAY, number, Counted(), notes.append)
    lines = listing(cache).splitlines()
    assert lines[-1].startswith("2 rings, 0.00")
    assert {line.split()[0] for line in lines[:-1]} == {key.digest(number)[:12] for number in range(2)}
    assert (cache.clear(), cache.size) == (2, 0)


def test_a_ring_is_not_read_again_while_its_file_is_the_same(cache, notes, monkeypatch):
    cache.cached(RACEWAY, PARTS, Counted(), notes.append)
    first = cache.cached(RACEWAY, PARTS, Counted(), notes.append)
    monkeypatch.setattr("flexbearing.cache.store._content", None)
    assert cache.cached(RACEWAY, PARTS, Counted(), notes.append) is first
    monkeypatch.undo()
    (entry,) = cache.entries()
    entry.path.write_bytes(entry.path.read_bytes())
    again = cache.cached(RACEWAY, PARTS, Counted(), notes.append)
    assert again is not first
    same(again, first)
    assert cache.clear() == 1
    anew = Counted()
    cache.cached(RACEWAY, PARTS, anew, notes.append)
    assert anew.calls == 1


def test_memory_holds_no_more_than_some_rings(cache, notes):
    for number in range(2 * recent.MOST):
        for _ in range(2):  # written, then read
            cache.cached(RACEWAY, (*PARTS, number), Counted(), notes.append)
    assert len(recent._rings) == recent.MOST
