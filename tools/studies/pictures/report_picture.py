# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The head of the report of scene 3 of the tutorial with its long stroke, whose loop closes, as Chromium shows it; with --docs the picture of README.md and
docs/tutorial.md. Started by tools/study report."""
import argparse
import pathlib
import shutil
import subprocess
import sys

from PIL import Image

from docs_page import ProgramError
from paper_runs import Runs
from paths import ROOT

WIDTH, HEIGHT = 1100, 1270
CHROMIUM = "chromium"


def photographed(page, picture):
    """Chromium does not ask for a sandbox that containers lack: the page is our own and needs no network."""
    if not shutil.which(CHROMIUM):
        raise ProgramError(f"{CHROMIUM} is not there; it is in Debian's package {CHROMIUM}, which ./test installs")
    words = ("--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--virtual-time-budget=5000",
             f"--window-size={WIDTH},{HEIGHT}", f"--screenshot={picture}", page.resolve().as_uri())
    done = subprocess.run([CHROMIUM, *words], capture_output=True, check=False)
    if done.returncode != 0 or not picture.exists():
        raise ProgramError(f"{CHROMIUM} did not draw {page}")


def main():
    parser = argparse.ArgumentParser(prog="tools/study report", description=__doc__)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/report", help="folder of the picture and the run")
    parser.add_argument("--docs", action="store_true", help="also refresh the picture in docs/")
    options = parser.parse_args()
    try:
        runs = Runs(ROOT / "build/orthocone", options.output / "runs")
        folder = runs.run("3_sliding", "../tutorial/3_fretting", "Output/Probes=",
                          "Load program/Legs=ux 0.03 : 8 ; ux -0.03 : 16 ; ux 0 : 8")
        subprocess.run([sys.executable, ROOT / "tools/report.py", folder.path], check=True)
        picture = options.output / "report.png"
        photographed(folder.path / "report.html", picture)
    except (ProgramError, subprocess.CalledProcessError) as error:
        sys.exit(f"report: {error}")
    if options.docs:
        small = Image.open(picture).convert("RGB").quantize(256, dither=Image.Dither.NONE)
        small.save(ROOT / "docs/images/report.png", optimize=True)
    print(f"report: {picture}")
