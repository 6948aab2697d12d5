"""Measurements of others: a prediction that is registered first, the printed value in a later commit, a verdict.

Predictions stand in `docs/evidence/predictions`, printed values in `docs/evidence/values`.
"""
