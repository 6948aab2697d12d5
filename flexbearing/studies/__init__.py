"""Several runs of one case: speed against error, equilibria over load or speed."""
