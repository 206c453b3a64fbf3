#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace isostack::testing {

/// Writes the DICOM file `from` in another transfer syntax with GDCM's own tool (Debian: libgdcm-tools); `how` is its
/// option: rle, jpeg, jpegls, j2k, deflated. Returns false when it cannot.
inline bool compress_dicom(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& how) {
  const std::string command = "gdcmconv --" + how + " '" + from.string() + "' '" + to.string() + "' > /dev/null 2>&1";
  return std::system(command.c_str()) == 0 && std::filesystem::exists(to);
}

inline bool can_compress_dicom() { return std::system("command -v gdcmconv > /dev/null") == 0; }

}  // namespace isostack::testing
