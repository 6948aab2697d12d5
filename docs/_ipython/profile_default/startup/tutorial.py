"""What tutorials need: commands whose failure fails the page, and a folder of their own."""

import atexit
import os
import shutil
import subprocess
import tempfile
from pathlib import Path


def checked(command):
    """Run a line `!command` away from any terminal, show what it prints, and raise where it fails."""
    line = get_ipython().var_expand(command, depth=1)  # noqa: F821
    shell = ["bash", "-o", "pipefail", "-c", line]
    finished = subprocess.run(shell, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(finished.stdout, end="")
    finished.check_returncode()


def work_in_a_new_folder():
    """Go to an empty folder that has the shipped cases beside, as long as the page is executed."""
    root, folder = Path.cwd(), Path(tempfile.mkdtemp(prefix="tutorial-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    for name in ("configs", "docs"):
        (folder / name).symlink_to(root / name)
    os.chdir(folder)


for name in ("FORCE_COLOR", "CLICOLOR", "CLICOLOR_FORCE"):  # that the kernel sets for terminals
    os.environ.pop(name, None)
get_ipython().system = checked  # noqa: F821
