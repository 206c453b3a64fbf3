#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace isostack {

/// Calls enter(row, column) for a pixel within a raster of this size, and for the 4-neighbours within it of every pixel
/// that was entered. `enter` returns whether it was: true once for each pixel at most.
template <class Enter>
void flood_from(Eigen::Index row, Eigen::Index column, Eigen::Index rows, Eigen::Index columns, Enter enter) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pending;
  const auto visit = [&](Eigen::Index r, Eigen::Index c) {
    if (r >= 0 && c >= 0 && r < rows && c < columns && enter(r, c)) pending.emplace_back(r, c);
  };
  visit(row, column);
  while (!pending.empty()) {
    const auto [r, c] = pending.back();
    pending.pop_back();
    visit(r - 1, c);
    visit(r + 1, c);
    visit(r, c - 1);
    visit(r, c + 1);
  }
}

}  // namespace isostack
