"""Files in and out: places by pydicom's tags, round trips, errors."""

import unittest

import numpy as np

import isostack
from support import SCRATCH, SHARED, main, needs, phantom, run, sphere_images, sphere_mesh

try:
    import pydicom
    from pydicom.dataset import FileDataset, FileMetaDataset
    from pydicom.uid import ExplicitVRLittleEndian, generate_uid
except ImportError:
    pydicom = None

needs_pydicom = unittest.skipIf(pydicom is None, "python3-pydicom is absent")


def write_series(folder, count=4):
    """An oblique CT series written by pydicom alone; stored values are row + 10 column + 100 slice."""
    folder.mkdir()
    series, study, frame = generate_uid(), generate_uid(), generate_uid()
    turn = np.radians(20)
    rows, columns = np.array([np.cos(turn), np.sin(turn), 0]), np.array([-np.sin(turn), np.cos(turn), 0])
    for k in range(count):
        meta = FileMetaDataset()
        meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
        meta.MediaStorageSOPInstanceUID = generate_uid()
        meta.TransferSyntaxUID = ExplicitVRLittleEndian
        data = FileDataset(None, {}, file_meta=meta, preamble=b"\0" * 128)
        data.is_little_endian, data.is_implicit_VR = True, False
        data.SOPClassUID, data.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
        data.SeriesInstanceUID, data.StudyInstanceUID, data.FrameOfReferenceUID = series, study, frame
        data.Modality, data.PatientName, data.PatientID, data.InstanceNumber = "CT", "Nobody^Known", "42", k + 1
        data.Rows, data.Columns, data.SamplesPerPixel = 5, 7, 1
        data.PhotometricInterpretation = "MONOCHROME2"
        data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = 16, 16, 15, 0
        data.PixelSpacing = [0.75, 0.5]  # rows apart, columns apart
        data.ImageOrientationPatient = [*rows, *columns]
        data.ImagePositionPatient = list(np.array([-20.0, 35.5, 100.0 + 3 * k]))
        data.RescaleSlope, data.RescaleIntercept = 2, -1000
        row, column = np.mgrid[0:5, 0:7]
        data.PixelData = (row + 10 * column + 100 * k).astype("<u2").tobytes()
        data.save_as(folder / f"{count - k}.dcm", write_like_original=False)


def affine_of(data):
    """Pixel (column, row, 1) to world, as PS3.3 C.7.6.2.1.1 has it, from pydicom's tags."""
    position = np.array(data.ImagePositionPatient, float)
    along_row = np.array(data.ImageOrientationPatient[:3], float) * float(data.PixelSpacing[1])
    along_column = np.array(data.ImageOrientationPatient[3:], float) * float(data.PixelSpacing[0])
    return np.stack([along_row, along_column, position], axis=1)


