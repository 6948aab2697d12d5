"""Bodies of revolution on their axial section, by harmonics: rings, shafts, smeared cages, bolted rings."""
