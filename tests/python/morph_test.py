"""Morphs by every method, of figures and of bodies."""

import subprocess
import unittest

import numpy as np

import isostack
from support import BIN, SCRATCH, main, run, sphere_mesh


def square(half_mm, name):
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half_mm + 20.0
    edges = [np.linspace(corners[i], corners[(i + 1) % 4], 20, endpoint=False) for i in range(4)]
    return isostack.ContourSlice([isostack.Contour(np.concatenate(edges))], size_pixels=[41, 41], name=name)


def disc(radius_mm, name):
    angles = np.linspace(0, 2 * np.pi, 80, endpoint=False)
    points = 20 + radius_mm * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return isostack.ContourSlice([isostack.Contour(points)], size_pixels=[41, 41], name=name)


METHODS = ["variational", "level-set", "blend", "subdivision", "signed-distance"]


class Figures(unittest.TestCase):
    def test_every_method_goes_from_the_one_to_the_other(self):
        first, last = square(6, "square"), disc(12, "disc")
        for method in METHODS:
            with self.subTest(method):
                steps = []
                morph = isostack.morph([first, last], method, progress=lambda step, fraction: steps.append(step))
                frames = morph.frames(5)
                areas = [frame.area_mm2 for frame in frames]
                self.assertAlmostEqual(areas[0] / 144, 1, delta=0.05)  # corners round off on 1 mm pixels
                self.assertAlmostEqual(areas[-1] / (np.pi * 144), 1, delta=0.05)
                if method == "blend":  # in which the first shape may go before the second comes
                    self.assertGreaterEqual(min(areas), 0.59 * 144)  # least_content, on 1 mm pixels
                else:
                    self.assertTrue(areas[0] < areas[2] < areas[4], areas)
                self.assertEqual(morph.report.method, method)

    def test_one_shape_by_t_and_by_weights(self):
        morph = isostack.morph([square(6, "square"), disc(12, "disc")])
        by_t, by_weights = morph.shape_at(0.25), morph.at([0.75, 0.25])
        np.testing.assert_allclose(by_t.contours[0].points_mm, by_weights.contours[0].points_mm)
        np.testing.assert_allclose(morph.weights_at(0.25), [0.75, 0.25])

    def test_mixtures_of_three(self):
        shapes = [square(6, "small"), disc(12, "disc"), square(10, "large")]
        morph = isostack.morph(shapes, layout="simplex")
        self.assertGreater(morph.at([1 / 3, 1 / 3, 1 / 3]).area_mm2, 144)
        corners = [np.array([1.0, 0, 0]), np.array([0, 0, 1.0])]
        path = isostack.weights_along_path(corners, 3)
        self.assertEqual(len(morph.frames(path)), 3)

    def test_the_surface_that_figures_sweep(self):
        morph = isostack.morph([disc(10, "first"), disc(10, "last")], "signed-distance")  # a cylinder
        frames = morph.frames(3)
        length_mm = morph.report.spacing_mm
        swept = morph.spacetime_surface(frames[0].pose)
        self.assertAlmostEqual(isostack.measure(swept).area_mm2 / (2 * np.pi * 10 * length_mm), 1, delta=0.01)
        np.testing.assert_allclose([swept.vertices_mm[:, 2].min(), swept.vertices_mm[:, 2].max()], [0, length_mm], atol=1e-9)
        stack = morph.spacetime_slices(frames, [morph.weights_at(t) for t in (0, 0.5, 1)])
        np.testing.assert_allclose([s.pose.origin_mm[2] for s in stack.slices], [0, length_mm / 2, length_mm])
        with self.assertRaises(isostack.InputError):
            morph.spacetime_slices(frames, [[1, 0]])
        self.assertIsNone(isostack.level_set_morph([disc(10, "first"), disc(6, "last")]).spacetime_surface(frames[0].pose))

    def test_landmarks(self):
        first, last = square(8, "square"), square(8, "turned")
        corners = [(12, 12, 0), (28, 12, 0), (28, 28, 0), (12, 28, 0)]
        landmarks = list(zip(corners, corners[1:] + corners[:1]))  # a quarter turn
        morph = isostack.morph([first, last], "signed-distance", landmarks=landmarks)
        # Halfway the corners are in the middles of the edges; without landmarks the square stays as it is.
        self.assertAlmostEqual(morph.shape_at(0.5).area_mm2, 128, delta=4)
        plain = isostack.morph([first, last], "signed-distance").shape_at(0.5)
        self.assertAlmostEqual(plain.area_mm2, 256, delta=4)
        self.assertEqual(len(isostack.morph([first, last], "level-set", landmarks=landmarks).frames(3)), 3)

    def test_courses_of_a_level_set_morph(self):
        found = isostack.run_level_set_morph([square(6, "square"), disc(12, "disc")])
        self.assertTrue(found.courses[0].arrived)
        self.assertEqual((found.courses[0].from_, found.courses[0].to), ("square", "disc"))
        self.assertEqual(found.unshared, [])

    def test_refusals(self):
        with self.assertRaisesRegex(ValueError, "none of variational"):
            isostack.morph([square(6, "a"), disc(12, "b")], "magic")
        with self.assertRaises(isostack.InputError):
            isostack.morph([square(6, "a")])
        with self.assertRaisesRegex(TypeError, "did you mean 'smoothing'"):
            isostack.morph([square(6, "a"), disc(12, "b")], smoothin=1)
        with self.assertRaises(isostack.InputError):
            isostack.morph([square(6, "a"), sphere_mesh()])

    def test_the_command_writes_the_same_frames(self):
        shapes = SCRATCH / "shapes"
        subprocess.run([BIN / "isostack_make_shapes", shapes], check=True, capture_output=True)
        run("morph", shapes / "seven.json", shapes / "two.json", "--frames", 4, "-o", SCRATCH / "frames.json")
        theirs = isostack.read_contours(SCRATCH / "frames.json")
        keys = [isostack.read_contours(shapes / f"{name}.json")[0][0] for name in ("seven", "two")]
        ours = isostack.morph(keys).frames(4)
        slices = [plane for organ in theirs for plane in organ]
        self.assertEqual(len(slices), 4)
        for a, b in zip(ours, slices):
            self.assertAlmostEqual(a.area_mm2, b.area_mm2, delta=1e-4)  # written with some digits


class Bodies(unittest.TestCase):
    def test_a_ball_grows(self):
        balls = [sphere_mesh(10, rings=12), sphere_mesh(14, rings=12)]
        for method in ("variational", "signed-distance", "level-set"):
            with self.subTest(method):
                half = isostack.morph(balls, method, resolution_mm=1).shape_at(0.5)
                self.assertIsInstance(half, isostack.TriangleMesh)
                radius = (isostack.measure(half).volume_mm3 * 3 / 4 / np.pi) ** (1 / 3)
                self.assertTrue(10 < radius < 14, radius)
                self.assertTrue(isostack.measure(half).watertight)
                quality = isostack.frame_quality(half)
                self.assertEqual((quality.components, quality.holes), (1, 0))


if __name__ == "__main__":
    main()
