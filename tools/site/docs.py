# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The site of the pages and of the public headers: README.md, docs/*.md, CONTRIBUTING.md and CHANGELOG.md by Sphinx and
MyST, the headers by Doxygen and Breathe. All is made in a folder of its own, and takes the place of an older site at the end."""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile
import warnings

sys.dont_write_bytecode = True  # the source tree stays clean
from sphinx.cmd.build import build_main  # noqa: E402

import headers  # noqa: E402
import installed  # noqa: E402
import interface  # noqa: E402
import pages  # noqa: E402
import theme  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def run_doxygen(folder):
    """Reads folder/include, writes folder/xml."""
    settings = (HERE / "Doxyfile").read_text(encoding="utf-8")
    done = subprocess.run(["doxygen", "-"], input=settings, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode or done.stderr:
        sys.exit(f"docs: doxygen: {done.stderr.strip() or done.returncode}")


def run_sphinx(source, xml, html, doctrees):
    """A warning is an error, but for those of Python on the libraries' use of each other."""
    warnings.filterwarnings("ignore", module="breathe")
    code = build_main(["-q", "-W", "--keep-going", "-b", "html", "-c", str(HERE), "-d", str(doctrees),
                       "-D", f"breathe_projects.orthocone={xml}", str(source), str(html)])
    if code:
        sys.exit("docs: the pages have errors, see above")


def check(output):
    """What is there will be removed, so it must be a site, or nothing."""
    if output.exists() and any(output.iterdir()) and not (output / "objects.inv").exists():
        sys.exit(f"docs: {output}: has something else in it than a site, and stays as it is")


def publish(html, output):
    if output.exists():
        shutil.rmtree(output)
    shutil.copytree(html, output)


def make(scratch, package):
    """The site, in a folder for all that is needed on the way. Returns its own folder."""
    source, xml, html = scratch / "source", scratch / "xml", scratch / "html"
    changed = (lambda name, text: installed.page(name, text, package)) if package else (lambda name, text: text)
    pages.write(ROOT, source, (HERE / "contents.md").read_text(encoding="utf-8"), changed)
    headers.write(ROOT, scratch / "include")
    run_doxygen(scratch)
    interface.write(ROOT, xml, source / "api")
    run_sphinx(source, xml, html, scratch / "doctrees")
    theme.mend(html)
    return html


def main():
    parser = argparse.ArgumentParser(prog="tools/docs", description=__doc__)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/site")
    parser.add_argument("--package", choices=installed.PACKAGES, help="with the commands of this package of tools/package")
    options = parser.parse_args()
    try:
        check(options.output)
        with tempfile.TemporaryDirectory() as scratch:
            publish(make(pathlib.Path(scratch), options.package), options.output)
    except OSError as error:
        sys.exit(f"docs: {error}")
    print(f"docs: {options.output}/index.html", file=sys.stderr)


if __name__ == "__main__":
    main()
