"""How a raceway deflects under its rollers, in harmonics and at azimuths, whatever computed it."""
