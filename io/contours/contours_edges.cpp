#include "io/contours/contours_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "io/atomic_file.h"
#include "io/contours/labelled_edges.h"
#include "io/contours/section_planes.h"
#include "io/contours/text_tokens.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr std::size_t vertex_bytes = 6, edge_bytes = 8, plane_bytes = 12;  // the shortest that can be written

struct EdgePlane {
  SectionPlane plane;
  std::vector<LabelledEdge> edges;
};

int read_label(TextTokens& tokens) {
  const long long label = tokens.whole_number("the label beside an edge");
  if (label < 0 || label > 65535) tokens.fail(fmt::format("label {} is not between 0 and 65535", label));
  return static_cast<int>(label);
}

EdgePlane read_plane(TextTokens& tokens, std::size_t number) {
  EdgePlane result;
  for (double& coefficient : result.plane.equation) coefficient = tokens.number("A, B, C or D of a plane");
  result.plane.where = fmt::format("{}, plane {}", tokens.where(), number);
  const std::size_t vertex_count = tokens.count("the number of vertices", vertex_bytes);
  const std::size_t edge_count = tokens.count("the number of edges", edge_bytes);
  for (std::size_t i = 0; i < vertex_count; ++i) {
    Eigen::Vector3d& vertex = result.plane.vertices_mm.emplace_back();
    for (double& coordinate : vertex) coordinate = tokens.number("a coordinate of a vertex");
  }
  const auto vertex = [&] {
    const long long index = tokens.whole_number("a vertex of an edge");
    if (index < 0 || static_cast<std::size_t>(index) >= vertex_count)
      tokens.fail(fmt::format("an edge names vertex {} of {}, counted from 0", index, vertex_count));
    return static_cast<int>(index);
  };
  for (std::size_t i = 0; i < edge_count; ++i) {
    LabelledEdge& edge = result.edges.emplace_back();
    edge.from = vertex();
    edge.to = vertex();
    edge.left = read_label(tokens);
    edge.right = read_label(tokens);
  }
  return result;
}

std::vector<EdgePlane> read_planes(const std::filesystem::path& path) {
  TextTokens tokens(path);
  const std::size_t plane_count = tokens.count("the number of planes", plane_bytes);
  std::vector<EdgePlane> planes;
  for (std::size_t p = 0; p < plane_count; ++p) planes.push_back(read_plane(tokens, p + 1));
  return planes;
}

/// Twice the area that is left of the edges of all labels but the outside, negative when it is to their right.
double enclosed_area(const EdgePlane& plane, int outside_label) {
  const Eigen::Vector3d normal = plane.plane.equation.head<3>().normalized();
  double area = 0;
  if (plane.plane.vertices_mm.empty()) return area;
  const Eigen::Vector3d origin = plane.plane.vertices_mm.front();
  for (const LabelledEdge& edge : plane.edges) {
    const Eigen::Vector3d from = plane.plane.vertices_mm[static_cast<std::size_t>(edge.from)] - origin;
    const Eigen::Vector3d to = plane.plane.vertices_mm[static_cast<std::size_t>(edge.to)] - origin;
    const int sides = (edge.left != outside_label ? 1 : 0) - (edge.right != outside_label ? 1 : 0);
    area += sides * from.cross(to).dot(normal);
  }
  return area;
}

int lowest_label(const std::vector<EdgePlane>& planes) {
  int lowest = 65536;
  for (const EdgePlane& plane : planes)
    for (const LabelledEdge& edge : plane.edges) lowest = std::min({lowest, edge.left, edge.right});
  return lowest;
}

/// Turns left into left as seen from the tip of the normal.
void settle_sides(std::vector<EdgePlane>& planes, int outside_label) {
  double area = 0;
  for (const EdgePlane& plane : planes) area += enclosed_area(plane, outside_label);
  if (area >= 0) return;
  for (EdgePlane& plane : planes)
    for (LabelledEdge& edge : plane.edges) std::swap(edge.left, edge.right);
}

/// The plane's curves as edges, of which neighbouring organs share those that they have in common.
EdgePlane edges_of(const WrittenPlane& written) {
  EdgePlane result;
  std::map<std::array<double, 3>, int> number_of;
  std::map<std::pair<int, int>, std::size_t> edge_between;
  const auto number = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector3d v = written.pose.slice_to_world(point);
    const auto [entry, is_new] = number_of.try_emplace({v.x(), v.y(), v.z()}, static_cast<int>(number_of.size()));
    if (is_new) result.plane.vertices_mm.push_back(v);
    return entry->second;
  };
  for (std::size_t organ = 0; organ < written.contours.size(); ++organ) {
    const int label = static_cast<int>(organ) + 1;
    for (const Contour& contour : written.contours[organ])
      for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
        const int from = number(contour.points_mm[i]);
        const int to = number(contour.points_mm[(i + 1) % contour.points_mm.size()]);
        const auto other = edge_between.find({to, from});
        if (other != edge_between.end() && result.edges[other->second].right == 0) {
          result.edges[other->second].right = label;
          continue;
        }
        edge_between[{from, to}] = result.edges.size();
        result.edges.push_back({from, to, label, 0});
      }
  }
  return result;
}

}  // namespace

bool is_edge_contours(const std::filesystem::path& path) {
  try {
    TextTokens tokens(path);
    tokens.count("the number of planes", plane_bytes);
    for (int i = 0; i < 4 && !tokens.at_end(); ++i) tokens.number("A, B, C or D of a plane");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

ContourFile read_edge_contours(const std::filesystem::path& path, const ReadOptions& /*options*/) {
  std::vector<EdgePlane> planes = read_planes(path);
  const int outside_label = lowest_label(planes);
  settle_sides(planes, outside_label);
  std::vector<SectionPlane> sections;
  std::vector<std::vector<SectionLoop>> loops;
  for (const EdgePlane& plane : planes) {
    sections.push_back(plane.plane);
    loops.push_back(loops_of_labels(plane.plane, plane.edges, outside_label));
  }
  return {.organs = section_organs(sections, loops, path.string())};
}

void write_edge_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                         const WriteOptions& /*options*/) {
  const std::vector<WrittenPlane> planes = planes_of(organs);
  std::string text = fmt::format("{}\n", planes.size());
  const auto out = std::back_inserter(text);
  for (const WrittenPlane& written : planes) {
    const EdgePlane plane = edges_of(written);
    const Eigen::Vector3d& n = written.normal;
    fmt::format_to(out, "{} {} {} {}\n{} {}\n", n.x(), n.y(), n.z(), n.dot(written.pose.origin_mm),
                   plane.plane.vertices_mm.size(), plane.edges.size());
    for (const Eigen::Vector3d& v : plane.plane.vertices_mm) fmt::format_to(out, "{} {} {}\n", v.x(), v.y(), v.z());
    for (const LabelledEdge& e : plane.edges) fmt::format_to(out, "{} {} {} {}\n", e.from, e.to, e.left, e.right);
  }
  write_whole_file(path, text);
}

}  // namespace isostack
