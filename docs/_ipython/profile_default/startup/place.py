"""Cells of pages run in the folder of the project, as commands are typed there."""

import os
from pathlib import Path

os.chdir(Path(os.environ["IPYTHONDIR"]).parents[1])
