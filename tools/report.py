#!/usr/bin/python3 -I
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes one self-contained HTML page of a run: tools/report.py RUN_FOLDER [RUN_FOLDER...] [--output FILE] [--follow]

The charts of the page show the other runs over the first one. The page needs no network and no other file. Exit codes:
0 done; 1 no Python here has NumPy and meshio; 2 wrong command line; 4 a file could not be read or written."""
import argparse
import math
import os
import pathlib
import shlex
import sys
import warnings

sys.dont_write_bytecode = True  # the source tree stays clean
TOOLS = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(TOOLS / name) for name in ("report", "runs", "rosettes")]
MOST_RUNS = 8  # as many colours as readers can distinguish on the page
LEAST_SECONDS, MOST_SECONDS = 0.5, 3600


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"report: {message}; '--help' explains\n")


def seconds_of(text):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not LEAST_SECONDS <= value <= MOST_SECONDS:
        raise argparse.ArgumentTypeError(f"{text}: allowed are seconds from {LEAST_SECONDS} to {MOST_SECONDS}")
    return value


def arguments():
    parser = ArgumentParser(prog="report", description="Makes one self-contained HTML page of a run, or of several.")
    parser.add_argument("folders", metavar="RUN_FOLDER", type=pathlib.Path, nargs="+",
                        help="where a run left its files; the charts of the first one show the others, too")
    parser.add_argument("--output", metavar="FILE", type=pathlib.Path,
                        help="the page (default: report.html in the first RUN_FOLDER)")
    parser.add_argument("--follow", action="store_true",
                        help="make the page anew as long as a run goes on; an open browser shows the new one by itself")
    parser.add_argument("--every", metavar="SECONDS", type=seconds_of, default=5,
                        help="with --follow: from one page to the next (default: 5, and more where a page takes long)")
    options = parser.parse_args()
    if len(options.folders) > MOST_RUNS:
        parser.error(f"{len(options.folders)} runs, and a page shows {MOST_RUNS} at most")
    places = [folder.resolve() for folder in options.folders]
    for k, folder in enumerate(options.folders):
        if places[k] in places[:k]:
            parser.error(f"{folder}: this run is named twice")
    return options


def load_page():
    """The parts that need NumPy and meshio; a Python that lacks them hands over to one that has them."""
    try:
        import following
        import page  # not at the top: see above
        import run_data
        import run_folder
    except ImportError as error:
        if "ORTHOCONE_PYTHON_FOUND" in os.environ:
            sys.exit(f"report: {error}")
        launcher = str(TOOLS / "python")
        os.execv(launcher, [launcher, "numpy,meshio", *sys.argv])
    return page, run_data, run_folder, following


def check_run_folder(folder):
    if not folder.is_dir():
        raise FileNotFoundError(f"{folder}: no such folder")
    missing = [name for name in ("history.csv", "parameters.prm") if not (folder / name).is_file()]
    if missing:
        raise FileNotFoundError(f"{folder}: not a run folder, for {' and '.join(missing)} "
                                f"{'is' if len(missing) == 1 else 'are'} missing")


def size_of(text):
    size = len(text.encode("utf-8", errors="replace"))
    return f"{size / 1e6:.1f} MB" if size >= 1e6 else f"{size / 1e3:.0f} kB"


class Report:
    """The page of a command line, and what is said of it."""

    def __init__(self, options):
        self.folders, self.options = options.folders, options
        self.output = options.output or options.folders[0] / "report.html"
        self.page, self.run_data, self.run_folder, self.following = load_page()
        self.n_made = 0

    def make(self, seconds=None):
        """Writes the page, which shows itself anew after `seconds` while a run goes on."""
        for folder in self.folders:
            check_run_folder(folder)
        if not self.output.parent.is_dir():
            raise FileNotFoundError(f"{self.output.parent}: no such folder")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of NumPy, on numbers that are too large
            runs = [self.run_data.RunData(folder) for folder in self.folders]
            text = self.page.make(runs, seconds)
        self.run_folder.write_whole(self.output, text)
        if seconds is None or self.n_made == 0:
            self.say(runs, text, seconds)
        self.n_made += 1

    def say(self, runs, text, seconds):
        print(f"report: {self.output} ({size_of(text)}): {self.page.said_of(runs)}")
        if self.n_made == 0:
            again = f", which shows the page anew until the run ends ({seconds:g} s)" if seconds else ""
            print(f"report: open it in a web browser{again}: xdg-open {shlex.quote(str(self.output))}", flush=True)

    def run(self):
        if self.options.follow:
            self.following.follow(self.folders, self.make, self.options.every)
        else:
            self.make()


def main():
    report = Report(arguments())
    sys.stdout.reconfigure(errors="surrogateescape")  # names of folders need not be text
    try:
        report.run()
    except KeyboardInterrupt:
        print(f"report: stopped; {report.output} shows the run as far as it was")
    except (OSError, report.run_folder.BadFile) as error:
        print(f"report: {report.run_folder.one_line(error)}", file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    main()
