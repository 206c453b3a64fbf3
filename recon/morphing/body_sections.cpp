#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "recon/morphing/solved_morph.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/layered_function.h"
#include "recon/surface/surface_seeds.h"

namespace isostack {

namespace {

/// Sections of the function at the frames' places, their surfaces followed from wherever a lattice meets them.
class BodySections : public MorphMethod {
 public:
  explicit BodySections(SolvedMorph solved)
      : function_(solved.kernel, solved.centres, solved.solution),
        places_(std::move(solved.places)),
        spacing_mm_(solved.spacing_mm),
        tolerance_mm_(solved.tolerance_mm),
        resolution_mm_(solved.resolution_mm) {
    for (const KeyShape& body : solved.shapes) box_.extend(box_of(body.shape, {}));
  }

  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override {
    std::vector<Shape> shapes;
    for (const Eigen::VectorXd& weight : weights) {
      progress.report("frames", static_cast<double>(shapes.size()) / static_cast<double>(weights.size()));
      shapes.emplace_back(body_at(spacing_mm_ * places_.place_at(weight), progress));
    }
    return shapes;
  }

 private:
  TriangleMesh body_at(const Eigen::VectorXd& place_mm, const Progress& progress) const {
    const ScalarField field = function_.section(place_mm, tolerance_mm_);
    const double side_mm = box_.sizes().maxCoeff();
    const auto widened = [&](double by_mm) {
      return Eigen::AlignedBox3d(box_.min().array() - by_mm, box_.max().array() + by_mm);
    };
    const double looked_at_mm = std::max(coarseness * resolution_mm_, side_mm / most_looks);
    const std::vector<Eigen::Vector3d> seeds = surface_seeds(field, widened(seeded_margin * side_mm), looked_at_mm);
    ExtractionOptions options;
    options.resolution_mm = resolution_mm_;
    options.bounds = widened(followed_margin * side_mm);
    options.may_be_empty = true;  // what is smaller than a cell is lost
    return extract_surface(field, seeds, options, {.on_report = {}, .is_cancelled = progress.is_cancelled}).mesh;
  }

  // Parts of a frame may reach beyond the key shapes; what begins far from them is no part of it.
  static constexpr double seeded_margin = 0.1, followed_margin = 0.5;
  // The lattice that finds the surface: in cells of the surface, and at most along the longest side.
  static constexpr double coarseness = 2, most_looks = 128;

  LayeredFunction function_;
  KeyPlaces places_;
  double spacing_mm_, tolerance_mm_, resolution_mm_;
  Eigen::AlignedBox3d box_;
};

}  // namespace

std::shared_ptr<const MorphMethod> body_sections(SolvedMorph solved) {
  return std::make_shared<const BodySections>(std::move(solved));
}

}  // namespace isostack
