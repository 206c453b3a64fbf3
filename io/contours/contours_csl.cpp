#include "io/contours/contours_csl.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

#include "io/atomic_file.h"
#include "io/contours/section_planes.h"
#include "io/contours/text_tokens.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// "n" or "nhK".
std::pair<std::size_t, int> parse_size(std::string_view word, const TextTokens& tokens) {
  std::size_t size = 0;
  const char* const end = word.data() + word.size();
  auto [rest, error] = std::from_chars(word.data(), end, size);
  if (error == std::errc() && rest == end) return {size, -1};
  int hole_of = -1;
  if (error == std::errc() && (*rest == 'h' || *rest == 'H')) {
    const auto [last, hole_error] = std::from_chars(rest + 1, end, hole_of);
    if (hole_error == std::errc() && last == end && hole_of >= 0) return {size, hole_of};
  }
  tokens.fail(fmt::format("'{}' is neither a number of vertices nor a hole such as 12h0", word.substr(0, 40)));
}

SectionLoop read_component(TextTokens& tokens, std::size_t vertex_count) {
  SectionLoop component;
  const auto [size, hole_of] = parse_size(tokens.word("a component"), tokens);
  component.hole_of = hole_of;
  const long long label = tokens.whole_number("the label of a component");
  if (label < 0 || label > 65535) tokens.fail(fmt::format("label {} is not between 0 and 65535", label));
  component.label = static_cast<int>(label);
  for (std::size_t i = 0; i < size; ++i) {
    const long long vertex = tokens.whole_number("a vertex of a component");
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertex_count)
      tokens.fail(fmt::format("a component names vertex {} of {}, counted from 0", vertex, vertex_count));
    component.vertices.push_back(static_cast<int>(vertex));
  }
  return component;
}

constexpr std::size_t vertex_bytes = 6, component_bytes = 4, plane_bytes = 14;  // the shortest that can be written

/// The curve that a hole is cut out of.
std::size_t curve_around(const Contour& hole, const std::vector<Contour>& contours) {
  std::size_t i = 0;
  while (i + 1 < contours.size() && !(contours[i].depth + 1 == hole.depth && encloses(contours[i], hole))) ++i;
  return i;
}

void append_plane(const WrittenPlane& plane, std::size_t number, std::string& text) {
  std::string vertices, components;
  std::size_t vertex_count = 0, component_count = 0;
  for (std::size_t organ = 0; organ < plane.contours.size(); ++organ) {
    const std::size_t first_of_organ = component_count;
    for (const Contour& contour : plane.contours[organ]) {
      components += fmt::format("{}", contour.points_mm.size());
      if (contour.depth % 2 == 1)
        components += fmt::format("h{}", first_of_organ + curve_around(contour, plane.contours[organ]));
      components += fmt::format(" {}", organ + 1);
      for (const Eigen::Vector2d& point : contour.points_mm) {
        const Eigen::Vector3d vertex = plane.pose.slice_to_world(point);
        fmt::format_to(std::back_inserter(vertices), "{} {} {}\n", vertex.x(), vertex.y(), vertex.z());
        fmt::format_to(std::back_inserter(components), " {}", vertex_count++);
      }
      components += '\n';
      ++component_count;
    }
  }
  const Eigen::Vector3d& n = plane.normal;
  fmt::format_to(std::back_inserter(text), "\n{} {} {} {} {} {} {}\n\n{}\n{}", number, vertex_count, component_count,
                 n.x(), n.y(), n.z(), -n.dot(plane.pose.origin_mm), vertices, components);
}

}  // namespace

bool is_csl(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string magic(4, '\0');
  stream.read(magic.data(), 4);
  return magic == "CSLC";
}

ContourFile read_csl(const std::filesystem::path& path, const ReadOptions& /*options*/) {
  TextTokens tokens(path);
  if (tokens.word("CSLC") != "CSLC") tokens.fail("it does not start with CSLC");
  const std::size_t plane_count = tokens.count("the number of planes", plane_bytes);
  const long long label_count = tokens.whole_number("the number of labels");
  std::vector<SectionPlane> planes;
  std::vector<std::vector<SectionLoop>> loops;
  for (std::size_t p = 0; p < plane_count; ++p) {
    SectionPlane& plane = planes.emplace_back();
    tokens.whole_number("the number of a plane");
    const std::size_t vertex_count = tokens.count("the number of vertices", vertex_bytes);
    const std::size_t component_count = tokens.count("the number of components", component_bytes);
    for (double& coefficient : plane.equation) coefficient = tokens.number("A, B, C or D of a plane");
    plane.where = fmt::format("{}, plane {}", tokens.where(), p + 1);
    for (std::size_t i = 0; i < vertex_count; ++i) {
      Eigen::Vector3d& vertex = plane.vertices_mm.emplace_back();
      for (double& coordinate : vertex) coordinate = tokens.number("a coordinate of a vertex");
    }
    std::vector<SectionLoop>& of_plane = loops.emplace_back();
    for (std::size_t i = 0; i < component_count; ++i) of_plane.push_back(read_component(tokens, vertex_count));
  }
  return {.organs = section_organs(planes, loops, path.string(), label_count)};
}

void write_csl(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
               const WriteOptions& /*options*/) {
  const std::vector<WrittenPlane> planes = planes_of(organs);
  std::string text = fmt::format("CSLC\n{} {}\n", planes.size(), organs.size() + 1);  // the outside is a label, too
  for (std::size_t p = 0; p < planes.size(); ++p) append_plane(planes[p], p + 1, text);
  write_whole_file(path, text);
}

}  // namespace isostack
