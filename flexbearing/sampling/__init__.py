"""Random inputs: their distributions, the points of a study, and what its outputs tell of them."""
