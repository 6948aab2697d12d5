"""Settings for all tests."""

import pytest
from hypothesis import settings
from threadpoolctl import threadpool_limits

settings.register_profile("steady", deadline=None, derandomize=True)
settings.load_profile("steady")


@pytest.fixture(autouse=True, scope="session")
def one_thread_for_small_matrices():
    """As a run does: threads of the linear algebra would only wait for each other."""
    with threadpool_limits(limits=1, user_api="blas"):
        yield
