#pragma once

#include <vtkSmartPointer.h>

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"

class vtkPolyData;

namespace isostack {

/// Triangles with their normals, if there are any, single precision.
vtkSmartPointer<vtkPolyData> polydata_of(const TriangleMesh& mesh);

/// The closed curves as polylines; coinciding neighbours are left out, as a line has no direction between them.
vtkSmartPointer<vtkPolyData> polydata_of(const ContourStack& organ);

}  // namespace isostack
