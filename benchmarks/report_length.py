"""How long reports are: words, A4 pages, screens, where the first diagram begins, graphics.

python -m benchmarks.report_length results/mao2016_report.html results/thickness_report.html

needs Playwright and an installed Chromium; `--pictures FOLDER` also writes what each screen shows.
"""

import argparse
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright

from flexbearing.pages.make import chromium, pdf_bytes

SCREENS = ((1400, 900), (420, 800))
_WORDS = """((opened) => {
  document.querySelectorAll(".plot, svg").forEach((each) => each.remove());
  document.querySelectorAll("details").forEach((each) => { each.open ||= opened; });
  return document.body.innerText.split(/\\s+/).filter((word) => /[A-Za-z0-9]/.test(word)).length;
})"""
_TOP = """(() => {
  const first = document.querySelector("figure");
  return first ? first.getBoundingClientRect().top + window.scrollY : -1;
})()"""


def main() -> None:
    """Print a row for each report."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("reports", nargs="+", type=Path)
    parser.add_argument("--pictures", type=Path)
    options = parser.parse_args()
    screens = "".join(f"{f'screens {wide}x{high}':>17}{'first diagram':>15}" for wide, high in SCREENS)
    print(f"{'report':<28}{'words':>7}{'all words':>11}{'A4 pages':>10}{screens}{'graphics':>10}")
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=chromium(), args=["--no-sandbox", "--disable-gpu"])
        for report in options.reports:
            print(f"{report.stem[:27]:<28}{_row(browser, report.resolve(), options.pictures)}", flush=True)
        browser.close()


def _row(browser: Browser, report: Path, folder: Path | None) -> str:
    pages = pdf_bytes(chromium(), report).count(b"/Type /Page\n")
    row, words, graphics = "", (0, 0), 0
    for wide, high in SCREENS:
        page = browser.new_page(viewport={"width": wide, "height": high})
        page.goto(report.as_uri(), timeout=120_000)
        page.wait_for_selector('body[data-ready="1"]', timeout=120_000)
        graphics = page.evaluate('document.querySelectorAll("figure").length')
        tall = page.evaluate("document.documentElement.scrollHeight")
        row += f"{tall / high:>17.1f}{page.evaluate(_TOP):>12.0f} px"
        if folder is not None:
            _pictures(page, folder / f"{report.stem}_{wide}")
        words = page.evaluate(_WORDS, False), page.evaluate(_WORDS, True)
        page.close()
    return f"{words[0]:>7}{words[1]:>11}{pages:>10}{row}{graphics:>10}"


def _pictures(page: Page, stem: Path) -> None:
    """The first screen, and the whole page."""
    stem.parent.mkdir(parents=True, exist_ok=True)
    page.screenshot(path=f"{stem}_first.png")
    page.screenshot(path=f"{stem}_whole.png", full_page=True)


if __name__ == "__main__":
    main()
