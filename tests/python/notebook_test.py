"""What a notebook shows inline: self-contained, and with pixels of the surface in it."""

import re
import shutil
import subprocess
import unittest

import numpy as np

import isostack
from support import SCRATCH, main, sphere_images, sphere_mesh

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
except ImportError:
    vtk_to_numpy = None


def shown():
    mesh = sphere_mesh(20, (10, -5, 30), rings=48)
    mesh.color = (220, 60, 40)
    return isostack.Scene(surfaces=[mesh], contours=[isostack.segment(sphere_images(), level=50)], title="ball & <b>")


def red_share(page, budget_ms):
    """How much of a browser's picture of the page is red."""
    picture = SCRATCH / f"cell_{budget_ms}.png"
    subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--use-gl=angle",
                    "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                    f"--user-data-dir={SCRATCH / 'profile'}", "--window-size=900,520",
                    f"--virtual-time-budget={budget_ms}", f"--screenshot={picture}", page.as_uri()],
                   capture_output=True, timeout=120, check=False)
    if not picture.exists():
        return 0
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    red = (pixels[:, 0] > 120) & (pixels[:, 0] > pixels[:, 1] + 50) & (pixels[:, 0] > pixels[:, 2] + 50)
    return red.mean()


class Inline(unittest.TestCase):
    def test_values_show_themselves(self):
        organ = isostack.segment(sphere_images(), level=50)
        for value in (shown(), sphere_mesh(), organ, isostack.reconstruct(organ)):
            text = value._repr_html_()
            self.assertTrue(text.startswith("<iframe srcdoc="), type(value))
            self.assertEqual(text.count("</iframe>"), 1)
            self.assertIn('sandbox="allow-scripts"', text)

    def test_nothing_to_show_is_text(self):
        empty = isostack.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int))
        self.assertIn("&lt;TriangleMesh", empty._repr_html_())

    def test_nothing_is_asked_of_the_network(self):
        page = isostack.page_html(shown())
        self.assertEqual(re.findall(r'(?:src|href)\s*=\s*"https?:', page), [])
        self.assertIn("Content-Security-Policy", page)

    def test_the_same_page_as_a_file(self):
        isostack.save_page(shown(), SCRATCH / "ball.html")
        self.assertEqual((SCRATCH / "ball.html").read_text(), isostack.page_html(shown()))

    @unittest.skipIf(shutil.which("chromium") is None, "chromium is absent")
    @unittest.skipIf(vtk_to_numpy is None, "python3-vtk9, which reads the picture, is absent")
    def test_a_browser_draws_it(self):
        page = SCRATCH / "cell.html"
        page.write_text(f"<!doctype html><meta charset='utf-8'><body>{shown()._repr_html_()}</body>")
        # A busy machine may not have drawn the frame in time for the picture.
        shares = (red_share(page, budget_ms) for budget_ms in (8_000, 30_000, 60_000, 100_000))
        self.assertTrue(any(share > 0.05 for share in shares))  # the ball takes a good part of the frame


if __name__ == "__main__":
    main()
