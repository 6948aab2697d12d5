"""One case given its family, from what was read to its result file; `run_case` is the way in."""
