"""How a raceway deflects under its rollers, in harmonics and at azimuths, whatever computed it.

Arrays and sums only: how they are found belongs to the discretisations, which stand above.
"""
