"""The module as `cmake --install` puts it somewhere else works by itself."""

import os
import pathlib
import subprocess
import sys
import unittest

from support import SCRATCH, main

JOB = """
import pathlib, numpy, isostack
ball = isostack.Volume(30 - numpy.linalg.norm(numpy.mgrid[-8:9, -8:9, -8:9] * 5.0, axis=0))
mesh = isostack.distance_surface(ball)
print(pathlib.Path(isostack.__file__).parent)
print(isostack.__version__, isostack.measure(mesh).watertight, "_repr_html_" in dir(mesh))
try:
    isostack.read("nowhere")
except isostack.InputError as error:
    print(error.where)
"""


class Install(unittest.TestCase):
    def test_from_a_prefix_of_its_own(self):
        prefix = SCRATCH / "prefix"
        cmake, build = os.environ["ISOSTACK_CMAKE"], os.environ["ISOSTACK_BUILD"]
        subprocess.run([cmake, "--install", build, "--component", "python", "--prefix", prefix], check=True,
                       capture_output=True)
        packages = list(prefix.rglob("dist-packages/isostack"))
        self.assertEqual(packages, [prefix / "lib/python3/dist-packages/isostack"])
        files = {path.name for path in packages[0].iterdir()}
        self.assertTrue({"__init__.py", "vtk.py", "_core.pyi", "py.typed"} <= files, files)
        outside = {"PATH": os.environ["PATH"], "PYTHONPATH": str(packages[0].parent)}
        done = subprocess.run([sys.executable, "-c", JOB], cwd="/", env=outside, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        where, told, error = done.stdout.splitlines()
        self.assertEqual(pathlib.Path(where), packages[0])
        self.assertRegex(told, r"^\d+\.\d+\.\d+ True True$")
        self.assertEqual(error, "nowhere")


if __name__ == "__main__":
    main()
