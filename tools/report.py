#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes one self-contained HTML page of a run: tools/report.py RUN_FOLDER [--output FILE]

The page needs no network and no other file. Exit codes: 0 done; 2 wrong command line; 4 a file could not be read or
written."""
import argparse
import os
import pathlib
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
TOOLS = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(TOOLS / "report"), str(TOOLS / "plots")]


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"report: {message}; '--help' explains\n")


def arguments():
    parser = ArgumentParser(prog="report", description="Makes one self-contained HTML page of a run.")
    parser.add_argument("folder", metavar="RUN_FOLDER", type=pathlib.Path, help="where the run left its files")
    parser.add_argument("--output", metavar="FILE", type=pathlib.Path,
                        help="the page (default: RUN_FOLDER/report.html)")
    return parser.parse_args()


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
    try:
        import page  # not at the top: it needs numpy and meshio
        import run_data
    except ImportError as error:
        sys.exit(f"report: {error}; Debian's packages python3-numpy and python3-meshio have what is needed")
    output = options.output or options.folder / "report.html"
    try:
        check_run_folder(options.folder)
        text = page.make(run_data.RunData(options.folder))
        write_whole(output, text)
    except (OSError, run_data.BadFile) as error:
        print(f"report: {one_line(error)}", file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    main()
