#include "io/contours/contours_vtp.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <initializer_list>

#include "io/contours/contour_checks.h"
#include "io/vtp_file.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

template <class Array>
vtkSmartPointer<Array> new_array(vtkFieldData& owner, const char* name, int components = 1) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  owner.AddArray(array);
  return array;
}

/// The table of slices, one row per slice of each organ.
class SliceTable {
 public:
  explicit SliceTable(vtkFieldData& field)
      : organ_names_(new_array<vtkStringArray>(field, "organ_name")),
        roi_types_(new_array<vtkStringArray>(field, "organ_roi_type")),
        colors_(new_array<vtkIntArray>(field, "organ_color", 4)),
        names_(new_array<vtkStringArray>(field, "slice_name")),
        organs_(new_array<vtkIntArray>(field, "slice_organ")),
        origins_(new_array<vtkDoubleArray>(field, "slice_origin_mm", 3)),
        x_axes_(new_array<vtkDoubleArray>(field, "slice_x_axis", 3)),
        y_axes_(new_array<vtkDoubleArray>(field, "slice_y_axis", 3)),
        spacings_(new_array<vtkDoubleArray>(field, "slice_spacing_mm", 2)),
        sizes_(new_array<vtkIntArray>(field, "slice_size_pixels", 2)) {}

  void add_organ(const ContourStack& organ) {
    organ_names_->InsertNextValue(organ.name);
    roi_types_->InsertNextValue(organ.roi_type);
    const Color color = organ.color.value_or(Color{});
    colors_->InsertNextTuple4(color.red, color.green, color.blue, organ.color ? 1 : 0);
  }
  void add_slice(int organ, const ContourSlice& slice) {
    names_->InsertNextValue(slice.name);
    organs_->InsertNextValue(organ);
    origins_->InsertNextTuple(slice.pose.origin_mm.data());
    x_axes_->InsertNextTuple(slice.pose.x_axis.data());
    y_axes_->InsertNextTuple(slice.pose.y_axis.data());
    spacings_->InsertNextTuple(slice.pose.spacing_mm.data());
    sizes_->InsertNextTuple2(slice.size_pixels.x(), slice.size_pixels.y());
  }

 private:
  vtkSmartPointer<vtkStringArray> organ_names_, roi_types_;
  vtkSmartPointer<vtkIntArray> colors_;
  vtkSmartPointer<vtkStringArray> names_;
  vtkSmartPointer<vtkIntArray> organs_;
  vtkSmartPointer<vtkDoubleArray> origins_, x_axes_, y_axes_, spacings_;
  vtkSmartPointer<vtkIntArray> sizes_;
};

/// Adds the curve with its first point's index repeated at the end: a closed polyline in VTK.
void add_polyline(const Contour& contour, const SlicePose& pose, vtkPoints& points, vtkCellArray& lines) {
  if (contour.points_mm.empty()) return;
  const vtkIdType first = points.GetNumberOfPoints();
  const auto count = static_cast<vtkIdType>(contour.points_mm.size());
  lines.InsertNextCell(static_cast<int>(count) + 1);
  for (const Eigen::Vector2d& point : contour.points_mm)
    lines.InsertCellPoint(points.InsertNextPoint(pose.slice_to_world(point).eval().data()));
  lines.InsertCellPoint(first);
}

vtkSmartPointer<vtkPolyData> to_vtk(const std::vector<ContourStack>& organs) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  SliceTable table(*data->GetFieldData());
  const auto organ_of = new_array<vtkIntArray>(*data->GetCellData(), "organ");
  const auto slice_of = new_array<vtkIntArray>(*data->GetCellData(), "slice");
  const auto depth_of = new_array<vtkIntArray>(*data->GetCellData(), "depth");
  int slice_row = 0;
  for (std::size_t organ = 0; organ < organs.size(); ++organ) {
    table.add_organ(organs[organ]);
    for (const ContourSlice& slice : organs[organ].slices) {
      table.add_slice(static_cast<int>(organ), slice);
      for (const Contour& contour : slice.contours) {
        add_polyline(contour, slice.pose, *points, *lines);
        organ_of->InsertNextValue(static_cast<int>(organ));
        slice_of->InsertNextValue(slice_row);
        depth_of->InsertNextValue(contour.depth);
      }
      ++slice_row;
    }
  }
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

[[noreturn]] void throw_no_table(const std::string& file, const std::string& what) {
  throw InputError(file, "it is not a contour file (" + what + ")",
                   "write contours with isostack or as docs/formats.md says");
}

vtkDataArray& numbers(vtkFieldData& field, const char* name, int components, vtkIdType rows, const std::string& file) {
  vtkDataArray* array = field.GetArray(name);
  if (!array || array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != rows)
    throw_no_table(file, fmt::format("no array \"{}\" of {} x {} numbers", name, rows, components));
  return *array;
}

vtkStringArray& strings(vtkFieldData& field, const char* name, const std::string& file) {
  auto* array = vtkStringArray::SafeDownCast(field.GetAbstractArray(name));
  if (!array) throw_no_table(file, fmt::format("no text array \"{}\"", name));
  return *array;
}

/// The slices, each where its organ's stack holds it.
struct ReadTable {
  std::vector<ContourStack> organs;
  std::vector<std::pair<std::size_t, std::size_t>> place_of_row;  ///< organ, index of the slice within it

