"""What a study leaves behind: a journal while it runs, a table at its end."""

from flexbearing.studies.table.table import Column, Table

__all__ = ["Column", "Table"]
