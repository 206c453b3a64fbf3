#pragma once

namespace isostack {

/// Silences GDCM and builds its tables; call before using GDCM, from any thread.
void set_up_gdcm();

}  // namespace isostack
