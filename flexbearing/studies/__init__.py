"""Several runs of one case: speed against error, equilibria over load or speed.

Here belong what varies and what is measured; a single run is in `runs`, tables and pictures in `report`.
"""
