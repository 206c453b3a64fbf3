#pragma once

namespace isostack {

/// While it lives VTK writes nothing to stdout and stderr; failures are found by looking at results.
class QuietVtk {
 public:
  QuietVtk();
  ~QuietVtk();
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int warnings_before_;
  int verbosity_before_;
};

}  // namespace isostack
