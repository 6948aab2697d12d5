"""A result for people: page and pictures; what is shown of a quantity is declared in `quantities`."""
