// rival_pcl_poisson SLICES MESH.ply [DEPTH]: PCL's (Kazhdan's) Poisson surface reconstruction of the contour stack's
// points with their normals.
#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>
#include <pcl/surface/poisson.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "tests/benchmarks/star_stack.h"

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) return 2;
  const auto contours = isostack::benchmarks::oriented_points(isostack::benchmarks::star_stack(std::atoi(argv[1])));
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  for (Eigen::Index i = 0; i < contours.points.cols(); ++i) {
    pcl::PointNormal point;
    point.getVector3fMap() = contours.points.col(i).cast<float>();
    point.getNormalVector3fMap() = contours.normals.col(i).cast<float>();
    cloud->push_back(point);
  }
  const isostack::Stopwatch watch;
  pcl::Poisson<pcl::PointNormal> poisson;
  poisson.setDepth(argc == 4 ? std::atoi(argv[3]) : 10);  // cells of some 1.5 mm in a box of 1.3 m
  poisson.setThreads(0);                                  // all
  poisson.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZ> vertices;
  pcl::PolygonMesh surface;
  poisson.reconstruct(surface);
  std::printf("constraints %zu\nseconds %.2f\npeak_gb %.2f\n", cloud->size(), watch.seconds(),
              static_cast<double>(isostack::peak_memory_bytes()) / 1e9);
  pcl::fromPCLPointCloud2(surface.cloud, vertices);
  std::ofstream file(argv[2]);
  file << "ply\nformat ascii 1.0\nelement vertex " << vertices.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << surface.polygons.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const pcl::PointXYZ& v : vertices) file << v.x << ' ' << v.y << ' ' << v.z << '\n';
  for (const pcl::Vertices& t : surface.polygons)
    file << "3 " << t.vertices[0] << ' ' << t.vertices[1] << ' ' << t.vertices[2] << '\n';
  return 0;
}
