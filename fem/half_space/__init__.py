"""Deflection of an elastic half-space under a load patch or line: the part that contact laws already hold.

Closed formulas only, without a mesh; contact laws themselves belong to the bearing, not to `fem`.
"""
