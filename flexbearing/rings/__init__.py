"""From a case to the structures that carry its raceways: condensed, in a fit, or solved in full."""
