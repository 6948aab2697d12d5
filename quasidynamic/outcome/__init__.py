"""What a solved state means."""
