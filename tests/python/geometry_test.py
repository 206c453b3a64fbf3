"""Arrays are views, composites are references, and what does not fit is refused."""

import copy
import gc
import inspect
import pickle
import unittest

import numpy as np

import isostack
from support import main, sphere_images, sphere_mesh


class Views(unittest.TestCase):
    def test_points_and_triangles_share_memory_with_the_mesh(self):
        mesh = sphere_mesh()
        points, triangles = mesh.vertices_mm, mesh.triangles
        self.assertEqual((points.dtype, triangles.dtype), (np.float64, np.int32))
        self.assertEqual(points.shape[1], 3)
        self.assertTrue(np.shares_memory(points, mesh.vertices_mm))
        self.assertTrue(np.shares_memory(triangles, mesh.triangles))
        before = isostack.measure(mesh).volume_mm3
        points *= 2  # written through
        self.assertAlmostEqual(isostack.measure(mesh).volume_mm3, 8 * before, delta=1e-9 * before)

    def test_a_view_keeps_its_owner_alive(self):
        points = sphere_mesh(radius_mm=3).vertices_mm
        gc.collect()
        for _ in range(50):
            sphere_mesh(radius_mm=7)  # would reuse the memory
        self.assertAlmostEqual(np.linalg.norm(points, axis=1).max(), 3)

    def test_views_of_parts_keep_the_whole_alive(self):
        pixels = sphere_images()[5].pixels
        gc.collect()
        self.assertEqual(pixels.shape, (33, 33))
        self.assertEqual(pixels.dtype, np.float32)
        self.assertEqual(pixels[16, 16], 100)

    def test_writing_pixels_changes_the_slice_of_the_stack(self):
        stack = sphere_images()
        stack[0].pixels[...] = 100  # the ball now reaches over the first slice
        self.assertEqual(isostack.segment(stack[:2], level=50)[0].contours[0].depth, 0)
        self.assertTrue(np.shares_memory(stack[3].pixels, stack.slices[3].pixels))
        self.assertTrue((stack.slices[0].pixels == 100).all())

    def test_contour_points_are_a_view(self):
        contour = isostack.Contour([[0, 0], [4, 0], [4, 3], [0, 3]])
        self.assertEqual((contour.signed_area_mm2, contour.perimeter_mm), (12, 14))
        contour.points_mm[:, 0] *= 2
        self.assertEqual(contour.signed_area_mm2, 24)
        stack = isostack.ContourStack([isostack.ContourSlice([contour])])
        stack[0].contours[0].points_mm[:, 1] *= 2
        self.assertEqual(stack[0].area_mm2, 48)

    def test_voxels_are_indexed_kji_and_are_a_view(self):
        to_world = np.diag([0.5, 1, 2, 1]).astype(float)
        volume = isostack.Volume(np.arange(24).reshape(2, 3, 4), to_world)
        self.assertEqual(list(volume.grid.size), [4, 3, 2])
        self.assertEqual(volume.voxels.dtype, np.float32)
        self.assertEqual(volume.voxels[1, 2, 3], 23)
        volume.voxels[1, 2, 3] = -1
        self.assertEqual(volume.voxels.min(), -1)
        self.assertTrue(np.shares_memory(volume.voxels, volume.voxels))
        self.assertEqual(isostack.slices_of(volume)[1].pixels[2, 3], -1)
        labels = isostack.LabelVolume(volume.grid, 7)
        self.assertEqual(labels.voxels.dtype, np.uint16)
        self.assertTrue((labels.voxels == 7).all())

    def test_layers_of_a_label_map_are_references(self):
        labels = isostack.LabelMap([isostack.LabelVolume(np.zeros((2, 2, 2), int))])
        labels.layers[0].voxels[0] = 3
        self.assertEqual([s.value for s in labels.all_segments], [3])

    def test_kept_points_of_a_reconstruction_lie_on_the_ball(self):
        result = isostack.reconstruct(isostack.segment(sphere_images(), level=50))
        distance = np.linalg.norm(result.kept_points_mm - [10, -5, 30], axis=1)
        self.assertLess(abs(distance - 20).max(), 0.2)  # a tenth of a pixel: linear between blurred pixels
        self.assertTrue(np.shares_memory(result.surface.vertices_mm, result.surface.vertices_mm))


class Refusals(unittest.TestCase):
    def test_shapes_and_kinds_of_arrays(self):
        triangle = [[0, 1, 2]]
        with self.assertRaisesRegex(isostack.InputError, r"vertices_mm: its shape is \(3, 2\); give an array of shape"):
            isostack.TriangleMesh(np.zeros((3, 2)), triangle)
        with self.assertRaisesRegex(TypeError, "triangles takes an array of whole numbers"):
            isostack.TriangleMesh(np.zeros((3, 3)), np.zeros((1, 3)))
        with self.assertRaisesRegex(TypeError, "vertices_mm takes an array of real numbers"):
            isostack.TriangleMesh(np.zeros((3, 3), complex), triangle)
        with self.assertRaisesRegex(isostack.InputError, "a corner is not among the 3 vertices"):
            isostack.TriangleMesh(np.zeros((3, 3)), [[0, 1, 3]])
        with self.assertRaisesRegex(isostack.InputError, "does not fit into int32"):
            isostack.TriangleMesh(np.zeros((3, 3)), [[0, 1, 2**40]])
        with self.assertRaisesRegex(isostack.InputError, "2 normals do not fit to 3 vertices"):
            isostack.TriangleMesh(np.zeros((3, 3)), triangle, np.zeros((2, 3)))
        with self.assertRaisesRegex(isostack.InputError, "voxels"):
            isostack.Volume(np.zeros((2, 2)))
        with self.assertRaisesRegex(isostack.InputError, "does not fit into uint16"):
            isostack.LabelVolume(np.full((1, 1, 1), -1))
        with self.assertRaises(TypeError):
            isostack.LabelVolume(np.zeros((1, 1, 1)))

    def test_an_array_keeps_its_size(self):
        mesh = sphere_mesh()
        view = mesh.vertices_mm
        mesh.vertices_mm = np.zeros_like(view)
        self.assertTrue((view == 0).all())
        with self.assertRaisesRegex(isostack.InputError, "keeps its shape"):
            mesh.vertices_mm = np.zeros((1, 3))

    def test_wrong_containers(self):
        with self.assertRaises(TypeError):
            isostack.SliceStack([1, 2])
        with self.assertRaises(IndexError):
            sphere_images()[99]
        with self.assertRaises(isostack.InputError):
            isostack.LabelMap([isostack.LabelVolume(np.zeros((1, 1, 1), int)),
                               isostack.LabelVolume(np.zeros((2, 1, 1), int))])


