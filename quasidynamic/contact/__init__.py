"""One touching pair in its own frame: numbers in, numbers out; nothing here knows the bearing around it."""
