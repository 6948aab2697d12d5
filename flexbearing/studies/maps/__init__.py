"""Maps of a case over one to three of its keys, with every equilibrium that is found."""
