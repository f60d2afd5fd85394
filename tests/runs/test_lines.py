# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Fields along lines: their files, whatever part of the body is meshed, whoever is killed, and with several processes.

Usage: test_lines.py PROGRAM [unittest options]"""
import json
import math
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from program import ROOT, SMALL, main  # noqa: E402
from resumed_runs import DONE, EVERY_STEP, FILE_ERROR, ResumeTest, WRONG_INPUT  # noqa: E402
from test_ranks import MULTIGRID, RanksTest, SMALL as SHARED  # noqa: E402

COLUMNS = ("s,x,y,z,u_x,u_y,u_z,stress_xx,stress_yy,stress_zz,stress_xy,stress_xz,stress_yz,pressure,traction_x,traction_y,"
           "slip_x,slip_y,status,traction_z,slip_z")
LINES = "Output/Lines=axis: 0 0 0 to 0 0 10, 11; across: -10 0 0 to 10 0 0, 21; low-2: 3 -7 1 to -3 7 4, 15"
NAMES = ("axis", "across", "low-2")
VOLUME_OFF = "Output/Volume fields=0"
WORDS = ("status",)


def numbers(row):
    return {name: value if name in WORDS else float(value) for name, value in row.items()}


class LinesTest(ResumeTest):
    def points(self, output, name, step):
        return [numbers(row) for row in self.rows(output, f"line-{name}-{step:04d}.csv")]

    def assert_close(self, first, second, bound, scale=None):
        """Tables of one line: each column to `bound` of its largest value, or stresses of the largest stress."""
        self.assertEqual(len(first), len(second))
        stress = max(abs(row[name]) for row in second for name in row if name.startswith("stress"))
        for name in second[0]:
            for one, other in zip(first, second):
                with self.subTest(column=name, s=other["s"]):
                    if name in WORDS or math.isnan(other[name]):
                        self.assertEqual(str(one[name]), str(other[name]))
                    elif name in ("u_x", "u_y", "u_z", "slip_x", "slip_y"):
                        self.assertLessEqual(abs(one[name] - other[name]), bound * 0.1)
                    else:
                        self.assertLessEqual(abs(one[name] - other[name]), bound * (20 if len(name) == 1 else stress))


class FilesTest(LinesTest):
    SETTINGS = [*SMALL, "Load program/Cycles=1", VOLUME_OFF, LINES]

    def test_files_and_columns(self):
        """Points of the surface have pressure and slip, the others have none; the force of the plane is that of the history."""
        self.assertEqual(self.run_program("run", settings=self.SETTINGS).returncode, DONE)
        for name in NAMES:
            files = sorted(file.name for file in (self.folder / "run").glob(f"line-{name}-*.csv"))
            self.assertEqual(files, [f"line-{name}-{step:04d}.csv" for step in range(1, 16)])
            self.assertEqual((self.folder / "run" / files[0]).read_text().splitlines()[0], COLUMNS)
        axis, across = self.points("run", "axis", 5), self.points("run", "across", 5)
        self.assertEqual([row["s"] for row in axis], list(range(11)))
        self.assertEqual([row["z"] for row in axis], list(range(11)))
        self.assertEqual([math.isnan(row["pressure"]) for row in axis], [False] + [True] * 10)
        self.assertEqual([row["status"] for row in axis][1:], ["inside"] * 10)
        self.assertTrue(all(row["pressure"] > 0 and row["status"] != "inside" for row in across))
        # The paper's step 5 presses the top by 0.1 mm; the base moves along the plane alone.
        self.assertAlmostEqual(axis[-1]["u_z"], -0.1, delta=1e-12)
        self.assertTrue(all(abs(row["u_z"]) < 1e-12 for row in across))
        for first, last in zip(across, reversed(across)):  # the scene is symmetric about x = 0
            self.assertAlmostEqual(first["slip_x"], -last["slip_x"], delta=1e-12)
            self.assertAlmostEqual(first["stress_zz"], last["stress_zz"], delta=1e-9)

    def test_surface_fields_are_those_of_the_probe(self):
        settings = [*self.SETTINGS, "Output/Probes=P: 10 0"]
        self.assertEqual(self.run_program("run", settings=settings).returncode, DONE)
        for step in (3, 5, 9):
            point, probe = self.points("run", "across", step)[-1], self.rows("run", "probe-P.csv")[step - 1]
            for name in ("pressure", "traction_x", "traction_y", "slip_x", "slip_y"):
                self.assertAlmostEqual(point[name], float(probe[name]), delta=1e-12 * max(1, abs(point[name])), msg=name)
            self.assertEqual(point["status"], probe["status"])

    def test_interval(self):
        for interval, steps in ((0, []), (4, [4, 8, 12, 15])):
            result = self.run_program("run", settings=[*self.SETTINGS, f"Output/Line fields={interval}"])
            self.assertEqual(result.returncode, DONE)
            files = sorted(file.name for file in (self.folder / "run").glob("line-axis-*.csv"))
            self.assertEqual(files, [f"line-axis-{step:04d}.csv" for step in steps])

    def test_files_of_users_are_safe(self):
        self.assertEqual(self.run_program("run", settings=self.SETTINGS).returncode, DONE)
        measured = self.folder / "run/line-measured-2024.csv"
        measured.write_text("mine")
        self.assertEqual(self.run_program("run", settings=[*self.SETTINGS, "Output/Lines="]).returncode, DONE)
        self.assertEqual([file.name for file in (self.folder / "run").glob("line-*.csv")], [measured.name])
        result = self.run_program("run", settings=[*self.SETTINGS, "Output/Lines=measured: 0 0 0 to 0 0 1, 2"])
        self.assertEqual(result.returncode, FILE_ERROR)
        self.assertRegex(result.stderr, r"^orthocone: .*cannot be the run folder \(it holds a line-measured-2024\.csv, and no run ")
        self.assertEqual(measured.read_text(), "mine")

    def test_refused_before_the_folder_is_touched(self):
        settings = [*SMALL, "Output/Lines=out: 0 0 0 to 0 0 11, 12"]
        result = self.run_program("run", settings=settings)
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"^orthocone: .*case_b\.prm: Output/Lines: point 12 of 12 of 'out' at \(0, 0, 11\) lies in no")
        self.assertFalse((self.folder / "run").exists())
        check = self.run_program("run", "--check", settings=settings)
        self.assertEqual((check.returncode, check.stderr), (WRONG_INPUT, result.stderr))

    def test_refused_before_a_search(self):
        for search in ("Mesh/Accuracy=5 %", "Mesh/Adaptive=1", "Load program/Accuracy=5 %"):
            with self.subTest(search):
                result = self.run_program("run", settings=[search, "Load program/Cycles=1", "Output/Lines=out: 0 0 1 to 0 0 -1, 2"])
                self.assertEqual(result.returncode, WRONG_INPUT)
                self.assertRegex(result.stderr, r"^orthocone: .*point 2 of 2 of 'out' at \(0, 0, -1\) lies in no body: ")
                self.assertFalse((self.folder / "run").exists())

    def test_half_space_has_no_fields(self):
        result = self.run_program("run", settings=[*SMALL, "Obstacle/Kind=half-space", "Output/Lines=deep: 0 0 0 to 0 0 -5, 6"])
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"point 2 of 6 of 'deep' at \(0, 0, -1\) lies in no body: allowed are points of the body")


class ModelsTest(LinesTest):
    def test_reduced_models_and_backends(self):
        """The full model's fields, whatever is meshed and solved."""
        settings = [*SMALL, VOLUME_OFF, LINES, "Load program/Legs=0 0 -0.1 : 2; 0 0 -0.05 : 1", "Load program/Cycles=1",
                    "Contact solver/Tolerance=1e-12"]
        runs = {"full": [], "half": [], "quarter": []}
        for model, more in runs.items():
            self.assertEqual(self.run_program(model, settings=[*settings, f"Mesh/Model={model}", *more]).returncode, DONE)
        result = self.run_program("multigrid", settings=[*settings, MULTIGRID, "Mesh/Model=quarter"])
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        for name in NAMES:
            for model in ("half", "quarter", "multigrid"):
                self.assert_close(self.points(model, name, 3), self.points("full", name, 3), 1e-7)

    def test_lower_body(self):
        """Equal bodies give way by half of the approach each, and press each other alike."""
        settings = [*SMALL, VOLUME_OFF, "Obstacle/Kind=body", "Lower mesh/Core cells=2", "Lower mesh/Rings=2",
                    "Lower mesh/Layers=2", "Lower mesh/Degree=1", "Load program/Legs=0 0 -0.1 : 1", "Load program/Cycles=1",
                    "Output/Lines=through: 2 3 -10 to 2 3 10, 41"]
        result = self.run_program("run", settings=settings)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        points = self.points("run", "through", 1)
        for low, high in zip(points[:20], reversed(points)):
            self.assertAlmostEqual(low["u_z"] + 0.05, -(high["u_z"] + 0.05), delta=1e-9)
            self.assertAlmostEqual(low["stress_zz"] / high["stress_zz"], 1, delta=1e-7)
        self.assertEqual([row["status"] == "inside" for row in points], [True] * 20 + [False] + [True] * 20)