class Structs(unittest.TestCase):
    def test_an_unknown_keyword_is_a_type_error_with_a_hint(self):
        with self.assertRaisesRegex(TypeError, "no field 'smothing'; did you mean 'smoothing'"):
            isostack.ReconstructOptions(smothing=1)
        with self.assertRaisesRegex(TypeError, "smoothing takes float, not 'much'"):
            isostack.ReconstructOptions(smoothing="much")
        with self.assertRaisesRegex(ValueError, "caps: 'pointed' is none of round, flat, open"):
            isostack.ReconstructOptions(caps="pointed")
        with self.assertRaisesRegex(isostack.InputError, "kernel"):
            isostack.ReconstructOptions(kernel="cubic")
        with self.assertRaisesRegex(TypeError, "SegmentationOptions has no field 'levle'"):
            isostack.segment(sphere_images(), levle=50)

    def test_defaults_are_visible(self):
        parameters = inspect.signature(isostack.ReconstructOptions).parameters
        self.assertEqual(parameters["max_constraints"].default, 60_000)
        self.assertEqual(parameters["kernel"].default.name, "triharmonic")
        self.assertIn("mm", isostack.ReconstructOptions.__doc__)

    def test_nested_options_are_references_and_lists_are_tuples(self):
        options = isostack.ReconstructOptions()
        options.softening.strength = 0
        self.assertEqual(options.softening.strength, 0)
        rules = isostack.OrganRules(seeds=[(1, 2, 3, "liver"), isostack.Seed(name="-")], start=["grow:2"])
        self.assertEqual([seed.name for seed in rules.seeds], ["liver", "-"])
        self.assertIsInstance(rules.start, tuple)
        with self.assertRaisesRegex(isostack.InputError, "grwo"):
            isostack.OrganRules(start=["grwo:2"])

    def test_replace_copies(self):
        options = isostack.ReconstructOptions(caps="flat")
        other = options.replace(smoothing=2)
        self.assertEqual((options.smoothing, other.smoothing, other.caps.name), (0, 2, "flat"))
        other = copy.deepcopy(options)
        other.caps = "open"
        self.assertEqual(options.caps.name, "flat")

    def test_results_have_no_constructor_and_become_dicts(self):
        measures = isostack.measure(sphere_mesh())
        with self.assertRaises(TypeError):
            isostack.MeshMeasures()
        with self.assertRaises(AttributeError):
            measures.volume_mm3 = 1
        self.assertEqual(measures.as_dict()["components"], 1)

    def test_meshes_go_to_other_processes(self):
        mesh = sphere_mesh()
        mesh.color = (1, 2, 3)
        again = pickle.loads(pickle.dumps(mesh))
        np.testing.assert_array_equal(again.vertices_mm, mesh.vertices_mm)
        np.testing.assert_array_equal(again.triangles, mesh.triangles)
        self.assertEqual((again.name, again.color), (mesh.name, mesh.color))

    def test_colours_are_tuples(self):
        mesh = sphere_mesh()
        self.assertIsNone(mesh.color)
        mesh.color = (255, 128, 0)
        self.assertEqual(mesh.color, (255, 128, 0))
        with self.assertRaises(TypeError):
            mesh.color = (256, 0, 0)

    def test_frames_of_a_pose(self):
        pose = isostack.SlicePose(origin_mm=[1, 2, 3], x_axis=[0, 1, 0], y_axis=[0, 0, 1], spacing_mm=[2, 3])
        self.assertEqual(list(pose.pixel_to_world([1, 1])), [1, 4, 6])
        self.assertEqual(list(pose.normal), [1, 0, 0])
        self.assertEqual(pose.signed_distance_mm([5, 0, 0]), 4)
        pose.origin_mm[0] = 7  # part of the pose, not a copy
        self.assertEqual(pose.signed_distance_mm([5, 0, 0]), -2)

    def test_stacks_are_sequences(self):
        stack = sphere_images()
        self.assertEqual([s.name for s in stack[::5]], ["slice 0", "slice 5", "slice 10"])
        self.assertEqual([s.name for s in stack[[0, -1]]], ["slice 0", "slice 10"])
        self.assertEqual(len(stack[:4] + stack[4:]), len(stack))
        self.assertEqual(isostack.volume_of(stack).grid, stack.grid())


if __name__ == "__main__":
    main()
