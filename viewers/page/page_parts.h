#pragma once

#include <string_view>

namespace isostack::page_parts {

// Files that become part of every page; see page/CMakeLists.txt.
extern const std::string_view page_html, page_css, page_js, three_js, orbit_controls_js, line_geometry_js,
    line_material_js, line_segments_js;

}  // namespace isostack::page_parts