class Dicom(unittest.TestCase):
    @needs_pydicom
    def test_places_and_values_are_those_of_pydicom(self):
        folder = SCRATCH / "by_pydicom"
        write_series(folder)
        files = sorted((pydicom.dcmread(f) for f in folder.iterdir()), key=lambda d: d.ImagePositionPatient[2])
        stack = isostack.read_slices(folder)
        self.assertEqual(len(stack), len(files))
        for found, data in zip(stack, files):
            for column, row in [(0, 0), (6, 0), (0, 4), (3, 2)]:
                expected = affine_of(data) @ [column, row, 1]
                np.testing.assert_allclose(found.pose.pixel_to_world([column, row]), expected, atol=1e-6)
            expected = data.pixel_array * float(data.RescaleSlope) + float(data.RescaleIntercept)
            np.testing.assert_array_equal(found.pixels, expected)
        self.assertNotIn("Nobody", repr(stack) + stack.name + "".join(s.name for s in stack))

    @needs_pydicom
    def test_the_phantom_is_as_pydicom_reads_it(self):
        stack = isostack.read_slices(phantom() / "series")
        for found in stack[::7]:
            data = pydicom.dcmread(phantom() / "series" / found.name)
            np.testing.assert_allclose(found.pose.pixel_to_world([127, 127]), affine_of(data) @ [127, 127, 1],
                                       atol=1e-5)
            np.testing.assert_array_equal(found.pixels,
                                          data.pixel_array * data.RescaleSlope + data.RescaleIntercept)

    @needs_pydicom
    @needs("rtstruct")
    def test_structure_sets_are_as_pydicom_reads_them(self):
        path = SHARED / "rtstruct" / "breast.dcm"
        data = pydicom.dcmread(path)
        names = {roi.ROINumber: roi.ROIName for roi in data.StructureSetROISequence}
        organs = {organ.name: organ for organ in isostack.read_contours(path)}
        self.assertEqual(set(organs), set(names.values()))
        drawn = [roi for roi in data.ROIContourSequence if "ContourSequence" in roi]
        for roi in drawn[:3]:
            given = [np.array(c.ContourData, float).reshape(-1, 3) for c in roi.ContourSequence
                     if c.ContourGeometricType == "CLOSED_PLANAR"]
            organ = organs[names[roi.ReferencedROINumber]]
            found = np.concatenate([[s.pose.slice_to_world(p) for p in c.points_mm] for s in organ for c in s.contours])
            for curve in given[::5]:
                gap = np.linalg.norm(found - curve[0], axis=1).min()
                self.assertLess(gap, 0.02)  # mm: points nearer than 0.005 mm are one, places have 2 decimals

    @needs_pydicom
    @needs("dicom_seg")
    def test_segmentations_are_as_pydicom_reads_them(self):
        path = SHARED / "dicom_seg" / "liver.dcm"
        data = pydicom.dcmread(path)
        labels = isostack.read(path)
        self.assertIsInstance(labels, isostack.LabelMap)
        self.assertEqual(len(labels.segments), len(data.SegmentSequence))
        voxels = sum(int((labels.layers[s.layer].voxels == s.value).sum()) for s in labels.segments)
        self.assertEqual(voxels, int((data.pixel_array > 0).sum()))

    def test_series_are_chosen_by_keyword(self):
        summaries = isostack.inspect(phantom() / "series")
        self.assertEqual([s.slice_count for s in summaries], [30])
        self.assertEqual(len(isostack.read_slices(phantom() / "series", series=summaries[0].series_uid)), 30)
        with self.assertRaises(isostack.InputError):
            isostack.read_slices(phantom() / "series", series="7")

    def test_a_series_written_comes_back(self):
        isostack.write_dicom_series(sphere_images(), SCRATCH / "written")
        again = isostack.read_slices(SCRATCH / "written")
        for a, b in zip(sphere_images(), again):
            np.testing.assert_allclose(a.pose.origin_mm, b.pose.origin_mm, atol=1e-6)
            np.testing.assert_allclose(a.pixels, b.pixels, atol=0.5)  # stored as whole numbers


