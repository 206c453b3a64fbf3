#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/components.h"
#include "segmentation/seeds.h"

namespace isostack {

/// The organs' masks (organs[organ][plane], planes in order along the normal at `positions_mm`, all of one size)
/// reduced to what is 6-connected to the organ's seeds, whose `slice` counts planes. Where organs reach the same pixels
/// these go to the organ that gets there first (Dijkstra 1959), when narrow passages take longer: a step of 1 mm takes
/// (1/d)², d the distance to the edge of what any organ reaches, in pixels. So organs that touch part at their necks.
void keep_connected(std::vector<std::vector<Mask>>& organs, const std::vector<std::vector<SeedPixel>>& seeds,
                    const std::vector<double>& positions_mm, const Eigen::Vector2d& spacing_mm);

}  // namespace isostack
