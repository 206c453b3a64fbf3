#include "io/volumes/label_values.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr double largest_value = 65535;

bool fits(double number) { return number >= 0 && number <= largest_value; }

std::set<double> numbers_in(const StoredVolume& volume, const std::string& where) {
  std::set<double> different;
  double last = NAN;  // labels come in runs
  for_each_value(volume, [&](std::size_t, double number) {
    if (number == last) return;
    if (!(std::abs(number) < 9e15) || number != std::floor(number))
      throw InputError(where, fmt::format("voxel value {:.6g} is not a whole number, so it is no label image", number),
                       "give a label image or a grey level");
    different.insert(last = number);
    if (different.size() > largest_value)
      throw InputError(where, "it has more than 65535 different values, so it is no label image",
                       "give a label image or a grey level");
  });
  return different;
}

/// The numbers' values as labels: their own, or free ones where they do not fit.
std::map<double, std::uint16_t> values_for(const std::set<double>& numbers) {
  std::map<double, std::uint16_t> values;
  std::uint16_t free = 0;
  for (const double number : numbers) {
    if (fits(number)) continue;
    do ++free;
    while (numbers.contains(free) && free < largest_value);
    values[number] = free;
  }
  return values;
}

}  // namespace

LabelMap label_map_of(const StoredVolume& volume, const std::string& where) {
  const std::map<double, std::uint16_t> replaced = values_for(numbers_in(volume, where));
  const auto layers = static_cast<std::size_t>(volume.header.components);
  LabelMap map{.layers = std::vector<LabelVolume>(layers, LabelVolume(volume.header.grid)), .segments = {}};
  map.warnings = volume.header.warnings;
  std::vector<std::set<double>> replaced_in(layers);
  for_each_value(volume, [&](std::size_t i, double number) {
    std::uint16_t& voxel = map.layers[i % layers].voxels[i / layers];
    if (fits(number)) {
      voxel = static_cast<std::uint16_t>(number);
    } else {
      voxel = replaced.at(number);
      replaced_in[i % layers].insert(number);
    }
  });
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (const double number : replaced_in[layer])
      map.segments.push_back({.name = fmt::format("{:.0f}", number), .value = replaced.at(number), .layer = layer});
  return map;
}

const LabelVolume& single_layer(const LabelMap& map, const std::string& where, const std::string& format) {
  if (map.layers.size() != 1)
    throw InputError(where, format + " labels cannot overlap", "write .seg.nrrd, or one file per organ");
  return map.layers.front();
}

}  // namespace isostack
