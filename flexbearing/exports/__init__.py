"""Results in the files of other programs: tables, fields, bearings of rotors, exchange files of gearboxes."""
