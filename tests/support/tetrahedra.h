#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace isostack::testing_support {

/// What tetrahedra joined at their corners are, counted.
struct TetrahedraCount {
  long euler_characteristic = 0;
  std::size_t open_triangles = 0;     ///< with one tetrahedron
  std::size_t crowded_triangles = 0;  ///< with more than two, or two that lie on one side of it
  std::size_t bad_links = 0;          ///< vertices round which the opposite triangles form neither a disc nor a sphere
};

/// V − E + F, and whether each inner edge of these triangles has two of them; connected.
struct LinkCount {
  long euler_characteristic = 0;
  bool is_surface = true, is_connected = true, has_border = false;
};

inline LinkCount count_link(const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::array<int, 2>, int> edges;
  std::map<int, int> root;
  const auto find = [&](int v) {
    while (root.at(v) != v) v = root.at(v);
    return v;
  };
  for (const auto& t : triangles) {
    for (const int v : t) root.try_emplace(v, v);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [a, b] = std::minmax(t[c], t[(c + 1) % 3]);
      ++edges[{a, b}];
      root[find(a)] = find(b);
    }
  }
  LinkCount count;
  std::set<int> roots;
  for (const auto& [v, r] : root) roots.insert(find(v));
  count.is_connected = roots.size() == 1;
  for (const auto& [edge, times] : edges) {
    count.is_surface &= times <= 2;
    count.has_border |= times == 1;
  }
  count.euler_characteristic =
      static_cast<long>(root.size()) - static_cast<long>(edges.size()) + static_cast<long>(triangles.size());
  return count;
}

/// A 3-manifold with border has neither crowded triangles nor bad links.
inline TetrahedraCount count(const Eigen::MatrixXi& tetrahedra) {
  std::map<std::array<int, 3>, std::array<int, 2>> triangles;  // sorted: times by orientation
  std::set<std::array<int, 2>> edges;
  std::map<int, std::vector<std::array<int, 3>>> opposite;
  for (Eigen::Index s = 0; s < tetrahedra.cols(); ++s)
    for (int left_out = 0; left_out < 4; ++left_out) {
      std::array<int, 3> t{};
      for (int c = 0, i = 0; c < 4; ++c)
        if (c != left_out) t[static_cast<std::size_t>(i++)] = tetrahedra(c, s);
      opposite[tetrahedra(left_out, s)].push_back(t);
      int sign = left_out % 2;
      for (const auto& [i, j] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(0u, 1u)})
        if (t[i] > t[j]) {
          std::swap(t[i], t[j]);
          sign = 1 - sign;
        }
      ++triangles[t][static_cast<std::size_t>(sign)];
      edges.insert({{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}});
    }
  TetrahedraCount made;
  for (const auto& [t, times] : triangles) {
    if (times[0] + times[1] == 1) ++made.open_triangles;
    if (times[0] > 1 || times[1] > 1) ++made.crowded_triangles;
  }
  for (const auto& [v, link] : opposite) {
    const LinkCount counted = count_link(link);
    const long expected = counted.has_border ? 1 : 2;
    if (!counted.is_surface || !counted.is_connected || counted.euler_characteristic != expected) ++made.bad_links;
  }
  made.euler_characteristic = static_cast<long>(opposite.size()) - static_cast<long>(edges.size()) +
                              static_cast<long>(triangles.size()) - static_cast<long>(tetrahedra.cols());
  return made;
}

}  // namespace isostack::testing_support
