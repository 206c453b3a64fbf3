"""What the tests of the Python module share. They are run by ctest, with PYTHONPATH set to the module's folder."""

import atexit
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import numpy as np

import isostack

BIN = pathlib.Path(os.environ["ISOSTACK_BIN"])
SHARED = pathlib.Path(__file__).resolve().parents[3] / "shared" / "data"

SCRATCH = pathlib.Path(tempfile.mkdtemp(prefix="isostack_python_"))
atexit.register(shutil.rmtree, SCRATCH, ignore_errors=True)


def main():
    """Without warnings: the phantom's gaps are uneven on purpose."""
    unittest.main(warnings="ignore", verbosity=2)


def needs(*names):
    """Skips a test where one of these folders of shared data is absent."""
    missing = [name for name in names if not (SHARED / name).exists()]
    return unittest.skipIf(missing, f"shared data is absent: {', '.join(missing)}")


def run(*arguments):
    """The command's standard output."""
    done = subprocess.run([BIN / "isostack", *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return done.stdout


def phantom():
    """The folder of the generated phantom."""
    folder = SCRATCH / "sample"
    if not folder.exists():
        subprocess.run([BIN / "isostack_make_phantom", folder], check=True, capture_output=True)
    return folder


def sphere_images(radius_mm=20.0, spacing_mm=2.0, gap_mm=5.0, slices=11):
    """A ball of 100 on 0, edges one pixel wide, round (10, −5, 30) mm; slices across z."""
    stack = []
    centre = np.array([10.0, -5.0, 30.0])
    for number in range(slices):
        z = centre[2] + (number - slices // 2) * gap_mm
        pose = isostack.SlicePose(origin_mm=[centre[0] - 32, centre[1] - 32, z], spacing_mm=[spacing_mm, spacing_mm])
        steps = np.arange(33) * spacing_mm - 32
        distance = radius_mm - np.sqrt(steps[None, :] ** 2 + steps[:, None] ** 2 + (z - centre[2]) ** 2)
        stack.append(isostack.Slice(np.clip(50 + 50 * distance / spacing_mm, 0, 100), pose, f"slice {number}"))
    return isostack.SliceStack(stack, "ball")


def sphere_mesh(radius_mm=20.0, centre_mm=(0, 0, 0), rings=24):
    """A closed mesh of a ball by latitude and longitude, outside out."""
    theta = np.linspace(0, np.pi, rings + 1)[1:-1]
    phi = np.arange(2 * rings) * np.pi / rings
    around = np.stack([np.outer(np.sin(theta), np.cos(phi)), np.outer(np.sin(theta), np.sin(phi)),
                       np.outer(np.cos(theta), np.ones_like(phi))], axis=-1).reshape(-1, 3)
    points = np.concatenate([around, [[0, 0, 1], [0, 0, -1]]]) * radius_mm + np.asarray(centre_mm)
    north, south, count = len(around), len(around) + 1, 2 * rings
    triangles = []
    for j in range(count):
        k = (j + 1) % count
        triangles += [[north, j, k], [south, len(around) - count + k, len(around) - count + j]]
        for i in range(rings - 2):
            a, b, c, d = i * count + j, i * count + k, (i + 1) * count + j, (i + 1) * count + k
            triangles += [[a, c, b], [b, c, d]]
    return isostack.TriangleMesh(points, triangles, name="ball")
