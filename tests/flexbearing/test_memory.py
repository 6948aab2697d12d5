"""Memory that batches free and ask for again."""

import platform
import subprocess
import sys

import pytest

FAULTS = """
import resource, sys
import numpy as np
from flexbearing.program.worker_processes import keep_freed
if sys.argv[1] == "kept":
    keep_freed()
def faults():
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt
def batch():
    return [np.ones(100_000) for _ in range(20)]
batch()
before = faults()
for _ in range(10):
    batch()
print(faults() - before)
"""


def faults(how):
    words = [sys.executable, "-c", FAULTS, how]
    return int(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="only glibc can be told so")
def test_a_batch_takes_the_memory_that_the_one_before_has_freed():
    """Ten batches of 16 MB have 40 000 pages of 4 KiB."""
    assert faults("given back") > 10_000
    assert faults("kept") < 1_000
