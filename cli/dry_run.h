#pragma once

#include "cli/session.h"
#include "recon/predicted_memory.h"

namespace isostack::cli {

/// Tells, in text and result, what a run would take.
void describe(const MemoryPrediction& prediction, Session& session);

}  // namespace isostack::cli
