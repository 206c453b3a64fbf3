#pragma once

#include <Eigen/Core>
#include <vector>

namespace isostack {

/// A short closed tour through all points, each once: their order along the loop that they were taken from, when they
/// lie on it densely. By turning and moving stretches of it (2-opt, Croes 1958; Or 1976) from two first tours. The tour
/// does not cross itself, and does not depend on the order the points come in. Points at one place are visited one
/// after the other. Time grows with about the square of their number.
std::vector<Eigen::Vector2d> shortest_tour(std::vector<Eigen::Vector2d> points);

}  // namespace isostack
