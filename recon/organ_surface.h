#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/slice_pose.h"
#include "recon/reconstruct.h"
#include "recon/surface/implicit_function.h"
#include "recon/surface/scalar_field.h"
#include "recon/surface/stack_bounds.h"

namespace isostack {

/// Throws GeometryError, naming the organ, when fewer than two slices have a contour.
void require_two_slices(std::size_t with_boundary, std::size_t total, const std::string& name);
void require_two_slices(const ContourStack& contours);

/// A fitted function with what bounds its surface.
struct FittedOrgan {
  ImplicitFunction function;
  std::vector<SlicePose> poses;
  double pixel_mm = std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector3d> seeds_mm;  ///< contour points that became boundary constraints

  void add_plane(const SlicePose& pose);
};

/// Fits the function of one organ and fills the report. Throws as reconstruct() does.
FittedOrgan fit_organ(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress,
                      ReconstructReport& report);

/// f and its gradient; with flat or open caps, unchanged beyond the outermost slices with contours.
struct BoundedField {
  ScalarField field;
  StackBounds bounds;
};
BoundedField bounded_field(const FittedOrgan& organ, const ReconstructOptions& options);

/// The surface of the field, which may differ from the organ's own, into result.surface; fills the report.
void extract_organ(const FittedOrgan& organ, const BoundedField& bounded, const ReconstructOptions& options,
                   const Progress& progress, Reconstruction& result);

}  // namespace isostack
