"""A report as one HTML file: templates with what the page needs, all of it inside."""

import json
import re
from collections.abc import Mapping
from html import escape
from importlib.resources import files
from math import isfinite
from typing import Any

from flexbearing.report.html.document import Document
from flexbearing.report.html.plotly import layout, traces

_CODE = re.compile(r"`([^`]+)`")
_LINK = re.compile(r"\[([^\[\]]+)\]\(#([\w-]+)\)")
TEMPLATE = "hovertemplate"  # of a trace, which holds markup of ours and no text from elsewhere
PLOTLY = "plotly-cartesian-4.1.1.min.js"  # scatter, bars, heatmaps; its licence lies beside it


def html(document: Document) -> str:
    """Lay a report out as a page."""
    from jinja2 import Environment, FunctionLoader, StrictUndefined

    page = files("flexbearing.report.html") / "page"
    environment = Environment(
        autoescape=True,
        undefined=StrictUndefined,
        lstrip_blocks=True,
        loader=FunctionLoader(lambda name: (page / name).read_text("utf-8")),
    )
    figures = [
        {"name": each.name, "traces": escaped(traces(each)), "layout": escaped(layout(each))}
        for each in document.figures
    ]
    environment.filters["marked"] = marked
    return environment.get_template(document.template).render(
        document=document,
        figures=in_script(figures),
        download=in_script(dict(zip(("name", "text"), document.download or ("", ""), strict=True))),
        style=(page / "report.css").read_text("utf-8"),
        plotly=(page / PLOTLY).read_text("utf-8").replace("</", "<\\/") if figures else "",
        program=(page / "report.js").read_text("utf-8"),
    )


def marked(text: str) -> str:
    """Escape a text for the page; what stands between backticks becomes code, [words](#place) a link in it.

    >>> marked("a < b: `run --set`")
    'a &lt; b: <code>run --set</code>'
    >>> marked("see [Life](#life), [bearing](other)")
    'see <a href="#life">Life</a>, [bearing](other)'
    """
    return _LINK.sub(r'<a href="#\2">\1</a>', _CODE.sub(r"<code>\1</code>", escape(text)))


def escaped(value: Any, key: str = "") -> Any:
    """Traces or layout whose texts Plotly shows as they are, and takes for no markup; templates are ours.

    >>> escaped({"name": "<a href='x'>load</a>", "hovertemplate": "%{y}<extra></extra>"})
    {'name': "&lt;a href='x'>load&lt;/a>", 'hovertemplate': '%{y}<extra></extra>'}

    Where there is no number is a gap.

    >>> escaped([1.0, float("nan")])
    [1.0, None]
    """
    if isinstance(value, float) and not isfinite(value):
        return None
    if isinstance(value, str):
        return value if key == TEMPLATE else value.replace("<", "&lt;")
    if isinstance(value, Mapping):
        return {name: escaped(item, name) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [escaped(item, key) for item in value]
    return value


def in_script(value: object) -> str:
    r"""JSON that can be in a script element, with any texts.

    >>> in_script("</script>")
    '"\\u003c/script>"'
    """
    return json.dumps(value, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
