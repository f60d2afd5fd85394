# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Draws a scene before its run: scene.py --output FILE.svg|FILE.png [--title TEXT] < DESCRIPTION

The description is the JSON that `orthocone --check --picture FILE` makes; that command starts this program. Exit codes:
0 done; 2 wrong command line; 4 the description could not be read, or the picture not be written."""
import argparse
import contextlib
import io
import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # threads would need memory, and have nothing to do

import matplotlib  # noqa: E402

matplotlib.use("Agg")
matplotlib.rcdefaults()  # whatever settings lie in the present folder
matplotlib.rcParams.update({"font.size": 9, "svg.fonttype": "none", "svg.hashsalt": "orthocone", "hatch.linewidth": 0.7,
                            "axes.spines.top": False, "axes.spines.right": False, "axes.titlesize": 9.5,
                            "axes.titlelocation": "left"})

import sheet  # noqa: E402

DPI = 130


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"scene: {message}; '--help' explains\n")


def arguments():
    parser = ArgumentParser(prog="scene", description="Draws a scene before its run.")
    parser.add_argument("--output", metavar="FILE", required=True, help="the picture, a .svg or .png")
    parser.add_argument("--title", default="", help="a line above the picture")
    return parser.parse_args()


def content_of(figure, kind):
    """The bytes of the picture; without dates, so that the same scene gives the same bytes."""
    content = io.BytesIO()
    figure.savefig(content, format=kind, dpi=DPI, metadata={"Date": None} if kind == "svg" else {"Software": None})
    return content.getvalue()


def write_whole(path, content):
    """Under its name the picture is complete, or as it was. A pipe, a device or a folder stays."""
    if os.path.lexists(path) and not os.path.islink(path) and not os.path.isfile(path):
        raise ValueError(f"{path}: is no ordinary file, and stays as it is")
    folder, name = os.path.split(path)
    part = os.path.join(folder, f".{name[:80]}.{os.urandom(6).hex()}.part")
    try:
        with open(part, "xb") as file:
            file.write(content)
        os.replace(part, path)
    except OSError as error:
        with contextlib.suppress(OSError):
            os.unlink(part)
        raise OSError(error.errno, error.strerror, path) from error


def main():
    options = arguments()
    try:
        scene = json.load(sys.stdin)
        figure = sheet.draw(scene, options.title)
        write_whole(options.output, content_of(figure, pathlib.Path(options.output).suffix[1:]))
    except OSError as error:
        print(f"{error.filename}: cannot be written ({error.strerror})", file=sys.stderr)
        sys.exit(4)
    except ValueError as error:
        print(" ".join(str(error).split()), file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    main()
