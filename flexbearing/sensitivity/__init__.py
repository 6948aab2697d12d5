"""The command `sensitivity`: derivatives as text, table and picture."""
