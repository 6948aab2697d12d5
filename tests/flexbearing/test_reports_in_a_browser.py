"""Reports in a real browser: figures drawn, nothing on the console, accessible, printed."""

import shutil

import pytest

import flexbearing
from flexbearing import api
from flexbearing.pages import make
from flexbearing.pages.make import report
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.test_html_study import DUTY, STUDY

BROWSER = next(filter(None, map(shutil.which, make.NAMES)), None)
pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(BROWSER is None, reason="no Chromium is installed (Debian: apt install chromium)"),
]
CASES = {
    "squirrel cage": ("mao2016.toml", ("accuracy.structure=beam",)),
    "roller with fits": ("nu209_fits.toml", ("outputs.catalogue_life=true",)),
    "fast ball": ("harris218.toml", ()),
    "slow balls": ("joshi2015_qj309.toml", ()),
}
STUDIES = {"study": STUDY, "duty cycle": DUTY}
PAGES = [*CASES, *STUDIES, "two results"]
WIDTHS = (1280, 390)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """Reports by their names."""
    folder = tmp_path_factory.mktemp("reports")
    pages = {}
    for name, (file, settings) in CASES.items():
        result = folder / f"{name}.h5"
        api.run(CONFIGS / file, settings, output=result)
        (pages[name],) = report(result)
    for name, text in STUDIES.items():
        (folder / f"{name}.toml").write_text(text, "utf-8")
        flexbearing.study(folder / f"{name}.toml", folder / name, jobs=1)
        (pages[name],) = report(folder / name / f"{'sweep' if name == 'study' else 'cycle'}.csv")
    other = folder / "other.h5"
    api.run(CONFIGS / "nu209_fits.toml", {"operation.radial_load": "8 kN"}, output=other)
    (pages["two results"],) = report(folder / "roller with fits.h5", folder / "two.html", against=other)
    return pages


@pytest.fixture(scope="module")
def browser():
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    with playwright.sync_playwright() as started:
        options = ["--no-sandbox", "--disable-gpu"]
        running = started.chromium.launch(executable_path=BROWSER, args=options)
        yield running
        running.close()


@pytest.fixture
def opened(browser, written):
    """Opens a report without a network; keeps what the console says."""
    contexts = []

    def open_page(name, width=WIDTHS[0], *, injecting=False):
        context = browser.new_context(
            offline=True,
            bypass_csp=injecting,
            viewport={"width": width, "height": 900},
            accept_downloads=True,
        )
        contexts.append(context)
        page, said = context.new_page(), []
        page.on("console", lambda message: said.append(message.text))
        page.on("pageerror", lambda error: said.append(str(error)))
        page.goto(written[name].as_uri())
        page.wait_for_selector('body[data-ready="1"]', timeout=60_000)
        return page, said

    yield open_page
    for context in contexts:
        context.close()


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", PAGES)
def test_figures_are_drawn_and_the_console_is_silent(opened, name, width):
    page, said = opened(name, width)
    assert said == []
    drawn = page.evaluate(
        """[...document.querySelectorAll(".js-plotly-plot")].map((plot) => {
            const size = plot.querySelector(".main-svg").getBoundingClientRect();
            return [plot.id, size.width, size.height,
                    plot.querySelectorAll(".scatterlayer path, .barlayer path, .heatmaplayer image").length];
        })"""
    )
    assert len(drawn) >= (1 if name == "duty cycle" else 2)
    assert [name for name, wide, high, marks in drawn if wide < 200 or high < 200 or not marks] == []
    assert page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("name", PAGES)
def test_axe_finds_nothing_serious(opened, name):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="axe is not installed")
    page, _ = opened(name, injecting=True)
    found = axe.Axe().run(page).response["violations"]
    assert [
        (one["id"], one["nodes"][0]["html"]) for one in found if one["impact"] in ("serious", "critical")
    ] == []


def test_a_point_tells_its_value_under_the_pointer(opened):
    page, _ = opened("roller with fits")
    point = page.locator("#figure-around-inner-load .point").nth(1)  # the first one is beyond the axis
    point.scroll_into_view_if_needed()
    place = point.bounding_box()
    page.mouse.move(place["x"] + place["width"] / 2, place["y"] + place["height"] / 2)
    page.wait_for_selector("#figure-around-inner-load .hoverlayer .hovertext", timeout=5000)


def test_a_heading_sorts_its_table_up_and_down(opened):
    page, _ = opened("study")
    page.locator("details", has_text="Every row").locator("summary").click()
    table = page.locator("table.sortable")
    heading = table.locator("thead th", has_text="life")
    column = heading.evaluate("cell => cell.cellIndex")

    def numbers():
        texts = table.locator(f"tbody tr > :nth-child({column + 1})").all_inner_texts()
        return [float(text.replace(",", "")) for text in texts]

    heading.locator("button").click()
    assert heading.get_attribute("aria-sort") == "ascending"
    assert numbers() == sorted(numbers())
    heading.locator("button").click()
    assert numbers() == sorted(numbers(), reverse=True)


def test_the_button_saves_the_table(opened, written):
    page, _ = opened("study")
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save the table as sweep.csv").click()
    table = written["study"].parent / "sweep.csv"
    assert saved.value.path().read_text("utf-8") == table.read_text("utf-8")


@pytest.mark.parametrize("name", ["squirrel cage", "study"])
def test_a_report_is_printed_to_pdf(written, tmp_path, name):
    source = written[name].with_name(f"{name}.h5" if name in CASES else "sweep.csv")
    page, printed = report(source, tmp_path / "report.html", pdf=True)
    assert (page.suffix, printed.suffix) == (".html", ".pdf")
    data = printed.read_bytes()
    assert data.startswith(b"%PDF")
    assert data.count(b"/Type /Page\n") <= 8


@pytest.mark.parametrize(("width", "height"), [(1400, 900), (420, 800)])
@pytest.mark.parametrize("name", PAGES)
def test_the_first_diagram_is_on_the_first_screen(opened, name, width, height):
    page, _ = opened(name, width)
    box = page.locator("figure").first.bounding_box()
    assert box["y"] + 0.8 * box["height"] < height


def test_a_figure_that_is_opened_is_drawn(opened):
    page, said = opened("squirrel cage")
    page.locator("summary", has_text="Convergence").click()
    page.wait_for_selector("#figure-convergence .main-svg", timeout=5000)
    assert said == []


@pytest.mark.parametrize("name", PAGES)
def test_no_line_of_text_is_longer_than_100_characters(opened, name):
    page, _ = opened(name, 1400)
    longest = page.evaluate(
        """Math.max(0, ...[...document.querySelectorAll("p, li, figcaption")].map((each) => {
            const range = document.createRange();
            range.selectNodeContents(each);
            const lines = new Set([...range.getClientRects()].map((box) => Math.round(box.bottom / 8))).size;
            return each.textContent.trim().length / Math.max(1, lines);
        }))"""
    )
    assert longest <= 100
