#include <utility>

#include "recon/morphing/figure_frames.h"
#include "recon/morphing/solved_morph.h"
#include "recon/surface/implicit_function.h"

namespace isostack {

namespace {

/// Frames of figures are sections of the solved function at a place.
class FigureSections : public MorphMethod {
 public:
  explicit FigureSections(SolvedMorph solved)
      : solved_(std::move(solved)),
        function_(solved_.kernel, solved_.centres, solved_.solution, solved_.tolerance_mm),
        frames_(solved_.shapes, solved_.resolution_mm) {}

  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override {
    std::vector<Shape> shapes;
    for (const Eigen::VectorXd& place : weights) {
      progress.report("frames", static_cast<double>(shapes.size()) / static_cast<double>(weights.size()));
      shapes.emplace_back(frames_.trace(section(solved_.place_mm(place))));
    }
    return shapes;
  }

  std::optional<SpacetimeField> spacetime() const override {
    if (solved_.places.layout != KeyLayout::line) return std::nullopt;
    const Eigen::RowVectorXd times_mm = solved_.spacing_mm * solved_.places.coordinates.row(0);
    SpacetimeField result;
    result.field = {.values = [f = function_](const Eigen::Matrix3Xd& points) { return f.values(points); },
                    .gradients = [f = function_](const Eigen::Matrix3Xd& points) -> Eigen::Matrix3Xd {
                      return f.gradients(points);
                    }};
    const Eigen::AlignedBox2d box = widened(frames_.box_mm(), 0.5);
    result.bounds_mm.min() << box.min(), times_mm.minCoeff();
    result.bounds_mm.max() << box.max(), times_mm.maxCoeff();
    for (std::size_t i = 0; i < solved_.constraints.size(); ++i)
      for (const auto& point :
           solved_.constraints[i].set.points.leftCols(solved_.constraints[i].boundary_count).colwise())
        result.seeds_mm.emplace_back(point.x(), point.y(), times_mm[static_cast<Eigen::Index>(i)]);
    return result;
  }

 private:
  PlaneFunction section(const Eigen::VectorXd& place_mm) const {
    return [this, place_mm](const Eigen::Matrix2Xd& points) -> Eigen::VectorXd {
      Eigen::MatrixXd placed(2 + place_mm.size(), points.cols());
      placed.topRows<2>() = points;
      placed.bottomRows(place_mm.size()).colwise() = place_mm;
      return function_.values(placed);
    };
  }

  SolvedMorph solved_;
  ImplicitFunction function_;
  FigureFrames frames_;
};

}  // namespace

std::shared_ptr<const MorphMethod> figure_sections(SolvedMorph solved) {
  return std::make_shared<const FigureSections>(std::move(solved));
}

}  // namespace isostack
