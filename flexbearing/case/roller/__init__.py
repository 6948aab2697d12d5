"""The case file of a cylindrical roller bearing, one module for each group of sections."""
