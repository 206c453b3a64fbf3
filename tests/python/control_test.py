"""Progress, Ctrl-C, and other threads that go on while a solve runs."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import isostack
from support import main, phantom, sphere_images, sphere_mesh


def long_job(progress=None):
    """Some seconds: the phantom with all its constraints."""
    organ = isostack.segment(isostack.read_slices(phantom() / "series"), level=25)
    return isostack.reconstruct(organ, progress=progress)


class Progress(unittest.TestCase):
    def test_steps_and_fractions(self):
        seen = []
        isostack.reconstruct(isostack.segment(sphere_images(), level=50), progress=lambda *report: seen.append(report))
        self.assertTrue(seen)
        for step, fraction in seen:
            self.assertIsInstance(step, str)
            self.assertTrue(0 <= fraction <= 1, fraction)
        self.assertIn("surface", {step for step, _ in seen})

    def test_what_the_callback_raises_comes_out(self):
        class Enough(Exception):
            pass

        def stop(step, fraction):
            raise Enough(step)

        with self.assertRaises(Enough):
            isostack.reconstruct(isostack.segment(sphere_images(), level=50), progress=stop)

    def test_a_callback_may_cancel(self):
        def cancel(step, fraction):
            raise isostack.Cancelled("enough")

        with self.assertRaises(isostack.Cancelled):
            isostack.mesh_distance(sphere_mesh(), isostack.distance_grid(sphere_mesh(), 1, 5), progress=cancel)

    def test_what_is_no_callback(self):
        with self.assertRaisesRegex(TypeError, "progress takes a callable"):
            isostack.reconstruct(isostack.segment(sphere_images(), level=50), progress=3)


class Lock(unittest.TestCase):
    def test_another_thread_counts_on(self):
        counted = []
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted.append(time.monotonic())
                time.sleep(0.001)

        counter = threading.Thread(target=count)
        solves = []

        def note(step, fraction):
            solves.append(time.monotonic())

        counter.start()
        try:
            long_job(note)
        finally:
            stop.set()
            counter.join()
        during = [t for t in counted if solves[0] < t < solves[-1]]
        # A thread that could go on within reports only would count about one for each of them.
        self.assertGreater(len(during), 5 * len(solves))


INTERRUPTED = """
import sys, time
sys.path[:0] = {path!r}
import isostack
from control_test import long_job
began = []
def note(step, fraction):
    if not began:
        began.append(1)
        print("solving", flush=True)
try:
    long_job(note)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    print(len(isostack.segment(isostack.SliceStack([isostack.Slice([[0, 1], [0, 1]])]), level=0.5)))
"""


class Interrupt(unittest.TestCase):
    def test_ctrl_c_stops_a_solve(self):
        script = INTERRUPTED.format(path=sys.path)
        command = [sys.executable, "-W", "ignore", "-c", script]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as solver:
            self.assertEqual(solver.stdout.readline(), "solving\n")
            os.kill(solver.pid, signal.SIGINT)
            self.assertEqual(solver.stdout.read(), "interrupted\n1\n")  # and the module goes on to work
        self.assertEqual(solver.returncode, 0)

    def test_without_a_callback_too(self):
        timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
        organ = isostack.segment(isostack.read_slices(phantom() / "series"), level=25)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            isostack.reconstruct(organ)
            timer.join()


class Threads(unittest.TestCase):
    def test_the_number_of_threads_changes_nothing(self):
        organ = isostack.segment(sphere_images(), level=50)
        for solver in ("fast", "dense"):
            with isostack.ThreadLimit(1):
                alone = isostack.reconstruct(organ, solver=solver).surface.vertices_mm
            together = isostack.reconstruct(organ, solver=solver).surface.vertices_mm
            self.assertTrue((alone == together).all())


if __name__ == "__main__":
    main()