class RoundTrips(unittest.TestCase):
    def test_meshes(self):
        mesh = sphere_mesh()
        for extension in ("ply", "obj", "vtp", "stl"):
            path = SCRATCH / f"ball.{extension}"
            isostack.write(mesh, path)
            again = isostack.read(path)
            self.assertEqual(len(again.triangles), len(mesh.triangles))
            self.assertAlmostEqual(isostack.measure(again).volume_mm3, isostack.measure(mesh).volume_mm3, delta=0.1)
        isostack.write_mesh(mesh, SCRATCH / "ras.ply", axes="ras")
        np.testing.assert_allclose(isostack.read_mesh(SCRATCH / "ras.ply", axes="ras").vertices_mm, mesh.vertices_mm,
                                   atol=1e-5)
        np.testing.assert_allclose(isostack.read_mesh(SCRATCH / "ras.ply").vertices_mm, mesh.vertices_mm * [-1, -1, 1],
                                   atol=1e-5)

    def test_contours(self):
        organ = isostack.segment(sphere_images(), level=50)
        organ.name, organ.color = "ball", (10, 20, 30)
        for extension in ("json", "vtp", "dcm"):
            path = SCRATCH / f"ball_contours.{extension}"
            isostack.write(organ, path)
            again = isostack.read_contours(path)[0]
            self.assertEqual((again.name, again.color), ("ball", (10, 20, 30)))
            area = sum(s.area_mm2 for s in again)
            self.assertAlmostEqual(area, sum(s.area_mm2 for s in organ), delta=0.1)

    def test_volumes_and_labels(self):
        volume = isostack.volume_of(sphere_images())
        for extension in ("nii.gz", "nrrd", "mha"):
            path = SCRATCH / f"ball.{extension}"
            isostack.write(volume, path)
            again = isostack.read(path)
            np.testing.assert_allclose(again.voxels, volume.voxels, rtol=1e-6)
            np.testing.assert_allclose(again.grid.index_to_world, volume.grid.index_to_world, atol=1e-4)
        organ = isostack.segment(sphere_images(), level=50)
        labels = isostack.label_map([organ], volume.grid)
        self.assertEqual(int(labels.layers[0].voxels.sum()), int((volume.voxels >= 50).sum()))
        isostack.write(labels, SCRATCH / "ball.seg.nrrd")
        again = isostack.read(SCRATCH / "ball.seg.nrrd")
        self.assertEqual([s.name for s in again.segments], [organ.name])
        np.testing.assert_array_equal(again.layers[0].voxels, labels.layers[0].voxels)

    def test_convert_writes_the_bytes_that_the_command_writes(self):
        isostack.write(sphere_mesh(), SCRATCH / "a.ply")
        isostack.write(isostack.volume_of(sphere_images()), SCRATCH / "a.nrrd")
        isostack.write(isostack.segment(sphere_images(), level=50), SCRATCH / "a.json")
        for source, target in [("a.ply", "stl"), ("a.nrrd", "nii.gz"), ("a.nrrd", "mha"), ("a.json", "vtp")]:
            ours, theirs = SCRATCH / f"ours.{target}", SCRATCH / f"theirs.{target}"
            isostack.convert(SCRATCH / source, ours)
            run("convert", SCRATCH / source, "-o", theirs)
            self.assertEqual(ours.read_bytes(), theirs.read_bytes(), target)

    def test_mesh_to_contours_on_a_series(self):
        isostack.convert(phantom() / "truth.stl", SCRATCH / "cut.json", like=phantom() / "series")
        run("convert", phantom() / "truth.stl", "-o", SCRATCH / "cut_by_command.json", "--like", phantom() / "series")
        self.assertEqual((SCRATCH / "cut.json").read_bytes(), (SCRATCH / "cut_by_command.json").read_bytes())


class Errors(unittest.TestCase):
    def test_parts_and_hierarchy(self):
        with self.assertRaises(isostack.InputError) as caught:
            isostack.read_slices("nowhere")
        error = caught.exception
        self.assertEqual((error.where, error.problem), ("nowhere", "there is no such file or folder"))
        self.assertEqual(str(error), f"{error.where}: {error.problem}; {error.remedy}.")
        self.assertIsInstance(error, isostack.Error)
        self.assertIsInstance(error, ValueError)
        self.assertTrue(issubclass(isostack.SolveError, RuntimeError))
        self.assertFalse(issubclass(isostack.Cancelled, isostack.Error))

    def test_geometry(self):
        with self.assertRaises(isostack.GeometryError):
            isostack.volume_of(isostack.read_slices(phantom() / "planes"))
        with self.assertRaises(isostack.GeometryError):
            isostack.reconstruct(isostack.segment(sphere_images()[5:6], level=50))

    def test_solve_that_does_not_fit(self):
        organ = isostack.segment(sphere_images(), level=50)
        with self.assertRaises(isostack.SolveError) as caught:
            isostack.reconstruct(organ, memory_limit_bytes=1000)
        self.assertTrue(caught.exception.remedy)

    def test_damaged_files(self):
        path = SCRATCH / "damaged.ply"
        isostack.write(sphere_mesh(), path)
        path.write_bytes(path.read_bytes()[:200])
        with self.assertRaisesRegex(isostack.InputError, "damaged.ply"):
            isostack.read(path)

    def test_warnings_of_readers(self):
        with self.assertWarnsRegex(isostack.InputWarning, "uneven gaps"):
            isostack.read_slices(phantom() / "series")

    def test_what_cannot_be_written(self):
        with self.assertRaisesRegex(TypeError, "write takes"):
            isostack.write(3, SCRATCH / "x.stl")
        with self.assertRaisesRegex(isostack.InputError, "xyz"):
            isostack.write(sphere_mesh(), SCRATCH / "x.xyz")


if __name__ == "__main__":
    main()
