"""What a run gives out, each quantity declared once: `roller`, `four_point` and `angular_contact`.

Result file, summary, pages, pictures and reference read these declarations. How a quantity is computed
belongs to the bearing models, how it is stored to `results`, how a page is laid out to `report`.
"""

from flexbearing.quantities.quantity import Quantity, SummaryValue, Unit

__all__ = ["Quantity", "SummaryValue", "Unit"]
