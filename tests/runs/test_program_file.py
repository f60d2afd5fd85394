# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Measured signals that drive the upper face (Load program/Program file).

Usage: test_program_file.py PROGRAM [unittest options]"""
import math
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import program  # noqa: E402
from program import ROOT, SMALL  # noqa: E402

DONE, WRONG_INPUT, FILE_ERROR = 0, 2, 4
ROWS_A_CYCLE, N_CYCLES = 25, 20
TABLES = ("history.csv", "cycles.csv", "checks.csv")


def sine():
    """501 rows: u_x (mm) of a fretting test under a constant normal force (N), which the first row puts on."""
    return [(-40000, 0.004 * math.sin(2 * math.pi * (row % ROWS_A_CYCLE) / ROWS_A_CYCLE))
            for row in range(N_CYCLES * ROWS_A_CYCLE + 1)]


class ProgramFileTest(program.RunTest):
    SETTINGS = [*SMALL, "Output/Contact fields=0", "Output/Probes=", "Mesh/Layers=1", "Mesh/Core cells=1", "Mesh/Rings=1",
                "Load program/Cycles=1"]

    def write(self, text):
        path = self.folder / "signal.csv"
        path.write_text(text, encoding="utf-8")
        return [*self.SETTINGS, f"Load program/Program file={path}"]

    def done(self, name, settings, *arguments):
        result = self.run_program(name, *arguments, settings=settings)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return result

    def test_rows_run_like_legs(self):
        """The cycles that are found are those that legs would have said: the same to the last bit."""
        signal = sine()
        given = self.write("Fz [kN],ux [um]\n" + "".join(f"{force / 1000!r},{u_x * 1000!r}\n" for force, u_x in signal))
        legs = [f"Fz {force / 1000 * 1000!r} ux {u_x * 1000 * 1e-3!r} : 1" for force, u_x in signal]
        self.done("file", given)
        self.done("legs", [*self.SETTINGS, f"Load program/Preload={legs[0]}",
                           f"Load program/Legs={';'.join(legs[1:ROWS_A_CYCLE + 1])}", f"Load program/Cycles={N_CYCLES}"])
        self.assert_same_files("file", "legs", TABLES)
        self.assertEqual(len(self.rows("file", "cycles.csv")), N_CYCLES)
        self.assertIn(f"signal.csv, which have {N_CYCLES} complete cycles\n", (self.folder / "file/log.txt").read_text(encoding="utf-8"))

    def test_times_resume_and_report(self):
        settings = self.write("time [ms];Fz;ux\n" + "".join(f"{20 * i};{force};{u_x}\n" for i, (force, u_x) in enumerate(sine()[:60])))
        settings.append("Load program/Steps per row=2")
        self.done("whole", settings)
        times = [float(row["time"]) for row in self.rows("whole")]
        self.assertEqual(len(times), 120)
        for i, time in enumerate(times):
            self.assertAlmostEqual(time, 0.01 * (i - 1), delta=1e-12)
        self.kill_after("resumed", [*settings, "Output/Checkpoint=0"], 1.5)
        self.done("resumed", [*settings, "Output/Checkpoint=0"], "--resume")
        self.assert_same_files("whole", "resumed", TABLES)
        page = self.folder / "page.html"
        subprocess.run([sys.executable, ROOT / "tools/report.py", self.folder / "whole", "--output", page], check=True,
                       cwd=self.folder, capture_output=True, timeout=100)
        self.assertIn("ux", page.read_text(encoding="utf-8"))

    def test_a_file_that_changed_is_refused(self):
        settings = self.write("uz\n-0.01\n-0.02\n")
        self.done("run", settings)
        self.write("uz\n-0.01\n-0.03\n")
        result = self.run_program("run", "--resume", settings=settings)
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"Load program/Program file = .*signal\.csv: has other content than when the run")
        self.write("uz\n-0.01\n-0.02\n")
        result = self.run_program("run", "--resume", settings=[*settings, "Load program/Cycles=2"])
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"Load program/Cycles = 2, but .* with 1; allowed for --resume is 1 if it was 1")

    def test_refused(self):
        for content, settings, code, expression in (
                ("uz\n-0.01\n\n0,5\n", (), WRONG_INPUT, r"case_b\.prm: \S*signal\.csv:4: has 2 cells: allowed are the 1 of"),
                ("uz [kN]\n-0.01\n", (), WRONG_INPUT, r"case_b\.prm: \S*signal\.csv:1: column 'uz' has the unit 'kN': allowed are mm"),
                ("cycle,uz\n1,-0.01\n", ["Load program/Cycles=2"], WRONG_INPUT,
                 r"case_b\.prm: Load program/Cycles = 2 with a column 'cycle' in .*: allowed is 1, or a file without that column"),
                ("uz\n-0.01\n", ["Load program/Accuracy=1 %"], WRONG_INPUT,
                 r"case_b\.prm: Load program/Accuracy = 1 % with Load program/Program file: allowed is 0; Steps per row"),
                ("\x00", (), WRONG_INPUT, r"case_b\.prm: \S*signal\.csv: is not a text file; a CSV file"),
                (None, (), FILE_ERROR, r"\S*signal\.csv: cannot be read \(No such file")):
            with self.subTest(expression=expression):
                given = self.write(content or "")
                if content is None:
                    (self.folder / "signal.csv").unlink()
                result = self.run_program("run", settings=[*given, *settings])
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertRegex(result.stderr, r"^orthocone: (\S*/)?" + expression + r".*\n$")

    def test_legs_beside_it_are_said_to_be_ignored(self):
        self.done("run", [*self.write("uz\n-0.01\n"), "Load program/Legs=0 0 -0.1 : 7"])
        self.assertIn("Load program/Legs = 0 0 -0.1 : 7 is ignored with Load program/Program file = ",
                      (self.folder / "run/log.txt").read_text(encoding="utf-8"))
        self.assertEqual(len(self.rows("run")), 1)


if __name__ == "__main__":
    program.main()
