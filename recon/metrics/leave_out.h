#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/metrics/slice_agreement.h"
#include "recon/reconstruct.h"

namespace isostack {

/// Slices that take part in a study, as positions in ContourStack::slices.
struct SliceSplit {
  std::vector<std::size_t> kept;
  std::vector<std::size_t> dropped;  ///< those compared: of parallel slices only the ones between kept slices
  bool parallel = true;
};

/// Keeps the first slice and every `every`-th after it, along the normal where slices are parallel, else in the order
/// given. Throws InputError for every < 2 and when fewer than two slices are kept or none is dropped.
SliceSplit split_slices(const ContourStack& contours, int every);

/// Reconstructs from the kept slices and compares the surface's sections with the dropped slices' contours.
/// Throws as reconstruct() does.
SliceAgreement agreement_on_dropped(const ContourStack& contours, const SliceSplit& split,
                                    const ReconstructOptions& options, ReconstructReport& report,
                                    const Progress& progress = {});

/// One method's contours on the dropped slices against the slices' own.
struct MethodAgreement {
  std::string method;  ///< "isostack", "cubic" or "linear"
  SliceAgreement agreement;
  double seconds = 0;
};

struct LeaveOutStudy {
  int every = 0;
  std::size_t kept = 0, dropped = 0;
  std::vector<MethodAgreement> methods;
  ReconstructReport report;  ///< of the reconstruction from the kept slices
};

/// How well slices nobody was shown come back. Reconstructs from the kept slices, cuts the surface with the dropped
/// slices' planes and compares the sections with their contours. For parallel slices the same is done with the signed
/// distances of the kept slices, interpolated along the normal on their pixels by a natural cubic spline
/// ("cubic") and from slice to slice ("linear"). Throws as split_slices() and reconstruct() do.
LeaveOutStudy leave_out(const ContourStack& contours, int every, const ReconstructOptions& options,
                        const Progress& progress = {});

}  // namespace isostack
