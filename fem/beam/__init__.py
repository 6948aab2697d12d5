"""Rings as closed curved beams on springs, in closed form per harmonic; no mesh."""
