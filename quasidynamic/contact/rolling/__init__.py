"""Rolling contact with stick and slip: Coulomb friction between elastic bodies on a grid.

Pressure and rigid slip come from elsewhere. Laws of one form: `kalker` (elastic half-spaces), `fastsim` (an
elastic foundation), `full_sliding` (rigid bodies).
"""
