#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/dicom/dicom_phases.h"
#include "io/dicom/dicom_pixels.h"
#include "io/dicom/dicom_series.h"
#include "io/slice_order.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Collects the pictures of a series that can be slices.
class Pictures {
 public:
  explicit Pictures(const DicomSeries& series) : is_scene_(series.is_scene) {
    const bool only_localizers = std::all_of(series.files.begin(), series.files.end(),
                                             [](const DicomHeader& file) { return file.is_localizer; });
    for (const DicomHeader& file : series.files) {
      if (file.is_localizer && !only_localizers)
        localizers_.push_back(file.name);
      else if (is_copy(file))
        copies_.push_back(file.name);
      else
        add(file);
    }
    if (only_localizers)
      throw InputError(series.files.front().name, "it is a localizer, a projection of the patient and no slice",
                       "choose a series of slices");
    if (headers.empty())
      throw InputError(rejected_.front(), "no picture of the scene can be used as a slice (" + first_reason_ + ")",
                       "choose a series of grey slices with positions");
  }

  std::vector<std::string> remarks() const {
    std::vector<std::string> remarks;
    const auto remark = [&](const std::vector<std::string>& names, std::string_view what, std::string_view why) {
      if (!names.empty()) remarks.push_back(fmt::format("{}: {} left out, {}", what, listed(names), why));
    };
    remark(localizers_, "localizers", "they are projections and no slices");
    remark(copies_, "duplicate files", "they are copies of others");
    remark(rejected_, "unusable pictures", first_reason_);
    return remarks;
  }

  std::vector<DicomHeader> headers;
  std::vector<SlicePose> poses;

 private:
  /// Some anonymisers give all files one UID, so the place must be the same, too.
  bool is_copy(const DicomHeader& file) {
    const Eigen::Vector3d p = file.position_mm.value_or(Eigen::Vector3d::Zero());
    const std::string key = fmt::format("{} {} {} {} {} {}", file.instance_uid, p.x(), p.y(), p.z(),
                                        file.timing.instance_number.value_or(0), file.frames);
    return !file.instance_uid.empty() && !instances_.insert(key).second;
  }
  void add(const DicomHeader& file) {
    try {
      require_grey(file);
      for (DicomHeader& picture : frames_of(file)) {
        poses.push_back(pose_of(picture));
        headers.push_back(std::move(picture));
      }
    } catch (const Error& error) {
      if (!is_scene_) throw;
      poses.resize(headers.size());
      if (rejected_.empty()) first_reason_ = error.what();
      rejected_.push_back(file.name);
    }
  }
  static std::string listed(const std::vector<std::string>& names) {
    return names.size() == 1 ? names.front() : fmt::format("{} and {} more", names.front(), names.size() - 1);
  }

  bool is_scene_;
  std::set<std::string> instances_;
  std::vector<std::string> localizers_, copies_, rejected_;
  std::string first_reason_;
};

/// For pictures in order, the number of the plane each lies in.
std::vector<std::size_t> places_of(const std::vector<SlicePose>& poses) {
  constexpr double same_place_mm = 1e-3;
  std::vector<std::size_t> place_of(poses.size(), 0);
  for (std::size_t i = 1, first = 0; i < poses.size(); ++i) {
    const bool is_same = are_parallel(poses[first], poses[i]) &&
                         std::abs(poses[first].signed_distance_mm(poses[i].origin_mm)) < same_place_mm;
    place_of[i] = place_of[i - 1] + (is_same ? 0 : 1);
    if (!is_same) first = i;
  }
  return place_of;
}

/// Slices of one series and one direction must be equally large.
void require_equal_sizes(const OrderedSeries& series) {
  std::map<std::string, std::size_t> first_of;
  for (std::size_t i = 0; i < series.files.size(); ++i) {
    if (i > 0 && !are_parallel(series.poses[i - 1], series.poses[i])) first_of.clear();
    const DicomHeader& file = series.files[i];
    const DicomHeader& first = series.files[first_of.try_emplace(file.series_uid, i).first->second];
    if (file.columns != first.columns || file.rows != first.rows)
      throw InputError(file.name,
                       fmt::format("the slice has {} x {} pixels, but {} has {} x {}", file.columns, file.rows,
                                   first.name, first.columns, first.rows),
                       "take the slices of other sizes out of the series");
  }
}

[[noreturn]] void throw_repeated(const OrderedSeries& series, const std::vector<std::size_t>& place_of,
                                 const DicomPhases& phases) {
  std::size_t second = 1;
  while (place_of[second] != place_of[second - 1]) ++second;
  throw GeometryError(
      series.files[second].name,
      fmt::format("the slice lies at the same position as {}: {} slices lie at {} place(s), up to {} at one, told "
                  "apart by {}",
                  series.files[second - 1].name, place_of.size(), phases.places, phases.count, phases.ordered_by),
      fmt::format("choose one of the phases with --phase 1 to {}, or keep one slice at each place", phases.count));
}

OrderedSeries in_order(const Pictures& pictures) {
  OrderedSeries ordered;
  for (const std::size_t i : order_along_normals(pictures.poses)) {
    ordered.files.push_back(pictures.headers[i]);
    ordered.poses.push_back(pictures.poses[i]);
  }
  return ordered;
}

/// Keeps the pictures of one phase.
void keep_phase(int phase, const DicomPhases& phases, OrderedSeries& series) {
  if (phase < 1 || phase > phases.count)
    throw InputError(series.files.front().name,
                     fmt::format("its series has {} phase(s), so there is no phase {}", phases.count, phase),
                     fmt::format("give --phase 1 to {}", phases.count));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < series.files.size(); ++i) {
    if (phases.phase_of[i] != phase) continue;
    std::swap(series.files[kept], series.files[i]);
    series.poses[kept++] = series.poses[i];
  }
  series.files.resize(kept);
  series.poses.resize(kept);
}

}  // namespace

OrderedSeries order_series(const DicomSeries& series, std::optional<int> phase) {
  const Pictures pictures(series);
  OrderedSeries ordered = in_order(pictures);
  ordered.remarks = pictures.remarks();
  require_equal_sizes(ordered);
  const std::vector<std::size_t> place_of = places_of(ordered.poses);
  const DicomPhases phases = number_phases(ordered.files, place_of);
  if (phases.count > 1 && !phase) throw_repeated(ordered, place_of, phases);
  ordered.phase_count = phases.count;
  ordered.phases_by = phases.ordered_by;
  if (phases.incomplete > 0)
    ordered.remarks.push_back(fmt::format("incomplete phases: {} of {} places have fewer than {} slices",
                                          phases.incomplete, phases.places, phases.count));
  keep_phase(phase.value_or(1), phases, ordered);
  return ordered;
}

}  // namespace isostack
