"""Settings for all tests."""

import gc

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
        gc.enable()


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
