#include "viewers/surface_actor.h"

#include <vtkActor.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "viewers/mesh_proxy.h"
#include "viewers/palette.h"
#include "viewers/polydata.h"

namespace isostack {

namespace {

/// Without a graphics card some five million triangles are drawn in a second, fewer while work goes on: this leaves
/// time for images and text within 100 ms.
constexpr std::size_t most_while_moving = 120'000;

vtkNew<vtkLookupTable> lookup_table(const ColourRange& range) {
  constexpr int colours = 256;
  const auto set = [](const Color& c, auto&& take) { take(c.red / 255.0, c.green / 255.0, c.blue / 255.0); };
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(colours);
  table->SetTableRange(range.low, std::max(range.high, range.low + 1e-12));
  for (int i = 0; i < colours; ++i)
    set(colour_of(range.low + (range.high - range.low) * i / (colours - 1), range),
        [&](double r, double g, double b) { table->SetTableValue(i, r, g, b); });
  set(colour_of(NAN, range), [&](double r, double g, double b) { table->SetNanColor(r, g, b, 1); });
  return table;
}

void show_values(const VertexValues& values, vtkPolyData& polydata, vtkPolyDataMapper& mapper) {
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfValues(polydata.GetNumberOfPoints());
  for (vtkIdType i = 0; i < polydata.GetNumberOfPoints(); ++i)
    scalars->SetValue(i, values.values[static_cast<std::size_t>(i)]);
  polydata.GetPointData()->SetScalars(scalars);
  mapper.SetLookupTable(lookup_table(values.range));
  mapper.UseLookupTableScalarRangeOn();
  mapper.InterpolateScalarsBeforeMappingOn();
  mapper.ScalarVisibilityOn();
}

vtkSmartPointer<vtkMapper> mapper_of(const TriangleMesh& mesh, const std::optional<VertexValues>& values) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->ScalarVisibilityOff();
  const vtkSmartPointer<vtkPolyData> polydata = polydata_of(mesh);
  if (values) show_values(*values, *polydata, *mapper);
  if (polydata->GetPointData()->GetNormals()) {
    mapper->SetInputData(polydata);
  } else {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(polydata);
    normals->SplittingOn();
    normals->SetFeatureAngle(60);  // a cube's edges stay sharp, a scan's noise does not show
    normals->ConsistencyOff();
    mapper->SetInputConnection(normals->GetOutputPort());
  }
  // Contours lie on the surface: push it back by a hair so that they are not drawn in dashes.
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  return mapper;
}

vtkSmartPointer<vtkMapper> proxy_mapper_of(const SceneSurface& item) {
  const MeshProxy proxy = mesh_proxy(item.mesh, most_while_moving / 2);
  std::optional<VertexValues> values;
  if (item.values) {
    values = {.label = "", .values = {}, .range = item.values->range};
    for (const std::size_t vertex : proxy.source_vertex) values->values.push_back(item.values->values[vertex]);
  }
  return mapper_of(proxy.mesh, values);
}

}  // namespace

SurfaceActor::SurfaceActor(std::size_t index) : index_(index), actor_(vtkSmartPointer<vtkActor>::New()) {
  vtkProperty& look = *actor_->GetProperty();
  look.SetInterpolationToPhong();
  look.SetAmbient(0.12);
  look.SetDiffuse(0.88);
  look.SetSpecular(0.18);
  look.SetSpecularPower(30);
}

void SurfaceActor::rebuild(const SceneSurface& item) {
  proxy_ = nullptr;
  whole_ = mapper_of(item.mesh, item.values);
  actor_->SetMapper(whole_);
  update_look(item);
}

void SurfaceActor::update_look(const SceneSurface& item) {
  vtkProperty& look = *actor_->GetProperty();
  Eigen::Vector3d rgb = organ_colours(index_).surface;
  if (item.mesh.color) rgb = Eigen::Vector3d(item.mesh.color->red, item.mesh.color->green, item.mesh.color->blue) / 255;
  look.SetColor(rgb.x(), rgb.y(), rgb.z());
  look.SetOpacity(item.opacity);
  item.style == SurfaceStyle::wire ? look.SetRepresentationToWireframe() : look.SetRepresentationToSurface();
  actor_->SetVisibility(item.visible);
}

void SurfaceActor::set_moving(bool moving, const SceneSurface& item) {
  const bool simpler = moving && item.visible && item.mesh.triangles.size() > most_while_moving;
  if (simpler && !proxy_) proxy_ = proxy_mapper_of(item);
  actor_->SetMapper(simpler ? proxy_ : whole_);
}

}  // namespace isostack
