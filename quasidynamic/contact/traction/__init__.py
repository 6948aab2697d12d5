"""Shear in the contact and in its inlet: traction laws and oil rheology; film thickness is given."""
