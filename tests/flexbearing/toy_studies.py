"""Studies whose variants a plain function computes, in place of a bearing."""

import os
import signal
import time

import numpy as np

from flexbearing.findings import RowFinding
from flexbearing.studies.pareto import NAMES, Timed
from flexbearing.studies.plan import Row
from flexbearing.studies.prepare import prepare_source
from tests.places import CONFIGS

CASE = CONFIGS / "nu209.toml"
COLLECT = '[collect]\nlife = "life_L10 [Mrev]"\nslip = "cage_slip"'
TEXTS = "life_L10 [Mrev]", "cage_slip [%]"


def toy(folder, over='"operation.radial_load" = "1 kN .. 10 kN, 10"', name="toy", collect=COLLECT):
    """A study file in a folder, and what follows from it."""
    file = folder / f"{name}.toml"
    file.write_text(f'case = "{CASE}"\n[over]\n{over}\n{collect}\n')
    return prepare_source(file)


def load(value):
    return float(value.split()[0])


def cubes(task, texts):
    """Life and slip that the load alone decides; none of both below 2 kN, a danger from 10 kN on."""
    assert set(texts) <= {*TEXTS}
    return [_row(variant, texts) for variant in task.variants]


def _row(variant, texts):
    number = load(variant.values[0])
    if number < 2:
        return Row(variant.identity, "iteration limit", "after 200 iterations", 0.25)
    values = dict(zip(TEXTS, (1000 / number**3, 0.1 * number), strict=True))
    found = (RowFinding("contact-pressure", "danger", 4.5e9, 4e9, ("inner raceway",)),) * (number >= 10)
    return Row(variant.identity, "converged", "", 0.5, {text: values[text] for text in texts}, found)


def lives(task, texts):
    """The same number of everything."""
    return [Row(each.identity, "converged", "", 0.5, dict.fromkeys(texts, 1.0)) for each in task.variants]


def deadly(task, texts, place):
    """As `cubes`, but the process of 7 kN is killed; the attempts stand in a file."""
    loads = [load(variant.values[0]) for variant in task.variants]
    if 7.0 in loads:
        with place.open("a") as file:
            file.write(f"{len(loads)}\n")
        os.kill(os.getpid(), signal.SIGKILL)
    return cubes(task, texts)


def slow_cubes(task, texts, place):
    """As `cubes`, in some time; the process stands in a file."""
    (place / str(os.getpid())).touch()
    time.sleep(0.2)
    return cubes(task, texts)


def replaced_cubes(task, texts, place):
    """As `slow_cubes`; when one of two processes was killed, after a third one has begun."""
    rows = slow_cubes(task, texts, place / "processes")
    gone_by = time.monotonic() + 300
    while (place / "killed").exists() and len(list((place / "processes").iterdir())) < 3:
        assert time.monotonic() < gone_by
        time.sleep(0.02)
    return rows


def no_ring(ring, *, here=False):
    """Rings of toys are rigid."""


def deadly_outer(ring, place):
    """The process of an outer ring is killed; the processes stand in a file."""
    with place.open("a") as file:
        file.write(f"{os.getpid()}\n")
    if ring.name == "outer":
        os._exit(1)


def deadly_ring(ring):
    """The process of an outer ring ends without a word."""
    if ring.name == "outer":
        os._exit(1)
    return "condensed"


def deadly_here(ring, place, *, here=False):
    """The process that meshes a ring itself ends without a word; rings that another one meshes are noted."""
    if here:
        os._exit(1)
    with place.open("a") as file:
        file.write(f"{ring.race}\n")


def deadly_level(run):
    """The same answer on every level of `pareto`, but the process of 5 slices is killed."""
    if run.name == "5 slices":
        os._exit(1)
    return Timed({"cold": 1.0, "cached": 1.0}, dict.fromkeys(NAMES, np.array(1.0)))


def deadly_branch(wanted):
    """No branch: the process is killed."""
    os._exit(1)
