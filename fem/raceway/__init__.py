"""How a raceway deflects under its rollers, in harmonics and at azimuths, by any discretisation.

Arrays and sums only: how they are found belongs to the discretisations, which import it.
"""
