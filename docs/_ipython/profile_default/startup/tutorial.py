"""What tutorials need: commands whose failure fails the page, and a folder of their own."""

import atexit
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def commands(text):
    """Run commands away from any terminal, show what they print in its order, and raise where one fails."""
    shell = ["bash", "-e", "-o", "pipefail", "-c", text]
    finished = subprocess.run(shell, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    sys.stdout.write(finished.stdout)
    finished.check_returncode()


def line(text):
    """Run a line `!command`, names of Python in braces replaced by their values."""
    commands(get_ipython().var_expand(text, depth=1))  # noqa: F821


def cell(options, text):
    """Run a cell `%%bash -e`."""
    commands(text)


def work_in_a_new_folder():
    """Go to an empty folder that has the shipped cases beside, as long as the page is executed."""
    root, folder = Path.cwd(), Path(tempfile.mkdtemp(prefix="tutorial-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    for name in ("configs", "docs"):
        (folder / name).symlink_to(root / name)
    os.chdir(folder)


for name in ("FORCE_COLOR", "CLICOLOR", "CLICOLOR_FORCE"):  # that the kernel sets for terminals
    os.environ.pop(name, None)
get_ipython().system = line  # noqa: F821
get_ipython().register_magic_function(cell, "cell", "bash")  # noqa: F821
