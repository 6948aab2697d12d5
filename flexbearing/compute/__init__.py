"""Making it happen: from a case to its result file; `flexbearing.compute.one.run` is the way in."""
