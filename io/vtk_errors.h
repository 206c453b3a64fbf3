#pragma once

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>

#include <filesystem>
#include <string>

#include "recon/geometry/errors.h"

namespace isostack {

/// Keeps what a VTK object would print, and remembers whether there was an error.
class VtkErrors : public vtkCommand {
 public:
  static VtkErrors* New() { return new VtkErrors; }
  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  bool any() const { return any_; }
  /// First line of the first error, without VTK's source line and address; may be empty.
  const std::string& message() const { return message_; }

 private:
  bool any_ = false;
  std::string message_;
};

/// Listens to the object's errors and warnings for as long as both live.
vtkNew<VtkErrors> capture_errors(vtkObject& object);

/// Updates a VTK reader. Throws InputError naming the file if VTK met an error.
template <class Reader>
void update_or_throw(Reader& reader, const std::filesystem::path& path) {
  const vtkNew<VtkErrors> errors = capture_errors(reader);
  reader.Update();
  if (errors->any())
    throw InputError(path.string(), "it cannot be decoded (" + errors->message() + ")",
                     "it is truncated or damaged; copy it again");
}

}  // namespace isostack
