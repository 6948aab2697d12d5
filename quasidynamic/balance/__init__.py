"""What must vanish: residuals, no iteration."""
