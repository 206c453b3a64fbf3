#include "viewers/page/page.h"

#include <nlohmann/json.hpp>

#include "io/atomic_file.h"
#include "viewers/page/page_data.h"
#include "viewers/page/page_parts.h"
#include "viewers/scene_points.h"

namespace isostack {

namespace {

/// Puts `text` in the place of the mark, of which there is one.
void fill_in(std::string_view mark, std::string_view text, std::string& page) {
  page.replace(page.find(mark), mark.size(), text);
}

/// JSON that may stand in a script: no text in it can end the script.
std::string as_script(const nlohmann::json& data) {
  const std::string text = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    safe += text[i];
    if (text[i] == '<' && i + 1 < text.size() && text[i + 1] == '/') safe += '\\';
  }
  return safe;
}

}  // namespace

std::string page_html(const Scene& scene, const PageOptions& options) {
  require_drawable(scene);
  std::string page(page_parts::page_html), additions;
  fill_in("/*page.css*/", page_parts::page_css, page);
  fill_in("/*three.js*/", page_parts::three_js, page);
  for (const std::string_view addition : {page_parts::orbit_controls_js, page_parts::line_geometry_js,
                                          page_parts::line_material_js, page_parts::line_segments_js})
    additions.append(addition).append("\n");
  fill_in("/*additions*/", additions, page);
  fill_in("/*page.js*/", page_parts::page_js, page);
  fill_in("/*scene*/", as_script(page_data(scene, options)), page);
  return page;
}

void save_page(const Scene& scene, const std::filesystem::path& html, const PageOptions& options) {
  write_whole_file(html, page_html(scene, options));
}

}  // namespace isostack
