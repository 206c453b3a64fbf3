#include "segmentation/propagate.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "recon/geometry/errors.h"
#include "segmentation/fast_marching.h"
#include "segmentation/flood.h"
#include "segmentation/number_text.h"
#include "segmentation/region.h"
#include "segmentation/shape_steps.h"

namespace isostack {

namespace {

/// Number of the 4-connected part at every pixel, from 1; 0 outside.
Image<int> parts_of(const Mask& mask) {
  Image<int> part = Image<int>::Zero(mask.rows(), mask.cols());
  int count = 0;
  for (Eigen::Index row = 0; row < mask.rows(); ++row)
    for (Eigen::Index column = 0; column < mask.cols(); ++column) {
      if (!mask(row, column) || part(row, column)) continue;
      ++count;
      flood_from(row, column, mask.rows(), mask.cols(), [&](Eigen::Index r, Eigen::Index c) {
        if (!mask(r, c) || part(r, c)) return false;
        part(r, c) = count;
        return true;
      });
    }
  return part;
}

/// The part that shares most pixels with the start, and those of which at least half does.
Mask parts_meeting(const Mask& mask, const Mask& start) {
  const Image<int> part = parts_of(mask);
  struct Count {
    double all = 0, shared = 0;
  };
  std::map<int, Count> counts;
  for (Eigen::Index pixel = 0; pixel < part.size(); ++pixel) {
    if (part.data()[pixel] == 0) continue;
    Count& count = counts[part.data()[pixel]];
    ++count.all;
    count.shared += start.data()[pixel] != 0;
  }
  int best = 0;
  double most = 0;
  for (const auto& [number, count] : counts)
    if (count.shared > most) most = count.shared, best = number;
  Mask kept = Mask::Zero(mask.rows(), mask.cols());
  for (Eigen::Index pixel = 0; pixel < part.size(); ++pixel) {
    const int number = part.data()[pixel];
    if (number == 0 || best == 0) continue;
    const Count& count = counts[number];
    kept.data()[pixel] = number == best || count.shared >= count.all / 2;
  }
  return kept;
}

Image<float> distance_of(const Image<float>& phi, const Eigen::Vector2d& spacing_mm, double band_mm) {
  Field<2> field = field_of(phi, spacing_mm);
  redistance(field, band_mm);
  return image_of(field);
}

/// What the neighbouring plane says: where to start, and the distance from its organ.
struct Neighbour {
  Mask start;
  Image<float> distance_mm;  ///< empty on a seed's plane
};

class Propagation {
 public:
  Propagation(OrganRegion& organ, const OrganScene& scene, const std::vector<StartStep>& steps,
              const OrganOptions& options)
      : organ_(organ), scene_(scene), steps_(steps), options_(options), is_done_(scene.order.size(), false) {}

  std::vector<std::string> run() {
    start_at_seeds();
    while (!front_.empty()) {
      const auto [from, step] = front_.front();
      front_.pop_front();
      visit_neighbour(from, step);
    }
    for (std::size_t k = 0; k < is_done_.size(); ++k)
      if (!is_done_[k]) organ_.phi[k].setConstant(-1);
    return std::move(remarks_);
  }

 private:
  void start_at_seeds() {
    std::map<std::size_t, Mask> starts;
    for (const SeedPixel& seed : seeds_within(organ_, scene_)) {
      Mask& start =
          starts.try_emplace(seed.slice, Mask::Zero(scene_.grey[seed.slice].rows(), scene_.grey[seed.slice].cols()))
              .first->second;
      start(seed.row, seed.column) = 1;
    }
    for (const auto& [plane, start] : starts) {
      if (!find_organ(plane, {start, {}}))
        throw InputError(scene_.slice(plane).name, "the steps after the rule leave nothing at the seed",
                         "try a smaller --open, or another --range or --level");
      for (const int step : {-1, 1}) front_.emplace_back(plane, step);
    }
  }

  void visit_neighbour(std::size_t from, int step) {
    if ((step < 0 && from == 0) || (step > 0 && from + 1 == is_done_.size())) return;
    const std::size_t plane = step < 0 ? from - 1 : from + 1;
    if (is_done_[plane]) return;
    const double band_mm = options_.propagate_mm + 2 * scene_.pose(from).spacing_mm.maxCoeff();
    const Neighbour neighbour{inside_of(organ_.phi[from]),
                              distance_of(organ_.phi[from], scene_.pose(from).spacing_mm, band_mm)};
    if (find_organ(plane, neighbour)) front_.emplace_back(plane, step);
  }

  /// Leaves the organ's region in phi[plane]; false when it is absent there.
  bool find_organ(std::size_t plane, const Neighbour& neighbour) {
    is_done_[plane] = true;
    Image<float>& phi = organ_.phi[plane];
    const SlicePose& pose = scene_.pose(plane);
    bool is_present = true;
    for (const StartStep& step : steps_) {
      if (std::holds_alternative<ConnectedStep>(step))
        is_present = is_present && keep_meeting(plane, neighbour);
      else
        apply_shape_step(step, pose, phi);
    }
    if (is_present && options_.evolution.is_active())
      phi = image_of(evolve_region<2>(field_of(phi, pose.spacing_mm), field_of(scene_.grey[plane], pose.spacing_mm),
                                      organ_.range, options_.evolution, scene_.slice(plane).name));
    is_present = is_present && (phi >= 0).any();
    if (!is_present) phi.setConstant(-1);
    return is_present;
  }

  /// The parts that meet the start, within reach of the neighbour's organ; false when there are none, or when most
  /// of them is beyond reach, so that something else was met.
  bool keep_meeting(std::size_t plane, const Neighbour& neighbour) {
    Image<float>& phi = organ_.phi[plane];
    const Mask kept = parts_meeting(inside_of(phi), neighbour.start);
    impose(kept, phi);
    const int size = kept.cast<int>().sum();
    if (size == 0 || neighbour.distance_mm.size() == 0) return size > 0;
    const auto reach_mm = static_cast<float>(options_.propagate_mm);
    const int within = ((kept != 0) && (neighbour.distance_mm >= -reach_mm)).cast<int>().sum();
    if (2 * within < size) {
      remarks_.push_back(
          organ_.name + ": on " + scene_.slice(plane).name + " the region runs " +
          number_text(100.0 * (size - within) / size, 2) +
          " % beyond reach of the slice before, so it is "
          "taken as absent from there on; if it is not, try --open, a narrower --range, or a seed there");
      return false;
    }
    const double band_mm = options_.propagate_mm + 2 * scene_.pose(plane).spacing_mm.maxCoeff();
    phi = distance_of(phi, scene_.pose(plane).spacing_mm, band_mm).min(neighbour.distance_mm + reach_mm);
    return true;
  }

  OrganRegion& organ_;
  const OrganScene& scene_;
  const std::vector<StartStep>& steps_;
  const OrganOptions& options_;
  std::vector<bool> is_done_;
  std::deque<std::pair<std::size_t, int>> front_;  ///< planes with a result, and the direction to go on
  std::vector<std::string> remarks_;
};

}  // namespace

std::vector<std::string> propagate(OrganRegion& organ, const OrganScene& scene, const std::vector<StartStep>& steps,
                                   const OrganOptions& options) {
  return Propagation(organ, scene, steps, options).run();
}

}  // namespace isostack
