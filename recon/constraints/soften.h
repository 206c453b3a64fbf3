#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/constraints/crossings.h"
#include "recon/kernels/kernel.h"

namespace isostack {

struct SofteningOptions {
  double least_pixels = 0.5;  ///< contradictions nearer than this are met exactly
  double strength = 100;      ///< factor on ρ; 0 softens nothing
  double reach = 3;           ///< radius round a contradiction, as a multiple of how far apart its contours are
};

/// A place where no surface can meet both slices: `distance_mm` apart between two points.
struct SoftPlace {
  Eigen::Vector3d from_mm, to_mm;
  double distance_mm;
};

/// The contradictions more than least_pixels · pixel_mm apart.
std::vector<SoftPlace> soft_places(const Contradictions& contradictions, double pixel_mm,
                                   const SofteningOptions& options = {});

/// Smoothing ρ for each of the points (3 × N, world mm): with d how far apart the contours of a contradiction
/// are, s the point's distance from it and p the power of the kernel φ ~ r^p,
///
///     ρ = strength · d^p · (1 − (s / (reach · d))²)²   within reach · d, the largest over all contradictions; else 0.
///
/// ρ has φ's unit, mm^p: a kernel matrix on points d apart differs from a constant by about d^p, so such a ρ lets the
/// function leave the values of constraints d or less apart and keeps what is wider. The factor 100 stands for the many
/// constraints in that neighbourhood. Measured on a sphere of radius 30 mm, two orthogonal stacks 2 mm apart from each
/// other (8 mm gaps, 1 mm pixels, r³): without softening 6 components, genus 8 and 10 % too much area, up to 5.6 mm
/// outside both; strength 1, 10, 100: one sphere, 5, 3.4, 1.5 % too much area, 0.7, 0.6, 0.6 mm outside both. The same
/// strength serves 1 and 4 mm, gaps of 16 mm and the kernel r. Both slices' constraints soften alike, so the surface
/// passes between their contours.
Eigen::VectorXd softening_of(const Eigen::MatrixXd& points, const std::vector<SoftPlace>& places, const Kernel& kernel,
                             const SofteningOptions& options = {});

/// Whether a contradiction explains why one slice objects to f at a point `wrong_by_mm` from its contours: meeting that
/// slice there would only move the surface away from the other one.
bool is_explained_by(const std::vector<SoftPlace>& places, const Eigen::Vector3d& point_mm, double wrong_by_mm,
                     const SofteningOptions& options = {});

}  // namespace isostack
