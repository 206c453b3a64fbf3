#include "io/vtp_file.h"

#include <vtkNew.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <fstream>
#include <string>

#include "io/atomic_file.h"
#include "io/vtk_errors.h"

namespace isostack {

namespace {

/// VTK takes a file whose last array is cut off.
void require_end_tag(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.tellg();
  std::string end(static_cast<std::size_t>(std::min<std::streamoff>(std::max<std::streamoff>(size, 0), 64)), '\0');
  stream.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  stream.read(end.data(), static_cast<std::streamsize>(end.size()));
  if (end.find("</VTKFile>") == std::string::npos)
    throw InputError(path.string(), "it does not end as a VTP file", "it is truncated or another format");
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_vtp(const std::filesystem::path& path) {
  require_end_tag(path);
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
