"""What must vanish in a ball bearing."""
