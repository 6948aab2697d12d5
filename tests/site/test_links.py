"""The built site is whole: no dead links, nothing from elsewhere. `make test-docs` builds it first."""

import pytest

from tests.site.built import SITE, outside, pages

pytestmark = pytest.mark.docs


@pytest.fixture(scope="module")
def site():
    found = pages()
    assert len(found) > 60, f"{SITE}: build the site with `make docs`"
    return found


def test_every_link_leads_somewhere(site):
    dead = []
    for page in site.values():
        for link in page.links:
            if outside(link):
                continue
            path, anchor = page.place(link)
            if not path.is_file() or (anchor and path in site and anchor not in site[path].anchors):
                dead.append(f"{page.path.relative_to(SITE)}: {link}")
    assert dead == []


def test_pages_load_nothing_from_elsewhere(site):
    missing = [
        f"{page.path.relative_to(SITE)}: {link}"
        for page in site.values()
        for link in page.loaded
        if outside(link) or not page.place(link)[0].is_file()
    ]
    assert missing == []


def test_every_page_is_reached_from_the_first(site):
    reached, ahead = set(), [SITE / "index.html"]
    while ahead:
        path = ahead.pop()
        if path in site and path not in reached:
            reached.add(path)
            ahead += [site[path].place(link)[0] for link in site[path].links if not outside(link)]
    made_by_sphinx = {SITE / name for name in ("search.html", "genindex.html", "py-modindex.html")}
    assert set(site) - reached <= made_by_sphinx


def test_functions_that_theory_names_have_pages_and_link_back(site):
    """Every equation of the theory is linked to its function, and the function to the page."""
    one_way = []
    for path, page in site.items():
        if path.parent.name != "theory":
            continue
        for link in page.tree.xpath(
            "//a[contains(@class, 'internal')][.//code[contains(@class, 'xref')]]/@href"
        ):
            target, anchor = page.place(str(link))
            described = site[target].tree.get_element_by_id(anchor).getparent()
            back = [site[target].place(str(found))[0] for found in described.xpath(".//a/@href")]
            if path not in back:
                one_way.append(f"{path.name}: {anchor}")
    assert one_way == []


def test_every_equation_of_the_theory_names_its_function(site):
    """Formulas stand in sections that link to functions, and every function that is named exists."""
    theory = [page for path, page in site.items() if path.parent.name == "theory"]
    assert [
        f"{page.path.name}: {section.get('id')}"
        for page in theory
        for section in page.tree.xpath("//section[div[contains(@class, 'math')]]")
        if not section.xpath(".//a[.//code[contains(@class, 'xref')]]")
    ] == []
    assert [
        f"{page.path.name}: {code.text_content()}"
        for page in theory
        for code in page.tree.xpath("//code[contains(@class, 'xref')][not(ancestor::a)]")
    ] == []
