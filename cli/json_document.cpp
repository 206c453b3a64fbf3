#include "cli/json_document.h"

#include <fstream>

#include "io/file_listing.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

nlohmann::json read_json_document(const std::filesystem::path& path, const std::string& format,
                                  const std::string& remedy) {
  require_exists(path);
  std::ifstream file(path);
  nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
  if (document.is_discarded()) throw InputError(path.string(), "it is not valid JSON", remedy);
  if (!document.is_object() || document.value("format", nlohmann::json()) != format ||
      document.value("version", nlohmann::json()) != 1)
    throw InputError(path.string(), "it is not a file of the format " + format + ", version 1", remedy);
  return document;
}

}  // namespace isostack::cli
