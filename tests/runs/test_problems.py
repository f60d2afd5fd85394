# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""orthocone-solve: problems that FCLIB's library writes are solved, and those written are what it says of them.

Usage: test_problems.py PROGRAM [unittest options]"""
import os
import pathlib
import subprocess
import sys
import unittest

import numpy as np
from problem_program import DONE, FILE_ERROR, SOLVE, UNSOLVED, WRONG_INPUT, ProblemCase, fclib_files, rigid_block, row_of_nodes


class ProblemTest(ProblemCase):
    def test_every_kind_of_matrix(self):
        """The forces are the same, and FCLIB has nothing to say against them."""
        W, q = row_of_nodes(6)
        forces = []
        for kind, room in (("columns", 0), ("rows", 0), ("triplets", 0), ("columns", 5), ("rows", 5)):
            name = f"{kind}-{room}"
            fclib_files.write(self.folder / name, W, q, np.linspace(0.1, 0.6, 6), kind, room=room)
            row = self.row(name, "--write", self.folder / f"{name}.solved")
            self.assertLess(float(row["residual"]), 1e-10)
            read = fclib_files.Read(self.folder / f"{name}.solved")
            self.assertLess(read.error, 1e-9)
            np.testing.assert_allclose(read.W, W, atol=1e-15)
            np.testing.assert_array_equal(read.mu, np.linspace(0.1, 0.6, 6))
            np.testing.assert_allclose(read.u, q + W @ read.r, atol=1e-12)
            forces.append(read.r)
        for others in forces[1:]:
            np.testing.assert_array_equal(forces[0], others)

    def test_methods_agree(self):
        W, q = row_of_nodes(6)
        fclib_files.write(self.folder / "problem", W, q, np.full(6, 0.3))
        forces = {}
        for method in ("newton", "gauss-seidel", "uzawa"):
            self.row("problem", "--method", method, "--write", self.folder / method)
            forces[method] = fclib_files.Read(self.folder / method).r
        for method, force in forces.items():
            np.testing.assert_allclose(force, forces["newton"], atol=1e-8 * np.abs(force).max(), err_msg=method)

    def test_scaled_form_of_other_laws(self):
        """What FCLIB reads is W' = D C W D with mu = 1, and its measure judges the law that it does not know."""
        W, q = row_of_nodes(6)
        fclib_files.write(self.folder / "problem", W, q, np.full(6, 0.3))
        for friction, slip in (("0.3,0.15", "0.3,0.15"), ("0.3,0.15", "0.05,0.2"), ("0.3,0.3", "0.1,0.2")):
            with self.subTest(friction=friction, slip=slip):
                self.row("problem", "--friction", friction, "--slip", slip, "--write", self.folder / "written")
                mu, p = (np.array(list(map(float, pair.split(",")))) for pair in (friction, slip))
                D = np.tile([1, *mu], 6)
                C = np.tile([1, *(p / mu / (p / mu).max())**2], 6)
                read = fclib_files.Read(self.folder / "written")
                np.testing.assert_array_equal(read.mu, np.ones(6))
                np.testing.assert_allclose(read.W, (D * C)[:, None] * W * D, rtol=1e-13)
                np.testing.assert_allclose(read.q, D * C * q, rtol=1e-13)
                np.testing.assert_allclose(read.u, read.q + read.W @ read.r, atol=1e-12)
                self.assertLess(read.error, 1e-9)
                self.row("written", "--write", self.folder / "again")
                again = fclib_files.Read(self.folder / "again")
                np.testing.assert_allclose(again.r, read.r, atol=1e-9 * np.abs(read.r).max())
                np.testing.assert_allclose(again.W, read.W, rtol=1e-13, atol=1e-16)

    def test_without_friction(self):
        W, q = row_of_nodes(4)
        fclib_files.write(self.folder / "problem", W, q, np.zeros(4))
        self.row("problem", "--write", self.folder / "written")
        read = fclib_files.Read(self.folder / "written")
        self.assertEqual(np.abs(read.r.reshape(-1, 3)[:, 1:]).max(), 0)

    def test_rigid_body(self):
        """Forces of more contacts than degrees of freedom are not unique; that they obey the law is."""
        W, q = rigid_block(4)
        self.assertEqual(np.linalg.matrix_rank(W), 6)
        fclib_files.write(self.folder / "problem", W, q, np.full(16, 0.4))
        row = self.row("problem", "--write", self.folder / "written")
        self.assertLess(float(row["fclib_error"]), 1e-8)

    def test_rounded_matrix(self):
        """Rounding of single precision is borne and named, in the text and in the table."""
        W, q = rigid_block(3)
        tilted = W + 5e-5 * np.random.default_rng(1).uniform(-1, 1, W.shape)
        fclib_files.write(self.folder / "tilted", tilted, q, np.full(9, 0.4))
        fclib_files.write(self.folder / "symmetric", W, q, np.full(9, 0.4))
        asymmetry = float(self.row("tilted", "--write", self.folder / "written")["w_asymmetry"])
        self.assertGreater(asymmetry, 1e-6)
        self.assertLess(asymmetry, 1e-4)
        self.assertEqual(float(self.row("symmetric")["w_asymmetry"]), 0)
        read = fclib_files.Read(self.folder / "written")
        np.testing.assert_allclose(read.W, (tilted + tilted.T) / 2, rtol=1e-15)
        self.assertLess(read.error, 1e-8)
        self.assertRegex(self.solve("tilted").stdout, r"\nW is not symmetric: .* symmetric part is taken\.\n")
        self.assertNotIn("symmetric", self.solve("symmetric").stdout)

    def test_rigid_body_between_walls(self):
        """They are too close for it. Forces that grow without bound are no solution."""
        H = np.zeros((6, 3))
        H[[0, 1, 2, 4, 5], [2, 0, 1, 0, 1]] = 1
        H[3, 2] = -1
        fclib_files.write(self.folder / "problem", H @ H.T, H @ [0.1, 0, 0] + np.tile([-1., 0, 0], 2), np.full(2, 0.3))
        for method in ("newton", "gauss-seidel", "uzawa"):
            self.assertEqual(self.solve("problem", "--method", method).returncode, UNSOLVED, method)

    def test_constraints(self):
        """With R they are eliminated, without they are a face that moves until the forces balance."""
        W, q = row_of_nodes(4)
        V = np.tile([[1.], [0], [0]], (4, 1))
        s = np.array([-3.])
        fclib_files.write(self.folder / "face", W, q, np.full(4, 0.3), V=V, R=np.zeros((1, 1)), s=s)
        row = self.row("face", "--write", self.folder / "written")
        self.assertEqual(row["constraints"], "1")
        read = fclib_files.Read(self.folder / "written")
        self.assertAlmostEqual(read.r[0::3].sum(), 3, delta=1e-8)
        fclib_files.write(self.folder / "soft", W, q, np.full(4, 0.3), V=V, R=[[-2.]], s=s)
        row = self.row("soft", "--write", self.folder / "eliminated")
        self.assertEqual(row["constraints"], "0")
        r = fclib_files.Read(self.folder / "eliminated").r
        multiplier = (V.T @ r + s) / 2
        u = W @ r + V @ multiplier + q
        self.assertLess(np.abs(np.minimum(u[0::3], r[0::3])).max(), 1e-8)

    def test_stored_solutions_are_judged_by_their_forces(self):
        """Velocities and multipliers that do not belong to them are named."""
        W, q = row_of_nodes(4)
        V, R, s = np.tile([[1.], [0], [0]], (4, 1)), np.array([[-2.]]), np.array([-3.])
        for has_constraint in (False, True):
            constraint = {"V": V, "R": R, "s": s} if has_constraint else {}
            fclib_files.write(self.folder / f"problem-{has_constraint}", W, q, np.full(4, 0.3), **constraint)
            self.row(f"problem-{has_constraint}", "--write", self.folder / f"solved-{has_constraint}", "--tolerance=1e-13")
            r = fclib_files.Read(self.folder / f"solved-{has_constraint}").r
            multipliers = (V.T @ r + s) / 2 if has_constraint else None
            u = W @ r + q + (V @ multipliers if has_constraint else 0)
            moved = u + np.eye(12)[4] * 0.1
            size = np.abs(W) @ np.abs(r) + np.abs(q)
            u_size = (size + (np.abs(V @ multipliers) if has_constraint else 0)).max()
            cases = [("right", u, r, multipliers, DONE, 0, 0), ("other u", moved, r, multipliers, DONE, 0.1 / u_size, 0),
                     ("other r", W @ (1.1 * r) + u - W @ r, 1.1 * r, multipliers, UNSOLVED, 0, None)]
            if has_constraint:
                cases += [("other l", u, r, multipliers + 1, DONE, 1 / (size + abs(V @ (multipliers + 1))).max(),
                           2 / (abs(V).T @ abs(r) + 2 * abs(multipliers + 1) + 3)[0]), ("no l", u, r, None, DONE, 0, 0)]
            for name, its_u, its_r, its_l, code, u_error, l_error in cases:
                name = f"{name}-{has_constraint}"
                with self.subTest(name):
                    fclib_files.write(self.folder / name, W, q, np.full(4, 0.3), **constraint)
                    fclib_files.write_solution(self.folder / name, its_u, its_r, its_l)
                    row = self.row(name, "--stored", code=code)
                    self.assertEqual(row["verdict"], "converged" if code == DONE else "unsolved")
                    self.assertAlmostEqual(float(row["stored_u_error"]), u_error, delta=1e-12 + 0.01 * u_error)
                    if l_error is not None:
                        self.assertAlmostEqual(float(row["stored_l_error"]), l_error, delta=1e-12 + 0.01 * l_error)
                    said = self.solve(name, "--stored").stdout
                    self.assertEqual("solution/u) are not W r + q" in said, u_error > 0, said)
                    self.assertEqual("solution/l) do not" in said, float(row["stored_l_error"]) > 1e-9, said)

    def test_directions_in_which_nodes_cannot_move(self):
        """A plate of mass 1 on rails along x, and a fifth node that cannot move at all: no force acts across the rails, and
        the others are those of a block in the plane, m v_n = sum r_n and friction mu r_n against its motion."""
        H = np.zeros((15, 2))
        H[0:12:3, 0], H[1:12:3, 1] = 1, 1
        q = H @ [-1, 0.7]
        q[12] = 0.5
        fclib_files.write(self.folder / "rails", H @ H.T, q, np.full(5, 0.3))
        for method in ("newton", "gauss-seidel", "uzawa"):
            self.row("rails", "--method", method, "--write", self.folder / method)
            r = fclib_files.Read(self.folder / method).r
            np.testing.assert_allclose([r[0::3].sum(), r[1::3].sum(), *r[2::3], *r[12:]], [1, -0.3] + 8 * [0], atol=1e-8)
            self.row(method, "--stored", "--tolerance=1e-9")
        q[5] = 0.1
        fclib_files.write(self.folder / "pulled", H @ H.T, q, np.full(5, 0.3))
        self.assert_error(self.solve("pulled"), FILE_ERROR, "W is zero along y of node 1, .* but slips by 0.1")

    def test_not_converged(self):
        W, q = row_of_nodes(6)
        fclib_files.write(self.folder / "problem", W, q, np.full(6, 0.3))
        self.assertEqual(self.row("problem", "--method=uzawa", "--iterations=3", code=UNSOLVED)["verdict"], "slow")

    def test_bad_files(self):
        W, q = row_of_nodes(4)
        mu = np.full(4, 0.3)
        fclib_files.write(self.folder / "good", W, q, mu)
        whole = (self.folder / "good").read_bytes()
        tilted = W.copy()
        tilted[0, 5] *= 1.1
        self.row("good", "--friction=0.3,0.3", "--write", self.folder / "double")
        third, half = (np.array([value]).tobytes() for value in (0.3, 0.5))
        (self.folder / "double").write_bytes((self.folder / "double").read_bytes().replace(third, half, 4))
        (self.folder / "text").write_text("not HDF5")
        (self.folder / "cut").write_bytes(whole[:len(whole) // 2])
        (self.folder / "foreign").write_bytes(whole.replace(b"fclib_local", b"other_local"))
        (self.folder / "nameless").write_bytes(whole.replace(b"vectors", b"vektors"))
        fclib_files.write(self.folder / "plane", W[:8, :8], q[:8], mu, spacedim=2)
        fclib_files.write(self.folder / "tilted", tilted, q, mu)
        fclib_files.write(self.folder / "negative", W, q, -mu)
        fclib_files.write(self.folder / "hollow", W * np.kron(np.eye(4), np.zeros((3, 3))), q, mu)
        fclib_files.write(self.folder / "indefinite", W - 0.5 * np.ones((12, 12)), q, mu)
        fclib_files.write(self.folder / "nan", W, q * np.nan, mu)
        fclib_files.write(self.folder / "singular", W, q, mu, V=np.ones((12, 2)), R=np.ones((2, 2)), s=np.ones(2))
        fclib_files.write(self.folder / "twice", W, q, mu, V=np.ones((12, 2)), R=np.zeros((2, 2)), s=np.ones(2))
        for name, expression in (("none", r"cannot be read \(No such file"), ("text", "is not an HDF5 file"),
                                 ("cut", "truncated or damaged"), ("foreign", "there is no problem of FCLIB"),
                                 ("nameless", "there is no array"), ("plane", "2 dimensions; allowed are 3"),
                                 ("tilted", r"W is not symmetric: .* give \(W \+ W\^T\)/2"), ("negative", "friction of node 0 is"),
                                 ("hollow", "on its diagonal; allowed"),
                                 ("indefinite", "W is indefinite: there are forces"), ("nan", "q has entries that are no numbers"),
                                 ("singular", "R is singular"), ("double", "the laws of the group orthocone make it"),
                                 ("twice", "not independent of each other"), ("good", "there is no solution in it")):
            with self.subTest(name):
                self.assert_error(self.solve(name, *["--stored"] * (name == "good")), FILE_ERROR, expression)

    def test_special_files(self):
        """A pipe nobody writes into, devices, folders and names that a terminal would obey."""
        W, q = row_of_nodes(2)
        fclib_files.write(self.folder / "good", W, q, np.full(2, 0.3))
        os.mkfifo(self.folder / "pipe")
        for name in ("pipe", "/dev/zero", "."):
            self.assert_error(self.solve(name), FILE_ERROR, "is no ordinary file")
        for name, expression in (("/dev/full", "it is no ordinary file"), (self.folder / "pipe", "it is no ordinary file"),
                                 (".", "it is a folder"), (self.folder, "it is a folder")):
            self.assert_error(self.solve("good", "--write", name), FILE_ERROR, expression)
        self.assertTrue(pathlib.Path("/dev/full").is_char_device() and (self.folder / "pipe").is_fifo())
        (self.folder / "precious").write_text("precious")
        (self.folder / "new.part").symlink_to(self.folder / "precious")
        self.row("good", "--write", self.folder / "new")
        self.assertEqual((self.folder / "precious").read_text(), "precious")
        self.assertFalse((self.folder / "new").is_symlink())
        result = self.solve("a\x1b[31mred\n" + "x" * 5000)
        self.assert_error(result, FILE_ERROR, "cannot be read")
        self.assertLess(len(result.stderr), 400)
        self.assertIn(r"a\x1b[31mred\n.hdf5", self.solve("a\x1b[31mred\n.hdf5").stderr)
        self.assertLess(len(self.solve("good", "--method=" + "x" * 5000).stderr), 400)

    def test_sizes_that_the_file_does_not_have(self):
        """One flipped byte makes a number of 3 GB, or 2^33 numbers, of an array of one: no memory is asked for."""
        W, q = row_of_nodes(2)
        fclib_files.write(self.folder / "good", W, q, np.full(2, 0.3))
        whole = (self.folder / "good").read_bytes()
        one_value = 2 * (1).to_bytes(8, "little")  # in a file by HDF5: size and largest size; the type is behind them
        place, said = whole.find(one_value), ""
        while place >= 0:
            for behind in (4, 31):
                bad = bytearray(whole)
                bad[place + behind] = 185
                (self.folder / "bad").write_bytes(bad)
                result = self.solve("bad")
                self.assertIn(result.returncode, (DONE, FILE_ERROR), result.stderr)  # some bytes say nothing
                said += result.stderr
            place = whole.find(one_value, place + 1)
        self.assertIn("which the file does not have", said)
        self.assertNotIn("cannot be read", said)  # HDF5 was not asked for it

    def test_bytes_at_random(self):
        """Whatever is damaged: an answer or one line, never a crash."""
        W, q = row_of_nodes(2)
        fclib_files.write(self.folder / "good", W, q, np.full(2, 0.3))
        whole = (self.folder / "good").read_bytes()
        random = np.random.default_rng(1)
        for _ in range(60):
            bad = bytearray(whole)
            for place in random.integers(0, len(bad), 8):
                bad[place] = random.integers(0, 256)
            (self.folder / "bad").write_bytes(bad)
            result = self.solve("bad")
            self.assertIn(result.returncode, (DONE, UNSOLVED, FILE_ERROR), result.stderr)
            self.assertLessEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_bad_command_lines(self):
        for options, expression in ((["--method=best"], "'best'"), (["--tolerance=2"], "allowed is 0 < number < 1"),
                                    (["--iterations", "0"], "allowed"), (["--speed=1"], "no option '--speed'"),
                                    (["--friction=0.3"], "two numbers > 0"), (["second"], "one file at a time"),
                                    (["--write"], "wants a value")):
            with self.subTest(options):
                self.assert_error(self.solve("none", *options), WRONG_INPUT, expression)

    def test_address_space(self):
        """Refused where BLAS would look for room for ever, and solved with more (the timeout is the test)."""
        W, q = row_of_nodes(6)
        fclib_files.write(self.folder / "problem", W, q, np.full(6, 0.3))
        for kilobytes, code in ((400000, WRONG_INPUT), (1100000, DONE)):
            command = f"ulimit -v {kilobytes}; exec '{SOLVE}' '{self.folder}/problem'"
            result = subprocess.run(["sh", "-c", command], text=True, capture_output=True, timeout=120, check=False)
            self.assertEqual(result.returncode, code, result.stderr)
            if code == WRONG_INPUT:
                self.assertRegex(result.stderr, r"\Aorthocone-solve: memory: 'ulimit -v' leaves \S+ GB .*allowed is .*\n\Z")

    def test_nowhere_to_write(self):
        W, q = row_of_nodes(2)
        fclib_files.write(self.folder / "good", W, q, np.full(2, 0.3))
        result = self.solve("good", "--write", self.folder / "none/file")
        self.assertEqual(result.returncode, FILE_ERROR, result.stderr)
        self.assertRegex(result.stderr, r"\Aorthocone-solve: .*none/file' cannot be written: .*\n\Z")


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
