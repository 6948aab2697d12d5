"""Newton loops of ball bearings: load distribution, motion of balls, ring on balls, homotopy in the inertia.

Forces and their derivatives come from `balance.balls`; what follows from an answer belongs to `outcome`.
"""
