#include "viewers/quiet_vtk.h"

#include <vtkLogger.h>
#include <vtkObject.h>

namespace isostack {

QuietVtk::QuietVtk()
    : warnings_before_(vtkObject::GetGlobalWarningDisplay()),
      verbosity_before_(vtkLogger::GetCurrentVerbosityCutoff()) {
  vtkObject::SetGlobalWarningDisplay(0);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

QuietVtk::~QuietVtk() {
  vtkObject::SetGlobalWarningDisplay(warnings_before_);
  vtkLogger::SetStderrVerbosity(vtkLogger::ConvertToVerbosity(verbosity_before_));
}

}  // namespace isostack
