#include "recon/geometry/progress.h"

#include "recon/geometry/errors.h"

namespace isostack {

void Progress::report(std::string_view stage, double fraction) const {
  if (on_report) on_report(stage, fraction);
  if (is_cancelled && is_cancelled()) throw Cancelled();
}

}  // namespace isostack
