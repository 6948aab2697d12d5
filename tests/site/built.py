"""The built site: its pages with their links and anchors."""

from functools import cached_property
from pathlib import Path
from urllib.parse import unquote, urlsplit

from lxml import html

from tests.places import ROOT

SITE = ROOT / "docs" / "_build" / "html"
LOADED = (("img", "src"), ("script", "src"), ("link", "href"), ("source", "src"), ("iframe", "src"))


class Page:
    """A page of the site."""

    def __init__(self, path: Path):
        self.path = path
        self.tree = html.fromstring(path.read_bytes())

    @cached_property
    def anchors(self) -> set[str]:
        return {*self.tree.xpath("//@id"), *self.tree.xpath("//a/@name")}

    @property
    def links(self) -> list[str]:
        return [str(link) for link in self.tree.xpath("//a/@href")]

    @property
    def loaded(self) -> list[str]:
        """What a browser loads with the page."""
        found = [str(link) for tag, name in LOADED for link in self.tree.xpath(f"//{tag}/@{name}")]
        return [link for link in found if link and not link.startswith("data:")]

    def place(self, link: str) -> tuple[Path, str]:
        """File and anchor that a link of this page leads to."""
        parts = urlsplit(link)
        path = (self.path.parent / unquote(parts.path)).resolve() if parts.path else self.path
        return path, unquote(parts.fragment)


def outside(link: str) -> bool:
    return urlsplit(link).scheme in ("http", "https", "mailto")


def pages() -> dict[Path, Page]:
    return {path: Page(path) for path in sorted(SITE.rglob("*.html"))}
