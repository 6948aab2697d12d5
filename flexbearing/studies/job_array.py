"""A script that computes a study as a job array, for queues without a Dask cluster."""

import shlex
import sys
from pathlib import Path

from flexbearing.files import require_folder_name
from flexbearing.studies.prepared_study import PreparedStudy

USUAL = 10  # jobs


def sbatch(prepared: PreparedStudy, output: Path, jobs: int | None) -> str:
    """Write a script for SLURM: a job array whose jobs compute a part each, and one that gathers them."""
    count = min(len(prepared.plan.tasks(lambda variant: True)), jobs or USUAL)
    folder = require_folder_name(output)
    file, program = prepared.study.path.resolve(), f"{shlex.quote(sys.executable)} -m flexbearing"
    command = f"{program} study {shlex.quote(str(file))} -o {shlex.quote(str(folder))} --jobs 1"
    name = shlex.quote(prepared.study.name)
    return f"""\
#!/bin/bash
# {len(prepared.plan.variants)} variants in {count} jobs. After them the table is gathered by
#   sbatch --dependency=afterany:JOB --wrap {shlex.quote(command)}
#SBATCH --job-name={name}
#SBATCH --array=1-{count}
#SBATCH --cpus-per-task=1
#SBATCH --output={shlex.quote(str(folder / prepared.study.name))}.%a.log
exec {command} --part "$SLURM_ARRAY_TASK_ID/{count}"
"""
