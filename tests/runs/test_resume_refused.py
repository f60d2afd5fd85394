# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a run may go on with, and what it refuses to.

Usage: test_resume_refused.py PROGRAM [unittest options]"""
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import SMALL, main  # noqa: E402
from resumed_runs import DONE, EVERY_STEP, FILE_ERROR, ResumeTest, UNSOLVED, WRONG_INPUT  # noqa: E402


class RefusalTest(ResumeTest):
    """What cannot be resumed is reported in a line, and nothing is touched."""
    SETTINGS = [*SMALL, EVERY_STEP, "Load program/Cycles=1", "Output/Volume fields=0"]

    def setUp(self):
        super().setUp()
        self.assertEqual(self.run_program("run", settings=self.SETTINGS).returncode, DONE)

    def content(self):
        return {file: file.read_bytes() for file in sorted(self.folder.rglob("*")) if file.is_file()}

    def assert_refused(self, code, expression, settings=(), file=None):
        before = self.content()
        result = self.run_program("run", "--resume", settings=[*self.SETTINGS, *settings], file=file)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, r"^orthocone: " + expression)
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertEqual(self.content(), before)

    def test_other_parameters(self):
        self.assert_refused(WRONG_INPUT, r".*case_b\.prm: Mesh/Degree = 2, but the run in .*run was started with 1; ",
                            ["Mesh/Degree=2"])
        self.assert_refused(WRONG_INPUT, r".*: Friction/Coefficients = 0\.3, 0\.2, but .* with 0\.3, 0\.15; ",
                            ["Friction/Coefficients=0.3, 0.2"])
        self.assert_refused(WRONG_INPUT, r".*: Output/Probes = , but .* with P: 6\.72 6\.72; allowed .* these probes and",
                            ["Output/Probes="])

    def test_other_gaps_in_the_same_file(self):
        gaps = self.folder / "gap.txt"
        gaps.write_text("-20 40 2 -20 40 2\n0 0\n0 0\n")
        settings = [*self.SETTINGS, f"Obstacle/Gap file={gaps}"]
        self.assertEqual(self.run_program("gap", settings=settings).returncode, DONE)
        gaps.write_text("# the same again\n-20 40 2 -20 40 2\n0 0\n0 0.0\n")
        self.assertEqual(self.run_program("gap", "--resume", settings=settings).returncode, DONE)
        gaps.write_text("-20 40 2 -20 40 2\n0 0\n0 0.001\n")
        result = self.run_program("gap", "--resume", settings=settings)
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"^orthocone: .*: Obstacle/Gap file = .*gap\.txt: has other content than when the run in "
                                        r".*gap was started; allowed for --resume are the same \(or start anew.*\)\n$")

    def test_damaged_checkpoint(self):
        state = self.folder / "run/checkpoint/state"
        good = state.read_bytes()
        middle = len(good) // 2
        for bad, expression in ((b"", "is not a checkpoint"), (b"hello\n", "is not a checkpoint"),
                                (good[:middle], "is cut off"), (good + b"x", "is cut off"),
                                (good[:middle] + bytes([good[middle] ^ 1]) + good[middle + 1:], "is damaged"),
                                (re.sub(rb"^(\S+) \d+ ", rb"\1 999 ", good), "has format version 999, and this")):
            state.write_bytes(bad)
            self.assert_refused(FILE_ERROR, r".*checkpoint/state: " + expression + r".*; without --resume")

    def test_tables_that_lost_lines(self):
        history = self.folder / "run/history.csv"
        history.write_bytes(history.read_bytes()[:-30])
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it is shorter")
        history.unlink()
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it is missing")

    def test_changed_tables_and_lost_fields(self):
        history = self.folder / "run/history.csv"
        good = history.read_bytes()
        history.write_bytes(good.replace(b"\n", b"\r\n"))
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it was changed")
        digit = good.index(b"0.0") + 2
        history.write_bytes(good[:digit] + b"9" + good[digit + 1:])
        self.assert_refused(FILE_ERROR, r".*history\.csv: cannot be continued \(it was changed")
        history.write_bytes(good)
        field = self.folder / "run/contact-0010.vtu"
        whole = field.read_bytes()
        for part in (b"", whole[:-20]):
            field.write_bytes(part)
            self.assert_refused(FILE_ERROR, r".*contact-0010\.vtu: is cut off")
        (self.folder / "run/contact-0010.vtu").unlink()
        result = self.run_program("run", "--resume", settings=self.SETTINGS)
        self.assertEqual(result.returncode, FILE_ERROR)
        self.assertRegex(result.stderr, r"contact-0010\.vtu: is missing")

    def test_lost_checkpoint(self):
        (self.folder / "run/checkpoint/state").unlink()
        self.assert_refused(FILE_ERROR, r".*checkpoint/state: is missing, and the folder holds results of other",
                            ["Mesh/Degree=2"])

    def test_complete_run(self):
        before = self.content()
        result = self.run_program("run", "--resume", settings=self.SETTINGS)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        after = self.content()
        changed = {file.name for file in after if after[file] != before.get(file)}
        self.assertLessEqual(changed, {"log.txt", "summary.json", "state"})

    def test_an_unsolved_step_can_be_tried_otherwise(self):
        file = self.FILE.with_name("case_c_q1.prm")
        stuck = ["Contact solver/Method=feng2006", "Contact solver/Maximum iterations=3",
                 "Mesh/Model=auto", "Load program/Legs=0 0 -0.1 : 1 ; 0 0 -0.08 : 1"]
        result = self.run_program("failed", settings=[*SMALL, *stuck], file=file)
        self.assertEqual(result.returncode, UNSOLVED)
        better = [*SMALL, *stuck, "Contact solver/Method=newton", "Contact solver/Maximum iterations=5000"]
        result = self.run_program("failed", "--resume", settings=better, file=file)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertEqual(len(self.rows("failed")), 2)


class ExtensionTest(ResumeTest):
    """What lies ahead of a run may change, what it has computed may not."""
    SETTINGS = [*SMALL, "Load program/Legs=0 0 -0.1 : 3 ; 0 0 -0.02 : 4", "Output/Volume fields=0"]

    def run_to(self, name, *settings, resume=True):
        result = self.run_program(name, *(["--resume"] if resume else []), settings=[*self.SETTINGS, *settings])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))

    def test_more_cycles(self):
        self.run_to("whole", "Load program/Cycles=5", resume=False)
        self.run_to("run", "Load program/Cycles=2", resume=False)
        self.run_to("run", "Load program/Cycles=5")
        self.assert_same_files("whole", "run", ["history.csv", "checks.csv", "cycles.csv", "probe-P.csv", "contact.pvd",
                                                "contact-0035.vtu", "parameters.prm"])
        result = self.run_program("run", "--resume", settings=[*self.SETTINGS, "Load program/Cycles=4"])
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, "Load program/Cycles = 4, but .* with 5; allowed .* the 35 load steps that are solved")

    def test_other_fields_and_more_probes(self):
        self.run_to("run", "Load program/Cycles=2", "Output/Contact fields=4", resume=False)
        later = ["Load program/Cycles=4", "Output/Contact fields=5", "Output/Volume fields=7",
                 "Output/Probes=rim: 9 0; P: 6.72 6.72"]
        self.run_to("run", *later)
        names = sorted(file.name for file in (self.folder / "run").glob("*-*.vtu"))
        self.assertEqual(names, [f"contact-{step:04d}.vtu" for step in (4, 8, 12, 14, 15, 20, 25, 28)] +
                         [f"volume-{step:04d}.vtu" for step in (21, 28)])
        listed = (self.folder / "run/contact.pvd").read_text()
        self.assertEqual([name for name in names if name in listed], names[:8])
        self.assertEqual([row["step"] for row in self.rows("run", "probe-rim.csv")], [str(step) for step in range(15, 29)])
        self.assertEqual(len(self.rows("run", "probe-P.csv")), 28)
        self.run_to("run", *later)  # the same again: nothing to do, nothing lost
        self.assertEqual(sorted(file.name for file in (self.folder / "run").glob("*-*.vtu")), names)


if __name__ == "__main__":
    main()
