#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace isostack {

/// Base of every failure the libraries report. The message is one sentence:
/// where it happened (file, slice, option), what was wrong, and what to do.
class Error : public std::runtime_error {
 public:
  Error(const std::string& where, const std::string& problem, const std::string& remedy);

  const std::string& where() const { return parts_->where; }
  const std::string& problem() const { return parts_->problem; }
  const std::string& remedy() const { return parts_->remedy; }

 private:
  struct Parts {
    std::string where, problem, remedy;
  };
  std::shared_ptr<const Parts> parts_;  ///< shared, so that a copy cannot throw
};

/// A file or value handed over is missing, broken or contradicts another.
class InputError : public Error {
  using Error::Error;
};

/// Slices, contours or meshes whose geometry cannot be used as asked.
class GeometryError : public Error {
  using Error::Error;
};

/// A solve that cannot reach its tolerance or does not fit into memory.
class SolveError : public Error {
  using Error::Error;
};

/// The caller asked to stop; nothing was produced.
class Cancelled : public std::runtime_error {
 public:
  Cancelled();
};

}  // namespace isostack
