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

sys.dont_write_bytecode = True  # the source tree stays clean
TOOLS = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(TOOLS / "report"), str(TOOLS / "plots")]
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
    except ImportError as error:
        if "ORTHOCONE_PYTHON_FOUND" in os.environ:
            sys.exit(f"report: {error}")
        launcher = str(TOOLS / "python")
        os.execv(launcher, [launcher, "numpy,meshio", *sys.argv])
    return page, run_data


def check_run_folder(folder):
    if not folder.is_dir():
        raise FileNotFoundError(f"{folder}: no such folder")
    missing = [name for name in ("history.csv", "parameters.prm") if not (folder / name).is_file()]
    if missing:
        raise FileNotFoundError(f"{folder}: not a run folder, for {' and '.join(missing)} "
                                f"{'is' if len(missing) == 1 else 'are'} missing")


def write_whole(path, text):
    """Under its name the file is complete or not there."""
    if not path.parent.is_dir():
        raise FileNotFoundError(f"{path.parent}: no such folder")
    if path.exists() and not path.is_file():
        raise FileExistsError(f"{path}: is no ordinary file, and stays as it is")
    temporary = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(path)
    except BaseException as error:
        temporary.unlink(missing_ok=True)
        if isinstance(error, OSError):
            raise OSError(error.errno, error.strerror, str(path)) from error
        raise


def one_line(error):
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    return " ".join(str(error).split())


def main():
    options = arguments()
    page, run_data = load_page()
    output = options.output or options.folders[0] / "report.html"
    try:
        for folder in options.folders:
            check_run_folder(folder)
        text = page.make([run_data.RunData(folder) for folder in options.folders])
        write_whole(output, text)
        print(f"report: {output}")
    except (OSError, run_data.BadFile) as error:
        print(f"report: {one_line(error)}", file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    main()
