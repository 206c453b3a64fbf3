"""Measures and comparisons against closed forms."""

import json
import unittest

import numpy as np

import isostack
from support import SCRATCH, main, run, sphere_images, sphere_mesh

BALL_MM3 = 4 / 3 * np.pi * 20**3


class Measures(unittest.TestCase):
    def test_of_a_ball(self):
        measures = isostack.measure(sphere_mesh(rings=64))
        self.assertAlmostEqual(measures.volume_mm3 / BALL_MM3, 1, delta=0.01)  # faces cut off 0.2 %
        self.assertAlmostEqual(measures.area_mm2 / (4 * np.pi * 20**2), 1, delta=0.01)
        self.assertEqual((measures.components, measures.genus, measures.watertight), (1, 0, True))
        curvature = isostack.mean_curvatures_per_mm(sphere_mesh(rings=64))
        self.assertAlmostEqual(np.median(curvature), 1 / 20, delta=0.001)

    def test_of_a_reconstruction(self):
        result = isostack.reconstruct(isostack.segment(sphere_images(), level=50))
        self.assertAlmostEqual(isostack.measure(result).volume_mm3 / BALL_MM3, 1, delta=0.02)  # 2 mm pixels
        self.assertLess(result.report.contour_residual.largest_mm, 0.5)
        self.assertEqual(result.report.sections.slices, 11)
        self.assertGreater(result.report.as_dict()["sections"]["dice"], 0.98)

    def test_of_contours_and_labels(self):
        square = isostack.ContourSlice([isostack.Contour([[0, 0], [10, 0], [10, 10], [0, 10]]),
                                        isostack.Contour([[2, 2], [2, 4], [4, 4], [4, 2]])])
        measures = isostack.measure(square)
        self.assertAlmostEqual(measures.area_mm2, 96)
        self.assertEqual((measures.components, measures.holes), (1, 1))
        cube = isostack.LabelVolume(np.ones((2, 2, 2), int), np.diag([2.0, 2, 2, 1]))
        self.assertAlmostEqual(isostack.measure(cube).volume_mm3, 64)

    def test_comparison_of_two_balls(self):
        found = isostack.compare(sphere_mesh(20, rings=48), sphere_mesh(19, rings=48))
        self.assertAlmostEqual(found.distance.mean_mm, 1, delta=0.05)
        self.assertAlmostEqual(found.dice, 2 * 19**3 / (19**3 + 20**3), delta=0.01)
        self.assertGreater(found.area_difference_mm2, 0)

    def test_comparison_says_what_the_command_says(self):
        a, b = SCRATCH / "a.ply", SCRATCH / "b.ply"
        isostack.write(sphere_mesh(20), a)
        isostack.write(sphere_mesh(18, (1, 2, 3)), b)

        told = json.loads(run("measure", a, "--against", b, "--json"))["comparison"]
        found = isostack.compare(isostack.read(a), isostack.read(b))
        self.assertEqual(told["dice"], found.dice)
        self.assertEqual(told["mean_distance_mm"], found.distance.mean_mm)
        self.assertEqual(told["volume_difference_mm3"], found.volume_difference_mm3)

    def test_against_labels(self):
        grid = isostack.distance_grid(sphere_mesh(), 1.0, 3.0)
        labels = isostack.LabelVolume(grid)
        isostack.voxelize(sphere_mesh(), labels)
        self.assertAlmostEqual(float(labels.voxels.sum()), BALL_MM3, delta=0.02 * BALL_MM3)
        found = isostack.compare(sphere_mesh(), labels)
        self.assertEqual(found.dice, 1)
        self.assertIsNone(found.area_difference_mm2)

    def test_agreement_at_inputs_and_left_out_slices(self):
        organ = isostack.segment(sphere_images(), level=50)
        agreement = isostack.agreement_at_inputs(isostack.reconstruct(organ).surface, organ)
        self.assertLess(agreement.largest_mm, 0.5)
        study = isostack.leave_out(organ, 2)
        self.assertEqual({m.method for m in study.methods}, {"isostack", "cubic", "linear"})
        self.assertLess(study.methods[0].agreement.mean_mm, 0.5)

    def test_memory_is_known_before(self):
        organ = isostack.segment(sphere_images(), level=50)
        prediction = isostack.predict_memory([organ])
        self.assertLessEqual(isostack.reconstruct(organ).report.constraints, prediction.organs[0].most_constraints)
        self.assertGreater(prediction.process_bytes, prediction.organs[0].solver_bytes)

    def test_contradictions_and_alignment(self):
        organ = isostack.segment(sphere_images(), level=50)
        self.assertEqual(isostack.find_contradictions(organ).disagreement_mm, 0)  # parallel slices
        self.assertEqual(len(isostack.align_slices(organ, max_shift_mm=5).motions), 11)


class Distances(unittest.TestCase):
    def test_there_and_back(self):
        mesh = sphere_mesh(rings=48)
        grid = isostack.distance_grid(mesh, 1.0, 5.0)
        distances = isostack.mesh_distance(mesh, grid)
        k, j, i = np.unravel_index(distances.voxels.argmax(), distances.voxels.shape)
        self.assertAlmostEqual(float(distances.voxels.max()), 20, delta=1)  # the centre's voxel is within one
        np.testing.assert_allclose((grid.index_to_world @ [i, j, k, 1])[:3], 0, atol=1)
        again = isostack.distance_surface(distances)
        self.assertLess(isostack.compare(mesh, again).distance.largest_mm, 0.2)
        isostack.write_distances(distances, SCRATCH / "ball.nrrd")
        self.assertTrue((isostack.read(SCRATCH / "ball.nrrd").voxels == distances.voxels).all())

    def test_an_open_mesh_is_warned_about_and_mended(self):
        mesh = sphere_mesh()
        hole = isostack.TriangleMesh(mesh.vertices_mm, mesh.triangles[4:], name="holed")
        with self.assertWarnsRegex(isostack.InputWarning, "."):
            isostack.mesh_distance(hole, isostack.distance_grid(hole, 2.0, 5.0))
        with self.assertWarns(isostack.InputWarning):
            mended = isostack.mended_mesh(hole)
        self.assertTrue(isostack.measure(mended).watertight)

    def test_sections_of_a_mesh(self):
        pose = isostack.SlicePose(origin_mm=[0, 0, 12])
        cut = isostack.plane_section(sphere_mesh(rings=96), pose)
        self.assertAlmostEqual(cut.area_mm2 / (np.pi * 16**2), 1, delta=0.01)  # 20² − 12² = 16²

    def test_retriangulation(self):
        fewer, report = isostack.retriangulate(sphere_mesh(rings=48), triangles=500)
        self.assertEqual(len(fewer.triangles), report.triangles_after)
        self.assertLessEqual(report.triangles_after, 500)


if __name__ == "__main__":
    main()
