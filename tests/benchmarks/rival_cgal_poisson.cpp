// rival_cgal_poisson SLICES MESH.ply: CGAL's Poisson surface reconstruction of the contour stack's points with their
// normals. A rival to measure against only; nothing of the product is linked to CGAL.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <utility>
#include <vector>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "tests/benchmarks/star_stack.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  const auto contours = isostack::benchmarks::oriented_points(isostack::benchmarks::star_stack(std::atoi(argv[1])));
  std::vector<Oriented> points;
  for (Eigen::Index i = 0; i < contours.points.cols(); ++i) {
    const Eigen::Vector3d p = contours.points.col(i), n = contours.normals.col(i);
    points.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  const isostack::Stopwatch watch;
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(
      points, 6, CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>()));
  const bool found = CGAL::poisson_surface_reconstruction_delaunay(
      points.begin(), points.end(), CGAL::First_of_pair_property_map<Oriented>(),
      CGAL::Second_of_pair_property_map<Oriented>(), surface, spacing);
  std::printf("constraints %zu\nseconds %.2f\npeak_gb %.2f\n", points.size(), watch.seconds(),
              static_cast<double>(isostack::peak_memory_bytes()) / 1e9);
  std::ofstream file(argv[2]);
  file.precision(9);
  CGAL::IO::write_PLY(file, surface);
  return found ? 0 : 1;
}
