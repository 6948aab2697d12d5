"""One case from its file to its result file; `flexbearing.runs.run_case.run` is the way in."""
