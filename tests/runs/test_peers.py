# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""tools/study peers where no peer is installed: it names who is missing, and races ours alone. Nothing is installed here.

Usage: test_peers.py PROGRAM [unittest options]"""
import contextlib
import csv
import io
import pathlib
import sys
from unittest import mock

import numpy as np

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, RunTest, main  # noqa: E402

sys.path.insert(0, str(ROOT / "tools/studies"))
import paths  # noqa: E402, F401 (finds the modules of all studies)
import fclib_files  # noqa: E402
import peers  # noqa: E402
import profiles  # noqa: E402
import race  # noqa: E402
import scenes_race  # noqa: E402

OURS = ["newton", "gauss-seidel", "uzawa", "plain-newton"]


class PeersTest(RunTest):
    def peers(self, *options, draws=False):
        """What the script of tools/study peers prints, as if nobody else were there."""
        figures = profiles.figures if draws else lambda *_: {}
        words = ["peers.py", "--quick", "--output", str(self.folder / "out"), *map(str, options)]
        text = io.StringIO()
        with mock.patch.object(sys, "argv", words), mock.patch.object(peers, "SICONOS_HEADERS", ()), \
                mock.patch.object(peers, "BUILD", pathlib.Path(PROGRAM).resolve().parent), \
                mock.patch.object(race, "MOST_LIMIT", 0.3), mock.patch.object(profiles, "figures", figures), \
                mock.patch.object(scenes_race, "there", lambda program: program == "orthocone"), \
                contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
            peers.main()
        return text.getvalue()

    def answers(self):
        with open(self.folder / "out/answers.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_ours_race_alone(self):
        """Rows, tables and pictures are there. Rigid bodies have no forces to compare with."""
        text = self.peers("--only", "problems", "--families", "friction,rigid", draws=True)
        self.assertIn("no Siconos here (Debian's libsiconos-numerics-dev)", text)
        rows = self.answers()
        named = {row["problem"]: row["family"] for row in rows}
        self.assertEqual(named, {"friction-8-1/7": "friction", "friction-8-1/14": "friction", "stack-2-10/1": "rigid",
                                 "stack-2-10-law/1": "rigid"})
        for row in rows:
            if row["solver"] == "newton":
                self.assertEqual(row["verdict"], "solved", row)
            if row["verdict"] == "solved":
                self.assertLessEqual(float(row["error"]), 1e-8, row)
                self.assertGreater(float(row["seconds"]), 0)
            if row["solver"] == "newton" and row["family"] == "friction":
                self.assertLess(float(row["difference"]), 1e-6)
        for name in named:
            self.assertEqual([row["solver"] for row in rows if row["problem"] == name], OURS)
        self.assertIn("| `newton` | 4 |", text)
        self.assertTrue((self.folder / "out/peers_profiles.png").exists())
        self.assert_only_what_changed_is_raced_again()

    def assert_only_what_changed_is_raced_again(self):
        """Rows of another program or problem are not mixed with those of this one."""
        self.assertIn("4 problems, of which 0 are", self.peers("--only", "problems", "--families", "friction,rigid"))
        file = self.folder / "out/answers.csv"
        other = self.answers()[0]["fingerprint"]
        file.write_text(file.read_text(encoding="utf-8").replace(other, "0123456789ab"), encoding="utf-8")
        (self.folder / "out/problems/stack-2-10/done.json").write_text("{}")  # made again, which changes its dates at least
        text = self.peers("--only", "problems", "--families", "friction,rigid")
        self.assertRegex(text, "4 problems, of which [1-3] are")
        rows = self.answers()
        self.assertEqual(len(rows), 4 * len(OURS))
        self.assertNotIn("0123456789ab", {row["fingerprint"] for row in rows})

    def test_rows_that_are_kept(self):
        """Those of what is not asked for stay, whatever is computed anew."""
        file = self.folder / "rows.csv"
        race.Answers(file, {"a": "1", "b": "2"}).add([{"problem": name, "solver": "newton"} for name in "ab"])
        for fingerprints, is_anew, missing in (({"a": "1", "b": "2"}, False, []), ({"a": "1", "b": "3"}, False, ["b"]),
                                               ({"a": "1"}, True, ["a"])):
            answers = race.Answers(file, fingerprints, is_anew)
            self.assertEqual(answers.missing(), missing)
            answers.add([{"problem": name, "solver": "newton"} for name in missing])
            self.assertEqual({row["problem"] for row in answers.asked_for()}, set(fingerprints))
            self.assertEqual(sorted(row["problem"] for row in race.Answers(file, {}).rows), ["a", "b"])

    def test_files_at_hand(self):
        """All below the folder; those that are refused are named with the reason."""
        folder = self.folder / "collection"
        (folder / "deep").mkdir(parents=True)
        mu = np.full(2, 0.3)
        W, q = np.kron([[1, 0.4], [0.4, 1]], np.diag([1, 1.2, 1.1])), np.array([-1, 0.1, 0.2, -0.5, 0.4, 0.1])
        fclib_files.write(folder / "good.hdf5", W, q, mu)
        fclib_files.write(folder / "deep/plane.hdf5", W[:4, :4], q[:4], mu, spacedim=2)
        fclib_files.write(folder / "deep/tied.hdf5", W, q, mu, V=np.eye(6)[:, :1], R=[[-1.]], s=[0.])
        (folder / "text.hdf5").write_text("not HDF5")
        text = self.peers("--only", "problems", "--families", "fclib", "--problems", folder)
        self.assertEqual({(row["problem"], row["family"]) for row in self.answers()}, {("good", "fclib")})
        self.assertEqual([row["verdict"] for row in self.answers()], ["solved"] * len(OURS))
        for name, reason in (("deep/plane", ".*2 dimensions"), ("deep/tied", "equality constraints"), ("text", "is not an HDF5 file")):
            self.assertRegex(text, rf"{name}.hdf5 is not raced: {reason}")

    def test_scenes_alone(self):
        text = self.peers("--only", "scenes")
        for package in ("python3-getfem", "calculix-ccx"):
            self.assertIn(f"(Debian's {package}): the scenes go without it", text)
        self.assertRegex(text, r"\| sheared block: orthocone \| solved \| .* \| 1 \|")

    def test_wrong_options(self):
        for options, reason in ((["--families", "others"], "others: allowed are paper"), (["--docs"], "belongs in --docs"),
                                (["--problems", self.folder / "none"], "there is no such folder")):
            text = io.StringIO()
            with contextlib.redirect_stderr(text), self.assertRaises(SystemExit), mock.patch.object(sys, "argv", ["peers", "--quick", *map(str, options)]):
                peers.parsed_options()
            self.assertIn(reason, text.getvalue())


if __name__ == "__main__":
    main()
