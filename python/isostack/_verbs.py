"""Segmenting, reconstructing, measuring."""

from typing import Any, Iterable, List, Optional, Sequence, Tuple, Union

from isostack import _core
from isostack._core import (
    Alignment, AlignOptions, BodyComparison, ContourMeasures, ContourSlice, ContourStack, CsgSolid,
    DistanceSurfaceOptions, Grid, KernelTrial, LabelMap, LabelOptions, LabelVolume, LeaveOutStudy, MemoryPrediction,
    MeshDistanceOptions, MeshMeasures, OrganOptions, OrganRules, Reconstruction, ReconstructOptions,
    RetriangulationOptions, Segment, SegmentationOptions, SegmentedOrgans, SliceStack, SolidDistanceOptions,
    TriangleMesh, Volume)
from isostack._options import Progress, merged, warn

__all__ = [
    "align_slices", "compare", "distance_surface", "label_sections", "leave_out", "measure", "mended_mesh",
    "mesh_distance", "predict_memory", "reconstruct", "reconstruct_all", "reconstruct_turk_obrien", "retriangulate",
    "segment", "segment_organs", "solid_distance", "trace_label", "trace_organs", "try_kernels",
]


def segment(images: SliceStack, options: Optional[SegmentationOptions] = None, *, progress: Progress = None,
            **fields: Any) -> ContourStack:
    """Contours of one organ by a level (CT: HU), on every slice, also those where it is absent. Slice mm.

    `fields` are those of SegmentationOptions: segment(images, level=226, largest=True). Raises InputError, for instance
    when no slice has a pixel on the organ's side of the level.
    """
    return _core.segment(images, merged(SegmentationOptions, options, fields), progress)


def segment_organs(images: SliceStack, options: Union[OrganRules, OrganOptions, None] = None, *,
                   progress: Progress = None, keep_distances: bool = False, **fields: Any) -> SegmentedOrgans:
    """Organs by seeds or rules, without overlap.

    `fields` are those of OrganRules, or of OrganOptions when these are given. Seeds are in world LPS mm:
    segment_organs(images, seeds=[(12, -40, 310, "liver")], spread=2.5). What a user should look at is warned about, and
    in `remarks`. Raises InputError or GeometryError naming the slice, seed or step.
    """
    if isinstance(options, OrganOptions):
        steps = merged(OrganOptions, options, fields)
    else:
        steps = _core.organ_options(merged(OrganRules, options, fields))
    found = _core.segment_organs(images, steps.replace(keep_distances=True) if keep_distances else steps, progress)
    warn(found.remarks)
    return found


def trace_label(images: SliceStack, label: int, options: Optional[LabelOptions] = None, *, progress: Progress = None,
                **fields: Any) -> ContourStack:
    """Contours of one label of a stack of label images; every pixel centre stays on its side. Slice mm."""
    return _core.trace_label(images, label, merged(LabelOptions, options, fields), progress)


def trace_organs(labels: LabelMap, label: Union[str, int] = "all", options: Optional[LabelOptions] = None, *,
                 progress: Progress = None, **fields: Any) -> List[ContourStack]:
    """Contours of the organs of a label map on its own k-planes, slice mm: all, one by name, or one by number."""
    grid = labels.layers[0].grid
    planes = [ContourSlice(pose=grid.pose_of_plane(k), size_pixels=grid.size[:2], name=f"labels slice {k}")
              for k in range(grid.size[2])]
    segments = labels.chosen_segments(str(label))
    return _core.label_sections(labels, segments, planes, merged(LabelOptions, options, fields), progress)


def label_sections(labels: LabelMap, segments: Sequence[Segment], planes: Sequence[ContourSlice],
                   options: Optional[LabelOptions] = None, *, progress: Progress = None,
                   **fields: Any) -> List[ContourStack]:
    """Labels cut onto planes anywhere, such as series_planes(): one organ per segment, slice mm."""
    return _core.label_sections(labels, segments, planes, merged(LabelOptions, options, fields), progress)


def align_slices(contours: ContourStack, options: Optional[AlignOptions] = None, *, progress: Progress = None,
                 **fields: Any) -> Alignment:
    """Moves slices within their planes until crossing slices contradict each other least: breathing, motion."""
    return _core.align_slices(contours, merged(AlignOptions, options, fields), progress)


def reconstruct(contours: ContourStack, options: Optional[ReconstructOptions] = None, *, progress: Progress = None,
                **fields: Any) -> Reconstruction:
    """One closed surface through all contours (Turk & O'Brien 1999), world LPS mm.

    `fields` are those of ReconstructOptions: reconstruct(contours, smoothing=1, kernel="biharmonic"). `progress` is
    called with a step and a fraction in [0, 1]; Ctrl-C stops the solve. Raises GeometryError for fewer than two slices
    with contours, SolveError when the solve fails or does not fit into memory.
    """
    return _core.reconstruct(contours, merged(ReconstructOptions, options, fields), progress)


