"""A roller bearing's residuals to zero."""
