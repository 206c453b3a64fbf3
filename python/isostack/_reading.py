"""Files to values."""

from typing import Any, List, Optional, Union

from isostack import _core
from isostack._core import (
    ContourSlice, ContourStack, CsgSolid, Grid, LabelMap, ReadOptions, SliceStack, TriangleMesh, Volume)
from isostack._options import Path, Progress, merged, warn

__all__ = [
    "read", "read_contours", "read_grid", "read_label_planes", "read_labels", "read_mesh", "read_slices",
    "read_volume", "series_planes",
]


def read_slices(path: Path, options: Optional[ReadOptions] = None, *, progress: Progress = None,
                **fields: Any) -> SliceStack:
    """Reads a DICOM folder or file, NIfTI, NRRD, MetaImage or a folder of PNG/TIFF images.

    Every slice keeps its own pose (DICOM LPS, mm); grey values are in the modality's units (CT: HU). Parallel DICOM
    slices come ordered along their normal. `fields` are those of ReadOptions. What a user must know is warned about.
    Raises InputError or GeometryError naming the file.
    """
    stack = _core.read_slices(path, merged(ReadOptions, options, fields), progress)
    warn(stack.warnings)
    return stack


def read_contours(path: Path, options: Optional[ReadOptions] = None, **fields: Any) -> List[ContourStack]:
    """Reads contours, one stack per organ: RTSTRUCT, .vtp, .json, .csl, .contour or cardiac guide points.

    Points are in slice mm, poses in DICOM LPS mm. `fields` are those of ReadOptions. What is left out is
    warned about. Raises InputError naming the file and the slice.
    """
    organs, remarks = _core.read_contours(path, merged(ReadOptions, options, fields))
    warn(remarks)
    return organs


def read_mesh(path: Path, axes: str = "lps") -> TriangleMesh:
    """Reads STL, PLY, OBJ or VTP. Coordinates are mm in the given axes ("lps" or "ras"); the mesh is in LPS.

    Raises InputError naming the file.
    """
    members = _core.MeshAxes.__members__
    if axes not in members:
        raise ValueError(f"axes: {axes!r} is none of {', '.join(members)}")
    return _core.read_mesh(path, members[axes])


def read_volume(path: Path) -> Volume:
    """Reads NIfTI, NRRD or MetaImage with its pose from the header, world LPS mm. Raises InputError naming the file."""
    return _core.read_volume(path)


def read_labels(path: Path) -> LabelMap:
    """Reads labels with their names and colours: DICOM SEG, NRRD, NIfTI, MetaImage. World LPS mm.

    Raises InputError naming the file, also when its values are not whole numbers.
    """
    labels = _core.read_labels(path)
    warn(labels.warnings)
    return labels


def read_label_planes(path: Path) -> List[LabelMap]:
    """As read_labels, but labels on no even grid, as DICOM SEG may have them, come as one map for each plane."""
    return _core.read_label_planes(path)


def read_grid(path: Path, options: Optional[ReadOptions] = None, **fields: Any) -> Grid:
    """The grid of a volume file, a DICOM SEG or an evenly spaced series, world LPS mm."""
    return _core.read_grid(path, merged(ReadOptions, options, fields))


def series_planes(like: Path, series: str = "") -> List[ContourSlice]:
    """The planes of a DICOM image series or a volume: slices without contours. No pixels are read."""
    return _core.series_planes(like, series)


def read(path: Path, options: Optional[ReadOptions] = None, *, progress: Progress = None,
         **fields: Any) -> Union[SliceStack, Volume, LabelMap, List[ContourStack], TriangleMesh, CsgSolid]:
    """Reads whatever a path holds, as kind_of(path) tells.

    DICOM images and folders of pictures: SliceStack; NIfTI, NRRD, MetaImage: Volume; DICOM SEG, .seg.nrrd: LabelMap;
    RTSTRUCT and contour files: list of ContourStack; STL, PLY, OBJ, VTP: TriangleMesh; solids (.json): CsgSolid.
    """
    kind = _core.kind_of(path)
    if kind == "slices":
        return read_slices(path, options, progress=progress, **fields)
    if kind == "contours":
        return read_contours(path, options, **fields)
    if options is not None or fields:
        raise TypeError(f"reading a {kind} takes no options")
    verbs = {"volume": read_volume, "labels": read_labels, "mesh": read_mesh, "solid": _core.read_solid}
    return verbs[kind](path)  # type: ignore[operator,no-any-return]