def reconstruct_all(organs: Iterable[ContourStack], options: Optional[ReconstructOptions] = None, *,
                    progress: Progress = None, **fields: Any) -> List[Reconstruction]:
    """The surfaces of several organs seen in the same slices, without overlap. World LPS mm."""
    return _core.reconstruct_all(list(organs), merged(ReconstructOptions, options, fields), progress)


def reconstruct_turk_obrien(images: SliceStack, level: float, options: Optional[ReconstructOptions] = None, *,
                            progress: Progress = None, **fields: Any) -> Reconstruction:
    """The paper's own recipe: constraints from the crossings between 4-neighbours of every image. World LPS mm."""
    return _core.reconstruct_turk_obrien(images, level, merged(ReconstructOptions, options, fields), progress)


def predict_memory(organs: Iterable[ContourStack], options: Optional[ReconstructOptions] = None,
                   **fields: Any) -> MemoryPrediction:
    """What reconstruct_all would take in this process, in bytes, before it starts. Solves nothing."""
    return _core.predict_memory(list(organs), merged(ReconstructOptions, options, fields))


def retriangulate(mesh: TriangleMesh, options: Optional[RetriangulationOptions] = None, *, progress: Progress = None,
                  **fields: Any) -> Tuple[TriangleMesh, _core.RetriangulationReport]:
    """Another triangulation of a surface and what came of it: retriangulate(mesh, edge_length_mm=2)."""
    return _core.retriangulate(mesh, merged(RetriangulationOptions, options, fields), progress)


def measure(shape: Union[TriangleMesh, Reconstruction, LabelVolume, ContourSlice],
            scale_mm: float = 1.0) -> Union[MeshMeasures, ContourMeasures]:
    """Volume (mm³), area (mm²), components, genus, watertightness of a mesh, or of label voxels that are not 0 (the
    area is that of their faces); area, perimeter and curvature (seen at scale_mm) of the contours of a slice."""
    if isinstance(shape, ContourSlice):
        return _core.measure_contours(shape, scale_mm)
    if isinstance(shape, LabelVolume):
        return _core.measure_labels(shape)
    return _core.measure_mesh(shape.surface if isinstance(shape, Reconstruction) else shape)


def compare(first: Union[TriangleMesh, LabelVolume], second: Union[TriangleMesh, LabelVolume], *, samples: int = 25_000,
            seed: int = 1) -> BodyComparison:
    """The first body against the second: Dice, mean, 95 % and largest surface distance (mm), volume and area."""
    return _core.compare(first, second, samples, seed)


def leave_out(contours: ContourStack, every: int, options: Optional[ReconstructOptions] = None, *,
              progress: Progress = None, **fields: Any) -> LeaveOutStudy:
    """How well slices nobody was shown come back: reconstructs from every so many slices, compares on the others."""
    return _core.leave_out(contours, every, merged(ReconstructOptions, options, fields), progress)


def try_kernels(contours: ContourStack, options: Optional[ReconstructOptions] = None, *, progress: Progress = None,
                **fields: Any) -> List[KernelTrial]:
    """Kernels and smoothings by how they predict every second slice, the best first."""
    return _core.try_kernels(contours, merged(ReconstructOptions, options, fields), progress)


def mesh_distance(mesh: TriangleMesh, grid: Grid, options: Optional[MeshDistanceOptions] = None, *,
                  progress: Progress = None, **fields: Any) -> Volume:
    """The signed distance to a closed mesh at a grid's voxels, mm, positive inside. Open meshes are warned about."""
    distances, remarks = _core.mesh_distance(mesh, grid, merged(MeshDistanceOptions, options, fields), progress)
    warn(remarks)
    return distances


def solid_distance(solid: CsgSolid, grid: Grid, options: Optional[SolidDistanceOptions] = None, *,
                   progress: Progress = None, **fields: Any) -> Volume:
    """The signed distance to a constructive solid at the voxels of a grid, mm, positive inside."""
    return _core.solid_distance(solid, grid, merged(SolidDistanceOptions, options, fields), progress)


def distance_surface(distances: Volume, options: Optional[DistanceSurfaceOptions] = None, *,
                     progress: Progress = None, **fields: Any) -> TriangleMesh:
    """The closed surface where a volume of distances (positive inside, any scale) is zero, world LPS mm."""
    return _core.distance_surface(distances, merged(DistanceSurfaceOptions, options, fields), progress)


def mended_mesh(mesh: TriangleMesh, *, progress: Progress = None) -> TriangleMesh:
    """A mesh that is open, crosses itself or disagrees about the outside, closed; what was wrong is warned about."""
    mended, remarks = _core.mended_mesh(mesh, progress)
    warn(remarks)
    return mended
