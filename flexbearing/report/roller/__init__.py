"""Pages and pictures of cylindrical roller bearings, with deformed rings; ball bearings are in `balls`."""
