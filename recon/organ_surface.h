#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "recon/constraints/contour_samples.h"
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
  double cell_pixels = 1;                     ///< width of the surface's cells where no resolution is asked for
  std::vector<Eigen::Vector3d> seeds_mm;      ///< contour points that became boundary constraints
  std::vector<ContourSample> samples = {};    ///< the same, with their contours; empty when made from images
  std::vector<std::string> slice_names = {};  ///< for samples

  void add_plane(const SlicePose& pose);
};

/// f and its gradient; with flat or open caps, unchanged beyond the outermost slices with contours.
struct BoundedField {
  ScalarField field;
  StackBounds bounds;
};
BoundedField bounded_field(const FittedOrgan& organ, const ReconstructOptions& options);

/// The surface of the field, which may differ from the organ's own, into result.surface; fills the report. Where a
/// resolution is not asked for, contours without a surface get one in finer cells where they can (lost_contours.h), and
/// else all cells are refined. Returns a sample of each contour that has none even so.
std::vector<ContourSample> extract_organ(const FittedOrgan& organ, const BoundedField& bounded,
                                         const ReconstructOptions& options, const Progress& progress,
                                         Reconstruction& result);

/// Throws SolveError naming the first slice unless there is none or options.accept_lost_contours.
void require_none_lost(const std::vector<ContourSample>& lost, const FittedOrgan& organ,
                       const ReconstructOptions& options);

/// An organ by itself.
struct OrganSurface {
  FittedOrgan fitted;
  BoundedField bounded;
  Reconstruction result;
};

/// Fits the function of one organ and extracts its surface, again and again while sections by the input planes stray
/// from the contours. Throws as reconstruct() does.
OrganSurface reconstruct_organ(const ContourStack& contours, const ReconstructOptions& options,
                               const Progress& progress);

/// Remeshes or simplifies result.surface as the options ask, on the zero set of the field it was extracted from; fills
/// the report. Throws GeometryError as retriangulate() does.
void retriangulate_organ(const BoundedField& bounded, const ReconstructOptions& options, const Progress& progress,
                         Reconstruction& result);

}  // namespace isostack