  ContourSlice& slice(std::size_t row) { return organs[place_of_row[row].first].slices[place_of_row[row].second]; }
};

/// Colours and ROI types, which files need not have.
void read_looks(vtkFieldData& field, std::vector<ContourStack>& organs, const std::string& file) {
  const auto count = static_cast<vtkIdType>(organs.size());
  auto* types = vtkStringArray::SafeDownCast(field.GetAbstractArray("organ_roi_type"));
  vtkDataArray* colors = field.GetArray("organ_color") ? &numbers(field, "organ_color", 4, count, file) : nullptr;
  for (vtkIdType i = 0; i < count; ++i) {
    ContourStack& organ = organs[static_cast<std::size_t>(i)];
    if (types && types->GetNumberOfValues() == count) organ.roi_type = types->GetValue(i);
    if (!colors || colors->GetComponent(i, 3) == 0) continue;
    const auto channel = [&](int c) {
      return static_cast<std::uint8_t>(std::clamp(colors->GetComponent(i, c), 0.0, 255.0));
    };
    organ.color = Color{channel(0), channel(1), channel(2)};
  }
}

ReadTable read_table(vtkFieldData& field, const std::string& file) {
  ReadTable table;
  vtkStringArray& organ_names = strings(field, "organ_name", file);
  vtkStringArray& names = strings(field, "slice_name", file);
  const vtkIdType rows = names.GetNumberOfValues();
  vtkDataArray& organs = numbers(field, "slice_organ", 1, rows, file);
  vtkDataArray& origins = numbers(field, "slice_origin_mm", 3, rows, file);
  vtkDataArray& x_axes = numbers(field, "slice_x_axis", 3, rows, file);
  vtkDataArray& y_axes = numbers(field, "slice_y_axis", 3, rows, file);
  vtkDataArray& spacings = numbers(field, "slice_spacing_mm", 2, rows, file);
  vtkDataArray& sizes = numbers(field, "slice_size_pixels", 2, rows, file);
  for (vtkIdType i = 0; i < organ_names.GetNumberOfValues(); ++i) table.organs.push_back({organ_names.GetValue(i), {}});
  read_looks(field, table.organs, file);
  for (vtkIdType row = 0; row < rows; ++row) {
    const auto organ = static_cast<std::size_t>(organs.GetComponent(row, 0));
    if (organ >= table.organs.size()) throw_no_table(file, "a slice belongs to an unknown organ");
    auto& slices = table.organs[organ].slices;
    table.place_of_row.emplace_back(organ, slices.size());
    ContourSlice& slice = slices.emplace_back();
    slice.name = names.GetValue(row);
    origins.GetTuple(row, slice.pose.origin_mm.data());
    x_axes.GetTuple(row, slice.pose.x_axis.data());
    y_axes.GetTuple(row, slice.pose.y_axis.data());
    spacings.GetTuple(row, slice.pose.spacing_mm.data());
    slice.size_pixels = {static_cast<int>(sizes.GetComponent(row, 0)), static_cast<int>(sizes.GetComponent(row, 1))};
  }
  return table;
}

Contour contour_from(vtkPolyData& data, vtkIdType count, const vtkIdType* corners, const ContourSlice& slice,
                     const std::string& file) {
  Contour contour;
  for (vtkIdType i = 0; i < count; ++i) {
    if (corners[i] < 0 || corners[i] >= data.GetNumberOfPoints())
      throw_no_table(file, "a polyline names a point that is not there");
    contour.points_mm.push_back(slice.pose.world_to_slice(Eigen::Vector3d(data.GetPoint(corners[i]))));
  }
  const bool closed =
      count > 0 && (corners[0] == corners[count - 1] || contour.points_mm.front() == contour.points_mm.back());
  if (!closed) throw_open_contour(file, slice.name);
  contour.points_mm.pop_back();
  return contour;
}

void read_polylines(vtkPolyData& data, ReadTable& table, const std::string& file) {
  vtkDataArray& slice_of = numbers(*data.GetCellData(), "slice", 1, data.GetNumberOfLines(), file);
  const auto cell = vtk::TakeSmartPointer(data.GetLines()->NewIterator());
  vtkIdType index = 0;
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell(), ++index) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(count, corners);
    const auto row = static_cast<std::size_t>(slice_of.GetComponent(index, 0));
    if (row >= table.place_of_row.size()) throw_no_table(file, "a polyline belongs to an unknown slice");
    ContourSlice& slice = table.slice(row);
    slice.contours.push_back(contour_from(data, count, corners, slice, file));
  }
}

}  // namespace

bool is_vtp_contours(const std::filesystem::path& path) {
  return read_vtp(path)->GetFieldData()->GetAbstractArray("slice_name") != nullptr;
}

ContourFile read_vtp_contours(const std::filesystem::path& path, const ReadOptions& /*options*/) {
  const vtkSmartPointer<vtkPolyData> read = read_vtp(path);
  vtkPolyData& data = *read;
  ReadTable table = read_table(*data.GetFieldData(), path.string());
  if (data.GetNumberOfLines() > 0) read_polylines(data, table, path.string());
  for (ContourStack& organ : table.organs)
    for (ContourSlice& slice : organ.slices) complete_slice(slice, path.string());
  return {.organs = std::move(table.organs)};
}

void write_vtp_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                        const WriteOptions& /*options*/) {
  write_vtp(*to_vtk(organs), path);
}

}  // namespace isostack
