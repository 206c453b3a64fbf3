"""VTK data sets out, sharing memory, and back."""

import gc
import unittest

import numpy as np

import isostack
from support import main, sphere_images, sphere_mesh

try:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    import isostack.vtk
except ImportError:
    vtk = None


@unittest.skipIf(vtk is None, "python3-vtk9 is absent")
class Meshes(unittest.TestCase):
    def test_points_triangles_and_normals_share_memory(self):
        mesh = isostack.reconstruct(isostack.segment(sphere_images(), level=50)).surface
        data = isostack.vtk.to_polydata(mesh)
        self.assertEqual(data.GetNumberOfPoints(), len(mesh.vertices_mm))
        self.assertEqual(data.GetNumberOfPolys(), len(mesh.triangles))
        for shared, own in [(data.GetPoints().GetData(), mesh.vertices_mm),
                            (data.GetPolys().GetConnectivityArray(), mesh.triangles),
                            (data.GetPointData().GetNormals(), mesh.normals)]:
            self.assertTrue(np.shares_memory(vtk_to_numpy(shared), own))

    def test_vtk_measures_the_same(self):
        mesh = sphere_mesh()
        measure = vtk.vtkMassProperties()
        measure.SetInputData(isostack.vtk.to_polydata(mesh))
        self.assertAlmostEqual(measure.GetVolume(), isostack.measure(mesh).volume_mm3, delta=1e-6 * measure.GetVolume())
        self.assertAlmostEqual(measure.GetSurfaceArea(), isostack.measure(mesh).area_mm2, delta=1e-3)

    def test_the_data_set_keeps_the_memory_alive(self):
        data = isostack.vtk.to_polydata(sphere_mesh(5))
        gc.collect()
        for _ in range(50):
            sphere_mesh(9)
        self.assertAlmostEqual(np.linalg.norm(vtk_to_numpy(data.GetPoints().GetData()), axis=1).max(), 5)

    def test_round_trip(self):
        mesh = sphere_mesh()
        again = isostack.vtk.from_polydata(isostack.vtk.to_polydata(mesh), "ball")
        np.testing.assert_array_equal(again.vertices_mm, mesh.vertices_mm)
        np.testing.assert_array_equal(again.triangles, mesh.triangles)
        self.assertEqual(again.name, "ball")

    def test_a_source_of_vtk(self):
        source = vtk.vtkCubeSource()  # quadrilaterals
        source.SetXLength(2)
        source.Update()
        mesh = isostack.vtk.from_polydata(source.GetOutput())
        self.assertAlmostEqual(isostack.measure(mesh).volume_mm3, 2, delta=1e-6)
        with self.assertRaises(isostack.InputError):
            isostack.vtk.from_polydata(vtk.vtkPolyData())

    def test_contours_are_closed_lines_in_world(self):
        organ = isostack.segment(sphere_images(), level=50)
        data = isostack.vtk.to_polydata(organ)
        self.assertEqual(data.GetNumberOfLines(), sum(len(s.contours) for s in organ))
        points = vtk_to_numpy(data.GetPoints().GetData())
        self.assertLess(abs(np.linalg.norm(points - [10, -5, 30], axis=1) - 20).max(), 0.2)
        self.assertIsNotNone(data.GetCellData().GetArray("slice"))


@unittest.skipIf(vtk is None, "python3-vtk9 is absent")
class Images(unittest.TestCase):
    def oblique(self):
        turn = np.array([[0, -1, 0], [0.6, 0, -0.8], [0.8, 0, 0.6]])
        matrix = np.eye(4)
        matrix[:3, :3] = turn * [0.5, 1, 2]
        matrix[:3, 3] = [10, -20, 30]
        return isostack.Volume(np.arange(24).reshape(2, 3, 4), matrix)

    def test_voxels_share_memory_and_lie_where_they_lay(self):
        volume = self.oblique()
        image = isostack.vtk.to_image_data(volume)
        self.assertTrue(np.shares_memory(vtk_to_numpy(image.GetPointData().GetScalars()), volume.voxels))
        self.assertEqual(image.GetScalarComponentAsDouble(3, 2, 1, 0), volume.voxels[1, 2, 3])
        place = [0.0, 0.0, 0.0]
        image.TransformIndexToPhysicalPoint([3, 2, 1], place)
        np.testing.assert_allclose(place, (volume.grid.index_to_world @ [3, 2, 1, 1])[:3])

    def test_round_trip(self):
        volume = self.oblique()
        again = isostack.vtk.from_image_data(isostack.vtk.to_image_data(volume))
        np.testing.assert_array_equal(again.voxels, volume.voxels)
        np.testing.assert_allclose(again.grid.index_to_world, volume.grid.index_to_world, atol=1e-12)
        labels = isostack.LabelVolume(np.arange(8).reshape(2, 2, 2))
        again = isostack.vtk.from_image_data(isostack.vtk.to_image_data(labels), labels=True)
        np.testing.assert_array_equal(again.voxels, labels.voxels)

    def test_an_extent_that_does_not_begin_at_zero(self):
        image = isostack.vtk.to_image_data(self.oblique())
        part = vtk.vtkExtractVOI()
        part.SetInputData(image)
        part.SetVOI(1, 3, 1, 2, 1, 1)
        part.Update()
        volume = isostack.vtk.from_image_data(part.GetOutput())
        np.testing.assert_allclose(volume.grid.index_to_world[:3, 3],
                                   (self.oblique().grid.index_to_world @ [1, 1, 1, 1])[:3])
        self.assertEqual(volume.voxels[0, 0, 0], self.oblique().voxels[1, 1, 1])

    def test_a_sheared_grid_is_refused(self):
        matrix = np.eye(4)
        matrix[1, 2] = 0.3
        with self.assertRaisesRegex(isostack.GeometryError, "sheared"):
            isostack.vtk.to_image_data(isostack.Volume(np.zeros((2, 2, 2)), matrix))


if __name__ == "__main__":
    main()
