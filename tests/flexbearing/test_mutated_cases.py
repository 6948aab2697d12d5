"""Case files that were changed at random are refused with a message, or computed to a sound answer."""

import warnings
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

import flexbearing
from flexbearing.__main__ import command
from tests import mutated_cases
from tests.sound_results import faults

BASES = mutated_cases.bases()
RIGID = [
    name for name, raw in BASES.items()
    if {raw.get(part, {}).get("kind", "rigid") for part in ("inner", "outer")} == {"rigid"}
    and "rings" not in raw and "target" not in raw.get("accuracy", {})
]  # fmt: skip


@pytest.mark.slow
@given(st.integers(0, 10**12))
@settings(max_examples=80, derandomize=True, deadline=None, suppress_health_check=list(HealthCheck))
def test_every_changed_case_passes_or_is_refused_in_words(tmp_path_factory, capsys, seed):
    case = mutated_cases.mutated(Random(seed), BASES)
    path = _stored(case, tmp_path_factory)
    code = command(["check", str(path), *_set(case)])
    told = capsys.readouterr()
    assert code in (0, 2), case.story
    assert told.out if code == 0 else told.err.strip(), case.story
    assert "internal error" not in told.err, case.story


@given(st.integers(0, 10**12))
@settings(max_examples=15, derandomize=True, deadline=None, suppress_health_check=list(HealthCheck))
def test_every_changed_case_that_passes_is_computed_to_a_sound_answer(tmp_path_factory, seed):
    rng = Random(seed)
    raw = BASES[rng.choice(RIGID)]
    changes = tuple(mutated_cases.plausible(rng, raw) for _ in range(rng.choice((1, 2, 4))))
    case = mutated_cases.MutatedCase("rigid", raw, changes)
    path = _stored(case, tmp_path_factory)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            result = flexbearing.run(path, case.settings, output=path.with_suffix(".h5"))
        except flexbearing.case.BadCase:
            return
    assert faults(result) == [], case.story
    assert result.summary(), case.story


@pytest.mark.parametrize("name", sorted(BASES))
def test_every_unchanged_case_passes(name, tmp_path_factory):
    """Or most of the changed ones were refused for no reason of theirs."""
    path = _stored(mutated_cases.MutatedCase(name, BASES[name], ()), tmp_path_factory)
    assert command(["check", str(path)]) == 0


def _stored(case, tmp_path_factory):
    folder = tmp_path_factory.getbasetemp() / "mutated"
    folder.mkdir(exist_ok=True)
    for drawing in mutated_cases.CONFIGS.glob("*.step"):
        (folder / drawing.name).write_bytes(drawing.read_bytes())
    path = folder / "case.toml"
    path.write_bytes(case.content)
    return path


def _set(case):
    return [word for setting in case.settings for word in ("--set", setting)]
