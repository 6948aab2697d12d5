"""Fits that may open or slide: two condensed bodies with unilateral contact and Coulomb friction."""
