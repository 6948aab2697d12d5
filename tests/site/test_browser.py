"""Every page of the built site in a real browser, without a network. `make test-docs` builds it first."""

import shutil

import pytest

from flexbearing.pages import make
from tests.site.built import SITE

BROWSER = next(filter(None, map(shutil.which, make.NAMES)), None)
pytestmark = [
    pytest.mark.docs,
    pytest.mark.skipif(BROWSER is None, reason="no Chromium is installed (Debian: apt install chromium)"),
]


@pytest.fixture(scope="module")
def offline():
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    with playwright.sync_playwright() as started:
        running = started.chromium.launch(
            executable_path=BROWSER, args=["--no-sandbox", "--disable-gpu", "--allow-file-access-from-files"]
        )
        yield running.new_context(offline=True)
        running.close()


@pytest.fixture
def opened(offline):
    """A page that collects what its console says and what could not be loaded."""
    page = offline.new_page()
    page.set_default_timeout(120_000)
    told: list[str] = []
    page.on("console", lambda message: message.type in ("error", "warning") and told.append(message.text))
    page.on("pageerror", lambda error: told.append(str(error)))
    page.on("requestfailed", lambda request: told.append(f"not loaded: {request.url}"))
    yield page, told
    page.close()


def test_every_page_opens_without_a_word_on_the_console(opened):
    page, told = opened
    paths = sorted(SITE.rglob("*.html"))
    assert len(paths) > 60
    wrong = {}
    for path in paths:
        told.clear()
        page.goto(path.as_uri())
        if page.locator(".math").count():
            page.wait_for_function("window.MathJax && MathJax.startup && MathJax.startup.promise")
            page.evaluate("() => MathJax.startup.promise")
            unset = page.evaluate(
                "[...document.querySelectorAll('.math')].filter(m => !m.querySelector('svg')).length"
            )
            bad = page.locator("mjx-merror, [data-mjx-error]").count()
            if unset or bad:
                told.append(f"{unset} formulas not set, {bad} with errors")
        if told:
            wrong[str(path.relative_to(SITE))] = list(told)
    assert wrong == {}


def test_the_search_finds_clearance(opened):
    page, told = opened
    page.goto((SITE / "search.html").as_uri() + "?q=clearance")
    page.wait_for_selector("#search-results li a")
    assert any("clearance" in text.lower() for text in page.locator("#search-results li a").all_inner_texts())
    assert told == []
