"""A ball bearing's residuals to zero."""
