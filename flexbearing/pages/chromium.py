"""Printing a page to PDF by an installed Chromium."""

import os
import shutil
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

from flexbearing.files import BadOutput, NotStored

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
SECONDS = 120.0  # that a page may take


def chromium() -> str:
    """Find an installed Chromium.

    Raises
    ------
    BadOutput
        where there is none
    """
    for name in NAMES:
        if found := shutil.which(name):
            return found
    raise BadOutput("--pdf: no Chromium is installed that could print; the HTML report needs none.")


def pdf_bytes(browser: str, page: Path) -> bytes:
    """Print a page.

    Raises
    ------
    NotStored
        where Chromium ends without one
    """
    alone = ["--no-sandbox"] if os.geteuid() == 0 else []  # Chromium refuses to run as root otherwise
    with TemporaryDirectory() as folder:
        printed = Path(folder) / "report.pdf"
        options = [
            "--headless=new", "--disable-gpu", "--no-pdf-header-footer", "--virtual-time-budget=20000",
            f"--user-data-dir={folder}/profile", "--window-size=720,1000", f"--print-to-pdf={printed}",
        ]  # fmt: skip
        command = [browser, *alone, *options, page.resolve().as_uri()]
        try:
            done = subprocess.run(command, capture_output=True, timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired:
            raise NotStored(
                f"{page}: Chromium did not print it within {SECONDS:.0f} s; the HTML is complete."
            ) from None
        if not printed.is_file():
            last = done.stderr.decode(errors="replace").strip().splitlines()[-1:]
            raise NotStored(f"{page}: Chromium did not print it ({' '.join(last)}); the HTML is complete.")
        return printed.read_bytes()
