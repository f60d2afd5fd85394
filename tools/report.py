#!/usr/bin/python3 -I
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes one self-contained HTML page of a run: tools/report.py RUN_FOLDER [RUN_FOLDER...] [--output FILE]

The charts of the page show the other runs over the first one. The page needs no network and no other file. Exit codes:
0 done; 1 no Python here has NumPy and meshio; 2 wrong command line; 4 a file could not be read or written."""
import argparse
import os
import pathlib
import sys
import warnings

sys.dont_write_bytecode = True  # the source tree stays clean
TOOLS = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(TOOLS / "report"), str(TOOLS / "runs")]
MOST_RUNS = 8  # as many colours as readers can distinguish on the page


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"report: {message}; '--help' explains\n")


def arguments():
    parser = ArgumentParser(prog="report", description="Makes one self-contained HTML page of a run, or of several.")
    parser.add_argument("folders", metavar="RUN_FOLDER", type=pathlib.Path, nargs="+",
                        help="where a run left its files; the charts of the first one show the others, too")
    parser.add_argument("--output", metavar="FILE", type=pathlib.Path,
                        help="the page (default: report.html in the first RUN_FOLDER)")
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
        import page  # not at the top: see above
        import run_data
        import run_folder
    except ImportError as error:
        if "ORTHOCONE_PYTHON_FOUND" in os.environ:
            sys.exit(f"report: {error}")
        launcher = str(TOOLS / "python")
        os.execv(launcher, [launcher, "numpy,meshio", *sys.argv])
    return page, run_data, run_folder


def check_run_folder(folder):
    if not folder.is_dir():
        raise FileNotFoundError(f"{folder}: no such folder")
    missing = [name for name in ("history.csv", "parameters.prm") if not (folder / name).is_file()]
    if missing:
        raise FileNotFoundError(f"{folder}: not a run folder, for {' and '.join(missing)} "
                                f"{'is' if len(missing) == 1 else 'are'} missing")


def main():
    options = arguments()
    page, run_data, run_folder = load_page()
    sys.stdout.reconfigure(errors="surrogateescape")  # names of folders need not be text
    output = options.output or options.folders[0] / "report.html"
    try:
        for folder in options.folders:
            check_run_folder(folder)
        if not output.parent.is_dir():
            raise FileNotFoundError(f"{output.parent}: no such folder")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of NumPy, on numbers that are too large
            text = page.make([run_data.RunData(folder) for folder in options.folders])
        run_folder.write_whole(output, text)
        print(f"report: {output}")
    except (OSError, run_folder.BadFile) as error:
        words = f"{error.filename}: {error.strerror}" if getattr(error, "filename", None) else error
        print(f"report: {run_folder.one_line(words)}", file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    main()
