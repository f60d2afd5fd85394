# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs that several processes share: the states of one process, whoever is killed, and one voice.

Usage: test_ranks.py PROGRAM [unittest options]"""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
from multigrid_scenes import ISOTROPIC, ONE_CYCLE, SCENES, differences, numbers  # noqa: E402
from program import ROOT, RunTest, main  # noqa: E402
from resumed_runs import DONE, EVERY_STEP, FILE_ERROR, UNSOLVED, WRONG_INPUT  # noqa: E402

# Open MPI refuses root otherwise, and on busy cores each process waits for the others at full speed. Version 5 complains of
# networks, which processes of one machine do not need.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "PRTE_ALLOW_RUN_AS_ROOT": "1", "PRTE_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none", "OMPI_MCA_btl": "^tcp"}
MULTIGRID = "Mesh/Backend=multigrid"
SMALL = [*ISOTROPIC, *ONE_CYCLE, MULTIGRID, "Mesh/Refinements=1"]
ON_FOUR = {"case C, degree 3", "cells of three sizes", "sheared box on a wave"}


class RanksTest(RunTest):
    def shared(self, n, output, *arguments, **options):
        """The command line of a run on n processes; one: without mpirun."""
        command = self.command(output, *arguments, **options)
        return [*(["mpirun", "--oversubscribe", "-n", str(n)] if n > 1 else []), *command]

    def run_shared(self, n, output, *arguments, **options):
        return subprocess.run(self.shared(n, output, *arguments, **options), cwd=self.folder, env=ENVIRONMENT, text=True,
                              capture_output=True, timeout=600, check=False)

    def assert_done(self, n, output, *arguments, **options):
        result = self.run_shared(n, output, *arguments, **options)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        return numbers(self.rows(output))

    def assert_same(self, first, second):
        for column, difference in differences(first, second).items():
            self.assertLessEqual(difference, 10, column)

    def summary(self, output):
        return json.loads((self.folder / output / "summary.json").read_text())


class SameStatesTest(RanksTest):
    def test_scenes(self):
        """What differences() compares, to ten times the tolerance of its scale."""
        scenes = {name: {"settings": [*settings, MULTIGRID, "Output/Volume fields=0"], "file": ROOT / "prm" / file}
                  for name, (file, settings) in SCENES.items()}
        answers = self.run_all(*(self.command(f"{name}, one", **options) for name, options in scenes.items()))
        for (name, options), answer in zip(scenes.items(), answers, strict=True):
            n = 4 if name in ON_FOUR else 2
            with self.subTest(scene=name, processes=n):
                self.assertEqual((answer["exit"], answer["message"]), (DONE, ""))
                self.assert_same(numbers(self.rows(f"{name}, one")), self.assert_done(n, "several", **options))

    def test_more_processes_than_cells_of_the_coarsest_mesh(self):
        """Some own nothing of it."""
        settings = ["Geometry/Shape=box", "Mesh/Cells=1, 1, 2", *ONE_CYCLE, MULTIGRID, "Mesh/Refinements=2",
                    "Output/Volume fields=0"]
        self.assert_same(self.assert_done(1, "one", settings=settings), self.assert_done(3, "several", settings=settings))

    def test_contact_fields_are_those_of_one_process(self):
        """The same nodes in the same order."""
        import meshio
        files = []
        for n in (1, 3):
            self.assert_done(n, str(n), settings=[*SMALL, "Mesh/Model=full", "Output/Volume fields=0"])
            files.append(meshio.read(self.folder / str(n) / "contact-0004.vtu"))
        self.assertLess(abs(files[0].points - files[1].points).max(), 1e-12)
        for name in ("pressure", "slip", "accumulated_slip", "status"):
            first, second = (file.point_data[name] for file in files)
            self.assertLessEqual(abs(first - second).max(), 1e-8 * abs(first).max(), name)

    def test_volume_comes_in_pieces(self):
        """All cells once, with the displacement that one process writes, where nodes hang, too."""
        import meshio
        import numpy
        for n in (1, 3):
            self.assert_done(n, str(n), settings=[*SMALL, "Mesh/Refined cells=1 3", "Output/Volume fields=4"])
        whole = meshio.read(self.folder / "1/volume-0004.vtu")
        names = re.findall(r'Source="(.*?)"', (self.folder / "3/volume-0004.pvtu").read_text())
        self.assertEqual(names, [f"volume-0004.{rank}.vtu" for rank in range(3)])
        self.assertIn('file="volume-0004.pvtu"', (self.folder / "3/volume.pvd").read_text())
        pieces = [meshio.read(self.folder / "3" / name) for name in names]
        self.assertEqual(sum(len(piece.cells[0].data) for piece in pieces), len(whole.cells[0].data))

        def table(meshes):
            rows = numpy.vstack([numpy.hstack([mesh.points, mesh.point_data["displacement"]]) for mesh in meshes])
            return rows[numpy.lexsort(numpy.round(rows[:, :3], 3).T)]

        # Points of the volume are written in single precision; those of cells that meet have the same displacement.
        first, second = table([whole]), table(pieces)
        self.assertLess(abs(first[:, :3] - second[:, :3]).max(), 1e-4)
        self.assertLess(abs(first[:, 3:6] - second[:, 3:6]).max(), 1e-5 * abs(first[:, 3:6]).max())


class AdaptiveTest(RanksTest):
    SETTINGS = [*SMALL, "Mesh/Adaptive=2", "Load program/Cycles=2", EVERY_STEP, "Output/Volume fields=0",
                "Mesh/Volumetric quadrature=projected"]

    def refined_cells(self, output):
        return re.search(r"set Refined cells *= (.*)", (self.folder / output / "parameters.prm").read_text()).group(1)

    def test_cells_are_those_of_one_process(self):
        """Each process knows the errors of its own cells; together they halve the same ones, and go on with them."""
        whole = self.assert_done(1, "one", settings=self.SETTINGS)
        self.assertEqual(self.refined_cells("one").count(";"), 1)
        for n in (2, 3):
            with self.subTest(processes=n):
                self.assert_same(whole, self.assert_done(n, str(n), settings=self.SETTINGS))
                self.assertEqual(self.refined_cells(str(n)), self.refined_cells("one"))

    def test_resumed_without_another_search(self):
        first = [setting.replace("Cycles=2", "Cycles=1") for setting in self.SETTINGS]
        self.assert_done(2, "run", settings=first)
        cells = self.refined_cells("run")
        resumed = self.assert_done(2, "run", "--resume", settings=self.SETTINGS)
        self.assert_same(self.assert_done(2, "whole", settings=self.SETTINGS), resumed)
        self.assertEqual(self.refined_cells("run"), cells)


class ResumedTest(RanksTest):
    SETTINGS = [*SMALL, "Load program/Cycles=2", EVERY_STEP, "Output/Volume fields=3"]

    def killed(self, victim, output):
        """A run on two processes, one of which is killed after a few steps."""
        history = self.folder / output / "history.csv"
        run = subprocess.Popen(self.shared(2, output, settings=self.SETTINGS), cwd=self.folder, env=ENVIRONMENT, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while run.poll() is None and (not history.exists() or history.read_text().count("\n") <= 4):
            time.sleep(0.002)
        processes = sorted(int(number) for children in pathlib.Path(f"/proc/{run.pid}/task").glob("*/children")
                           for number in children.read_text().split())
        self.assertEqual(len(processes), 2)
        os.kill(processes[victim], signal.SIGKILL)
        run.communicate()
        self.assertNotEqual(run.returncode, DONE)

    def test_whoever_is_killed(self):
        """On as many processes to the last bit, whichever is killed; on others to ten times the tolerance, for which the
        checkpoint is the same."""
        whole = self.assert_done(2, "whole", settings=self.SETTINGS)
        for victim in (0, 1):
            with self.subTest(killed=victim):
                self.killed(victim, "killed")
                for n in (1, 2, 4) if victim == 0 else (2,):
                    shutil.copytree(self.folder / "killed", self.folder / f"on-{n}", dirs_exist_ok=True)
                    resumed = self.assert_done(n, f"on-{n}", "--resume", settings=self.SETTINGS)
                    self.assert_same(whole, resumed)
                    self.assertEqual(self.summary(f"on-{n}")["status"], "complete")
                    self.assertEqual(self.summary(f"on-{n}")["processes"], n)
                self.assert_same_files("whole", "on-2", ["history.csv", "checks.csv", "cycles.csv", "contact-0012.vtu",
                                                         "volume-0012.1.vtu", "volume.pvd"])
                shutil.rmtree(self.folder / "killed")

    def test_a_run_of_one_process_goes_on_with_two(self):
        whole = self.assert_done(1, "run", settings=self.SETTINGS)
        short = [setting.replace("Cycles=2", "Cycles=1") for setting in self.SETTINGS]
        self.assert_done(1, "grown", settings=short)
        self.assert_same(whole, self.assert_done(2, "grown", "--resume", settings=self.SETTINGS))

    def test_a_condensed_run_cannot_be_shared(self):
        """The backend was chosen when it began."""
        settings = [setting for setting in self.SETTINGS if setting != MULTIGRID]
        self.assert_done(1, "run", settings=[setting.replace("Cycles=2", "Cycles=1") for setting in settings])
        result = self.run_shared(2, "run", "--resume", settings=settings)
        self.assertEqual(result.returncode, WRONG_INPUT)
        self.assertIn("Mesh/Backend = condensed, as the run has chosen, with 2 processes", result.stderr)
        self.assert_done(1, "run", "--resume", settings=settings)

    def test_a_piece_that_is_missing(self):
        self.assert_done(2, "run", settings=[*self.SETTINGS, "Load program/Cycles=1"])
        (self.folder / "run/volume-0003.1.vtu").unlink()
        result = self.run_shared(2, "run", "--resume", settings=self.SETTINGS)
        self.assertEqual(result.returncode, FILE_ERROR)
        self.assertIn("volume-0003.1.vtu: is missing", result.stderr)

    def test_nothing_stays_of_the_run_before(self):
        self.assert_done(2, "run", settings=self.SETTINGS)
        self.assert_done(1, "run", settings=self.SETTINGS)
        self.assertEqual([file.name for file in (self.folder / "run").glob("*.pvtu")], [])
        self.assertEqual([file.name for file in (self.folder / "run").glob("volume-*.*.vtu")], [])


class OneVoiceTest(RanksTest):
    def assert_refused(self, message, *settings, file=None):
        """One line of ours; mpirun adds some of its own."""
        result = self.run_shared(2, "refused", settings=settings, file=file)
        self.assertEqual(result.returncode, WRONG_INPUT)
        lines = [line for line in result.stderr.splitlines() if line.startswith("orthocone")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertIn(message, lines[0])
        self.assertFalse((self.folder / "refused").exists())

    def test_what_is_not_shared_is_refused(self):
        self.assert_refused("Mesh/Backend = condensed with 2 processes: allowed is multigrid", "Mesh/Backend=condensed")
        self.assert_refused("Mesh/Model = axisymmetric with 2 processes", file=ROOT / "prm/paper/case_a.prm")
        self.assert_refused("Mesh/Accuracy = 1 with 2 processes", "Mesh/Accuracy=1 %")
        self.assert_refused("Load program/Accuracy = 1 with 2 processes", "Load program/Accuracy=1 %")
        self.assert_refused("Mesh/Backend = auto with 2 processes", "Contact solver/Method=uzawa")

    def test_files_that_differ(self):
        """One process cannot know what the others have read."""
        files = [self.folder / f"{rank}.prm" for rank in (0, 1)]
        for rank, file in enumerate(files):
            file.write_text(f"include {self.FILE}\nsubsection Material\n  set Young modulus = {rank + 1}e5\nend\n")
        command = [str(word) for word in self.shared(2, "run", settings=SMALL[:-1])]
        command[command.index(str(self.FILE))] = "$OMPI_COMM_WORLD_RANK.prm"
        words = " ".join(f'"{word}"' for word in command[4:])
        result = subprocess.run([*command[:4], "sh", "-c", words], cwd=self.folder, env=ENVIRONMENT, text=True,
                                capture_output=True, timeout=600, check=False)
        self.assertEqual(result.returncode, WRONG_INPUT, result.stderr)
        self.assertIn("not all of the 2 processes have the same entries", result.stderr)

    def test_wrong_input_is_reported_once(self):
        self.assert_refused("Material/Young modulus", "Material/Young modulus=-1")

    def test_a_step_that_is_not_solved(self):
        result = self.run_shared(2, "run", settings=[*SMALL, "Contact solver/Maximum iterations=1", "Output/Volume fields=0"])
        self.assertEqual(result.returncode, UNSOLVED)
        self.assertEqual(len([line for line in result.stderr.splitlines() if line.startswith("orthocone")]), 1)
        self.assertNotEqual(self.summary("run")["status"], "complete")
        self.assertTrue((self.folder / "run/checkpoint/state").exists())

    def test_auto_takes_multigrid(self):
        self.assert_done(2, "run", settings=[*SMALL, "Mesh/Backend=auto", "Output/Volume fields=0"])
        log = (self.folder / "run/log.txt").read_text()
        self.assertRegex(log, "backend        multigrid: 2 processes; one process alone would take less time, condensed about")
        self.assertEqual(log.count("processes      2\n"), 1)
        self.assertIn("threads        1 (one for each of 2 processes)\n", log)

    def test_version_and_check_are_printed_once(self):
        check = self.shared(2, "run", "--check", settings=SMALL)
        for command, word in ((check, "contact nodes"), ([*check[:4], check[4], "--version"], "deal.II")):
            result = subprocess.run(command, cwd=self.folder, env=ENVIRONMENT, text=True, capture_output=True, timeout=600,
                                    check=False)
            self.assertEqual((result.returncode, result.stdout.count(word)), (DONE, 1), result.stderr)


if __name__ == "__main__":
    main()
