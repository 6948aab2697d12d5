"""Settings for all tests."""

import gc
from collections import Counter

import pytest
from hypothesis import settings
from threadpoolctl import threadpool_limits

settings.register_profile("steady", deadline=None, derandomize=True, max_examples=40)
settings.load_profile("steady")


@pytest.hookimpl(wrapper=True)
def pytest_collection():
    """What is collected stays to the end: the garbage collector need not look at it, now or later."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(100_000, 20, 20)  # what tests make is short-lived
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Of the parameters of a test that is `sampled(n)` every n-th is fast, those between them are slow."""
    counts = Counter()
    for item in items:
        if marker := item.get_closest_marker("sampled"):
            place = counts[item.fspath, item.originalname]
            counts[item.fspath, item.originalname] += 1
            if place % marker.args[0]:
                item.add_marker(pytest.mark.slow)


@pytest.fixture(autouse=True, scope="session")
def one_process_for_all_cores():
    """Tests share the cores already; those of worker processes say how many they want."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FLEXBEARING_THREADS", "1")
        yield


@pytest.fixture(autouse=True, scope="session")
def progress_for_none_who_waits():
    """What a command says on the error stream must not depend on how busy the machine is."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("flexbearing.progress.EVERY", 3600.0)
        yield


@pytest.fixture
def two_cores(monkeypatch):
    """For tests of worker processes."""
    monkeypatch.delenv("SLURM_CPUS_PER_TASK", raising=False)
    monkeypatch.setenv("FLEXBEARING_THREADS", "2")


@pytest.fixture(autouse=True, scope="session")
def cache_of_the_session(tmp_path_factory, worker_id):
    """Rings that tests of any worker condensed may be used again; those of earlier sessions may not."""
    folder = tmp_path_factory.getbasetemp()
    folder = folder if worker_id == "master" else folder.parent
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FLEXBEARING_CACHE", str(folder / "cache"))
        yield


@pytest.fixture(autouse=True, scope="session")
def one_thread_for_small_matrices():
    """As a run does: threads of the linear algebra would only wait for each other."""
    with threadpool_limits(limits=1, user_api="blas"):
        yield
