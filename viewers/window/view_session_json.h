#pragma once

#include <nlohmann/json.hpp>

#include "viewers/window/view_session.h"

namespace isostack {

/// The "state" of a session file. Private to the window.
nlohmann::json to_json(const ViewState& state);

/// What is not said keeps its default. Throws nlohmann::json::exception saying what is wrong.
ViewState view_state_from(const nlohmann::json& json);

}  // namespace isostack
