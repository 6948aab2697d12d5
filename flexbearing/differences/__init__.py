"""Two results beside each other: keys of the cases, then outputs beyond their errors."""
