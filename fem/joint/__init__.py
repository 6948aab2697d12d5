"""Fits that may open or slide: two condensed bodies with unilateral contact and Coulomb friction.

Bonded parts belong to `fem.section` or `fem.solid`, rings that only push on lines to `fem.section`.
"""
