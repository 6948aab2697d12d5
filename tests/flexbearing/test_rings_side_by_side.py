"""Both rings of a bearing condensed at once: the outer one in a process that starts before anything else."""

import pytest

import flexbearing
from fem import condense
from flexbearing.coupling import PartnerFailed
from flexbearing.runs import roller
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
COARSE = {"accuracy.element_order": 2}
CAGE = COARSE | {"inner.kind": "rigid"}


@pytest.fixture
def processes(monkeypatch, tmp_path):
    """How each process began and ended, with an empty cache and two cores."""
    monkeypatch.setenv("FLEXBEARING_CACHE", str(tmp_path / "rings"))
    monkeypatch.setenv("FLEXBEARING_THREADS", "2")
    monkeypatch.delenv("SLURM_CPUS_PER_TASK", raising=False)
    told, begin = [], condense.started

    class Told:
        def __init__(self, *task, **options):
            self.process = begin(*task, **options)

        def __enter__(self):
            told.append("started")
            return self.process.__enter__()

        def __exit__(self, *ending):
            self.process.__exit__(*ending)
            told.append("ended")

    monkeypatch.setattr(condense, "started", Told)
    return told


@pytest.mark.slow
def test_the_answer_is_the_same_one_after_the_other(processes, monkeypatch, tmp_path):
    both = flexbearing.run(PAPER, COARSE)
    assert processes == ["started", "ended"]
    monkeypatch.setenv("FLEXBEARING_CACHE", str(tmp_path / "others"))
    monkeypatch.setenv("FLEXBEARING_THREADS", "1")
    assert flexbearing.run(PAPER, COARSE) == both
    assert processes == ["started", "ended"]


@pytest.mark.slow
def test_a_known_ring_starts_no_process(processes):
    first = flexbearing.run(PAPER, CAGE)
    assert flexbearing.run(PAPER, CAGE) == first
    assert processes == ["started", "ended"]


def test_a_run_that_fails_before_leaves_no_process(processes, monkeypatch):
    def failing(*_):
        raise PartnerFailed("no equilibrium", "stalled")

    monkeypatch.setattr(roller.BearingPartner, "solve", failing)
    assert flexbearing.run(PAPER, CAGE).attributes["status"] == "not solved"
    assert processes == ["started", "ended"]


@pytest.mark.parametrize(
    "settings",
    [{"outer.kind": "rigid"}, {"accuracy.structure": "beam"}, {"accuracy.structure": "smeared"}],
    ids=str,
)
def test_rings_without_a_mesh_in_space_start_no_process(processes, settings):
    flexbearing.run(PAPER, {"inner.kind": "rigid"} | settings)
    assert processes == []
