# SPDX-License-Identifier: GPL-3.0-or-later
"""The package foldless as a user of numpy has it. Run with the folder of the package on PYTHONPATH."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import foldless

ASSETS = pathlib.Path(__file__).resolve().parents[3] / "assets"


def square(n):
    """V, F of n × n cells of the unit square."""
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))
    V = np.column_stack([x.ravel(), y.ravel()])
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    F = np.vstack([np.column_stack([a, a + 1, a + n + 2]), np.column_stack([a, a + n + 2, a + n + 1])])
    return V, F


def swapped(n):
    """V, F, handles, targets: two points of a square change places."""
    V, F = square(n)
    row = n // 2 * (n + 1)
    return V, F, [row + n // 4, row + 3 * n // 4, 0, n], [[0.8, 0.5], [0.2, 0.5], [0, 0], [1, 0]]


def permuted(n, k):
    """The same: k points of a square take the places of each other, which keeps a solve busy."""
    V, F = square(n)
    random = np.random.default_rng(1)
    handles = random.choice(len(V), k, replace=False)
    return V, F, handles, V[random.permutation(handles)]


class Solve(unittest.TestCase):
    def test_arrives_without_a_fold(self):
        V, F, handles, targets = swapped(12)
        r = foldless.solve(V, F, handles, targets)
        self.assertTrue(r.reached)
        self.assertEqual(r.outcome, "gradient")
        np.testing.assert_allclose(r.U[r.parents.outputs[handles]], targets, atol=1e-5)
        self.assertTrue(foldless.check(r.V, r.F, r.U)["injective"])
        self.assertGreater(r.log[-1].flips, 0)

    def test_keeps_the_triangles_on_request(self):
        V, F, handles, targets = swapped(12)
        r = foldless.solve(V, F, handles, targets, fixed_triangulation=True)
        np.testing.assert_array_equal(r.F, F)
        self.assertFalse(r.reached)

    def test_knows_every_energy_by_its_name(self):
        V, F, handles, targets = swapped(4)
        for energy in foldless.energies():
            r = foldless.solve(V, F, handles, targets, energy=energy, time_limit=5)
            self.assertTrue(foldless.check(r.V, r.F, r.U)["injective"], energy)

    def test_stops_at_its_time_limit(self):
        r = foldless.solve(*permuted(60, 40), time_limit=0.05)
        self.assertEqual(r.outcome, "time-limit")

    def test_gives_views_that_outlive_their_result(self):
        r = foldless.solve(*swapped(4))
        U = r.U
        self.assertFalse(U.flags.owndata)
        self.assertFalse(U.flags.writeable)
        before = U.copy()
        del r
        np.testing.assert_array_equal(U, before)

    def test_takes_lists_and_arrays_of_any_layout(self):
        V, F, handles, targets = swapped(6)
        r = foldless.solve(V, F, handles, targets)
        s = foldless.solve(np.asfortranarray(V), F[:, :].astype(np.int16).tolist(),
                           np.array(handles), np.array(targets, dtype=np.float32).astype(float))
        self.assertEqual(s.F.shape, r.F.shape)


class Map(unittest.TestCase):
    def test_agrees_with_the_mesh(self):
        for n in (3, 12):
            V, F, handles, targets = swapped(n)
            r = foldless.solve(V, F, handles, targets)
            most = 1e-12 * np.linalg.norm(np.ptp(V, axis=0))
            self.assertLess(abs(r.map(V) - r.U[r.parents.outputs]).max(), most)
            self.assertLess(abs(r.map(r.V) - r.U).max(), most)
            by_triangle = r.map(r.parents.triangles, r.parents.coordinates)
            np.testing.assert_allclose(by_triangle, r.U, atol=1e-9)

    def test_parents_put_vertices_where_they_are_at_rest(self):
        V, F, handles, targets = swapped(3)
        r = foldless.solve(V, F, handles, targets)
        self.assertGreater(len(r.V), len(V))
        places = np.einsum("pk,pki->pi", r.parents.coordinates, V[F[r.parents.triangles]])
        np.testing.assert_allclose(places, r.V, atol=1e-12)

    def test_refuses_points_outside(self):
        r = foldless.solve(*swapped(4))
        with self.assertRaisesRegex(foldless.Error, "point 0 at .* lies outside of the mesh"):
            r.map([[2, 2]])


class Session(unittest.TestCase):
    def test_goes_where_its_targets_are_written(self):
        V, F = square(6)
        s = foldless.Session(V, F, [0, 48], [[0, 0], [1, 1]])
        np.testing.assert_array_equal(s.U, V)
        s.targets[1] = 1.4, 1.2
        self.assertFalse(s.reached)
        self.assertTrue(s.step())
        self.assertTrue(s.run())
        self.assertTrue(s.reached and s.ended)
        np.testing.assert_allclose(s.U[48], [1.4, 1.2], atol=1e-5)
        s.targets = [[0, 0], [1, 1]]
        s.run()
        np.testing.assert_allclose(s.U[48], [1, 1], atol=1e-5)

    def test_is_cancelled_from_another_thread(self):
        s = foldless.Session(*permuted(80, 40))
        timer = threading.Timer(0.2, s.cancel)
        timer.start()
        self.assertFalse(s.run())
        timer.join()
        self.assertEqual(s.result.outcome, "cancelled")


class Threads(unittest.TestCase):
    def test_of_a_solve_give_the_same_bits_however_many(self):
        problem = swapped(34)
        self.assertGreater(len(problem[1]), 2000)
        alone, shared = (foldless.solve(*problem, threads=n) for n in (1, 3))
        self.assertTrue(alone.reached)
        for name in ("V", "F", "U"):
            self.assertEqual(getattr(alone, name).tobytes(), getattr(shared, name).tobytes())

    def test_of_a_session_are_helpers_that_go_with_it(self):
        def count():
            return len(os.listdir("/proc/self/task"))

        def comes_to(threads):  # one that has ended is listed a little longer
            return any(count() == threads or time.sleep(0.01) for _ in range(500))

        before = count()
        s = foldless.Session(*swapped(34), threads=3)
        s.step()
        self.assertTrue(comes_to(before + 2))
        del s
        self.assertTrue(comes_to(before))

    def test_of_python_go_on_during_a_solve(self):
        counts, done = [], threading.Event()

        def count():
            while not done.is_set():
                counts.append(time.process_time())
                time.sleep(0.002)

        counter = threading.Thread(target=count)
        counter.start()
        start = time.process_time()
        foldless.solve(*permuted(80, 40), time_limit=1)
        end = time.process_time()
        done.set()
        counter.join()
        during = [t for t in counts if start < t < end]
        self.assertGreater(len(during), 50)
        # The lock is given up at once, not only now and then; by the clock of this process, which
        # stands still while the machine does other things.
        self.assertLess(max(np.diff(during)), 0.5)


INTERRUPTED = """
import sys, time
sys.path.insert(0, sys.argv[1])
import foldless, foldless_test
problem = foldless_test.permuted(160, 40)
print("begins", flush=True)
try:
    foldless.solve(*problem)
