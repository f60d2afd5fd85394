# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/report.py on run folders that are damaged, or somebody else's: a line says what is wrong, and no page is left.

Usage: test_report_damaged.py PROGRAM [unittest options]"""
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # the source tree stays clean
from program import main  # noqa: E402
from report_run import COARSE, SCRATCH, report, run  # noqa: E402


def cell(column, text, row=1):
    """Another entry in a row of a table."""
    def change(content):
        lines = [line.split(",") for line in content.splitlines()]
        lines[row][lines[0].index(column)] = text
        return "\n".join(",".join(line) for line in lines) + "\n"
    return change


def entry(place, value):
    """Another value in a JSON file; None of it removes the name."""
    def change(content):
        whole = inner = json.loads(content)
        *path, name = place.split("/")
        for key in path:
            inner = inner[key]
        inner[name] = value
        if value is None:
            del inner[name]
        return json.dumps(whole)
    return change


def setting(name, text):
    return lambda content: re.sub(rf"(?m)^( *set {name} *=).*$", rf"\1 {text}", content)


def array(name, text):
    """Another array in a .vtu file."""
    return lambda content: re.sub(rf'(<DataArray[^>]*Name="{name}"[^>]*)format="\w+"([^>]*>)[^<]*<',
                                  rf'\g<1>format="ascii"\g<2>{text}<', content)


# File, what is done to its text, and what is said.
DAMAGES = (
    ("history.csv", lambda text: "step,ux\n1", "row 1 has 1 entries, not 2"),
    ("history.csv", lambda text: text[:-30], "row 15 has .* entries, not"),
    ("history.csv", lambda text: text.partition("\n")[2], "has . columns '.*'; allowed is one of each name"),
    ("history.csv", lambda text: text + text, "column step does not hold numbers only"),
    ("history.csv", lambda text: text.replace("ux", "uy", 1), "has 2 columns 'uy'"),
    ("history.csv", lambda text: text.replace("force_x", "other", 1), "no column force_x"),
    ("history.csv", lambda text: text.replace("worn_volume", "other", 1), "no 'worn_volume'"),
    *(("history.csv", cell("step", text), "column step has something that is not a whole number")
      for text in ("1.5", "-1", "1e300")),
    *(("history.csv", cell(name, text), f"column {name} has something that is not a finite number")
      for name, text in (("step", "nan"), ("step", "inf"), ("force_x", "nan"), ("dissipation", "9" * 400))),
    ("history.csv", cell("step", "1", 3), "column step does not ascend"),
    ("history.csv", cell("force_z", "much"), "column force_z does not hold numbers only"),
    ("cycles.csv", cell("last_step", "inf"), "column last_step has something"),
    ("cycles.csv", lambda text: text.replace("n_cycles", "other", 1), "no column n_cycles"),
    ("checks.csv", cell("step", "nan"), "column step has something"),
    ("checks.csv", cell("slip_rule", ""), "column slip_rule does not hold numbers only"),
    ("timing.csv", cell("seconds", "soon"), "column seconds does not hold numbers only"),
    ("probe-P.csv", cell("slip_x", "far"), "column slip_x does not hold numbers only"),
    ("probe-P.csv", cell("step", "inf"), "column step has something"),
    *(("summary.json", lambda text, new=new: new, says) for new, says in
      (("{", "is no JSON"), ("{}x", "is no JSON"), ("[]", "allowed is an object"), ("[" * 100000, "too many brackets"))),
    *(("summary.json", entry(place, value), says) for place, value, says in
      (("seconds", [], "seconds has something"), ("seconds/total", "long", "seconds has something that is not a number"),
       ("warnings", 3, "warnings is not words"), ("model", 1, "model is no object"), ("model/cells", None, "model has no cells"),
       ("peaks/slip_mm", {}, "slip_mm has no value"), ("scene/area_mm2", "wide", "scene.area_mm2 is not a number"),
       ("versions", {"BLAS": 1}, "versions has something that is not a word"), ("status", 1, "status is not a word"))),
    ("parameters.prm", lambda text: "subsection Friction\nend", "no section Geometry"),
    *(("parameters.prm", setting(name, text), "cannot be understood") for name, text in
      (("Radius", "0"), ("Radius", "nan"), ("Height", "-1"), ("Layers", "999999999"), ("Layers", "many"), ("Legs", "a : b"),
       ("Legs", "0 0 0"), ("Orthotropy angle", "inf"), ("Coefficients", "0.1, 0"), ("Coefficients", "nan, 1"),
       ("Slip potential", "0, 0"), ("Probes", "P: far 1"))),
    ("parameters.prm", lambda text: setting("Shape", "box")(setting("Sizes", "1, 2, nan")(text)), "Sizes = nan"),
    ("contact-0003.vtu", lambda text: "<VTKFile>", "not a .vtu file of a run"),
    ("contact-0015.vtu", array("wear_depth", "nan " * 25), "field wear_depth has something that is no number"),
    ("contact-0003.vtu", array("pressure", "inf " * 25), "field pressure has something that is no number"),
    ("contact-0001.vtu", lambda text: text.replace('"status"', '"other"'), "no field status"),
    ("contact-0001.vtu", array("connectivity", "0 1 2 9999"), "not a .vtu file of a run"))


class DamagedTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = run("whole", *COARSE, "Load program/Cycles=1", "Output/Probes=P: 1 2", "Wear/Law=archard",
                         "Wear/Coefficient=1e-6", "Load program/Legs=0.01 0 -0.1 : 5; 0 0 0 : 10")

    def copy(self):
        bad = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH.name)) / "bad"
        shutil.copytree(self.folder, bad)
        return bad

    def assert_refused(self, bad, name, says):
        result = report(bad)
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertRegex(result.stderr, rf"^report: \S*{re.escape(name)}: .*{says}.*\n$")
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertFalse(list(bad.glob("*report*")) + list(bad.glob(".*")))

    def test_damaged_files(self):
        for number, (name, change, says) in enumerate(DAMAGES):
            bad = self.copy()
            with self.subTest(name, says=says, number=number):
                text = (bad / name).read_text(encoding="utf-8")
                self.assertNotEqual(change(text), text)
                (bad / name).write_text(change(text), encoding="utf-8")
                self.assert_refused(bad, name, says)

    def test_files_that_are_no_text(self):
        for name in ("history.csv", "cycles.csv", "probe-P.csv", "summary.json"):
            bad = self.copy()
            with self.subTest(name):
                (bad / name).write_bytes((bad / name).read_bytes() + b"\xff\n")
                self.assert_refused(bad, name, "is no UTF-8")

    def test_pipes_and_devices(self):
        for name in ("cycles.csv", "checks.csv", "probe-Q.csv", "summary.json", "contact-0001.vtu", "contact-0099.vtu"):
            for make in (os.mkfifo, lambda path: path.symlink_to("/dev/zero")):
                bad = self.copy()
                with self.subTest(name):
                    (bad / name).unlink(missing_ok=True)
                    make(bad / name)
                    self.assert_refused(bad, name, "is no ordinary file")

    def test_a_mesh_file_that_is_a_pipe_is_not_drawn(self):
        bad = self.copy()
        os.mkfifo(bad / "mesh")
        parameters = bad / "parameters.prm"
        text = setting("Shape", "file")(setting("Mesh file", str(bad / "mesh"))(parameters.read_text(encoding="utf-8")))
        parameters.write_text(text, encoding="utf-8")
        result = report(bad)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("The body is not drawn", (bad / "report.html").read_text(encoding="utf-8"))

    def test_names_that_are_no_text(self):
        bad = self.copy()
        other = os.fsencode(bad) + b"\xff\n"
        os.rename(bad, other)
        shutil.copy(os.path.join(other, b"probe-P.csv"), os.path.join(other, b"probe-\xff<b>.csv"))
        (pathlib.Path(os.fsdecode(other)) / "input.prm").write_bytes(b"# \xff\n")
        result = report(os.fsdecode(other))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(os.path.join(other, b"report.html"), encoding="utf-8") as page:
            self.assertNotIn("<b>.csv", page.read())


def tearDownModule():
    SCRATCH.cleanup()


if __name__ == "__main__":
    main()
