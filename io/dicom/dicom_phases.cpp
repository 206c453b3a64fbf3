#include "io/dicom/dicom_phases.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

namespace isostack {

namespace {

struct Key {
  std::string_view name;
  std::optional<double> DicomTiming::*value;
};
constexpr std::array keys = {
    Key{"TemporalPosition", &DicomTiming::temporal_position}, Key{"TriggerTime", &DicomTiming::trigger_time_ms},
    Key{"AcquisitionTime", &DicomTiming::acquisition_s}, Key{"EchoTime", &DicomTiming::echo_time_ms},
    Key{"InstanceNumber", &DicomTiming::instance_number}};

using Places = std::vector<std::vector<std::size_t>>;  // the pictures of each

Places pictures_at(const std::vector<std::size_t>& place_of) {
  Places places;
  for (std::size_t i = 0; i < place_of.size(); ++i) {
    places.resize(std::max(places.size(), place_of[i] + 1));
    places[place_of[i]].push_back(i);
  }
  return places;
}

bool tells_apart(const Key& key, const Places& places, const std::vector<DicomHeader>& pictures) {
  return std::all_of(places.begin(), places.end(), [&](const std::vector<std::size_t>& place) {
    std::set<double> values;
    for (const std::size_t i : place)
      if (const auto& value = pictures[i].timing.*key.value;
          place.size() > 1 && (!value || !values.insert(*value).second))
        return false;
    return true;
  });
}

/// The rank of each picture's value among all values, from 1; 0 for pictures without one.
std::vector<int> ranks(const Key& key, const std::vector<DicomHeader>& pictures) {
  std::map<double, int> rank_of;
  for (const DicomHeader& picture : pictures)
    if (const auto& value = picture.timing.*key.value) rank_of[*value] = 0;
  int rank = 0;
  for (auto& entry : rank_of) entry.second = ++rank;
  std::vector<int> result;
  for (const DicomHeader& picture : pictures) {
    const auto& value = picture.timing.*key.value;
    result.push_back(value ? rank_of[*value] : 0);
  }
  return result;
}

void number_within_places(const Key* key, Places places, const std::vector<DicomHeader>& pictures,
                          std::vector<int>& phase_of) {
  for (auto& place : places) {
    if (key && place.size() > 1)
      std::sort(place.begin(), place.end(), [&](std::size_t a, std::size_t b) {
        return *(pictures[a].timing.*key->value) < *(pictures[b].timing.*key->value);
      });
    for (std::size_t i = 0; i < place.size(); ++i) phase_of[place[i]] = static_cast<int>(i) + 1;
  }
}

}  // namespace

DicomPhases number_phases(const std::vector<DicomHeader>& pictures, const std::vector<std::size_t>& place_of) {
  const Places places = pictures_at(place_of);
  DicomPhases phases;
  phases.places = places.size();
  phases.phase_of.assign(pictures.size(), 1);
  for (const auto& place : places) phases.count = std::max(phases.count, static_cast<int>(place.size()));
  if (phases.count == 1) return phases;
  const auto key =
      std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return tells_apart(k, places, pictures); });
  phases.ordered_by = key == keys.end() ? "file name" : key->name;
  const auto by_rank = key == keys.begin() ? ranks(*key, pictures) : std::vector<int>();
  const bool everywhere_the_same = !by_rank.empty() && *std::min_element(by_rank.begin(), by_rank.end()) > 0 &&
                                   *std::max_element(by_rank.begin(), by_rank.end()) == phases.count;
  if (everywhere_the_same)
    phases.phase_of = by_rank;
  else
    number_within_places(key == keys.end() ? nullptr : &*key, places, pictures, phases.phase_of);
  phases.incomplete = static_cast<std::size_t>(std::count_if(
      places.begin(), places.end(), [&](const auto& place) { return static_cast<int>(place.size()) < phases.count; }));
  return phases;
}

}  // namespace isostack
