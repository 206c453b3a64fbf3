#include "recon/geometry/errors.h"

namespace isostack {

Error::Error(const std::string& where, const std::string& problem, const std::string& remedy)
    : std::runtime_error(where + ": " + problem + "; " + remedy + "."),
      parts_(std::make_shared<const Parts>(Parts{where, problem, remedy})) {}

Cancelled::Cancelled() : std::runtime_error("cancelled") {}

}  // namespace isostack
