"""Pictures of reports for the documents: what a wide and a narrow screen show, and printed pages.

python docs/report_pictures.py results/mao2016_report.html results/thickness_report.html docs/images

needs Playwright, an installed Chromium and pypdfium2; the PDF lies beside the first report.
"""

import sys
from pathlib import Path

import pypdfium2
from PIL import Image
from playwright.sync_api import sync_playwright

from flexbearing.pages.make import chromium

SCREENS = {  # file to report, width and height of what is shown, width of the picture
    "report_wide.png": ("result", 1280, 2050, 900),
    "report_narrow.png": ("result", 390, 1000, 390),
    "report_study.png": ("study", 1280, 1500, 900),
}
PAGES, HIGH = (0, 1, 2, 3), 700  # of the PDF; height of their picture [px]
COLOURS = 128


def main() -> None:
    """Draw all four."""
    result, study, folder = map(Path, sys.argv[1:])
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=chromium(), args=["--no-sandbox", "--disable-gpu"])
        for name, (which, wide, high, shown) in SCREENS.items():
            page = browser.new_page(viewport={"width": wide, "height": high})
            page.goto((result if which == "result" else study).resolve().as_uri(), timeout=120_000)
            page.wait_for_selector('body[data-ready="1"]', timeout=120_000)
            page.screenshot(path=folder / name)
            _store(Image.open(folder / name).convert("RGB"), shown, folder / name)
        browser.close()
    _store_pages(result.with_suffix(".pdf"), folder / "report_pdf.png")


def _store_pages(pdf: Path, place: Path) -> None:
    """Pages of a PDF side by side."""
    document = pypdfium2.PdfDocument(pdf)
    pages = [document[number].render(scale=HIGH / document[number].get_height()).to_pil() for number in PAGES]
    room = 8
    whole = Image.new("RGB", (sum(page.width + room for page in pages), HIGH + room), "#8a939d")
    left = room // 2
    for page in pages:
        whole.paste(page.convert("RGB"), (left, room // 2))
        left += page.width + room
    _store(whole, whole.width, place)


def _store(picture: Image.Image, wide: int, place: Path) -> None:
    """A picture in a width, with few colours so that the file is small."""
    size = (wide, round(picture.height * wide / picture.width))
    picture.resize(size, Image.Resampling.LANCZOS).quantize(COLOURS).save(place, optimize=True)


if __name__ == "__main__":
    main()