except KeyboardInterrupt as stop:
    r = stop.result
    print(r.outcome, foldless.check(r.V, r.F, r.U)["injective"], len(r.log) > 0)
"""


def processor_seconds_of(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    if fields[0] == "Z":
        raise AssertionError("the process has ended by itself")
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Interruption(unittest.TestCase):
    # Of processor time, which other work on the machine leaves as it is.
    def words_when_interrupted_after(self, seconds):
        here = str(pathlib.Path(__file__).resolve().parent)
        process = subprocess.Popen([sys.executable, "-c", INTERRUPTED, here],
                                   stdout=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "begins\n")
        begin = processor_seconds_of(process)
        while processor_seconds_of(process) < begin + seconds:
            time.sleep(0.01)
        end = processor_seconds_of(process)
        os.kill(process.pid, signal.SIGINT)
        words = process.stdout.read()
        process.stdout.close()
        _, _, usage = os.wait4(process.pid, 0)
        process.returncode = 0
        self.assertLess(usage.ru_utime + usage.ru_stime - end, 1)
        return words

    def test_ends_a_solve_within_a_second_with_a_valid_mesh(self):
        # The first of four quarters has no step yet: how long it takes is the machine's affair.
        for seconds in (0.7, 1.4, 2.8, 5.6):
            words = self.words_when_interrupted_after(seconds)
            if words != "cancelled True False\n":
                break
        self.assertEqual(words, "cancelled True True\n")


class BadInput(unittest.TestCase):
    def test_gets_one_sentence(self):
        V, F, handles, targets = swapped(4)
        for error, words, arguments in [
                (ValueError, r"V has the shape \(25, 3\); it must be \(n, 2\)",
                 (np.zeros((25, 3)), F, handles, targets)),
                (TypeError, "F is of the type float64; give integers",
                 (V, F.astype(float), handles, targets)),
                (ValueError, r"F has the shape \(32, 2\); it must be \(n, 3\)",
                 (V, F[:, :2], handles, targets)),
                (TypeError, "V is of the type .*; give real numbers",
                 (V.astype(complex), F, handles, targets)),
                (TypeError, "V is of the type .*; give real numbers", (None, F, handles, targets)),
                (ValueError, "F contains -1; indices count from 0", (V, F - 1, handles, targets)),
                (ValueError, r"handles has the shape \(1, 4\); it must be \(n,\)",
                 (V, F, [handles], targets)),
                (foldless.Error, "there are 3 rows of targets for 4 handles; give one for each",
                 (V, F, handles, targets[:3])),
                (foldless.Error, "row 0 of targets is not finite; every coordinate must be a number",
                 (V, F, handles, [[np.nan, 0]] + targets[1:])),
                (foldless.Error, "handle 0 is at the vertex 99, but the vertices are 0 to 24",
                 (V, F, [99] + handles[1:], targets)),
        ]:
            with self.assertRaisesRegex(error, f"^{words}$"):
                foldless.solve(*arguments)
        with self.assertRaisesRegex(foldless.Error, "there is no energy 'no'; choose one of"):
            foldless.solve(V, F, handles, targets, energy="no")
        with self.assertRaisesRegex(foldless.Error, "^the number of threads has to be 1 or more$"):
            foldless.solve(V, F, handles, targets, threads=0)

    def test_for_pictures_gets_one_sentence(self):
        with self.assertRaisesRegex(foldless.Error, "nowhere.png"):
            foldless.mesh_image("nowhere.png")
        with self.assertRaisesRegex(foldless.Error, "end the name with .png, .svg or .pdf"):
            foldless.render(foldless.solve(*swapped(4)), "a.bmp")


class Pictures(unittest.TestCase):
    def test_are_meshed_and_drawn(self):
        image = next(iter(sorted((ASSETS / "images").glob("*.png"))))
        V, F = foldless.mesh_image(image, detail="coarse")
        self.assertEqual((V.shape[1], F.shape[1]), (2, 3))
        self.assertTrue(foldless.check(V, F, V)["injective"])
        left, right = V[:, 0].argmin(), V[:, 0].argmax()
        r = foldless.solve(V, F, [left, right], V[[left, right]] + [[0, 0], [40, 20]])
        with tempfile.TemporaryDirectory() as folder:
            for name, magic in [("a.png", b"\x89PNG"), ("a.svg", b"<?xml"), ("a.pdf", b"%PDF")]:
                file = pathlib.Path(folder) / name
                foldless.render(r, file, width=300, height=200, texture=image)
                self.assertTrue(file.read_bytes().startswith(magic))


class Words(unittest.TestCase):
    def test_of_the_documentation_run_as_pasted(self):
        page = (ASSETS.parent / "docs" / "python.md").read_text()
        first, *_, interrupted = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        session = next(block for block in re.findall(r"```python\n(.*?)```", page, re.DOTALL)
                       if "Session(" in block)
        with tempfile.TemporaryDirectory() as folder:
            program = first + session + "handles, targets = [0], [[1, 1]]\n" + interrupted
            run = subprocess.run([sys.executable, "-c", program], cwd=folder, text=True,
                                 capture_output=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("True", run.stdout)
            self.assertTrue((pathlib.Path(folder) / "deformed.png").exists())

    def test_of_the_stubs_name_all_that_there_is(self):
        stub = pathlib.Path(foldless.__file__).with_name("__init__.pyi").read_text()
        for name in foldless.__all__:
            self.assertRegex(stub, rf"(?m)^(class|def) {name}\b")
            for member in vars(getattr(foldless, name, object)) if name in (
                    "Iteration", "Parents", "Result", "Session") else []:
                if not member.startswith("_"):
                    self.assertRegex(stub, rf"(?m)^    def {member}\b")
        self.assertRegex(foldless.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
