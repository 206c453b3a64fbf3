"""Values to and from the data sets of VTK's Python module. World LPS mm on both sides; memory is shared outwards."""

from typing import Any, Union

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # type: ignore[import]
from vtkmodules.vtkCommonCore import vtkPoints  # type: ignore[import]
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData  # type: ignore[import]
from vtkmodules.vtkFiltersCore import vtkTriangleFilter  # type: ignore[import]

from isostack._core import ContourStack, LabelVolume, TriangleMesh, Volume
from isostack.errors import GeometryError, InputError


def _points(values: Any) -> vtkPoints:
    points = vtkPoints()
    points.SetData(numpy_to_vtk(values, deep=False))
    return points


def _cells(connectivity: Any, sizes: Any) -> vtkCellArray:
    offsets = numpy.zeros(len(sizes) + 1, dtype=connectivity.dtype)
    numpy.cumsum(sizes, out=offsets[1:])
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtk(offsets, deep=True), numpy_to_vtk(connectivity, deep=False))
    return cells


def to_polydata(mesh: Union[TriangleMesh, ContourStack]) -> vtkPolyData:
    """A vtkPolyData of a mesh, which shares its points, triangles and normals; or of an organ's contours as closed
    polylines in world mm, with the slice's number and the nesting depth of each."""
    if isinstance(mesh, ContourStack):
        return _contours(mesh)
    data = vtkPolyData()
    if len(mesh.vertices_mm) == 0:
        return data
    data.SetPoints(_points(mesh.vertices_mm))
    data.SetPolys(_cells(mesh.triangles.reshape(-1), numpy.full(len(mesh.triangles), 3)))
    if len(mesh.normals):
        normals = numpy_to_vtk(mesh.normals, deep=False)
        normals.SetName("Normals")
        data.GetPointData().SetNormals(normals)
    return data


def _contours(organ: ContourStack) -> vtkPolyData:
    points, loops, slices, depths = [numpy.zeros((0, 3))], [], [], []
    count = 0
    for number, plane in enumerate(organ.slices):
        axes = numpy.stack([plane.pose.x_axis, plane.pose.y_axis])
        for contour in plane.contours:
            points.append(plane.pose.origin_mm + contour.points_mm @ axes)
            loop = numpy.arange(count, count + len(contour), dtype=numpy.int64)
            loops.append(numpy.append(loop, count))
            slices.append(number)
            depths.append(contour.depth)
            count += len(contour)
    data = vtkPolyData()
    data.SetPoints(_points(numpy.concatenate(points)))
    if loops:
        data.SetLines(_cells(numpy.concatenate(loops), [len(loop) for loop in loops]))
    for name, values in (("slice", slices), ("depth", depths)):
        array = numpy_to_vtk(numpy.array(values, dtype=numpy.int32), deep=True)
        array.SetName(name)
        data.GetCellData().AddArray(array)
    return data


def from_polydata(data: vtkPolyData, name: str = "") -> TriangleMesh:
    """The mesh of a vtkPolyData (LPS mm): polygons and strips become triangles, point normals are kept. Copied."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(data)
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    found = triangles.GetOutput()
    if found.GetNumberOfPolys() == 0:
        raise InputError("vtkPolyData", "there is no triangle in it", "give a surface of polygons or strips")
    corners = vtk_to_numpy(found.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    normals = found.GetPointData().GetNormals()
    return TriangleMesh(vtk_to_numpy(found.GetPoints().GetData()), corners,
                        None if normals is None else vtk_to_numpy(normals), name)


def to_image_data(volume: Union[Volume, LabelVolume], name: str = "values") -> vtkImageData:
    """A vtkImageData that shares the volume's voxels, with origin, spacing and direction (LPS mm).

    Raises GeometryError for a sheared grid (gantry tilt), which vtkImageData cannot hold.
    """
    matrix = volume.grid.index_to_world
    spacing = numpy.linalg.norm(matrix[:3, :3], axis=0)
    direction = matrix[:3, :3] / spacing
    if not numpy.allclose(direction.T @ direction, numpy.eye(3), atol=1e-6):
        raise GeometryError("vtkImageData", "the grid is sheared", "resample the volume on a grid with right angles")
    image = vtkImageData()
    image.SetDimensions(*(int(n) for n in volume.grid.size))
    image.SetSpacing(*spacing)
    image.SetOrigin(*matrix[:3, 3])
    image.SetDirectionMatrix(*direction.reshape(-1))
    values = numpy_to_vtk(volume.voxels.reshape(-1), deep=False)
    values.SetName(name)
    image.GetPointData().SetScalars(values)
    return image


def from_image_data(image: vtkImageData, labels: bool = False) -> Union[Volume, LabelVolume]:
    """The volume of a vtkImageData's scalars (LPS mm), as labels if asked for. Copied."""
    scalars = image.GetPointData().GetScalars()
    if scalars is None or scalars.GetNumberOfComponents() != 1:
        raise InputError("vtkImageData", "it does not have one scalar per point", "set its point scalars")
    to_world = image.GetIndexToPhysicalMatrix()
    matrix = numpy.array([[to_world.GetElement(row, column) for column in range(4)] for row in range(4)])
    first = numpy.eye(4)
    first[:3, 3] = image.GetExtent()[::2]
    columns, rows, planes = image.GetDimensions()
    voxels = vtk_to_numpy(scalars).reshape(planes, rows, columns)
    return LabelVolume(voxels, matrix @ first) if labels else Volume(voxels, matrix @ first)
