"""Values to files. A file appears whole or not at all."""

import os
from typing import Any, Iterable, Optional, Sequence, Union

from isostack import _core
from isostack._core import (
    ContourStack, Grid, LabelMap, LabelVolume, Reconstruction, Segment, SliceStack, TriangleMesh, Volume, WriteOptions)
from isostack._options import Path, merged
from isostack._reading import read, read_contours, read_labels, read_mesh, series_planes

__all__ = [
    "convert", "label_map", "write", "write_contours", "write_dicom_series", "write_distances", "write_labels",
    "write_mesh", "write_volume",
]


def write_mesh(mesh: TriangleMesh, path: Path, options: Optional[WriteOptions] = None, **fields: Any) -> None:
    """Writes STL, PLY, OBJ or VTP in LPS mm (axes="ras" for others), or glTF (metres, Y up), by extension."""
    _core.write_mesh(mesh, path, merged(WriteOptions, options, fields))


def write_contours(organs: Union[ContourStack, Sequence[ContourStack]], path: Path,
                   options: Optional[WriteOptions] = None, **fields: Any) -> None:
    """Writes contours as .vtp, .json, .csl, .contour or RTSTRUCT (.dcm; like=SERIES names the images)."""
    several = [organs] if isinstance(organs, ContourStack) else list(organs)
    _core.write_contours(several, path, merged(WriteOptions, options, fields))


def write_labels(labels: Union[LabelMap, LabelVolume], path: Path, options: Optional[WriteOptions] = None,
                 **fields: Any) -> None:
    """Writes labels as NIfTI, NRRD (.seg.nrrd keeps everything), MetaImage or DICOM SEG (.dcm)."""
    whole = LabelMap([labels]) if isinstance(labels, LabelVolume) else labels
    _core.write_labels(whole, path, merged(WriteOptions, options, fields))


def write_volume(volume: Volume, path: Path, options: Optional[WriteOptions] = None, **fields: Any) -> None:
    """Writes NIfTI, NRRD or MetaImage with its pose, in the narrowest type that holds every value exactly."""
    _core.write_volume(volume, path, merged(WriteOptions, options, fields))


def write_distances(distances: Volume, path: Path, options: Optional[WriteOptions] = None, **fields: Any) -> None:
    """The same of signed distances in mm, positive inside, marked as such."""
    _core.write_distances(distances, path, merged(WriteOptions, options, fields))


def write_dicom_series(stack: SliceStack, folder: Path, *, seed: int = 1,
                       description: str = "synthetic phantom") -> None:
    """Writes the slices as CT images slice_0001.dcm ... of patient PHANTOM. All UIDs follow from the seed."""
    _core.write_dicom_series(stack, folder, seed, description)


def write(value: Any, path: Path, options: Optional[WriteOptions] = None, **fields: Any) -> None:
    """Writes a mesh, a reconstruction's surface, contours of one or several organs, labels, a volume, or evenly spaced
    slices as a volume, in the format of the extension. Raises InputError naming the file."""
    if isinstance(value, Reconstruction):
        value = value.surface
    if isinstance(value, SliceStack):
        value = _core.volume_of(value)
    if isinstance(value, TriangleMesh):
        return write_mesh(value, path, options, **fields)
    if isinstance(value, Volume):
        return write_volume(value, path, options, **fields)
    if isinstance(value, (LabelMap, LabelVolume)):
        return write_labels(value, path, options, **fields)
    several = isinstance(value, Iterable) and all(isinstance(item, ContourStack) for item in value)
    if isinstance(value, ContourStack) or several:
        return write_contours(value, path, options, **fields)
    raise TypeError(f"write takes a mesh, contours, labels, a volume or slices, not {value!r}")


def label_map(bodies: Iterable[Union[ContourStack, TriangleMesh]], grid: Grid) -> LabelMap:
    """Organs as labels 1, 2, ... on a grid: voxels whose centre lies within the contours, or inside the closed mesh."""
    labels = LabelMap([LabelVolume(grid)])
    for number, body in enumerate(bodies, 1):
        mask = LabelVolume(grid)
        if isinstance(body, TriangleMesh):
            _core.voxelize(body, mask)
        else:
            _core.rasterize(body, mask)
        labels = labels.with_segment(mask, Segment(name=body.name, value=number, color=body.color))
    return labels


def _as_labels(path: Path) -> bool:
    return os.fspath(path).lower().endswith((".dcm", ".seg.nrrd"))


def _cut(mesh: TriangleMesh, options: WriteOptions) -> ContourStack:
    planes = series_planes(options.like, options.like_series)  # type: ignore[arg-type]
    slices = [_core.ContourSlice(_core.plane_section(mesh, plane.pose).contours, plane.pose, plane.size_pixels,
                                 plane.name) for plane in planes]
    return ContourStack(slices, mesh.name, mesh.color)


def convert(source: Path, path: Path, options: Optional[WriteOptions] = None, **fields: Any) -> None:
    """From any format to another of the same kind: meshes, contours, labels, volumes (which keep their stored type).

    A DICOM series becomes a volume; a mesh becomes contours on the planes of like=SERIES. `fields` are those of
    WriteOptions. Raises InputError naming the file.
    """
    chosen = merged(WriteOptions, options, fields)
    kind = _core.kind_of(source)
    if kind == "volume" and not _as_labels(path):
        return _core.convert_volume(source, path, chosen)
    if kind in ("volume", "labels"):
        return write_labels(read_labels(source), path, chosen)
    if kind == "mesh":
        mesh = read_mesh(source)
        is_cut = chosen.like is not None and os.fspath(path).lower().endswith((".json", ".dcm", ".csl", ".contour"))
        return write(_cut(mesh, chosen) if is_cut else mesh, path, chosen)
    if kind == "contours":
        return write_contours(read_contours(source), path, chosen)
    return write(read(source), path, chosen)
