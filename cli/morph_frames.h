#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/morphing/morph.h"

namespace isostack::cli {

/// One frame of a morph and where it is.
struct MorphFrame {
  std::string name;         ///< "t = 0.25", or the weights of the key shapes: "0.5 0.25 0.25"
  double t = 0;             ///< from the first key shape to the last, or the share of the path behind it
  Eigen::VectorXd weights;  ///< of the key shapes, sum 1
  Shape shape;

  bool is_figure() const { return std::holds_alternative<ContourSlice>(shape); }
  const ContourSlice& figure() const { return std::get<ContourSlice>(shape); }
  const TriangleMesh& body() const { return std::get<TriangleMesh>(shape); }
};

}  // namespace isostack::cli
