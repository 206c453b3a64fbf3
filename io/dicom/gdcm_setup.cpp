#include "io/dicom/gdcm_setup.h"

#include <gdcmGlobal.h>
#include <gdcmTrace.h>

namespace isostack {

void set_up_gdcm() {
  static const bool done = [] {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    gdcm::Global::GetInstance();  // its dictionaries are built on first use, which is not thread-safe
    return true;
  }();
  static_cast<void>(done);
}

}  // namespace isostack
