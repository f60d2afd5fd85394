# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pictures of a run folder, unattended: the views of contact.py.

xvfb-run -a -s -noreset pvbatch pictures.py RUN_FOLDER --png DIR [--steps 5,8,12 | --steps all] [--width PIXELS] [--open]
writes {overview,body,slip,pressure,friction}-NNNN.png, and wear-NNNN.png of a run that wears, by default for the step of largest elastic energy. Most
ParaViews, Debian's among them, draw through an X server even in pvbatch; xvfb-run brings one that needs no screen
(without -noreset it sometimes refuses). Not needed at a screen, or if built for EGL or OSMesa.

Exit codes: 0 done; 2 wrong command line; 4 a file could not be read or written."""
import argparse
import os
import pathlib
import sys

from paraview import simple
from vtkmodules.vtkRenderingCore import vtkRenderWindow

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[0])))
import contact  # noqa: E402

WIDTH = 1600  # pixels


def save(what, path, size):
    """Writes a picture, under its name when it is complete."""
    part = path.with_name(f".{path.stem}.part.png")
    try:
        simple.SaveScreenshot(str(part), what, ImageResolution=size, SeparatorWidth=2, SeparatorColor=contact.PLANE)
        if not part.exists():  # what SaveScreenshot returns does not say
            raise contact.RunError(f"{path}: cannot be written")
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def write_pictures(run, views, layout, steps, folder, width=WIDTH):
    size = [width, 3 * width // 4]
    for step in steps:
        simple.GetAnimationScene().AnimationTime = step
        layout.SetSize(size)
        save(layout, folder / f"overview-{step:04d}.png", size)
        for name, view in views.items():
            if name != "body" or run.volume:
                view.ViewSize = [pixels // 2 for pixels in size]  # the layout's are a pixel off, and fonts then scale badly
                save(view, folder / f"{name}-{step:04d}.png", size)


def refuse(message):
    raise contact.RunError(f"{message}; see --help", 2)


def chosen_steps(run, words):
    """The steps of --steps, with files that are there and whole: ParaView would draw another step, or nothing."""
    steps = [str(step) for step in run.contact]
    chosen = steps if words == "all" else words.split(",") if words else [str(run.peak(run.contact, "elastic_energy"))]
    if not set(chosen) <= set(steps):
        refuse(f"--steps {words}: contact.pvd does not have all of them, but {len(steps)}, {steps[0]} to {steps[-1]}")
    for step in map(int, chosen):
        for files in (run.contact, run.volume):
            if step in files:
                contact.Grid(files[step])
    return [int(step) for step in chosen]


def main(words):
    parser = argparse.ArgumentParser("pictures.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run_folder", metavar="RUN_FOLDER")
    parser.add_argument("--png", metavar="DIR", type=pathlib.Path, required=True, help="folder of the pictures")
    parser.add_argument("--steps", metavar="LIST", help="steps, as 5,8,12, or all")
    parser.add_argument("--width", metavar="PIXELS", type=int, default=WIDTH,
                        help=f"of a picture, whose letters are the larger the fewer they are ({WIDTH})")
    parser.add_argument("--open", action="store_true", help="show the whole surface, with the values of open nodes")
    parser.error = refuse  # one line
    options = parser.parse_args(words)
    run = contact.Run(options.run_folder)
    steps = chosen_steps(run, options.steps)
    if options.width < 400:
        refuse(f"--width {options.width}: at least 400")
    # ParaView itself would abort with pages of addresses.
    if vtkRenderWindow().GetClassName() == "vtkXOpenGLRenderWindow" and not os.environ.get("DISPLAY"):
        refuse("no X server to draw with; start with xvfb-run")
    options.png.mkdir(parents=True, exist_ok=True)
    write_pictures(*contact.open_run(options.run_folder, options.open), steps, options.png, options.width)


if __name__ == "__main__":
    if CODE := contact.guarded("pictures.py", main, sys.argv[1:]):
        sys.stdout.flush()
        os._exit(CODE)  # at a proper exit after a failure X may complain, with an exit code of its own
