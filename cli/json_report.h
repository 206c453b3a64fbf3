#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "recon/geometry/contour.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/reconstruct.h"

namespace isostack::cli {

nlohmann::json to_json(const ReconstructReport& report);
nlohmann::json to_json(const MeshMeasures& measures);
/// Distances are null where no slice has contours on both sides.
nlohmann::json to_json(const SliceAgreement& agreement);

/// Slices, contours, points and enclosed area of one organ.
nlohmann::json to_json(const ContourStack& organ);

/// "volume  123.4 cm³" and so on, for people.
std::string to_text(const MeshMeasures& measures);

}  // namespace isostack::cli
