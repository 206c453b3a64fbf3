#include "io/vtp_file.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "io/atomic_file.h"
#include "io/vtk_errors.h"

namespace isostack {

namespace {

/// VTK takes a file whose last array is cut off, and crashes on an array of unknown type.
void require_sound(const std::filesystem::path& path) {
  constexpr std::string_view types =
      "|PolyData|Int8|UInt8|Int16|UInt16|Int32|UInt32|Int64|UInt64|Float32|Float64|String|Bit|vtkIdType|";
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string_view end = std::string_view(text).substr(text.size() - std::min<std::size_t>(text.size(), 64));
  bool sound = end.find("</VTKFile>") != std::string_view::npos;
  constexpr std::string_view attribute = " type=\"";
  for (auto at = text.find(attribute); at != std::string::npos && sound; at = text.find(attribute, at + 1)) {
    const auto value = std::string_view(text).substr(at + attribute.size());
    sound = types.find(fmt::format("|{}|", value.substr(0, value.find('"')))) != std::string_view::npos;
  }
  if (!sound)
    throw InputError(path.string(), "it is not a whole VTP file", "it is truncated, damaged or another format");
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_vtp(const std::filesystem::path& path) {
  require_sound(path);
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  update_or_throw(*reader, path);
  return reader->GetOutput();
}

void write_vtp(vtkPolyData& data, const std::filesystem::path& path) {
  AtomicFile file(path);
  const vtkNew<vtkXMLPolyDataWriter> writer;
  const vtkNew<VtkErrors> errors = capture_errors(*writer);
  writer->SetFileName(file.temporary().c_str());
  writer->SetInputData(&data);
  if (writer->Write() == 0 || errors->any() || writer->GetErrorCode() != 0)
    throw InputError(path.string(), "it cannot be written to the end", "check that the disk has free space");
  file.commit();
}

}  // namespace isostack