class VolumeTest(LinesTest):
    def test_fields_are_those_of_the_volume_files(self):
        """Of warm bodies, too, whose strain of heat causes no stress: at the points that cells have for themselves."""
        import meshio
        import numpy
        settings = [*SMALL, "Mesh/Degree=2", "Load program/Loads=heat: temperature; cool: temperature on lower",
                    "Material/Thermal expansion=1.2e-5", "Lower material/Thermal expansion=2e-5", "Obstacle/Kind=body",
                    "Load program/Legs=uz -0.05 heat 80 cool -30 : 1", "Load program/Cycles=1", "Output/Volume fields=1"]
        result = self.run_program("volume", settings=settings)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        for kind in ("volume", "lower"):
            mesh = meshio.read(self.folder / f"volume/{kind}-0001.vtu")
            _, first, count = numpy.unique(numpy.round(mesh.points, 5), axis=0, return_index=True, return_counts=True)
            least = numpy.abs(mesh.points[first]).min(axis=1)  # in planes of symmetry a line has the mean of both sides
            inside = first[(count == 1) & (least > 0.5) & (numpy.hypot(*mesh.points[first, :2].T) < 8)]
            self.assertGreater(len(inside), 3)
            for i in inside[::len(inside) // 3]:
                x, y, z = map(float, mesh.points[i])
                line = f"Output/Lines=L: {x!r} {y!r} {z!r} to 0 0 {1 if z > 0 else -1}, 2"
                self.assertEqual(self.run_program("line", settings=[*settings, VOLUME_OFF, line]).returncode, DONE)
                point = self.points("line", "L", 1)[0]
                stress = mesh.point_data["stress"][i].reshape(3, 3)
                for name, (a, b) in {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}.items():
                    self.assertAlmostEqual(point["stress_" + name], stress[a, b], delta=1e-5 * abs(stress).max(), msg=(kind, name))
                for axis, name in enumerate(("u_x", "u_y", "u_z")):
                    self.assertAlmostEqual(point[name], mesh.point_data["displacement"][i][axis], delta=1e-7, msg=(kind, name))


class GoOnTest(LinesTest):
    SETTINGS = [*SMALL, EVERY_STEP, LINES, "Output/Line fields=3", "Load program/Cycles=2"]

    def test_killed_and_resumed(self):
        files = [f"line-{name}-{step:04d}.csv" for name in NAMES for step in (3, 15, 18, 30)]
        self.whole(self.SETTINGS, ["history.csv", *files])
        for step in (4, 11, 19):
            run = self.start("killed", self.SETTINGS, "--resume")
            while not (self.folder / f"killed/contact-{step:04d}.vtu").exists() and run.poll() is None:
                time.sleep(0.001)
            run.kill()
            run.communicate()
        late = self.folder / "killed/line-axis-0099.csv"
        late.write_text("of a step that the checkpoint does not know")
        self.assert_resumes("killed", self.SETTINGS)

    def test_files_that_were_lost(self):
        """A run that would have a gap does not go on."""
        settings = [*self.SETTINGS, "Load program/Cycles=1"]
        self.assertEqual(self.run_program("run", settings=settings).returncode, DONE)
        file = self.folder / "run/line-low-2-0006.csv"
        good = file.read_bytes()
        for prepare, says in ((lambda: file.write_bytes(good[:-1]), "is cut off"), (file.unlink, "is missing")):
            prepare()
            result = self.run_program("run", "--resume", settings=self.SETTINGS)
            self.assertEqual(result.returncode, FILE_ERROR)
            self.assertRegex(result.stderr, rf"^orthocone: .*line-low-2-0006\.csv: {says}, so that the run cannot be continued; ")

    def test_more_lines_and_no_fewer(self):
        settings = [*self.SETTINGS, "Load program/Cycles=1"]
        self.assertEqual(self.run_program("run", settings=settings).returncode, DONE)
        result = self.run_program("run", "--resume", settings=[*self.SETTINGS, "Output/Lines=axis: 0 0 0 to 0 0 10, 11"])
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertRegex(result.stderr, r"Output/Lines = axis: .* allowed for --resume is a value that contains these lines and "
                                        r"perhaps more")
        more = f"{LINES}; new: 0 0 5 to 1 0 5, 3"
        self.assertEqual(self.run_program("run", "--resume", settings=[*self.SETTINGS, more]).returncode, DONE)
        steps = [file.stem[-4:] for file in sorted((self.folder / "run").glob("line-new-*.csv"))]
        self.assertEqual(steps, ["0018", "0021", "0024", "0027", "0030"])


class ProcessesTest(RanksTest, LinesTest):
    def test_two_processes(self):
        """The fields of one process, where cells of several sizes and processes meet, too."""
        settings = [*SHARED, "Mesh/Refined cells=1 3", VOLUME_OFF, LINES]
        for n in (1, 2):
            self.assert_done(n, str(n), settings=settings)
        last = json.loads((self.folder / "1/summary.json").read_text())["steps"]["solved"]
        for name in NAMES:
            self.assert_close(self.points("2", name, last), self.points("1", name, last), 1e-7)

    def test_out_of_the_body_on_two_processes(self):
        result = self.run_shared(2, "run", settings=[*SHARED, "Output/Lines=out: 0 0 0 to 0 0 -1, 2"], file=ROOT /
                                 "prm/paper/case_b.prm")
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertIn("point 2 of 2 of 'out' at (0, 0, -1) lies in no body", result.stderr)
        self.assertFalse((self.folder / "run").exists())


if __name__ == "__main__":
    main()
