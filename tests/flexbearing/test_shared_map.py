"""Calls that worker processes share: the same answers, and nothing left running."""

import os
import signal
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from flexbearing.program.interpreter import Died
from flexbearing.program.shared_map import FEWEST, shared_map
from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.errors import NotSolved
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.material import Material
from tests.ball_bearings import slow_bearing
from tests.flexbearing import process_calls
from tests.flexbearing.process_calls import dead, dead_once, process_of, unsolved
from tests.flexbearing.test_interruptions import ended, started, wait_for
from tests.places import CONFIGS

pytestmark = pytest.mark.usefixtures("two_cores")

JOSHI = CONFIGS / "joshi2015_fourpoint.toml"
STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)
NUMBERS = range(2 * FEWEST)


def in_two_processes(function):
    with shared_map() as mapped:
        return list(mapped(function, NUMBERS))


def children(process):
    return Path(f"/proc/{process}/task/{process}/children").read_text().split()


def test_workers_that_load_a_module_ahead_give_the_same_answers_and_end(monkeypatch):
    started_ones = children(os.getpid())
    with shared_map(ahead=process_calls.__name__) as mapped:
        assert len(children(os.getpid())) == len(started_ones) + 2
        numbers, processes = zip(*mapped(process_of, NUMBERS), strict=True)
        assert [number for number, _ in mapped(process_of, NUMBERS)] == [*NUMBERS]
    assert numbers == tuple(NUMBERS)
    assert os.getpid() not in processes  # one may have answered all before the other was loaded
    assert children(os.getpid()) == started_ones
    monkeypatch.setenv("FLEXBEARING_THREADS", "1")
    with shared_map(ahead=process_calls.__name__) as mapped:
        assert children(os.getpid()) == started_ones
        assert {process for _, process in mapped(process_of, NUMBERS)} == {os.getpid()}


def test_answers_come_in_the_order_of_the_arguments_from_two_processes():
    numbers, processes = zip(*in_two_processes(process_of), strict=True)
    assert numbers == tuple(NUMBERS)
    assert len(set(processes)) == 2
    assert os.getpid() not in processes
    assert not any(Path(f"/proc/{process}").exists() for process in processes)


def test_few_calls_stay_in_this_process():
    with shared_map() as mapped:
        assert {process for _, process in mapped(process_of, NUMBERS[1:])} == {os.getpid()}


@pytest.mark.slow
def test_what_a_call_raises_is_raised_here():
    before = children(os.getpid())
    with pytest.raises(NotSolved, match="number 3") as raised:
        in_two_processes(unsolved)
    assert raised.value.outcome == "stalled"
    assert set(children(os.getpid())) <= set(before)


@pytest.mark.slow
def test_a_worker_that_dies_is_told():
    with pytest.raises(Died, match="worker process ended 3 times"):
        in_two_processes(dead)


@pytest.mark.slow
def test_what_a_worker_did_not_answer_is_answered_by_another(tmp_path):
    assert in_two_processes(partial(dead_once, place=tmp_path / "died")) == [*NUMBERS]


@pytest.mark.slow
def test_balls_are_the_same_by_one_and_by_two_workers():
    bearing = slow_bearing(friction=0.1, conformity=0.53, spin="local")
    load = np.linspace(1e3, 20e3, len(NUMBERS))[:, None, None] * np.ones((1, 1, 2))
    balls = bearing.slide(np.full(load.shape, np.pi / 4), load)
    parts = []
    roll = partial(bearing.roll, balls, "kalker", (12, 16))
    with shared_map() as mapped:
        shared, alone = roll(parts.append, mapped), roll()
    for one, other in zip(filter(None, shared.rolled), filter(None, alone.rolled), strict=True):
        assert np.array_equal(one.fine.rolled.traction, other.fine.rolled.traction)
        assert np.array_equal(one.fine.motion, other.fine.motion)
    assert np.array_equal(shared.ball_torques, alone.ball_torques)
    assert parts == [(number + 1) / len(NUMBERS) for number in NUMBERS]


@pytest.mark.slow
def test_fast_balls_are_the_same_by_one_and_by_two_workers():
    groove = Groove(conformity=0.5232, material=STEEL)
    parts = AngularContactBearing(
        ball=Ball(diameter=12e-3, material=STEEL), inner=groove, outer=groove, balls=len(NUMBERS),
        pitch_diameter=0.12, contact_angle=np.radians(40.0),
    )  # fmt: skip
    bearing = AngularContactBallBearing(bearing=parts, friction=0.1)
    state = bearing.solve(RingOperation(load=(5e3, 0.0, 1e3, 0.0, 0.0), inner_speed=500.0))
    told, before = [], set(children(os.getpid()))
    roll = partial(bearing.roll, state, "kalker", (12, 16))
    with shared_map() as mapped:
        shared, alone = roll(told.append, mapped), roll()
        assert len(set(children(os.getpid())) - before) == 2
    for one, other in zip(filter(None, shared.rolled), filter(None, alone.rolled), strict=True):
        assert np.array_equal(one.fine.rolled.traction, other.fine.rolled.traction)
    assert np.array_equal(shared.ball_torques, alone.ball_torques)
    assert np.array_equal(shared.unbalanced_force, alone.unbalanced_force)
    assert told == [(number + 1) / len(NUMBERS) for number in NUMBERS]


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_workers_too(number, tmp_path):
    process = started("run", JOSHI, "-o", tmp_path / "out.h5", "--set", "friction.model=kalker")
    wait_for(process.stderr, "stick and slip")
    workers = children(process.pid)
    os.killpg(process.pid, number)
    complaint = ended(process)
    assert len(workers) == 2
    assert process.returncode == 128 + number
    assert complaint.startswith("interrupted")
    assert not any(Path(f"/proc/{worker}").exists() for worker in workers)
