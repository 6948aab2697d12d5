"""One touching pair in its own frame: numbers in, numbers out."""
