#include "recon/morphing/morph.h"

#include <utility>

#include "recon/geometry/errors.h"

namespace isostack {

Morph::Morph(std::shared_ptr<const MorphMethod> method, KeyPlaces places, MorphReport report)
    : method_(std::move(method)), places_(std::move(places)), report_(std::move(report)) {}

Shape Morph::shape_at(double t, const Progress& progress) const { return at(places_.weights_at(t), progress); }

Shape Morph::at(const Eigen::VectorXd& weights, const Progress& progress) const {
  return std::move(frames(std::vector{weights}, progress).front());
}

std::vector<Shape> Morph::frames(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const {
  for (const Eigen::VectorXd& place : weights) places_.require_weights(place);
  return method_->shapes_at(weights, progress);
}

std::vector<Shape> Morph::frames(std::size_t count, const Progress& progress) const {
  if (count < 2) throw InputError("frames", "a sequence needs both its ends", "ask for two frames or more");
  std::vector<Eigen::VectorXd> weights;
  for (std::size_t i = 0; i < count; ++i)
    weights.push_back(places_.weights_at(static_cast<double>(i) / static_cast<double>(count - 1)));
  return frames(weights, progress);
}

}  // namespace isostack
