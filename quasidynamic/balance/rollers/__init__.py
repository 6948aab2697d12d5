"""What must vanish in a roller bearing."""
