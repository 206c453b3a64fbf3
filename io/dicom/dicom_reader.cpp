#include "io/dicom/dicom_reader.h"

#include <fstream>

#include "io/dicom/gdcm_setup.h"

namespace isostack {

DicomReader::DicomReader(const std::filesystem::path& path)
    : DicomReader(path, find_dicom_start(path).value_or(DicomStart{})) {}

DicomReader::DicomReader(const std::filesystem::path& path, const DicomStart& start) {
  set_up_gdcm();
  const std::string missing = missing_start(start);
  if (missing.empty()) {
    reader_.SetFileName(path.c_str());
    return;
  }
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(start.offset));
  std::ostringstream bytes;
  bytes << missing << file.rdbuf();
  completed_.str(std::move(bytes).str());
  reader_.SetStream(completed_);
}

}  // namespace isostack
