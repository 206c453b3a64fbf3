#include "cli/failure.h"

#include <fmt/format.h>

#include <new>

#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

Failure with_parts(ExitCode exit_code, const char* kind, const Error& error) {
  return {exit_code, kind, error.what(), error.where(), error.problem(), error.remedy()};
}

}  // namespace

Failure failure_of(const std::exception& error) {
  if (const auto* e = dynamic_cast<const SolveError*>(&error)) return with_parts(kCouldNotSolve, "SolveError", *e);
  if (const auto* e = dynamic_cast<const GeometryError*>(&error)) return with_parts(kBadInput, "GeometryError", *e);
  if (const auto* e = dynamic_cast<const Error*>(&error)) return with_parts(kBadInput, "InputError", *e);
  if (dynamic_cast<const Cancelled*>(&error))
    return {kCancelled, "Cancelled", "stopped; no output was written", "", "", ""};
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return failure_of(
        SolveError("memory", "there is not enough of it", "use fewer constraints or a coarser --resolution"));
  return {kBadInput,
          "UnexpectedError",
          fmt::format("unexpected failure: {}; please report how it came about.", error.what()),
          "",
          "",
          ""};
}

nlohmann::json to_json(const Failure& failure) {
  nlohmann::json json = {{"exit_code", failure.exit_code}, {"kind", failure.kind}, {"message", failure.message}};
  if (!failure.where.empty())
    json.update({{"where", failure.where}, {"problem", failure.problem}, {"remedy", failure.remedy}});
  return json;
}

}  // namespace isostack::cli
