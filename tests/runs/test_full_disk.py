# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Runs that cannot write, and go on when there is room again.

Usage: test_full_disk.py PROGRAM [unittest options]"""
import os
import resource
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
from program import main  # noqa: E402
from resumed_runs import EVERY_STEP, FILE_ERROR, ResumeTest  # noqa: E402


class FullDiskTest(ResumeTest):
    SETTINGS = ["Mesh/Core cells=4", "Mesh/Degree=1", EVERY_STEP, "Output/Volume fields=5"]

    def assert_stopped(self, result, cause):
        """Exit code and one line; what is there under its name is whole."""
        self.assertEqual(result.returncode, FILE_ERROR, result.stderr)
        self.assertRegex(result.stderr, rf"^orthocone: \S+: .*{cause}.*\n$")
        self.assertEqual(result.stderr.count("\n"), 1)
        for file in (self.folder / "full").rglob("*"):
            self.assertNotEqual(file.suffix, ".part")
            if file.suffix == ".csv":
                self.assertIn(file.read_bytes()[-1:], (b"\n", b""), f"{file.name} ends with half a line")

    def test_files_that_may_not_grow(self):
        """Limits on the size of files; the larger ones stop the growing tables."""
        self.whole(self.SETTINGS)
        sizes = sorted({file.stat().st_size for file in (self.folder / "whole").rglob("*") if file.is_file()})
        limits = [0, 100, 1000, 2000, 4000, 6000, 8000, *[size - 1 for size in sizes if size > 9000][:3]]
        for limit in limits:
            result = self.run_program("full", settings=self.SETTINGS, restore_signals=True, preexec_fn=lambda size=limit:
                                      resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
            with self.subTest(limit=limit):
                self.assert_stopped(result, "File too large")
                self.assert_resumes("full", self.SETTINGS)
            shutil.rmtree(self.folder / "full")

    def test_earlier_results_stay_if_there_is_no_room_for_a_new_run(self):
        self.whole(self.SETTINGS)
        before = {file: file.read_bytes() for file in (self.folder / "whole").rglob("*") if file.is_file()}
        result = self.run_program("whole", settings=[*self.SETTINGS, "Material/Poisson ratio=0.2"], preexec_fn=lambda:
                                  resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
        self.assertEqual(result.returncode, FILE_ERROR)
        after = {file: file.read_bytes() for file in (self.folder / "whole").rglob("*")
                 if file.is_file() and file.suffix != ".part"}
        self.assertEqual(after, before)

    def test_full_file_system(self):
        """A small file system of its own, full at ten different moments, then enlarged."""
        disk = self.folder / "full"
        disk.mkdir()
        if os.geteuid() != 0 or not self.mount("-t", "tmpfs", "-o", "size=4k", "none", disk):
            self.skipTest("file systems cannot be mounted here; the limits on the size of files stand for it")
        self.addCleanup(subprocess.run, ["umount", "-l", disk], check=False)
        self.whole(self.SETTINGS)
        total = sum(file.stat().st_size for file in (self.folder / "whole").rglob("*"))
        for number in range(10):
            size = 4096 + number * total // 11
            with self.subTest(size=size):
                self.assertTrue(self.mount("-o", f"remount,size={size}", disk))
                self.assert_stopped(self.run_program("full", settings=self.SETTINGS), "No space left on device")
                self.assertTrue(self.mount("-o", "remount,size=1g", disk))
                self.assert_resumes("full", self.SETTINGS)
            for file in disk.iterdir():
                shutil.rmtree(file) if file.is_dir() else file.unlink()

    @staticmethod
    def mount(*arguments):
        return subprocess.run(["mount", *arguments], capture_output=True, check=False).returncode == 0


if __name__ == "__main__":
    main()
