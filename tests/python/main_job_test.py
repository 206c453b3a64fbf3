"""The main job in a few lines, and the command's own files to the last bit."""

import unittest

import isostack
from support import SCRATCH, SHARED, main, needs, phantom, run


class SameBytes(unittest.TestCase):
    def same(self, ours, *command):
        theirs = ours.with_name("command_" + ours.name)
        run(*command, "-o", theirs)
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())

    def test_from_series_to_surface(self):
        series, path = phantom() / "series", SCRATCH / "organ.stl"

        images = isostack.read_slices(series)[::4]
        organ = isostack.segment(images, level=25)
        result = isostack.reconstruct(organ)
        isostack.write(result, path)

        self.same(path, "reconstruct", series, "--level", 25, "--every", 4)
        truth = isostack.read_mesh(phantom() / "truth.stl")
        self.assertGreater(isostack.compare(result.surface, truth).dice, 0.9)  # from a quarter of the slices

    def test_planes_in_any_direction_with_the_dense_solver(self):
        path = SCRATCH / "planes.ply"
        organ = isostack.segment(isostack.read_slices(phantom() / "planes"), level=25, gaussian_sigma_pixels=0.5)
        isostack.write(isostack.reconstruct(organ, solver="dense", max_constraints=2000), path)
        self.same(path, "reconstruct", phantom() / "planes", "--level", 25, "--gaussian", 0.5, "--solver", "dense",
                  "--max-constraints", 2000)

    def test_rules_and_seeds(self):
        series, path = phantom() / "series", SCRATCH / "by_seed.json"
        images = isostack.read_slices(series)
        inside = isostack.segment(images, level=25)[15].contours[0]
        seed = images[15].pose.slice_to_world(inside.points_mm.mean(axis=0)).round(3)
        found = isostack.segment_organs(images, seeds=[(*seed, "organ")], otsu=True, open_mm=1.5, fill_holes=True,
                                        evolution=isostack.EvolutionOptions(curvature=0.5))
        isostack.write(found.organs, path)
        self.same(path, "segment", series, "--seed", ",".join(map(str, seed)) + ",organ", "--otsu", "--open", 1.5,
                  "--fill-holes", "--curvature", 0.5)

    def test_interpolating(self):
        options = isostack.interpolating()
        self.assertEqual((options.softening.strength, options.section_rounds), (0, 6))

    @needs("abdomen_ct")
    def test_a_kidney_from_labels(self):
        labels = SHARED / "abdomen_ct" / "labels.nii.gz"
        kidney = isostack.trace_organs(isostack.read_labels(labels), KIDNEY)[0]
        path = SCRATCH / "kidney.ply"
        isostack.write(isostack.reconstruct(kidney[::2], max_constraints=3000), path)
        self.same(path, "reconstruct", labels, "--label", KIDNEY, "--every", 2, "--max-constraints", 3000)
        voxels = isostack.LabelVolume(isostack.read_labels(labels).layers[0].grid)
        voxels.voxels[...] = isostack.read_labels(labels).layers[0].voxels == KIDNEY
        self.assertGreater(isostack.compare(isostack.read(path), voxels).dice, 0.9)  # every other slice, stairs


KIDNEY = 2  # of the shared labels: right kidney


if __name__ == "__main__":
    main()
